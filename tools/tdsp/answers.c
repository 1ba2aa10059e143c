/* SPDX-License-Identifier: MIT */
/* Ask about times, print the answers. */
#include "answers.h"

#include "cli.h"
#include "json_out.h"
#include "margins.h"
#include "progress.h"
#include "scene_solver.h"
#include "text_table.h"
#include "times.h"

static gboolean solve(const AnswerKind *kind, const SceneSolver *solver, const GArray *times, GArray *answers, GError **error)
{
    Progress progress = progress_begin(kind->command);
    gboolean solved = TRUE;
    for (guint i = 0; solved && i < times->len; i++) {
        Answer answer = {.numbers = {g_array_index(times, double, i)}};
        Stopwatch watch = stopwatch_start();
        solved = kind->ask(kind, solver, &answer, error);
        answer.seconds = stopwatch_seconds(watch);
        if (solved && kind->explain) solved = kind->explain(solver, &answer, error);
        g_array_append_val(answers, answer);
        progress_show(&progress, i + 1, times->len);
    }
    progress_end(&progress);
    return solved;
}

/* The lower bound stands last, so that the other columns are where they always are. */
static gboolean print_text(const AnswerKind *kind, const GArray *answers, GError **error)
{
    const char *const heading[] = {
        kind->names[0], kind->names[1], kind->names[2], "status", "seconds", kind->within > 0 ? "lower" : NULL, NULL};
    g_auto(TextTable) table = text_table_new(heading);
    for (guint i = 0; i < answers->len; i++) {
        const Answer *answer = &g_array_index(answers, Answer, i);
        for (guint k = 0; k < ANSWER_NUMBERS; k++) text_table_number(&table, answer->numbers[k]);
        text_table_string(&table, tdsp_status_name(answer->status));
        text_table_number(&table, answer->seconds);
        if (kind->within > 0) text_table_number(&table, answer->lower);
    }
    return text_table_print(&table, error);
}

static void json_answer(JsonOut *out, const AnswerKind *kind, const Answer *answer)
{
    json_out_line(out);
    json_out_begin(out, '{');
    for (guint k = 0; k < ANSWER_NUMBERS; k++) json_out_member_number(out, kind->names[k], answer->numbers[k]);
    if (kind->within > 0) json_out_member_number(out, "lower", answer->lower);
    json_out_member_string(out, "status", tdsp_status_name(answer->status));
    if (kind->explain) margins_json_witness(out, &answer->witness);
    json_out_member_number(out, "seconds", answer->seconds);
    json_out_end(out, '}');
}

static gboolean print_json(const AnswerKind *kind, const GArray *answers, const SceneSolver *solver, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_number(&out, "prepare_seconds", solver->prepare_seconds);
    json_out_member_string(&out, "method", tdsp_method_name(tdsp_solver_method(solver->solver)));
    if (kind->within > 0) json_out_member_number(&out, "within", kind->within);
    json_out_key(&out, "results");
    json_out_begin(&out, '[');
    for (guint i = 0; i < answers->len; i++) json_answer(&out, kind, &g_array_index(answers, Answer, i));
    json_out_end(&out, ']');
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean any_ok(const GArray *answers)
{
    for (guint i = 0; i < answers->len; i++)
        if (g_array_index(answers, Answer, i).status == TDSP_OK) return TRUE;
    return FALSE;
}

int answers_run(const AnswerKind *kind, int argc, char **argv, gboolean json, GError **error)
{
    g_autoptr(GArray) times = times_new();
    g_autoptr(GArray) answers = g_array_new(FALSE, FALSE, sizeof(Answer));
    g_auto(SceneSolver) solver = {0};
    if (!times_add_all(times, argc, argv, 2, kind->what, error) || !scene_solver_load_for(argv[1], &kind->ends, (tdsp_method)kind->method, &solver, error) ||
        !solve(kind, &solver, times, answers, error) ||
        !(json ? print_json(kind, answers, &solver, error) : print_text(kind, answers, error)))
        return CLI_FAILED;
    return cli_answer(any_ok(answers));
}
