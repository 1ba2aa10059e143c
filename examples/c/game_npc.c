/* SPDX-License-Identifier: MIT */
/*
 * Guards of a game run to a courier who walks on, among fires that spread; a frame has 16 ms, of which planning may take one question.
 *
 *   game_npc [--time]    --time tells on stderr how long the slowest question took
 *
 * The fires are prepared once. Each frame one guard, in turn, asks for a way to where the courier is by now; the others walk on along the way that they
 * have. That way stays safe however old it is, as every fire's growth was reckoned with, so a guard who finds no new one is never without an old one.
 * The room is made up: metres, seconds.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "tdsp/path.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"

#define FRAME 0.016   /* s */
#define GOOD_ENOUGH 0.05 /* a way that takes 5 % longer than the best will do */
enum { GUARDS = 3, MAX_LEGS = 64, FRAMES = 2000 };

typedef struct Guard {
    tdsp_point place;
    tdsp_leg legs[MAX_LEGS]; /* the way that he walks */
    size_t count;            /* 0: he stands */
    int planned, kept;       /* questions with a new way, and without */
    double caught;           /* when he had the courier; negative: not yet */
} Guard;

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "game_npc: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

static tdsp_point courier_at(double now)
{
    return (tdsp_point){5.0 + 1.2 * now, 24.0 - 0.1 * now};
}

/* One question. It cannot be interrupted; what it may take is what --time shows for the largest scene of the game. */
static void plan(Guard *guard, tdsp_solver *solver, double now)
{
    const tdsp_ends ends = {guard->place, courier_at(now)};
    tdsp_leg legs[MAX_LEGS];
    size_t count = 0;
    double arrival = 0.0, lower = 0.0;
    must(tdsp_solver_set_ends(solver, &ends));
    tdsp_status status = tdsp_earliest_arrival_within(solver, now, GOOD_ENOUGH, &arrival, &lower);
    if (status == TDSP_OK) status = tdsp_solver_path(solver, legs, MAX_LEGS, &count);
    if (status == TDSP_OK) {
        memcpy(guard->legs, legs, count * sizeof *legs);
        guard->count = count;
        guard->planned++;
    } else if (tdsp_status_is_answer(status) || status == TDSP_BUFFER_TOO_SMALL) {
        guard->kept++; /* no way there for now: he keeps to the one that he has */
    } else {
        must(status);
    }
}

static void walk(Guard *guard, double now)
{
    tdsp_point courier = courier_at(now);
    if (guard->count > 0) must(tdsp_path_position(guard->legs, guard->count, now, &guard->place));
    if (hypot(guard->place.x - courier.x, guard->place.y - courier.y) < 0.5) guard->caught = now;
}

/* Returns the slowest question, in seconds of processor time. */
static double play(Guard *guards, tdsp_solver *solver)
{
    double slowest = 0.0;
    for (int frame = 0; frame < FRAMES; frame++) {
        Guard *turn = &guards[frame % GUARDS];
        clock_t start = clock();
        if (turn->caught < 0.0) plan(turn, solver, frame * FRAME);
        slowest = fmax(slowest, (double)(clock() - start) / CLOCKS_PER_SEC);
        for (int i = 0; i < GUARDS; i++)
            if (guards[i].caught < 0.0) walk(&guards[i], (frame + 1) * FRAME);
    }
    return slowest;
}

int main(int argc, char **argv)
{
    /* The ends are those of the room: each question brings its own. */
    const tdsp_journey room = {.speed = 3.0, .radius = 0.4, .source = {0.0, 0.0}, .destination = {40.0, 25.0}};
    const tdsp_disc fires[] = {
        {{10.0, 6.0}, 1.0, 0.15}, {{16.0, 14.0}, 1.5, 0.10}, {{22.0, 8.0}, 0.5, 0.20}, {{9.0, 17.0}, 1.0, 0.05},
        {{28.0, 16.0}, 1.0, 0.12}, {{33.0, 7.0}, 2.0, 0.00}, {{20.0, 20.0}, 0.5, 0.20}, {{5.0, 11.0}, 0.8, 0.10},
        {{38.0, 14.0}, 0.3, 0.45},
    };
    Guard guards[GUARDS] = {{.place = {2.0, 2.0}, .caught = -1.0}, {.place = {30.0, 2.0}, .caught = -1.0}, {.place = {38.0, 16.5}, .caught = -1.0}};
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    must(tdsp_scene_create(&room, fires, sizeof fires / sizeof *fires, NULL, &scene));
    must(tdsp_solver_create(scene, &solver));
    double slowest = play(guards, solver);
    for (int i = 0; i < GUARDS; i++) {
        printf("guard %d: %d ways planned, %d kept, ", i, guards[i].planned, guards[i].kept);
        if (guards[i].caught >= 0.0) printf("has the courier after %.1f s\n", guards[i].caught);
        else printf("without the courier at (%.1f, %.1f)\n", guards[i].place.x, guards[i].place.y);
    }
    if (argc > 1 && !strcmp(argv[1], "--time")) fprintf(stderr, "slowest question: %.3f ms of a frame's 16\n", 1000.0 * slowest);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return EXIT_SUCCESS;
}
