/* SPDX-License-Identifier: MIT */
/* The header's values, one by one and against each other. */
#include "base/round.h"
#include "base/text.h"
#include "table/check.h"
#include "table/read.h"

static int check_not_negative(double x)
{
    return x >= 0 && round_is_finite(x);
}

static int check_last_reason(uint32_t reason)
{
    switch (reason) {
    case TDSP_SOURCE_COVERED:
    case TDSP_DESTINATION_COVERED:
    case TDSP_CUT_OFF:
    case TDSP_HORIZON:
    case TDSP_OUTSIDE_TABLE:
    case TDSP_UNREACHABLE: return 1;
    default: return 0;
    }
}

/* The enumerations, and which of them go together (include/tdsp/types.h, include/tdsp/build.h). */
static int check_kinds(const tdsp_table *table)
{
    uint32_t monotone = table_header_u32(table, FORMAT_AT_MONOTONE);
    uint32_t guarantee = table_header_u32(table, FORMAT_AT_GUARANTEE);
    uint32_t sampling = table_header_u32(table, FORMAT_AT_SAMPLING);
    if (monotone > TDSP_MONOTONE_ARRIVAL || guarantee > TDSP_GUARANTEE_ABSOLUTE || sampling > TDSP_SAMPLING_GEOMETRIC) return 0;
    if (monotone == TDSP_MONOTONE_ARRIVAL && guarantee == TDSP_GUARANTEE_TRAVEL) return 0;
    if (sampling == TDSP_SAMPLING_GEOMETRIC && guarantee != TDSP_GUARANTEE_ARRIVAL) return 0;
    return check_last_reason(table_header_u32(table, FORMAT_AT_LAST_REASON));
}

/* Exactly the bound of the guarantee is over 0; the other is 0. */
static int check_bounds(const tdsp_table *table)
{
    double epsilon = table_header_f64(table, FORMAT_AT_EPSILON);
    double delta = table_header_f64(table, FORMAT_AT_DELTA);
    int absolute = table_header_u32(table, FORMAT_AT_GUARANTEE) == TDSP_GUARANTEE_ABSOLUTE;
    double bound = absolute ? delta : epsilon;
    double other = absolute ? epsilon : delta;
    return bound > 0 && round_is_finite(bound) && other == 0;
}

static int check_world(const tdsp_table *table)
{
    for (size_t at = FORMAT_AT_SOURCE; at < FORMAT_AT_FIRST_DEPARTURE; at += 8) {
        if (!round_is_finite(table_header_f64(table, at))) return 0;
    }
    return check_not_negative(table_header_f64(table, FORMAT_AT_ERROR)) &&
           check_not_negative(table_header_f64(table, FORMAT_AT_TIME_SCALE)) &&
           check_not_negative(table_header_f64(table, FORMAT_AT_SPEED));
}

/* UTF-8, then zeros to the end, at least one. */
static int check_unit(const unsigned char *unit)
{
    size_t length = 0;
    while (length < FORMAT_UNIT_SIZE && unit[length] != 0) length++;
    for (size_t i = length; i < FORMAT_UNIT_SIZE; i++) {
        if (unit[i] != 0) return 0;
    }
    return length < FORMAT_UNIT_SIZE && text_is_utf8(unit, 0, length);
}

int check_header(const tdsp_table *table)
{
    return check_kinds(table) && check_bounds(table) && check_world(table) && check_unit(table->bytes + FORMAT_AT_LENGTH_UNIT) &&
           check_unit(table->bytes + FORMAT_AT_TIME_UNIT) && (table->joint == 1 || table->joint == 2) &&
           table_header_u32(table, FORMAT_AT_RESERVED) == 0;
}
