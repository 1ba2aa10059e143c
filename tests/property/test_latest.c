/* SPDX-License-Identifier: MIT */
/* The latest departure: A^-1(a) = sup { t : A(t) <= a }, also across jumps, and the last departure of all. */
#include "support/cmocka_all.h"

#include "slow/slow.h"
#include "support/chance.h"
#include "support/property.h"

#define NEAR 1e-9 /* of departures, relative to the journey and the departure */

static double later(const property_case *c, double departure, double share)
{
    return departure + share * (c->unit + departure);
}

static double earlier(const property_case *c, double departure, double share)
{
    return fmax(0.0, departure - share * (c->unit + departure));
}

/* An arrival to ask for: close to the first, far off, just below or above the last. */
static double some_arrival(property_case *c, int number, double first)
{
    static const double ahead[] = {0.0, 0.01, 0.2, 1.0, 5.0};
    return first + c->unit * ahead[number] * (number < 2 ? 1.0 : chance_between(&c->chance, 0.2, 1.0));
}

/* A(departure) <= a, and A is over a right after it. */
static void is_latest(property_case *c, double a, double departure, double arrives)
{
    const double slack = 1e-11 * (c->unit + a);
    property_relates(c, arrives, <=, a + slack);
    property_path_is_good(c, departure, arrives);
    const double again = property_arrival(c, departure);
    property_relates(c, fabs(again - arrives), <=, slack);
    property_relates(c, property_arrival(c, later(c, departure, NEAR)), >, a - slack);
}

static void latest_is_latest(property_case *c)
{
    const double first = property_arrival(c, 0.0);
    if (!(first < INFINITY)) return;
    for (int i = 0; i < 5; i++) {
        const double a = some_arrival(c, i, first);
        double departure = -1.0, arrives = -1.0;
        property_holds(c, tdsp_latest_departure(c->solver, a, &departure, &arrives) == TDSP_OK);
        is_latest(c, a, departure, arrives);
    }
    double untouched = 7.0;
    property_holds(c, tdsp_latest_departure(c->solver, first - 1e-6 * c->unit, &untouched, NULL) == TDSP_ARRIVAL_TOO_EARLY);
    property_holds(c, untouched == 7.0);
}

static void leaving_at_the_latest_departure_arrives_in_time_and_later_does_not(void **state)
{
    (void)state;
    property_each(40, 12, latest_is_latest);
}

static void inverse_of_arrival(property_case *c)
{
    for (int i = 0; i < 4; i++) {
        double departure = chance_between(&c->chance, 0.0, 1.5) * c->unit, latest = -1.0;
        const double arrival = property_arrival(c, departure);
        if (!(arrival < INFINITY)) continue;
        property_holds(c, tdsp_latest_departure(c->solver, arrival * (1.0 + 1e-15), &latest, NULL) == TDSP_OK);
        property_relates(c, latest, >=, earlier(c, departure, NEAR));
    }
}

static void the_latest_departure_for_an_arrival_is_no_earlier_than_the_departure_that_had_it(void **state)
{
    (void)state;
    property_each(30, 20, inverse_of_arrival);
}

/* Bisection on the slow solver; where they differ, only as far as two views of a touch do. */
static void halving_agrees(property_case *c)
{
    const double first = property_arrival(c, 0.0);
    if (!(first < INFINITY)) return;
    const double a = some_arrival(c, 1 + (int)chance_below(&c->chance, 4), first);
    double departure = -1.0;
    property_holds(c, tdsp_latest_departure(c->solver, a, &departure, NULL) == TDSP_OK);
    const double expected = slow_departure(&c->journey, c->discs, c->count, a);
    property_holds(c, !isnan(expected));
    if (fabs(expected - departure) <= 10.0 * NEAR * (c->unit + departure)) return;
    property_relates(c, slow_arrival(&c->journey, c->discs, c->count, earlier(c, departure, 10.0 * NEAR)), <=, a * (1.0 + 1e-11));
    property_relates(c, slow_arrival(&c->journey, c->discs, c->count, later(c, departure, 10.0 * NEAR)), >, a);
}

static void the_latest_departure_is_the_one_that_halving_finds(void **state)
{
    (void)state;
    property_each(8, 6, halving_agrees);
}

static void last_is_last(property_case *c)
{
    tdsp_last_departure last;
    const double first = property_arrival(c, 0.0);
    const tdsp_status status = tdsp_solver_last_departure(c->solver, &last);
    if (!(first < INFINITY)) {
        property_holds(c, status != TDSP_OK || last.departure < 0.0);
        return;
    }
    property_holds(c, status == TDSP_OK);
    double departure = -1.0, arrives = -1.0;
    property_holds(c, tdsp_latest_departure(c->solver, INFINITY, &departure, &arrives) == TDSP_OK);
    property_relates(c, departure, ==, last.departure);
    if (last.departure == INFINITY) {
        property_holds(c, last.reason == TDSP_OK);
        property_holds(c, property_arrival(c, 1e3 * c->unit) < INFINITY);
        return;
    }
    property_relates(c, fabs(property_arrival(c, last.departure) - last.arrival), <=, 1e-11 * (c->unit + last.arrival));
    double after = 0.0;
    property_holds(c, tdsp_earliest_arrival(c->solver, later(c, last.departure, NEAR), &after) == last.reason);
    property_holds(c, tdsp_latest_departure(c->solver, 2.0 * last.arrival + c->unit, &departure, &arrives) == TDSP_OK);
    property_relates(c, fabs(departure - last.departure), <=, 1e-11 * (c->unit + departure));
}

static void after_the_last_departure_there_is_none_for_the_reason_given(void **state)
{
    (void)state;
    property_each(40, 12, last_is_last);
}

static void two_discs_that_close_a_gap_give_the_known_numbers(void **state)
{
    (void)state;
    property_case c = {.name = "gap", .count = 2, .journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}}};
    c.discs[0] = (tdsp_disc){{0.0, 3.0}, 1.0, 0.1};
    c.discs[1] = (tdsp_disc){{0.0, -3.0}, 1.0, 0.1};
    property_prepare(&c);
    /* The corner of the two discs slows down to the robot's speed when their radius is 3 / sqrt(0.99). */
    const double radius = 3.0 / sqrt(0.99), last = (radius - 1.0) / 0.1 - 10.0 - 0.1 * radius;
    assert_near(property_arrival(&c, last - 1e-9), last + 20.0, 2e-9);
    assert_near(property_arrival(&c, last + 1e-9), 33.5675, 1e-4);
    const double inside[] = {last + 20.0 + 1e-6, 30.35, 33.0, 33.56};
    for (size_t i = 0; i < 4; i++) {
        double departure, arrives;
        assert_int_equal(tdsp_latest_departure(c.solver, inside[i], &departure, &arrives), TDSP_OK);
        assert_near(departure, last, 1e-9);
        assert_near(arrives, last + 20.0, 1e-9);
    }
    property_drop(&c);
}

/* Work that the bisection would not need fewer of: at most three forward searches on average, gap events and all. */
static uint64_t asked, forward;

static void count_searches(property_case *c)
{
    tdsp_solver_work before, after;
    double departure;
    const double first = property_arrival(c, 0.0);
    if (!(first < INFINITY)) return;
    property_holds(c, tdsp_solver_work_done(c->solver, &before) == TDSP_OK);
    for (int i = 1; i < 5; i++) {
        asked++;
        property_holds(c, tdsp_latest_departure(c->solver, some_arrival(c, i, first), &departure, NULL) == TDSP_OK);
    }
    property_holds(c, tdsp_solver_work_done(c->solver, &after) == TDSP_OK);
    forward += after.forward_searches - before.forward_searches;
}

static void a_latest_departure_takes_three_forward_searches_or_fewer_on_average(void **state)
{
    (void)state;
    property_each(10, 30, count_searches);
    print_message("%.2f forward searches for a latest departure\n", (double)forward / (double)asked);
    assert_true(forward <= 3 * asked);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(leaving_at_the_latest_departure_arrives_in_time_and_later_does_not),
        cmocka_unit_test(the_latest_departure_for_an_arrival_is_no_earlier_than_the_departure_that_had_it),
        cmocka_unit_test(the_latest_departure_is_the_one_that_halving_finds),
        cmocka_unit_test(after_the_last_departure_there_is_none_for_the_reason_given),
        cmocka_unit_test(two_discs_that_close_a_gap_give_the_known_numbers),
        cmocka_unit_test(a_latest_departure_takes_three_forward_searches_or_fewer_on_average),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
