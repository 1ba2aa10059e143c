/* SPDX-License-Identifier: MIT */
/*
 * What asks a solver, over one that fails or contradicts itself: errors are handed on, contradictions end the work or are told. No scene makes the
 * solver do that; the linker's --wrap puts these functions before its own (rules.mk).
 */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/world.h"
#include "tdsp/margin.h"
#include "tdsp/shape.h"
#include "tdsp/solver.h"
#include "tdsp/verify_report.h"

/* ARRIVES_LATER: from call `at` on. */
typedef enum untruth { FAILS, TOO_EARLY, LATER, EARLIER, NO_GAP, ARRIVES_LATER } untruth;

static struct {
    untruth how;
    unsigned at; /* of the calls that it can happen to, from 1; 0: never */
    unsigned stop; /* ARRIVES_LATER: before this call; 0: for ever */
    unsigned calls;
} now;

tdsp_status __real_tdsp_earliest_arrival(tdsp_solver *solver, double departure, double *arrival);
tdsp_status __wrap_tdsp_earliest_arrival(tdsp_solver *solver, double departure, double *arrival);
tdsp_status __real_tdsp_latest_departure(tdsp_solver *solver, double arrival, double *departure, double *arrives);
tdsp_status __wrap_tdsp_latest_departure(tdsp_solver *solver, double arrival, double *departure, double *arrives);
tdsp_status __real_tdsp_solver_gap(tdsp_solver *solver, double departure, tdsp_gap *out);
tdsp_status __wrap_tdsp_solver_gap(tdsp_solver *solver, double departure, tdsp_gap *out);

static int is_due(void)
{
    return ++now.calls == now.at;
}

tdsp_status __wrap_tdsp_earliest_arrival(tdsp_solver *solver, double departure, double *arrival)
{
    if (now.how == FAILS && is_due()) return TDSP_FAILED;
    tdsp_status status = __real_tdsp_earliest_arrival(solver, departure, arrival);
    if (now.how == ARRIVES_LATER && now.at && ++now.calls >= now.at && (now.stop == 0 || now.calls < now.stop)) *arrival += 1000.0;
    return status;
}

tdsp_status __wrap_tdsp_latest_departure(tdsp_solver *solver, double arrival, double *departure, double *arrives)
{
    int due = now.how != NO_GAP && now.how != ARRIVES_LATER && is_due();
    if (due && now.how == FAILS) return TDSP_FAILED;
    if (due && now.how == TOO_EARLY) return TDSP_ARRIVAL_TOO_EARLY;
    tdsp_status status = __real_tdsp_latest_departure(solver, arrival, departure, arrives);
    if (!due || status != TDSP_OK) return status;
    double away = now.how == LATER ? 1000.0 : -*departure;
    *departure += away;
    if (arrives) *arrives += away;
    return TDSP_OK;
}

tdsp_status __wrap_tdsp_solver_gap(tdsp_solver *solver, double departure, tdsp_gap *out)
{
    if (now.how == FAILS && is_due()) return TDSP_FAILED;
    return now.how == NO_GAP ? TDSP_NO_ANSWER : __real_tdsp_solver_gap(solver, departure, out);
}

static void be_untrue(untruth how, unsigned at)
{
    now.how = how;
    now.at = at;
    now.stop = now.calls = 0;
}

/* ---------------------------------------------------------------------------------------------------------------- jumps and pieces */

static const tdsp_journey across = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
static const tdsp_disc gate[] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};
static const tdsp_disc touching[] = {{{0.0, 2.0}, 1.0, 0.05}};
static const tdsp_disc switching[] = {{{-3.0, 0.05}, 1.0, 0.0}, {{3.0, -0.5}, 0.1, 0.02}};
static const struct {
    const tdsp_disc *discs;
    size_t count;
    double until;
} scenes[] = {{gate, 2, INFINITY}, {gate, 2, 20.0}, {touching, 1, 20.0}, {switching, 2, 60.0}};
enum { SCENES = sizeof scenes / sizeof *scenes };

typedef tdsp_status (*finder)(tdsp_solver *solver, const tdsp_shape_options *options, unsigned *unknown);

static tdsp_status find_jumps(tdsp_solver *solver, const tdsp_shape_options *options, unsigned *unknown)
{
    tdsp_jumps *jumps = NULL;
    tdsp_arrival_jump jump;
    tdsp_status status = tdsp_jumps_find(solver, options, &jumps);
    assert_int_equal(status == TDSP_OK, jumps != NULL);
    for (size_t i = 0; tdsp_jumps_get(jumps, i, &jump) == TDSP_OK; i++) *unknown += jump.gap.first == TDSP_NO_DISC;
    tdsp_jumps_free(jumps);
    return status;
}

static tdsp_status find_pieces(tdsp_solver *solver, const tdsp_shape_options *options, unsigned *unknown)
{
    tdsp_envelope *envelope = NULL;
    tdsp_piece piece;
    tdsp_status status = tdsp_envelope_find(solver, options, &envelope);
    assert_int_equal(status == TDSP_OK, envelope != NULL);
    for (size_t i = 0; tdsp_envelope_piece(envelope, i, &piece) == TDSP_OK; i++)
        *unknown += piece.change == TDSP_CHANGE_JUMP && piece.gap.first == TDSP_NO_DISC;
    tdsp_envelope_free(envelope);
    return status;
}

static const finder finders[] = {find_jumps, find_pieces};

static tdsp_status find(size_t scene, size_t which, unsigned *unknown)
{
    tdsp_shape_options options;
    tdsp_shape_options_init(&options);
    options.until = scenes[scene].until;
    options.resolution = 0.5;
    unsigned own = 0;
    world w = world_make(across, scenes[scene].discs, scenes[scene].count);
    tdsp_status status = finders[which](w.solver, &options, unknown ? unknown : &own);
    world_free(w);
    return status;
}

static void an_error_of_the_solver_at_any_call_is_handed_on(void **state)
{
    (void)state;
    for (size_t scene = 0; scene < SCENES; scene++)
        for (size_t k = 0; k < 2; k++)
            for (unsigned at = 1;; at++) {
                be_untrue(FAILS, at);
                tdsp_status status = find(scene, k, NULL);
                assert_int_equal(status, now.calls < at ? TDSP_OK : TDSP_FAILED);
                if (now.calls < at) break;
            }
}

static void an_arrival_between_two_known_ones_that_is_said_to_be_too_early_is_a_failure(void **state)
{
    (void)state;
    for (size_t k = 0; k < 2; k++)
        for (unsigned at = 1;; at++) {
            be_untrue(TOO_EARLY, at);
            tdsp_status status = find(1, k, NULL);
            if (now.calls < at) break;
            assert_int_equal(status, TDSP_FAILED);
        }
}

static void departures_outside_their_stretch_end_the_division(void **state)
{
    (void)state;
    for (size_t scene = 1; scene < SCENES; scene++)
        for (size_t k = 0; k < 2; k++)
            for (unsigned at = 1; at < 12; at++) {
                be_untrue(at % 2 ? LATER : EARLIER, (at + 1) / 2);
                assert_int_equal(find(scene, k, NULL), TDSP_OK);
            }
}

static void a_jump_whose_gap_is_not_known_is_one(void **state)
{
    (void)state;
    for (size_t k = 0; k < 2; k++) {
        unsigned unknown = 0;
        be_untrue(NO_GAP, 0);
        assert_int_equal(find(0, k, &unknown), TDSP_OK);
        assert_int_equal(unknown, 1);
    }
}

/* ------------------------------------------------------------------------------------------------------------------------ deadlines */

static tdsp_status latest_for(double deadline, tdsp_deadline_answer *out)
{
    world w = world_make(across, gate, 2);
    tdsp_status status = tdsp_solver_deadline(w.solver, deadline, out);
    world_free(w);
    return status;
}

static void a_deadline_says_what_closes_or_only_that_something_jumps(void **state)
{
    (void)state;
    tdsp_deadline_answer answer;
    be_untrue(FAILS, 0);
    assert_int_equal(latest_for(30.0, &answer), TDSP_OK);
    assert_int_equal(answer.witness.limit, TDSP_LIMIT_GAP);
    be_untrue(NO_GAP, 0);
    assert_int_equal(latest_for(30.0, &answer), TDSP_OK);
    assert_int_equal(answer.witness.limit, TDSP_LIMIT_JUMP);
    for (unsigned at = 1;; at++) {
        be_untrue(FAILS, at);
        tdsp_status status = latest_for(30.0, &answer);
        assert_int_equal(status, now.calls < at ? TDSP_OK : TDSP_FAILED);
        if (now.calls < at) break;
    }
}

/* How far all growth may rise, with arrivals 1000 later from call `from` to before call `stop`: after the hunt, when what it found is solved again. */
static tdsp_margin margin_with(tdsp_raise how, unsigned from, unsigned stop)
{
    tdsp_margin margin = {0};
    world w = world_make(across, gate, 2);
    be_untrue(ARRIVES_LATER, from);
    now.stop = stop;
    assert_int_equal(tdsp_departure_margin(w.scene, how, 2.0, 40.0, &margin), TDSP_OK);
    world_free(w);
    return margin;
}

static void a_margin_that_does_not_hold_when_it_is_solved_again_is_taken_back(void **state)
{
    (void)state;
    for (int how = 0; how < 2; how++) {
        const tdsp_margin sound = margin_with((tdsp_raise)how, UINT32_MAX, 0);
        unsigned again = now.calls; /* at most: the explanation asks, too */
        assert_true(sound.most > 0.0 && again > 5);
        tdsp_margin back = sound;
        while (again > 1 && back.most == sound.most) {
            --again;
            back = margin_with((tdsp_raise)how, again, again + 1);
        }
        assert_true(back.most < sound.most && back.most > 0.999999 * sound.most);
        assert_int_equal(back.status, TDSP_OK);
        const tdsp_margin none = margin_with((tdsp_raise)how, again, 0);
        assert_true(none.most == -INFINITY && isinf(none.arrival));
        assert_int_equal(none.witness.limit, TDSP_LIMIT_DEADLINE);
    }
}

/* ------------------------------------------------------------------------------------------------------------------- verify --deep */

#define WORLD                                                                                                                    \
    "{\"robot\": {\"speed\": 1}, \"source\": [-10, 0], \"destination\": [10, 0], \"discs\": [{\"center\": [0, 3], \"radius\": 1, \"growth\": 0.1}]}"

/* Verify by searching that a path that leaves at `departure` takes 20: how many problems there are, -1 for an error. */
static int problems_at(double departure, untruth how, unsigned at, const char *words)
{
    SceneFile file;
    SceneSolver solver = {0};
    g_autoptr(GError) error = NULL;
    g_auto(VerifyReport) report = verify_report_new();
    const PathFile path = {departure, departure + 20.0, NULL, NULL};
    be_untrue(how, 0);
    if (!scene_file_parse("scene.json", WORLD, strlen(WORLD), &file, &error) || !scene_solver_take(&file, &solver, &error)) fail();
    be_untrue(how, at);
    gboolean done = verify_deep_path(&report, &solver, &path, &error);
    int problems = done ? (int)report.problems->len : -1;
    if (problems == 1 && !strstr(g_ptr_array_index(report.problems, 0), words)) fail_msg("%s", (char *)g_ptr_array_index(report.problems, 0));
    scene_solver_clear(&solver);
    return problems;
}

static void deep_verification_tells_what_the_solver_contradicts(void **state)
{
    (void)state;
    assert_int_equal(problems_at(5.0, FAILS, 0, ""), 0);
    assert_int_equal(problems_at(5.0, TOO_EARLY, 1, "but backwards: arrival_too_early"), 1);
    assert_int_equal(problems_at(0.0, TOO_EARLY, 1, ""), 0); /* rounding: before any departure there is none */
    assert_int_equal(problems_at(5.0, EARLIER, 1, "but backwards departs at 0"), 1);
    assert_int_equal(problems_at(5.0, LATER, 2, "backwards finds an arrival before"), 1);
    for (unsigned at = 1; at <= 3; at++) assert_int_equal(problems_at(5.0, FAILS, at, ""), -1);
    assert_int_equal(problems_at(5.0, FAILS, 4, ""), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_error_of_the_solver_at_any_call_is_handed_on),
        cmocka_unit_test(an_arrival_between_two_known_ones_that_is_said_to_be_too_early_is_a_failure),
        cmocka_unit_test(departures_outside_their_stretch_end_the_division),
        cmocka_unit_test(a_jump_whose_gap_is_not_known_is_one),
        cmocka_unit_test(a_deadline_says_what_closes_or_only_that_something_jumps),
        cmocka_unit_test(a_margin_that_does_not_hold_when_it_is_solved_again_is_taken_back),
        cmocka_unit_test(deep_verification_tells_what_the_solver_contradicts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
