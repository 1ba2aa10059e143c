/* SPDX-License-Identifier: MIT */
/*
 * The public search on a graph of bytes: Dijkstra and A* must find the distances that relaxing all edges until nothing changes finds, whatever the order of labels, and come
 * back with what `expand` returns. Bounds that break their promise, times that are no numbers and limits must do no worse than lose labels.
 */
#include <math.h>

#include "input.h"
#include "tdsp/search.h"

enum { NODES = 12, EDGES = 40 };

typedef struct graph {
    unsigned from[EDGES], to[EDGES];
    double length[EDGES];
    size_t edges;
    double best[NODES]; /* as settled */
    double bound[NODES];
    unsigned fails;  /* the expansion that fails; 0: none */
    unsigned calls;
    unsigned limits; /* the expansion that sets a limit */
} graph;

static double graph_bound(void *ctx, const tdsp_label *label)
{
    const graph *g = ctx;
    return g->bound[label->id];
}

static tdsp_status graph_expand(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    graph *g = ctx;
    (void)done;
    fuzz_require(label->id < NODES, "a label that nobody pushed");
    if (++g->calls == g->fails) return TDSP_FAILED;
    if (label->time >= g->best[label->id]) return TDSP_OK;
    g->best[label->id] = label->time;
    if (g->calls == g->limits) tdsp_search_limit(open, label->time);
    for (size_t i = 0; i < g->edges; i++) {
        if (g->from[i] != label->id) continue;
        const tdsp_label next = {label->time + g->length[i], g->to[i], g->calls};
        const tdsp_status status = tdsp_search_push(open, &next);
        fuzz_require(status == (isnan(next.time) ? TDSP_INVALID_ARGUMENT : TDSP_OK), "a push with another status");
    }
    return TDSP_OK;
}

static void graph_read(graph *g, fuzz_input *in)
{
    const unsigned odd = input_byte(in);
    *g = (graph){.fails = odd & 1u ? input_byte(in) : 0, .limits = odd & 2u ? input_byte(in) : 0};
    for (int i = 0; i < NODES; i++) {
        g->best[i] = INFINITY;
        g->bound[i] = odd & 4u ? (double)input_byte(in) / 16.0 : 0.0;
    }
    while (g->edges < EDGES && input_left(in)) {
        const unsigned ends = input_byte(in), length = input_byte(in);
        g->from[g->edges] = (ends & 15u) % NODES;
        g->to[g->edges] = (ends >> 4) % NODES;
        g->length[g->edges++] = odd & 8u && length == 255 ? NAN : odd & 8u && length == 254 ? INFINITY : (double)length / 8.0;
    }
}

/* By Bellman and Ford. */
static void graph_relax(const graph *g, double best[NODES])
{
    for (int i = 0; i < NODES; i++) best[i] = i ? INFINITY : 0.0;
    for (int round = 0; round < NODES; round++)
        for (size_t i = 0; i < g->edges; i++)
            if (best[g->from[i]] + g->length[i] < best[g->to[i]]) best[g->to[i]] = best[g->from[i]] + g->length[i];
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    fuzz_input in = {data, size, 0};
    graph g;
    graph_read(&g, &in);
    tdsp_search *search = NULL;
    const tdsp_search_problem problem = {sizeof problem, &g, graph_bound, graph_expand};
    const tdsp_label start = {0.0, 0, 0};
    double best[NODES];
    int done = 7;
    fuzz_require(tdsp_search_create(NULL, &search) == TDSP_OK, "no search");
    const tdsp_status status = tdsp_search_run(search, &problem, &start, 1, &done);
    const int has_failed = g.fails && g.calls >= g.fails;
    fuzz_require(status == (has_failed ? TDSP_FAILED : TDSP_OK), "a run with another status");
    fuzz_require(has_failed || done == 0, "an end that nobody called");
    graph_relax(&g, best);
    for (int i = 0; i < NODES && !has_failed && !g.limits; i++) fuzz_require(g.best[i] == best[i] || (isinf(best[i]) && isinf(g.best[i])), "another distance");
    tdsp_search_free(search);
    return 0;
}
