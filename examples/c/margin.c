/* SPDX-License-Identifier: MIT */
/*
 * A fire crew's trigger: by when must they leave, and how wrong may the forecast be?
 *
 * Two fronts spread towards the road between the crew and the safety zone. Times are minutes from now, and the crew has to be there by minute 159. If the fronts
 * keep their forecast rates it is enough to leave before the gap closes. How much faster may they spread before a departure fails? When
 * that is less than the forecast's own error, the trigger is pulled.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "tdsp/margin.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"

#define FORECAST_ERROR 1.3 /* rates may be that much higher than forecast */

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "margin: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

static void print_latest(tdsp_solver *solver, double deadline)
{
    tdsp_deadline_answer latest;
    must(tdsp_solver_deadline(solver, deadline, &latest));
    printf("in the zone by minute %.0f: leave by %.2f, limited by %s", deadline, latest.departure,
           tdsp_limit_name(latest.witness.limit));
    if (latest.witness.limit == TDSP_LIMIT_GAP)
        printf(" (fronts %u and %u at minute %.2f)", (unsigned)latest.witness.disc, (unsigned)latest.witness.other,
               latest.witness.time);
    printf("\n");
}

static void print_trigger(const tdsp_scene *scene, tdsp_solver *solver, double departure, double deadline)
{
    tdsp_slack slack;
    tdsp_margin factor, added;
    must(tdsp_solver_slack(solver, departure, deadline, &slack));
    must(tdsp_departure_margin(scene, TDSP_RAISE_FACTOR, departure, deadline, &factor));
    must(tdsp_departure_margin(scene, TDSP_RAISE_ADDED, departure, deadline, &added));
    printf("leave at %3.0f: %5.2f min to spare, rates may rise %.3f-fold or by %.2f m/min: %s\n", departure, slack.later,
           factor.most, added.most, factor.most < FORECAST_ERROR ? "go now" : "may wait");
}

int main(void)
{
    const tdsp_journey drive = {.speed = 500.0, .radius = 10.0, .source = {0.0, 0.0}, .destination = {6000.0, 0.0}};
    const tdsp_disc fronts[] = {
        {.center = {3000.0, 1600.0}, .radius = 400.0, .growth = 8.0},
        {.center = {3200.0, -1900.0}, .radius = 500.0, .growth = 9.0},
    };
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    must(tdsp_scene_create(&drive, fronts, 2, NULL, &scene));
    must(tdsp_solver_create(scene, &solver));
    print_latest(solver, 120.0);
    print_latest(solver, 159.0);
    for (double departure = 60.0; departure <= 150.0; departure += 20.0) print_trigger(scene, solver, departure, 159.0);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return EXIT_SUCCESS;
}
