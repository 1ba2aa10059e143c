/* SPDX-License-Identifier: MIT */
/*
 * Discs that grow as laws of one's own say: a fire that burns out, and a crowd that walks off at an alarm.
 *
 * The fire spreads ever more slowly and stops at its final radius; the crowd stands still, and from the alarm on may be anywhere that
 * its walking speed reaches. Both are callbacks; where a law is not smooth, its time is told. For comparison, what a planner has to
 * assume who knows the greatest rates only.
 */
#include <stdio.h>
#include <stdlib.h>

#include "tdsp/growth.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"

typedef struct Fire {
    double radius; /* m, at the start */
    double final;  /* m */
    double out;    /* s: when it stops */
} Fire;

typedef struct Crowd {
    double radius; /* m, until the alarm */
    double alarm;  /* s */
    double speed;  /* m/s */
} Crowd;

static void fire_law(void *ctx, double time, double *radius, double *rate)
{
    const Fire *fire = ctx;
    double left = time < fire->out ? 1.0 - time / fire->out : 0.0;
    *radius = fire->final - (fire->final - fire->radius) * left * left;
    *rate = 2.0 * (fire->final - fire->radius) * left / fire->out;
}

static void crowd_law(void *ctx, double time, double *radius, double *rate)
{
    const Crowd *crowd = ctx;
    *radius = crowd->radius + (time > crowd->alarm ? crowd->speed * (time - crowd->alarm) : 0.0);
    *rate = time >= crowd->alarm ? crowd->speed : 0.0;
}

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "growth_laws: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

static const tdsp_journey journey = {.speed = 2.0, .radius = 0.5, .source = {0.0, 0.0}, .destination = {100.0, 0.0}};

static tdsp_scene *scene_of_laws(Fire *fire, Crowd *crowd)
{
    const tdsp_growing_disc discs[] = {
        {.center = {35.0, 4.0}, .radius = fire->radius, .growth = {.kind = TDSP_GROWTH_LAW, .law = fire_law, .ctx = fire, .until = fire->out}},
        {.center = {60.0, -3.0},
         .radius = crowd->radius,
         .growth = {.kind = TDSP_GROWTH_LAW, .law = crowd_law, .ctx = crowd, .times = &crowd->alarm, .count = 1, .until = 2.0 * crowd->alarm}},
    };
    tdsp_scene *scene = NULL;
    for (size_t i = 0; i < 2; i++) {
        const char *wrong = tdsp_growing_disc_check(&discs[i]);
        if (wrong) fprintf(stderr, "growth_laws: disc %u: %s\n", (unsigned)i, wrong);
    }
    must(tdsp_scene_create_growing(&journey, discs, 2, NULL, &scene));
    return scene;
}

static tdsp_scene *scene_of_greatest_rates(const Fire *fire, const Crowd *crowd)
{
    const tdsp_disc discs[] = {
        {.center = {35.0, 4.0}, .radius = fire->radius, .growth = 2.0 * (fire->final - fire->radius) / fire->out},
        {.center = {60.0, -3.0}, .radius = crowd->radius, .growth = crowd->speed},
    };
    tdsp_scene *scene = NULL;
    must(tdsp_scene_create(&journey, discs, 2, NULL, &scene));
    return scene;
}

static void print_radii(const tdsp_scene *scene)
{
    printf("  time    fire   crowd\n");
    for (double time = 0.0; time <= 120.0; time += 20.0) {
        double fire = 0.0, crowd = 0.0;
        must(tdsp_scene_disc_at(scene, 0, time, &fire, NULL));
        must(tdsp_scene_disc_at(scene, 1, time, &crowd, NULL));
        printf("%4.0f s  %4.1f m  %4.1f m\n", time, fire, crowd);
    }
}

static void print_arrivals(const char *what, const tdsp_scene *scene)
{
    tdsp_solver *solver = NULL;
    must(tdsp_solver_create(scene, &solver));
    printf("%s\n", what);
    for (double departure = 0.0; departure <= 80.0; departure += 20.0) {
        double arrival = 0.0;
        tdsp_status status = tdsp_earliest_arrival(solver, departure, &arrival);
        if (status != TDSP_OK && !tdsp_status_is_answer(status)) must(status);
        if (status == TDSP_OK) printf("  leave at %2.0f s: arrive at %.3f s, after %.3f s\n", departure, arrival, arrival - departure);
        else printf("  leave at %2.0f s: %s\n", departure, tdsp_status_text(status));
    }
    tdsp_solver_free(solver);
}

int main(void)
{
    Fire fire = {.radius = 3.0, .final = 12.0, .out = 90.0};
    Crowd crowd = {.radius = 2.0, .alarm = 60.0, .speed = 0.6};
    tdsp_scene *laws = scene_of_laws(&fire, &crowd), *rates = scene_of_greatest_rates(&fire, &crowd);
    print_radii(laws);
    print_arrivals("as the laws say:", laws);
    print_arrivals("at the greatest rates all the time:", rates);
    tdsp_scene_free(laws);
    tdsp_scene_free(rates);
    return EXIT_SUCCESS;
}
