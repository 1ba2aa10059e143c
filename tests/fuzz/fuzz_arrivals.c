/*
 * Bytes as a small scene whose numbers are degenerate on purpose: a coarse grid of places, radii that touch, rates of 0, of the robot's own
 * speed and beside it. Whatever the scene, the verifier accepts every path, the travel time never falls, a latest departure arrives in time,
 * and no departure that is known to be in time is later.
 */
#include <math.h>
#include <stdlib.h>

#include "tdsp/solver.h"
#include "tdsp/verify.h"

enum { MOST_DISCS = 12, MOST_LEGS = 512, ASKED = 5 };

/* Relative to the journey's time and the times at hand: several times the stated error of an arrival. */
#define SLACK 1e-10

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size);

typedef struct fuzz_input {
    const unsigned char *data;
    size_t left;
} fuzz_input;

typedef struct fuzz_world {
    tdsp_journey journey;
    tdsp_disc discs[MOST_DISCS];
    size_t count;
    tdsp_scene *scene;
    tdsp_solver *solver;
    double unit; /* the journey's time, or 1 */
} fuzz_world;

static void fuzz_require(int holds)
{
    if (!holds) abort();
}

static unsigned fuzz_byte(fuzz_input *input)
{
    if (!input->left) return 0;
    --input->left;
    return *input->data++;
}

/* A place on the half-unit grid in [-8, 8), now and then beside it. */
static double fuzz_coordinate(fuzz_input *input)
{
    static const double beside[8] = {0.0, 0.0, 0.0, 0.0, 0.0, 1e-13, -1e-9, 1.0 / 7.0};
    unsigned byte = fuzz_byte(input);
    return 0.5 * ((int)(byte & 31) - 16) + beside[byte >> 5];
}

static tdsp_disc fuzz_disc(fuzz_input *input)
{
    static const double radii[16] = {0.0, 0.25, 0.5, 0.5, 1.0, 1.0, 1.5, 2.0, 2.5, 3.0, 1e-9, 0.7071067811865476, 1.25, 0.1, 0.3, 5.0};
    static const double rates[16] = {0.0, 0.0, 0.1, 0.1, 0.25, 0.5, 0.5, 0.8660254037844386, 0.9, 0.999, 1.0 - 1e-9, 1.0, 1.5, 1e-9, 0.01, 0.3};
    tdsp_disc disc = {{fuzz_coordinate(input), fuzz_coordinate(input)}, 0.0, 0.0};
    unsigned byte = fuzz_byte(input);
    disc.radius = radii[byte & 15];
    disc.growth = rates[byte >> 4];
    return disc;
}

static void fuzz_read(fuzz_input *input, fuzz_world *world)
{
    static const double robot[4] = {0.0, 0.0, 0.25, 0.1};
    world->journey.speed = 1.0;
    world->journey.radius = robot[fuzz_byte(input) & 3];
    world->journey.source.x = fuzz_coordinate(input);
    world->journey.source.y = fuzz_coordinate(input);
    world->journey.destination.x = fuzz_coordinate(input);
    world->journey.destination.y = fuzz_coordinate(input);
    world->count = 0;
    while (input->left >= 3 && world->count < MOST_DISCS) world->discs[world->count++] = fuzz_disc(input);
    double across = hypot(world->journey.destination.x - world->journey.source.x, world->journey.destination.y - world->journey.source.y);
    world->unit = across > 0.0 ? across : 1.0;
}

static double fuzz_slack(const fuzz_world *world, double travel)
{
    return SLACK * (world->unit + travel);
}

static void fuzz_path(const fuzz_world *world, double departure, double arrival)
{
    tdsp_leg legs[MOST_LEGS];
    size_t count;
    tdsp_verdict verdict;
    fuzz_require(tdsp_solver_path(world->solver, legs, MOST_LEGS, &count) == TDSP_OK);
    tdsp_status status = tdsp_verify_path(world->scene, legs, count, departure, arrival, &verdict);
    fuzz_require(status == TDSP_OK && verdict.problems == 0);
}

/* A(t), infinite when there is no way; the path is checked. */
static double fuzz_arrive(const fuzz_world *world, double departure)
{
    double arrival = -1.0;
    tdsp_status status = tdsp_earliest_arrival(world->solver, departure, &arrival);
    fuzz_require(tdsp_status_is_answer(status) && (status == TDSP_OK) == isfinite(arrival));
    if (status == TDSP_OK) fuzz_path(world, departure, arrival);
    return arrival;
}

/* A^-1(a) for an a that the departure `known` reaches. */
static void fuzz_depart(const fuzz_world *world, double a, double known)
{
    double departure = -1.0, arrives = -1.0;
    tdsp_status status = tdsp_latest_departure(world->solver, a, &departure, &arrives);
    double slack = fuzz_slack(world, a - known);
    if (status == TDSP_ARRIVAL_TOO_EARLY) fuzz_require(known <= slack);
    if (status != TDSP_OK) {
        fuzz_require(status == TDSP_ARRIVAL_TOO_EARLY);
        return;
    }
    fuzz_require(departure >= known - slack && departure <= arrives && arrives <= a);
    fuzz_path(world, departure, arrives);
    double again = fuzz_arrive(world, departure);
    if (again > a + slack) again = fuzz_arrive(world, fmax(departure - 10.0 * slack, 0.0));
    fuzz_require(again <= a + slack);
}

static void fuzz_last(const fuzz_world *world, double known)
{
    tdsp_last_departure last;
    tdsp_status status = tdsp_solver_last_departure(world->solver, &last);
    fuzz_require(tdsp_status_is_answer(status));
    if (known >= 0.0) fuzz_require(status == TDSP_OK && last.departure >= known - fuzz_slack(world, known));
    if (status == TDSP_OK && isfinite(last.departure)) {
        double step = 1e-7 * (world->unit + last.arrival);
        fuzz_require(isinf(fuzz_arrive(world, last.departure + step)));
    }
}

static void fuzz_world_check(const fuzz_world *world, double step)
{
    double before = 0.0, known = -1.0;
    for (int i = 0; i < ASKED; ++i) {
        double departure = step * i, arrival = fuzz_arrive(world, departure);
        fuzz_require(isinf(arrival) || arrival - departure >= before - fuzz_slack(world, before));
        fuzz_require(!(isinf(before) && isfinite(arrival)));
        before = arrival - departure;
        if (isinf(arrival)) continue;
        known = departure;
        fuzz_depart(world, arrival, departure);
        fuzz_depart(world, arrival + 0.37 * step, departure);
    }
    fuzz_last(world, known);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    static const double steps[8] = {0.5, 1.0, 0.1, 2.0, 0.25, 0.7, 1e-3, 4.0};
    fuzz_input input = {data, size};
    fuzz_world world;
    double step = steps[fuzz_byte(&input) & 7];
    fuzz_read(&input, &world);
    fuzz_require(tdsp_scene_create(&world.journey, world.discs, world.count, NULL, &world.scene) == TDSP_OK);
    fuzz_require(tdsp_solver_create(world.scene, &world.solver) == TDSP_OK);
    fuzz_world_check(&world, step);
    tdsp_solver_free(world.solver);
    tdsp_scene_free(world.scene);
    return 0;
}
