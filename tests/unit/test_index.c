/* SPDX-License-Identifier: MIT */
/* The index against looking at every disc. */
#include "support/cmocka_all.h"

#include <stdlib.h>
#include <string.h>

#include "geom/spiral.h"
#include "scene/index.h"
#include "support/chance.h"
#include "support/tight.h"

enum { MOST = 400 };

typedef struct world {
    geom_disc discs[MOST];
    geom_disc reverse[MOST];
    geom_disc spare[MOST];
    geom_disc given_discs[MOST]; /* as they were before the index ordered them */
    uint32_t given[MOST];
    uint32_t count;
    scene_index index;
    tdsp_allocator memory;
} world;

enum { KINDS = 7 };

/* Spread out, in clusters, all in one place, in a row, spread out again, clusters nested in clusters, the same so deep that halving by place would not end; rates alike or not. */
static geom_disc random_disc(uint64_t *chance, int kind)
{
    tdsp_point place = point_make(chance_between(chance, -10.0, 10.0), chance_between(chance, -10.0, 10.0));
    if (kind == 1) place = point_make(floor(place.x / 5.0) + 0.05 * place.y, floor(place.y / 5.0));
    if (kind == 2) place = point_make(1.0, 1.0);
    if (kind == 3) place.y = 0.0;
    if (kind == 5) place = point_scale(ldexp(1.0, -(int)chance_below(chance, 300)), place);
    if (kind == 6) {
        const double scale = ldexp(1.0, -(int)chance_below(chance, 140));
        return disc_make(point_make(scale, 0.0), 0.25 * scale, 0.0);
    }
    double rate = kind % 2 ? 0.2 : chance_between(chance, 0.0, 1.3);
    return disc_make(place, chance_between(chance, 0.0, 0.6), rate);
}

static world *world_make(uint64_t *chance, uint32_t count, int kind)
{
    world *w = calloc(1, sizeof *w);
    assert_non_null(w);
    w->count = count;
    w->memory = memory_allocator(NULL);
    for (uint32_t i = 0; i < count; ++i) {
        w->discs[i] = w->given_discs[i] = random_disc(chance, kind);
        w->given[i] = i;
    }
    index_items items = {w->discs, w->given, w->spare, count};
    assert_int_equal(index_build(&w->index, &w->memory, items), TDSP_OK);
    for (uint32_t i = 0; i < count; ++i) w->reverse[i] = disc_make(w->discs[i].center, w->discs[i].radius, -w->discs[i].rate);
    return w;
}

static void world_free(world *w)
{
    index_free(&w->index, &w->memory);
    free(w);
}

static index_view view_of(const world *w, int sign)
{
    index_view view = {&w->index, sign > 0 ? w->discs : w->reverse, sign};
    return view;
}

static void each_world(uint64_t seed, void (*check)(const world *w, uint64_t *chance))
{
    static const uint32_t counts[] = {0, 1, 2, 4, 5, 17, 100, 400};
    uint64_t chance = seed;
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; ++i)
        for (int kind = 0; kind < KINDS; ++kind) {
            world *w = world_make(&chance, counts[i], kind);
            check(w, &chance);
            world_free(w);
        }
}

static void check_items(const world *w, uint64_t *chance)
{
    unsigned char seen[MOST] = {0};
    (void)chance;
    for (uint32_t i = 0; i < w->count; ++i) {
        assert_true(w->given[i] < w->count && !seen[w->given[i]]);
        seen[w->given[i]] = 1;
        assert_memory_equal(&w->discs[i], &w->given_discs[w->given[i]], sizeof w->discs[i]);
    }
}

static void every_disc_keeps_its_name(void **state)
{
    (void)state;
    each_world(1, check_items);
}

/* As it is at time 0, in the node's box and in its circle; and no faster. */
static void assert_inside(const index_node *node, const geom_disc *disc)
{
    tdsp_point from = point_sub(disc->center, node->middle);
    assert_true(fabs(from.x) + disc->radius <= node->half_x && fabs(from.y) + disc->radius <= node->half_y);
    assert_true(point_length(from) + disc->radius <= node->half);
    assert_true(disc->rate <= node->rate);
    assert_exact(index_node_distance(node, disc->center), 0.0);
}

/* The first disc after those below the node, which is `depth` nodes below the root. */
static uint32_t check_node_below(const scene_index *index, const geom_disc *discs, uint32_t self, uint32_t first, int depth)
{
    const index_node *node = &index->nodes[self];
    uint32_t last = first + node->count;
    assert_true(self < index->node_count && depth < INDEX_DEPTH && node->count <= INDEX_LEAF);
    assert_int_equal(node->first, first);
    if (node->count == 0) {
        last = check_node_below(index, discs, self + 1, first, depth + 1);
        last = check_node_below(index, discs, node->right, last, depth + 1);
    }
    assert_true(last > first);
    for (uint32_t i = first; i < last; ++i) {
        assert_inside(node, &discs[i]);
    }
    return last;
}

static uint32_t check_node(const scene_index *index, const geom_disc *discs, uint32_t self, uint32_t first)
{
    return check_node_below(index, discs, self, first, 0);
}

static void check_tree(const world *w, uint64_t *chance)
{
    (void)chance;
    if (w->count) assert_int_equal(check_node(&w->index, w->discs, 0, 0), w->count);
    if (!w->count) assert_int_equal(w->index.node_count, 0);
}

static void every_node_bounds_what_is_below_it(void **state)
{
    (void)state;
    each_world(2, check_tree);
}

static void check_node_distance(const world *w, uint64_t *chance)
{
    for (uint32_t k = 0; k < w->index.node_count; ++k) {
        const index_node *node = &w->index.nodes[k];
        tdsp_point place = point_make(chance_between(chance, -15.0, 15.0), chance_between(chance, -15.0, 15.0));
        tdsp_point low = point_make(node->middle.x - node->half_x, node->middle.y - node->half_y);
        tdsp_point high = point_make(node->middle.x + node->half_x, node->middle.y + node->half_y);
        tdsp_point nearest = point_make(fmin(fmax(place.x, low.x), high.x), fmin(fmax(place.y, low.y), high.y));
        assert_near(index_node_distance(node, place), point_distance(place, nearest), 1e-12);
    }
}

static void the_distance_to_a_box_is_that_to_its_nearest_point(void **state)
{
    (void)state;
    each_world(3, check_node_distance);
}

typedef struct visits {
    unsigned char seen[MOST];
    uint32_t count;
    uint32_t stop_after;
} visits;

static int visit(void *ctx, uint32_t disc)
{
    visits *v = ctx;
    assert_int_equal(v->seen[disc], 0);
    v->seen[disc] = 1;
    return ++v->count != v->stop_after;
}

static geom_line random_line(uint64_t *chance, int sign)
{
    double start = sign * chance_between(chance, 0.0, 3.0);
    if (sign < 0) start -= 5.0;
    geom_line line = {point_make(chance_between(chance, -12.0, 12.0), chance_between(chance, -12.0, 12.0)),
                      point_unit(chance_between(chance, -3.2, 3.2)), start, chance_between(chance, 0.0, 5.0)};
    return line;
}

static void check_line(const world *w, const index_view *view, const geom_line *line, uint32_t skip, uint32_t other)
{
    visits v = {{0}, 0, 0};
    uint32_t blocked = 0;
    double first = INFINITY, length;
    index_line_visit(view, line, skip, other, visit, &v);
    for (uint32_t i = 0; i < w->count; ++i) {
        int meets = line_blocked(line, &view->discs[i]) && i != skip && i != other;
        assert_int_equal(v.seen[i], meets);
        blocked += (uint32_t)meets;
        if (i != skip) first = fmin(first, line_first_contact(line, &view->discs[i]));
    }
    assert_int_equal(index_line_blocked(view, line, skip, other) != 0, blocked > 0);
    uint32_t disc = index_line_first(view, line, skip, &length);
    assert_exact(length, first);
    assert_int_equal(disc == INDEX_NONE, isinf(first));
    if (disc != INDEX_NONE) assert_exact(line_first_contact(line, &view->discs[disc]), first);
}

static void check_lines(const world *w, uint64_t *chance)
{
    for (int k = 0; k < 200; ++k) {
        int sign = k % 2 ? 1 : -1;
        index_view view = view_of(w, sign);
        geom_line line = random_line(chance, sign);
        uint32_t skip = w->count ? (uint32_t)chance_below(chance, w->count) : INDEX_NONE;
        check_line(w, &view, &line, skip, k % 3 && w->count ? (uint32_t)chance_below(chance, w->count) : INDEX_NONE);
        check_line(w, &view, &line, INDEX_NONE, INDEX_NONE);
    }
}

static void straight_motions_meet_what_looking_at_every_disc_finds(void **state)
{
    (void)state;
    each_world(4, check_lines);
}

static void check_ride(const world *w, const index_view *view, const geom_ride *ride, uint32_t self)
{
    visits v = {{0}, 0, 0};
    double first = INFINITY;
    index_ride_visit(view, ride, self, visit, &v);
    for (uint32_t i = 0; i < w->count; ++i) {
        double contact = i == self ? INFINITY : ride_contact(ride, &view->discs[i]);
        assert_int_equal(v.seen[i], !isinf(contact));
        first = fmin(first, contact);
    }
    assert_near(index_ride_contact(view, ride, self), first, 1e-8);
}

static void check_rides(const world *w, uint64_t *chance)
{
    for (int k = 0; k < 200 && w->count; ++k) {
        int sign = k % 2 ? 1 : -1;
        index_view view = view_of(w, sign);
        uint32_t self = (uint32_t)chance_below(chance, w->count);
        const geom_disc *disc = &view.discs[self];
        double start = sign * chance_between(chance, 0.0, 3.0) - (sign < 0 ? 3.0 : 0.0);
        if (!disc_ridable(disc) || disc_radius(disc, start) < 1e-3) continue;
        geom_ride ride = {disc, k % 4 < 2 ? 1 : -1, chance_between(chance, -3.0, 3.0), start,
                          start + spiral_duration(disc, start, 0.25)};
        check_ride(w, &view, &ride, self);
    }
}

static void rides_meet_what_looking_at_every_disc_finds(void **state)
{
    (void)state;
    each_world(5, check_rides);
}

static void check_near(const world *w, uint64_t *chance)
{
    for (int k = 0; k < 100; ++k) {
        index_view view = view_of(w, 1);
        tdsp_point place = point_make(chance_between(chance, -12.0, 12.0), chance_between(chance, -12.0, 12.0));
        double margin = chance_between(chance, 0.0, 2.0), time = chance_between(chance, 0.0, 2.0);
        visits v = {{0}, 0, 0};
        index_near(&view, place, margin, time, visit, &v);
        for (uint32_t i = 0; i < w->count; ++i)
            if (point_distance(place, w->discs[i].center) <= margin + disc_radius(&w->discs[i], time))
                assert_int_equal(v.seen[i], 1);
    }
}

static void everything_near_is_visited_once(void **state)
{
    (void)state;
    each_world(6, check_near);
}

static void far_things_are_not_looked_at(void **state)
{
    (void)state;
    uint64_t chance = 7;
    world *w = world_make(&chance, 400, 1);
    index_view view = view_of(w, 1);
    visits v = {{0}, 0, 0};
    index_near(&view, point_make(1000.0, 0.0), 1.0, 1.0, visit, &v);
    assert_int_equal(v.count, 0);
    index_near(&view, point_make(-1.5, -1.0), 0.1, 0.0, visit, &v);
    assert_true(v.count < 200);
    world_free(w);
}

static void a_visit_that_returns_0_is_the_last(void **state)
{
    (void)state;
    uint64_t chance = 8;
    world *w = world_make(&chance, 100, 2);
    index_view view = view_of(w, 1);
    geom_line line = {point_make(-5.0, 1.0), point_make(1.0, 0.0), 0.0, 10.0};
    geom_disc ridden = disc_make(point_make(0.0, 1.0), 1.0, 0.0);
    geom_ride ride = {&ridden, 1, -1.0, 0.0, 1.0};
    for (uint32_t stop = 1; stop < 4; ++stop) {
        visits a = {{0}, 0, stop}, b = a, c = a;
        index_line_visit(&view, &line, INDEX_NONE, INDEX_NONE, visit, &a);
        index_near(&view, point_make(1.0, 1.0), 1.0, 0.0, visit, &b);
        index_ride_visit(&view, &ride, INDEX_NONE, visit, &c);
        assert_int_equal(a.count, stop);
        assert_int_equal(b.count, stop);
        assert_int_equal(c.count, stop);
    }
    world_free(w);
}

static void the_same_discs_are_ordered_in_the_same_way(void **state)
{
    (void)state;
    for (int kind = 0; kind < KINDS; ++kind) {
        uint64_t a = 9, b = 9;
        world *one = world_make(&a, 300, kind), *two = world_make(&b, 300, kind);
        assert_memory_equal(one->given, two->given, sizeof one->given);
        world_free(one);
        world_free(two);
    }
}

static void building_again_uses_the_memory_again(void **state)
{
    (void)state;
    uint64_t chance = 10;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    world *w = world_make(&chance, 300, 0);
    scene_index index = {0};
    size_t calls = 0;
    for (uint32_t count = 300; count > 0; count /= 2) {
        index_items items = {w->discs, w->given, w->spare, count};
        assert_int_equal(index_build(&index, &memory, items), TDSP_OK);
        assert_int_equal(check_node(&index, w->discs, 0, 0), count);
        if (count < 300) assert_int_equal(heap.calls, calls);
        calls = heap.calls;
    }
    index_free(&index, &memory);
    assert_int_equal(heap.held, 0);
    world_free(w);
}

/* A field of small still discs, and one that is not. */
static world *world_with_one(double radius, double rate)
{
    world *w = calloc(1, sizeof *w);
    assert_non_null(w);
    w->count = MOST;
    w->memory = memory_allocator(NULL);
    for (uint32_t i = 0; i < MOST; ++i) {
        w->discs[i] = disc_make(point_make(i % 20, i / 20), 0.2, 0.01);
        w->given[i] = i;
    }
    w->discs[MOST / 2] = disc_make(point_make(7.3, 11.2), radius, rate);
    index_items items = {w->discs, w->given, w->spare, w->count};
    assert_int_equal(index_build(&w->index, &w->memory, items), TDSP_OK);
    return w;
}

static void a_large_disc_and_a_fast_one_get_a_branch_of_their_own(void **state)
{
    (void)state;
    world *large = world_with_one(30.0, 0.01), *fast = world_with_one(0.2, 100.0);
    uint32_t blown_up = 0, hurried = 0;
    for (uint32_t k = 0; k < large->index.node_count; ++k) blown_up += large->index.nodes[k].half_x >= 30.0f;
    assert_int_equal(blown_up, 2); /* the root and a leaf */
    for (uint32_t k = 0; k < fast->index.node_count; ++k) hurried += fast->index.nodes[k].rate > 1.0f;
    assert_int_equal(hurried, 2);
    world_free(large);
    world_free(fast);
}

static void a_rate_beyond_floats_reaches_everywhere_at_once(void **state)
{
    (void)state;
    world *w = world_with_one(0.2, 1e200);
    index_view view = view_of(w, 1);
    visits v = {{0}, 0, 0};
    uint32_t fast = 0;
    while (w->discs[fast].rate < 1e200) ++fast;
    index_near(&view, point_make(-1e12, 1e12), 0.0, 1e-180, visit, &v);
    assert_int_equal(v.seen[fast], 1);
    geom_line line = {point_make(-500.0, 500.0), point_make(1.0, 0.0), 0.0, 1.0};
    assert_int_equal(index_line_blocked(&view, &line, INDEX_NONE, INDEX_NONE), 1);
    world_free(w);
}

static void trimming_gives_back_what_only_building_needs(void **state)
{
    (void)state;
    uint64_t chance = 11;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    world *w = world_make(&chance, 300, 0);
    scene_index index = {0};
    index_items items = {w->discs, w->given, w->spare, w->count};
    assert_int_equal(index_build(&index, &memory, items), TDSP_OK);
    assert_int_equal(heap.held, index_bytes(&index));
    assert_int_equal(index_trim(&index, &memory), TDSP_OK);
    assert_int_equal(heap.held, index.node_count * sizeof *index.nodes);
    assert_int_equal(check_node(&index, w->discs, 0, 0), 300);
    index_free(&index, &memory);
    assert_int_equal(heap.held, 0);
    world_free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_disc_keeps_its_name),
        cmocka_unit_test(every_node_bounds_what_is_below_it),
        cmocka_unit_test(the_distance_to_a_box_is_that_to_its_nearest_point),
        cmocka_unit_test(straight_motions_meet_what_looking_at_every_disc_finds),
        cmocka_unit_test(rides_meet_what_looking_at_every_disc_finds),
        cmocka_unit_test(everything_near_is_visited_once),
        cmocka_unit_test(far_things_are_not_looked_at),
        cmocka_unit_test(a_visit_that_returns_0_is_the_last),
        cmocka_unit_test(the_same_discs_are_ordered_in_the_same_way),
        cmocka_unit_test(building_again_uses_the_memory_again),
        cmocka_unit_test(a_large_disc_and_a_fast_one_get_a_branch_of_their_own),
        cmocka_unit_test(a_rate_beyond_floats_reaches_everywhere_at_once),
        cmocka_unit_test(trimming_gives_back_what_only_building_needs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
