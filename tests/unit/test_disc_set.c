/* SPDX-License-Identifier: MIT */
/* Sets of discs: both directions of time in one order, chosen from another set, and no larger than they need be. */
#include "support/cmocka_all.h"

#include <string.h>

#include "scene/disc_set.h"
#include "support/chance.h"
#include "support/tight.h"
#include "tdsp/scene.h"

enum { MOST = 500 };

/* Rates alike, a few, all different; some zero. */
static void fill(disc_set *set, const tdsp_allocator *memory, uint32_t count, uint64_t *chance, int kind)
{
    assert_int_equal(set_reserve(set, memory, count), TDSP_OK);
    set->count = count;
    for (uint32_t i = 0; i < count; ++i) {
        tdsp_point place = point_make(chance_between(chance, -1.0, 1.0), chance_between(chance, -1.0, 1.0));
        double rate = kind == 0 ? 0.1 : kind == 1 ? 0.1 * (double)chance_below(chance, 3) : chance_between(chance, 0.0, 1.5);
        set->forward[i] = disc_make(place, chance_between(chance, 0.01, 0.1), rate);
        set->origin[i] = i;
    }
}

static void check_set(const disc_set *set)
{
    double least = INFINITY;
    for (uint32_t i = 0; i < set->count; ++i) {
        const geom_disc *disc = &set->forward[i];
        geom_disc forward = disc_make(disc->center, disc->radius, disc->rate);
        geom_disc reverse = disc_make(disc->center, disc->radius, -disc->rate);
        assert_memory_equal(disc, &forward, sizeof forward);
        assert_memory_equal(&set->reverse[i], &reverse, sizeof reverse);
        least = fmin(least, disc->rate);
    }
    assert_exact(set->rate_min, least);
}

static void both_directions_are_the_same_discs(void **state)
{
    (void)state;
    uint64_t chance = 1;
    tdsp_allocator memory = memory_allocator(NULL);
    for (int kind = 0; kind < 3; ++kind) {
        disc_set set = {0};
        fill(&set, &memory, MOST, &chance, kind);
        assert_int_equal(set_prepare(&set, &memory), TDSP_OK);
        check_set(&set);
        set_free(&set, &memory);
    }
}

static void a_set_chosen_from_another_holds_those_discs_both_ways(void **state)
{
    (void)state;
    uint64_t chance = 2;
    tdsp_allocator memory = memory_allocator(NULL);
    disc_set all = {0}, chosen = {0};
    fill(&all, &memory, MOST, &chance, 2);
    assert_int_equal(set_prepare(&all, &memory), TDSP_OK);
    for (uint32_t step = 1; step < 40; step += 6) {
        uint32_t members[MOST], count = 0;
        for (uint32_t i = MOST; i-- > 0;)
            if (i % step == 0) members[count++] = i;
        assert_int_equal(set_choose(&chosen, &memory, &all, members, count), TDSP_OK);
        assert_int_equal(chosen.count, count);
        for (uint32_t i = 0; i < count; ++i) {
            assert_int_equal(chosen.origin[i] % step, 0);
            assert_memory_equal(&chosen.forward[i], &all.forward[chosen.origin[i]], sizeof chosen.forward[i]);
        }
        check_set(&chosen);
    }
    set_free(&chosen, &memory);
    set_free(&all, &memory);
}

static void a_whole_set_has_angles_and_no_room_to_spare(void **state)
{
    (void)state;
    uint64_t chance = 3;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    disc_set set = {0};
    fill(&set, &memory, MOST, &chance, 1);
    set.forward[7].radius = 5.0; /* swallows what is not faster */
    for (uint32_t i = 0; i < MOST; ++i) set.forward[i].sine = set.forward[i].theta = NAN;
    assert_int_equal(set_prepare_whole(&set, &memory), TDSP_OK);
    assert_true(set.count > 0 && set.count < MOST);
    check_set(&set);
    assert_int_equal(heap.held, set_bytes(&set));
    assert_int_equal(set.forward_capacity, set.count);
    assert_int_equal(set.reverse_capacity, set.count);
    assert_int_equal(set.origin_capacity, set.count);
    assert_int_equal(set.index.node_capacity, set.index.node_count);
    assert_int_equal(set.index.key_capacity, 0);
    set_free(&set, &memory);
    assert_int_equal(heap.held, 0);
}

static tdsp_status make_every_way(const tdsp_allocator *memory)
{
    uint64_t chance = 4;
    const uint32_t members[3] = {5, 1, 9};
    disc_set all = {0}, chosen = {0};
    tdsp_status status = set_reserve(&all, memory, 100);
    if (status == TDSP_OK) {
        fill(&all, memory, 100, &chance, 2);
        status = set_prepare_whole(&all, memory);
    }
    if (status == TDSP_OK) status = set_choose(&chosen, memory, &all, members, 3);
    if (status == TDSP_OK) status = set_prepare(&chosen, memory);
    set_free(&chosen, memory);
    set_free(&all, memory);
    return status;
}

static void a_failed_allocation_is_told(void **state)
{
    (void)state;
    for (size_t refuse = 1;; ++refuse) {
        tight_heap heap = {.refuse = refuse};
        tdsp_allocator memory = tight_allocator(&heap);
        tdsp_status status = make_every_way(&memory);
        assert_int_equal(heap.held, 0);
        if (refuse > heap.calls) {
            assert_int_equal(status, TDSP_OK);
            break;
        }
        assert_int_equal(status, TDSP_NO_MEMORY);
    }
}

static void a_scene_of_many_discs_holds_no_more_bytes_than_the_header_says(void **state)
{
    (void)state;
    static tdsp_disc discs[20000];
    const tdsp_journey journey = {1.0, 0.0, {-1.0, 0.0}, {1.0, 0.0}};
    uint64_t chance = 5;
    tight_heap heap = {0};
    tdsp_allocator memory = tight_allocator(&heap);
    tdsp_scene *scene;
    for (size_t i = 0; i < 20000; ++i) {
        tdsp_disc disc = {{chance_between(&chance, -1.0, 1.0), chance_between(&chance, -1.0, 1.0)}, 1e-3, 1e-5};
        discs[i] = disc;
    }
    assert_int_equal(tdsp_scene_create(&journey, discs, 20000, &memory, &scene), TDSP_OK);
    assert_true(heap.held < 160 * 20000);
    tdsp_scene_free(scene);
    assert_int_equal(heap.held, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_directions_are_the_same_discs),
        cmocka_unit_test(a_set_chosen_from_another_holds_those_discs_both_ways),
        cmocka_unit_test(a_whole_set_has_angles_and_no_room_to_spare),
        cmocka_unit_test(a_failed_allocation_is_told),
        cmocka_unit_test(a_scene_of_many_discs_holds_no_more_bytes_than_the_header_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
