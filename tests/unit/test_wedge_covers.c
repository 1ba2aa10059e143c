/* SPDX-License-Identifier: MIT */
/* Covers block what they say, and no limit cuts a leg that could be in time. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "support/chunk.h"

static int covers_tried;

static void check_covers(chunk_world *w, uint64_t *chance)
{
    for (uint32_t k = 0; k < w->set.count; ++k) {
        const geom_disc *disc = &w->discs[k];
        if (k == w->self || !disc_ridable(disc)) continue;
        tdsp_point offset = point_sub(disc->center, w->motion.disc->center);
        for (int sector = 0; sector < (chunk_sectors(w)); ++sector) {
            look_wedge wedge = chunk_wedge(w, sector);
            wedge_sight sight;
            if (!wedge_look_at_disc(&wedge, disc, point_length(offset), atan2(offset.y, offset.x), &sight)) continue;
            wedge_cover(&wedge, disc, &sight);
            for (int i = 0; i < wedge.sky.near_count; ++i) {
                const sky_cover *cover = &wedge.sky.near[i];
                for (int sample = 0; sample <= 6; ++sample) {
                    double share = sample < 2 ? sample : chance_unit(chance);
                    geom_line ray = chunk_ray(w, &wedge, cover->from + share * (cover->to - cover->from), cover->reach * (1.0 + 1e-9));
                    assert_true(line_blocked(&ray, disc));
                }
                ++covers_tried;
            }
        }
    }
}

static void every_ray_inside_a_cover_runs_into_its_disc_within_the_reach(void **state)
{
    (void)state;
    covers_tried = 0;
    chunk_each(2000, 4, check_covers);
    assert_true(covers_tried > 3000);
}

static int in_time, too_late;

static void check_limit(chunk_world *w, uint64_t *chance)
{
    tdsp_point goal = point_make(chance_between(chance, -2.0, 2.0), chance_between(chance, -2.0, 2.0));
    double away = point_distance(goal, w->motion.disc->center);
    double limit = w->motion.start + away * chance_between(chance, 0.8, 1.6);
    int sectors = chunk_sectors(w);
    for (int k = 0; k < 200; ++k) {
        look_wedge wedge = chunk_wedge(w, (int)chance_below(chance, (size_t)sectors));
        wedge_set_limit(&wedge, goal, limit);
        double length = chance_between(chance, 0.0, 2.0) * away, x = chance_between(chance, -1.0, 1.0) * wedge.half_angle;
        geom_line ray = chunk_ray(w, &wedge, x, length);
        tdsp_point end = point_along(ray.from, length, ray.heading);
        int is_in_time = ray.start + length + point_distance(end, goal) <= limit;
        if (is_in_time) assert_true(length <= wedge.longest);
        in_time += is_in_time;
        too_late += length > wedge.longest;
    }
}

static void no_limit_cuts_a_leg_that_is_in_time(void **state)
{
    (void)state;
    in_time = too_late = 0;
    chunk_each(4000, 5, check_limit);
    assert_true(in_time > 10000 && too_late > 100000);
}

/* A limit that nothing is beyond, one that is past already, and a goal where the rider is. */
static void limits_at_their_ends_are_none_or_shut_everything_out(void **state)
{
    (void)state;
    uint64_t chance = 7;
    static chunk_world w;
    chunk_world_make(&w, 1, &chance);
    look_wedge wedge = chunk_wedge(&w, 0);
    wedge_set_limit(&wedge, point_make(1.0, 1.0), INFINITY);
    assert_true(isinf(wedge.longest));
    double away = point_distance(w.point.center, point_make(1.0, 1.0));
    wedge_set_limit(&wedge, point_make(1.0, 1.0), w.motion.start + 0.999 * away);
    assert_true(wedge.longest < 0.0);
    wedge = chunk_wedge(&w, 0);
    wedge_set_limit(&wedge, w.point.center, w.motion.start + 1.0);
    assert_near(wedge.longest, 0.5, 1e-9);
    chunk_world_free(&w);
}

/* Found by fuzzing: late in a scene that hardly grows a radius overflowed the floats of a block, and the unused places were taken for discs. */
static void unused_places_of_a_block_are_seen_by_nobody(void **state)
{
    (void)state;
    static const double sizes[] = {0.0, 1e20, 1e38, 1e200, INFINITY, NAN};
    neighbour_block block;
    int seen[NEIGHBOUR_BLOCK];
    for (int i = 0; i < NEIGHBOUR_BLOCK; ++i) {
        block.distance[i] = 1.0f;
        block.bearing[i] = 0.0f;
        block.gap[i] = 1e30f;
        block.disc[i] = INDEX_NONE;
    }
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        const look_wedge wedge = {.widest = sizes[i]};
        assert_int_equal(wedge_look_at_block(&wedge, &block, seen), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_ray_inside_a_cover_runs_into_its_disc_within_the_reach),
        cmocka_unit_test(no_limit_cuts_a_leg_that_is_in_time),
        cmocka_unit_test(unused_places_of_a_block_are_seen_by_nobody),
        cmocka_unit_test(limits_at_their_ends_are_none_or_shut_everything_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
