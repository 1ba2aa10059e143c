/* SPDX-License-Identifier: MIT */
/*
 * A baseline: the earliest arrival by the textbook's tangent graph, with the library's geometry and none of its search.
 *     tangents eager|lazy SCENE DEPARTURE       CSV on standard output: arrival,seconds,legs,tests,rides
 *
 * A leg that is taken starts a ride: as far as no disc stops it (all are asked), and as far as no earlier ride on the same
 * disc and side has been. Every tangent from it to every other disc is computed, and tested against all discs. In order of
 * time this is Dijkstra on a graph of O(n^2) legs, O(n^3) time. `lazy` is the strongest plain form: a leg is tested when it
 * is taken, and taken in the order of time plus the straight way left (A*). A place that an earlier rider passed is not
 * left again, though with mixed rates a later rider may find free what was blocked: in such worlds this baseline may miss a
 * path, which the library does not.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/timing.h"
#include "geom/contact.h"
#include "geom/spiral.h"
#include "geom/tangent.h"
#include "tdsp/scene_file.h"
#include "tdsp/search.h"

#define NONE 0xffffffffu
#define SAME 1e-12 /* angle or time, relative: one rider and not two */

typedef struct Leg {
    guint32 disc; /* reached; the number of discs for the destination */
    guint32 from; /* left; NONE for the source */
    int side;
    geom_line motion;
} Leg;

typedef struct Graph {
    gboolean lazy;
    guint32 count;
    geom_disc *discs; /* the last one is the destination */
    geom_disc source;
    GArray *legs;     /* of Leg: the labels' ids */
    GPtrArray *rides; /* of GArray of geom_ride, for each disc and side */
    tdsp_search *open;
    double limit, arrival;
    guint64 tests, ridden;
} Graph;

static double leg_arrival(const Leg *leg)
{
    return leg->motion.start + leg->motion.length;
}

static gboolean leg_free(Graph *graph, const Leg *leg)
{
    graph->tests++;
    for (guint32 k = 0; k < graph->count; k++)
        if (k != leg->from && k != leg->disc && line_blocked(&leg->motion, &graph->discs[k])) return FALSE;
    return TRUE;
}

static double bound(void *ctx, const tdsp_label *label)
{
    const Graph *graph = ctx;
    const Leg *leg = &g_array_index(graph->legs, Leg, label->id);
    tdsp_point place = point_along(leg->motion.from, leg->motion.length, leg->motion.heading);
    return leg->disc == graph->count ? 0 : point_distance(place, graph->discs[graph->count].center);
}

static tdsp_status push(Graph *graph, const Leg *leg)
{
    tdsp_label label = {leg_arrival(leg), graph->legs->len, 0};
    if (label.time >= graph->limit || (!graph->lazy && !leg_free(graph, leg))) return TDSP_OK;
    if (leg->disc == graph->count && !graph->lazy) graph->limit = label.time;
    g_array_append_val(graph->legs, *leg);
    return tdsp_search_push(graph->open, &label);
}

/* One tangent from a ride, if the rider comes to its departure point. */
static tdsp_status push_tangent(Graph *graph, const geom_ride *ride, const geom_pair *pair, guint32 target, int side, int root)
{
    double leave;
    geom_tangent tangent = tangent_make(pair, ride->side, side, root);
    if (!tangent_possible(&tangent) || !tangent_leave(&tangent, ride->angle, ride->start, ride->end, &leave)) return TDSP_OK;
    geom_leg taken = tangent_leg(&tangent, ride_angle(ride, leave), leave);
    Leg leg = {target, (guint32)(ride->disc - graph->discs), side, {{0, 0}, {0, 0}, leave, taken.length}};
    leg.motion.from = disc_boundary(ride->disc, taken.normal, leave);
    leg.motion.heading = point_unit(taken.heading);
    return push(graph, &leg);
}

static tdsp_status push_tangents(Graph *graph, const geom_ride *ride)
{
    tdsp_status status = TDSP_OK;
    for (guint32 j = 0; j <= graph->count && status == TDSP_OK; j++) {
        geom_pair pair = pair_make(ride->disc, &graph->discs[j]);
        gboolean goal = j == graph->count;
        if (pair.to == pair.from || !disc_ridable(pair.to)) continue;
        for (int way = goal ? 2 : 0; way < 4 && status == TDSP_OK; way++) /* two sides, two roots */
            status = push_tangent(graph, ride, &pair, j, way & 2 ? ride->side : -ride->side, way & 1 ? -1 : 1);
    }
    return status;
}

static tdsp_status push_from_source(Graph *graph, double departure)
{
    tdsp_status status = TDSP_OK;
    for (guint32 j = 0; j <= graph->count && status == TDSP_OK; j++) {
        geom_pair pair = pair_make(&graph->source, &graph->discs[j]);
        for (int side = j == graph->count ? 1 : -1; side <= 1 && disc_ridable(pair.to) && status == TDSP_OK; side += 2) {
            geom_tangent tangent = tangent_make(&pair, side, side, 1);
            Leg leg = {j, NONE, side, {graph->source.center, {0, 0}, departure, tangent_length(&tangent, departure)}};
            leg.motion.heading = point_unit(tangent_heading(&tangent, departure));
            status = push(graph, &leg);
        }
    }
    return status;
}

static double turned_between(const geom_ride *from, const geom_ride *to)
{
    double turned = angle_positive(from->side * (to->angle - from->angle));
    return turned < GEOM_TURN - SAME ? turned : 0.0;
}

/* Where an earlier ride is ahead, the rest is its own; returns FALSE when that is all. */
static gboolean cut_short(const GArray *earlier, geom_ride *ride)
{
    for (guint i = 0; i < earlier->len; i++) {
        const geom_ride *other = &g_array_index(earlier, geom_ride, i);
        double passed = other->start + spiral_duration(ride->disc, other->start, turned_between(other, ride));
        if (passed <= fmin(other->end, ride->start + SAME * (1 + ride->start))) return FALSE;
        double meets = ride->start + spiral_duration(ride->disc, ride->start, turned_between(ride, other));
        if (meets < ride->end && meets >= other->start) ride->end = meets;
    }
    return TRUE;
}

static void stop_at_discs(const Graph *graph, geom_ride *ride)
{
    double reach = disc_radius(ride->disc, ride->end);
    for (guint32 k = 0; k < graph->count; k++) {
        const geom_disc *other = &graph->discs[k];
        if (other == ride->disc) continue;
        if (point_distance(other->center, ride->disc->center) > reach + disc_radius(other, ride->end)) continue;
        double contact = ride_contact(ride, other);
        if (contact < ride->end) ride->end = contact;
    }
}

static tdsp_status expand(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    Graph *graph = ctx;
    Leg leg = g_array_index(graph->legs, Leg, label->id);
    const geom_disc *disc = &graph->discs[leg.disc];
    (void)open;
    if (leg.disc == graph->count) {
        if (graph->lazy && !leg_free(graph, &leg)) return TDSP_OK;
        graph->arrival = label->time;
        *done = 1;
        return TDSP_OK;
    }
    GArray *earlier = g_ptr_array_index(graph->rides, 2 * leg.disc + (leg.side > 0));
    double heading = atan2(leg.motion.heading.y, leg.motion.heading.x);
    geom_ride ride = {disc, leg.side, heading - leg.side * disc->theta, label->time, 0};
    ride.end = ride.start + spiral_duration(disc, ride.start, GEOM_TURN);
    if (!cut_short(earlier, &ride) || (graph->lazy && !leg_free(graph, &leg))) return TDSP_OK;
    stop_at_discs(graph, &ride);
    g_array_append_val(earlier, ride);
    graph->ridden++;
    return push_tangents(graph, &ride);
}

/* The search begins with a label that is no leg: it stands for the source. */
static tdsp_status expand_first(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    return label->kind == 1 ? push_from_source(ctx, label->time) : expand(ctx, label, open, done);
}

static double bound_first(void *ctx, const tdsp_label *label)
{
    return label->kind == 1 ? 0.0 : bound(ctx, label);
}

static void free_rides(gpointer rides)
{
    g_array_unref(rides);
}

/* Lengths in units of the journey, as the geometry wants them. Returns the unit. */
static double graph_init(Graph *graph, const tdsp_scene *scene)
{
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(scene, &count);
    const tdsp_journey *journey = tdsp_scene_journey(scene);
    double unit = point_distance(journey->source, journey->destination);
    graph->count = (guint32)count;
    graph->discs = g_new(geom_disc, count + 1);
    graph->source = disc_point(point_make(0, 0));
    for (size_t i = 0; i < count; i++) {
        tdsp_point center = point_scale(1 / unit, point_sub(discs[i].center, journey->source));
        graph->discs[i] = disc_make(center, (discs[i].radius + journey->radius) / unit, discs[i].growth / journey->speed);
    }
    graph->discs[count] = disc_point(point_scale(1 / unit, point_sub(journey->destination, journey->source)));
    graph->legs = g_array_new(FALSE, FALSE, sizeof(Leg));
    graph->rides = g_ptr_array_new_with_free_func(free_rides);
    for (size_t i = 0; i < 2 * count; i++) g_ptr_array_add(graph->rides, g_array_new(FALSE, FALSE, sizeof(geom_ride)));
    graph->limit = graph->arrival = INFINITY;
    return unit / journey->speed;
}

static void graph_clear(Graph *graph)
{
    g_free(graph->discs);
    g_array_unref(graph->legs);
    g_ptr_array_unref(graph->rides);
    tdsp_search_free(graph->open);
}

static tdsp_status solve(Graph *graph, double departure)
{
    const tdsp_search_problem problem = {sizeof problem, graph, graph->lazy ? bound_first : NULL, expand_first};
    const tdsp_label start = {departure, 0, 1};
    tdsp_status status = tdsp_search_create(NULL, &graph->open);
    return status == TDSP_OK ? tdsp_search_run(graph->open, &problem, &start, 1, NULL) : status;
}

int main(int argc, char **argv)
{
    g_auto(SceneFile) file = {0};
    g_autoptr(GError) error = NULL;
    if (argc != 4) {
        fprintf(stderr, "usage: tangents eager|lazy SCENE DEPARTURE\n");
        return 2;
    }
    if (!scene_file_load(argv[2], &file, &error)) {
        fprintf(stderr, "%s\n", error->message);
        return 1;
    }
    Graph graph = {.lazy = strcmp(argv[1], "lazy") == 0};
    double unit = graph_init(&graph, file.scene), begin = timing_now();
    tdsp_status status = solve(&graph, atof(argv[3]) / unit);
    double seconds = timing_now() - begin;
    if (status == TDSP_OK)
        printf("%.17g,%.6g,%u,%.0f,%.0f\n", graph.arrival * unit, seconds, graph.legs->len, (double)graph.tests,
               (double)graph.ridden);
    else
        fprintf(stderr, "tangents: %s\n", tdsp_status_text(status));
    graph_clear(&graph);
    return status == TDSP_OK ? 0 : 1;
}
