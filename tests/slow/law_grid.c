/* SPDX-License-Identifier: MIT */
/* Nodes are numbered row by row; the journey runs from the node (behind, aside) along the row. */
#include "slow/law_grid.h"

#include <math.h>
#include <stdlib.h>

#define REACH 4
#define SAMPLES_A_CELL 4
#define MARGIN 5e-4 /* of the journey: what a disc may come closer between two samples */

typedef struct grid {
    const tdsp_journey *journey;
    const slow_law_disc *discs;
    size_t count;
    double until;
    int cells, behind, aside, wide, high;
    double length;
    double *times;      /* the earliest arrival known at each node */
    int *heap, *places; /* nodes by time; where each is in the heap, -1 when it is not */
    int open;
} grid;

static tdsp_point node_point(const grid *g, int node)
{
    const tdsp_journey *j = g->journey;
    const double along = (double)(node % g->wide - g->behind) / g->cells, across = (double)(node / g->wide - g->aside) / g->cells;
    const double dx = j->destination.x - j->source.x, dy = j->destination.y - j->source.y;
    return (tdsp_point){j->source.x + along * dx - across * dy, j->source.y + along * dy + across * dx};
}

static int clear_of(const grid *g, const slow_law_disc *disc, tdsp_point at, double time, double margin)
{
    size_t piece = 0;
    while (piece < disc->break_count && disc->breaks[piece] < time) piece++;
    const double radius = disc->jet(disc->ctx, piece, time).radius + g->journey->radius;
    return hypot(at.x - disc->center.x, at.y - disc->center.y) >= radius + margin * g->length;
}

static int all_clear(const grid *g, tdsp_point at, double time, double margin)
{
    for (size_t i = 0; i < g->count; i++)
        if (!clear_of(g, &g->discs[i], at, time, margin)) return 0;
    return 1;
}

static int step_clear(const grid *g, tdsp_point a, tdsp_point b, double begin, double end, int samples)
{
    if (end > g->until) return 0;
    for (int i = 0; i <= samples; i++) {
        const double share = (double)i / samples;
        const tdsp_point at = {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
        if (!all_clear(g, at, begin + share * (end - begin), MARGIN)) return 0;
    }
    return 1;
}

static void heap_put(grid *g, int place, int node)
{
    g->heap[place] = node;
    g->places[node] = place;
}

static void heap_rise(grid *g, int node)
{
    int at = g->places[node];
    while (at > 0 && g->times[g->heap[(at - 1) / 2]] > g->times[node]) {
        heap_put(g, at, g->heap[(at - 1) / 2]);
        at = (at - 1) / 2;
    }
    heap_put(g, at, node);
}

static int heap_take(grid *g)
{
    const int taken = g->heap[0], moved = g->heap[--g->open];
    int at = 0;
    for (int child = 1; child < g->open; child = 2 * at + 1) {
        if (child + 1 < g->open && g->times[g->heap[child + 1]] < g->times[g->heap[child]]) child++;
        if (g->times[g->heap[child]] >= g->times[moved]) break;
        heap_put(g, at, g->heap[child]);
        at = child;
    }
    if (g->open > 0) heap_put(g, at, moved);
    g->places[taken] = -1;
    return taken;
}

static void offer(grid *g, int node, double time)
{
    if (time >= g->times[node]) return;
    g->times[node] = time;
    if (g->places[node] < 0) heap_put(g, g->open++, node);
    heap_rise(g, node);
}

static int common_factor(int a, int b)
{
    while (b) {
        const int rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

static void settle(grid *g, int node)
{
    const int x = node % g->wide, y = node / g->wide;
    const tdsp_point a = node_point(g, node);
    for (int dy = -REACH; dy <= REACH; dy++)
        for (int dx = -REACH; dx <= REACH; dx++) {
            if (common_factor(abs(dx), abs(dy)) != 1) continue;
            if (x + dx < 0 || x + dx >= g->wide || y + dy < 0 || y + dy >= g->high) continue;
            const int to = (y + dy) * g->wide + x + dx;
            const tdsp_point b = node_point(g, to);
            const double end = g->times[node] + hypot(b.x - a.x, b.y - a.y) / g->journey->speed;
            if (end < g->times[to] && step_clear(g, a, b, g->times[node], end, SAMPLES_A_CELL * (abs(dx) + abs(dy))))
                offer(g, to, end);
        }
}

static double run(grid *g, double departure)
{
    const int nodes = g->wide * g->high, source = g->aside * g->wide + g->behind, destination = source + g->cells;
    for (int i = 0; i < nodes; i++) {
        g->times[i] = INFINITY;
        g->places[i] = -1;
    }
    offer(g, source, departure);
    while (g->open > 0) {
        const int node = heap_take(g);
        if (node == destination) return g->times[node];
        settle(g, node);
    }
    return INFINITY;
}

double slow_law_grid(const tdsp_journey *journey, const slow_law_disc *discs, size_t count, double until, double departure,
                     int cells)
{
    grid g = {.journey = journey, .discs = discs, .count = count, .until = until, .cells = cells};
    g.behind = g.aside = cells;
    g.wide = 3 * cells + 1;
    g.high = 2 * cells + 1;
    g.length = hypot(journey->destination.x - journey->source.x, journey->destination.y - journey->source.y);
    const size_t nodes = (size_t)g.wide * (size_t)g.high;
    g.times = malloc(nodes * sizeof *g.times);
    g.heap = malloc(nodes * sizeof *g.heap);
    g.places = malloc(nodes * sizeof *g.places);
    const double arrival = g.times && g.heap && g.places ? run(&g, departure) : NAN;
    free(g.times);
    free(g.heap);
    free(g.places);
    return arrival;
}
