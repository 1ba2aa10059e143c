/* SPDX-License-Identifier: MIT */
/* Tables over toy oracles. All checks are made in long double against the closed form. */
#include "support/toy_tables.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support/assert.h"

#define STEPS 100

/* The double right after 10, and the two right after 1. */
#define AFTER_TEN 0x1.4000000000001p+3
#define AFTER_ONE 0x1.0000000000001p+0
#define AFTER_THAT 0x1.0000000000002p+0

static const toy_piece linear[] = {{10, 5, 1, 0}};
static const toy_piece quadratic[] = {{10, 5, 0, 0.3}};
static const toy_piece flat[] = {{7, 3, 0, 0}};
static const toy_piece slow[] = {{10, 5, 0.0101, 0}};
static const toy_piece steep[] = {{1, 5, 0.1, 0}, {1.001, 5.2, 20000, 0}, {3, 26, 0.5, 0}};
static const toy_piece cliff[] = {{7, 3, 0, 0}, {8, 9, 0, 0}};
static const toy_piece bend[] = {{4, 5, 0.5, 0}, {6, 7, 2, 0}, {10, 11, 0.2, 0.1}};
static const toy_piece zero[] = {{5, 0, 0, 0}};
static const toy_piece zero_jump[] = {{5, 0, 0, 0}, {9, 4, 1, 0}};
static const toy_piece neighbours[] = {{1, 3, 0.1, 0}, {AFTER_ONE, 4, 0, 0}, {AFTER_THAT, 5, 0, 0}, {3, 6, 0.2, 0}};
static const toy_piece end_jump[] = {{10, 3, 0.1, 0}, {AFTER_TEN, 8, 0, 0}};
static const toy_piece start_jump[] = {{0, 3, 0, 0}, {4, 8, 0.3, 0}};
static const toy_piece instant[] = {{0, 3, 0, 0}};
static const toy_piece tiny[] = {{4e-7, 5e-7, 0.5, 0}, {6e-7, 9e-7, 2, 0}};
static const toy_piece huge[] = {{4e9, 5e8, 0.5, 0}, {6e9, 9e9, 2, 0}};

/* Arrivals, none before its departure. */
static const toy_piece city[] = {{4, 5, 0.5, 0}, {6, 8, 0.25, 0}, {10, 11, 0.2, 0.1}, {20, 25, 0, 0}, {30, 31, 1, 0}};
static const toy_piece shuttle[] = {{5, 10, 0, 0}, {10, 15, 0, 0}, {15, 20, 0, 0}, {20, 25, 0, 0}, {25, 30, 0, 0}};
static const toy_piece lane[] = {{50, 3, 1, 0}};

static toy_piece *stairs(double slope)
{
    static toy_piece flat_steps[STEPS];
    static toy_piece rising_steps[STEPS];
    toy_piece *steps = slope > 0 ? rising_steps : flat_steps;
    double value = 3;
    for (int i = 0; i < STEPS; i++, value *= 1.017)
        steps[i] = (toy_piece){(i + 1) * 0.137, value, slope * value, 0};
    return steps;
}

#define WORLD(list)                                                                                                              \
    {                                                                                                                            \
        #list,                                                                                                                   \
        {                                                                                                                        \
            .pieces = (list), .count = sizeof(list) / sizeof *(list), .reason = TDSP_CUT_OFF                                     \
        }                                                                                                                        \
    }
#define NETWORK(list)                                                                                                            \
    {                                                                                                                            \
        #list,                                                                                                                   \
        {                                                                                                                        \
            .pieces = (list), .count = sizeof(list) / sizeof *(list), .by_arrival = 1, .reason = TDSP_UNREACHABLE                \
        }                                                                                                                        \
    }

const toy_world *toy_worlds(size_t *count)
{
    static toy_world worlds[] = {WORLD(linear),         WORLD(quadratic),  WORLD(flat),       WORLD(slow),       WORLD(steep),
                                 WORLD(cliff),          WORLD(bend),       WORLD(zero),       WORLD(tiny),       WORLD(huge),
                                 WORLD(zero_jump),      WORLD(end_jump),   WORLD(neighbours), WORLD(start_jump), WORLD(instant),
                                 {.name = "staircase"}, {.name = "rising"}};
    *count = sizeof worlds / sizeof *worlds;
    worlds[*count - 2].toy = toy_over(stairs(0), STEPS, 0);
    worlds[*count - 1].toy = toy_over(stairs(0.05), STEPS, 0);
    return worlds;
}

const toy_world *toy_networks(size_t *count)
{
    static const toy_world networks[] = {NETWORK(city), NETWORK(shuttle), NETWORK(lane)};
    *count = sizeof networks / sizeof *networks;
    return networks;
}

const toy_world *toy_named(const char *name)
{
    size_t count;
    const toy_world *worlds = toy_worlds(&count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(worlds[i].name, name) == 0) return &worlds[i];
    worlds = toy_networks(&count);
    for (size_t i = 0; i < count; i++)
        if (strcmp(worlds[i].name, name) == 0) return &worlds[i];
    fail_msg("no toy %s", name);
    return NULL;
}

toy_table toy_build(const tdsp_oracle *oracle, const tdsp_build_options *options)
{
    toy_table t;
    memset(&t, 0, sizeof t);
    assert_int_equal(tdsp_build(oracle, options, NULL, &t.bytes, &t.length, &t.report), TDSP_OK);
    assert_int_equal(tdsp_table_open(&t.table, t.bytes, t.length), TDSP_OK);
    assert_int_equal(t.report.bytes, t.length);
    assert_int_equal(t.report.rows, t.table.rows);
    return t;
}

void toy_table_free(toy_table *t)
{
    tdsp_bytes_free(NULL, t->bytes, t->length);
    t->bytes = NULL;
}

/* The upper end that the guarantee allows for a lower one. */
static long double allowed(const tdsp_build_options *options, double departure, double lower)
{
    long double eps = options->epsilon;
    if (options->guarantee == TDSP_GUARANTEE_ABSOLUTE) return lower + (long double)options->delta;
    if (options->guarantee == TDSP_GUARANTEE_ARRIVAL) return (1 + eps) * lower;
    return departure + (1 + eps) * ((long double)lower - departure);
}

/* A toy whose forward function jumps late is not to be judged between the two places. */
static int is_ambiguous(const toy *truth, double departure)
{
    if (truth->blur == 0) return 0;
    for (size_t i = 0; i < truth->count; i++) {
        double late = departure - truth->pieces[i].until;
        if (late > 0 && late < 2 * truth->blur) return 1;
    }
    return 0;
}

static void certify_at(const toy *truth, const tdsp_build_options *options, const toy_table *t, double departure)
{
    if (departure < 0 || is_ambiguous(truth, departure)) return;
    double lower = NAN;
    double upper = NAN;
    tdsp_status status = tdsp_table_arrival(&t->table, departure, &lower, &upper);
    if (departure > t->report.last_departure) {
        assert_int_equal(status, t->report.last_reason);
        return;
    }
    assert_int_equal(status, TDSP_OK);
    long double arrival = toy_arrival(truth, departure);
    int good = lower <= arrival && arrival <= upper && upper <= allowed(options, departure, lower);
    if (good) return;
    print_error("at %.17g: [%.17g, %.17g], arrival %.20Lg, allowed %.20Lg\n", departure, lower, upper, arrival,
                allowed(options, departure, lower));
    fail();
}

static double draw(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) * 0x1p-53;
}

void toy_certify(const toy *truth, const tdsp_build_options *options, const toy_table *t, size_t samples)
{
    uint64_t state = 20180801984u;
    double last = t->report.last_departure;
    for (size_t i = 0; i < samples; i++)
        certify_at(truth, options, t, draw(&state) * last * 1.01);
    for (uint64_t i = 0; i < t->table.rows; i++) {
        tdsp_row row;
        assert_int_equal(tdsp_table_row(&t->table, i, &row), TDSP_OK);
        certify_at(truth, options, t, nextafter(row.departure, -INFINITY));
        certify_at(truth, options, t, row.departure);
        certify_at(truth, options, t, nextafter(row.departure, INFINITY));
    }
}

size_t toy_least_rows(const toy *t, const tdsp_build_options *options)
{
    double last = fmin(toy_last(t), options->horizon);
    double b = 0;
    size_t rows = 1;
    while (b < last) {
        long double lower = toy_value_after(t, b);
        long double shift = options->guarantee == TDSP_GUARANTEE_ARRIVAL && !t->by_arrival ? b : 0;
        long double rise = options->epsilon * (lower + shift);
        if (options->guarantee == TDSP_GUARANTEE_ABSOLUTE) rise = options->delta;
        double next = toy_inverse(t, lower + rise);
        if (next > b) rows++;
        /* A piece of one double may be left in long double only by a step that no double makes. */
        b = next > b ? next : nextafter(b, INFINITY);
    }
    return rows;
}
