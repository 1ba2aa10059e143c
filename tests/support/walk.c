/* SPDX-License-Identifier: MIT */
/* Rows of large tables are walked in steps, so that a table of any size takes about the same time. */
#include "support/walk.h"

#include <math.h>

#include "tdsp/path.h"

#define WALK_ROWS 200
#define WALK_LEGS 50

static const char *walk_departure(const tdsp_table *table, double arrival)
{
    double departure, last, lower, upper;
    tdsp_table_info info;
    if (tdsp_table_departure(table, arrival, &departure, &last) != TDSP_OK) return NULL;
    if (tdsp_table_get_info(table, &info) != TDSP_OK) return "no info";
    if (info.monotone == TDSP_MONOTONE_TRAVEL && !(departure <= last)) return "a safe departure after the last possible one";
    if (tdsp_table_arrival(table, departure, &lower, &upper) != TDSP_OK) return "a safe departure without an arrival";
    return upper <= arrival ? NULL : "a safe departure that arrives too late";
}

static const char *walk_path(const tdsp_table *table, double departure, double upper, uint64_t legs)
{
    tdsp_leg leg;
    tdsp_point at;
    double before = -INFINITY;
    for (uint64_t i = 0; i < legs; i += 1 + legs / WALK_LEGS) {
        if (tdsp_table_leg(table, departure, i, &leg) != TDSP_OK) return "a leg is missing";
        if (!(leg.start_time >= before && leg.start_time <= leg.end_time)) return "a path runs backwards";
        if (!(leg.start_time >= departure && leg.end_time <= upper)) return "a path outside its certified interval";
        before = leg.end_time;
        if (tdsp_table_position(table, departure, leg.start_time + (leg.end_time - leg.start_time) / 3, &at) != TDSP_OK)
            return "no position";
    }
    if (tdsp_table_leg(table, departure, legs, &leg) == TDSP_OK) return "a leg too many";
    if (legs > 0 && tdsp_table_position(table, departure, upper + 1, &at) != TDSP_OK) return "no position after the path";
    return NULL;
}

/* Of the departure that t is as a float. */
static int walk_contains_in_floats(const tdsp_table *table, double t)
{
    double lower, upper;
    float low, high;
    float departure = (float)t;
    tdsp_status status = tdsp_table_arrival(table, departure, &lower, &upper);
    if (status != tdsp_table_arrival_float(table, departure, &low, &high)) return 0;
    return status != TDSP_OK || (low <= lower && upper <= high);
}

static const char *walk_arrival(const tdsp_table *table, double t)
{
    double lower, upper;
    uint64_t row;
    tdsp_row stored;
    tdsp_status status = tdsp_table_arrival(table, t, &lower, &upper);
    if (status != tdsp_table_find(table, t, &row)) return "arrival and find disagree";
    if (status != TDSP_OK) return NULL;
    if (!(t <= upper && lower <= upper)) return "an empty interval";
    if (!walk_contains_in_floats(table, t)) return "an interval of floats that does not contain that of doubles";
    if (tdsp_table_row(table, row, &stored) != TDSP_OK) return "a row found that does not exist";
    const char *wrong = walk_path(table, t, upper, stored.legs);
    return wrong ? wrong : walk_departure(table, upper);
}

static unsigned walk_bytes(const tdsp_table *table, uint64_t row)
{
    const void *bytes;
    size_t length;
    unsigned sum = 0;
    if (tdsp_table_row_bytes(table, row, &bytes, &length) != TDSP_OK) return 0;
    for (size_t i = 0; i < length; i++)
        sum += ((const unsigned char *)bytes)[i];
    return sum;
}

static const char *walk_row(const tdsp_table *table, uint64_t row)
{
    tdsp_row stored;
    tdsp_leg legs[4];
    tdsp_jump jump;
    size_t count;
    if (tdsp_table_row(table, row, &stored) != TDSP_OK) return "a row is missing";
    for (uint64_t i = 0; i <= stored.legs && i < WALK_LEGS; i++)
        (void)tdsp_table_row_leg(table, row, i, &legs[0]);
    (void)tdsp_table_path(table, stored.departure, legs, 4, &count);
    (void)tdsp_table_next_jump(table, stored.departure, &jump);
    (void)tdsp_table_previous_jump(table, stored.departure, &jump);
    volatile unsigned sum = walk_bytes(table, row);
    (void)sum;
    const char *wrong = walk_arrival(table, stored.departure);
    if (!wrong) wrong = walk_arrival(table, nextafter(stored.departure, INFINITY));
    if (!wrong) wrong = walk_arrival(table, stored.departure * 0.999);
    return wrong ? wrong : walk_departure(table, stored.departure + stored.right);
}

const char *walk_table(const tdsp_table *table)
{
    const double far[] = {0, 1, 1e300, INFINITY};
    tdsp_table_info info;
    const char *wrong = NULL;
    if (tdsp_table_get_info(table, &info) != TDSP_OK) return "no info";
    for (uint64_t row = 0; row < info.rows && !wrong; row += 1 + info.rows / WALK_ROWS)
        wrong = walk_row(table, row);
    for (size_t i = 0; i < sizeof far / sizeof far[0] && !wrong; i++) {
        wrong = walk_arrival(table, far[i]);
        if (!wrong) wrong = walk_departure(table, far[i]);
    }
    return wrong ? wrong : walk_row(table, info.rows - 1);
}
