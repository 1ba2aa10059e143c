/* SPDX-License-Identifier: MIT */
/* Other ways to the same number: the other engine, the slow solvers, one search for many, and a table. */
#include "soak/checks.h"

#include <math.h>
#include <stdlib.h>

#include "slow/law.h"
#include "slow/slow.h"
#include "tdsp/build.h"
#include "tdsp/verify.h"

/* The slow solvers are right to about 1e-10, and decide touches by their own measures. */
#define SLOW_LOOSER 10.0

/* Tables are asked up to this many journeys. */
#define LONGEST 3.0

void soak_check_general(soak_case *c)
{
    soak_world general;
    if (!soak_has_rates_only(c->scene) || soak_open(c->scene, TDSP_METHOD_GENERAL, &general) != TDSP_OK) return;
    const double found = soak_ask(c, &general, c->departure);
    soak_close(&general);
    soak_agrees(c, &c->world, c->departure, found, "the engine for changing rates");
}

static double slow_for_rates(const soak_case *c)
{
    tdsp_disc discs[4];
    for (size_t i = 0; i < c->scene->count; i++)
        discs[i] = (tdsp_disc){c->scene->discs[i].center, c->scene->discs[i].radius, c->scene->discs[i].growth.rate};
    return slow_arrival(&c->scene->journey, discs, c->scene->count, c->departure);
}

static double slow_for_growth(const soak_case *c, double until)
{
    tdsp_growing_disc discs[4];
    slow_law_disc laws[4];
    for (size_t i = 0; i < c->scene->count; i++) {
        const soak_disc *disc = &c->scene->discs[i];
        discs[i] = (tdsp_growing_disc){disc->center, disc->radius, disc->growth};
        discs[i].growth.values = disc->values;
        discs[i].growth.times = disc->times;
        discs[i].growth.ctx = (void *)(uintptr_t)&disc->parts;
        laws[i] = slow_law_of(&discs[i]);
    }
    return slow_law_arrival(&c->scene->journey, laws, c->scene->count, until, c->departure);
}

/* Riders on a disc that is about as fast as they turn for ever, which sampling follows for as long. */
static int is_too_slow(const soak_scene *scene)
{
    for (size_t i = 0; i < scene->count; i++)
        if (fabs(scene->discs[i].growth.rate - scene->journey.speed) < 1e-3 * scene->journey.speed) return 1;
    return scene->count > 4;
}

void soak_check_slow(soak_case *c)
{
    if (is_too_slow(c->scene)) return;
    const double until = fmin(tdsp_scene_valid_until(c->world.scene, NULL), c->departure + 20.0 * c->world.unit);
    const int rates = soak_has_rates_only(c->scene);
    const double found = rates ? slow_for_rates(c) : slow_for_growth(c, until), arrival = soak_ask(c, &c->world, c->departure);
    if (isnan(found) || isnan(arrival) || (!rates && !(arrival < until))) return;
    c->looser = SLOW_LOOSER;
    soak_agrees(c, &c->world, c->departure, found, "the slow solver");
}

/* ----------------------------------------------------------------------------------------------------------------- many */

enum { MANY = 4 };

static tdsp_point place_near(soak_case *c)
{
    const double far = soak_distance(c->scene);
    const tdsp_point s = c->scene->journey.source;
    return (tdsp_point){s.x + soak_pick_between(c, -far, far), s.y + soak_pick_between(c, -far, far)};
}

void soak_check_many(soak_case *c)
{
    tdsp_point to[MANY] = {c->scene->journey.destination};
    double arrivals[MANY];
    tdsp_status statuses[MANY];
    for (int k = 1; k < MANY; k++) to[k] = place_near(c);
    const tdsp_status status =
        tdsp_earliest_arrivals(c->world.solver, c->scene->journey.source, c->departure, to, MANY, arrivals, statuses);
    if (status == TDSP_SHRINKS || soak_is_far(&c->world, status, c->departure)) return;
    if (!tdsp_status_is_answer(status)) soak_fail(c, INFINITY, "many: status %s", tdsp_status_name(status));
    for (int k = 0; k < MANY && !c->failed; k++) {
        const tdsp_ends ends = {c->scene->journey.source, to[k]};
        if (tdsp_solver_set_ends(c->world.solver, &ends) != TDSP_OK) soak_fail(c, INFINITY, "many: ends are refused");
        soak_agrees(c, &c->world, c->departure, arrivals[k], "one of many");
    }
    (void)tdsp_solver_set_ends(c->world.solver, NULL);
}

/* Other ends, in half of the cases the scene's own the other way round. The two frames differ, and a journey's unit with them. */
void soak_check_ends(soak_case *c)
{
    static soak_scene other;
    const tdsp_journey *j = &c->scene->journey;
    tdsp_ends ends = {j->destination, j->source};
    soak_world world;
    if (soak_pick(c, 2)) ends = (tdsp_ends){place_near(c), place_near(c)};
    soak_copy(&other, c->scene);
    other.journey.source = ends.source;
    other.journey.destination = ends.destination;
    if (soak_open(&other, TDSP_METHOD_AUTO, &world) != TDSP_OK) return;
    if (tdsp_solver_set_ends(c->world.solver, &ends) != TDSP_OK) soak_fail(c, INFINITY, "ends are refused");
    world.unit = fmax(world.unit, c->world.unit);
    soak_agrees(c, &world, c->departure, soak_ask(c, &c->world, c->departure), "between other ends");
    (void)tdsp_solver_set_ends(c->world.solver, NULL);
    soak_close(&world);
}

/* ---------------------------------------------------------------------------------------------------------------- table */

static void holds(soak_case *c, const tdsp_table *table, double departure)
{
    double lower, upper;
    const tdsp_status status = tdsp_table_arrival(table, departure, &lower, &upper);
    if (status == TDSP_HORIZON || status == TDSP_OUTSIDE_TABLE || isnan(soak_ask(c, &c->world, departure))) return;
    soak_not_after(c, &c->world, departure, status == TDSP_OK ? lower : INFINITY, "a table's lower end");
    if (status == TDSP_OK) soak_not_before(c, &c->world, departure, upper, "a table's upper end");
}

static void is_good(soak_case *c, const void *bytes, size_t length)
{
    tdsp_table table;
    tdsp_table_verdict verdict;
    if (tdsp_table_open(&table, bytes, length) != TDSP_OK || tdsp_verify_table(c->world.scene, &table, &verdict) != TDSP_OK) {
        soak_fail(c, INFINITY, "a table that cannot be opened or verified");
        return;
    }
    if (!verdict.ok)
        soak_fail(c, INFINITY, "a table with %d bad rows in order, %d in ratio, %d paths, the first row %d, clearance %.3g",
                  (int)verdict.bad_order, (int)verdict.bad_ratio, (int)verdict.bad_paths, (int)verdict.first_bad_row,
                  verdict.worst.min_clearance);
    holds(c, &table, c->departure);
    holds(c, &table, c->later);
    for (int k = 0; k < 8; k++) holds(c, &table, soak_pick_between(c, 0.0, LONGEST * c->world.unit));
}

void soak_check_table(soak_case *c)
{
    tdsp_oracle oracle;
    tdsp_build_options options;
    void *bytes = NULL;
    size_t length;
    if (!(c->world.unit > 0.0)) return;
    tdsp_build_options_init(&options);
    options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
    options.delta = (soak_pick(c, 2) ? 0.05 : 0.3) * c->world.unit;
    options.horizon = LONGEST * c->world.unit;
    options.max_rows = 2000;
    options.world = (tdsp_build_world){tdsp_scene_hash(c->world.scene),
                                       c->scene->journey.speed,
                                       c->scene->journey.source,
                                       c->scene->journey.destination,
                                       NULL,
                                       NULL};
    if (soak_pick(c, 2)) options.oracle_share = 0.0;
    (void)tdsp_solver_oracle(c->world.solver, &oracle);
    const tdsp_status status = tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL);
    if (status == TDSP_OK)
        is_good(c, bytes, length);
    else if (status != TDSP_SHRINKS && status != TDSP_TOO_MANY_ROWS && !tdsp_status_is_answer(status))
        soak_fail(c, INFINITY, "no table: %s", tdsp_status_name(status));
    tdsp_bytes_free(NULL, bytes, length);
}
