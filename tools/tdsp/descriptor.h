/* SPDX-License-Identifier: MIT */
/* Whole reads and writes of file descriptors: what a signal interrupts or the system does in part is gone on with. */
#ifndef TDSP_DESCRIPTOR_H
#define TDSP_DESCRIPTOR_H

#include <glib.h>

/* Some bytes, at most `room`: how many, 0 at the end, -1 with errno. */
gssize descriptor_read(int file, void *block, gsize room);

/* All of the bytes: 0, or errno. */
int descriptor_write_all(int file, const void *bytes, gsize length);

/* open(), and again when a signal came: a descriptor, or -1 with errno. */
int descriptor_open(const char *path, int flags);

/*
 * Descriptors 0 to 2 are open afterwards, so that no file gets the number of a standard stream that the caller had closed. Those
 * opened here are the wrong way round: to use them is still an error.
 */
void descriptor_guard_standard(void);

#endif
