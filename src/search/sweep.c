/* What has been ridden already: the rule is in sweep.h. */
#include "search/sweep.h"

#include "geom/spiral.h"

/* Rides that start this close behind an angle count as having passed it. */
#define SAME_ANGLE 1e-12

/* Who passes within this share of the times at hand passes at the same time: then the older ride counts as the earlier one. */
#define SAME_MOMENT 1e-13

static int passed_before(double passed, double time, int is_older)
{
    double tie = SAME_MOMENT * (1.0 + fabs(time));
    return passed < time - tie || (is_older && passed <= time + tie);
}

static size_t sweep_list(uint32_t disc, int side)
{
    return 2 * (size_t)disc + (side > 0);
}

static uint32_t sweep_first(const disc_engine *engine, uint32_t disc, int side)
{
    size_t list = sweep_list(disc, side);
    return engine->stamps[list] == engine->stamp ? engine->heads[list] : ENGINE_NONE;
}

void sweep_add(disc_engine *engine, uint32_t ride)
{
    engine_ride *added = &engine->rides[ride];
    size_t list = sweep_list(added->disc, added->side);
    added->next = sweep_first(engine, added->disc, added->side);
    engine->heads[list] = ride;
    engine->stamps[list] = engine->stamp;
}

/* Could a rider at this angle at time `early` be at it at `late` by going straight along the radius? */
static int sweep_radius_free(disc_engine *engine, uint32_t disc, double normal, double early, double late)
{
    const geom_disc *self = engine_disc(engine, disc);
    double gain = disc_radius(self, late) - disc_radius(self, early);
    if (fabs(self->rate) <= engine->set->rate_min || gain == 0.0) return 1;
    tdsp_point outward = point_unit(normal);
    tdsp_point from = point_along(self->center, disc_radius(self, early), outward);
    geom_line line = {from, point_scale(gain > 0.0 ? 1.0 : -1.0, outward), gain > 0.0 ? early : late - fabs(gain), fabs(gain)};
    ++engine->legs_tested;
    return !index_line_blocked(&engine->view, &line, disc, INDEX_NONE);
}

/* When the ride passed the angle; infinite when it has not. */
static double sweep_passed(const disc_engine *engine, const engine_ride *ride, double normal)
{
    const geom_disc *disc = engine_disc(engine, ride->disc);
    double ahead = angle_positive(ride->side * (normal - ride->normal));
    if (ahead > GEOM_TURN - SAME_ANGLE) ahead = 0.0;
    double time = ride->start + spiral_duration(disc, ride->start, ahead);
    return time <= ride->now ? time : INFINITY;
}

int sweep_covers(disc_engine *engine, uint32_t disc, int side, double normal, double time)
{
    for (uint32_t r = sweep_first(engine, disc, side); r != ENGINE_NONE; r = engine->rides[r].next) {
        double passed = sweep_passed(engine, &engine->rides[r], normal);
        if (passed_before(passed, time, 1) && sweep_radius_free(engine, disc, normal, passed, time)) return 1;
    }
    return 0;
}

double sweep_cut(disc_engine *engine, uint32_t ride, double from, double to)
{
    const engine_ride *self = &engine->rides[ride];
    const geom_disc *disc = engine_disc(engine, self->disc);
    double normal = self->normal + self->side * spiral_angle(disc, self->start, from);
    for (uint32_t r = sweep_first(engine, self->disc, self->side); r != ENGINE_NONE; r = engine->rides[r].next) {
        const engine_ride *other = &engine->rides[r];
        if (r == ride) continue;
        double passed = sweep_passed(engine, other, normal);
        if (passed_before(passed, from, r < ride) && sweep_radius_free(engine, self->disc, normal, passed, from)) return from;
        double ahead = angle_positive(self->side * (other->normal - normal));
        double meet = from + spiral_duration(disc, from, ahead);
        if (meet >= to || !passed_before(other->start, meet, r < ride)) continue;
        if (sweep_radius_free(engine, self->disc, other->normal, other->start, meet)) to = meet;
    }
    return to;
}
