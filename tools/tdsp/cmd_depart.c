/* tdsp depart: exact latest departures. */
#include <math.h>

#include "answers.h"
#include "commands.h"

static gboolean ask(const AnswerKind *kind, const SceneSolver *solver, Answer *answer, GError **error)
{
    double *departure = &answer->numbers[1], *arrives = &answer->numbers[2];
    tdsp_deadline_answer latest;
    answer->witness = (tdsp_witness){TDSP_LIMIT_NONE, TDSP_NO_DISC, TDSP_NO_DISC, INFINITY, {0, 0}};
    answer->status = kind->limits ? tdsp_solver_deadline(solver->solver, answer->numbers[0], &latest)
                                  : tdsp_latest_departure(solver->solver, answer->numbers[0], departure, arrives);
    if (!tdsp_status_is_answer(answer->status)) return scene_solver_fail(solver, answer->status, error);
    if (answer->status != TDSP_OK) {
        *departure = *arrives = INFINITY;
    } else if (kind->limits) {
        *departure = latest.departure;
        *arrives = latest.arrival;
        answer->witness = latest.witness;
    }
    return TRUE;
}

int cmd_depart(const CliCommand *command, int argc, char **argv, GError **error)
{
    AnswerKind kind = {.command = command->name, .what = "arrival", .names = {"arrival", "departure", "arrives"}, .ask = ask};
    gboolean json = FALSE;
    if (!cli_parse(command, NULL, &json, &argc, &argv, error) || !cli_positional(command, argc, 2, -1, error)) return CLI_FAILED;
    kind.limits = json; /* they take more searches; the text says nothing of them */
    return answers_run(&kind, argc, argv, json, error);
}
