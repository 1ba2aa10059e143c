/* SPDX-License-Identifier: MIT */
/* The engine against the slow solver, and every path against the verifier. */
#include "support/cmocka_all.h"

#include "slow/slow.h"
#include "support/chance.h"
#include "support/property.h"
#include "tdsp/verify.h"

/* Relative to the travel time and the journey; a departure this close to a jump may be on either side of it. */
#define NEAR 1e-9

/* Departures from 0 to the end of all, and some that are too late. */
static double some_departure(property_case *c, int number)
{
    if (number == 0) return 0.0;
    double last = tdsp_scene_source_free_until(c->scene, NULL);
    if (!(last < 3.0 * c->unit)) last = 3.0 * c->unit;
    return number == 1 ? last * chance_between(&c->chance, 0.9, 1.1) : last * chance_between(&c->chance, 0.0, 0.5);
}

static double slow(const property_case *c, double departure)
{
    const double arrival = slow_arrival(&c->journey, c->discs, c->count, departure);
    property_holds(c, !isnan(arrival));
    return arrival;
}

static void agrees_at(property_case *c, double departure)
{
    const double arrival = property_arrival(c, departure), expected = slow(c, departure);
    const double slack = NEAR * (c->unit + (expected < INFINITY ? expected - departure : 0.0));
    if (arrival == expected || fabs(arrival - expected) <= slack) return;
    /* Unless the departure is at a jump, where the two may differ in what is still a touch. */
    const double step = NEAR * (c->unit + departure);
    property_relates(c, arrival, >=, slow(c, fmax(0.0, departure - step)) - slack);
    property_relates(c, arrival, <=, slow(c, departure + step) + slack);
}

static void agrees(property_case *c)
{
    for (int i = 0; i < 4; i++)
        agrees_at(c, some_departure(c, i));
}

static void the_engine_and_the_slow_solver_agree(void **state)
{
    (void)state;
    property_each(40, 6, agrees);
}

static void agrees_in_company(property_case *c)
{
    for (int i = 0; i < 2; i++)
        agrees_at(c, some_departure(c, i * 2));
}

static void they_agree_on_a_dozen_discs(void **state)
{
    (void)state;
    property_each(13, 13, agrees_in_company);
}

static void path_is_good(property_case *c)
{
    for (int i = 0; i < 4; i++) {
        const double departure = some_departure(c, i), arrival = property_arrival(c, departure);
        if (arrival < INFINITY) property_path_is_good(c, departure, arrival);
    }
}

static void every_path_is_accepted_by_the_verifier(void **state)
{
    (void)state;
    property_each(40, 30, path_is_good);
}

/* The slow solver's own paths, so that the arbiter is tried on paths that the engine did not make. */
static void slow_path_is_good(property_case *c)
{
    tdsp_leg legs[64];
    size_t count;
    tdsp_verdict verdict;
    const double departure = some_departure(c, 2);
    const double arrival = slow_path(&c->journey, c->discs, c->count, departure, legs, 64, &count);
    if (!(arrival < INFINITY) || count == 0) return;
    property_holds(c, tdsp_verify_path(c->scene, legs, count, departure, arrival, &verdict) == TDSP_OK);
    property_relates(c, verdict.min_clearance, >=, -verdict.tolerance);
    property_holds(c, verdict.problems == 0);
}

static void paths_of_the_slow_solver_are_accepted_too(void **state)
{
    (void)state;
    property_each(20, 6, slow_path_is_good);
}

static void status_is_right(property_case *c)
{
    for (int i = 0; i < 4; i++) {
        const double departure = some_departure(c, i);
        double arrival = -1.0;
        const tdsp_status status = tdsp_earliest_arrival(c->solver, departure, &arrival);
        const int covered = departure > tdsp_scene_source_free_until(c->scene, NULL);
        const double destination = tdsp_scene_destination_free_until(c->scene, NULL);
        property_holds(c, covered == (status == TDSP_SOURCE_COVERED));
        property_holds(c, tdsp_status_is_answer(status));
        if (status == TDSP_OK) property_relates(c, arrival, <=, destination + NEAR * (c->unit + arrival));
        if (status == TDSP_DESTINATION_COVERED) property_holds(c, destination < INFINITY);
        if (destination < departure + c->unit * (1.0 - NEAR)) property_holds(c, status != TDSP_OK);
    }
}

static void a_status_says_what_is_covered(void **state)
{
    (void)state;
    property_each(40, 6, status_is_right);
}

static tdsp_status status_of(const tdsp_disc *discs, size_t count, double departure)
{
    property_case c = {.name = "by hand", .count = count, .journey = {1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}}};
    for (size_t i = 0; i < count; i++)
        c.discs[i] = discs[i];
    property_prepare(&c);
    double arrival = -1.0;
    const tdsp_status status = tdsp_earliest_arrival(c.solver, departure, &arrival);
    assert_true(status == TDSP_OK ? arrival >= departure + 2.0 : arrival == INFINITY);
    property_drop(&c);
    return status;
}

static void each_reason_for_no_path_is_told(void **state)
{
    (void)state;
    const tdsp_disc beside = {{1.0, 1.0}, 0.5, 0.2}, behind = {{-1.5, 0.0}, 0.25, 0.125};
    /* A square of four discs around the source, closed from the start. */
    const tdsp_disc ring[4] = {
        {{-0.5, 0.0}, 0.4, 0.0}, {{-1.5, 0.0}, 0.4, 0.0}, {{-1.0, 0.5}, 0.4, 0.0}, {{-1.0, -0.5}, 0.4, 0.0}};
    assert_int_equal(status_of(&beside, 1, 0.49), TDSP_OK);
    assert_int_equal(status_of(&beside, 1, 0.51), TDSP_DESTINATION_COVERED);
    assert_int_equal(status_of(&behind, 1, 2.0), TDSP_OK);
    assert_int_equal(status_of(&behind, 1, 2.01), TDSP_SOURCE_COVERED);
    assert_int_equal(status_of(ring, 4, 0.0), TDSP_CUT_OFF);
    assert_int_equal(status_of(ring, 3, 0.0), TDSP_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_engine_and_the_slow_solver_agree),   cmocka_unit_test(they_agree_on_a_dozen_discs),
        cmocka_unit_test(every_path_is_accepted_by_the_verifier), cmocka_unit_test(paths_of_the_slow_solver_are_accepted_too),
        cmocka_unit_test(a_status_says_what_is_covered),          cmocka_unit_test(each_reason_for_no_path_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
