/* SPDX-License-Identifier: MIT */
/* The library's own mathematics as a list, with arguments for it: what tests measure, record and compare. Needs C99 and nothing else, so that it runs on any machine. */
#ifndef SUPPORT_FUNCTIONS_H
#define SUPPORT_FUNCTIONS_H

#include <stdint.h>
#include <stdio.h>

/* Where arguments come from: evenly from low to high, or of all sizes from 2^low to 2^high with both signs where not `is_positive`. */
typedef struct function_range {
    const char *name;
    int is_wide, is_positive;
    double low, high;
} function_range;

#define FUNCTION_RANGES 6

typedef struct function_case {
    const char *name;
    double (*one)(double x);           /* or */
    double (*two)(double x, double y); /* in the order in which it is called */
    function_range ranges[FUNCTION_RANGES]; /* up to one without a name */
} function_case;

extern const function_case function_cases[];
extern const int function_count;

/* Arguments of special meaning: zeros, infinities, NaN, ends of ranges, neighbours of where a formula gives way to another. */
extern const double function_specials[];
extern const int function_special_count;

double function_argument(const function_range *range, uint64_t *chance);

double function_value(const function_case *function, double x, double y);

/* The bits of a number; those of one NaN for all. */
uint64_t function_bits(double x);

/* One line a value: name, bits of the arguments, bits of the result; and one line a range: a hash of many. */
void functions_say(FILE *out);

#endif
