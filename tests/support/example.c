/* SPDX-License-Identifier: MIT */
/* See example.h. */
#include "support/example.h"

#include "slow/slow.h"
#include "support/cmocka_all.h"

#define NEAR 1e-9

example example_load(const char *path)
{
    example e;
    GError *error = NULL;
    if (!scene_file_load(path, &e.file, &error)) fail_msg("%s", error->message);
    e.journey = tdsp_scene_journey(e.file.scene);
    e.discs = tdsp_scene_discs(e.file.scene, &e.count);
    assert_int_equal(tdsp_solver_create(e.file.scene, &e.solver), TDSP_OK);
    return e;
}

void example_free(example *e)
{
    tdsp_solver_free(e->solver);
    scene_file_clear(&e->file);
}

double example_arrival(const example *e, double departure)
{
    double found = NAN;
    assert_true(tdsp_status_is_answer(tdsp_earliest_arrival(e->solver, departure, &found)));
    return found;
}

double example_travel_time(const example *e, double departure)
{
    return example_arrival(e, departure) - departure;
}

double example_latest(const example *e, double by)
{
    double found = NAN;
    assert_int_equal(tdsp_latest_departure(e->solver, by, &found, NULL), TDSP_OK);
    return found;
}

double example_last(const example *e)
{
    tdsp_last_departure last;
    assert_int_equal(tdsp_solver_last_departure(e->solver, &last), TDSP_OK);
    return last.departure;
}

double example_agreed_arrival(const example *e, double departure)
{
    const double found = example_arrival(e, departure);
    assert_near(found, slow_arrival(e->journey, e->discs, e->count, departure), NEAR * found);
    return found;
}
