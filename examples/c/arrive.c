/* SPDX-License-Identifier: MIT */
/*
 * When does the robot arrive, and along which path? A scene made in code, two departures, and the legs of each path.
 *
 * A boat at 10 m/s has to pass two drifting wrecks whose whereabouts become less certain by the second.
 */
#include <stdio.h>
#include <stdlib.h>

#include "tdsp/scene.h"
#include "tdsp/solver.h"

enum { MAX_LEGS = 32 };

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "arrive: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

static void print_leg(const tdsp_leg *leg)
{
    printf("    %6.2f s to %6.2f s  ", leg->start_time, leg->end_time);
    if (leg->kind == TDSP_LEG_LINE) {
        printf("straight");
    } else {
        printf("around disc %u, %s", (unsigned)leg->disc, leg->turn > 0 ? "it stays to the left" : "it stays to the right");
    }
    printf(" to (%.1f, %.1f)\n", leg->to.x, leg->to.y);
}

static void print_answer(tdsp_solver *solver, double departure)
{
    tdsp_leg legs[MAX_LEGS];
    size_t count = 0;
    double arrival = 0.0;
    tdsp_status status = tdsp_earliest_arrival(solver, departure, &arrival);
    if (tdsp_status_is_answer(status) && status != TDSP_OK) {
        printf("leave at %.0f s: %s\n", departure, tdsp_status_text(status));
        return;
    }
    must(status);
    printf("leave at %.0f s: arrive at %.2f s\n", departure, arrival);
    must(tdsp_solver_path(solver, legs, MAX_LEGS, &count));
    for (size_t i = 0; i < count; i++) {
        print_leg(&legs[i]);
    }
}

int main(void)
{
    const tdsp_journey journey = {.speed = 10.0, .radius = 2.0, .source = {0.0, 0.0}, .destination = {1000.0, 0.0}};
    const tdsp_disc discs[] = {
        {.center = {400.0, 30.0}, .radius = 50.0, .growth = 1.0},
        {.center = {700.0, -60.0}, .radius = 20.0, .growth = 2.0},
    };
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    must(tdsp_scene_create(&journey, discs, 2, NULL, &scene));
    must(tdsp_solver_create(scene, &solver));
    print_answer(solver, 0.0);
    print_answer(solver, 20.0);
    print_answer(solver, 400.0);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return EXIT_SUCCESS;
}
