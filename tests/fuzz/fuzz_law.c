/* SPDX-License-Identifier: MIT */
/*
 * Growth laws that do whatever the bytes say: jump, fall, run to infinity, answer with no number, differ from one call to the next. Making a scene of them is refused, or
 * gives one whose radii never fall and whose questions are answered; and the parts of any scene say the same of it as it was given.
 */
#include <math.h>
#include <string.h>

#include "input.h"
#include "tdsp/growth.h"
#include "tdsp/solver.h"

enum { STEPS = 8 };

typedef struct byte_law {
    unsigned kind;
    double radius, at[STEPS], rate[STEPS]; /* the rate from each time on, and what else happens there */
    unsigned char trick[STEPS];
    unsigned calls;
} byte_law;

static void law_read(byte_law *law, fuzz_input *in)
{
    double time = 0.0;
    memset(law, 0, sizeof *law);
    law->kind = input_byte(in);
    law->radius = (double)input_byte(in) / 32.0;
    for (int i = 0; i < STEPS; i++) {
        law->at[i] = time;
        law->rate[i] = (double)input_byte(in) / 64.0;
        law->trick[i] = (unsigned char)input_byte(in);
        time += (double)(1 + input_byte(in)) / 32.0;
    }
}

/* The steps' sum, smooth in the odd kinds; then what goes wrong. */
static void law_at(void *ctx, double time, double *radius, double *rate)
{
    byte_law *law = ctx;
    double sum = law->radius, now = 0.0;
    fuzz_require(time >= 0.0 && isfinite(time), "asked about a time that is none");
    law->calls++;
    for (int i = 0; i < STEPS && time >= law->at[i]; i++) {
        const double end = i + 1 < STEPS ? fmin(time, law->at[i + 1]) : time, span = end - law->at[i];
        sum += law->rate[i] * (law->kind & 1u ? span * span : span);
        now = law->rate[i] * (law->kind & 1u ? 2.0 * span : 1.0);
        switch (law->trick[i]) {
        case 1: sum -= 0.5; break;
        case 2: now = NAN; break;
        case 3: sum = INFINITY; break;
        case 4: now = -now - 0.1; break;
        case 5: sum += 1.0; break;
        case 6: sum += law->calls; break;
        case 7: now = 1e200; break;
        case 8: sum += 1e-9 * sin(1e6 * time); break;
        default: break;
        }
    }
    *radius = sum;
    *rate = now;
}

static void law_check_radii(const tdsp_scene *scene, size_t count, double until)
{
    for (uint32_t i = 0; i < count; i++) {
        double before = 0.0, radius = 0.0, rate = 0.0;
        for (int k = 0; k <= 16; k++) {
            fuzz_require(tdsp_scene_disc_at(scene, i, until * k / 12.0, &radius, &rate) == TDSP_OK, "no radius");
            fuzz_require(radius >= before * (1.0 - 1e-9) - 1e-9 && rate >= -1e-6 * (1.0 + radius), "a radius falls");
            before = radius;
        }
    }
    fuzz_require(tdsp_scene_disc_at(scene, (uint32_t)count, 0.0, NULL, NULL) == TDSP_INVALID_ARGUMENT, "a disc that is not there");
}

/* What the scene says of itself. */
static void law_check_parts(const tdsp_scene *scene, const tdsp_journey *journey, size_t count)
{
    size_t given = 0;
    uint32_t disc = 0;
    const tdsp_ends own = {journey->source, journey->destination}, other = {journey->destination, journey->source};
    (void)tdsp_scene_discs(scene, &given);
    fuzz_require(given == count && memcmp(tdsp_scene_journey(scene), journey, sizeof *journey) == 0, "another scene than was given");
    fuzz_require(tdsp_scene_hash(scene) == tdsp_scene_hash_for(scene, NULL) && tdsp_scene_hash(scene) == tdsp_scene_hash_for(scene, &own), "another hash for the same");
    fuzz_require(tdsp_scene_hash(scene) != tdsp_scene_hash_for(scene, &other), "the same hash for another");
    const double source = tdsp_scene_source_free_until(scene, &disc), destination = tdsp_scene_destination_free_until(scene, NULL);
    fuzz_require((source < INFINITY) == (disc != TDSP_NO_DISC), "covered by nobody");
    fuzz_require(tdsp_scene_free_until(scene, journey->source, NULL) == source, "the source is covered at another time");
    fuzz_require(tdsp_scene_free_until(scene, journey->destination, NULL) == destination, "the destination is covered at another time");
    (void)tdsp_scene_has_rates_only(scene);
}

static void law_solve(const tdsp_scene *scene)
{
    tdsp_solver *solver = NULL;
    double arrival = 0.0;
    fuzz_require(tdsp_solver_create(scene, &solver) == TDSP_OK, "no solver");
    const tdsp_status status = tdsp_earliest_arrival(solver, 0.25, &arrival);
    fuzz_require(tdsp_status_is_answer(status) || status == TDSP_NOT_SUPPORTED || status == TDSP_SHRINKS, "an arrival with another status");
    tdsp_solver_free(solver);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    fuzz_input in = {data, size, 0};
    byte_law law, kinked;
    tdsp_scene *scene = NULL;
    law_read(&law, &in);
    law_read(&kinked, &in);
    const double until = (double)(1 + input_byte(&in)) / 16.0;
    const tdsp_journey journey = {1.0, 0.0, {-3.0, 0.0}, {3.0, 0.5}};
    const tdsp_growing_disc discs[] = {
        {{0.0, 0.25}, law.radius, {.kind = TDSP_GROWTH_LAW, .law = law_at, .ctx = &law, .until = until}},
        {{1.0, -1.5}, kinked.radius, {.kind = TDSP_GROWTH_LAW, .law = law_at, .ctx = &kinked, .until = until, .count = STEPS - 1, .times = &kinked.at[1]}},
    };
    const char *wrong = tdsp_growing_disc_check(&discs[0]);
    const tdsp_status status = tdsp_scene_create_growing(&journey, discs, 2, NULL, &scene);
    fuzz_require(status == TDSP_OK || status == TDSP_BAD_SCENE, "a scene with another status");
    const int is_steady = !memchr(law.trick, 6, STEPS);
    fuzz_require(!is_steady || !wrong || status == TDSP_BAD_SCENE, "a law that is wrong makes a scene");
    if (status != TDSP_OK) return 0;
    law_check_radii(scene, 2, until);
    law_check_parts(scene, &journey, 2);
    law_solve(scene);
    tdsp_scene_free(scene);
    return 0;
}
