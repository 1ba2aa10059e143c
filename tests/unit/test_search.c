/* SPDX-License-Identifier: MIT */
/* The label-setting loop on graphs, against Bellman and Ford's relaxation of every edge, and its errors. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/chance.h"
#include "support/tight.h"
#include "tdsp/search.h"

enum { NODES = 60, EDGES = 400 };

typedef struct edge {
    uint32_t from, to;
    double length;
} edge;

typedef struct graph {
    uint32_t nodes;
    uint32_t edges;
    edge edge[EDGES];
    double distance[NODES]; /* from node 0 */
    double to_goal[NODES];
    /* of the run */
    double reached[NODES];
    double last_key;
    double scale; /* of the bound: a share of the true distance to the goal */
    uint32_t goal;
    uint32_t expanded;
    tdsp_status fail_with;
    uint32_t fail_after;
} graph;

static double goal_bound(void *ctx, const tdsp_label *label)
{
    const graph *g = ctx;
    return g->scale * fmin(g->to_goal[label->id], 1e6);
}

static tdsp_status expand(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    graph *g = ctx;
    double key = label->time + goal_bound(g, label);
    assert_true(key >= g->last_key - 1e-9);
    g->last_key = key;
    if (++g->expanded > g->fail_after) return g->fail_with;
    if (label->time >= g->reached[label->id]) return TDSP_OK;
    g->reached[label->id] = label->time;
    *done = label->id == g->goal;
    for (uint32_t e = 0; e < g->edges && !*done; ++e) {
        if (g->edge[e].from != label->id) continue;
        tdsp_label next = {label->time + g->edge[e].length, g->edge[e].to, 0};
        tdsp_status status = tdsp_search_push(open, &next);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}

static void bellman_ford(const graph *g, uint32_t from, int backwards, double *distance)
{
    for (uint32_t i = 0; i < g->nodes; ++i) distance[i] = i == from ? 0.0 : INFINITY;
    for (uint32_t round = 0; round < g->nodes; ++round)
        for (uint32_t e = 0; e < g->edges; ++e) {
            uint32_t a = backwards ? g->edge[e].to : g->edge[e].from, b = backwards ? g->edge[e].from : g->edge[e].to;
            distance[b] = fmin(distance[b], distance[a] + g->edge[e].length);
        }
}

static void graph_make(graph *g, uint64_t *chance)
{
    memset(g, 0, sizeof *g);
    g->nodes = 2 + (uint32_t)chance_below(chance, NODES - 1);
    g->edges = (uint32_t)chance_below(chance, EDGES);
    g->goal = g->nodes - 1;
    g->fail_after = UINT32_MAX;
    for (uint32_t e = 0; e < g->edges; ++e) {
        edge made = {(uint32_t)chance_below(chance, g->nodes), (uint32_t)chance_below(chance, g->nodes), (double)chance_below(chance, 20)};
        g->edge[e] = made;
    }
    bellman_ford(g, 0, 0, g->distance);
    bellman_ford(g, g->goal, 1, g->to_goal);
}

static void graph_forget(graph *g, double scale, uint32_t goal)
{
    for (uint32_t i = 0; i < NODES; ++i) g->reached[i] = INFINITY;
    g->last_key = -INFINITY;
    g->scale = scale;
    g->goal = goal;
    g->expanded = 0;
}

static const tdsp_label origin = {0.0, 0, 0};

static void dijkstra_finds_the_distances_of_bellman_and_ford(void **state)
{
    (void)state;
    static graph g;
    uint64_t chance = 1;
    tdsp_search *search;
    assert_int_equal(tdsp_search_create(NULL, &search), TDSP_OK);
    for (int k = 0; k < 500; ++k) {
        int done = 7;
        graph_make(&g, &chance);
        graph_forget(&g, 0.0, UINT32_MAX);
        tdsp_search_problem problem = {sizeof problem, &g, NULL, expand};
        assert_int_equal(tdsp_search_run(search, &problem, &origin, 1, &done), TDSP_OK);
        assert_int_equal(done, 0);
        for (uint32_t i = 0; i < g.nodes; ++i) assert_exact(g.reached[i], g.distance[i]);
    }
    tdsp_search_free(search);
}

static void a_consistent_bound_finds_the_same_with_less_work(void **state)
{
    (void)state;
    static graph g;
    uint64_t chance = 2;
    uint32_t blind = 0, guided = 0;
    tdsp_search *search;
    assert_int_equal(tdsp_search_create(NULL, &search), TDSP_OK);
    for (int k = 0; k < 500; ++k) {
        static const double shares[3] = {0.0, 0.5, 1.0};
        graph_make(&g, &chance);
        for (int i = 0; i < 3; ++i) {
            int done = 7;
            graph_forget(&g, shares[i], g.nodes - 1);
            tdsp_search_problem problem = {sizeof problem, &g, goal_bound, expand};
            assert_int_equal(tdsp_search_run(search, &problem, &origin, 1, &done), TDSP_OK);
            assert_int_equal(done, isfinite(g.distance[g.goal]));
            assert_exact(g.reached[g.goal], g.distance[g.goal]);
            if (i == 0) blind += g.expanded;
            if (i == 2) guided += g.expanded;
        }
    }
    assert_true(guided < blind);
    tdsp_search_free(search);
}

static void several_starts_are_taken_together(void **state)
{
    (void)state;
    static graph g;
    uint64_t chance = 3;
    tdsp_search *search;
    assert_int_equal(tdsp_search_create(NULL, &search), TDSP_OK);
    for (int k = 0; k < 200; ++k) {
        double other[NODES];
        graph_make(&g, &chance);
        const tdsp_label starts[2] = {{5.0, 0, 0}, {2.0, g.nodes - 1, 0}};
        bellman_ford(&g, g.nodes - 1, 0, other);
        graph_forget(&g, 0.0, UINT32_MAX);
        tdsp_search_problem problem = {sizeof problem, &g, NULL, expand};
        assert_int_equal(tdsp_search_run(search, &problem, starts, 2, NULL), TDSP_OK);
        for (uint32_t i = 0; i < g.nodes; ++i) assert_exact(g.reached[i], fmin(5.0 + g.distance[i], 2.0 + other[i]));
    }
    tdsp_search_free(search);
}

typedef struct served {
    uint32_t ids[100];
    size_t count;
    double limit_at_first;
} served;

static tdsp_status serve(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    served *s = ctx;
    (void)done;
    if (s->count == 0 && s->limit_at_first > 0.0) tdsp_search_limit(open, s->limit_at_first);
    s->ids[s->count++] = label->id;
    for (uint32_t i = 1; label->kind == 1 && i < 20; ++i) {
        tdsp_label next = {label->time + (i % 4), i, 0};
        assert_int_equal(tdsp_search_push(open, &next), TDSP_OK);
    }
    return TDSP_OK;
}

static void ties_are_served_in_the_order_of_their_pushes(void **state)
{
    (void)state;
    static const uint32_t order[20] = {0, 4, 8, 12, 16, 1, 5, 9, 13, 17, 2, 6, 10, 14, 18, 3, 7, 11, 15, 19};
    served s = {{0}, 0, 0.0};
    tdsp_search *search;
    const tdsp_label start = {1.0, 0, 1};
    const tdsp_search_problem problem = {sizeof problem, &s, NULL, serve};
    assert_int_equal(tdsp_search_create(NULL, &search), TDSP_OK);
    assert_int_equal(tdsp_search_run(search, &problem, &start, 1, NULL), TDSP_OK);
    assert_int_equal(s.count, 20);
    assert_memory_equal(s.ids, order, sizeof order);
    tdsp_search_free(search);
}

static void labels_over_the_limit_are_dropped_until_the_end_of_the_run(void **state)
{
    (void)state;
    served s = {{0}, 0, 2.0};
    tdsp_search *search;
    const tdsp_label start = {1.0, 0, 1};
    const tdsp_search_problem problem = {sizeof problem, &s, NULL, serve};
    assert_int_equal(tdsp_search_create(NULL, &search), TDSP_OK);
    assert_int_equal(tdsp_search_run(search, &problem, &start, 1, NULL), TDSP_OK);
    assert_int_equal(s.count, 10); /* at 1 and at 2, not at 3 and 4 */
    s.count = 0;
    s.limit_at_first = 0.0;
    assert_int_equal(tdsp_search_run(search, &problem, &start, 1, NULL), TDSP_OK);
    assert_int_equal(s.count, 20);
    tdsp_search_free(search);
}

static void an_error_of_expand_ends_the_run_and_leaves_done_alone(void **state)
{
    (void)state;
    static graph g;
    uint64_t chance = 4;
    tdsp_search *search;
    int done = 7;
    assert_int_equal(tdsp_search_create(NULL, &search), TDSP_OK);
    do graph_make(&g, &chance);
    while (g.edges < 300);
    tdsp_search_problem problem = {sizeof problem, &g, NULL, expand};
    for (uint32_t after = 0; after < 5; ++after) {
        graph_forget(&g, 0.0, UINT32_MAX);
        g.fail_after = after;
        g.fail_with = after % 2 ? TDSP_FAILED : TDSP_CUT_OFF;
        assert_int_equal(tdsp_search_run(search, &problem, &origin, 1, &done), g.fail_with);
        assert_int_equal(g.expanded, after + 1);
        assert_int_equal(done, 7);
    }
    graph_forget(&g, 0.0, UINT32_MAX);
    g.fail_after = UINT32_MAX;
    assert_int_equal(tdsp_search_run(search, &problem, &origin, 1, &done), TDSP_OK);
    assert_exact(g.reached[g.nodes - 1], g.distance[g.nodes - 1]);
    tdsp_search_free(search);
}

static double bound_nan(void *ctx, const tdsp_label *label)
{
    (void)ctx;
    (void)label;
    return NAN;
}

static void bad_arguments_are_refused(void **state)
{
    (void)state;
    served s = {{0}, 0, 0.0};
    tdsp_search *search;
    const tdsp_label nan = {NAN, 0, 0};
    const tdsp_search_problem good = {sizeof good, &s, NULL, serve}, old = {sizeof good - 1, &s, NULL, serve};
    const tdsp_search_problem empty = {sizeof good, &s, NULL, NULL}, lost = {sizeof good, &s, bound_nan, serve};
    assert_int_equal(tdsp_search_create(NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_search_create(NULL, &search), TDSP_OK);
    assert_int_equal(tdsp_search_run(NULL, &good, &origin, 1, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_search_run(search, NULL, &origin, 1, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_search_run(search, &old, &origin, 1, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_search_run(search, &empty, &origin, 1, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_search_run(search, &good, NULL, 1, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_search_run(search, &good, &nan, 1, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_search_run(search, &good, (tdsp_label[]){nan, origin}, 2, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_search_run(search, &lost, &origin, 1, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(s.count, 0);
    tdsp_search_free(search);
}

static void pushing_outside_a_run_is_refused(void **state)
{
    (void)state;
    tdsp_search *search;
    assert_int_equal(tdsp_search_create(NULL, &search), TDSP_OK);
    assert_int_equal(tdsp_search_push(search, &origin), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_search_push(NULL, &origin), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_search_push(search, NULL), TDSP_INVALID_ARGUMENT);
    tdsp_search_free(search);
}

static void a_run_without_starts_ends_at_once(void **state)
{
    (void)state;
    served s = {{0}, 0, 0.0};
    tdsp_search *search;
    int done = 7;
    const tdsp_search_problem problem = {sizeof problem, &s, NULL, serve};
    assert_int_equal(tdsp_search_create(NULL, &search), TDSP_OK);
    assert_int_equal(tdsp_search_run(search, &problem, NULL, 0, &done), TDSP_OK);
    assert_int_equal(done, 0);
    assert_int_equal(s.count, 0);
    tdsp_search_free(search);
    tdsp_search_free(NULL);
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    tight_heap heap = {.refuse = 1};
    tdsp_allocator memory = tight_allocator(&heap);
    tdsp_search *search = NULL;
    served s = {{0}, 0, 0.0};
    const tdsp_label start = {1.0, 0, 1};
    const tdsp_search_problem problem = {sizeof problem, &s, NULL, serve};
    assert_int_equal(tdsp_search_create(&memory, &search), TDSP_NO_MEMORY);
    assert_null(search);
    assert_int_equal(tdsp_search_create(&memory, &search), TDSP_OK);
    heap.refuse = heap.calls + 1;
    assert_int_equal(tdsp_search_run(search, &problem, &start, 1, NULL), TDSP_NO_MEMORY);
    assert_int_equal(s.count, 0);
    assert_int_equal(tdsp_search_run(search, &problem, &start, 1, NULL), TDSP_OK);
    assert_int_equal(s.count, 20);
    tdsp_search_free(search);
    assert_int_equal(heap.blocks, 0);
    assert_int_equal(heap.held, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dijkstra_finds_the_distances_of_bellman_and_ford),
        cmocka_unit_test(a_consistent_bound_finds_the_same_with_less_work),
        cmocka_unit_test(several_starts_are_taken_together),
        cmocka_unit_test(ties_are_served_in_the_order_of_their_pushes),
        cmocka_unit_test(labels_over_the_limit_are_dropped_until_the_end_of_the_run),
        cmocka_unit_test(an_error_of_expand_ends_the_run_and_leaves_done_alone),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(pushing_outside_a_run_is_refused),
        cmocka_unit_test(a_run_without_starts_ends_at_once),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
