/* What holds between departures: the travel time never falls, and the latest departure is the inverse of the earliest arrival. */
#include "soak/checks.h"

#include <math.h>

#include "tdsp/verify.h"

/* Latest departures are looked past by this share of the times at hand. */
#define PAST 1e-9

static double past(const soak_case *c, double departure)
{
    return departure + PAST * (c->world.unit + departure);
}

void soak_check_bounds(soak_case *c)
{
    const double t = c->departure, source = tdsp_scene_source_free_until(c->world.scene, NULL);
    double arrival = -1.0;
    const tdsp_status status = tdsp_earliest_arrival(c->world.solver, t, &arrival);
    if (status == TDSP_SHRINKS) return;
    if (!tdsp_status_is_answer(status)) soak_fail(c, INFINITY, "status %s at departure %.17g", tdsp_status_name(status), t);
    if ((status == TDSP_SOURCE_COVERED) != (t > source))
        soak_fail(c, fabs(t - source), "status %s at departure %.17g, and the source is free until %.17g",
                  tdsp_status_name(status), t, source);
    if (status != TDSP_OK) return;
    const double slack = soak_slack(c, &c->world, t, arrival), least = t + c->world.unit,
                 most = tdsp_scene_destination_free_until(c->world.scene, NULL);
    if (arrival < least - slack) soak_fail(c, least - arrival, "arrival %.17g before a straight line's, %.17g", arrival, least);
    if (arrival > most + slack)
        soak_fail(c, arrival - most, "arrival %.17g after the destination is covered, %.17g", arrival, most);
}

void soak_check_rise(soak_case *c)
{
    const double arrival = soak_ask(c, &c->world, c->later);
    if (arrival < INFINITY)
        soak_not_before(c, &c->world, c->departure, c->departure + (arrival - c->later), "the travel time falls: moved earlier");
}

void soak_check_repeat(soak_case *c)
{
    double latest;
    const double first = soak_ask(c, &c->world, c->departure);
    (void)soak_ask(c, &c->world, c->later);
    (void)tdsp_latest_departure(c->world.solver, 2.0 * c->world.unit + c->departure, &latest, NULL);
    const double second = soak_ask(c, &c->world, c->departure);
    if (first != second && !isnan(first))
        soak_fail(c, fabs(second - first), "first %.17g, then %.17g, at departure %.17g", first, second, c->departure);
}

/* The latest departure in a world for an arrival; NAN where it has none. */
static double latest_in(soak_case *c, const soak_world *world, double arrival, double *arrives)
{
    double departure = NAN;
    *arrives = NAN;
    const tdsp_status status = tdsp_latest_departure(world->solver, arrival, &departure, arrives);
    if (!tdsp_status_is_answer(status) && status != TDSP_SHRINKS)
        soak_fail(c, INFINITY, "latest departure for %.17g: status %s", arrival, tdsp_status_name(status));
    return status == TDSP_OK ? departure : NAN;
}

/* The departure `t` arrives by `a`; the latest one is not before. Where discs that are larger by a touch say otherwise, they are asked. */
static void is_no_earlier(soak_case *c, double t, double a, double latest)
{
    const double least = t - soak_slack(c, &c->world, t, a);
    soak_world larger;
    double arrives;
    if (latest >= least) return;
    if (!soak_open_moved(c, &c->world, 1.0, &larger)) return;
    double bound = latest_in(c, &larger, a, &arrives);
    soak_close(&larger);
    c->forgiven++;
    if (isnan(bound)) bound = -INFINITY;
    bound = fmin(bound, t) - soak_slack(c, &c->world, t, a) - soak_step(c, &c->world, t);
    if (!(latest >= bound)) soak_fail(c, bound - latest, "latest departure %.17g for %.17g, which %.17g reaches", latest, a, t);
}

static void path_is_good(soak_case *c, double departure, double arrives)
{
    static tdsp_leg legs[4096];
    size_t count;
    tdsp_verdict verdict;
    if (tdsp_solver_path(c->world.solver, legs, 4096, &count) != TDSP_OK) {
        soak_fail(c, INFINITY, "no path of the latest departure %.17g", departure);
        return;
    }
    if (tdsp_verify_path(c->world.scene, legs, count, departure, arrives, &verdict) != TDSP_OK || verdict.problems)
        soak_fail(c, fabs(verdict.min_clearance) / c->scene->journey.speed,
                  "the path of the latest departure %.17g is rejected: problems %u, clearance %.3g", departure, verdict.problems,
                  verdict.min_clearance);
}

void soak_check_latest(soak_case *c)
{
    const double t = c->departure, arrival = soak_ask(c, &c->world, t);
    double arrives;
    if (!(arrival < INFINITY)) return;
    /* In part of the cases somewhat later, so that some are inside a jump. */
    const double a = (arrival + (soak_pick(c, 2) ? 0.0 : c->world.unit * soak_pick_between(c, 0.0, 0.5))) * (1.0 + 1e-15);
    const double latest = latest_in(c, &c->world, a, &arrives), slack = soak_slack(c, &c->world, t, a);
    if (isnan(latest)) {
        /* Where a radius shrinks on the way, or what is a touch is decided otherwise. */
        if (tdsp_scene_valid_until(c->world.scene, NULL) == INFINITY) is_no_earlier(c, t, a, -INFINITY);
        return;
    }
    is_no_earlier(c, t, a, latest);
    path_is_good(c, latest, arrives);
    if (!(arrives <= a + slack))
        soak_fail(c, arrives - a, "latest departure %.17g for %.17g arrives at %.17g", latest, a, arrives);
    soak_agrees(c, &c->world, latest, arrives, "the arrival of the latest departure");
    if (latest < INFINITY && arrives < INFINITY)
        soak_not_after(c, &c->world, past(c, latest), a, "later than the latest departure");
}

void soak_check_too_early(soak_case *c)
{
    const double first = soak_ask(c, &c->world, 0.0), early = first - 1e-6 * c->world.unit;
    double latest = NAN, arrives;
    if (!(first < INFINITY) || !(early >= 0.0) || early == first) return;
    const tdsp_status status = tdsp_latest_departure(c->world.solver, early, &latest, &arrives);
    if (status == TDSP_ARRIVAL_TOO_EARLY || status == TDSP_SHRINKS) return;
    if (status == TDSP_OK)
        soak_not_before(c, &c->world, 0.0, early, "a latest departure for what is too early");
    else
        soak_fail(c, INFINITY, "latest departure for %.17g, too early: status %s", early, tdsp_status_name(status));
}

void soak_check_last(soak_case *c)
{
    tdsp_last_departure last;
    double arrival;
    const double first = soak_ask(c, &c->world, 0.0);
    const tdsp_status status = tdsp_solver_last_departure(c->world.solver, &last);
    /* Among discs that hardly grow the last departure may be too many journeys away. */
    if (status == TDSP_SHRINKS || status == TDSP_NOT_SUPPORTED || isnan(first)) return;
    if (!(first < INFINITY)) {
        if (status == TDSP_OK && last.departure >= 0.0)
            soak_fail(c, INFINITY, "last departure %.17g, and none at 0", last.departure);
        return;
    }
    if (status != TDSP_OK || last.departure < 0.0) {
        soak_fail(c, INFINITY, "last departure: status %s, and one at 0", tdsp_status_name(status));
        return;
    }
    if (last.departure == INFINITY) {
        if (!(soak_ask(c, &c->world, 1e3 * c->world.unit) < INFINITY))
            soak_fail(c, INFINITY, "nothing ends the departures, and a late one has no way");
        return;
    }
    soak_agrees(c, &c->world, last.departure, last.arrival, "the arrival of the last departure");
    soak_not_after(c, &c->world, past(c, last.departure), INFINITY, "later than the last departure");
    const tdsp_status after = tdsp_earliest_arrival(c->world.solver, past(c, last.departure), &arrival);
    if (after != TDSP_OK && after != TDSP_SHRINKS && after != last.reason)
        soak_fail(c, INFINITY, "after the last departure %.17g it is %s, and the reason is %s", last.departure,
                  tdsp_status_name(after), tdsp_status_name(last.reason));
}
