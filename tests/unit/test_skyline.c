/* SPDX-License-Identifier: MIT */
/* What near discs hide, against asking each cover in turn. */
#include "support/cmocka_all.h"

#include "geom/skyline.h"
#include "support/chance.h"

#define MARGIN 1e-8 /* covers count as a little narrower than they are */

static sky_cover random_cover(uint64_t *chance)
{
    double from = chance_between(chance, -0.3, 0.25), reach = chance_between(chance, 0.1, 3.0);
    sky_cover cover = {from, from + chance_between(chance, -0.01, 0.2), reach};
    if (chance_below(chance, 8) == 0) cover.from = -0.25;
    if (chance_below(chance, 8) == 0) cover.to = 0.25;
    return cover;
}

/* Does a cover with at most this reach hold the heading, made wider by `wider`? */
static int covered(const sky_cover *covers, int count, double heading, double reach, double wider)
{
    for (int i = 0; i < count; ++i)
        if (covers[i].reach <= reach && covers[i].from - wider <= heading && heading <= covers[i].to + wider && covers[i].from < covers[i].to) return 1;
    return 0;
}

/* The whole window, by asking at both sides of every end of a cover. */
static int window_covered(const sky_cover *covers, int count, double from, double to, double reach, double wider)
{
    if (!covered(covers, count, from, reach, wider) || !covered(covers, count, to, reach, wider)) return 0;
    for (int i = 0; i < 2 * count; ++i) {
        double end = i < count ? covers[i].from : covers[i - count].to;
        for (int side = -1; side <= 1; side += 2) {
            double heading = end + side * (fabs(wider) + 2.0 * MARGIN);
            if (heading > from && heading < to && !covered(covers, count, heading, reach, wider)) return 0;
        }
    }
    return 1;
}

static void check_bound(skyline *sky, const sky_cover *covers, int count, double bound, uint64_t *chance)
{
    int more = sky_advance(sky, bound);
    if (!more) assert_true(window_covered(covers, count, -0.25, 0.25, bound, 0.0));
    if (more) assert_false(window_covered(covers, count, -0.25, 0.25, bound, -MARGIN));
    for (int k = 0; k < 50; ++k) {
        double from = chance_between(chance, -0.25, 0.25), to = fmin(0.25, from + chance_between(chance, 0.0, 0.1));
        int hidden = sky_hides(sky, from, to, bound);
        if (hidden) assert_true(window_covered(covers, count, from, to, bound, 0.0));
        if (!hidden) assert_false(window_covered(covers, count, from, to, bound, -MARGIN));
        double length = bound + chance_between(chance, 0.0, 1.0);
        hidden = sky_hides(sky, from, from, length);
        if (hidden) assert_true(covered(covers, count, from, length, 0.0));
        if (!hidden) assert_false(covered(covers, count, from, length * (1.0 - 1e-12), -MARGIN));
    }
}

static void covers_hide_what_the_union_of_those_passed_holds(void **state)
{
    (void)state;
    uint64_t chance = 1;
    for (int k = 0; k < 2000; ++k) {
        sky_cover covers[SKY_COVERS];
        int count = (int)chance_below(&chance, SKY_COVERS) / 2, added = 0;
        skyline sky;
        sky_init(&sky, -0.25, 0.25);
        for (double bound = 0.0; bound < 4.0; bound += 0.5) {
            /* A disc that is looked at now has legs at least as long as the bound. */
            for (; added < count * bound / 3.0 && added < count; ++added) {
                covers[added] = random_cover(&chance);
                covers[added].reach += bound;
                sky_add(&sky, covers[added].from, covers[added].to, covers[added].reach);
            }
            check_bound(&sky, covers, added, bound, &chance);
        }
    }
}

static void covers_beyond_the_room_only_hide_less(void **state)
{
    (void)state;
    uint64_t chance = 2;
    for (int k = 0; k < 200; ++k) {
        enum { MANY = 400 };
        static sky_cover covers[MANY];
        skyline sky;
        sky_init(&sky, -0.25, 0.25);
        for (int i = 0; i < MANY; ++i) {
            covers[i].from = chance_between(&chance, -0.25, 0.25);
            covers[i].to = covers[i].from + 1e-3;
            covers[i].reach = chance_between(&chance, 0.0, 1.0);
            sky_add(&sky, covers[i].from, covers[i].to, covers[i].reach);
            if (i % 50 == 49) assert_true(sky_advance(&sky, i / 400.0));
            for (int j = 0; j < 5; ++j) {
                double heading = chance_between(&chance, -0.25, 0.25);
                if (sky_hides(&sky, heading, heading, 0.5)) assert_true(covered(covers, i + 1, heading, i / 400.0 > 0.5 ? 1.0 : 0.5, 0.0));
            }
        }
        assert_true(sky.near_count <= SKY_COVERS && sky.full_count <= SKY_COVERS);
    }
}

static void passed_covers_stay_sorted_and_apart(void **state)
{
    (void)state;
    uint64_t chance = 3;
    for (int k = 0; k < 500; ++k) {
        skyline sky;
        sky_init(&sky, -0.25, 0.25);
        for (int i = 0; i < 100; ++i) {
            sky_cover cover = random_cover(&chance);
            if (cover.to > cover.from + 0.01) cover.to = cover.from + 0.01;
            sky_add(&sky, cover.from, cover.to, 0.0);
            (void)sky_advance(&sky, 1.0);
            for (int j = 0; j + 1 < sky.full_count; ++j) assert_true(sky.full[j].to < sky.full[j + 1].from);
            for (int j = 0; j < sky.full_count; ++j) assert_true(sky.full[j].from < sky.full[j].to);
        }
    }
}

static void an_empty_sky_hides_nothing(void **state)
{
    (void)state;
    skyline sky;
    sky_init(&sky, -0.1, 0.1);
    assert_true(sky_advance(&sky, 1e9));
    assert_false(sky_hides(&sky, 0.0, 0.0, 0.0));
    assert_false(sky_hides(&sky, 0.0, 0.0, 1e9));
}

static void a_leg_shorter_than_the_reach_is_seen(void **state)
{
    (void)state;
    skyline sky;
    sky_init(&sky, -0.1, 0.1);
    sky_add(&sky, -0.05, 0.05, 2.0);
    assert_true(sky_advance(&sky, 1.0));
    assert_false(sky_hides(&sky, 0.0, 0.0, 1.5));
    assert_false(sky_hides(&sky, 0.0, 0.0, 2.0));
    assert_true(sky_hides(&sky, 0.0, 0.0, 2.5));
    assert_false(sky_hides(&sky, 0.06, 0.06, 2.5));
}

static void a_leg_along_the_edge_of_a_cover_is_seen_but_not_at_the_chunks_own_end(void **state)
{
    (void)state;
    skyline sky;
    sky_init(&sky, -0.1, 0.1);
    sky_add(&sky, -0.1, 0.05, 1.0);
    sky_add(&sky, 0.07, 0.09, 1.0);
    assert_true(sky_hides(&sky, -0.1, -0.1, 2.0));
    assert_false(sky_hides(&sky, 0.05, 0.05, 2.0));
    assert_false(sky_hides(&sky, 0.07, 0.07, 2.0));
    assert_true(sky_hides(&sky, 0.08, 0.08, 2.0));
}

/* What lies beyond the chunk's ends is not asked about; a leg shorter than a reach is seen before it is passed and after. */
static void a_window_counts_as_far_as_the_chunk_goes_and_a_leg_as_far_as_the_reach(void **state)
{
    (void)state;
    for (int passed = 0; passed < 2; ++passed) {
        skyline sky;
        sky_init(&sky, -0.1, 0.1);
        sky_add(&sky, -0.1, -0.02, 1.0);
        sky_add(&sky, 0.02, 0.1, 1.0);
        if (passed) assert_true(sky_advance(&sky, 1.5));
        assert_true(sky_hides(&sky, -0.2, -0.05, 2.0));
        assert_true(sky_hides(&sky, 0.05, 0.2, 2.0));
        assert_false(sky_hides(&sky, -0.2, 0.0, 2.0));
        assert_false(sky_hides(&sky, 0.0, 0.2, 2.0));
        assert_false(sky_hides(&sky, -0.05, -0.05, 0.5));
    }
}

/* Three covers that are passed out of order, and a fourth that joins the last two. */
static void covers_that_are_passed_lie_in_order_with_the_longest_reach_of_each(void **state)
{
    (void)state;
    skyline sky;
    sky_init(&sky, -1.0, 1.0);
    sky_add(&sky, 0.5, 0.6, 3.0);
    sky_add(&sky, -0.5, -0.4, 1.0);
    sky_add(&sky, 0.0, 0.1, 2.0);
    assert_exact(sky.next, 1.0);
    assert_true(sky_advance(&sky, 1.0));
    assert_int_equal(sky.full_count, 1);
    assert_exact(sky.next, 2.0);
    assert_true(sky_advance(&sky, 1.5));
    assert_int_equal(sky.full_count, 1);
    assert_true(sky_advance(&sky, 3.0));
    assert_int_equal(sky.full_count, 3);
    assert_int_equal(sky.near_count, 0);
    assert_exact(sky.next, INFINITY);
    for (int i = 0; i < 3; ++i) assert_exact(sky.full[i].reach, i + 1.0);
    sky_add(&sky, 0.05, 0.55, 2.5);
    assert_true(sky_advance(&sky, 3.0));
    assert_int_equal(sky.full_count, 2);
    assert_exact(sky.full[1].reach, 3.0);
    assert_near(sky.full[1].from, 0.0, 1e-8);
    assert_near(sky.full[1].to, 0.6, 1e-8);
    sky_add(&sky, -0.6, -0.45, 2.9);
    assert_true(sky_advance(&sky, 3.0));
    assert_int_equal(sky.full_count, 2);
    assert_exact(sky.full[0].reach, 2.9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(covers_hide_what_the_union_of_those_passed_holds),
        cmocka_unit_test(covers_beyond_the_room_only_hide_less),
        cmocka_unit_test(passed_covers_stay_sorted_and_apart),
        cmocka_unit_test(an_empty_sky_hides_nothing),
        cmocka_unit_test(a_leg_shorter_than_the_reach_is_seen),
        cmocka_unit_test(a_leg_along_the_edge_of_a_cover_is_seen_but_not_at_the_chunks_own_end),
        cmocka_unit_test(a_window_counts_as_far_as_the_chunk_goes_and_a_leg_as_far_as_the_reach),
        cmocka_unit_test(covers_that_are_passed_lie_in_order_with_the_longest_reach_of_each),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
