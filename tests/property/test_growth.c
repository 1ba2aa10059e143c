/* SPDX-License-Identifier: MIT */
/* The engine for discs of any growth against the slow solver, and every path
 * against the verifier. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "support/growth_solved.h"
#include "support/property.h"

/* Relative to the travel time and the journey; a departure this close to a jump
 * may be on either side of it. */
#define NEAR 1e-8

static double cut(double arrival, double until)
{
    return arrival <= until ? arrival : INFINITY;
}

static void agrees_at(grown_case *c, const grown_solved *solved, double departure)
{
    const double unit = c->scene.unit, until = fmin(solved->valid, departure + 8.0 * unit), step = NEAR * (unit + departure);
    const double arrival = cut(grown_arrival(solved, departure), until), expected = grown_slow(c, until, departure);
    const double slack = NEAR * (unit + (expected < INFINITY ? expected - departure : 0.0));
    if (arrival == expected || fabs(arrival - expected) <= slack) return;
    /* Unless the departure is at a jump, or the arrival at the end of what is
   * asked. */
    grown_relates(c, arrival, >=, grown_slow(c, until + step, fmax(0.0, departure - step)) - slack);
    grown_relates(c, arrival, <=, grown_slow(c, until - step, departure + step) + slack);
}

static void agrees(grown_case *c)
{
    grown_solved solved = grown_solve(c);
    for (int i = 0; i < 3; i++) agrees_at(c, &solved, grown_departure(c, i));
    grown_drop(&solved);
}

static void the_engine_and_the_slow_solver_agree(void **state)
{
    (void)state;
    grown_each(36, 6, agrees);
}

static void path_is_good(grown_case *c)
{
    grown_solved solved = grown_solve(c);
    for (int i = 0; i < 4; i++) {
        const double departure = grown_departure(c, i), arrival = grown_arrival(&solved, departure);
        if (arrival < INFINITY) grown_path_is_good(&solved, departure, arrival);
    }
    grown_drop(&solved);
}

static void every_path_is_accepted_by_the_verifier(void **state)
{
    (void)state;
    grown_each(36, 16, path_is_good);
}

/* ----------------------------------------------------------------------------------------------------------
 * one rate */

#define EXACT 1e-12

/* A(t) by another solver of the same scene; at a jump the departure may be
 * moved by rounding. */
static double arrival_of(property_case *c, tdsp_solver *solver, double departure)
{
    double arrival = -1.0;
    property_holds(c, tdsp_status_is_answer(tdsp_earliest_arrival(solver, departure, &arrival)));
    return arrival;
}

static void same_answers(property_case *c, tdsp_solver *solver)
{
    for (int i = 0; i < 3; i++) {
        const double departure = i ? 1.5 * c->unit * chance_unit(&c->chance) : 0.0;
        const double expected = property_arrival(c, departure), arrival = arrival_of(c, solver, departure);
        const double slack = EXACT * (c->unit + (expected < INFINITY ? expected - departure : 0.0));
        if (arrival == expected || fabs(arrival - expected) <= slack) continue;
        const double step = EXACT * (c->unit + departure);
        property_relates(c, arrival, >=, property_arrival(c, fmax(0.0, departure - step)) - slack);
        property_relates(c, arrival, <=, property_arrival(c, departure + step) + slack);
    }
}

/* The same rates as polynomials of higher degree, and the same scene by the
 * general method. */
static void one_rate_is_a_law_too(property_case *c)
{
    double values[RANDOM_MOST_DISCS][4] = {{0.0}};
    tdsp_growing_disc discs[RANDOM_MOST_DISCS];
    tdsp_scene *scene;
    tdsp_solver *padded, *general;
    for (size_t i = 0; i < c->count; i++) {
        values[i][0] = c->discs[i].growth;
        discs[i] = (tdsp_growing_disc){.center = c->discs[i].center, .radius = c->discs[i].radius};
        discs[i].growth = (tdsp_growth){.kind = TDSP_GROWTH_POLYNOMIAL, .count = 1 + i % 4, .values = values[i]};
    }
    property_holds(c, tdsp_scene_create_growing(&c->journey, discs, c->count, NULL, &scene) == TDSP_OK);
    property_holds(c, tdsp_solver_create(scene, &padded) == TDSP_OK);
    property_holds(c, tdsp_solver_create_for(scene, TDSP_METHOD_GENERAL, &general) == TDSP_OK);
    property_relates(c, arrival_of(c, padded, c->unit), ==, property_arrival(c, c->unit));
    same_answers(c, general);
    tdsp_solver_free(padded);
    tdsp_solver_free(general);
    tdsp_scene_free(scene);
}

static void the_general_method_has_the_answers_of_the_one_for_constant_rates(void **state)
{
    (void)state;
    property_each(10, 12, one_rate_is_a_law_too);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_engine_and_the_slow_solver_agree),
        cmocka_unit_test(every_path_is_accepted_by_the_verifier),
        cmocka_unit_test(the_general_method_has_the_answers_of_the_one_for_constant_rates),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
