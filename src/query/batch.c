/*
 * Many look-ups at once.
 *
 * Look-ups in a table beyond the nearest caches wait for memory, each for its guide first and then for its row. So they go in groups: what
 * all of a group will read of the guide is asked for, then the rows that the guide names, and only then is each look-up done.
 * Tables that fit the nearest cache need none of this. The answers are those of the single functions.
 */
#include <math.h>

#include "table/guide.h"

#if defined(__GNUC__)
#define BATCH_PREFETCH(p) __builtin_prefetch(p)
#else
#define BATCH_PREFETCH(p) ((void)(p))
#endif

#define BATCH_GROUP 32
#define BATCH_NEAR_ROWS 2048

static size_t batch_group(size_t left)
{
    return left < BATCH_GROUP ? left : BATCH_GROUP;
}

/* A time that is not in the table takes part as the first one. */
static uint64_t batch_cell(const tdsp_guide *guide, double x)
{
    int inside = (x >= guide->first) & (x <= guide->last);
    return guide_cell(guide->first, guide->scale, inside ? x : guide->first);
}

/* `travel`: with the row's travel times. */
static void batch_prefetch(const tdsp_table *table, const tdsp_guide *guide, int travel, const double *times, size_t count)
{
    uint64_t cells[BATCH_GROUP];
    if (!guide->bases || table->rows < BATCH_NEAR_ROWS) return;
    for (size_t i = 0; i < count; i++) {
        cells[i] = batch_cell(guide, times[i]);
        BATCH_PREFETCH(guide_base_at(guide, cells[i]));
        BATCH_PREFETCH(guide->counts + cells[i]);
    }
    for (size_t i = 0; i < count; i++) {
        uint64_t start = guide_start(guide, cells[i]);
        uint64_t row = start < table->rows ? start : 0;
        BATCH_PREFETCH(table->bytes + table->departures + 8 * row);
        if (!travel) continue;
        BATCH_PREFETCH(table->bytes + table->left + 8 * row);
        BATCH_PREFETCH(table->bytes + table->right + 8 * row);
    }
}

/* The single functions leave their outputs alone where there is no answer: then both stay as given here. */
typedef tdsp_status batch_question(const tdsp_table *table, double time, double *low, double *high);

static inline void batch_ask(const tdsp_table *table, const tdsp_guide *guide, batch_question *ask, double none,
                             const double *times, size_t count, double *lows, double *highs, tdsp_status *statuses)
{
    for (size_t i = 0; i < count; i++) {
        if (i % BATCH_GROUP == 0) batch_prefetch(table, guide, 1, times + i, batch_group(count - i));
        double low = none;
        double high = none;
        tdsp_status status = ask(table, times[i], &low, &high);
        if (lows) lows[i] = low;
        if (highs) highs[i] = high;
        if (statuses) statuses[i] = status;
    }
}

tdsp_status tdsp_table_arrivals(const tdsp_table *table, const double *departures, size_t count, double *lower, double *upper,
                                tdsp_status *statuses)
{
    if (!table || !table->bytes || !departures) return TDSP_INVALID_ARGUMENT;
    batch_ask(table, &table->by_departure, tdsp_table_arrival, INFINITY, departures, count, lower, upper, statuses);
    return TDSP_OK;
}

tdsp_status tdsp_table_departures(const tdsp_table *table, const double *arrivals, size_t count, double *departures,
                                  double *departures_upper, tdsp_status *statuses)
{
    if (!table || !table->bytes || !arrivals) return TDSP_INVALID_ARGUMENT;
    batch_ask(table, &table->by_arrival, tdsp_table_departure, -INFINITY, arrivals, count, departures, departures_upper,
              statuses);
    return TDSP_OK;
}

tdsp_status tdsp_table_rows(const tdsp_table *table, const double *departures, size_t count, uint64_t *rows,
                            tdsp_status *statuses)
{
    if (!table || !table->bytes || !departures) return TDSP_INVALID_ARGUMENT;
    for (size_t i = 0; i < count; i++) {
        if (i % BATCH_GROUP == 0) batch_prefetch(table, &table->by_departure, 0, departures + i, batch_group(count - i));
        uint64_t row = table->rows;
        tdsp_status status = tdsp_table_find(table, departures[i], &row);
        if (rows) rows[i] = row;
        if (statuses) statuses[i] = status;
    }
    return TDSP_OK;
}
