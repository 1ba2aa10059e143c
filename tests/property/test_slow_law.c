/* SPDX-License-Identifier: MIT */
/* The slow solver for any growth law, held to what is known without it. */
#include "support/cmocka_all.h"

#include "slow/law.h"
#include "slow/law_grid.h"
#include "slow/slow.h"
#include "support/chance.h"
#include "support/growth_property.h"
#include "support/property.h"

#define NEAR 1e-9 /* relative to the travel time and the journey; a departure this close to a jump may be on either side of it */

static double any_departure(property_case *c, int number)
{
    double last = tdsp_scene_source_free_until(c->scene, NULL);
    if (!(last < 3.0 * c->unit)) last = 3.0 * c->unit;
    return number == 0 ? 0.0 : last * chance_between(&c->chance, 0.0, number == 1 ? 1.1 : 0.5);
}

static double by_law(const property_case *c, const tdsp_growing_disc *discs, double until, double departure)
{
    slow_law_disc laws[RANDOM_MOST_DISCS];
    for (size_t i = 0; i < c->count; i++) laws[i] = slow_law_of(&discs[i]);
    const double arrival = slow_law_arrival(&c->journey, laws, c->count, until, departure);
    property_holds(c, !isnan(arrival));
    return arrival;
}

static double cut(double arrival, double until)
{
    return arrival <= until ? arrival : INFINITY;
}

/* One rate, said in each way there is. */
static void agrees_with_rates(property_case *c)
{
    tdsp_growing_disc discs[RANDOM_MOST_DISCS] = {{{0.0, 0.0}, 0.0, {0}}};
    for (size_t i = 0; i < c->count; i++) {
        discs[i].center = c->discs[i].center;
        discs[i].radius = c->discs[i].radius;
        discs[i].growth.rate = c->discs[i].growth;
    }
    for (int i = 0; i < 3; i++) {
        const double departure = any_departure(c, i), until = departure + 12.0 * c->unit;
        const double arrival = by_law(c, discs, until, departure);
        const double expected = cut(slow_arrival(&c->journey, c->discs, c->count, departure), until);
        const double slack = NEAR * (c->unit + (expected < INFINITY ? expected - departure : 0.0));
        if (arrival == expected || fabs(arrival - expected) <= slack) continue;
        const double step = NEAR * (c->unit + departure);
        property_relates(c, arrival, >=,
                         cut(slow_arrival(&c->journey, c->discs, c->count, fmax(0.0, departure - step)), until) - slack);
        property_relates(c, arrival, <=, cut(slow_arrival(&c->journey, c->discs, c->count, departure + step), until) + slack);
    }
}

static void discs_of_one_rate_have_the_other_slow_solvers_answers(void **state)
{
    (void)state;
    property_each(10, 6, agrees_with_rates);
}

#define MOST_PLACES 20000

static double grown_departure(grown_case *c, int number)
{
    return number == 0 ? 0.0 : c->scene.unit * chance_between(&c->chance, 0.0, 1.2);
}

static double grown_until(const grown_case *c, double departure)
{
    return fmin(c->valid, departure + 6.0 * c->scene.unit);
}

static tdsp_point between(tdsp_point a, tdsp_point b, double share)
{
    return (tdsp_point){a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

static double time_between(const grown_case *c, tdsp_point a, tdsp_point b)
{
    return hypot(b.x - a.x, b.y - a.y) / c->scene.journey.speed;
}

/* Straight at top speed, as free as so many samples show. */
static int straight_is_clear(const grown_case *c, tdsp_point a, tdsp_point b, double begin, int samples, double slack)
{
    const double duration = time_between(c, a, b);
    for (int i = 0; i <= samples; i++)
        if (!grown_clear(c, between(a, b, (double)i / samples), begin + duration * i / samples, slack)) return 0;
    return 1;
}

static void path_holds(grown_case *c)
{
    static slow_law_place places[MOST_PLACES];
    for (int i = 0; i < 2; i++) {
        size_t count;
        const double departure = grown_departure(c, i), length = c->scene.unit * c->scene.journey.speed, slack = 1e-11 * length;
        const double arrival = grown_slow_path(c, grown_until(c, departure), departure, places, MOST_PLACES, &count);
        if (!(arrival < INFINITY)) continue;
        grown_relates(c, places[count - 1].time, ==, arrival);
        grown_relates(c, time_between(c, places[0].at, c->scene.journey.source), <=, 0.0);
        grown_relates(c, time_between(c, places[count - 1].at, c->scene.journey.destination), <=, 1e-12 * c->scene.unit);
        for (size_t k = 0; k + 1 < count; k++) {
            const double duration = places[k + 1].time - places[k].time;
            grown_holds(c, grown_clear(c, places[k].at, places[k].time, slack));
            grown_relates(c, time_between(c, places[k].at, places[k + 1].at), <=, duration + 1e-11 * c->scene.unit);
            if (places[k].disc == SLOW_LAW_LINE)
                grown_holds(c, straight_is_clear(c, places[k].at, places[k + 1].at, places[k].time, 400, slack));
        }
    }
}

static void what_it_finds_is_a_motion_that_keeps_clear(void **state)
{
    (void)state;
    grown_each(18, 6, path_holds);
}

/* No straight way between two places of the path is free and quicker: the path bends only where it must. */
static void no_chord_is_quicker(grown_case *c)
{
    static slow_law_place places[MOST_PLACES];
    size_t count;
    const double departure = grown_departure(c, 1), slack = 1e-10 * c->scene.unit * c->scene.journey.speed;
    grown_slow_path(c, grown_until(c, departure), departure, places, MOST_PLACES, &count);
    const size_t step = 1 + count / 100;
    for (size_t i = 0; i < count; i += step)
        for (size_t j = i + step; j < count; j += step) {
            const tdsp_point a = places[i].at, b = places[j].at;
            if (places[i].time + time_between(c, a, b) >= places[j].time - 1e-8 * c->scene.unit) continue;
            int clear = 1;
            for (int samples = 30; samples <= 1000000 && clear; samples *= 30)
                clear = straight_is_clear(c, a, b, places[i].time, samples, slack);
            grown_holds(c, !clear);
        }
}

static void no_short_cut_is_free(void **state)
{
    (void)state;
    grown_each(12, 6, no_chord_is_quicker);
}

/* The grid's way is a way: it may not be quicker. How much slower it is, says how much of the world the comparison sees. */
static double grid_sum;
static int grid_count;

static void not_later_than_the_grid(grown_case *c)
{
    slow_law_disc laws[GROWTH_MOST_DISCS];
    const double departure = grown_departure(c, (int)(c->seed % 2)), until = grown_until(c, departure);
    for (size_t i = 0; i < c->scene.count; i++) laws[i] = slow_law_of(&c->scene.discs[i]);
    const double arrival = grown_slow(c, until, departure);
    const double grid = slow_law_grid(&c->scene.journey, laws, c->scene.count, until, departure, 40);
    grown_holds(c, !isnan(grid));
    grown_relates(c, arrival, <=, grid + 1e-12 * c->scene.unit);
    if (!(grid < INFINITY)) return;
    grid_sum += (grid - departure) / (arrival - departure);
    grid_count++;
}

static void straight_steps_on_a_grid_are_not_quicker(void **state)
{
    (void)state;
    grown_each(5, 6, not_later_than_the_grid);
    print_message("over the grid, %.2f %% slower on average\n", 100.0 * (grid_sum / grid_count - 1.0));
    assert_true(grid_count > 0 && grid_sum < 1.03 * grid_count);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(discs_of_one_rate_have_the_other_slow_solvers_answers),
        cmocka_unit_test(what_it_finds_is_a_motion_that_keeps_clear),
        cmocka_unit_test(no_short_cut_is_free),
        cmocka_unit_test(straight_steps_on_a_grid_are_not_quicker),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
