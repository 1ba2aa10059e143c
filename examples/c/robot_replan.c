/* SPDX-License-Identifier: MIT */
/*
 * A robot crosses a hall in which people walk about, and plans anew ten times a second from where they are seen then.
 *
 * A person seen at a place may be anywhere that walking speed reaches from there: a disc that grows. Each cycle makes a scene of what was
 * just measured, with its own time 0, and asks for the way from where the robot will be at the cycle's end, so that planning may take all of the
 * cycle. Where there is no such way the robot keeps the last one: it was safe whatever anybody does, and still is. Before the first it waits.
 * The hall and its people are made up.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tdsp/path.h"
#include "tdsp/scene.h"
#include "tdsp/solver.h"

#define CYCLE 0.1      /* s */
#define WALKING 0.5    /* m/s: nobody is faster */
#define PERSON 0.3     /* m: the radius of a person */
#define SEEN_WITHIN 0.1 /* m: measured places are that good */
enum { PEOPLE = 5, MAX_LEGS = 64, CYCLES = 300 };

static const tdsp_journey errand = {.speed = 1.5, .radius = 0.25, .source = {0.0, 0.0}, .destination = {9.0, 0.5}};

typedef struct Plan {
    tdsp_leg legs[MAX_LEGS]; /* in the time of the cycle in which they were planned */
    size_t count;     /* 0: it stands at `place` */
    tdsp_point place;
    double made; /* the start of that cycle */
} Plan;

static void must(tdsp_status status)
{
    if (status == TDSP_OK) return;
    fprintf(stderr, "robot_replan: %s\n", tdsp_status_text(status));
    exit(EXIT_FAILURE);
}

/* Where person i really is: on a circle, at up to WALKING. */
static tdsp_point person_at(int i, double now)
{
    static const double walks[PEOPLE][4] = {{4, 2.6, 1.0, -0.5}, {5, -2.4, 1.2, -0.4}, {8, 4.5, 1.5, 0.3}, {10, -3.6, 0.6, 0.8}, {3, -3.2, 0.8, -0.6}};
    const double *walk = walks[i];
    return (tdsp_point){walk[0] + walk[2] * cos(walk[3] * now), walk[1] + walk[2] * sin(walk[3] * now)};
}

/* What the sensor says: off by up to SEEN_WITHIN, here to one side and the other in turn. */
static void measure(tdsp_disc *seen, double now, int cycle)
{
    for (int i = 0; i < PEOPLE; i++) {
        tdsp_point place = person_at(i, now);
        double off = (cycle + i) % 2 ? 0.7 * SEEN_WITHIN : -0.7 * SEEN_WITHIN;
        seen[i] = (tdsp_disc){{place.x + off, place.y - off}, PERSON + SEEN_WITHIN, WALKING};
    }
}

static tdsp_point robot_at(const Plan *plan, double now)
{
    tdsp_point place = plan->place;
    if (plan->count > 0) must(tdsp_path_position(plan->legs, plan->count, now - plan->made, &place));
    return place;
}

/* Plans from `from`, where the robot is when the cycle ends. Why there is no plan is an answer, not an error; `plan` then stays. */
static tdsp_status replan(Plan *plan, tdsp_point from, const tdsp_disc *seen, double now)
{
    tdsp_journey journey = errand;
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    Plan fresh = {.place = from, .made = now};
    double arrival = 0.0;
    journey.source = from;
    must(tdsp_scene_create(&journey, seen, PEOPLE, NULL, &scene));
    must(tdsp_solver_create(scene, &solver));
    tdsp_status status = tdsp_earliest_arrival(solver, CYCLE, &arrival);
    if (status == TDSP_OK) status = tdsp_solver_path(solver, fresh.legs, MAX_LEGS, &fresh.count);
    if (status == TDSP_OK) *plan = fresh;
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return status;
}

/* The least distance between robot and people during a cycle, from skin to skin. */
static double least_distance(const Plan *plan, double now)
{
    double least = INFINITY;
    for (int step = 0; step < 10; step++) {
        double time = now + CYCLE * step / 10.0;
        tdsp_point robot = robot_at(plan, time);
        for (int i = 0; i < PEOPLE; i++) {
            tdsp_point person = person_at(i, time);
            least = fmin(least, hypot(robot.x - person.x, robot.y - person.y) - errand.radius - PERSON);
        }
    }
    return least;
}

int main(void)
{
    Plan plan = {.place = errand.source};
    tdsp_status last = TDSP_OK;
    double least = INFINITY;
    int cycle, planned = 0, kept = 0;
    for (cycle = 0; cycle < CYCLES; cycle++) {
        double now = cycle * CYCLE;
        Plan driven = plan; /* during this cycle, while the next plan is made */
        tdsp_disc seen[PEOPLE];
        tdsp_point robot = robot_at(&plan, now);
        if (hypot(robot.x - errand.destination.x, robot.y - errand.destination.y) < 1e-9) break;
        measure(seen, now, cycle);
        tdsp_status status = replan(&plan, robot_at(&plan, now + CYCLE), seen, now);
        if (status != TDSP_OK && !tdsp_status_is_answer(status)) must(status);
        if (status == TDSP_OK) planned++;
        else kept++;
        if (cycle == 0 || status != last) {
            printf("%4.1f s at (%5.2f, %5.2f): %s\n", now, robot.x + 0.0, robot.y + 0.0, status == TDSP_OK ? "a new way each cycle" : tdsp_status_text(status));
        }
        last = status;
        least = fmin(least, least_distance(&driven, now));
    }
    printf("there after %.1f s: %d ways planned, %d times the last one kept\n", cycle * CYCLE, planned, kept);
    printf("never closer than %.2f m to anybody\n", least);
    return EXIT_SUCCESS;
}
