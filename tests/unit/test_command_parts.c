/* SPDX-License-Identifier: MIT */
/* Parts of the command, given what no command line leads to: statuses that were sorted out before, values of no meaning, and places too narrow. */
#include "support/cmocka_all.h"

#include <float.h>
#include <string.h>
#include <time.h>

#include "tdsp/build_asked.h"
#include "tdsp/cli.h"
#include "tdsp/plot_labels.h"
#include "tdsp/plot_route.h"
#include "tdsp/progress.h"
#include "tdsp/scene_solver.h"
#include "tdsp/shape_asked.h"
#include "tdsp/table_path.h"
#include "tdsp/verify_report.h"
#include "tdsp/words.h"
#include "tdsp/workers.h"

#define WORLD                                                                                                                    \
    "{\"robot\": {\"speed\": 1}, \"source\": [0, 0], \"destination\": [20, 0], \"discs\": [{\"center\": [10, 3], \"radius\": 1, \"growth\": 0.1}]}"

static SceneSolver solver_of(const char *text)
{
    SceneFile scene;
    SceneSolver solver = {0};
    g_autoptr(GError) error = NULL;
    if (!scene_file_parse("scene.json", text, strlen(text), &scene, &error) || !scene_solver_take(&scene, &solver, &error))
        fail_msg("%s", error->message);
    return solver;
}

/* The exit status, and that the message says why. */
static int exit_of(GError *error, const char *words)
{
    assert_non_null(error);
    if (!strstr(error->message, words)) fail_msg("no \"%s\" in \"%s\"", words, error->message);
    int code = error->code;
    g_error_free(error);
    return code;
}

static int exit_of_status(tdsp_status status)
{
    GError *error = NULL;
    assert_false(cli_fail_status(&error, "here", status));
    return exit_of(error, "here: ");
}

static void every_family_of_statuses_has_its_exit_status(void **state)
{
    (void)state;
    assert_int_equal(exit_of_status(TDSP_NEEDS_HORIZON), CLI_USAGE);
    assert_int_equal(exit_of_status(TDSP_TOO_MANY_ROWS), CLI_USAGE);
    assert_int_equal(exit_of_status(TDSP_NOT_SUPPORTED), CLI_USAGE);
    assert_int_equal(exit_of_status(TDSP_BAD_SCENE), CLI_INPUT);
    assert_int_equal(exit_of_status(TDSP_BAD_TABLE), CLI_INPUT);
    assert_int_equal(exit_of_status(TDSP_SHRINKS), CLI_INPUT);
    assert_int_equal(exit_of_status(TDSP_BAD_ORACLE), CLI_SYSTEM);
    assert_int_equal(exit_of_status(TDSP_NO_MEMORY), CLI_SYSTEM);
    assert_int_equal(exit_of_status(TDSP_INVALID_ARGUMENT), CLI_SYSTEM);
}

static void assert_plain(const char *text, size_t length, const char *expected)
{
    GString *plain = cli_plain(text, length, "\n");
    assert_string_equal(plain->str, expected);
    g_string_free(plain, TRUE);
}

static void control_characters_are_written_out_and_letters_of_two_bytes_are_not(void **state)
{
    (void)state;
    assert_plain("a\nb\tc", 5, "a\nb\\x09c");
    assert_plain("\0\x7f", 2, "\\x00\\x7f");
    assert_plain("\xc2\x9b", 2, "\\xc2\\x9b");
    assert_plain("\xc2\xa3", 2, "\xc2\xa3");
    assert_plain("\xc2", 1, "\xc2");
}

static void too_many_rows_names_the_horizon_where_there_is_one(void **state)
{
    (void)state;
    g_auto(SceneSolver) solver = solver_of(WORLD);
    BuildAsked asked = {.options = {.max_rows = 9, .horizon = INFINITY}};
    GError *error = NULL;
    assert_false(build_asked_fail(&asked, &solver.file, TDSP_TOO_MANY_ROWS, &error));
    assert_null(strstr(error->message, "--horizon"));
    assert_int_equal(exit_of(error, "more than 9 rows"), CLI_USAGE);
    asked.options.horizon = 5;
    error = NULL;
    assert_false(build_asked_fail(&asked, &solver.file, TDSP_TOO_MANY_ROWS, &error));
    assert_int_equal(exit_of(error, "nearer --horizon"), CLI_USAGE);
}

static void a_solver_that_has_answered_nothing_has_no_path(void **state)
{
    (void)state;
    g_auto(SceneSolver) solver = solver_of(WORLD);
    GError *error = NULL;
    assert_null(scene_solver_path(solver.solver, &error));
    assert_int_equal(exit_of(error, "path: "), CLI_SYSTEM);
}

static void a_scene_that_never_shrinks_is_not_said_to(void **state)
{
    (void)state;
    g_auto(SceneSolver) solver = solver_of(WORLD);
    GError *error = NULL;
    assert_false(scene_file_fail(&solver.file, "solver", TDSP_SHRINKS, &error));
    assert_int_equal(exit_of(error, "solver: "), CLI_INPUT);
}

static void a_table_that_is_not_open_is_an_error_of_each_that_reads_it(void **state)
{
    (void)state;
    g_auto(SceneSolver) solver = solver_of(WORLD);
    g_auto(VerifyReport) report = verify_report_new();
    const tdsp_table closed = {0};
    TablePath path;
    GError *error = NULL;
    assert_false(table_path_find(&closed, 0, &path, &error));
    exit_of(error, "table: ");
    error = NULL;
    assert_false(verify_report_table(&report, solver.file.scene, &closed, &error));
    exit_of(error, "verify: ");
    error = NULL;
    assert_false(verify_deep_table(&report, &solver, &closed, 1, &error));
    exit_of(error, "table: ");
    assert_true(verify_report_ok(&report));
}

static void a_path_that_departs_at_no_time_cannot_be_verified(void **state)
{
    (void)state;
    g_auto(SceneSolver) solver = solver_of(WORLD);
    g_auto(VerifyReport) report = verify_report_new();
    g_auto(PathFile) path = {NAN, 20, NULL, g_array_new(FALSE, TRUE, sizeof(tdsp_leg))};
    GError *error = NULL;
    assert_false(verify_report_path(&report, solver.file.scene, &path, &error));
    exit_of(error, "verify: ");
    error = NULL;
    assert_false(verify_deep_path(&report, &solver, &path, &error));
    exit_of(error, "solver: ");
}

static void values_without_a_word_are_unknown(void **state)
{
    (void)state;
    assert_string_equal(words_guarantee(TDSP_GUARANTEE_ABSOLUTE), "absolute");
    assert_string_equal(words_guarantee(3), "unknown");
    assert_string_equal(words_monotone(UINT32_MAX), "unknown");
}

static void a_gap_that_is_not_known_is_null_in_each_member(void **state)
{
    (void)state;
    const tdsp_gap unknown = {TDSP_NO_DISC, TDSP_NO_DISC, 0, {0, 0}};
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    shape_json_gap(&out, &unknown);
    json_out_end(&out, '}');
    assert_string_equal(out.text->str, "{\"first\": null, \"second\": null, \"time\": null, \"place\": null}");
    g_autofree char *discs = shape_gap_discs(&unknown);
    assert_string_equal(discs, "unknown");
    json_out_clear(&out);
    json_out_clear(&out); /* once more, as the automatic end does */
}

static void count_task(void *context, size_t task, size_t worker)
{
    (void)task;
    (void)worker;
    g_atomic_int_inc((int *)context);
}

static void workers_run_each_task_once_and_none_where_there_is_none(void **state)
{
    (void)state;
    g_auto(SceneSolver) solver = solver_of(WORLD);
    g_autoptr(GError) error = NULL;
    Workers *workers = workers_new(solver.file.scene, 3, &error);
    int runs = 0;
    assert_non_null(workers);
    workers_run(workers, count_task, &runs, 0);
    assert_int_equal(runs, 0);
    workers_run(workers, count_task, &runs, 1);
    assert_int_equal(runs, 1);
    workers_run(workers, count_task, &runs, 100);
    assert_int_equal(runs, 101);
    workers_free(workers);
    workers_free(NULL);
}

/* ------------------------------------------------------------------------------------------------------------------------- progress */

static Progress begun(double seconds_ago)
{
    Progress progress = {.what = "test", .on = TRUE, .begun = stopwatch_start()};
    progress.begun.tv_sec -= (time_t)seconds_ago;
    return progress;
}

static void a_bar_without_a_known_end_stays_at_its_beginning(void **state)
{
    (void)state;
    const double ends[] = {0, INFINITY, NAN, -1};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        Progress progress = begun(5);
        progress_show(&progress, 3, ends[i]);
        assert_true(progress.visible);
        assert_exact(progress.share, 0);
    }
}

static void a_bar_stays_within_its_ends_and_does_not_go_back(void **state)
{
    (void)state;
    Progress progress = begun(5);
    progress_show(&progress, -1, 8);
    assert_exact(progress.share, 0);
    progress.drawn = 0;
    progress_show(&progress, 6, 8);
    assert_exact(progress.share, 0.75);
    progress.drawn = 0;
    progress_show(&progress, 2, 8);
    assert_exact(progress.share, 0.75);
    progress.drawn = 0;
    progress_show(&progress, 9, 8);
    assert_exact(progress.share, 1);
}

static void a_hundred_hours_and_more_are_not_counted_down(void **state)
{
    (void)state;
    Progress progress = begun(100000);
    progress_show(&progress, 0.1, 1); /* 900000 seconds left */
    assert_true(progress.visible);
    progress_end(&progress);
    assert_false(progress.visible);
}

/* ------------------------------------------------------------------------------------------------------------------------- pictures */

static Canvas *paper(void)
{
    return canvas_new("paper.png", 200, 200, NULL, NULL);
}

static void a_label_goes_where_there_is_room_or_nowhere(void **state)
{
    (void)state;
    const TextStyle style = {12, FALSE, PLOT_INK, 0, 0, TRUE};
    const struct {
        Frame frame;
        double x, y;
        int fits;
    } cases[] = {{{0, 0, 200, 200, 0, 1, 0, 1}, 100, 100, 1}, {{0, 0, 200, 200, 0, 1, 0, 1}, 100, 2, 1}, {{0, 0, 200, 200, 0, 1, 0, 1}, 100, 198, 1},
                 {{0, 0, 200, 200, 0, 1, 0, 1}, 2, 100, 1},   {{0, 0, 30, 200, 0, 1, 0, 1}, 15, 100, 0}, {{0, 0, 200, 12, 0, 1, 0, 1}, 100, 6, 0}};
    g_autoptr(Canvas) canvas = paper();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        g_auto(Labels) labels = labels_new(&cases[i].frame);
        assert_int_equal(labels_write(&labels, canvas, cases[i].x, cases[i].y, 5, 0, &style, "a label"), cases[i].fits);
    }
}

static tdsp_leg line_of(double start, double end, double x)
{
    return (tdsp_leg){.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = start, .end_time = end, .from = {x, 0}, .to = {x + end - start, 0}};
}

static void a_path_of_no_duration_has_no_times_along_it(void **state)
{
    (void)state;
    const Frame frame = {0, 0, 200, 200, 0, 10, -5, 5};
    const tdsp_leg still = line_of(3, 3, 5), moving = line_of(3, 8, 1);
    g_autoptr(Canvas) canvas = paper();
    g_auto(Labels) labels = labels_new(&frame);
    assert_exact(plot_route_times(canvas, &frame, &(Route){&still, 1, PLOT_PATH, PLOT_PATH_TINT}, &labels), 0);
    assert_true(plot_route_times(canvas, &frame, &(Route){&moving, 1, PLOT_PATH, PLOT_PATH_TINT}, &labels) > 0);
}

/* A path that waits has no direction at a tick, which is drawn none the less. */
static void a_path_that_stands_still_at_a_tick_is_drawn(void **state)
{
    (void)state;
    const Frame frame = {0, 0, 200, 200, 0, 10, -5, 5};
    const tdsp_leg legs[] = {line_of(0, 2, 1), {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = 2, .end_time = 6, .from = {3, 0}, .to = {3, 0}},
                             line_of(6, 9, 3)};
    g_autoptr(Canvas) canvas = paper();
    g_auto(Labels) labels = labels_new(&frame);
    assert_exact(plot_route_times(canvas, &frame, &(Route){legs, 3, PLOT_PATH, PLOT_PATH_TINT}, &labels), 1);
    assert_true(labels.boxes->len > 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_family_of_statuses_has_its_exit_status),
        cmocka_unit_test(control_characters_are_written_out_and_letters_of_two_bytes_are_not),
        cmocka_unit_test(too_many_rows_names_the_horizon_where_there_is_one),
        cmocka_unit_test(a_solver_that_has_answered_nothing_has_no_path),
        cmocka_unit_test(a_scene_that_never_shrinks_is_not_said_to),
        cmocka_unit_test(a_table_that_is_not_open_is_an_error_of_each_that_reads_it),
        cmocka_unit_test(a_path_that_departs_at_no_time_cannot_be_verified),
        cmocka_unit_test(values_without_a_word_are_unknown),
        cmocka_unit_test(a_gap_that_is_not_known_is_null_in_each_member),
        cmocka_unit_test(workers_run_each_task_once_and_none_where_there_is_none),
        cmocka_unit_test(a_bar_without_a_known_end_stays_at_its_beginning),
        cmocka_unit_test(a_bar_stays_within_its_ends_and_does_not_go_back),
        cmocka_unit_test(a_hundred_hours_and_more_are_not_counted_down),
        cmocka_unit_test(a_label_goes_where_there_is_room_or_nowhere),
        cmocka_unit_test(a_path_of_no_duration_has_no_times_along_it),
        cmocka_unit_test(a_path_that_stands_still_at_a_tick_is_drawn),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
