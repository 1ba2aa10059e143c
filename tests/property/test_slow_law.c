/* The slow solver for any growth law, held to what is known without it. */
#include "support/cmocka_all.h"

#include "slow/law.h"
#include "slow/slow.h"
#include "support/chance.h"
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
    property_each(12, 6, agrees_with_rates);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(discs_of_one_rate_have_the_other_slow_solvers_answers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
