/* SPDX-License-Identifier: MIT */
/* See worlds.h. A near world is a far one with its ends moved, so that both have the same discs. */
#include "bench/worlds.h"

#include <math.h>
#include <string.h>

#define SIDE 100.0 /* of the square that the generator fills */
#define ROOM 0.25  /* spacings between an end and the nearest disc, as in the generator */

/* A ring's discs are as large as the largest of the others, and so close that neighbours overlap from the start. */
#define RING_DISC 0.42
#define RING_PITCH 0.7
#define RING_SEALED 3.0  /* its radius, in spacings */
#define RING_FENCED 25.0 /* and in the scene's unit */

static double spacing(guint discs)
{
    return SIDE / sqrt(discs);
}

static double distance(tdsp_point a, tdsp_point b)
{
    return hypot(a.x - b.x, a.y - b.y);
}

static void clear_around(GArray *discs, tdsp_point end, double room)
{
    guint kept = 0;
    for (guint i = 0; i < discs->len; i++) {
        tdsp_disc disc = g_array_index(discs, tdsp_disc, i);
        if (distance(disc.center, end) >= disc.radius + room) g_array_index(discs, tdsp_disc, kept++) = disc;
    }
    g_array_set_size(discs, kept);
}

/* Other ends for the journey, with room around them, and the growth that goes with its length. */
static void move_ends(Generated *out, tdsp_point source, tdsp_point destination, double room)
{
    double longer = distance(out->journey.source, out->journey.destination) / distance(source, destination);
    for (guint i = 0; i < out->discs->len; i++) g_array_index(out->discs, tdsp_disc, i).growth *= longer;
    out->journey.source = source;
    out->journey.destination = destination;
    clear_around(out->discs, source, room);
    clear_around(out->discs, destination, room);
}

static void make_near(guint discs, Generated *out)
{
    double apart = WORLD_NEAR_SPACINGS * spacing(discs) / sqrt(8.0);
    tdsp_point source = {SIDE / 2 - apart, SIDE / 2 - apart}, destination = {SIDE / 2 + apart, SIDE / 2 + apart};
    move_ends(out, source, destination, ROOM * spacing(discs));
}

static void add_ring(GArray *discs, tdsp_point center, double radius, guint count, double disc_radius)
{
    for (guint i = 0; i < count; i++) {
        double angle = 2 * G_PI * i / count;
        tdsp_disc disc = {{center.x + radius * cos(angle), center.y + radius * sin(angle)}, disc_radius, 0};
        g_array_append_val(discs, disc);
    }
}

static const char *make_closed(const World *world, gboolean fenced, Generated *out)
{
    double a = spacing(world->discs), radius = fenced ? RING_FENCED : RING_SEALED * a;
    guint ring = (guint)ceil(2 * G_PI * radius / (RING_PITCH * a));
    if (ring >= world->discs) return "too few discs for a ring";
    const GenerateKind *kind = generate_kind("random");
    kind->make(&(GenerateOptions){world->discs - ring, world->seed, kind->growth}, out);
    if (world->near) make_near(world->discs, out);
    if (fenced) move_ends(out, out->journey.source, (tdsp_point){SIDE / 2, SIDE / 2}, ROOM * a);
    add_ring(out->discs, out->journey.destination, radius, ring, RING_DISC * a);
    return NULL;
}

const char *world_make(const World *world, Generated *out)
{
    if (world->near && world->discs < WORLD_NEAR_LEAST) return "too few discs for a near journey";
    if (world->discs == 0 || world->discs > 10000000) return "from 1 to 10000000 discs";
    gboolean fenced = strcmp(world->kind, "fenced") == 0;
    if (fenced && world->near) return "a fence is not near";
    if (fenced || strcmp(world->kind, "sealed") == 0) return make_closed(world, fenced, out);
    const GenerateKind *kind = generate_kind(world->kind);
    if (!kind || kind->growth < 0) return "no such kind";
    kind->make(&(GenerateOptions){world->discs, world->seed, kind->growth}, out);
    if (world->near) make_near(world->discs, out);
    return NULL;
}
