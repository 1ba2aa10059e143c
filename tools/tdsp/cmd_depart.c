/* tdsp depart: exact latest departures. */
#include <math.h>

#include "answers.h"
#include "commands.h"

static gboolean ask(const SceneSolver *solver, double within, Answer *answer, GError **error)
{
    (void)within; /* always exact */
    double *departure = &answer->numbers[1], *arrives = &answer->numbers[2];
    answer->status = tdsp_latest_departure(solver->solver, answer->numbers[0], departure, arrives);
    if (!tdsp_status_is_answer(answer->status)) return scene_solver_fail(solver, answer->status, error);
    if (answer->status != TDSP_OK) *departure = *arrives = INFINITY;
    return TRUE;
}

int cmd_depart(const CliCommand *command, int argc, char **argv, GError **error)
{
    const AnswerKind kind = {
        .command = command->name, .what = "arrival", .names = {"arrival", "departure", "arrives"}, .ask = ask};
    gboolean json = FALSE;
    if (!cli_parse(command, NULL, &json, &argc, &argv, error) || !cli_positional(command, argc, 2, -1, error)) return CLI_FAILED;
    return answers_run(&kind, argc, argv, json, error);
}
