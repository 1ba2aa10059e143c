/* SPDX-License-Identifier: MIT */
/*
 * Other ends among the discs of one prepared scene, on random scenes: against a scene that is made for those ends, whose frame is another one.
 */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "support/property.h"
#include "tdsp/build.h"
#include "tdsp/verify.h"

/* Relative to the travel time and the journeys. */
#define NEAR 1e-9

/* The same discs twice: prepared for their own journey and asked about others, and prepared for the other one. */
typedef struct pair {
    property_case *here;
    property_case there;
    tdsp_ends ends;
    double slack;
} pair;

static tdsp_point some_place(property_case *c)
{
    const tdsp_point s = c->journey.source, d = c->journey.destination;
    const double along = chance_between(&c->chance, -0.5, 1.5), across = chance_between(&c->chance, -1.0, 1.0);
    return (tdsp_point){s.x + along * (d.x - s.x) - across * (d.y - s.y), s.y + along * (d.y - s.y) + across * (d.x - s.x)};
}

static void pair_make(pair *p, property_case *c)
{
    p->here = c;
    p->ends = (tdsp_ends){some_place(c), some_place(c)};
    p->there = *c;
    p->there.journey.source = p->ends.source;
    p->there.journey.destination = p->ends.destination;
    property_prepare(&p->there);
    p->slack = NEAR * (c->unit + p->there.unit);
    property_holds(c, tdsp_solver_set_ends(c->solver, &p->ends) == TDSP_OK);
}

static void pair_drop(pair *p)
{
    property_drop(&p->there);
    property_holds(p->here, tdsp_solver_set_ends(p->here->solver, NULL) == TDSP_OK);
}

static double some_departure(pair *p, int number)
{
    double last = tdsp_scene_source_free_until(p->there.scene, NULL);
    if (number == 0 || last < 0.0) return 0.0;
    if (!(last < 3.0 * p->there.unit)) last = 3.0 * p->there.unit;
    return last * chance_between(&p->here->chance, 0.0, 1.1);
}

static void path_fits(pair *p, double departure, double arrival)
{
    static tdsp_leg legs[1024];
    tdsp_verdict verdict;
    size_t count;
    property_holds(p->here, tdsp_solver_path(p->here->solver, legs, 1024, &count) == TDSP_OK);
    property_holds(p->here, tdsp_verify_path_for(p->here->scene, &p->ends, legs, count, departure, arrival, &verdict) == TDSP_OK);
    if (verdict.problems) property_fail(p->here, "the verifier rejects the path", verdict.problems, departure, __FILE__, __LINE__);
}

static void arrivals_agree(property_case *c)
{
    pair p;
    pair_make(&p, c);
    for (int i = 0; i < 4; i++) {
        const double departure = some_departure(&p, i), found = property_arrival(c, departure);
        if (found < INFINITY) path_fits(&p, departure, found);
        const double made = property_arrival(&p.there, departure), slack = p.slack + NEAR * (found < INFINITY ? found - departure : 0.0);
        if (found == made || fabs(found - made) <= slack) continue;
        const double step = NEAR * (departure + p.there.unit); /* beside a jump, then */
        property_relates(c, found, <=, property_arrival(&p.there, departure + step) + slack);
        property_relates(c, found, >=, property_arrival(&p.there, fmax(0.0, departure - step)) - slack);
    }
    pair_drop(&p);
}

static void arrivals_are_those_of_a_scene_made_for_the_ends(void **state)
{
    (void)state;
    property_each(60, 40, arrivals_agree);
}

static void departures_agree(property_case *c)
{
    pair p;
    pair_make(&p, c);
    for (int i = 0; i < 3; i++) {
        const double arrival = p.there.unit * chance_between(&c->chance, 0.5, 4.0);
        double found = -1.0, made = -1.0, arrives;
        const tdsp_status status = tdsp_latest_departure(c->solver, arrival, &found, &arrives);
        const tdsp_status expected = tdsp_latest_departure(p.there.solver, arrival, &made, NULL);
        property_holds(c, tdsp_status_is_answer(status));
        property_relates(c, status, ==, expected);
        if (status != TDSP_OK) continue;
        property_relates(c, fabs(found - made), <=, 10.0 * (p.slack + NEAR * arrival));
        path_fits(&p, found, arrives);
    }
    pair_drop(&p);
}

static void departures_are_those_of_a_scene_made_for_the_ends(void **state)
{
    (void)state;
    property_each(40, 40, departures_agree);
}

static void ends_agree(property_case *c)
{
    pair p;
    tdsp_last_departure found = {0}, made = {0};
    pair_make(&p, c);
    const tdsp_status status = tdsp_solver_last_departure(c->solver, &found);
    property_relates(c, status, ==, tdsp_solver_last_departure(p.there.solver, &made));
    if (status == TDSP_OK && !(isinf(found.departure) && isinf(made.departure))) {
        property_relates(c, fabs(found.departure - made.departure), <=, 10.0 * (p.slack + NEAR * found.departure));
    }
    /* Where the source is covered at that very moment, rounding decides which of two reasons comes first. */
    const double covered = tdsp_scene_free_until(c->scene, p.ends.source, NULL);
    const int apart = fabs(found.departure - covered) > p.slack || (found.reason == TDSP_SOURCE_COVERED && made.reason == TDSP_SOURCE_COVERED);
    if (status == TDSP_OK && !isinf(found.departure) && apart) {
        property_relates(c, found.reason, ==, made.reason);
        property_holds(c, found.reason == TDSP_CUT_OFF || fabs(found.time - made.time) <= p.slack + NEAR * made.time);
    }
    pair_drop(&p);
}

static void the_last_departure_is_that_of_a_scene_made_for_the_ends(void **state)
{
    (void)state;
    property_each(40, 40, ends_agree);
}

/* A table between the ends is accepted as one of the scene with those ends. */
static void table_is_good(property_case *c)
{
    pair p;
    tdsp_oracle oracle;
    tdsp_build_options options;
    void *bytes;
    size_t length;
    pair_make(&p, c);
    tdsp_build_options_init(&options);
    options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    options.delta = 0.05 * (c->unit + p.there.unit);
    options.horizon = 2.0 * p.there.unit;
    options.world = (tdsp_build_world){tdsp_scene_hash_for(c->scene, &p.ends), c->journey.speed, p.ends.source, p.ends.destination, NULL, NULL};
    property_holds(c, tdsp_solver_oracle(c->solver, &oracle) == TDSP_OK);
    const tdsp_status status = tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL);
    property_holds(c, tdsp_status_is_answer(status));
    if (status == TDSP_OK) {
        tdsp_table table;
        tdsp_table_verdict verdict;
        property_holds(c, tdsp_table_open(&table, bytes, length) == TDSP_OK);
        property_holds(c, tdsp_verify_table_for(c->scene, &p.ends, &table, &verdict) == TDSP_OK && verdict.ok);
        property_holds(c, tdsp_verify_table(p.there.scene, &table, &verdict) == TDSP_OK && verdict.ok);
        property_holds(c, tdsp_verify_table(c->scene, &table, &verdict) == TDSP_OK && verdict.stale);
        tdsp_bytes_free(NULL, bytes, length);
    }
    pair_drop(&p);
}

static void a_table_between_the_ends_is_accepted_by_the_verifier(void **state)
{
    (void)state;
    property_each(8, 30, table_is_good);
}

enum { MANY = 24 };

/* Places of all kinds: anywhere, the other end itself, and some twice. */
static void some_places(property_case *c, tdsp_point places[MANY], tdsp_point other)
{
    for (int k = 0; k < MANY; k++) places[k] = some_place(c);
    places[3] = other;
    places[7] = places[11];
    places[13] = c->discs[0].center;
}

/* Beside a jump either side will do. */
static void same_arrival(property_case *c, const tdsp_ends *ends, double departure, double found, double alone)
{
    const double slack = NEAR * (c->unit + (found < INFINITY ? found - departure : 0.0)), step = NEAR * (departure + c->unit);
    double before, after;
    if (found == alone || fabs(found - alone) <= slack) return;
    property_holds(c, tdsp_status_is_answer(tdsp_earliest_arrival_for(c->solver, ends, fmax(0.0, departure - step), &before)));
    property_holds(c, tdsp_status_is_answer(tdsp_earliest_arrival_for(c->solver, ends, departure + step, &after)));
    property_relates(c, found, >=, before - slack);
    property_relates(c, found, <=, after + slack);
}

static void many_arrivals_agree(property_case *c)
{
    tdsp_point places[MANY];
    double arrivals[MANY], alone;
    tdsp_status statuses[MANY];
    const tdsp_point source = some_place(c);
    some_places(c, places, source);
    const double departure = chance_below(&c->chance, 3) ? chance_between(&c->chance, 0.0, 0.5) * c->unit : 0.0;
    property_holds(c, tdsp_earliest_arrivals(c->solver, source, departure, places, MANY, arrivals, statuses) == TDSP_OK);
    for (int k = 0; k < MANY; k++) {
        const tdsp_ends ends = {source, places[k]};
        const tdsp_status status = tdsp_earliest_arrival_for(c->solver, &ends, departure, &alone);
        property_holds(c, (statuses[k] == TDSP_OK) == (arrivals[k] < INFINITY));
        if (arrivals[k] == INFINITY && status != TDSP_OK) property_relates(c, statuses[k], ==, status);
        same_arrival(c, &ends, departure, arrivals[k], alone);
    }
}

static void arrivals_that_share_a_search_are_those_of_each_alone(void **state)
{
    (void)state;
    property_each(25, 40, many_arrivals_agree);
}

static void many_departures_agree(property_case *c)
{
    tdsp_point places[MANY];
    double departures[MANY], arrives[MANY], alone;
    tdsp_status statuses[MANY];
    const tdsp_point destination = some_place(c);
    some_places(c, places, destination);
    const double arrival = chance_between(&c->chance, 0.2, 3.0) * c->unit;
    property_holds(c, tdsp_latest_departures(c->solver, places, MANY, destination, arrival, departures, arrives, statuses) == TDSP_OK);
    for (int k = 0; k < MANY; k++) {
        const tdsp_ends ends = {places[k], destination};
        property_relates(c, statuses[k], ==, tdsp_latest_departure_for(c->solver, &ends, arrival, &alone, NULL));
        if (statuses[k] != TDSP_OK) continue;
        property_relates(c, fabs(departures[k] - alone), <=, 10.0 * NEAR * (c->unit + arrival));
        property_relates(c, arrives[k], <=, arrival);
        property_relates(c, arrives[k], >=, departures[k]);
    }
}

static void departures_that_share_a_search_are_those_of_each_alone(void **state)
{
    (void)state;
    property_each(25, 40, many_departures_agree);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrivals_are_those_of_a_scene_made_for_the_ends),
        cmocka_unit_test(departures_are_those_of_a_scene_made_for_the_ends),
        cmocka_unit_test(the_last_departure_is_that_of_a_scene_made_for_the_ends),
        cmocka_unit_test(arrivals_that_share_a_search_are_those_of_each_alone),
        cmocka_unit_test(departures_that_share_a_search_are_those_of_each_alone),
        cmocka_unit_test(a_table_between_the_ends_is_accepted_by_the_verifier),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
