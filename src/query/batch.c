/* SPDX-License-Identifier: MIT */
/*
 * Many look-ups at once.
 *
 * Look-ups in a table beyond the nearest caches wait for memory, each for its guide first and then for its row. So they go in groups: what
 * all of a group will read of the guide is asked for, then the rows that the guide names, and only then is each look-up done. A
 * table that fits the nearest cache gains nothing from that. The answers are those of the single functions; these also answer what is not between the first row and the last.
 */
#include <math.h>

#include "query/arrival.h"
#include "query/departure.h"
#include "query/locate.h"

/* It reads nothing, whatever the place, so there is nothing to prove of it. */
#if defined(__GNUC__) && !defined(__FRAMAC__)
#define BATCH_PREFETCH(bytes, at) __builtin_prefetch((const void *)((uintptr_t)(bytes) + (uintptr_t)(at)))
#else
#define BATCH_PREFETCH(bytes, at) ((void)(bytes), (void)(at))
#endif

#define BATCH_GROUP 16u
/* The proof has a smaller table take the same way. */
#if !defined(BATCH_MIN_ROWS)
#define BATCH_MIN_ROWS 2048u
#endif

/* A group of times: for each its cell and where that starts. Of one that is in no cell it is BATCH_NONE. */
typedef struct batch_group {
    uint64_t cell[BATCH_GROUP];
    uint64_t start[BATCH_GROUP];
} batch_group;

#define BATCH_NONE GUIDE_NOWHERE

static inline void batch_find_cells(const tdsp_table *table, const tdsp_guide *guide, double above, const double *times, size_t first,
                                    size_t end, batch_group *group)
{
    const unsigned char *bytes = table->bytes;
    const tdsp_guide read = *guide;
    for (size_t i = first; i < end; i++) {
        int inside = times[i] >= read.first && times[i] > above && times[i] <= read.last;
        uint64_t cell = inside ? guide_cell(read.first, read.scale, times[i]) : BATCH_NONE;
        group->cell[i % BATCH_GROUP] = cell;
        BATCH_PREFETCH(bytes, guide_base_at(&read, cell));
        BATCH_PREFETCH(bytes, guide_count_at(&read, cell));
    }
}

/* `travel`: the travel times will be wanted too. */
static inline void batch_find_starts(const tdsp_table *table, const tdsp_guide *guide, int travel, size_t first, size_t end,
                                     batch_group *group)
{
    const tdsp_table read = *table;
    for (size_t i = first; i < end; i++) {
        uint64_t start = guide_start(&read, guide, group->cell[i % BATCH_GROUP]);
        uint64_t row = start < read.rows ? start : 0;
        group->start[i % BATCH_GROUP] = start;
        BATCH_PREFETCH(read.bytes, read.departures + 8 * row);
        if (travel) BATCH_PREFETCH(read.bytes, read.left + 8 * row);
        if (travel) BATCH_PREFETCH(read.bytes, read.right + 8 * row);
    }
}

static int batch_pays(const tdsp_table *table, const tdsp_guide *guide)
{
    return guide->bases && table->rows >= BATCH_MIN_ROWS;
}

static size_t batch_end(size_t first, size_t count)
{
    size_t end = first + BATCH_GROUP;
    return end < count ? end : count;
}

/* Departure 0 is answered by the header: only what is above it is in a cell. */
static void batch_prepare_departures(const tdsp_table *table, int travel, const double *times, size_t first, size_t end,
                                     batch_group *group)
{
    batch_find_cells(table, &table->by_departure, 0, times, first, end, group);
    batch_find_starts(table, &table->by_departure, travel, first, end, group);
}

static void batch_prepare_arrivals(const tdsp_table *table, const double *times, size_t first, size_t end, batch_group *group)
{
    batch_find_cells(table, &table->by_arrival, -INFINITY, times, first, end, group);
    batch_find_starts(table, &table->by_arrival, 1, first, end, group);
}

/* The row of a departure inside; `group` is NULL where there are none. */
static inline uint64_t batch_row(const tdsp_table *table, const batch_group *group, size_t at, double departure)
{
    return group ? locate_from(table, group->cell[at], group->start[at], departure) : locate_row(table, departure);
}

tdsp_status tdsp_table_rows(const tdsp_table *table, const double *departures, size_t count, uint64_t *rows,
                            tdsp_status *statuses)
{
    batch_group group = {{0}, {0}};
    if (!table || !table->bytes || !departures) return TDSP_INVALID_ARGUMENT;
    int grouped = batch_pays(table, &table->by_departure);
    for (size_t i = 0; i < count; i++) {
        size_t at = i % BATCH_GROUP;
        if (grouped && at == 0) batch_prepare_departures(table, 0, departures, i, batch_end(i, count), &group);
        uint64_t row = table->rows;
        tdsp_status status = TDSP_OK;
        if (locate_is_inside(table, departures[i]))
            row = batch_row(table, grouped ? &group : NULL, at, departures[i]);
        else
            status = tdsp_table_find(table, departures[i], &row);
        if (rows) rows[i] = row;
        if (statuses) statuses[i] = status;
    }
    return TDSP_OK;
}

static inline tdsp_status batch_arrival(const tdsp_table *table, const batch_group *group, size_t at, double departure,
                                        double *lower, double *upper)
{
    if (!locate_is_inside(table, departure)) return tdsp_table_arrival(table, departure, lower, upper);
    uint64_t row = batch_row(table, group, at, departure);
    *lower = arrival_lower(table, row, departure);
    *upper = arrival_upper(table, row, departure);
    return TDSP_OK;
}

tdsp_status tdsp_table_arrivals(const tdsp_table *table, const double *departures, size_t count, double *lower, double *upper,
                                tdsp_status *statuses)
{
    batch_group group = {{0}, {0}};
    if (!table || !table->bytes || !departures) return TDSP_INVALID_ARGUMENT;
    int grouped = batch_pays(table, &table->by_departure);
    for (size_t i = 0; i < count; i++) {
        size_t at = i % BATCH_GROUP;
        if (grouped && at == 0) batch_prepare_departures(table, 1, departures, i, batch_end(i, count), &group);
        double low = INFINITY;
        double high = INFINITY;
        tdsp_status status = batch_arrival(table, grouped ? &group : NULL, at, departures[i], &low, &high);
        if (lower) lower[i] = low;
        if (upper) upper[i] = high;
        if (statuses) statuses[i] = status;
    }
    return TDSP_OK;
}

static inline tdsp_status batch_departure(const tdsp_table *table, const batch_group *group, size_t at, double arrival,
                                          double *lower, double *upper)
{
    if (!group || group->cell[at] == BATCH_NONE) return tdsp_table_departure(table, arrival, lower, upper);
    return departure_from(table, group->cell[at], group->start[at], arrival, lower, upper);
}

tdsp_status tdsp_table_departures(const tdsp_table *table, const double *arrivals, size_t count, double *departures,
                                  double *departures_upper, tdsp_status *statuses)
{
    batch_group group = {{0}, {0}};
    if (!table || !table->bytes || !arrivals) return TDSP_INVALID_ARGUMENT;
    int grouped = batch_pays(table, &table->by_arrival);
    for (size_t i = 0; i < count; i++) {
        size_t at = i % BATCH_GROUP;
        if (grouped && at == 0) batch_prepare_arrivals(table, arrivals, i, batch_end(i, count), &group);
        double low = -INFINITY;
        double high = -INFINITY;
        tdsp_status status = batch_departure(table, grouped ? &group : NULL, at, arrivals[i], &low, &high);
        if (departures) departures[i] = low;
        if (departures_upper) departures_upper[i] = high;
        if (statuses) statuses[i] = status;
    }
    return TDSP_OK;
}
