/* SPDX-License-Identifier: MIT */
/* Linked before everything that is to be rewound. */
#include "faults/rewind_bounds.h"

char rewind_data_begin[8] = "begin";
char rewind_bss_begin[8];
