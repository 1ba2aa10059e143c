/* SPDX-License-Identifier: MIT */
/* How far the library's own mathematics is off, by the C library's functions of long doubles. */
#ifndef SUPPORT_FUNCTION_ERRORS_H
#define SUPPORT_FUNCTION_ERRORS_H

#include "support/functions.h"

typedef long double function_number;

typedef struct function_reference {
    const char *name;
    function_number (*one)(function_number x);
    function_number (*two)(function_number x, function_number y);
    double (*peer)(double x); /* the C library's own, of doubles */
    double (*peer_two)(double x, double y);
    double bound; /* of the error, in units in the last place, for results that are normal numbers; for others it is 1 */
} function_reference;

/* In the order of function_cases. */
extern const function_reference function_references[];

/* How precise the reference is: where long doubles are doubles its own error counts. */
double function_reference_error(void);

function_number function_true(int function, double x, double y);

/* |found - wanted| in units in the last place of `wanted` as a double; 0 where both are the same infinity, zero or NaN, and infinite where only one is. */
double function_error(double found, function_number wanted);

/* Is it a number below the least normal one? */
int function_is_small(function_number wanted);

/* The bound on the error there. */
double function_bound(int function, function_number wanted);

/* The worst error among so many arguments of a range, as a part of its bound, and where it is. */
typedef struct function_worst {
    double error, peer_error, part;
    double x, y;
} function_worst;

function_worst function_measure(int function, const function_range *range, long count, uint64_t seed);

#endif
