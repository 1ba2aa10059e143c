/* SPDX-License-Identifier: MIT */
/* Paths among discs with any growth law, leg by leg; and what is left when memory runs out on the way to one. */
#include "support/cmocka_all.h"

#include "support/shapes.h"
#include "support/tight.h"
#include "tdsp/path.h"
#include "tdsp/solver.h"

#define SEED 4204

enum { LEGS = 4096 };

static tdsp_leg legs[LEGS];

/* A ride is where its disc's boundary is, to this share of the scene's length and the disc's distance. */
#define ON_BOUNDARY 1e-11

static void leg_is_on_its_boundary(const tdsp_scene *scene, const tdsp_leg *leg)
{
    const tdsp_journey *journey = tdsp_scene_journey(scene);
    for (int i = 0; i <= 16; ++i) {
        double time = leg->start_time + (leg->end_time - leg->start_time) * i / 16.0, radius;
        assert_int_equal(tdsp_scene_disc_at(scene, leg->disc, time, &radius, NULL), TDSP_OK);
        double distance = point_distance(tdsp_leg_position(leg, time), leg->center);
        assert_near(distance, radius + journey->radius, ON_BOUNDARY * (scene->length + distance));
    }
}

/* How fast the leg says its robot is: the same everywhere. */
static void leg_is_at_the_robots_speed(const tdsp_scene *scene, const tdsp_leg *leg)
{
    double duration = leg->end_time - leg->start_time, step = 1e-4 * duration, speed = tdsp_scene_journey(scene)->speed;
    if (duration < 1e-6 * scene->time) return; /* differences of rounded places say nothing */
    for (int i = 1; i < 16; ++i) {
        double time = leg->start_time + duration * i / 16.0;
        double way = point_distance(tdsp_leg_position(leg, time + step), tdsp_leg_position(leg, time - step));
        assert_near(way / (2.0 * step), speed, 2e-4 * speed);
    }
}

static size_t path_is_whole(const tdsp_scene *scene, const tdsp_solver *solver, double departure, double arrival)
{
    size_t count, curves = 0;
    const tdsp_journey *journey = tdsp_scene_journey(scene);
    tdsp_point at = journey->source;
    double now = departure;
    assert_int_equal(tdsp_solver_path(solver, legs, LEGS, &count), TDSP_OK);
    for (size_t i = 0; i < count; ++i) {
        const tdsp_leg *leg = &legs[i];
        assert_exact(leg->start_time, now);
        assert_memory_equal(&leg->from, &at, sizeof at);
        assert_true(leg->end_time >= leg->start_time);
        assert_near(point_distance(tdsp_leg_position(leg, leg->start_time), leg->from), 0.0, ON_BOUNDARY * scene->length);
        assert_near(point_distance(tdsp_leg_position(leg, leg->end_time), leg->to), 0.0, ON_BOUNDARY * scene->length);
        if (leg->kind != TDSP_LEG_LINE) leg_is_on_its_boundary(scene, leg);
        leg_is_at_the_robots_speed(scene, leg);
        curves += leg->kind == TDSP_LEG_CURVE;
        now = leg->end_time;
        at = leg->to;
    }
    assert_exact(now, arrival);
    assert_memory_equal(&at, &journey->destination, sizeof at);
    return curves;
}

/* Curves for a ride of one turn or so: a rider's heading turns by 0.03 or more in each, but for the last ones before R' = v. */
#define MOST_CURVES 400

static void a_path_is_joined_and_rides_on_boundaries_at(shape_world *w)
{
    tdsp_solver *solver;
    assert_int_equal(tdsp_solver_create_for(w->scene, TDSP_METHOD_GENERAL, &solver), TDSP_OK);
    for (int k = 0; k < 3; ++k) {
        double departure = chance_between(&w->chance, 0.0, w->grown.unit), arrival;
        if (tdsp_earliest_arrival(solver, departure, &arrival) != TDSP_OK) continue;
        size_t curves = path_is_whole(w->scene, solver, departure, arrival);
        assert_true(curves <= MOST_CURVES);
    }
    tdsp_solver_free(solver);
}

static void a_path_is_joined_and_rides_on_boundaries(void **state)
{
    (void)state;
    shapes_each(12, 8, SEED, a_path_is_joined_and_rides_on_boundaries_at);
}

static void rates_that_change_at_given_times_are_ridden_on_arcs_alone(void **state)
{
    (void)state;
    static const grown_mix mixes[4] = {GROWTH_MIX_RATES, GROWTH_MIX_PULSES, GROWTH_MIX_DELAYED, GROWTH_MIX_CAPPED};
    size_t arcs = 0;
    for (int i = 0; i < 120; ++i) {
        shape_world w;
        tdsp_solver *solver;
        double arrival;
        shapes_open(&w, SEED + 100 + (uint64_t)i, mixes[i % 4], 8);
        assert_int_equal(tdsp_solver_create(w.scene, &solver), TDSP_OK);
        if (tdsp_earliest_arrival(solver, 0.0, &arrival) == TDSP_OK) {
            size_t count, curves = path_is_whole(w.scene, solver, 0.0, arrival);
            assert_int_equal(curves, 0);
            assert_int_equal(tdsp_solver_path(solver, legs, LEGS, &count), TDSP_OK);
            for (size_t k = 0; k < count; ++k) arcs += legs[k].kind == TDSP_LEG_ARC;
        }
        tdsp_solver_free(solver);
        shapes_close(&w);
    }
    assert_true(arcs > 30);
}

/* ----------------------------------------------------------------------------------------------------- without memory */

typedef tdsp_status (*question)(tdsp_solver *solver, double until, double *out);

static tdsp_status ask_arrival(tdsp_solver *solver, double until, double *out)
{
    (void)until;
    return tdsp_earliest_arrival(solver, 0.0, out);
}

static tdsp_status ask_latest(tdsp_solver *solver, double until, double *out)
{
    return tdsp_latest_departure(solver, until, out, NULL);
}

static tdsp_status ask_last(tdsp_solver *solver, double until, double *out)
{
    tdsp_last_departure last;
    (void)until;
    tdsp_status status = tdsp_solver_last_departure(solver, &last);
    if (status == TDSP_OK) *out = last.departure;
    return status;
}

/* Each allocation of a new solver and of its question fails in turn; asked again, the same solver answers as if nothing had been. */
static void fail_each(tight_heap *heap, const tdsp_scene *scene, question ask, double until)
{
    tdsp_solver *solver;
    double expected = 77.0;
    size_t blocks = heap->blocks, held = heap->held;
    assert_int_equal(tdsp_solver_create_for(scene, TDSP_METHOD_GENERAL, &solver), TDSP_OK);
    tdsp_status answer = ask(solver, until, &expected), status = TDSP_NO_MEMORY;
    tdsp_solver_free(solver);
    for (size_t refuse = 1; status == TDSP_NO_MEMORY; ++refuse) {
        double found = 77.0;
        solver = NULL;
        heap->refuse = heap->calls + refuse;
        status = tdsp_solver_create_for(scene, TDSP_METHOD_GENERAL, &solver);
        if (status == TDSP_OK) status = ask(solver, until, &found);
        heap->refuse = 0;
        if (status == TDSP_NO_MEMORY) assert_exact(found, 77.0);
        if (solver) assert_int_equal(ask(solver, until, &found), answer);
        if (solver) assert_exact(found, expected);
        tdsp_solver_free(solver);
        assert_int_equal(heap->blocks, blocks);
        assert_int_equal(heap->held, held);
    }
    assert_int_equal(status, answer);
}

static void an_answer_without_memory_is_told_and_can_be_asked_again(void **state)
{
    (void)state;
    static grown_scene grown;
    static const grown_mix mixes[5] = {GROWTH_MIX_CONVEX, GROWTH_MIX_S_SHAPED, GROWTH_MIX_RATES, GROWTH_MIX_CLUSTER, GROWTH_MIX_WALL};
    for (int i = 0; i < 5; ++i) {
        tight_heap heap = {0};
        tdsp_allocator memory = tight_allocator(&heap);
        tdsp_scene *scene;
        random_growth(SEED + (uint64_t)i, mixes[i % 5], 9, &grown);
        assert_int_equal(tdsp_scene_create_growing(&grown.journey, grown.discs, 9, &memory, &scene), TDSP_OK);
        fail_each(&heap, scene, ask_arrival, 0.0);
        fail_each(&heap, scene, ask_latest, 1.5 * grown.unit);
        fail_each(&heap, scene, ask_last, 0.0);
        tdsp_scene_free(scene);
        assert_int_equal(heap.blocks, 0);
        assert_int_equal(heap.held, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_path_is_joined_and_rides_on_boundaries),
        cmocka_unit_test(rates_that_change_at_given_times_are_ridden_on_arcs_alone),
        cmocka_unit_test(an_answer_without_memory_is_told_and_can_be_asked_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
