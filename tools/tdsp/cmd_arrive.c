/* tdsp arrive: exact earliest arrivals. */
#include <math.h>

#include "commands.h"
#include "json_out.h"
#include "progress.h"
#include "scene_solver.h"
#include "text_table.h"
#include "times.h"

typedef struct Answer {
    double departure, arrival, seconds;
    tdsp_status status;
} Answer;

static double travel_time(const Answer *answer)
{
    return answer->arrival - answer->departure;
}

static gboolean solve(tdsp_solver *solver, const GArray *departures, GArray *answers, GError **error)
{
    Progress progress = progress_begin("arrive");
    gboolean solved = TRUE;
    for (guint i = 0; solved && i < departures->len; i++) {
        Answer answer = {.departure = g_array_index(departures, double, i)};
        Stopwatch watch = stopwatch_start();
        solved = scene_solver_arrival(solver, answer.departure, &answer.arrival, &answer.status, error);
        answer.seconds = stopwatch_seconds(watch);
        g_array_append_val(answers, answer);
        progress_show(&progress, i + 1, departures->len);
    }
    progress_end(&progress);
    return solved;
}

static gboolean print_text(const GArray *answers, GError **error)
{
    static const char *const heading[] = {"departure", "arrival", "travel_time", "status", "seconds", NULL};
    g_auto(TextTable) table = text_table_new(heading);
    for (guint i = 0; i < answers->len; i++) {
        const Answer *answer = &g_array_index(answers, Answer, i);
        text_table_number(&table, answer->departure);
        text_table_number(&table, answer->arrival);
        text_table_number(&table, travel_time(answer));
        text_table_string(&table, tdsp_status_name(answer->status));
        text_table_number(&table, answer->seconds);
    }
    return text_table_print(&table, error);
}

static gboolean print_json(const GArray *answers, double prepare_seconds, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_number(&out, "prepare_seconds", prepare_seconds);
    json_out_key(&out, "results");
    json_out_begin(&out, '[');
    for (guint i = 0; i < answers->len; i++) {
        const Answer *answer = &g_array_index(answers, Answer, i);
        json_out_line(&out);
        json_out_begin(&out, '{');
        json_out_member_number(&out, "departure", answer->departure);
        json_out_member_number(&out, "arrival", answer->arrival);
        json_out_member_number(&out, "travel_time", travel_time(answer));
        json_out_member_string(&out, "status", tdsp_status_name(answer->status));
        json_out_member_number(&out, "seconds", answer->seconds);
        json_out_end(&out, '}');
    }
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

int cmd_arrive(const CliCommand *command, int argc, char **argv, GError **error)
{
    gboolean json = FALSE;
    g_autoptr(GArray) departures = times_new();
    g_autoptr(GArray) answers = g_array_new(FALSE, FALSE, sizeof(Answer));
    g_auto(SceneSolver) solver = {0};
    if (!cli_parse(command, NULL, &json, &argc, &argv, error) || !cli_positional(command, argc, 2, -1, error) ||
        !times_add_all(departures, argc, argv, 2, "departure", error) || !scene_solver_load(argv[1], &solver, error) ||
        !solve(solver.solver, departures, answers, error))
        return CLI_FAILED;
    if (!(json ? print_json(answers, solver.prepare_seconds, error) : print_text(answers, error))) return CLI_FAILED;
    return cli_answer(any_ok(answers));
}
