/* SPDX-License-Identifier: MIT */
/*
 * What no answer may depend on. Turning by right angles, and other units by powers of two, round nothing: every bit must stay. Everything else
 * rounds the scene, or asks in another order.
 */
#include "soak/checks.h"

#include <math.h>
#include <string.h>

static soak_scene other; /* the scene of the check under way */

/* A(t) of `other` is `scale` times that of the scene: to the bit, or as far as touches allow. */
static void same_answers(soak_case *c, double scale, int exact, const char *text)
{
    soak_world world;
    const tdsp_status status = soak_open(&other, TDSP_METHOD_AUTO, &world);
    if (status != TDSP_OK) {
        soak_fail(c, INFINITY, "%s: %s", text, tdsp_status_name(status));
        return;
    }
    const double expected = soak_ask(c, &c->world, c->departure), found = soak_ask(c, &world, c->departure * scale) / scale;
    soak_close(&world);
    if (!exact)
        soak_agrees(c, &c->world, c->departure, found, text);
    else if (expected != found && !(isnan(expected) && isnan(found)))
        soak_fail(c, fabs(found - expected), "%s: %.17g, and not %.17g, at departure %.17g", text, found, expected, c->departure);
}

static void changed(soak_case *c, const grown_change *change, int exact, const char *text)
{
    soak_copy(&other, c->scene);
    soak_place(&other, change);
    same_answers(c, change->time, exact, text);
}

void soak_check_quarter(soak_case *c)
{
    static const tdsp_point turns[] = {{0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
    const grown_change change = {turns[soak_pick(c, 3)], {0.0, 0.0}, 1.0, 1.0, 0};
    /* Discs of one rate: only angles are rounded otherwise. The other engine finds touches by steps that end within a share of what still is a touch. */
    c->looser = tdsp_solver_method(c->world.solver) == TDSP_METHOD_GENERAL ? 0.3 : 0.01;
    changed(c, &change, 0, "turned by right angles");
}

static void place_doubled(const soak_case *c, int length, int time)
{
    const grown_change change = {{1.0, 0.0}, {0.0, 0.0}, ldexp(1.0, length), ldexp(1.0, time), 0};
    soak_copy(&other, c->scene);
    soak_place(&other, &change);
}

void soak_check_doubled(soak_case *c)
{
    int length = (int)soak_pick(c, 41) - 20, time = (int)soak_pick(c, 41) - 20;
    /* The smallest numbers lose bits. */
    if ((c->departure > 0.0 && c->departure < 1e-280) || soak_has_laws(c->scene)) return;
    place_doubled(c, length, time);
    /* In units too far off a coefficient would be larger than a scene may have: then in units half as far off. */
    for (; !soak_is_within_limits(&other); place_doubled(c, length, time)) {
        length /= 2;
        time /= 2;
    }
    same_answers(c, ldexp(1.0, time), 1, "in units by powers of two");
}

void soak_check_turned(soak_case *c)
{
    const double angle = soak_pick_between(c, 0.0, 6.283185307179586);
    const grown_change change = {{cos(angle), sin(angle)}, {0.0, 0.0}, 1.0, 1.0, 0};
    changed(c, &change, 0, "turned");
}

void soak_check_moved(soak_case *c)
{
    const double far = soak_distance(c->scene) * 4.0;
    const grown_change change = {{1.0, 0.0}, {soak_pick_between(c, -far, far), soak_pick_between(c, -far, far)}, 1.0, 1.0, 0};
    changed(c, &change, 0, "moved");
}

void soak_check_scaled(soak_case *c)
{
    const grown_change change = {{1.0, 0.0}, {0.0, 0.0}, soak_pick_between(c, 1e-3, 1e3), soak_pick_between(c, 1e-3, 1e3), 0};
    changed(c, &change, 0, "in other units");
}

void soak_check_mirrored(soak_case *c)
{
    const grown_change change = {{1.0, 0.0}, {0.0, 0.0}, 1.0, 1.0, 1};
    changed(c, &change, 0, "mirrored");
}

static void exchange(soak_scene *scene, size_t a, size_t b)
{
    const soak_disc kept = scene->discs[a];
    scene->discs[a] = scene->discs[b];
    scene->discs[b] = kept;
}

void soak_check_relabelled(soak_case *c)
{
    soak_copy(&other, c->scene);
    for (size_t i = other.count; i > 1; i--) exchange(&other, i - 1, (size_t)soak_pick(c, i));
    same_answers(c, 1.0, 0, "in another order");
}

/* A disc that is half of another in everything is inside it for good. */
static void add_hidden(soak_case *c)
{
    const soak_disc *outer = &other.discs[soak_pick(c, other.count)];
    if (outer->growth.kind == TDSP_GROWTH_RATE) soak_add(&other, outer->center, 0.5 * outer->radius, 0.5 * outer->growth.rate);
}

void soak_check_fewer(soak_case *c)
{
    soak_world world;
    if (c->scene->count == 0 || c->scene->count == SOAK_MOST_DISCS) return;
    soak_copy(&other, c->scene);
    add_hidden(c);
    same_answers(c, 1.0, 0, "with a disc inside another");
    soak_copy(&other, c->scene);
    exchange(&other, (size_t)soak_pick(c, other.count), other.count - 1);
    other.count--;
    if (c->failed || soak_open(&other, TDSP_METHOD_AUTO, &world) != TDSP_OK) return;
    soak_not_before(c, &world, c->departure, soak_ask(c, &c->world, c->departure), "with a disc more");
    soak_close(&world);
}
