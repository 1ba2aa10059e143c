/* SPDX-License-Identifier: MIT */
/*
 * Arrivals within a share of the best, on random scenes: against the exact engine, the slow solver and the verifier, and against themselves in other
 * coordinates. So few discs are always searched all together, with heavier bounds.
 */
#include "support/cmocka_all.h"

#include <string.h>

#include "slow/slow.h"
#include "support/chance.h"
#include "support/property.h"

/* Relative to the travel time and the journey. */
#define NEAR 1e-9

static const double deltas[] = {0.0, 1e-9, 1e-3, 0.05, 0.3, 1.0};
enum { DELTAS = sizeof deltas / sizeof *deltas };

typedef struct interval {
    double lower;
    double arrival;
} interval;

static double some_departure(property_case *c, int number)
{
    double last = tdsp_scene_source_free_until(c->scene, NULL);
    if (!(last < 3.0 * c->unit)) last = 3.0 * c->unit;
    return number == 0 ? 0.0 : number == 1 ? last * chance_between(&c->chance, 0.9, 1.1) : last * chance_between(&c->chance, 0.0, 0.6);
}

static double slack_of(const property_case *c, double departure, double arrival)
{
    return NEAR * (c->unit + (arrival < INFINITY ? arrival - departure : 0.0));
}

static interval within(property_case *c, double departure, double delta)
{
    interval found = {-1.0, -1.0};
    const tdsp_status status = tdsp_earliest_arrival_within(c->solver, departure, delta, &found.arrival, &found.lower);
    property_holds(c, tdsp_status_is_answer(status));
    property_holds(c, (status == TDSP_OK) == (found.arrival < INFINITY) && (status == TDSP_OK) == (found.lower < INFINITY));
    if (status != TDSP_OK) return found;
    property_relates(c, found.lower, <=, found.arrival);
    property_relates(c, found.lower, >=, departure);
    property_relates(c, found.arrival - departure, <=, (1.0 + delta) * (found.lower - departure) + slack_of(c, departure, found.arrival));
    property_relates(c, found.arrival, <=, (1.0 + delta) * found.lower + slack_of(c, departure, found.arrival));
    return found;
}

/* Does the interval hold the arrival, or at a jump one of those beside it? */
static void holds(property_case *c, interval found, double arrival, double departure, double (*beside)(property_case *c, double departure))
{
    const double slack = slack_of(c, departure, arrival), step = NEAR * (c->unit + departure);
    if (found.arrival == arrival) return;
    if (!(found.lower <= arrival + slack)) property_relates(c, found.lower, <=, beside(c, departure + step) + slack);
    if (!(found.arrival >= arrival - slack)) property_relates(c, found.arrival, >=, beside(c, fmax(0.0, departure - step)) - slack);
}

static void is_within(property_case *c)
{
    for (int i = 0; i < 4; i++) {
        const double departure = some_departure(c, i), delta = deltas[chance_below(&c->chance, DELTAS)];
        const interval found = within(c, departure, delta);
        if (found.arrival < INFINITY) property_path_is_good(c, departure, found.arrival);
        holds(c, found, property_arrival(c, departure), departure, property_arrival);
    }
}

static void the_interval_holds_the_exact_arrival_and_its_path_is_accepted_by_the_verifier(void **state)
{
    (void)state;
    property_each(40, 40, is_within);
}

static double slow(property_case *c, double departure)
{
    const double arrival = slow_arrival(&c->journey, c->discs, c->count, departure);
    property_holds(c, !isnan(arrival));
    return arrival;
}

static void is_within_slowly(property_case *c)
{
    for (int i = 0; i < 3; i++) {
        const double departure = some_departure(c, i), delta = deltas[2 + chance_below(&c->chance, DELTAS - 2)];
        holds(c, within(c, departure, delta), slow(c, departure), departure, slow);
    }
}

static void the_interval_holds_the_arrival_of_the_slow_solver(void **state)
{
    (void)state;
    property_each(20, 6, is_within_slowly);
}

/* Why there is no way does not depend on how well one wants to know. */
static void reason_is_the_same(property_case *c)
{
    for (int i = 0; i < 4; i++) {
        const double departure = some_departure(c, i);
        double arrival, lower;
        const tdsp_status exact = tdsp_earliest_arrival(c->solver, departure, &arrival);
        for (int k = 0; k < DELTAS; k++)
            property_holds(c, tdsp_earliest_arrival_within(c->solver, departure, deltas[k], &arrival, &lower) == exact);
    }
}

static void the_status_is_that_of_the_exact_answer(void **state)
{
    (void)state;
    property_each(15, 30, reason_is_the_same);
}

static void zero_is_exact(property_case *c)
{
    for (int i = 0; i < 3; i++) {
        const double departure = some_departure(c, i);
        const interval found = within(c, departure, 0.0);
        const double exact = property_arrival(c, departure);
        if (found.arrival == exact) continue;
        property_relates(c, fabs(found.arrival - exact), <=, slack_of(c, departure, exact));
        property_relates(c, fabs(found.lower - exact), <=, slack_of(c, departure, exact));
    }
}

static void a_share_of_nothing_is_exact(void **state)
{
    (void)state;
    property_each(20, 30, zero_is_exact);
}

typedef tdsp_point (*place_change)(tdsp_point p);

static tdsp_point turned(tdsp_point p)
{
    return (tdsp_point){0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y};
}

static tdsp_point mirrored(tdsp_point p)
{
    return (tdsp_point){p.x, -p.y};
}

/* Where ends or boundaries touch, rounding tells them apart when they are turned. */
static int touches(const property_case *c)
{
    return strcmp(c->name, "on_source") == 0 || strcmp(c->name, "on_destination") == 0 || strcmp(c->name, "touching") == 0;
}

/* In other coordinates another path may be found; its interval holds the same arrival. */
static void other_coordinates_hold_it_too(property_case *c)
{
    static const place_change changes[] = {turned, mirrored};
    for (size_t k = 0; k < 2; k++) {
        property_case other = *c;
        if (changes[k] == turned && touches(c)) continue;
        other.journey.source = changes[k](c->journey.source);
        other.journey.destination = changes[k](c->journey.destination);
        for (size_t i = 0; i < c->count; i++) other.discs[i].center = changes[k](c->discs[i].center);
        property_prepare(&other);
        const double departure = some_departure(c, 2), slack = slack_of(c, departure, 0.0), step = NEAR * (c->unit + departure);
        const interval there = within(&other, departure, 0.05);
        property_relates(c, within(c, fmax(0.0, departure - step), 0.05).lower, <=, there.arrival + slack);
        property_relates(c, there.lower, <=, within(c, departure + step, 0.05).arrival + slack);
        property_drop(&other);
    }
}

static void intervals_of_a_turned_or_mirrored_scene_overlap(void **state)
{
    (void)state;
    property_each(15, 20, other_coordinates_hold_it_too);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_interval_holds_the_exact_arrival_and_its_path_is_accepted_by_the_verifier),
        cmocka_unit_test(the_interval_holds_the_arrival_of_the_slow_solver),
        cmocka_unit_test(the_status_is_that_of_the_exact_answer),
        cmocka_unit_test(a_share_of_nothing_is_exact),
        cmocka_unit_test(intervals_of_a_turned_or_mirrored_scene_overlap),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
