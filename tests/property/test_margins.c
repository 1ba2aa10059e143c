/* SPDX-License-Identifier: MIT */
/* Margins over random scenes: against raising the rates by hand, against the verifier, and against the slow solver. */
#include "support/cmocka_all.h"

#include <string.h>

#include "slow/slow.h"
#include "support/chance.h"
#include "support/property.h"
#include "tdsp/margin.h"
#include "tdsp/verify.h"

enum { LEGS = 1024 };

/* Margins and arrivals are compared this closely: errors of A and of the search, and touches that two ways of looking see differently. */
#define NEAR 1e-8

/* A of the scene raised by an amount. */
static double raised_arrival(property_case *c, tdsp_raise how, double amount, double departure)
{
    tdsp_scene *scene;
    tdsp_solver *solver;
    double arrival = -1.0;
    property_holds(c, tdsp_scene_raise(c->scene, how, amount, &scene) == TDSP_OK);
    property_holds(c, tdsp_solver_create(scene, &solver) == TDSP_OK);
    property_holds(c, tdsp_status_is_answer(tdsp_earliest_arrival(solver, departure, &arrival)));
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return arrival;
}

/* An amount moved by a share of itself and of what it is counted in. */
static double amount_moved(const property_case *c, tdsp_raise how, double amount, double share)
{
    if (how == TDSP_RAISE_FACTOR) return fmax(amount * (1.0 + share) + share, 0.0);
    return amount + share * c->journey.speed;
}

static tdsp_margin margin_of(property_case *c, tdsp_raise how, double departure, double deadline)
{
    tdsp_margin m;
    property_holds(c, tdsp_departure_margin(c->scene, how, departure, deadline, &m) == TDSP_OK);
    return m;
}

/* A departure and a deadline to ask about. */
static double some_departure(property_case *c)
{
    return chance_below(&c->chance, 3) ? chance_between(&c->chance, 0.0, 1.5) * c->unit : 0.0;
}

static double some_deadline(property_case *c, double departure)
{
    if (chance_below(&c->chance, 2)) return INFINITY;
    return departure + c->unit * chance_between(&c->chance, 0.95, 2.0);
}

static uint64_t asked, scenes;

/* The margin keeps the deadline, a little more does not, and it is over none exactly when the scene as it is keeps it. */
static void margin_is_largest(property_case *c)
{
    for (int how = 0; how < 2; how++) {
        const double t = some_departure(c), a = some_deadline(c, t);
        const tdsp_raise raise = (tdsp_raise)how;
        const tdsp_margin m = margin_of(c, raise, t, a);
        const double none = raise == TDSP_RAISE_FACTOR ? 1.0 : 0.0;
        if (m.most > NEAR) { /* that no growth at all is allowed takes long to find */
            asked++;
            scenes += m.scenes;
        }
        if (m.most == -INFINITY) {
            property_relates(c, raised_arrival(c, raise, raise == TDSP_RAISE_FACTOR ? 0.0 : -INFINITY, t), >, fmin(a, 1e300));
            property_holds(c, m.status != TDSP_OK);
            continue;
        }
        const double kept = raised_arrival(c, raise, m.most, t);
        property_relates(c, kept, <=, a);
        property_holds(c, kept < INFINITY && kept == m.arrival && m.status == TDSP_OK);
        if (m.most < INFINITY)
            property_relates(c, raised_arrival(c, raise, amount_moved(c, raise, m.most, NEAR), t), >, fmin(a, 1e300));
        const double arrival = property_arrival(c, t);
        if (arrival < INFINITY && arrival <= a) property_relates(c, m.most, >=, none);
        if (!(arrival <= a * (1.0 + 1e-10)) || isinf(arrival)) property_relates(c, m.most, <=, none);
    }
}

static void a_margin_keeps_the_deadline_and_a_little_more_does_not(void **state)
{
    (void)state;
    property_each(10, 8, margin_is_largest);
    print_message("%.1f scenes for a margin\n", (double)scenes / (double)asked);
    assert_true(scenes <= 20 * asked);
}

/* The larger the amount, the later the arrival. */
static void larger_is_later(property_case *c)
{
    const double t = some_departure(c);
    double before = 0.0;
    for (int i = 0; i <= 6; i++) {
        const double arrival = raised_arrival(c, TDSP_RAISE_FACTOR, 0.5 * i, t);
        property_relates(c, arrival, >=, before * (1.0 - 1e-10));
        before = arrival;
    }
}

static void arrivals_never_get_earlier_as_rates_rise(void **state)
{
    (void)state;
    property_each(8, 8, larger_is_later);
}

static void raised_discs(const property_case *c, double factor, tdsp_disc *discs)
{
    const double cap = TDSP_MARGIN_CAP * c->journey.speed;
    for (size_t i = 0; i < c->count; i++) {
        discs[i] = c->discs[i];
        if (discs[i].growth < cap) discs[i].growth = fmin(factor * discs[i].growth, cap);
    }
}

static double slow_raised(const property_case *c, double factor, double departure)
{
    tdsp_disc discs[RANDOM_MOST_DISCS];
    raised_discs(c, factor, discs);
    return slow_arrival(&c->journey, discs, c->count, departure);
}

/* Halving with another solver; where they differ, only as far as two views of a touch do. */
static void halving_agrees(property_case *c)
{
    const double t = some_departure(c), a = some_deadline(c, t);
    const tdsp_margin m = margin_of(c, TDSP_RAISE_FACTOR, t, a);
    double keeps = 0.0, fails = 64.0;
    if (!(slow_raised(c, 0.0, t) <= fmin(a, 1e300))) {
        property_relates(c, m.most, <=, 1e-6);
        return;
    }
    if (slow_raised(c, fails, t) <= fmin(a, 1e300)) {
        property_relates(c, m.most, >=, fails * (1.0 - 1e-6));
        return;
    }
    for (int step = 0; step < 34; step++) {
        const double middle = 0.5 * (keeps + fails), arrival = slow_raised(c, middle, t);
        if (isnan(arrival)) return; /* the slow solver gave up */
        *(arrival <= fmin(a, 1e300) ? &keeps : &fails) = middle;
    }
    if (fabs(m.most - keeps) <= 1e-7 * (1.0 + keeps)) return;
    property_relates(c, slow_raised(c, m.most * (1.0 - 1e-7), t), <=, a + NEAR * (c->unit + t));
    property_relates(c, slow_raised(c, m.most * (1.0 + 1e-7), t), >, fmin(a, 1e300) - NEAR * (c->unit + t));
}

static void the_margin_is_the_one_that_halving_with_another_solver_finds(void **state)
{
    (void)state;
    property_each(2, 3, halving_agrees);
}

/* Does the verifier accept the legs in the raised scene? */
static int accepts(property_case *c, tdsp_raise how, double amount, const tdsp_leg *legs, size_t count, tdsp_verdict *verdict)
{
    tdsp_scene *scene;
    property_holds(c, tdsp_scene_raise(c->scene, how, amount, &scene) == TDSP_OK);
    property_holds(c, tdsp_verify_path(scene, legs, count, legs[0].start_time, legs[count - 1].end_time, verdict) == TDSP_OK);
    tdsp_scene_free(scene);
    return !(verdict->problems & TDSP_PROBLEM_CLEARANCE);
}

/* At the margin the verifier accepts the path; where the disc named has grown by a few tolerances more, it does not. */
static void verifier_agrees(property_case *c, tdsp_raise how, const tdsp_leg *legs, size_t count)
{
    tdsp_margin m;
    tdsp_verdict verdict;
    property_holds(c, tdsp_path_margin(c->scene, how, legs, count, 0.0, &m) == TDSP_OK);
    if (m.most == -INFINITY) return;
    property_holds(c, accepts(c, how, m.most, legs, count, &verdict));
    if (m.most == INFINITY) return;
    property_holds(c, m.witness.limit == TDSP_LIMIT_TOUCH && m.witness.disc < c->count);
    const double reach = 3.0 * verdict.tolerance / m.witness.time, rate = c->discs[m.witness.disc].growth;
    const double more = how == TDSP_RAISE_FACTOR ? m.most + reach / rate : m.most + reach;
    const double cap = TDSP_MARGIN_CAP * c->journey.speed;
    if ((how == TDSP_RAISE_FACTOR ? more * rate : more + rate) < cap && reach < INFINITY)
        property_holds(c, !accepts(c, how, more, legs, count, &verdict));
}

static void path_margin_is_largest(property_case *c)
{
    static tdsp_leg legs[LEGS];
    const double t = some_departure(c);
    size_t count;
    tdsp_margin m;
    if (!(property_arrival(c, t) < INFINITY)) return;
    property_holds(c, tdsp_solver_path(c->solver, legs, LEGS, &count) == TDSP_OK);
    if (count == 0) return;
    for (int how = 0; how < 2; how++) {
        property_holds(c, tdsp_path_margin(c->scene, (tdsp_raise)how, legs, count, t, &m) == TDSP_OK);
        property_relates(c, m.most, >=, how == TDSP_RAISE_FACTOR ? 1.0 : 0.0);
        verifier_agrees(c, (tdsp_raise)how, legs, count);
    }
    /* The same path earlier has something to spare; later it would be too late, if it touches anything that grows. */
    const double shift = chance_between(&c->chance, 0.0, 1.0) * t;
    for (size_t i = 0; i < count; i++) {
        legs[i].start_time -= shift;
        legs[i].end_time -= shift;
    }
    for (int how = 0; how < 2; how++) verifier_agrees(c, (tdsp_raise)how, legs, count);
}

static void at_the_margin_of_a_path_the_verifier_accepts_it_and_a_little_above_it_does_not(void **state)
{
    (void)state;
    property_each(30, 12, path_margin_is_largest);
}

/* A plan that stays good is a way to arrive: planning anew cannot do worse. */
static void planning_anew_is_no_worse(property_case *c)
{
    static tdsp_leg legs[LEGS];
    const double t = some_departure(c), arrival = property_arrival(c, t);
    size_t count;
    tdsp_margin plan;
    if (!(arrival < INFINITY)) return;
    property_holds(c, tdsp_solver_path(c->solver, legs, LEGS, &count) == TDSP_OK);
    for (int how = 0; how < 2; how++) {
        const tdsp_margin anew = margin_of(c, (tdsp_raise)how, t, arrival + NEAR * (c->unit + t));
        property_holds(c, tdsp_path_margin(c->scene, (tdsp_raise)how, legs, count, t, &plan) == TDSP_OK);
        if (plan.most < INFINITY)
            property_relates(c, anew.most, >=, amount_moved(c, (tdsp_raise)how, plan.most, -NEAR));
        else
            property_relates(c, anew.most, ==, INFINITY);
    }
}

static void planning_anew_spares_no_less_than_the_plan_itself(void **state)
{
    (void)state;
    property_each(8, 8, planning_anew_is_no_worse);
}

static void added_is_the_factor_in_other_words(property_case *c)
{
    const double rate = c->discs[0].growth;
    for (size_t i = 1; i < c->count; i++)
        if (c->discs[i].growth != rate) return;
    if (!(rate > 0.0) || rate >= TDSP_MARGIN_CAP * c->journey.speed) return;
    const double t = some_departure(c), a = some_deadline(c, t);
    const double factor = margin_of(c, TDSP_RAISE_FACTOR, t, a).most, added = margin_of(c, TDSP_RAISE_ADDED, t, a).most;
    if (isinf(factor))
        property_relates(c, factor, ==, added);
    else
        property_relates(c, fabs((factor - 1.0) * rate - added), <=, 1e-9 * factor * rate);
}

static void with_one_rate_an_added_rate_and_a_factor_say_the_same(void **state)
{
    (void)state;
    property_each(10, 8, added_is_the_factor_in_other_words);
}

static tdsp_point turned(tdsp_point p, double scale)
{
    return (tdsp_point){scale * (0.8 * p.x + 0.6 * p.y) + 2.0 * scale, scale * (0.6 * p.x - 0.8 * p.y) - 3.0 * scale};
}

/* Where ends or boundaries touch, rounding tells copies apart. */
static int touches(const property_case *c)
{
    return strcmp(c->name, "on_source") == 0 || strcmp(c->name, "on_destination") == 0 || strcmp(c->name, "touching") == 0 ||
           strcmp(c->name, "collinear") == 0;
}

/* Mirrored, moved, in other units of length and time: factors stay, added rates scale. */
static void symmetric(property_case *c)
{
    const double t = some_departure(c), a = some_deadline(c, t), scale = 3.0, slower = 0.5;
    property_case other = *c;
    if (touches(c)) return;
    other.journey = (tdsp_journey){c->journey.speed * scale * slower, c->journey.radius * scale, turned(c->journey.source, scale),
                                   turned(c->journey.destination, scale)};
    for (size_t i = 0; i < c->count; i++)
        other.discs[i] =
            (tdsp_disc){turned(c->discs[i].center, scale), c->discs[i].radius * scale, c->discs[i].growth * scale * slower};
    property_prepare(&other);
    for (int how = 0; how < 2; how++) {
        const double rates = how == TDSP_RAISE_FACTOR ? 1.0 : scale * slower;
        const double here = margin_of(c, (tdsp_raise)how, t, a).most;
        const double there = margin_of(&other, (tdsp_raise)how, t / slower, a / slower).most / rates;
        if (here == there) continue;
        /* Where they differ, then by a touch that rounding decides: both are margins. */
        property_relates(c, raised_arrival(c, (tdsp_raise)how, amount_moved(c, (tdsp_raise)how, there, -NEAR), t), <=, a);
        property_relates(c, raised_arrival(c, (tdsp_raise)how, amount_moved(c, (tdsp_raise)how, there, NEAR), t), >,
                         fmin(a, 1e300));
    }
    property_drop(&other);
}

static void margins_do_not_depend_on_place_orientation_or_units(void **state)
{
    (void)state;
    property_each(5, 8, symmetric);
}

/* A finite deadline has a limit that holds: after the latest departure one is late. */
static void limits_hold(property_case *c)
{
    const double t = some_departure(c), a = some_deadline(c, t);
    tdsp_deadline_answer answer;
    const tdsp_status status = tdsp_solver_deadline(c->solver, a, &answer);
    property_holds(c, tdsp_status_is_answer(status));
    if (status != TDSP_OK || isinf(answer.departure)) return;
    property_path_is_good(c, answer.departure, answer.arrival);
    const tdsp_witness *w = &answer.witness;
    property_holds(c, w->limit != TDSP_LIMIT_NONE && w->limit != TDSP_LIMIT_TOUCH);
    if (w->limit == TDSP_LIMIT_DEADLINE) property_relates(c, fabs(answer.arrival - a), <=, 2e-10 * (c->unit + a));
    if (w->limit == TDSP_LIMIT_GAP) {
        property_holds(c, w->disc < w->other && w->other < c->count);
        for (int k = 0; k < 2; k++) { /* the place lies on both boundaries */
            const tdsp_disc *disc = &c->discs[k ? w->other : w->disc];
            const double away = hypot(w->place.x - disc->center.x, w->place.y - disc->center.y);
            const double radius = disc->radius + c->journey.radius + disc->growth * w->time;
            property_relates(c, fabs(away - radius), <=, 1e-6 * (c->unit * c->journey.speed + radius));
        }
    }
}

static void a_limit_is_where_it_says(void **state)
{
    (void)state;
    property_each(40, 12, limits_hold);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_margin_keeps_the_deadline_and_a_little_more_does_not),
        cmocka_unit_test(arrivals_never_get_earlier_as_rates_rise),
        cmocka_unit_test(the_margin_is_the_one_that_halving_with_another_solver_finds),
        cmocka_unit_test(at_the_margin_of_a_path_the_verifier_accepts_it_and_a_little_above_it_does_not),
        cmocka_unit_test(planning_anew_spares_no_less_than_the_plan_itself),
        cmocka_unit_test(with_one_rate_an_added_rate_and_a_factor_say_the_same),
        cmocka_unit_test(margins_do_not_depend_on_place_orientation_or_units),
        cmocka_unit_test(a_limit_is_where_it_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
