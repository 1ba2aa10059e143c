/* SPDX-License-Identifier: MIT */
/* The verifier of tables where rates change, its memory, and what it does with legs that go around for ever. */
#include "support/cmocka_all.h"
#include "support/tight.h"

#include <stdlib.h>

#include "support/curve.h"
#include "support/golden.h"
#include "tdsp/growth.h"
#include "tdsp/verify.h"

enum { RIDE = 24 };

static const curve_law law = {{1, 0.1, 0.02}};
static const tdsp_point center = {4, -3};

/* The disc that is ridden, its radius raised by `more`, with the given coefficients of growth, and another one of one rate, far away. */
static tdsp_scene *scene_of(const tdsp_leg legs[RIDE], double more, const double values[], size_t count,
                            const tdsp_allocator *allocator)
{
    const tdsp_journey journey = {1.5, 0, legs[0].from, legs[RIDE - 1].to};
    const tdsp_growing_disc discs[2] = {
        {center, law.c[0] + more, {.kind = TDSP_GROWTH_POLYNOMIAL, .values = values, .count = count}},
        {{40, 0}, 1, {.kind = TDSP_GROWTH_RATE, .rate = 0.5}}};
    tdsp_scene *scene = NULL;
    assert_int_equal(tdsp_scene_create_growing(&journey, discs, 2, allocator, &scene), TDSP_OK);
    return scene;
}

/* A row for departure 0 and one for 0.5, whose path the first has moved earlier. */
static unsigned char *table_for(const tdsp_scene *scene, const tdsp_leg legs[RIDE], size_t *length)
{
    static tdsp_leg early[RIDE];
    for (int i = 0; i < RIDE; i++) {
        early[i] = legs[i];
        early[i].start_time -= 0.5;
        early[i].end_time -= 0.5;
    }
    const tdsp_journey *journey = tdsp_scene_journey(scene);
    const writer_row rows[2] = {{0, 1.5, 1.5, early, RIDE, NULL, 0}, {0.5, 1.5, INFINITY, legs, RIDE, NULL, 0}};
    writer_header header = golden_tables[5].header;
    header.first_lower = 1.5;
    header.world = (tdsp_build_world){.scene_hash = tdsp_scene_hash(scene),
                                      .speed = journey->speed,
                                      .source = journey->source,
                                      .destination = journey->destination};
    unsigned char *bytes = golden_rows(&header, rows, 2, length);
    assert_non_null(bytes);
    return bytes;
}

static tdsp_status verify(const tdsp_scene *scene, const tdsp_leg legs[RIDE], tdsp_table_verdict *verdict)
{
    size_t length;
    unsigned char *bytes = table_for(scene, legs, &length);
    tdsp_table table;
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    const tdsp_status status = tdsp_verify_table(scene, &table, verdict);
    free(bytes);
    return status;
}

static void make_ride(tdsp_leg legs[RIDE])
{
    curve_legs(&law, center, 1.5, 0.5, 2, 1, 1, legs, RIDE);
}

static void a_table_of_rides_is_accepted_and_rejected_where_the_disc_is_larger(void **state)
{
    (void)state;
    tdsp_leg legs[RIDE];
    make_ride(legs);
    for (int larger = 0; larger < 2; larger++) {
        tdsp_scene *scene = scene_of(legs, larger ? 1e-6 : 0, law.c + 1, 2, NULL);
        tdsp_table_verdict verdict;
        assert_int_equal(verify(scene, legs, &verdict), TDSP_OK);
        assert_int_equal(verdict.ok, !larger);
        assert_int_equal(verdict.bad_paths,
                         larger); /* the first row's path stays clear by what the disc grows in half a second */
        assert_near(verdict.worst.min_clearance, larger ? -1e-6 : 0, 1e-12);
        tdsp_scene_free(scene);
    }
}

/* R' = 0.4 - 0.3 t: nothing is known of the disc after 4 / 3. */
static void what_goes_on_when_a_disc_would_shrink_is_not_judged(void **state)
{
    (void)state;
    const double values[] = {0.4, -0.15};
    tdsp_leg legs[RIDE];
    tdsp_table_verdict verdict;
    tdsp_verdict path = {.problems = 77};
    make_ride(legs);
    tdsp_scene *scene = scene_of(legs, 0, values, 2, NULL);
    assert_int_equal(verify(scene, legs, &verdict), TDSP_SHRINKS);
    assert_int_equal(tdsp_verify_path(scene, legs, RIDE, 0.5, 2, &path), TDSP_SHRINKS);
    assert_int_equal(path.problems, 77);
    assert_int_equal(tdsp_verify_path(scene, legs, 13, 0.5, legs[12].end_time, &path), TDSP_OK); /* until 21 / 16 */
    tdsp_scene_free(scene);
}

/* A last departure's path was refused where its arrival was the end of what is known, but for the solver's rounding. */
static void a_path_that_ends_when_a_disc_would_shrink_is_judged_up_to_the_solvers_rounding(void **state)
{
    (void)state;
    static const double values[] = {0.4, -0.15};
    const tdsp_growing_disc disc = {.center = {0, 50}, .growth = {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = values}};
    const tdsp_journey journey = {1, 0, {0, 0}, {1, 0}};
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_OK);
    const double valid = tdsp_scene_valid_until(scene, NULL);
    for (int far = 0; far < 2; far++) {
        const double arrival = valid * (1 + (far ? 5e-11 : 5e-12));
        const tdsp_leg leg = {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = arrival - 1, .end_time = arrival, .to = {1, 0}};
        tdsp_verdict verdict = {.problems = 77};
        assert_int_equal(tdsp_verify_path(scene, &leg, 1, arrival - 1, arrival, &verdict), far ? TDSP_SHRINKS : TDSP_OK);
        assert_int_equal(verdict.problems, far ? 77 : 0);
    }
    tdsp_scene_free(scene);
}

/* Around the disc as fast as a robot of any speed can, in the time of a blink and in that of a life; beside another disc. */
static void a_leg_that_goes_around_for_ever_is_judged_in_time(void **state)
{
    (void)state;
    tdsp_leg legs[RIDE];
    make_ride(legs);
    tdsp_scene *scene = scene_of(legs, 0, law.c + 1, 2, NULL);
    for (double sweep = 10; sweep < 1e18; sweep *= 100) {
        tdsp_leg leg = legs[0];
        tdsp_verdict verdict;
        leg.center.x += 0.5;
        leg.sweep = sweep;
        assert_int_equal(tdsp_verify_path(scene, &leg, 1, 0.5, leg.end_time, &verdict), TDSP_OK);
        assert_true(verdict.problems & TDSP_PROBLEM_SPEED);
    }
    tdsp_scene_free(scene);
}

static void a_refused_allocation_is_an_error_and_leaks_nothing(void **state)
{
    (void)state;
    tight_heap heap = {.and_after = 1};
    const tdsp_allocator allocator = tight_allocator(&heap);
    tdsp_leg legs[RIDE];
    tdsp_verdict verdict;
    make_ride(legs);
    tdsp_scene *scene = scene_of(legs, 0, law.c + 1, 2, &allocator);
    const size_t before = heap.blocks;
    unsigned refused = 0;
    for (;;) {
        heap.calls = 0;
        heap.refuse = refused + 1;
        const tdsp_status status = tdsp_verify_path(scene, legs, RIDE, 0.5, 2, &verdict);
        assert_int_equal(heap.blocks, before);
        if (status == TDSP_OK) break;
        assert_int_equal(status, TDSP_NO_MEMORY);
        refused++;
    }
    assert_int_equal(refused, 3);
    assert_int_equal(verdict.problems, 0);
    tdsp_scene_free(scene);
    assert_int_equal(heap.blocks, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_of_rides_is_accepted_and_rejected_where_the_disc_is_larger),
        cmocka_unit_test(what_goes_on_when_a_disc_would_shrink_is_not_judged),
        cmocka_unit_test(a_path_that_ends_when_a_disc_would_shrink_is_judged_up_to_the_solvers_rounding),
        cmocka_unit_test(a_leg_that_goes_around_for_ever_is_judged_in_time),
        cmocka_unit_test(a_refused_allocation_is_an_error_and_leaks_nothing),
    };
    return cmocka_run_group_tests_name("verify_growing_table", tests, NULL, NULL);
}
