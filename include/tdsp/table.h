/* SPDX-License-Identifier: MIT */
/*
 * Tables: open the bytes once, then look up departures and paths. No heap, no stdio, no recursion, no state;
 * firmware may use everything here. The format is specified in docs/format.md.
 *
 * Rows 0 .. n-1 are at departures b_0 = 0 < b_1 < ... ; row i answers every t in (b_(i-1), b_i], row 0 answers t = 0.
 */
#ifndef TDSP_TABLE_H
#define TDSP_TABLE_H

#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Private: where a guide is in the bytes, and how to read it (docs/format.md, section 7). */
typedef struct tdsp_guide {
    uint64_t bases; /* offsets of its two parts; 0: the table has none */
    uint64_t counts;
    uint64_t cells;
    double scale; /* cells per unit of time */
    double first; /* the time that cell 0 starts at, and the last row's */
    double last;
} tdsp_guide;

/**
 * An opened table: a view of the caller's bytes, which must stay as they are while it is used. Members are private. Copy it freely;
 * any number of threads may read it.
 */
typedef struct tdsp_table {
    const unsigned char *bytes;
    uint64_t length;
    uint64_t rows;
    uint64_t waypoint_count;
    uint64_t arc_count;
    uint64_t departures; /* offsets of the sections */
    uint64_t left;
    uint64_t right;
    uint64_t first_waypoint;
    uint64_t waypoints;
    uint64_t arcs;
    uint64_t first_byte;
    uint64_t opaque;
    uint64_t opaque_length;
    uint32_t monotone;
    uint32_t joint; /* waypoints at the joint of two legs: 1 or 2 */
    uint64_t last;  /* the bits of the last departure; 0 where it is 0 */
    tdsp_guide by_departure;
    tdsp_guide by_arrival;
    uint64_t curve_count; /* numbered behind the arcs */
    uint64_t curves;
    uint64_t gap_count; /* of jumps */
    uint64_t gaps;
    uint64_t last_word; /* the offset of the last 8 bytes */
} tdsp_table;

/**
 * Check the bytes whole and open them.
 *
 * @param table   receives the view; untouched on error
 * @param bytes   at any alignment; not copied
 * @param length  the exact length of the table
 * @return TDSP_OK; TDSP_INVALID_ARGUMENT; TDSP_BAD_MAGIC, TDSP_BAD_VERSION, TDSP_BAD_LENGTH, TDSP_BAD_CHECKSUM, TDSP_BAD_TABLE
 *
 * O(length). After TDSP_OK no function here can read outside the bytes. Since 0.1.
 */
TDSP_API tdsp_status tdsp_table_open(tdsp_table *table, const void *bytes, size_t length);

/**
 * Open again, in O(1), bytes that tdsp_table_open() has accepted before: at an earlier start, or where firmware was made (`tdsp embed` opens what it
 * embeds). Nothing is summed up and rows are not looked at. After TDSP_OK no function here can read outside the bytes, whatever they are; but only from
 * bytes that were accepted, and are still the same, the answers are right.
 *
 * @param table   as for tdsp_table_open(), as the rest
 * @return TDSP_OK; TDSP_INVALID_ARGUMENT; TDSP_BAD_MAGIC, TDSP_BAD_VERSION, TDSP_BAD_LENGTH, TDSP_BAD_TABLE. Since 0.1.
 */
TDSP_API tdsp_status tdsp_table_reopen(tdsp_table *table, const void *bytes, size_t length);

/** What the header of a table says. */
typedef struct tdsp_table_info {
    uint16_t version_major; /* of the format */
    uint16_t version_minor; /* likewise */
    uint32_t monotone;  /* tdsp_monotone */
    uint32_t guarantee; /* tdsp_guarantee */
    uint32_t sampling;  /* tdsp_sampling */
    uint64_t rows;       /* departures in the table */
    uint64_t legs;       /* of all rows' paths */
    uint64_t length;     /* bytes */
    uint64_t scene_hash; /* of the world that it was built for */
    double epsilon; /* the bound of travel and arrival; 0 for absolute */
    double delta;   /* the bound of absolute; 0 for the others */
    double error;   /* the oracle's stated error: of A(t), error * (T(t) + time_scale) */
    double time_scale;      /* the oracle's */
    double speed;           /* the robot's top speed; 0 where that means nothing */
    tdsp_point source;      /* where journeys begin */
    tdsp_point destination; /* where they end */
    double first_lower;      /* T(0), rounded down */
    double first_departure;  /* 0 */
    double last_departure;   /* b_(n-1) */
    tdsp_status last_reason; /* why there is no answer after it */
    char length_unit[16];    /* ends with a zero byte */
    char time_unit[16];      /* likewise */
    uint64_t guide_length; /* bytes of the guides that speed up look-ups; 0: none */
    uint64_t curves;       /* stored for legs of the kind TDSP_LEG_CURVE */
    uint64_t gaps;         /* jumps of which the table says what closes (tdsp_jump) */
} tdsp_table_info;

/** What the header says. TDSP_OK or TDSP_INVALID_ARGUMENT. O(1). Since 0.1. */
TDSP_API tdsp_status tdsp_table_get_info(const tdsp_table *table, tdsp_table_info *out);

/** A row of a table. */
typedef struct tdsp_row {
    double departure; /* b_i */
    double left;      /* T(b_i), rounded up: the row's path takes no longer */
    double
        right; /* T(b_i+), rounded down: over left at a jump; infinite for the last row of a table that does not end at a horizon.
                         Elsewhere it may be below left by as much as both were rounded. */
    uint64_t legs; /* legs of the row's path */
} tdsp_row;

/** Row i. TDSP_OK or TDSP_INVALID_ARGUMENT. O(1). Since 0.1. */
TDSP_API tdsp_status tdsp_table_row(const tdsp_table *table, uint64_t row, tdsp_row *out);

/**
 * The row that answers a departure.
 *
 * @return TDSP_OK; the table's last_reason for a departure after the last; TDSP_INVALID_ARGUMENT for NaN, a negative departure or NULL.
 * O(log rows). Since 0.1.
 */
TDSP_API tdsp_status tdsp_table_find(const tdsp_table *table, double departure, uint64_t *row);

/**
 * The certified interval of the earliest arrival: lower <= A(departure) <= upper, and the row's path arrives at `upper` or before.
 * Either output may be NULL; both untouched unless TDSP_OK. Errors as tdsp_table_find(). O(log rows). Since 0.1.
 */
TDSP_API tdsp_status tdsp_table_arrival(const tdsp_table *table, double departure, double *lower, double *upper);

/**
 * The same in floats, for machines that do doubles in software: an interval of floats that contains tdsp_table_arrival()'s for this departure. Each end
 * is rounded outward, and wider by at most four units in the last place of a float (below 1.2e-38, the least normal float, by that). A lower end
 * over the greatest float is that one; an upper end is infinite. Errors as tdsp_table_find(). O(log rows). Since 0.1.
 */
TDSP_API tdsp_status tdsp_table_arrival_float(const tdsp_table *table, float departure, float *lower, float *upper);

/**
 * The other direction: leaving at `departure` arrives by `arrival` for certain; no departure after `departure_upper` can. Either output
 * may be NULL. An arrival after the last possible one, also infinity, answers the last departure; `departure_upper` is after the last
 * departure only where a horizon ended the table.
 *
 * @return TDSP_OK; TDSP_ARRIVAL_TOO_EARLY when no row certifies an arrival that early (outputs untouched); TDSP_INVALID_ARGUMENT.
 * O(log rows). Since 0.1.
 */
TDSP_API tdsp_status tdsp_table_departure(const tdsp_table *table, double arrival, double *departure, double *departure_upper);

/** `count` look-ups at once; where statuses[i] is not TDSP_OK both results are infinite. Arrays may not overlap. `lower`, `upper`
 * or `statuses` may be NULL. TDSP_OK or TDSP_INVALID_ARGUMENT (a NULL table or departures; a bad departure is answered in its status). Since 0.1. */
TDSP_API tdsp_status tdsp_table_arrivals(const tdsp_table *table, const double *departures, size_t count, double *lower,
                                         double *upper, tdsp_status *statuses);
/** As tdsp_table_arrivals(), for tdsp_table_departure(). Where a status is not TDSP_OK both results are -infinity. Since 0.1. */
TDSP_API tdsp_status tdsp_table_departures(const tdsp_table *table, const double *arrivals, size_t count, double *departures,
                                           double *departures_upper, tdsp_status *statuses);

/** As tdsp_table_arrivals(), for tdsp_table_find(): where a status is not TDSP_OK the row is the number of rows. Since 0.1. */
TDSP_API tdsp_status tdsp_table_rows(const tdsp_table *table, const double *departures, size_t count, uint64_t *rows,
                                     tdsp_status *statuses);

/**
 * Leg `leg` of the path that answers `departure`: the row's path moved earlier by b_i - departure (a table that is monotone in travel), or as
 * it is (monotone in arrival: wait until b_i).
 * @return TDSP_OK; TDSP_NO_ANSWER when the row has no leg of that number; else as tdsp_table_find(). O(log rows). Since 0.1.
 */
TDSP_API tdsp_status tdsp_table_leg(const tdsp_table *table, double departure, uint64_t leg, tdsp_leg *out);

/** Leg `leg` of row `row` as stored. TDSP_OK, TDSP_NO_ANSWER, TDSP_INVALID_ARGUMENT. O(1). Since 0.1. */
TDSP_API tdsp_status tdsp_table_row_leg(const tdsp_table *table, uint64_t row, uint64_t leg, tdsp_leg *out);

/** The opaque bytes of row `row` (oracles whose paths are bytes); length 0 when there are none. O(1). Since 0.1. */
TDSP_API tdsp_status tdsp_table_row_bytes(const tdsp_table *table, uint64_t row, const void **bytes, size_t *length);

/** The whole path that answers `departure`, with tdsp_solver_path()'s rules for the buffer. Since 0.1. */
TDSP_API tdsp_status tdsp_table_path(const tdsp_table *table, double departure, tdsp_leg *legs, size_t capacity, size_t *count);

/** Where a robot that left at `departure` is at `time` (clamped to the path). TDSP_NO_ANSWER when rows carry no legs. O(log rows +
 * log legs). Since 0.1. */
TDSP_API tdsp_status tdsp_table_position(const tdsp_table *table, double departure, double time, tdsp_point *out);

/**
 * A jump of the travel time at a row: right exceeds left by more than 2 error (left + time_scale) + 2^-40 (departure + left). Both are
 * rounded outward by the stated error already; the second term is there because right may have been taken at the next double after the
 * departure, where a steep T has risen a little.
 */
typedef struct tdsp_jump {
    uint64_t row;     /* whose departure it is */
    double departure; /* the last departure before the jump */
    double before;    /* T(departure), rounded up */
    double after;     /* T(departure+), rounded down */
    tdsp_gap gap;     /* what closes there, where the table says it */
} tdsp_jump;

/** The first jump at `departure` or later, the last jump before it: TDSP_OK, TDSP_NO_ANSWER when there is none,
 * TDSP_INVALID_ARGUMENT. The end of the table is no jump. O(log rows + rows passed over + log gaps). Since 0.1. */
TDSP_API tdsp_status tdsp_table_next_jump(const tdsp_table *table, double departure, tdsp_jump *out);
TDSP_API tdsp_status tdsp_table_previous_jump(const tdsp_table *table, double departure, tdsp_jump *out);

#ifdef __cplusplus
}
#endif

#endif
