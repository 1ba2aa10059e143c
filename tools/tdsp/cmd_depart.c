/* SPDX-License-Identifier: MIT */
/* tdsp depart: exact latest departures. */
#include <math.h>

#include "answers.h"
#include "commands.h"
#include "words.h"

static gboolean ask(const AnswerKind *kind, const SceneSolver *solver, Answer *answer, GError **error)
{
    double *departure = &answer->numbers[1], *arrives = &answer->numbers[2];
    (void)kind;
    answer->status = tdsp_latest_departure(solver->solver, answer->numbers[0], departure, arrives);
    if (!tdsp_status_is_answer(answer->status)) return scene_solver_fail(solver, answer->status, error);
    if (answer->status != TDSP_OK) *departure = *arrives = INFINITY;
    return TRUE;
}

static gboolean explain(const SceneSolver *solver, Answer *answer, GError **error)
{
    tdsp_deadline_answer latest;
    answer->witness = (tdsp_witness){TDSP_LIMIT_NONE, TDSP_NO_DISC, TDSP_NO_DISC, INFINITY, {0, 0}};
    if (answer->status != TDSP_OK) return TRUE;
    tdsp_status status = tdsp_solver_deadline(solver->solver, answer->numbers[0], &latest);
    if (!tdsp_status_is_answer(status)) return scene_solver_fail(solver, status, error);
    if (status == TDSP_OK) answer->witness = latest.witness;
    return TRUE;
}

int cmd_depart(const CliCommand *command, int argc, char **argv, GError **error)
{
    AnswerKind kind = {.command = command->name, .what = "arrival", .names = {"arrival", "departure", "arrives"}, .ask = ask};
    gboolean json = FALSE;
    g_autofree char *method = NULL;
    g_auto(SceneEnds) ends = {0};
    const GOptionEntry entries[] = {SCENE_SOLVER_METHOD(&method), SCENE_ENDS_ENTRIES(&ends), G_OPTION_ENTRY_NULL};
    if (!cli_parse(command, entries, &json, &argc, &argv, error) || !cli_positional(command, argc, 2, -1, error) ||
        !words_parse_method("--method", method, &kind.method, error))
        return CLI_FAILED;
    if (json) kind.explain = explain; /* that takes more searches; the text says nothing of it */
    kind.ends = ends;
    return answers_run(&kind, argc, argv, json, error);
}
