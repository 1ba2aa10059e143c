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
    assert_true(sky_hides(&sky, -0.1, -0.1, 2.0));
    assert_false(sky_hides(&sky, 0.05, 0.05, 2.0));
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
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
