/* SPDX-License-Identifier: MIT */
/* What has been ridden already: rides put in by hand, and the moments at which they dominate others. */
#include "support/cmocka_all.h"

#include "geom/spiral.h"
#include "search/sweep.h"
#include "support/chance.h"

enum { RIDES = 8 };

typedef struct world {
    tdsp_scene *scene;
    disc_engine engine;
    engine_ride rides[RIDES];
} world;

/* An engine that looks at the scene forwards and has ridden nothing. The frame is the scene: |sd| = 1 = speed, centred. */
static void world_make(world *w, const tdsp_disc *discs, size_t count)
{
    const tdsp_journey journey = {1.0, 0.0, {-0.5, 0.0}, {0.5, 0.0}};
    assert_int_equal(tdsp_scene_create(&journey, discs, count, NULL, &w->scene), TDSP_OK);
    assert_int_equal(engine_create(&w->engine, w->scene), TDSP_OK);
    w->engine.set = &w->scene->all;
    w->engine.view.index = &w->scene->all.index;
    w->engine.view.discs = w->scene->all.forward;
    w->engine.view.sign = 1.0;
    w->engine.stamp = 1;
    w->engine.rides = w->rides;
    w->engine.ride_count = 0;
}

static void world_free(world *w)
{
    w->engine.rides = NULL;
    engine_free(&w->engine);
    tdsp_scene_free(w->scene);
}

static uint32_t disc_given(const world *w, uint32_t given)
{
    for (uint32_t k = 0; k < w->scene->all.count; ++k)
        if (w->scene->all.origin[k] == given) return k;
    fail();
    return 0;
}

static uint32_t add(world *w, uint32_t disc, int side, double normal, double start, double now)
{
    engine_ride ride = {disc, side, ENGINE_NONE, ENGINE_NONE, normal, start, now, 0.0};
    uint32_t added = (uint32_t)w->engine.ride_count++;
    w->rides[added] = ride;
    sweep_add(&w->engine, added);
    return added;
}

static const tdsp_disc alone = {{0.0, 2.0}, 1.0, 0.2};

static void a_place_is_covered_once_a_ride_has_passed_it(void **state)
{
    (void)state;
    static world w;
    uint64_t chance = 1;
    for (int k = 0; k < 300; ++k) {
        world_make(&w, &alone, 1);
        const geom_disc *disc = &w.scene->all.forward[0];
        int side = k % 2 ? 1 : -1;
        double normal = chance_between(&chance, -7.0, 7.0), start = chance_between(&chance, 0.0, 2.0), turned = chance_between(&chance, 0.1, 3.0);
        add(&w, 0, side, normal, start, start + spiral_duration(disc, start, turned));
        double share = chance_between(&chance, 0.01, 0.99), there = normal + side * share * turned;
        double passed = start + spiral_duration(disc, start, share * turned);
        for (int lap = -1; lap <= 1; ++lap) {
            assert_int_equal(sweep_covers(&w.engine, 0, side, there + lap * GEOM_TURN, passed + 1e-9), 1);
            assert_int_equal(sweep_covers(&w.engine, 0, side, there + lap * GEOM_TURN, passed - 1e-9), 0);
        }
        assert_int_equal(sweep_covers(&w.engine, 0, -side, there, passed + 1e-9), 1);
        assert_int_equal(sweep_covers(&w.engine, 0, -side, there, passed - 1e-9), 0);
        assert_int_equal(sweep_covers(&w.engine, 0, side, normal + side * (turned + 0.01), passed + 9.0), 0);
        assert_int_equal(sweep_covers(&w.engine, 0, side, normal - side * 0.01, passed + 9.0), 0);
        world_free(&w);
    }
}

static void a_new_run_forgets_what_was_ridden(void **state)
{
    (void)state;
    static world w;
    world_make(&w, &alone, 1);
    add(&w, 0, 1, 0.0, 0.0, 1.0);
    assert_int_equal(sweep_covers(&w.engine, 0, 1, 0.1, 1.0), 1);
    ++w.engine.stamp;
    assert_int_equal(sweep_covers(&w.engine, 0, 1, 0.1, 1.0), 0);
    world_free(&w);
}

static void a_ride_ends_where_an_earlier_one_began(void **state)
{
    (void)state;
    static world w;
    uint64_t chance = 2;
    for (int k = 0; k < 300; ++k) {
        world_make(&w, &alone, 1);
        const geom_disc *disc = &w.scene->all.forward[0];
        int side = k % 2 ? 1 : -1;
        double normal = chance_between(&chance, -3.0, 3.0), ahead = chance_between(&chance, 0.01, 0.24);
        uint32_t late = add(&w, 0, side, normal, 1.0, 1.0);
        add(&w, 0, side, normal + side * ahead, chance_between(&chance, 0.0, 1.0), 1.1);
        double end = 1.0 + spiral_duration(disc, 1.0, 0.25);
        assert_near(sweep_cut(&w.engine, late, 1.0, end), 1.0 + spiral_duration(disc, 1.0, ahead), 1e-12);
        world_free(&w);
    }
}

/* Both have turned half the angle between them, or the other ended before. */
static void rides_of_both_sides_end_where_they_meet(void **state)
{
    (void)state;
    static world w;
    uint64_t chance = 4;
    for (int k = 0; k < 300; ++k) {
        world_make(&w, &alone, 1);
        const geom_disc *disc = &w.scene->all.forward[0];
        int side = k % 2 ? 1 : -1;
        double normal = chance_between(&chance, -3.0, 3.0), apart = chance_between(&chance, 0.2, 3.0), turned = chance_between(&chance, 0.0, 2.0);
        uint32_t one = add(&w, 0, side, normal, 1.0, 1.0);
        add(&w, 0, -side, normal + side * apart, 1.0, 1.0 + spiral_duration(disc, 1.0, turned));
        double met = turned >= 0.5 * apart ? 0.5 * apart : apart - turned;
        assert_near(sweep_cut(&w.engine, one, 1.0, 9.0), fmin(9.0, 1.0 + spiral_duration(disc, 1.0, met)), 1e-12);
        world_free(&w);
    }
}

static void a_ride_passes_over_one_of_the_other_side_that_started_later(void **state)
{
    (void)state;
    static world w;
    world_make(&w, &alone, 1);
    uint32_t early = add(&w, 0, 1, 0.0, 1.0, 1.0);
    add(&w, 0, -1, 0.1, 5.0, 5.5);
    assert_exact(sweep_cut(&w.engine, early, 1.0, 1.25), 1.25);
    world_free(&w);
}

static void rides_that_part_at_one_place_both_go_on(void **state)
{
    (void)state;
    static world w;
    uint64_t chance = 5;
    for (int k = 0; k < 300; ++k) {
        world_make(&w, &alone, 1);
        double normal = chance_between(&chance, -3.0, 3.0), start = chance_between(&chance, 0.0, 3.0);
        uint32_t one = add(&w, 0, 1, normal, start, start);
        uint32_t other = add(&w, 0, -1, normal + chance_between(&chance, -3e-16, 3e-16), start + chance_between(&chance, -3e-16, 3e-16), start + 0.1);
        assert_exact(sweep_cut(&w.engine, one, start, start + 0.1), start + 0.1);
        w.rides[one].now = start + 0.1;
        assert_true(sweep_cut(&w.engine, other, w.rides[other].start, start + 0.1) > start + 0.09);
        world_free(&w);
    }
}

static void a_ride_goes_on_past_where_a_later_one_begins(void **state)
{
    (void)state;
    static world w;
    world_make(&w, &alone, 1);
    uint32_t early = add(&w, 0, 1, 0.0, 1.0, 1.0);
    add(&w, 0, 1, 0.1, 5.0, 5.5);
    assert_exact(sweep_cut(&w.engine, early, 1.0, 1.25), 1.25);
    world_free(&w);
}

static void a_ride_that_follows_an_earlier_one_ends_at_once(void **state)
{
    (void)state;
    static world w;
    world_make(&w, &alone, 1);
    add(&w, 0, 1, -0.3, 0.0, 1.5);
    uint32_t late = add(&w, 0, 1, 0.0, 1.0, 1.0);
    assert_exact(sweep_cut(&w.engine, late, 1.0, 1.2), 1.0);
    world_free(&w);
}

static void of_two_rides_together_the_older_goes_on(void **state)
{
    (void)state;
    static world w;
    uint64_t chance = 3;
    for (int k = 0; k < 300; ++k) {
        world_make(&w, &alone, 1);
        const geom_disc *disc = &w.scene->all.forward[0];
        double normal = chance_between(&chance, -3.0, 3.0), start = chance_between(&chance, 0.0, 3.0);
        double other = normal + chance_between(&chance, -3e-16, 3e-16), at = start + chance_between(&chance, -3e-16, 3e-16);
        double middle = start + spiral_duration(disc, start, 0.25), end = start + spiral_duration(disc, start, 0.5);
        uint32_t a = add(&w, 0, 1, normal, start, middle), b = add(&w, 0, 1, other, at, middle);
        int older_goes = sweep_cut(&w.engine, a, middle, end) > middle;
        if (k % 2 && older_goes) w.rides[a].now = end; /* as when it is followed first */
        int younger_goes = sweep_cut(&w.engine, b, middle, end) > middle;
        assert_true(older_goes || younger_goes);
        if (k % 2) assert_true(older_goes && !younger_goes);
        world_free(&w);
    }
}

static void a_slow_disc_in_the_way_straight_out_keeps_the_later_ride_alive(void **state)
{
    (void)state;
    static world w;
    const tdsp_disc discs[2] = {alone, {{1.5, 2.0}, 0.2, 0.01}}; /* in front of the normal 0, swallowed later on */
    for (size_t count = 1; count <= 2; ++count) {
        world_make(&w, discs, count);
        add(&w, disc_given(&w, 0), -1, 0.3, 0.0, 2.0);
        assert_int_equal(sweep_covers(&w.engine, disc_given(&w, 0), -1, 0.0, 6.0), count == 1);
        world_free(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_place_is_covered_once_a_ride_has_passed_it),
        cmocka_unit_test(a_new_run_forgets_what_was_ridden),
        cmocka_unit_test(a_ride_ends_where_an_earlier_one_began),
        cmocka_unit_test(rides_of_both_sides_end_where_they_meet),
        cmocka_unit_test(a_ride_passes_over_one_of_the_other_side_that_started_later),
        cmocka_unit_test(rides_that_part_at_one_place_both_go_on),
        cmocka_unit_test(a_ride_goes_on_past_where_a_later_one_begins),
        cmocka_unit_test(a_ride_that_follows_an_earlier_one_ends_at_once),
        cmocka_unit_test(of_two_rides_together_the_older_goes_on),
        cmocka_unit_test(a_slow_disc_in_the_way_straight_out_keeps_the_later_ride_alive),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
