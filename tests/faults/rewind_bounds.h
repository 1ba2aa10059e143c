/* SPDX-License-Identifier: MIT */
/* The first and the last of the variables that are rewound, with a value and without. */
#ifndef FAULTS_REWIND_BOUNDS_H
#define FAULTS_REWIND_BOUNDS_H

extern char rewind_data_begin[8], rewind_data_end[8];
extern char rewind_bss_begin[8], rewind_bss_end[8];

#endif
