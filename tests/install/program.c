/* SPDX-License-Identifier: MIT */
/* What a user's first program does: needs the installed headers and library only. */
#include <stdio.h>
#include <string.h>

#include <tdsp/tdsp.h>

int main(void) {
    tdsp_journey journey = {1.0, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
    tdsp_disc disc = {{0.0, 0.0}, 1.0, 0.25};
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    double arrival = 0.0;
    if (strcmp(tdsp_version(), TDSP_VERSION_STRING) != 0) {
        return 1;
    }
    if (tdsp_scene_create(&journey, &disc, 1, NULL, &scene) != TDSP_OK || tdsp_solver_create(scene, &solver) != TDSP_OK) {
        return 1;
    }
    tdsp_status status = tdsp_earliest_arrival(solver, 0.0, &arrival);
    printf("%s %.6f\n", tdsp_status_name(status), arrival);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return status == TDSP_OK && arrival > 20.0 ? 0 : 1;
}
