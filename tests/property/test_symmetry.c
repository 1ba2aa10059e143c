/* SPDX-License-Identifier: MIT */
/* What A(t) may not depend on, and what must never fall. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/chance.h"
#include "support/property.h"

#define NEAR 1e-10 /* relative to the journey and the travel time; at a jump the departure may be moved by this much */

static double departure_of(property_case *c)
{
    double last = tdsp_scene_source_free_until(c->scene, NULL);
    if (!(last < 2.0 * c->unit)) last = 2.0 * c->unit;
    return last * chance_between(&c->chance, 0.0, 0.7);
}

static double slack_of(const property_case *c, double departure, double arrival)
{
    return NEAR * (c->unit + (arrival < INFINITY ? arrival - departure : 0.0));
}

static void travel_time_never_falls(property_case *c)
{
    const double first = tdsp_scene_source_free_until(c->scene, NULL);
    const double step = (first < 3.0 * c->unit ? first : 3.0 * c->unit) / 19.0;
    double before = 0.0;
    for (int i = 0; i < 22; i++) {
        const double departure = step * i, arrival = property_arrival(c, departure);
        const double travel = arrival - departure;
        property_relates(c, travel, >=, before - (before < INFINITY ? slack_of(c, 0.0, before) : 0.0));
        before = travel;
    }
}

static void the_travel_time_never_falls(void **state)
{
    (void)state;
    property_each(30, 20, travel_time_never_falls);
}

/* A(t) of `other`, a copy of `c` in other coordinates, is `scale` times that of `c`. */
static void assert_same_answers(property_case *c, property_case *other, double scale)
{
    property_prepare(other);
    for (int i = 0; i < 4; i++) {
        const double departure = i ? departure_of(c) : 0.0;
        const double expected = property_arrival(c, departure), arrival = property_arrival(other, scale * departure) / scale;
        const double slack = slack_of(c, departure, expected), step = NEAR * (c->unit + departure);
        if (arrival == expected || fabs(arrival - expected) <= slack) continue;
        property_relates(c, arrival, <=, property_arrival(c, departure + step) + slack);
        if (departure >= step) property_relates(c, arrival, >=, property_arrival(c, departure - step) - slack);
    }
    property_drop(other);
}

/* Copies in which the ends or boundaries that touch would be told apart by rounding are left out. */
static int touches(const property_case *c)
{
    return strcmp(c->name, "on_source") == 0 || strcmp(c->name, "on_destination") == 0 || strcmp(c->name, "touching") == 0;
}

typedef tdsp_point (*place_change)(tdsp_point p);

static void change_places(property_case *c, place_change change, double speed)
{
    c->journey.source = change(c->journey.source);
    c->journey.destination = change(c->journey.destination);
    c->journey.speed *= speed;
    for (size_t i = 0; i < c->count; i++) {
        c->discs[i].center = change(c->discs[i].center);
        c->discs[i].growth *= speed;
    }
}

static tdsp_point turned(tdsp_point p)
{
    return (tdsp_point){0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y};
}

static tdsp_point moved(tdsp_point p)
{
    return (tdsp_point){p.x + 1.7, p.y - 0.3};
}

static tdsp_point mirrored(tdsp_point p)
{
    return (tdsp_point){p.x, -p.y};
}

static tdsp_point unchanged(tdsp_point p)
{
    return p;
}

static void other_coordinates_change_nothing(property_case *c)
{
    static const place_change changes[] = {turned, moved, mirrored};
    for (size_t i = 0; i < 3; i++) {
        property_case other = *c;
        change_places(&other, changes[i], 1.0);
        if (changes[i] == mirrored || !touches(c)) assert_same_answers(c, &other, 1.0);
    }
}

static void turning_moving_and_mirroring_a_scene_change_no_answer(void **state)
{
    (void)state;
    property_each(20, 12, other_coordinates_change_nothing);
}

static void other_units_scale(property_case *c)
{
    property_case longer = *c, faster = *c;
    const double length = 3.7e4, speed = 0x1p-7;
    change_places(&faster, unchanged, speed);
    assert_same_answers(c, &faster, 1.0 / speed);
    if (touches(c)) return;
    longer.journey.source = (tdsp_point){length * c->journey.source.x, length * c->journey.source.y};
    longer.journey.destination = (tdsp_point){length * c->journey.destination.x, length * c->journey.destination.y};
    longer.journey.radius *= length;
    for (size_t i = 0; i < c->count; i++) {
        longer.discs[i].center = (tdsp_point){length * c->discs[i].center.x, length * c->discs[i].center.y};
        longer.discs[i].radius *= length;
    }
    assert_same_answers(c, &longer, length);
}

static void other_units_of_length_and_time_scale_the_answer(void **state)
{
    (void)state;
    property_each(20, 12, other_units_scale);
}

static void other_names_change_nothing(property_case *c)
{
    property_case other = *c;
    for (size_t i = c->count; i > 1; i--) {
        const size_t with = (size_t)chance_below(&c->chance, i);
        const tdsp_disc kept = other.discs[i - 1];
        other.discs[i - 1] = other.discs[with];
        other.discs[with] = kept;
    }
    assert_same_answers(c, &other, 1.0);
}

static void the_order_of_the_discs_changes_no_answer(void **state)
{
    (void)state;
    property_each(20, 20, other_names_change_nothing);
}

/* Also: the same disc twice, and one wholly inside another for good, are as if they were not there. */
static void more_discs_do_not_help(property_case *c)
{
    property_case less = *c, more = *c;
    less.count = c->count - 1;
    more.discs[more.count++] = c->discs[0];
    more.discs[more.count] = c->discs[0];
    more.discs[more.count].radius *= 0.5;
    more.discs[more.count++].growth *= 0.5;
    property_prepare(&less);
    property_prepare(&more);
    for (int i = 0; i < 4; i++) {
        const double departure = i ? departure_of(c) : 0.0, arrival = property_arrival(c, departure);
        const double without = property_arrival(&less, departure);
        property_relates(c, arrival, >=, without - (without < INFINITY ? slack_of(c, departure, without) : 0.0));
        const double with = property_arrival(&more, departure);
        if (with != arrival) property_relates(c, fabs(with - arrival), <=, slack_of(c, departure, arrival));
    }
    property_drop(&less);
    property_drop(&more);
}

static void another_disc_never_helps_and_a_hidden_one_never_harms(void **state)
{
    (void)state;
    property_each(20, 12, more_discs_do_not_help);
}

/* The same question gives the same bits, whatever was asked before. */
static void repeats(property_case *c)
{
    const double departure = departure_of(c), first = property_arrival(c, departure);
    property_arrival(c, 0.5 * departure);
    double latest;
    (void)tdsp_latest_departure(c->solver, 2.0 * c->unit + departure, &latest, NULL);
    property_relates(c, property_arrival(c, departure), ==, first);
}

static void an_answer_does_not_depend_on_earlier_questions(void **state)
{
    (void)state;
    property_each(10, 20, repeats);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_travel_time_never_falls),
        cmocka_unit_test(turning_moving_and_mirroring_a_scene_change_no_answer),
        cmocka_unit_test(other_units_of_length_and_time_scale_the_answer),
        cmocka_unit_test(the_order_of_the_discs_changes_no_answer),
        cmocka_unit_test(another_disc_never_helps_and_a_hidden_one_never_harms),
        cmocka_unit_test(an_answer_does_not_depend_on_earlier_questions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
