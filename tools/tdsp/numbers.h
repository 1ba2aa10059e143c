/* SPDX-License-Identifier: MIT */
/*
 * Numbers as text: what is printed reads back as the same double, and what is read is a plain decimal number or is refused.
 * Never depends on the locale.
 */
#ifndef NUMBERS_H
#define NUMBERS_H

#include <glib.h>

#define NUMBER_ROOM 32 /* enough for any double as text */

/**
 * The shortest of 15, 16 or 17 significant digits that reads back as the same double; "inf", "-inf". Returns `buffer`.
 * A decimal of up to 15 digits survives the way through a double, so shorter forms come out by themselves.
 */
const char *number_format(char buffer[NUMBER_ROOM], double value);

/* The same with `digits` significant digits, for people. */
const char *number_brief(char buffer[NUMBER_ROOM], double value, int digits);

/* A decimal number with nothing around it: no hexadecimal, no "inf", no "nan", no overflow. NULL, or what is wrong. */
const char *number_parse(const char *text, double *value);

/* As number_parse(), and not negative: a time. -0 becomes 0. */
const char *number_parse_time(const char *text, double *value);

/* A whole number from `least` to `most`. */
const char *number_parse_whole(const char *text, guint64 least, guint64 most, guint64 *value);

#endif
