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
#include "query/search.h"
#include "tdsp/table.h"

/* The two predicates, each on the rounded sum and on the real one. An infinite right says that nothing leaves after the row. */
static int departure_is_well_safe(const tdsp_table *table, uint64_t row, double arrival)
{
    return table_departure(table, row) + table_left(table, row) < arrival;
}

static int departure_is_safe(const tdsp_table *table, uint64_t row, double arrival)
{
    return round_sum_at_most(table_departure(table, row), table_left(table, row), arrival);
}

static int departure_may_well_follow(const tdsp_table *table, uint64_t row, double arrival)
{
    return table_departure(table, row) + table_right(table, row) < arrival;
}

static int departure_may_follow(const tdsp_table *table, uint64_t row, double arrival)
{
    double right = table_right(table, row);
    return (right <= DBL_MAX) & round_sum_at_most(table_departure(table, row), right, arrival);
}

/*
 * A rounded sum below a says that the real one is, and one over a that the real one is over a. So the rounded sums, at one
 * addition and one comparison a step, decide unless the row they end at is a tie; only then the real ones are searched.
 */
static uint64_t departure_count(const tdsp_table *table, double arrival, query_before *well, query_before *exactly)
{
    uint64_t count = query_count(table, arrival, well);
    if (count == table->rows || !exactly(table, count, arrival)) return count;
    return query_count(table, arrival, exactly);
}

/* The largest t that is safe, given that the rows before `safe` are and that there is one. */
static double departure_lower(const tdsp_table *table, uint64_t safe, double arrival)
{
    double departure = table_departure(table, safe - 1);
    if (safe == table->rows || table->monotone != TDSP_MONOTONE_TRAVEL) return departure;
    double later = round_subtract_down(arrival, table_left(table, safe));
    return later > departure ? later : departure;
}

static double departure_upper(const tdsp_table *table, double arrival)
{
    uint64_t open = departure_count(table, arrival, departure_may_well_follow, departure_may_follow);
    if (open == 0) return 0;
    int travel = table->monotone == TDSP_MONOTONE_TRAVEL;
    double solved = travel ? round_subtract_up(arrival, table_right(table, open - 1)) : arrival;
    if (open == table->rows) return solved;
    double next = table_departure(table, open);
    return next < solved ? next : solved;
}

tdsp_status tdsp_table_departure(const tdsp_table *table, double arrival, double *departure, double *upper)
{
    if (!table || !table->bytes || isnan(arrival)) return TDSP_INVALID_ARGUMENT;
    uint64_t safe = departure_count(table, arrival, departure_is_well_safe, departure_is_safe);
    if (safe == 0) return TDSP_ARRIVAL_TOO_EARLY;
    if (departure) *departure = departure_lower(table, safe, arrival);
    if (upper) *upper = departure_upper(table, arrival);
    return TDSP_OK;
}

tdsp_status tdsp_table_departures(const tdsp_table *table, const double *arrivals, size_t count, double *departures,
                                  double *departures_upper, tdsp_status *statuses)
{
    if (!table || !table->bytes || !arrivals) return TDSP_INVALID_ARGUMENT;
    for (size_t i = 0; i < count; i++) {
        double low = -INFINITY;
        double high = -INFINITY;
        tdsp_status status = tdsp_table_departure(table, arrivals[i], &low, &high);
        if (departures) departures[i] = low;
        if (departures_upper) departures_upper[i] = high;
        if (statuses) statuses[i] = status;
    }
    return TDSP_OK;
}
