/* SPDX-License-Identifier: MIT */
/* tdsp arrive: earliest arrivals, exact or within a share of the best. */
#include "answers.h"
#include "commands.h"
#include "scene_solver.h"
#include "words.h"

static gboolean ask(const AnswerKind *kind, const SceneSolver *solver, Answer *answer, GError **error)
{
    const double within = kind->within;
    double departure = answer->numbers[0], *arrival = &answer->numbers[1];
    if (!(within > 0 ? scene_solver_arrival_within(solver, departure, within, arrival, &answer->lower, &answer->status, error)
                     : scene_solver_arrival(solver, departure, arrival, &answer->status, error)))
        return FALSE;
    answer->numbers[2] = *arrival - departure;
    return TRUE;
}

int cmd_arrive(const CliCommand *command, int argc, char **argv, GError **error)
{
    AnswerKind kind = {
        .command = command->name, .what = "departure", .names = {"departure", "arrival", "travel_time"}, .ask = ask};
    gboolean json = FALSE;
    g_autofree char *within = NULL, *method = NULL;
    g_auto(SceneEnds) ends = {0};
    const GOptionEntry entries[] = {SCENE_SOLVER_WITHIN(&within), SCENE_SOLVER_METHOD(&method), SCENE_ENDS_ENTRIES(&ends), G_OPTION_ENTRY_NULL};
    if (!cli_parse(command, entries, &json, &argc, &argv, error) || !cli_positional(command, argc, 2, -1, error) ||
        !scene_solver_parse_within(within, &kind.within, error) || !words_parse_method("--method", method, &kind.method, error))
        return CLI_FAILED;
    kind.ends = ends;
    return answers_run(&kind, argc, argv, json, error);
}
