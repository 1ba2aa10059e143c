/* SPDX-License-Identifier: MIT */
/* Linked behind everything that is to be rewound. */
#include "faults/rewind_bounds.h"

char rewind_data_end[8] = "end";
char rewind_bss_end[8];
