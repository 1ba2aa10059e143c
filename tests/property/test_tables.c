/* SPDX-License-Identifier: MIT */
/* Tables of random scenes: what is built is accepted by the verifier, and keeps its promise at random departures. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "support/property.h"
#include "tdsp/build.h"
#include "tdsp/table.h"
#include "tdsp/verify.h"

#define EPSILON 0.02
#define MOST_LEGS 512
#define SAMPLES 100 /* random departures for each table */

typedef struct built {
    void *bytes;
    size_t length;
    tdsp_table table;
    tdsp_table_info info;
} built;

static void choose(const property_case *c, tdsp_guarantee guarantee, tdsp_sampling sampling, tdsp_build_options *options)
{
    tdsp_build_options_init(options);
    options->guarantee = guarantee;
    options->sampling = sampling;
    options->epsilon = EPSILON;
    options->delta = EPSILON * c->unit;
    options->world.scene_hash = tdsp_scene_hash(c->scene);
    options->world.speed = c->journey.speed;
    options->world.source = c->journey.source;
    options->world.destination = c->journey.destination;
}

static tdsp_status always_rough(void *ctx, double departure, double delta, double *arrival, double *lower)
{
    return tdsp_earliest_arrival_within(ctx, departure, delta, arrival, lower);
}

/*
 * 1 when there is a table; 0 when the scene has no path. Where nothing ends the departures a horizon does. The solver's oracle is exact in
 * scenes as small as these, unless it is told not to be.
 */
static int build(property_case *c, tdsp_guarantee guarantee, tdsp_sampling sampling, int rough, built *out)
{
    tdsp_oracle oracle;
    tdsp_build_options options;
    choose(c, guarantee, sampling, &options);
    property_holds(c, tdsp_solver_oracle(c->solver, &oracle) == TDSP_OK);
    if (rough) oracle.earliest_arrival_within = always_rough;
    tdsp_last_departure last;
    const int possible = property_arrival(c, 0.0) < INFINITY;
    if (possible) {
        property_holds(c, tdsp_solver_last_departure(c->solver, &last) == TDSP_OK);
        if (last.departure == INFINITY)
            property_holds(c, tdsp_build(&oracle, &options, NULL, &out->bytes, &out->length, NULL) == TDSP_NEEDS_HORIZON);
        if (!(last.departure < 50.0 * c->unit)) options.horizon = 5.0 * c->unit;
    }
    const tdsp_status status = tdsp_build(&oracle, &options, NULL, &out->bytes, &out->length, NULL);
    if (!possible) property_holds(c, status != TDSP_OK && tdsp_status_is_answer(status));
    if (!possible) return 0;
    property_relates(c, (double)status, ==, (double)TDSP_OK);
    property_holds(c, tdsp_table_open(&out->table, out->bytes, out->length) == TDSP_OK);
    property_holds(c, tdsp_table_get_info(&out->table, &out->info) == TDSP_OK);
    return 1;
}

static void is_accepted(property_case *c, const built *b)
{
    tdsp_table_verdict verdict;
    property_holds(c, tdsp_verify_table(c->scene, &b->table, &verdict) == TDSP_OK);
    property_relates(c, verdict.worst.min_clearance, >=, -verdict.worst.tolerance);
    property_holds(c, verdict.worst.problems == 0);
    property_holds(c, verdict.ok);
}

static void keeps_promise_at(property_case *c, const built *b, double departure)
{
    double lower, upper;
    property_holds(c, tdsp_table_arrival(&b->table, departure, &lower, &upper) == TDSP_OK);
    const double arrival = property_arrival(c, departure), rounding = 1e-14 * (departure + upper);
    property_relates(c, lower, <=, arrival);
    property_relates(c, arrival, <=, upper);
    switch ((int)b->info.guarantee) {
    case TDSP_GUARANTEE_TRAVEL:
        property_relates(c, upper - departure, <=, (1.0 + EPSILON) * (lower - departure) + rounding);
        break;
    case TDSP_GUARANTEE_ARRIVAL:
        property_relates(c, upper, <=, (1.0 + EPSILON) * lower + rounding);
        break;
    default:
        property_relates(c, upper - lower, <=, EPSILON * c->unit + rounding);
        break;
    }
}

/* The row's path moved to the departure is a path, and arrives in time. */
static void path_serves(property_case *c, const built *b, double departure)
{
    static tdsp_leg legs[MOST_LEGS];
    size_t count;
    tdsp_verdict verdict;
    double upper;
    property_holds(c, tdsp_table_arrival(&b->table, departure, NULL, &upper) == TDSP_OK);
    property_holds(c, tdsp_table_path(&b->table, departure, legs, MOST_LEGS, &count) == TDSP_OK);
    const double arrival = count ? legs[count - 1].end_time : departure;
    property_relates(c, arrival, <=, upper + 1e-15 * (upper + b->info.last_departure));
    property_holds(c, tdsp_verify_path(c->scene, legs, count, departure, arrival, &verdict) == TDSP_OK);
    property_relates(c, verdict.min_clearance, >=, -verdict.tolerance);
    property_holds(c, verdict.problems == 0);
}

/* Leaving at `departure` arrives by a; nobody who leaves after `departure_upper` does. */
static void inverse_is_certified(property_case *c, const built *b, double a)
{
    double departure, last;
    const tdsp_status status = tdsp_table_departure(&b->table, a, &departure, &last);
    if (status == TDSP_ARRIVAL_TOO_EARLY) {
        property_relates(c, property_arrival(c, 0.0), >=, a * (1.0 - EPSILON));
        return;
    }
    property_holds(c, status == TDSP_OK);
    property_relates(c, departure, <=, last);
    property_relates(c, property_arrival(c, departure), <=, a);
    /* A table that ends at a horizon says nothing of departures after it. */
    if (last < b->info.last_departure) property_relates(c, property_arrival(c, last * (1.0 + 1e-9) + 1e-9 * c->unit), >, a);
}

static void keeps_promise(property_case *c, const built *b)
{
    const double end = b->info.last_departure;
    for (int i = 0; i < SAMPLES; i++)
        keeps_promise_at(c, b, end * chance_unit(&c->chance));
    keeps_promise_at(c, b, 0.0);
    keeps_promise_at(c, b, end);
    for (int i = 0; i < 5; i++)
        path_serves(c, b, end * chance_unit(&c->chance));
    for (int i = 0; i < 5; i++) {
        double upper;
        property_holds(c, tdsp_table_arrival(&b->table, end * chance_unit(&c->chance), NULL, &upper) == TDSP_OK);
        inverse_is_certified(c, b, upper * chance_between(&c->chance, 0.95, 1.1));
    }
}

static void table_is_good(property_case *c, tdsp_guarantee guarantee, tdsp_sampling sampling, int rough)
{
    built b;
    if (!build(c, guarantee, sampling, rough, &b)) return;
    is_accepted(c, &b);
    keeps_promise(c, &b);
    tdsp_bytes_free(NULL, b.bytes, b.length);
}

static void travel_is_good(property_case *c)
{
    table_is_good(c, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 0);
}

static void arrival_is_good(property_case *c)
{
    table_is_good(c, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_ADAPTIVE, 0);
}

static void absolute_is_good(property_case *c)
{
    table_is_good(c, TDSP_GUARANTEE_ABSOLUTE, TDSP_SAMPLING_ADAPTIVE, 0);
}

static void geometric_is_good(property_case *c)
{
    table_is_good(c, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC, 0);
}

static void rough_is_good(property_case *c)
{
    table_is_good(c, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 1);
    table_is_good(c, TDSP_GUARANTEE_ABSOLUTE, TDSP_SAMPLING_ADAPTIVE, 1);
}

static void a_table_of_rough_answers_keeps_its_guarantee(void **state)
{
    (void)state;
    property_each(5, 10, rough_is_good);
}

static void a_table_keeps_its_guarantee_in_travel_time(void **state)
{
    (void)state;
    property_each(8, 10, travel_is_good);
}

static void a_table_keeps_its_guarantee_in_arrival_time(void **state)
{
    (void)state;
    property_each(5, 10, arrival_is_good);
}

static void a_table_keeps_its_absolute_guarantee(void **state)
{
    (void)state;
    property_each(5, 10, absolute_is_good);
}

static void a_geometric_table_keeps_its_guarantee(void **state)
{
    (void)state;
    property_each(5, 10, geometric_is_good);
}

static uint64_t rows_of(property_case *c, tdsp_sampling sampling)
{
    built b;
    if (!build(c, TDSP_GUARANTEE_ARRIVAL, sampling, 0, &b)) return 0;
    const uint64_t rows = b.info.rows;
    tdsp_bytes_free(NULL, b.bytes, b.length);
    return rows;
}

static void adaptive_needs_no_more(property_case *c)
{
    property_relates(c, (double)rows_of(c, TDSP_SAMPLING_ADAPTIVE), <=, (double)rows_of(c, TDSP_SAMPLING_GEOMETRIC));
}

static void adaptive_sampling_never_needs_more_rows_than_geometric(void **state)
{
    (void)state;
    property_each(8, 10, adaptive_needs_no_more);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_keeps_its_guarantee_in_travel_time),
        cmocka_unit_test(a_table_keeps_its_guarantee_in_arrival_time),
        cmocka_unit_test(a_table_keeps_its_absolute_guarantee),
        cmocka_unit_test(a_table_of_rough_answers_keeps_its_guarantee),
        cmocka_unit_test(a_geometric_table_keeps_its_guarantee),
        cmocka_unit_test(adaptive_sampling_never_needs_more_rows_than_geometric),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
