/* SPDX-License-Identifier: MIT */
/* See measure.h. */
#include "numerics/measure.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "slow/precise.h"
#include "support/chance.h"
#include "tdsp/build.h"
#include "tdsp/table.h"
#include "tdsp/verify.h"

enum { MOST_DISCS = 64, MOST_LEGS = 4096 };

#define ULP 0x1p-52

static void fail(const numeric_case *c, const char *what, double at)
{
    fprintf(stderr, "%s, seed %llu: %s at %.17g\n", c->name, (unsigned long long)c->seed, what, at);
    exit(1);
}

/* Keep the greatest, and the question that gave it when it is beyond its bound by more than any other. */
static void note(numeric_case *c, double *worst, double value, double bound, const char *what, double at)
{
    if (value > *worst) *worst = value;
    if (!(value > bound) || !(value / bound > c->into->worst_ratio)) return;
    c->into->worst_ratio = value / bound;
    snprintf(c->into->worst, sizeof c->into->worst, "%s, seed %llu, %s at %.17g: %.3g", c->name, (unsigned long long)c->seed, what, at, value);
}

static double arrival_of(const numeric_case *c, double departure)
{
    double arrival = -1.0;
    if (!tdsp_status_is_answer(tdsp_earliest_arrival(c->solver, departure, &arrival))) fail(c, "no answer", departure);
    return arrival;
}

/* A* with every disc larger by the share eta of |sd| plus its radius at `reference`. */
static long double precise(numeric_case *c, double departure, double eta, double reference)
{
    tdsp_disc discs[MOST_DISCS];
    const double length = c->unit * c->journey.speed;
    for (size_t i = 0; i < c->count; i++) {
        discs[i] = c->discs[i];
        discs[i].radius += eta * (length + c->journey.radius + discs[i].radius + discs[i].growth * reference);
    }
    long double arrival = precise_arrival(&c->journey, discs, c->count, departure);
    if (isnan(arrival)) c->into->given_up++;
    return arrival;
}

/* By how much one arrival is beyond another, as a share of travel time plus journey; the rounding of the times is taken off. */
static double beyond(const numeric_case *c, long double a, long double b, double departure)
{
    if (a <= b || isnan(a) || isnan(b)) return 0.0;
    if (isinf(a)) return INFINITY;
    const long double rounding = ULP * (departure + a);
    return (double)(fmaxl(a - b - rounding, 0.0L) / (a - departure + c->unit));
}

/* The moment at which the radii are taken. */
static double reference_of(const numeric_case *c, double departure, double arrival)
{
    return arrival < INFINITY ? arrival : departure + 2.0 * c->unit;
}

static double touch_of(numeric_case *c, double departure, double arrival)
{
    const double reference = reference_of(c, departure, arrival);
    for (double eta = 1e-16; eta < 1e-3; eta *= 10.0) {
        const long double low = precise(c, departure, -eta, reference), high = precise(c, departure, eta, reference);
        if (beyond(c, low, arrival, departure) <= BOUND_ERROR && beyond(c, arrival, high, departure) <= BOUND_ERROR) return eta;
    }
    return 1.0;
}

static void measure_arrival(numeric_case *c, double departure)
{
    const double arrival = arrival_of(c, departure);
    const long double expected = precise(c, departure, 0.0, 0.0);
    if (isnan(expected)) return;
    const double error = arrival > expected ? beyond(c, arrival, expected, departure) : beyond(c, expected, arrival, departure);
    c->into->arrivals++;
    if (error <= BOUND_ERROR) {
        if (arrival < INFINITY) note(c, &c->into->roundings, (double)(fabsl(arrival - expected) / (ULP * (departure + expected))), INFINITY, "", 0.0);
        note(c, &c->into->error, error, BOUND_ERROR, "arrival", departure);
        return;
    }
    c->into->touches++;
    note(c, &c->into->touch, touch_of(c, departure, arrival), BOUND_TOUCH, "touch of the arrival", departure);
}

static void measure_path(numeric_case *c, double departure)
{
    static tdsp_leg legs[MOST_LEGS];
    size_t count;
    tdsp_verdict verdict;
    const double arrival = arrival_of(c, departure);
    if (isinf(arrival)) return;
    if (tdsp_solver_path(c->solver, legs, MOST_LEGS, &count) != TDSP_OK) fail(c, "no path", departure);
    if (tdsp_verify_path(c->scene, legs, count, departure, arrival, &verdict) != TDSP_OK) fail(c, "no verdict", departure);
    if (verdict.problems) note(c, &c->into->depth, INFINITY, 1.0, "a path that is refused", departure);
    note(c, &c->into->depth, fmax(-verdict.min_clearance, 0.0) / verdict.tolerance, 1.0, "depth of the path", departure);
}

/*
 * A latest departure d is too late when A*(d) > a, and by no more than that, for A grows at least as fast as time. It is too early when A* a little later is not
 * after a; how little is found by trying.
 */
static void measure_departure(numeric_case *c, double a)
{
    double departure, arrives;
    const tdsp_status status = tdsp_latest_departure(c->solver, a, &departure, &arrives);
    if (status != TDSP_OK) return;
    const double reference = reference_of(c, departure, a);
    const long double expected = precise(c, departure, 0.0, 0.0);
    if (isnan(expected)) return;
    c->into->departures++;
    double late = beyond(c, expected, a, departure);
    if (late > BOUND_ERROR) {
        double eta = 1e-16;
        while (eta < 1.0 && beyond(c, precise(c, departure, -eta, reference), a, departure) > BOUND_ERROR) eta *= 10.0;
        note(c, &c->into->depart_touch, eta, BOUND_TOUCH, "touch of the latest departure (too late)", a);
    } else {
        note(c, &c->into->late, late, BOUND_ERROR, "latest departure too late", a);
    }
    if (isinf(a) || a >= tdsp_scene_destination_free_until(c->scene, NULL)) return;
    double early = beyond(c, a, expected, departure);
    for (double e = 1e-16; early > BOUND_ERROR; e *= 10.0) {
        const double later = departure + e * (a - departure + c->unit) + ULP * (a + departure);
        if (precise(c, later, 0.0, 0.0) > a) early = e;
        if (early > BOUND_ERROR && e >= 1e-4) break;
    }
    if (early > BOUND_ERROR) {
        double eta = 1e-16;
        const double later = departure + BOUND_ERROR * (a - departure + c->unit) + ULP * (a + departure);
        while (eta < 1.0 && !(precise(c, later, eta, reference) > a)) eta *= 10.0;
        note(c, &c->into->depart_touch, eta, BOUND_TOUCH, "touch of the latest departure (too early)", a);
    } else {
        note(c, &c->into->early, early, BOUND_ERROR, "latest departure too early", a);
    }
}

/* T over departures that come ever closer to one. */
static void measure_fall(numeric_case *c, double departure)
{
    double before = 0.0;
    for (double step = -1.0; fabs(step) > 1e-15;) {
        const double at = fmax(departure + step * 0.1 * c->unit, 0.0), arrival = arrival_of(c, at);
        if (arrival == INFINITY) {
            before = INFINITY;
        } else {
            const double travel = arrival - at, rounding = 2.0 * ULP * (at + arrival);
            const double fall = isinf(before) ? INFINITY : (before - travel - rounding) / (travel + c->unit);
            note(c, &c->into->fall, fall, 2.0 * BOUND_ERROR, "travel time falls", at);
            if (!isinf(before)) before = fmax(before, travel);
        }
        step = step < 0.0 ? step / 8.0 : step * 8.0;
        if (step < 0.0 && step > -1e-14) step = 1e-14;
        if (step > 1.0) return;
    }
}

static void measure_interval(numeric_case *c, const tdsp_table *table, double departure)
{
    double lower, upper;
    if (tdsp_table_arrival(table, departure, &lower, &upper) != TDSP_OK) return;
    const long double expected = precise(c, departure, 0.0, 0.0);
    if (expected >= lower && expected <= upper) return;
    const double reference = reference_of(c, departure, upper);
    double eta = 1e-16;
    while (eta < 1e-3 && !(precise(c, departure, eta, reference) >= lower && precise(c, departure, -eta, reference) <= upper)) eta *= 10.0;
    note(c, &c->into->outside, eta, BOUND_TOUCH, "touch of a table's interval", departure);
}

/* At the ends of rows, where the interval is tight. */
static void measure_rows(numeric_case *c, const tdsp_table *table, int questions)
{
    tdsp_table_info info;
    tdsp_row row;
    if (tdsp_table_get_info(table, &info) != TDSP_OK) fail(c, "no information", 0.0);
    for (int i = 0; i < questions; i++) {
        if (tdsp_table_row(table, chance_below(&c->chance, info.rows), &row) != TDSP_OK) fail(c, "no row", 0.0);
        measure_interval(c, table, row.departure);
        measure_interval(c, table, nextafter(row.departure, INFINITY));
    }
}

static void measure_table(numeric_case *c, int questions)
{
    tdsp_build_options options;
    tdsp_oracle oracle;
    tdsp_table table;
    void *bytes;
    size_t length;
    tdsp_build_options_init(&options);
    options.horizon = 3.0 * c->unit;
    if (tdsp_solver_oracle(c->solver, &oracle) != TDSP_OK) fail(c, "no oracle", 0.0);
    if (isinf(arrival_of(c, 0.0)) || tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL) != TDSP_OK) return;
    if (tdsp_table_open(&table, bytes, length) != TDSP_OK) fail(c, "no table", 0.0);
    c->into->tables++;
    measure_rows(c, &table, questions);
    tdsp_bytes_free(NULL, bytes, length);
}

/* Halve into the half in which T rises more: a jump, if there is one. */
static double steepest(numeric_case *c, double low, double high)
{
    double at_low = arrival_of(c, low) - low, at_high = arrival_of(c, high) - high;
    for (int i = 0; i < 80; i++) {
        const double middle = 0.5 * (low + high);
        if (!(middle > low && middle < high)) break;
        const double at = arrival_of(c, middle) - middle;
        if (at < INFINITY && (isinf(at_high) || at_high - at >= at - at_low)) {
            low = middle;
            at_low = at;
        } else {
            high = middle;
            at_high = at;
        }
    }
    return low;
}

/* What the fastest path rides, and in which sense; a number that hardly two sequences have in common. */
static uint64_t form_of(numeric_case *c, double departure)
{
    static tdsp_leg legs[MOST_LEGS];
    size_t count;
    uint64_t form = 0;
    if (isinf(arrival_of(c, departure))) return 1;
    if (tdsp_solver_path(c->solver, legs, MOST_LEGS, &count) != TDSP_OK) fail(c, "no path", departure);
    for (size_t i = 0; i < count; i++)
        if (legs[i].kind == TDSP_LEG_ARC) form = form * 1000003u + 2 * legs[i].disc + (legs[i].turn > 0) + 7;
    return form;
}

/* A departure at which the form changes, if it is not the same at both. */
static double form_change(numeric_case *c, double low, double high)
{
    const uint64_t before = form_of(c, low);
    for (int i = 0; i < 80; i++) {
        const double middle = 0.5 * (low + high);
        if (!(middle > low && middle < high)) break;
        *(form_of(c, middle) == before ? &low : &high) = middle;
    }
    return low;
}

/* Where answers are easy, beside a jump, beside a change of the path's form (a touch, or a switch), and just before the source is covered. */
static double departure_for(numeric_case *c, int question, double last)
{
    const double from = fmin(c->first, last), any = chance_between(&c->chance, from, last);
    double step = chance_between(&c->chance, 1.0, 10.0);
    for (uint64_t k = 4 + chance_below(&c->chance, 13); k > 0; k--) step /= 10.0;
    if (question == 0) return c->first;
    if (question % 4 == 1) return any;
    const double covered = tdsp_scene_source_free_until(c->scene, NULL);
    if (question % 4 == 0 && covered < 1e3 * c->unit) return fmax(covered - step * fmax(c->unit, covered), 0.0);
    const double at = question % 4 == 2 ? steepest(c, fmin(any, last), last) : form_change(c, from, any);
    return fmax(at + (chance_below(&c->chance, 2) ? step : -step) * c->unit, 0.0);
}

void measure_scene(numeric_case *c, int questions)
{
    double last = fmin(tdsp_scene_source_free_until(c->scene, NULL), tdsp_scene_destination_free_until(c->scene, NULL));
    last = fmin(last, c->first + 3.0 * c->unit);
    c->into->scenes++;
    for (int i = 0; i < questions; i++) {
        const double departure = departure_for(c, i, last);
        measure_arrival(c, departure);
        measure_path(c, departure);
        measure_fall(c, departure);
        const double arrival = arrival_of(c, departure);
        measure_departure(c, arrival < INFINITY ? arrival + (i % 2 ? 0.1 * c->unit : 0.0) : last + c->unit);
    }
    if (c->first == 0.0) measure_table(c, questions);
}
