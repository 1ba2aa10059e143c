/* SPDX-License-Identifier: MIT */
/*
 * Where a gap closes A jumps, and rounding decides on which side of the jump a departure is that is as near to it as that. It must be one of the two sides: never a third
 * arrival, and never none where both sides have one.
 */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "support/property.h"

#define PIECES 24    /* of the departures looked at, between which jumps are looked for */
#define PIECE 0.15   /* ... each so long, as a share of the journey's time */
#define AROUND 1e-8  /* the sides of a jump are seen from so far off, relative to the journey and the departure */
#define STEP 6.25e-13
#define STEPS 40     /* near the jump; as many again are four times as far apart on either side */
#define SAME 1e-6    /* times that differ by less are the same, relative to the journey */

static double travel_time(property_case *c, double departure)
{
    return property_arrival(c, departure) - departure;
}

/* Halve an interval over which A rises, into the half in which it rises more; returns by how much in the end. */
static double halve(property_case *c, double *from, double to)
{
    double before = travel_time(c, *from), after = travel_time(c, to);
    for (int step = 0; step < 100; step++) {
        const double middle = 0.5 * (*from + to);
        if (!(middle > *from && middle < to)) break;
        const double between = travel_time(c, middle);
        if (between < INFINITY && (isinf(after) || after - between >= between - before)) {
            *from = middle;
            before = between;
        } else {
            to = middle;
            after = between;
        }
    }
    return after - before;
}

static int is_same(const property_case *c, double a, double b)
{
    return (isinf(a) && isinf(b)) || fabs(a - b) <= SAME * c->unit;
}

/* Departures from `jump` on either side belong to one of them. */
static void only_two_sides(property_case *c, double jump)
{
    const double scale = c->unit + jump, before = travel_time(c, jump - AROUND * scale), after = travel_time(c, jump + AROUND * scale);
    for (int i = -2 * STEPS; i <= 2 * STEPS; i++) {
        const double departure = jump + i * STEP * scale * (abs(i) > STEPS ? 4.0 : 1.0), seen = travel_time(c, departure);
        if (!is_same(c, seen, before) && !is_same(c, seen, after)) property_fail(c, "neither side", departure, seen, __FILE__, __LINE__);
    }
}

/* A boundary that comes over the source stops legs that leave along it, as a touch or not: that is no gap, and arrivals rise steeply there. */
static int is_gap(property_case *c, double jump)
{
    const double scale = c->unit + jump;
    double arrival;
    return jump > AROUND * scale && tdsp_earliest_arrival(c->solver, jump + AROUND * scale, &arrival) != TDSP_SOURCE_COVERED;
}

static unsigned jumps_seen;

static void jumps_have_two_sides(property_case *c)
{
    double before = travel_time(c, 0.0);
    for (int i = 1; i <= PIECES && before < INFINITY; i++) {
        const double to = i * PIECE * c->unit, after = travel_time(c, to);
        double from = to - PIECE * c->unit;
        if (!(after - before < 0.1 * c->unit) && halve(c, &from, to) > SAME * c->unit && is_gap(c, from)) {
            jumps_seen++;
            only_two_sides(c, from);
        }
        before = after;
    }
}

static void a_departure_at_a_jump_has_the_arrival_of_one_of_its_sides(void **state)
{
    (void)state;
    property_each(30, 8, jumps_have_two_sides);
    print_message("%u jumps\n", jumps_seen);
    assert_true(jumps_seen > 0);
}

static void by_the_general_method(property_case *c)
{
    tdsp_solver_free(c->solver);
    assert_int_equal(tdsp_solver_create_for(c->scene, TDSP_METHOD_GENERAL, &c->solver), TDSP_OK);
}

/* Riders that touched the second disc of a gap were let past it, could not change over to it, and stopped those who came from the other side. */
static void a_rider_who_is_let_past_at_a_touch_can_change_over(void **state)
{
    (void)state;
    static const struct {
        random_mix mix;
        uint64_t seed;
        size_t count;
        double jump;
        int is_general;
    } seen[] = {
        {RANDOM_ON_DESTINATION, 12, 3, 4.8849445487064678, 0},
        {RANDOM_ON_DESTINATION, 63, 4, 2.2885615413991358, 0},
        {RANDOM_FORTRESS, 24, 5, 21.004547045345333, 0},
        {RANDOM_MIXED_RATES, 5, 5, 8.4531415034472417, 0},
        {RANDOM_PRISON, 105, 6, 1.0873420118071213, 0},
        {RANDOM_MIXED_RATES, 4, 5, 5.4961035369809821, 1},
        {RANDOM_COLLINEAR, 1033, 4, 4.5840505892340255, 1},
        {RANDOM_ON_DESTINATION, 17, 5, 4.672247712143097, 1},
    };
    for (size_t i = 0; i < sizeof seen / sizeof *seen; i++) {
        property_case c = {.name = random_mix_name(seen[i].mix), .seed = seen[i].seed, .count = seen[i].count};
        random_scene(c.seed, seen[i].mix, c.count, &c.journey, c.discs);
        property_prepare(&c);
        if (seen[i].is_general) by_the_general_method(&c);
        only_two_sides(&c, seen[i].jump);
        property_drop(&c);
    }
}

static void general_jumps_have_two_sides(property_case *c)
{
    by_the_general_method(c);
    jumps_have_two_sides(c);
}

static void the_general_method_too_has_one_of_the_two_sides(void **state)
{
    (void)state;
    jumps_seen = 0;
    property_each(10, 6, general_jumps_have_two_sides);
    print_message("%u jumps\n", jumps_seen);
    assert_true(jumps_seen > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rider_who_is_let_past_at_a_touch_can_change_over),
        cmocka_unit_test(a_departure_at_a_jump_has_the_arrival_of_one_of_its_sides),
        cmocka_unit_test(the_general_method_too_has_one_of_the_two_sides),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
