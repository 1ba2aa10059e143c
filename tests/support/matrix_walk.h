/* SPDX-License-Identifier: MIT */
/* Matrices in tests: their checksums put right after a change, and every read that there is. */
#ifndef SUPPORT_MATRIX_WALK_H
#define SUPPORT_MATRIX_WALK_H

#include <stddef.h>

#include "tdsp/matrix.h"

/* Put the checksums right, those of the tables inside first, as far as they can be found. */
void matrix_seal(unsigned char *bytes, size_t length);

/* Ask for everything in it. NULL, or what does not hold together. */
const char *matrix_walk(const tdsp_matrix *matrix);

#endif
