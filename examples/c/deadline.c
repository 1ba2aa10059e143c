/* SPDX-License-Identifier: MIT */
/*
 * To arrive by a given time, when must the robot leave at the latest?
 *
 * Two discs leave a gap that closes. Whoever leaves in time goes straight through it; a moment later the way around takes 3.7 s
 * longer, so that every deadline between the two has the same answer: the last moment at which the gap can still be passed.
 */
#include <stdio.h>
#include <stdlib.h>

#include "tdsp/scene.h"
#include "tdsp/solver.h"

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "deadline: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

static void print_latest(tdsp_solver *solver, double deadline)
{
    double departure = 0.0, arrives = 0.0;
    tdsp_status status = tdsp_latest_departure(solver, deadline, &departure, &arrives);
    if (status == TDSP_ARRIVAL_TOO_EARLY) {
        printf("be there by %5.2f: %s\n", deadline, tdsp_status_text(status));
        return;
    }
    must(status);
    printf("be there by %5.2f: leave by %.6f, arrive at %.6f\n", deadline, departure, arrives);
}

int main(void)
{
    const tdsp_journey journey = {.speed = 1.0, .radius = 0.0, .source = {-10.0, 0.0}, .destination = {10.0, 0.0}};
    const tdsp_disc discs[] = {
        {.center = {0.0, 3.0}, .radius = 1.0, .growth = 0.1},
        {.center = {0.0, -3.0}, .radius = 1.0, .growth = 0.1},
    };
    const double deadlines[] = {15.0, 25.0, 30.35, 33.0, 40.0};
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    tdsp_last_departure last;
    must(tdsp_scene_create(&journey, discs, 2, NULL, &scene));
    must(tdsp_solver_create(scene, &solver));
    for (size_t i = 0; i < sizeof deadlines / sizeof deadlines[0]; i++) {
        print_latest(solver, deadlines[i]);
    }
    must(tdsp_solver_last_departure(solver, &last));
    printf("after %.6f there is no way: %s\n", last.departure, tdsp_status_text(last.reason));
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return EXIT_SUCCESS;
}
