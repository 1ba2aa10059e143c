/* SPDX-License-Identifier: MIT */
/* The word that was probably meant. */
#ifndef SUGGEST_H
#define SUGGEST_H

#include <glib.h>

/* Edits (a letter more, less, changed, or two swapped) from one word to the other. */
guint suggest_distance(const char *from, const char *to);

#endif
