/* SPDX-License-Identifier: MIT */
/*
 * A fire crew's trigger point: which place must the front not pass before the crew leaves?
 *
 * The way to the safety zone closes when fronts meet, and the forecast of their rates may be wrong. So the rates are raised by a safety factor,
 * the last departure is asked for in that worse world, and where the fronts stand at that moment are the trigger points: a line on the map that a lookout
 * can watch, without a clock. Whichever front comes to its line first: if none spreads faster than the factor allows from then on, the way stays open for
 * long enough. The fires are made up: metres, minutes.
 */
#include <stdio.h>
#include <stdlib.h>

#include "tdsp/growth.h"
#include "tdsp/margin.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"

#define SAFETY 1.5   /* rates may be that much higher than forecast */
#define GETTING_READY 10.0 /* minutes from the call to the departure */
#define DEADLINE 100.0 /* minutes: then it is dark */
enum { FRONTS = 3 };

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "fire_trigger: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

/* The last departure that still gets through, and what closes then. */
static double last_chance(const tdsp_scene *scene, const char *world)
{
    tdsp_solver *solver = NULL;
    tdsp_deadline_answer last;
    must(tdsp_solver_create(scene, &solver));
    must(tdsp_solver_deadline(solver, DEADLINE, &last));
    printf("%s: leave by minute %.1f, there at minute %.1f", world, last.departure, last.arrival);
    printf(", limited by %s", tdsp_limit_name(last.witness.limit));
    if (last.witness.limit == TDSP_LIMIT_GAP)
        printf(":\n    fronts %u and %u close the way at (%.0f, %.0f) at minute %.1f, around them it takes until minute %.0f",
               (unsigned)last.witness.disc, (unsigned)last.witness.other, last.witness.place.x, last.witness.place.y, last.witness.time,
               last.after_arrival);
    printf("\n");
    tdsp_solver_free(solver);
    return last.departure;
}

int main(void)
{
    /* On foot through brush, 70 m a minute, and 15 m from any flame. */
    const tdsp_journey retreat = {.speed = 70.0, .radius = 15.0, .source = {0.0, 0.0}, .destination = {3000.0, 0.0}};
    const tdsp_disc fronts[FRONTS] = {
        {.center = {900.0, 1100.0}, .radius = 250.0, .growth = 9.0},
        {.center = {1300.0, -700.0}, .radius = 120.0, .growth = 7.0},
        {.center = {-900.0, 900.0}, .radius = 200.0, .growth = 6.0},
    };
    tdsp_scene *forecast = NULL, *worse = NULL;
    tdsp_margin margin;
    must(tdsp_scene_create(&retreat, fronts, FRONTS, NULL, &forecast));
    must(tdsp_scene_raise(forecast, TDSP_RAISE_FACTOR, SAFETY, &worse));
    last_chance(forecast, "as forecast");
    double trigger = last_chance(worse, "half as fast again") - GETTING_READY;

    printf("call the crew at minute %.1f, or as soon as\n", trigger);
    for (uint32_t i = 0; i < FRONTS; i++) {
        double radius = 0.0;
        must(tdsp_scene_disc_at(worse, i, trigger, &radius, NULL));
        printf("    front %u has come %.0f m farther than now, %.0f m from where it began\n", (unsigned)i, radius - fronts[i].radius, radius);
    }
    for (double departure = trigger; departure <= trigger + GETTING_READY; departure += GETTING_READY) {
        must(tdsp_departure_margin(forecast, TDSP_RAISE_FACTOR, departure, DEADLINE, &margin));
        printf("who leaves at minute %.1f bears rates %.2f times those of the forecast\n", departure, margin.most);
    }
    tdsp_scene_free(worse);
    tdsp_scene_free(forecast);
    return EXIT_SUCCESS;
}
