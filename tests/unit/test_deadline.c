/* SPDX-License-Identifier: MIT */
/* The latest departure with its reason, and slack. */
#include "support/cmocka_all.h"

#include "support/world.h"
#include "tdsp/margin.h"

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
static const tdsp_disc gap[2] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};

/* The last moment to pass the gap: docs/math.md, 5.3. */
static double gap_radius(void)
{
    return 3.0 / sqrt(0.99);
}

static void where_the_arrival_is_continuous_the_deadline_is_the_limit(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    tdsp_deadline_answer answer;
    const double deadlines[] = {20.0, 25.0, 40.0};
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(tdsp_solver_deadline(w.solver, deadlines[i], &answer), TDSP_OK);
        assert_int_equal(answer.witness.limit, TDSP_LIMIT_DEADLINE);
        assert_int_equal(answer.witness.disc, TDSP_NO_DISC);
        assert_near(answer.arrival, deadlines[i], 1e-9);
        assert_near(answer.witness.time, deadlines[i], 0);
        assert_near(answer.witness.place.x, 10.0, 1e-12);
        assert_near(world_arrival(w, answer.departure), answer.arrival, 1e-10);
    }
    world_free(w);
}

static void inside_a_jump_the_gap_is_the_limit_with_its_discs_moment_and_place(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    tdsp_deadline_answer answer;
    const double passes = 10.0 * (gap_radius() - 1.0);
    const double deadlines[] = {30.35, 33.0, 33.56};
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(tdsp_solver_deadline(w.solver, deadlines[i], &answer), TDSP_OK);
        assert_int_equal(answer.witness.limit, TDSP_LIMIT_GAP);
        assert_int_equal(answer.witness.disc, 0);
        assert_int_equal(answer.witness.other, 1);
        assert_near(answer.witness.time, passes, 1e-8);
        assert_near(answer.witness.place.x, 0.1 * gap_radius(), 1e-8);
        assert_near(answer.witness.place.y, 0.0, 1e-8);
        assert_int_equal(answer.after, TDSP_OK);
        assert_near(answer.after_arrival, 33.5675, 1e-4);
    }
    world_free(w);
}

static void the_path_handed_out_is_that_of_the_latest_departure(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    const double deadlines[] = {25.0, 33.0, INFINITY};
    for (size_t i = 0; i < 3; i++) {
        tdsp_deadline_answer answer;
        tdsp_leg legs[16];
        size_t count;
        assert_int_equal(tdsp_solver_deadline(w.solver, deadlines[i], &answer), TDSP_OK);
        assert_int_equal(tdsp_solver_path(w.solver, legs, 16, &count), TDSP_OK);
        assert_exact(legs[0].start_time, answer.departure);
        assert_near(legs[count - 1].end_time, answer.arrival, 1e-10);
    }
    world_free(w);
}

static void each_cover_is_named(void **state)
{
    (void)state;
    const tdsp_disc at_source[2] = {{{-10.0, 4.0}, 1.0, 0.1}, {{-10.0, -5.0}, 1.0, 0.1}};
    const tdsp_disc at_destination[2] = {{{10.0, 9.0}, 1.0, 0.1}, {{10.0, -5.0}, 1.0, 0.1}};
    const double deadlines[] = {70.0, INFINITY};
    for (size_t i = 0; i < 2; i++) {
        tdsp_deadline_answer answer;
        world w = world_make(across, at_source, 2);
        assert_int_equal(tdsp_solver_deadline(w.solver, deadlines[i], &answer), TDSP_OK);
        assert_int_equal(answer.witness.limit, TDSP_LIMIT_SOURCE_COVERED);
        assert_int_equal(answer.witness.disc, 0);
        assert_near(answer.witness.time, 30.0, 1e-12);
        assert_near(answer.witness.place.x, -10.0, 0);
        assert_int_equal(answer.after, TDSP_SOURCE_COVERED);
        assert_near(answer.after_arrival, INFINITY, 0);
        world_free(w);
        w = world_make(across, at_destination, 2);
        assert_int_equal(tdsp_solver_deadline(w.solver, deadlines[i], &answer), TDSP_OK);
        assert_int_equal(answer.witness.limit, TDSP_LIMIT_DESTINATION_COVERED);
        assert_int_equal(answer.witness.disc, 1);
        assert_near(answer.witness.time, 40.0, 1e-12);
        assert_int_equal(answer.after, TDSP_DESTINATION_COVERED);
        world_free(w);
    }
}

/* A still ring about the destination with one gap, which two growing discs close. */
static void a_gap_that_cuts_off_is_the_limit_of_all_departures(void **state)
{
    (void)state;
    enum { RING = 24 };
    tdsp_disc discs[RING + 2];
    for (int i = 0; i < RING; i++) {
        const double angle = 2.0 * 3.14159265358979323846 * i / (double)RING;
        discs[i] = (tdsp_disc){{10.0 + 5.0 * cos(angle), 5.0 * sin(angle)}, 0.8, 0.0};
    }
    discs[RING / 2].radius = 0.0; /* the gap, towards the source */
    discs[RING] = (tdsp_disc){{5.0, 1.5}, 0.5, 0.02};
    discs[RING + 1] = (tdsp_disc){{5.0, -1.5}, 0.5, 0.02};
    world w = world_make(across, discs, RING + 2);
    tdsp_deadline_answer answer;
    assert_int_equal(tdsp_solver_deadline(w.solver, INFINITY, &answer), TDSP_OK);
    assert_int_equal(answer.after, TDSP_CUT_OFF);
    assert_int_equal(answer.witness.limit, TDSP_LIMIT_GAP);
    assert_true(world_arrival(w, answer.departure) < INFINITY);
    world_free(w);
}

static void nothing_limits_where_nothing_grows(void **state)
{
    (void)state;
    const tdsp_disc still = {{0.0, 0.0}, 3.0, 0.0};
    world w = world_make(across, &still, 1);
    tdsp_deadline_answer answer;
    assert_int_equal(tdsp_solver_deadline(w.solver, INFINITY, &answer), TDSP_OK);
    assert_int_equal(answer.witness.limit, TDSP_LIMIT_NONE);
    assert_true(isinf(answer.departure) && isinf(answer.arrival));
    assert_int_equal(tdsp_solver_deadline(w.solver, 100.0, &answer), TDSP_OK);
    assert_int_equal(answer.witness.limit, TDSP_LIMIT_DEADLINE);
    world_free(w);
}

static void without_an_answer_the_status_says_why_and_nothing_is_touched(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    tdsp_deadline_answer answer = {.departure = 7.0};
    assert_int_equal(tdsp_solver_deadline(w.solver, 19.0, &answer), TDSP_ARRIVAL_TOO_EARLY);
    assert_int_equal(tdsp_solver_deadline(w.solver, -1.0, &answer), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_deadline(w.solver, NAN, &answer), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_deadline(NULL, 30.0, &answer), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_deadline(w.solver, 30.0, NULL), TDSP_INVALID_ARGUMENT);
    assert_exact(answer.departure, 7.0);
    world_free(w);
}

static void slack_counts_both_ways(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    tdsp_slack slack;
    const double latest = 10.0 * (gap_radius() - 1.0) - 10.0 - 0.1 * gap_radius();
    assert_int_equal(tdsp_solver_slack(w.solver, 5.0, 33.0, &slack), TDSP_OK);
    assert_int_equal(slack.status, TDSP_OK);
    assert_near(slack.arrival, 25.0, 1e-10);
    assert_near(slack.early, 8.0, 1e-10);
    assert_near(slack.later, latest - 5.0, 1e-9);
    assert_int_equal(slack.latest.witness.limit, TDSP_LIMIT_GAP);
    assert_int_equal(tdsp_solver_slack(w.solver, 12.0, 33.0, &slack), TDSP_OK);
    assert_true(slack.early < 0.0);
    assert_near(slack.later, latest - 12.0, 1e-9);
    assert_int_equal(tdsp_solver_slack(w.solver, 5.0, INFINITY, &slack), TDSP_OK);
    assert_true(isinf(slack.early) && slack.later > 55.0);
    assert_int_equal(tdsp_solver_slack(w.solver, 70.0, 33.0, &slack), TDSP_OK);
    assert_int_equal(slack.status, TDSP_DESTINATION_COVERED);
    assert_true(slack.early == -INFINITY && slack.later < -60.0);
    assert_int_equal(tdsp_solver_slack(w.solver, 5.0, 10.0, &slack), TDSP_OK);
    assert_int_equal(slack.latest_status, TDSP_ARRIVAL_TOO_EARLY);
    assert_true(slack.later == -INFINITY);
    assert_near(slack.early, -15.0, 1e-10);
    assert_int_equal(tdsp_solver_slack(w.solver, -1.0, 10.0, &slack), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_slack(w.solver, 1.0, NAN, &slack), TDSP_INVALID_ARGUMENT);
    world_free(w);
}

static void a_departure_at_the_limit_has_no_slack_and_is_not_late(void **state)
{
    (void)state;
    world w = world_make(across, gap, 2);
    const double departures[] = {0.0, 3.0, 11.0, 40.0};
    for (size_t i = 0; i < 4; i++) {
        tdsp_slack slack;
        assert_int_equal(tdsp_solver_slack(w.solver, departures[i], world_arrival(w, departures[i]), &slack), TDSP_OK);
        assert_near(slack.early, 0.0, 0);
        assert_true(slack.later >= 0.0);
        assert_near(slack.later, 0.0, 1e-9);
    }
    world_free(w);
}

static void limits_have_names(void **state)
{
    (void)state;
    assert_string_equal(tdsp_limit_name(TDSP_LIMIT_NONE), "none");
    assert_string_equal(tdsp_limit_name(TDSP_LIMIT_DEADLINE), "deadline");
    assert_string_equal(tdsp_limit_name(TDSP_LIMIT_GAP), "gap");
    assert_string_equal(tdsp_limit_name(TDSP_LIMIT_JUMP), "jump");
    assert_string_equal(tdsp_limit_name(TDSP_LIMIT_SOURCE_COVERED), "source_covered");
    assert_string_equal(tdsp_limit_name(TDSP_LIMIT_DESTINATION_COVERED), "destination_covered");
    assert_string_equal(tdsp_limit_name(TDSP_LIMIT_CUT_OFF), "cut_off");
    assert_string_equal(tdsp_limit_name(TDSP_LIMIT_TOUCH), "touch");
    assert_string_equal(tdsp_limit_name((tdsp_limit)99), "unknown");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(where_the_arrival_is_continuous_the_deadline_is_the_limit),
        cmocka_unit_test(inside_a_jump_the_gap_is_the_limit_with_its_discs_moment_and_place),
        cmocka_unit_test(the_path_handed_out_is_that_of_the_latest_departure),
        cmocka_unit_test(each_cover_is_named),
        cmocka_unit_test(a_gap_that_cuts_off_is_the_limit_of_all_departures),
        cmocka_unit_test(nothing_limits_where_nothing_grows),
        cmocka_unit_test(without_an_answer_the_status_says_why_and_nothing_is_touched),
        cmocka_unit_test(slack_counts_both_ways),
        cmocka_unit_test(a_departure_at_the_limit_has_no_slack_and_is_not_late),
        cmocka_unit_test(limits_have_names),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
