/* SPDX-License-Identifier: MIT */
/* Discs whose rates change often, faster and slower than the robot, without memory: lists that outgrow their first room are refused too. */
#include "support/cmocka_all.h"

#include "support/tight.h"
#include "tdsp/growth.h"
#include "tdsp/solver.h"

enum { TIMES = 48 };

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};

/* Bursts of 1.5 for a tenth of each half unit of time, on average 0.38: corners where the rate falls below the robot's speed. */
static tdsp_growing_disc bursting(tdsp_point center, double radius, double *times, double *rates)
{
    for (int i = 0; i < TIMES; i++) {
        times[i] = 0.25 * (i / 2) + (i % 2 ? 0.05 : 0.0);
        rates[i] = i % 2 ? 0.1 : 1.5;
    }
    rates[TIMES - 1] = 0.0;
    return (tdsp_growing_disc){center, radius, {.kind = TDSP_GROWTH_RATES, .count = TIMES, .values = rates, .times = times}};
}

/* The travel times at two departures, or why there are none. What the heap holds in between is the solver's. */
static tdsp_status solve(const tdsp_growing_disc *discs, size_t count, tight_heap *heap, double travels[2])
{
    tdsp_allocator memory = tight_allocator(heap);
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    tdsp_status status = tdsp_scene_create_growing(&across, discs, count, &memory, &scene);
    if (status == TDSP_OK) status = tdsp_solver_create(scene, &solver);
    for (int i = 0; i < 2 && status == TDSP_OK; i++) {
        double departure = 4.0 * i, arrival;
        status = tdsp_earliest_arrival(solver, departure, &arrival);
        travels[i] = arrival - departure;
    }
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    assert_int_equal(heap->blocks, 0);
    assert_int_equal(heap->held, 0);
    return status;
}

static void every_allocation_for_discs_of_many_rates_may_fail(void **state)
{
    (void)state;
    double times[2][TIMES], rates[2][TIMES], whole[2], travels[2];
    const tdsp_growing_disc discs[] = {bursting((tdsp_point){-2.0, 1.5}, 0.2, times[0], rates[0]),
                                       bursting((tdsp_point){3.0, -1.0}, 0.0, times[1], rates[1]),
                                       {{0.0, 6.0}, 1.0, {.rate = 0.05}}};
    tight_heap heap = {0};
    assert_int_equal(solve(discs, 3, &heap, whole), TDSP_OK);
    assert_true(whole[0] > 20.0 && whole[1] >= whole[0]);
    assert_true(heap.calls > 30);
    size_t calls = heap.calls;
    for (size_t refuse = 1; refuse <= calls; refuse++) {
        heap = (tight_heap){.refuse = refuse};
        assert_int_equal(solve(discs, 3, &heap, travels), TDSP_NO_MEMORY);
    }
}

/* The rate falls below the robot's speed while the disc is still a point: there is nothing to ride. */
static void a_corner_of_a_disc_that_is_hardly_more_than_a_point_is_no_touch(void **state)
{
    (void)state;
    const double times[] = {0.0, 1e-13}, rates[] = {2.0, 0.01};
    const tdsp_growing_disc point = {{0.0, 0.0}, 0.0, {.kind = TDSP_GROWTH_RATES, .count = 2, .values = rates, .times = times}};
    const tdsp_growing_disc slow = {{0.0, 0.0}, 0.0, {.rate = 0.01}};
    double travels[2], expected[2];
    tight_heap heap = {0};
    assert_int_equal(solve(&point, 1, &heap, travels), TDSP_OK);
    assert_int_equal(solve(&slow, 1, &heap, expected), TDSP_OK);
    for (int i = 0; i < 2; i++) assert_near(travels[i], expected[i], 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_allocation_for_discs_of_many_rates_may_fail),
        cmocka_unit_test(a_corner_of_a_disc_that_is_hardly_more_than_a_point_is_no_touch),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
