/* SPDX-License-Identifier: MIT */
/*
 * Solving again. Forwards: A(t) must not be before a table's lower end or after its upper one. Backwards, by a search of its own in
 * reversed time: the latest departure that arrives by A(t) is not before t, or the forward answer was not the earliest; and for a
 * moment less than A(t) it is not after t.
 *
 * Both hold up to rounding. An error e of arrivals becomes one of departures as steep as A^-1 is, which is at most 1 because
 * A(t) - t never decreases.
 */
#include <math.h>

#include "cli.h"
#include "progress.h"
#include "scene_solver.h"
#include "verify_report.h"

#define ROUNDING 1e-8 /* relative to the times compared; the solver's stated error is far below */

static double slack(double departure, double arrival)
{
    return ROUNDING * (arrival - departure) + 1e-12 * arrival;
}

/* Is `arrival`, the forward answer for `departure`, what the search backwards finds? */
static gboolean check_backwards(VerifyReport *report, const SceneSolver *solver, double departure, double arrival, GError **error)
{
    double latest, margin = slack(departure, arrival);
    tdsp_status status = tdsp_latest_departure(solver->solver, arrival, &latest, NULL);
    if (!tdsp_status_is_answer(status)) return scene_solver_fail(solver, status, error);
    if (status == TDSP_ARRIVAL_TOO_EARLY && departure <= margin) return TRUE;
    if (status != TDSP_OK)
        verify_report_problem(report, "departure %.17g: arrives at %.17g forwards, but backwards: %s", departure, arrival,
                              tdsp_status_name(status));
    else if (latest < departure - margin)
        verify_report_problem(report, "departure %.17g: arrives at %.17g forwards, but backwards departs at %.17g", departure,
                              arrival, latest);
    if (arrival - 2 * margin <= departure) return TRUE;
    status = tdsp_latest_departure(solver->solver, arrival - 2 * margin, &latest, NULL);
    if (!tdsp_status_is_answer(status)) return scene_solver_fail(solver, status, error);
    if (status == TDSP_OK && latest > departure)
        verify_report_problem(report, "departure %.17g: backwards finds an arrival before %.17g", departure, arrival);
    return TRUE;
}

gboolean verify_deep_path(VerifyReport *report, const SceneSolver *solver, const PathFile *path, GError **error)
{
    double arrival;
    tdsp_status status;
    if (!scene_solver_arrival(solver, path->departure, &arrival, &status, error)) return FALSE;
    if (status != TDSP_OK) {
        if (isfinite(path->arrival)) verify_report_problem(report, "the solver finds no path: %s", tdsp_status_name(status));
        return TRUE;
    }
    if (path->arrival < arrival - slack(path->departure, arrival))
        verify_report_problem(report, "arrives at %.17g, before the earliest arrival %.17g", path->arrival, arrival);
    if (!check_backwards(report, solver, path->departure, arrival, error)) return FALSE;
    double travel = arrival - path->departure;
    verify_report_checked(
        report, "deep: solved 1 departure again, forwards and backwards; the path takes %.6g times the least travel time",
        travel > 0 ? (path->arrival - path->departure) / travel : 1);
    return TRUE;
}

static gboolean check_departure(VerifyReport *report, const SceneSolver *solver, const tdsp_table *table, double departure,
                                GError **error)
{
    double arrival, lower, upper;
    tdsp_status status, answer;
    status = tdsp_table_arrival(table, departure, &lower, &upper);
    if (status != TDSP_OK) return cli_fail_status(error, "table", status);
    if (!scene_solver_arrival(solver, departure, &arrival, &answer, error)) return FALSE;
    if (answer != TDSP_OK) {
        verify_report_problem(report, "departure %.17g: the table has a path, the solver has none: %s", departure,
                              tdsp_status_name(answer));
        return TRUE;
    }
    double margin = slack(departure, arrival);
    if (arrival < lower - margin || arrival > upper + margin)
        verify_report_problem(report, "departure %.17g: arrival %.17g is outside [%.17g, %.17g]", departure, arrival, lower,
                              upper);
    return check_backwards(report, solver, departure, arrival, error);
}

gboolean verify_deep_table(VerifyReport *report, const SceneSolver *solver, const tdsp_table *table, guint departures, GError **error)
{
    tdsp_table_info info;
    tdsp_status status = tdsp_table_get_info(table, &info);
    if (status != TDSP_OK) return cli_fail_status(error, "table", status);
    Progress progress = progress_begin("verify");
    gboolean done = TRUE;
    for (guint i = 0; done && i < departures; i++) {
        done = check_departure(report, solver, table, info.last_departure * ((i + 0.5) / departures), error);
        progress_show(&progress, i + 1, departures);
    }
    progress_end(&progress);
    verify_report_checked(report, "deep: solved %u departures again, forwards and backwards", departures);
    return done;
}
