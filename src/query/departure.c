/* SPDX-License-Identifier: MIT */
/*
 * When must one leave to arrive by a? Comparisons and additions only.
 *
 * Safe: the largest t whose upper end is at most a. With i the last row with b_i + left_i <= a (none: too early):
 *   monotone in travel    t = b_i, or later inside row i + 1, whose upper end t + left_(i+1) is at most a up to
 *                         t = a - left_(i+1), rounded down: max_i min(b_i, a - left_i) of the whole table, as left does not decrease.
 *   monotone in arrival   the upper end is the same all over a row: t = b_i.
 *
 * Certain: no departure after u arrives by a, for u = sup { t : lower(t) <= a }. With j the last row with b_j + right_j <= a:
 *   monotone in travel    every t > b_(j+1) has A(t) >= t + T(b_(j+1)+) > b_(j+1) + right_(j+1) > a. In row j + 1 the lower end
 *                         t + right_j is at most a up to t = a - right_j. So u = min(b_(j+1), a - right_j), rounded up; for the
 *                         last row, after which the table knows only that T does not decrease, u = a - right_j.
 *   monotone in arrival   every t > b_(j+1) has A(t) >= b_(j+1) + right_(j+1) > a; and A(t) >= t. So u = min(b_(j+1), a), and for the
 *                         last row u = a.
 * No such j: u = 0, since every t > 0 has A(t) over a.
 *
 * All sums here are the real ones (a sum is at most a, a double, exactly when the sum rounded up is), so departure <= u, since
 * lower(t) <= upper(t). The lower end that tdsp_table_arrival() rounds down may still be a itself for a t just after u.
 */
#include <math.h>

#include "base/round.h"
#include "query/departure.h"
#include "query/outward.h"
#include "table/guide.h"

/* The two predicates. An infinite right says that nothing leaves after the row. */
static int departure_is_safe(const tdsp_table *table, uint64_t row, double arrival)
{
    return round_sum_at_most(table_departure(table, row), table_left(table, row), arrival);
}

static int departure_may_follow(const tdsp_table *table, uint64_t row, double arrival)
{
    double right = table_right(table, row);
    return (right <= DBL_MAX) & round_sum_at_most(table_departure(table, row), right, arrival);
}

/*
 * Sums rounded to nearest, at one addition and one comparison a row, decide unless the row they end at is a tie: one below a says
 * that the real sum is, and one over a that the real one is over a.
 */
static uint64_t departure_halving(const tdsp_table *table, uint64_t first, uint64_t end, double arrival)
{
    while (first < end) {
        uint64_t middle = (first + end) / 2;
        int before = guide_arrival(table, middle) < arrival;
        first = before ? middle + 1 : first;
        end = before ? end : middle;
    }
    return end;
}

#define DEPARTURE_STEPS 8

/* From the start of the cell: a few rows one by one, the rest halved. */
static uint64_t departure_in_cell(const tdsp_table *table, uint64_t cell, uint64_t start, double arrival)
{
    uint64_t end = guide_end(table, &table->by_arrival, cell);
    if (end > table->rows) end = table->rows;
    uint64_t near = end > DEPARTURE_STEPS && start < end - DEPARTURE_STEPS ? start + DEPARTURE_STEPS : end;
    for (uint64_t row = start; row < near; row++) {
        if (guide_arrival(table, row) >= arrival) return row;
    }
    return near < end ? departure_halving(table, near, end, arrival) : end;
}

/* How many rows have a rounded arrival below a. */
static uint64_t departure_count_rounded(const tdsp_table *table, double arrival)
{
    const tdsp_guide *guide = &table->by_arrival;
    if (!guide->bases) return departure_halving(table, 0, table->rows, arrival);
    if (!(arrival >= guide->first)) return 0;
    if (!(arrival <= guide->last)) return table->rows;
    uint64_t cell = guide_cell(guide->first, guide->scale, arrival);
    return departure_in_cell(table, cell, guide_start(table, guide, cell), arrival);
}

/* The first row in [first, end] that is not safe; the rows before `first` are. */
static uint64_t departure_count_ties(const tdsp_table *table, uint64_t first, double arrival)
{
    uint64_t end = table->rows;
    while (first < end) {
        uint64_t middle = (first + end) / 2;
        if (departure_is_safe(table, middle, arrival))
            first = middle + 1;
        else
            end = middle;
    }
    return end;
}

static uint64_t departure_count_safe(const tdsp_table *table, uint64_t count, double arrival)
{
    if (count == table->rows || !departure_is_safe(table, count, arrival)) return count;
    return departure_count_ties(table, count + 1, arrival);
}

/*
 * The row after the last that may be followed, starting from the first that is not safe: mostly that one or the one before it, so the
 * steps double from there.
 */
static uint64_t departure_count_open(const tdsp_table *table, uint64_t safe, double arrival)
{
    uint64_t step = 1, low = safe, high = safe;
    while (low > 0 && !departure_may_follow(table, low - 1, arrival)) {
        uint64_t next = low - step; /* below 0 it is great */
        high = low - 1;
        low = next < low ? next : 0;
        step *= 2;
    }
    if (high == safe) {
        while (high < table->rows && departure_may_follow(table, high, arrival)) {
            uint64_t next = high + step;
            low = high + 1;
            high = next < table->rows ? next : table->rows;
            step *= 2;
        }
    }
    while (low < high) {
        uint64_t middle = (low + high) / 2;
        if (departure_may_follow(table, middle, arrival))
            low = middle + 1;
        else
            high = middle;
    }
    return high;
}

/* The largest t that is safe, given that the rows before `safe` are and that there is one. */
static double departure_lower(const tdsp_table *table, uint64_t safe, double arrival)
{
    double departure = table_departure(table, safe - 1);
    if (safe == table->rows || table->monotone != TDSP_MONOTONE_TRAVEL) return departure;
    double later = outward_subtract_down(arrival, table_left(table, safe));
    return later > departure ? later : departure;
}

static double departure_upper(const tdsp_table *table, uint64_t safe, double arrival)
{
    uint64_t open = departure_count_open(table, safe, arrival);
    if (open == 0) return 0;
    int travel = table->monotone == TDSP_MONOTONE_TRAVEL;
    double solved = travel ? outward_subtract_up(arrival, table_right(table, open - 1)) : arrival;
    if (open == table->rows) return solved;
    double next = table_departure(table, open);
    return next < solved ? next : solved;
}

/* Given how many rows have a rounded arrival below a. */
static tdsp_status departure_answer(const tdsp_table *table, uint64_t count, double arrival, double *departure, double *upper)
{
    uint64_t safe = departure_count_safe(table, count, arrival);
    if (safe == 0) return TDSP_ARRIVAL_TOO_EARLY;
    if (departure) *departure = departure_lower(table, safe, arrival);
    if (upper) *upper = departure_upper(table, safe, arrival);
    return TDSP_OK;
}

tdsp_status departure_from(const tdsp_table *table, uint64_t cell, uint64_t start, double arrival, double *departure,
                           double *upper)
{
    return departure_answer(table, departure_in_cell(table, cell, start, arrival), arrival, departure, upper);
}

tdsp_status tdsp_table_departure(const tdsp_table *table, double arrival, double *departure, double *upper)
{
    if (!table || !table->bytes || isnan(arrival)) return TDSP_INVALID_ARGUMENT;
    return departure_answer(table, departure_count_rounded(table, arrival), arrival, departure, upper);
}
