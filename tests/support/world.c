/* SPDX-License-Identifier: MIT */
/* A scene with a solver, for tests that ask it questions. */
#include "support/world.h"

#include <math.h>

#include "support/cmocka_all.h"

world world_make(tdsp_journey journey, const tdsp_disc *discs, size_t count)
{
    world w;
    assert_int_equal(tdsp_scene_create(&journey, discs, count, NULL, &w.scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(w.scene, &w.solver), TDSP_OK);
    w.unit = hypot(journey.destination.x - journey.source.x, journey.destination.y - journey.source.y) / journey.speed;
    return w;
}

void world_free(world w)
{
    tdsp_solver_free(w.solver);
    tdsp_scene_free(w.scene);
}

double world_arrival(world w, double departure)
{
    double found = -1.0;
    assert_true(tdsp_status_is_answer(tdsp_earliest_arrival(w.solver, departure, &found)));
    return found;
}
