/* SPDX-License-Identifier: MIT */
/* What A(t) may not depend on whatever the growth law, what must never fall,
 * and laws between laws. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "support/growth_solved.h"

#define NEAR                                                                                                                     \
    1e-9 /* relative to the journey and the travel time; at a jump the departure \
          may be moved by this much */

static double slack_of(const grown_solved *solved, double departure, double arrival)
{
    return NEAR * (solved->unit + (arrival < INFINITY ? arrival - departure : 0.0));
}

static void travel_time_never_falls(grown_case *c)
{
    grown_solved solved = grown_solve(c);
    double before = 0.0;
    for (int i = 0; i < 20; i++) {
        const double departure = 2.0 * c->scene.unit * i / 19.0, travel = grown_arrival(&solved, departure) - departure;
        grown_relates(c, travel, >=, before - (before < INFINITY ? slack_of(&solved, 0.0, before) : 0.0));
        before = travel;
    }
    grown_drop(&solved);
}

static void the_travel_time_never_falls(void **state)
{
    (void)state;
    grown_each(12, 10, travel_time_never_falls);
}

/* A(t) in `other` is `scale` times that in `c`. */
static void assert_same_answers(grown_case *c, const grown_scene *other, double scale)
{
    grown_solved here = grown_solve(c), there = grown_solve_scene(c, other);
    for (int i = 0; i < 3; i++) {
        const double departure = grown_departure(c, 2 * i);
        const double expected = grown_arrival(&here, departure), arrival = grown_arrival(&there, scale * departure) / scale;
        const double slack = slack_of(&here, departure, expected), step = NEAR * (here.unit + departure);
        if (arrival == expected || fabs(arrival - expected) <= slack) continue;
        /* An answer at the very time from which a radius would shrink is on either
     * side of it. */
        if (fabs(fmin(arrival, expected) - here.valid) <= 1e-6 * here.valid) continue;
        grown_relates(c, arrival, <=, grown_arrival(&here, departure + step) + slack);
        if (departure >= step) grown_relates(c, arrival, >=, grown_arrival(&here, departure - step) - slack);
    }
    grown_drop(&here);
    grown_drop(&there);
}

static void other_coordinates_change_nothing(grown_case *c)
{
    static grown_scene other;
    const grown_change turned = {{0.6, 0.8}, {0.0, 0.0}, 1.0, 1.0, 0}, moved = {{1.0, 0.0}, {3.25, -17.5}, 1.0, 1.0, 0},
                       mirrored = {{1.0, 0.0}, {0.0, 0.0}, 1.0, 1.0, 1}, longer = {{1.0, 0.0}, {0.0, 0.0}, 3.7e4, 1.0, 0},
                       slower = {{1.0, 0.0}, {0.0, 0.0}, 1.0, 128.0, 0};
    const grown_change *changes[] = {&turned, &moved, &mirrored, &longer, &slower};
    for (size_t i = 0; i < 5; i++) {
        grown_copy(&c->scene, &other);
        grown_place(&other, changes[i]);
        assert_same_answers(c, &other, changes[i]->time);
    }
}

static void turning_moving_mirroring_and_other_units_change_no_answer(void **state)
{
    (void)state;
    grown_each(6, 8, other_coordinates_change_nothing);
}

static void other_names_change_nothing(grown_case *c)
{
    static grown_scene other;
    grown_copy(&c->scene, &other);
    for (size_t i = other.count; i > 1; i--) {
        const size_t with = (size_t)chance_below(&c->chance, i);
        const tdsp_growing_disc kept = other.discs[i - 1];
        other.discs[i - 1] = other.discs[with];
        other.discs[with] = kept;
    }
    assert_same_answers(c, &other, 1.0);
}

static void the_order_of_the_discs_changes_no_answer(void **state)
{
    (void)state;
    grown_each(8, 10, other_names_change_nothing);
}

static void more_discs_do_not_help(grown_case *c)
{
    static grown_scene less;
    grown_copy(&c->scene, &less);
    less.count--;
    grown_solved all = grown_solve(c), fewer = grown_solve_scene(c, &less);
    for (int i = 0; i < 4; i++) {
        const double departure = grown_departure(c, i);
        const double arrival = grown_arrival(&all, departure), without = grown_arrival(&fewer, departure);
        if (without == INFINITY) continue;
        grown_relates(c, arrival, >=, without - slack_of(&all, departure, without));
    }
    grown_drop(&all);
    grown_drop(&fewer);
}

static void another_disc_never_helps(void **state)
{
    (void)state;
    grown_each(15, 10, more_discs_do_not_help);
}

/* The latest departure for A(t) is no earlier than t, arrives in time, and a
 * moment later nothing does. */
static void latest_is_latest(grown_case *c)
{
    grown_solved solved = grown_solve(c);
    for (int i = 0; i < 3; i++) {
        const double departure = grown_departure(c, 2 * i), arrival = grown_arrival(&solved, departure);
        if (!(arrival < INFINITY)) continue;
        const double slack = slack_of(&solved, departure, arrival), a = arrival * (1.0 + 1e-15);
        double latest = -1.0, arrives = -1.0;
        const tdsp_status status = tdsp_latest_departure(solved.solver, a, &latest, &arrives);
        if (status != TDSP_OK) grown_fail(c, tdsp_status_name(status), departure, arrival, __FILE__, __LINE__);
        grown_relates(c, latest, >=, departure - slack);
        grown_relates(c, arrives, <=, a + slack);
        grown_path_is_good(&solved, latest, arrives);
        grown_relates(c, fabs(grown_arrival(&solved, latest) - arrives), <=, slack);
        grown_relates(c, grown_arrival(&solved, latest + 10.0 * slack), >, a - slack);
    }
    grown_drop(&solved);
}

static void the_latest_departure_is_the_latest(void **state)
{
    (void)state;
    grown_each(10, 8, latest_is_latest);
}

/* -------------------------------------------------------------------------------------------------
 * laws between laws */

#define PIECES 64

/* A polynomial between two laws of constant rates, straight between its radii
 * at PIECES + 1 times and moved down and up. */
typedef struct bracket {
    tdsp_growing_disc below[GROWTH_MOST_DISCS], above[GROWTH_MOST_DISCS];
    double times[PIECES], slower[GROWTH_MOST_DISCS][PIECES], faster[GROWTH_MOST_DISCS][PIECES];
} bracket;

static double sag_at(const tdsp_growing_disc *disc, double step, double time)
{
    const double piece = fmin(floor(time / step), PIECES - 1), share = time / step - piece;
    const double a = grown_radius(disc, piece * step), b = grown_radius(disc, (piece + 1.0) * step);
    return fabs(grown_radius(disc, time) - (a + share * (b - a)));
}

/* How far the law is from straight within the pieces, by samples and at its kinks, and a tenth more. */
static double sag_of(const tdsp_growing_disc *disc, double step)
{
    const tdsp_growth *g = &disc->growth;
    double sag = 0.0;
    for (int k = 0; k < 8 * PIECES; k++) sag = fmax(sag, sag_at(disc, step, k / 8.0 * step));
    for (size_t k = 0; g->times && k < g->count && g->times[k] < PIECES * step; k++)
        sag = fmax(sag, sag_at(disc, step, g->times[k]));
    return 1.1 * sag + 1e-12 * grown_radius(disc, PIECES * step);
}

static void make_bracket(const grown_scene *scene, double until, bracket *b)
{
    const double step = until / PIECES;
    for (int k = 0; k < PIECES; k++) b->times[k] = k * step;
    for (size_t i = 0; i < scene->count; i++) {
        const tdsp_growing_disc *disc = &scene->discs[i];
        const double sag = sag_of(disc, step);
        for (int k = 0; k < PIECES; k++) {
            const double from = grown_radius(disc, k * step), to = grown_radius(disc, (k + 1) * step);
            b->faster[i][k] = fmax(0.0, to - from) / step;
            b->slower[i][k] = fmax(0.0, fmax(0.0, to - 4.0 * sag) - fmax(0.0, from - 4.0 * sag)) / step;
        }
        const tdsp_growth steps = {.kind = TDSP_GROWTH_RATES, .count = PIECES, .values = b->faster[i], .times = b->times};
        b->below[i] = b->above[i] = (tdsp_growing_disc){disc->center, disc->radius + sag, steps};
        b->below[i].radius = fmax(0.0, disc->radius - 4.0 * sag);
        b->below[i].growth.values = b->slower[i];
    }
}

static grown_solved solve_with(grown_case *c, const tdsp_growing_disc *discs)
{
    grown_scene other = c->scene;
    for (size_t i = 0; i < other.count; i++) other.discs[i] = discs[i];
    return grown_solve_scene(c, &other);
}

static double bracket_sum;
static int bracket_count;

static void lies_between(grown_case *c)
{
    static bracket b;
    const double until = fmin(c->valid, 5.0 * c->scene.unit);
    make_bracket(&c->scene, until, &b);
    grown_solved exact = grown_solve(c), below = solve_with(c, b.below), above = solve_with(c, b.above);
    for (int i = 0; i < 3; i++) {
        const double departure = grown_departure(c, 2 * i), arrival = grown_arrival(&exact, departure);
        const double low = grown_arrival(&below, departure), high = grown_arrival(&above, departure);
        const double slack = slack_of(&exact, departure, arrival);
        if (arrival <= until) grown_relates(c, low, <=, arrival + slack);
        if (high > until) continue;
        grown_relates(c, arrival, <=, high + slack);
        bracket_sum += (high - low) / c->scene.unit;
        bracket_count++;
    }
    grown_drop(&exact);
    grown_drop(&below);
    grown_drop(&above);
}

static void a_law_between_two_others_has_an_answer_between_theirs(void **state)
{
    (void)state;
    grown_each(8, 5, lies_between);
    print_message("%d answers lie between others, %.2g of the journey apart on average\n", bracket_count,
                  bracket_sum / bracket_count);
    assert_true(bracket_count > 0 && bracket_sum < 0.02 * bracket_count);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_travel_time_never_falls),
        cmocka_unit_test(turning_moving_mirroring_and_other_units_change_no_answer),
        cmocka_unit_test(the_order_of_the_discs_changes_no_answer),
        cmocka_unit_test(another_disc_never_helps),
        cmocka_unit_test(the_latest_departure_is_the_latest),
        cmocka_unit_test(a_law_between_two_others_has_an_answer_between_theirs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
