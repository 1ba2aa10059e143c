/* SPDX-License-Identifier: MIT */
/* Rings of neighbours against looking at every disc. */
#include "support/cmocka_all.h"

#include <string.h>

#include "geom/angle.h"
#include "search/neighbours.h"
#include "support/chance.h"
#include "support/tight.h"

enum { MOST = 600, KINDS = 5 };

/* A single-precision column may be off by this share. */
#define FLOAT 1.2e-7

typedef struct world {
    tdsp_allocator memory;
    disc_set set;
    neighbourhood around;
    double rate; /* largest */
} world;

/* Evenly spread, in clusters, all in one place, in a row, of very different sizes. */
static geom_disc random_disc(uint64_t *chance, int kind)
{
    tdsp_point place = point_make(chance_between(chance, -1.0, 1.0), chance_between(chance, -1.0, 1.0));
    double radius = chance_between(chance, 0.0, 0.05);
    if (kind == 1) place = point_make(0.7 * floor(2.0 * place.x) + 1e-3 * place.y, 0.7 * floor(2.0 * place.y) + 1e-3 * place.x);
    if (kind == 2) place = point_make(0.25, -0.5);
    if (kind == 3) place.y = 0.0;
    if (kind == 4) radius = ldexp(0.5, -(int)chance_below(chance, 20));
    return disc_make(place, radius, chance_between(chance, 0.0, 0.3));
}

static void world_make(world *w, uint32_t count, int kind, uint64_t *chance, const tdsp_allocator *memory)
{
    memset(w, 0, sizeof *w);
    w->memory = memory_allocator(memory);
    assert_int_equal(set_reserve(&w->set, &w->memory, count), TDSP_OK);
    w->set.count = count;
    for (uint32_t i = 0; i < count; ++i) {
        w->set.forward[i] = random_disc(chance, kind);
        w->set.origin[i] = i;
        w->rate = fmax(w->rate, w->set.forward[i].rate);
    }
    assert_int_equal(set_prepare(&w->set, &w->memory), TDSP_OK);
}

static void world_free(world *w)
{
    neighbours_free(&w->around, &w->memory);
    set_free(&w->set, &w->memory);
}

static double gap_of(const world *w, const neighbour_rings *rings, uint32_t disc)
{
    const geom_disc *other = &w->set.forward[disc];
    return point_distance(other->center, rings->center) - other->radius;
}

static void check_entry(const world *w, const neighbour_rings *rings, const neighbour_block *block, uint32_t at)
{
    const geom_disc *disc = &w->set.forward[block->disc[at]];
    tdsp_point offset = point_sub(disc->center, rings->center);
    double distance = point_length(offset);
    assert_near(block->distance[at], distance, FLOAT * distance);
    assert_near(block->gap[at], distance - disc->radius, FLOAT * (distance + disc->radius));
    double off = angle_wrap(block->bearing[at] - atan2(offset.y, offset.x));
    if (distance > 0.0) assert_near(off, 0.0, GEOM_ANGLE_NEAR);
}

/* Mark what the ring holds. The rest of its last block says that it is nowhere. */
static void check_ring(const world *w, const neighbour_rings *rings, uint32_t ring, unsigned char *seen)
{
    const neighbour_ring *self = &rings->rings[ring];
    double inner = ring ? rings->rings[ring - 1].radius : -INFINITY;
    uint32_t whole = (self->count + NEIGHBOUR_BLOCK - 1) / NEIGHBOUR_BLOCK * NEIGHBOUR_BLOCK;
    assert_true(self->radius >= inner);
    for (uint32_t i = 0; i < whole; ++i) {
        const neighbour_block *block = &w->around.blocks[self->first + i / NEIGHBOUR_BLOCK];
        uint32_t at = i % NEIGHBOUR_BLOCK;
        if (i >= self->count) {
            assert_int_equal(block->disc[at], INDEX_NONE);
            assert_true(block->gap[at] > 1e29f);
            continue;
        }
        double gap = gap_of(w, rings, block->disc[at]);
        assert_true(gap > inner && gap <= self->radius);
        assert_false(seen[block->disc[at]]);
        seen[block->disc[at]] = 1;
        check_entry(w, rings, block, at);
    }
}

/* What is in no ring is farther away than the last one's radius, and will be at any later time, less what can grow. */
static void check_rings(const world *w, uint32_t place)
{
    unsigned char seen[MOST] = {0};
    const neighbour_rings *rings = &w->around.rings[place];
    uint32_t count = 0;
    for (uint32_t ring = 0; ring < rings->ring_count; ++ring) {
        check_ring(w, rings, ring, seen);
        count += rings->rings[ring].count;
    }
    assert_int_equal(count, rings->disc_count);
    double radius = rings->ring_count ? rings->rings[rings->ring_count - 1].radius : -INFINITY;
    for (uint32_t k = 0; k < w->set.count; ++k) {
        if (seen[k] || k == rings->self) continue;
        assert_true(gap_of(w, rings, k) > radius);
        const geom_disc *disc = &w->set.forward[k];
        for (double time = 0.0; time < 3.0; time += 0.7)
            assert_true(point_distance(disc->center, rings->center) - disc_radius(disc, time) > radius - w->rate * time - 1e-12);
    }
    int all = 1;
    for (uint32_t k = 0; k < w->set.count; ++k) all = all && (seen[k] || k == rings->self);
    assert_int_equal(neighbours_complete(&w->around, place) != 0, all);
}

/* Widen until there is no more. */
static void widen_all(world *w, uint32_t place)
{
    int added = 1;
    check_rings(w, place);
    while (added) {
        assert_int_equal(neighbours_widen(&w->around, &w->memory, place, NEIGHBOURS_MOST, &added), TDSP_OK);
        check_rings(w, place);
    }
    const neighbour_rings *rings = &w->around.rings[place];
    int enough = rings->ring_count == NEIGHBOUR_RINGS || rings->disc_count >= NEIGHBOURS_MOST;
    assert_true(enough || neighbours_complete(&w->around, place));
}

static void each_world(uint64_t seed, void (*check)(world *w, uint64_t *chance))
{
    static const uint32_t counts[] = {1, 2, 7, 40, 300, MOST};
    uint64_t chance = seed;
    for (size_t i = 0; i < sizeof counts / sizeof *counts; ++i)
        for (int kind = 0; kind < KINDS; ++kind) {
            static world w;
            world_make(&w, counts[i], kind, &chance, NULL);
            assert_int_equal(neighbours_begin(&w.around, &w.memory, &w.set), TDSP_OK);
            check(&w, &chance);
            world_free(&w);
        }
}

static void check_around_discs(world *w, uint64_t *chance)
{
    for (int k = 0; k < 12; ++k) {
        uint32_t disc = (uint32_t)chance_below(chance, w->set.count), place, again;
        assert_int_equal(neighbours_of_disc(&w->around, &w->memory, disc, &place), TDSP_OK);
        assert_int_equal(w->around.rings[place].self, disc);
        widen_all(w, place);
        assert_int_equal(neighbours_of_disc(&w->around, &w->memory, disc, &again), TDSP_OK);
        assert_int_equal(again, place);
    }
}

static void the_rings_of_a_disc_hold_what_is_between_their_radii(void **state)
{
    (void)state;
    each_world(1, check_around_discs);
}

static void check_around_points(world *w, uint64_t *chance)
{
    for (int k = 0; k < 6; ++k) {
        double far = k == 5 ? 50.0 : 1.5;
        tdsp_point point = point_make(chance_between(chance, -far, far), chance_between(chance, -far, far));
        uint32_t place;
        assert_int_equal(neighbours_of_point(&w->around, &w->memory, point, &place), TDSP_OK);
        assert_int_equal(w->around.rings[place].self, INDEX_NONE);
        widen_all(w, place);
    }
}

static void the_rings_of_a_point_hold_what_is_between_their_radii(void **state)
{
    (void)state;
    each_world(2, check_around_points);
}

/* Rings are grown in turn, so that their blocks lie between those of others. */
static void check_in_turn(world *w, uint64_t *chance)
{
    uint32_t places[4];
    for (int i = 0; i < 4; ++i) {
        uint32_t disc = (uint32_t)chance_below(chance, w->set.count);
        assert_int_equal(neighbours_of_disc(&w->around, &w->memory, disc, &places[i]), TDSP_OK);
    }
    for (int round = 0; round < 2 * NEIGHBOUR_RINGS; ++round) {
        int added;
        assert_int_equal(neighbours_widen(&w->around, &w->memory, places[round % 4], NEIGHBOURS_MOST, &added), TDSP_OK);
        for (int i = 0; i < 4; ++i) check_rings(w, places[i]);
    }
}

static void rings_grown_in_turn_do_not_disturb_each_other(void **state)
{
    (void)state;
    each_world(3, check_in_turn);
}

static void beginning_again_forgets_everything(void **state)
{
    (void)state;
    uint64_t chance = 4;
    static world w;
    uint32_t place;
    world_make(&w, 100, 0, &chance, NULL);
    assert_int_equal(neighbours_begin(&w.around, &w.memory, &w.set), TDSP_OK);
    assert_int_equal(neighbours_of_disc(&w.around, &w.memory, 5, &place), TDSP_OK);
    widen_all(&w, place);
    assert_int_equal(neighbours_begin(&w.around, &w.memory, &w.set), TDSP_OK);
    assert_int_equal(w.around.rings_count, 0);
    assert_int_equal(w.around.block_count, 0);
    assert_int_equal(neighbours_of_disc(&w.around, &w.memory, 5, &place), TDSP_OK);
    assert_int_equal(place, 0);
    assert_int_equal(w.around.rings[place].ring_count, 0);
    widen_all(&w, place);
    world_free(&w);
}

static void among_no_discs_the_rings_of_a_point_are_complete(void **state)
{
    (void)state;
    uint64_t chance = 5;
    static world w;
    uint32_t place;
    int added = 7;
    world_make(&w, 0, 0, &chance, NULL);
    assert_int_equal(neighbours_begin(&w.around, &w.memory, &w.set), TDSP_OK);
    assert_int_equal(neighbours_of_point(&w.around, &w.memory, point_make(0.5, 0.5), &place), TDSP_OK);
    assert_true(neighbours_complete(&w.around, place));
    assert_int_equal(neighbours_widen(&w.around, &w.memory, place, NEIGHBOURS_MOST, &added), TDSP_OK);
    assert_int_equal(added, 0);
    world_free(&w);
}

/* Look up two discs and a point, all the way. */
static tdsp_status look_up(world *w)
{
    uint32_t places[3] = {0, 0, 0};
    tdsp_status status = neighbours_begin(&w->around, &w->memory, &w->set);
    if (status == TDSP_OK) status = neighbours_of_disc(&w->around, &w->memory, 3, &places[0]);
    if (status == TDSP_OK) status = neighbours_of_disc(&w->around, &w->memory, 44, &places[1]);
    if (status == TDSP_OK) status = neighbours_of_point(&w->around, &w->memory, point_make(0.1, 0.2), &places[2]);
    for (int i = 0; i < 3; ++i)
        for (int added = 1; added && status == TDSP_OK;) status = neighbours_widen(&w->around, &w->memory, places[i], NEIGHBOURS_MOST, &added);
    return status;
}

static void rings_without_memory_are_told_and_can_be_looked_up_again(void **state)
{
    (void)state;
    static world w;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    uint64_t chance = 6;
    world_make(&w, 200, 0, &chance, &memory);
    size_t held = heap.held;
    tdsp_status status = TDSP_NO_MEMORY;
    for (size_t refuse = 1; status != TDSP_OK; ++refuse) {
        heap.refuse = heap.calls + refuse;
        status = look_up(&w);
        heap.refuse = 0;
        if (status == TDSP_OK) continue;
        assert_int_equal(status, TDSP_NO_MEMORY);
        assert_int_equal(look_up(&w), TDSP_OK);
        for (uint32_t place = 0; place < 3; ++place) check_rings(&w, place);
        neighbours_free(&w.around, &w.memory);
        assert_int_equal(heap.held, held);
    }
    assert_int_equal(neighbours_bytes(&w.around), heap.held - held);
    world_free(&w);
    assert_int_equal(heap.blocks, 0);
    assert_int_equal(heap.held, 0);
}

static void a_ring_that_failed_half_way_can_be_added_later(void **state)
{
    (void)state;
    static world w;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    uint64_t chance = 7;
    uint32_t place;
    int failed = 0;
    world_make(&w, MOST, 0, &chance, &memory);
    assert_int_equal(neighbours_begin(&w.around, &w.memory, &w.set), TDSP_OK);
    assert_int_equal(neighbours_of_disc(&w.around, &w.memory, 9, &place), TDSP_OK);
    for (int added = 1; added;) {
        heap.refuse = heap.calls + 1;
        if (neighbours_widen(&w.around, &w.memory, place, NEIGHBOURS_MOST, &added) == TDSP_OK) continue;
        ++failed;
        assert_int_equal(added, 0);
        check_rings(&w, place);
        heap.refuse = 0;
        assert_int_equal(neighbours_widen(&w.around, &w.memory, place, NEIGHBOURS_MOST, &added), TDSP_OK);
        check_rings(&w, place);
    }
    assert_true(failed > 0);
    world_free(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_rings_of_a_disc_hold_what_is_between_their_radii),
        cmocka_unit_test(the_rings_of_a_point_hold_what_is_between_their_radii),
        cmocka_unit_test(rings_grown_in_turn_do_not_disturb_each_other),
        cmocka_unit_test(beginning_again_forgets_everything),
        cmocka_unit_test(among_no_discs_the_rings_of_a_point_are_complete),
        cmocka_unit_test(rings_without_memory_are_told_and_can_be_looked_up_again),
        cmocka_unit_test(a_ring_that_failed_half_way_can_be_added_later),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
