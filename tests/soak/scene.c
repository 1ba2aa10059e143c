/* SPDX-License-Identifier: MIT */
/* See scene.h. */
#include "soak/scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* No number of a scene is beyond this. */
#define LARGEST 1e100

enum { HALVINGS = 60 };

void soak_copy(soak_scene *to, const soak_scene *from)
{
    memcpy(to, from, offsetof(soak_scene, discs) + from->count * sizeof from->discs[0]);
}

void soak_add(soak_scene *scene, tdsp_point center, double radius, double rate)
{
    if (scene->count == SOAK_MOST_DISCS) return;
    scene->discs[scene->count++] =
        (soak_disc){.center = center, .radius = fmax(0.0, radius), .growth = {.kind = TDSP_GROWTH_RATE, .rate = fmax(0.0, rate)}};
}

void soak_take_rates(soak_scene *scene, const tdsp_journey *journey, const tdsp_disc *discs, size_t count)
{
    scene->journey = *journey;
    scene->count = 0;
    for (size_t i = 0; i < count; i++) soak_add(scene, discs[i].center, discs[i].radius, discs[i].growth);
}

void soak_take_growth(soak_scene *scene, const grown_scene *from)
{
    scene->journey = from->journey;
    scene->count = from->count;
    for (size_t i = 0; i < from->count; i++) {
        const tdsp_growing_disc *disc = &from->discs[i];
        soak_disc *to = &scene->discs[i];
        *to = (soak_disc){.center = disc->center, .radius = disc->radius, .growth = disc->growth, .parts = from->parts[i]};
        const size_t count = disc->growth.kind == TDSP_GROWTH_RATE ? 0 : disc->growth.count;
        if (disc->growth.values) memcpy(to->values, disc->growth.values, count * sizeof(double));
        if (disc->growth.times) memcpy(to->times, disc->growth.times, count * sizeof(double));
    }
}

static void attach(const soak_disc *disc, tdsp_growing_disc *to)
{
    *to = (tdsp_growing_disc){disc->center, disc->radius, disc->growth};
    to->growth.values = disc->values;
    to->growth.times = disc->times;
    to->growth.ctx = (void *)(uintptr_t)&disc->parts;
}

tdsp_status soak_open(const soak_scene *scene, tdsp_method method, soak_world *world)
{
    *world = (soak_world){.is = scene, .unit = soak_distance(scene) / scene->journey.speed};
    tdsp_growing_disc *discs = calloc(scene->count + 1, sizeof *discs);
    if (!discs) return TDSP_NO_MEMORY;
    for (size_t i = 0; i < scene->count; i++) attach(&scene->discs[i], &discs[i]);
    tdsp_status status = tdsp_scene_create_growing(&scene->journey, discs, scene->count, NULL, &world->scene);
    free(discs);
    if (status == TDSP_OK) status = tdsp_solver_create_for(world->scene, method, &world->solver);
    if (status != TDSP_OK) soak_close(world);
    return status;
}

void soak_close(soak_world *world)
{
    tdsp_solver_free(world->solver);
    tdsp_scene_free(world->scene);
    world->solver = NULL;
    world->scene = NULL;
}

int soak_has_rates_only(const soak_scene *scene)
{
    for (size_t i = 0; i < scene->count; i++)
        if (scene->discs[i].growth.kind != TDSP_GROWTH_RATE) return 0;
    return 1;
}

int soak_has_laws(const soak_scene *scene)
{
    for (size_t i = 0; i < scene->count; i++)
        if (scene->discs[i].growth.kind == TDSP_GROWTH_LAW) return 1;
    return 0;
}

static tdsp_point placed(const grown_change *c, tdsp_point a)
{
    const double y = c->mirror ? -a.y : a.y;
    return (tdsp_point){c->shift.x + c->length * (c->turn.x * a.x - c->turn.y * y),
                        c->shift.y + c->length * (c->turn.y * a.x + c->turn.x * y)};
}

static void place_disc(soak_disc *disc, const grown_change *change)
{
    double power = 1.0;
    disc->center = placed(change, disc->center);
    disc->radius *= change->length;
    disc->growth.rate *= change->length / change->time;
    disc->growth.until *= change->time;
    for (size_t k = 0; k < GROWTH_MOST_VALUES; k++) {
        if (k == 0 || disc->growth.kind == TDSP_GROWTH_POLYNOMIAL) power *= change->time;
        disc->values[k] *= change->length / power;
        disc->times[k] *= change->time;
    }
    disc->parts.radius *= change->length;
    for (size_t k = 0; k < disc->parts.count; k++) {
        disc->parts.begins[k] *= change->time;
        disc->parts.spans[k] *= change->time;
        disc->parts.shares[k] *= change->length;
    }
}

void soak_place(soak_scene *scene, const grown_change *change)
{
    tdsp_journey *j = &scene->journey;
    j->source = placed(change, j->source);
    j->destination = placed(change, j->destination);
    j->radius *= change->length;
    j->speed *= change->length / change->time;
    scene->moment *= change->time;
    for (size_t i = 0; i < scene->count; i++) place_disc(&scene->discs[i], change);
}

static double radius_of_steps(const soak_disc *disc, double time)
{
    double radius = disc->radius;
    for (size_t k = 0; k < disc->growth.count && disc->times[k] < time; k++) {
        const double end = k + 1 < disc->growth.count ? fmin(disc->times[k + 1], time) : time;
        radius += disc->values[k] * (end - disc->times[k]);
    }
    return radius;
}

static double radius_of_powers(const soak_disc *disc, double time)
{
    double sum = 0.0;
    for (size_t k = disc->growth.count; k-- > 0;) sum = (sum + disc->values[k]) * time;
    return disc->radius + sum;
}

static double radius_of_law(const soak_disc *disc, double time)
{
    double radius, rate;
    const double until = disc->growth.until;
    disc->growth.law((void *)(uintptr_t)&disc->parts, fmin(time, until), &radius, &rate);
    return radius + rate * fmax(0.0, time - until);
}

double soak_radius(const soak_scene *scene, size_t i, double time)
{
    const soak_disc *disc = &scene->discs[i];
    switch (disc->growth.kind) {
    case TDSP_GROWTH_POLYNOMIAL: return radius_of_powers(disc, time) + scene->journey.radius;
    case TDSP_GROWTH_RATES: return radius_of_steps(disc, time) + scene->journey.radius;
    case TDSP_GROWTH_LAW: return radius_of_law(disc, time) + scene->journey.radius;
    case TDSP_GROWTH_RATE: break;
    }
    return disc->radius + disc->growth.rate * time + scene->journey.radius;
}

static double distance(tdsp_point a, tdsp_point b)
{
    return hypot(b.x - a.x, b.y - a.y);
}

double soak_distance(const soak_scene *scene)
{
    return distance(scene->journey.source, scene->journey.destination);
}

static double largest(tdsp_point p)
{
    return fmax(fabs(p.x), fabs(p.y));
}

double soak_magnitude(const soak_scene *scene)
{
    double most = fmax(largest(scene->journey.source), largest(scene->journey.destination));
    for (size_t i = 0; i < scene->count; i++)
        most = fmax(most, fmax(largest(scene->discs[i].center), scene->discs[i].radius + scene->journey.radius));
    return most;
}

static int is_moderate(double x)
{
    return fabs(x) <= LARGEST;
}

static int disc_is_within_limits(const soak_disc *disc)
{
    const size_t count = disc->growth.kind == TDSP_GROWTH_RATE ? 0 : disc->growth.count;
    for (size_t k = 0; k < count; k++)
        if (!is_moderate(disc->values[k]) || !is_moderate(disc->times[k])) return 0;
    return is_moderate(disc->center.x) && is_moderate(disc->center.y) && is_moderate(disc->radius) && is_moderate(disc->growth.rate) &&
           is_moderate(disc->growth.until);
}

int soak_is_within_limits(const soak_scene *scene)
{
    const tdsp_journey *j = &scene->journey;
    for (size_t i = 0; i < scene->count; i++)
        if (!disc_is_within_limits(&scene->discs[i])) return 0;
    return is_moderate(j->speed) && is_moderate(1.0 / j->speed) && is_moderate(j->radius) && is_moderate(largest(j->source)) &&
           is_moderate(largest(j->destination));
}

static void set_radius(soak_disc *disc, double radius)
{
    disc->parts.radius = fmax(0.0, disc->parts.radius + radius - disc->radius);
    disc->radius = disc->growth.kind == TDSP_GROWTH_LAW ? disc->parts.radius : radius;
}

static void grow_by_share(soak_disc *disc, double share)
{
    disc->growth.rate *= share;
    for (size_t k = 0; k < GROWTH_MOST_VALUES; k++) disc->values[k] *= share;
    for (size_t k = 0; k < disc->parts.count; k++) disc->parts.shares[k] *= share;
}

/* No robot that leaves so meets the disc before this. */
static double first_meeting(const soak_scene *scene, size_t i, const soak_nudge *nudge)
{
    const double speed = scene->journey.speed, away = distance(scene->discs[i].center, nudge->start);
    double low = nudge->departure, high = low + away / speed;
    for (int step = 0; step < HALVINGS; step++) {
        const double middle = 0.5 * (low + high);
        *(soak_radius(scene, i, middle) + speed * (middle - nudge->departure) < away ? &low : &high) = middle;
    }
    return low;
}

static void inflate_disc(soak_scene *scene, size_t i, const soak_nudge *nudge, double by)
{
    soak_disc *disc = &scene->discs[i];
    const double radius = disc->radius + by, grown = soak_radius(scene, i, first_meeting(scene, i, nudge)) - disc->radius;
    set_radius(disc, fmax(0.0, radius));
    if (radius < 0.0) grow_by_share(disc, fmax(0.0, 1.0 + radius / grown));
}

void soak_inflate(soak_scene *scene, const soak_nudge *nudge)
{
    tdsp_journey *j = &scene->journey;
    const double rest = nudge->rounding * (soak_magnitude(scene) + j->speed * nudge->time);
    for (size_t i = 0; i < scene->count; i++) set_radius(&scene->discs[i], scene->discs[i].radius + j->radius);
    j->radius = 0.0;
    for (size_t i = 0; i < scene->count; i++) {
        const soak_disc *disc = &scene->discs[i];
        const double sizes = soak_distance(scene) + distance(disc->center, j->source) + disc->radius;
        inflate_disc(scene, i, nudge, nudge->share * sizes + rest);
    }
}
