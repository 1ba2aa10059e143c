/* SPDX-License-Identifier: MIT */
/*
 * Which way out is the nearest, and until when can it be reached? One source, many destinations, one prepared scene.
 *
 * Build: cc many_destinations.c -ltdsp -lm
 */
#include <stdio.h>
#include <stdlib.h>

#include "tdsp/tdsp.h"

#define EXITS 4

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "many_destinations: %s\n", tdsp_status_text(status));
    exit(1);
}

int main(void)
{
    /* Two fires close a gap; the scene's own ends do not matter here. */
    const tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    const tdsp_disc fires[] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};
    const tdsp_point here = {-4.0, 0.0}, exits[EXITS] = {{10.0, 0.0}, {0.0, 12.0}, {0.0, -3.5}, {-12.0, -9.0}};
    double arrivals[EXITS];
    tdsp_status statuses[EXITS];
    tdsp_scene *scene;
    tdsp_solver *solver;
    must(tdsp_scene_create(&journey, fires, 2, NULL, &scene));
    must(tdsp_solver_create(scene, &solver));

    must(tdsp_earliest_arrivals(solver, here, 0.0, exits, EXITS, arrivals, statuses));
    int nearest = -1;
    for (int i = 0; i < EXITS; i++) {
        printf("exit %d: %s", i, tdsp_status_name(statuses[i]));
        if (statuses[i] == TDSP_OK) printf(", arrival %.6f", arrivals[i]);
        printf("\n");
        if (statuses[i] == TDSP_OK && (nearest < 0 || arrivals[i] < arrivals[nearest])) nearest = i;
    }

    /* The path and the last departure of the one chosen. */
    if (nearest >= 0) {
        const tdsp_ends ends = {here, exits[nearest]};
        tdsp_last_departure last;
        must(tdsp_solver_set_ends(solver, &ends));
        must(tdsp_solver_last_departure(solver, &last));
        printf("nearest: exit %d, to be reached by whoever leaves by %.6f (then %s)\n", nearest, last.departure, tdsp_status_name(last.reason));
    }
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return 0;
}
