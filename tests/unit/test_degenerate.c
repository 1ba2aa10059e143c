/* Scenes that went wrong once, as they were found: both engines must give the same answer, with a path that the verifier takes. */
#include "support/cmocka_all.h"

#include "tdsp/growth.h"
#include "tdsp/solver.h"
#include "tdsp/verify.h"

#define MOST_LEGS 64

typedef struct degenerate {
    tdsp_journey journey;
    size_t count;
    tdsp_disc discs[4];
} degenerate;

/* A(departure) by a method, its path checked; infinite without a way. */
static double arrival_by(const tdsp_scene *scene, tdsp_method method, double departure)
{
    tdsp_solver *solver;
    tdsp_leg legs[MOST_LEGS];
    tdsp_verdict verdict;
    size_t count;
    double arrival = -1.0;
    assert_int_equal(tdsp_solver_create_for(scene, method, &solver), TDSP_OK);
    assert_true(tdsp_status_is_answer(tdsp_earliest_arrival(solver, departure, &arrival)));
    if (arrival < INFINITY) {
        assert_int_equal(tdsp_solver_path(solver, legs, MOST_LEGS, &count), TDSP_OK);
        assert_int_equal(tdsp_verify_path(scene, legs, count, departure, arrival, &verdict), TDSP_OK);
        assert_int_equal(verdict.problems, 0);
    }
    tdsp_solver_free(solver);
    return arrival;
}

static tdsp_scene *scene_of(const degenerate *d)
{
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create(&d->journey, d->discs, d->count, NULL, &scene), TDSP_OK);
    return scene;
}

/* What both engines say of a departure. */
static double agreed_arrival(const degenerate *d, double departure)
{
    tdsp_scene *scene = scene_of(d);
    const double one = arrival_by(scene, TDSP_METHOD_AUTO, departure), other = arrival_by(scene, TDSP_METHOD_GENERAL, departure);
    tdsp_scene_free(scene);
    assert_near(other, one, 1e-10 * one);
    return one;
}

static double last_departure(const degenerate *d)
{
    tdsp_scene *scene = scene_of(d);
    tdsp_solver *solver;
    tdsp_last_departure last;
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    assert_int_equal(tdsp_solver_last_departure(solver, &last), TDSP_OK);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return last.departure;
}

/* A place so far from a centre, in one of some directions. */
static tdsp_point place_around(tdsp_point center, double away, int direction)
{
    return (tdsp_point){center.x + away * cos(0.37 * direction), center.y + away * sin(0.37 * direction)};
}

static void a_destination_a_hair_beyond_a_boundary_is_not_ridden_past(void **state)
{
    (void)state;
    for (int direction = -7; direction <= 7; direction++) {
        for (double hair = 1e-3; hair > 1e-11; hair *= 0.1) {
            degenerate d = {{1.0, 0.0, {-1.0, 0.0}, {0.0, 0.0}}, 1, {{{0.0, 0.0}, 0.25, 0.0}}};
            d.journey.destination = place_around(d.discs[0].center, 0.25 + hair, direction);
            assert_true(agreed_arrival(&d, 0.0) < INFINITY);
        }
    }
}

/* The disc is 5e-7 of the journey: the coordinates of its boundary are known to less than the depth that was forgiven. */
static void a_destination_on_the_boundary_of_a_pebble_is_reached(void **state)
{
    (void)state;
    const degenerate d = {{0x1p-20, 0.0, {-1048576.0, 0.0}, {-802816.0, 2080768.0}}, 1, {{{-802816.83487477119, 2080768.634425523}, 1.048576, 0.0}}};
    assert_true(agreed_arrival(&d, 0.0) < INFINITY);
}

static void a_point_that_grows_a_hair_from_the_source_covers_it_last(void **state)
{
    (void)state;
    const degenerate d = {{0.3, 0.0, {-1.0, 0.0}, {1.296875, -2.0}}, 1, {{{-1.000000000880604, 4.7385297032589052e-10}, 0.0, 0.15}}};
    tdsp_scene *scene = scene_of(&d);
    const double covered = tdsp_scene_source_free_until(scene, NULL);
    tdsp_scene_free(scene);
    assert_near(last_departure(&d), covered, 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_destination_a_hair_beyond_a_boundary_is_not_ridden_past),
        cmocka_unit_test(a_destination_on_the_boundary_of_a_pebble_is_reached),
        cmocka_unit_test(a_point_that_grows_a_hair_from_the_source_covers_it_last),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
