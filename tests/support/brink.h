/* SPDX-License-Identifier: MIT */
/* Bytes right before memory that must not be read: a read behind them ends the program, under no sanitizer too. */
#ifndef SUPPORT_BRINK_H
#define SUPPORT_BRINK_H

#include <stddef.h>

typedef struct brink {
    void *pages;
    unsigned char *bytes;
    size_t page;
} brink;

/* A copy of up to a page of bytes. */
brink brink_of(const unsigned char *bytes, size_t length);
void brink_free(brink b);

#endif
