/* SPDX-License-Identifier: MIT */
/*
 * Legs of any numbers at all, as a caller may hand them in: moving along them, moving them in time, verifying them, and asking for their margin must come back with an
 * answer or a refusal. A position along legs that the verifier finds nothing wrong with is a number.
 */
#include <math.h>
#include <string.h>

#include "input.h"
#include "tdsp/margin.h"
#include "tdsp/path.h"
#include "tdsp/verify.h"
#include "tdsp/growth.h"

enum { LEGS = 6 };

static double legs_double(fuzz_input *in)
{
    static const double odd[] = {0, -0.0, 1, -1, 2, 0.5, 10, -10, 5e-324, 1e308, -1e308, 1e-300, 1e100, 3.25, 1e9, 1e-9};
    const unsigned kind = input_byte(in);
    unsigned char raw[8];
    double number;
    if (kind < 64) return odd[kind % 16];
    if (kind < 192) return ((double)kind - 128.0) / 8.0;
    if (kind == 192) return NAN;
    if (kind == 193) return INFINITY;
    for (int i = 0; i < 8; i++) raw[i] = (unsigned char)input_byte(in);
    memcpy(&number, raw, sizeof number);
    return number;
}

static tdsp_point legs_point(fuzz_input *in)
{
    const double x = legs_double(in);
    return (tdsp_point){x, legs_double(in)};
}

/* Half of the legs join the one before. */
static tdsp_leg legs_read(fuzz_input *in, const tdsp_leg *before)
{
    const unsigned shape = input_byte(in);
    tdsp_leg leg = {.kind = shape & 3u, .disc = shape & 4u ? 0u : shape & 8u ? 1u : TDSP_NO_DISC, .turn = shape & 16u ? 1 : shape & 32u ? -1 : 0};
    leg.start_time = legs_double(in);
    leg.end_time = legs_double(in);
    leg.from = legs_point(in);
    leg.to = legs_point(in);
    if (before && shape & 64u) {
        leg.start_time = before->end_time;
        leg.from = before->to;
    }
    if (leg.kind == TDSP_LEG_LINE && shape & 128u) return leg;
    leg.center = legs_point(in);
    double *rest[] = {&leg.radius_from, &leg.radius_to, &leg.angle_from, &leg.sweep, &leg.rate_from, &leg.rate_to, &leg.bend_from, &leg.bend_to, &leg.speed};
    for (size_t i = 0; i < sizeof rest / sizeof *rest; i++) *rest[i] = legs_double(in);
    return leg;
}

static tdsp_scene *legs_scene(unsigned kind)
{
    static const double powers[] = {0.1, 0.004};
    const tdsp_journey journey = {1.0, 0.125, {-10.0, 0.0}, {10.0, 0.0}};
    tdsp_growing_disc discs[] = {{{0.0, 3.0}, 1.0, {.kind = TDSP_GROWTH_RATE, .rate = 0.1}},
                                 {{-3.0, -1.0}, 1.0, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = powers}}};
    tdsp_scene *scene = NULL;
    fuzz_require(tdsp_scene_create_growing(&journey, discs, kind & 1u ? 2 : 1, NULL, &scene) == TDSP_OK, "no scene");
    return scene;
}

static void legs_move(const tdsp_leg *legs, size_t count, double time, int is_good)
{
    tdsp_point at = {0.0, 0.0};
    const tdsp_status status = tdsp_path_position(legs, count, time, &at);
    fuzz_require(status == TDSP_OK || status == TDSP_INVALID_ARGUMENT, "a position with another status");
    if (is_good && isfinite(time)) fuzz_require(status == TDSP_OK && isfinite(at.x) && isfinite(at.y), "a good path leads nowhere");
    const tdsp_leg moved = tdsp_leg_shifted(&legs[0], -time);
    const tdsp_point there = tdsp_leg_position(&moved, 0.0);
    if (is_good && isfinite(time)) fuzz_require(isfinite(there.x) && isfinite(there.y), "a good leg moved in time leads nowhere");
}

static int legs_judge(const tdsp_scene *scene, const tdsp_leg *legs, size_t count, double departure, double arrival)
{
    tdsp_verdict verdict;
    tdsp_margin margin;
    const tdsp_status status = tdsp_verify_path(scene, legs, count, departure, arrival, &verdict);
    fuzz_require(status == TDSP_OK || status == TDSP_INVALID_ARGUMENT, "a verdict with another status");
    fuzz_require(status != TDSP_OK || (isfinite(departure) && departure >= 0.0 && isfinite(arrival)), "a verdict on times that are none");
    const tdsp_raise how = count % 2 ? TDSP_RAISE_ADDED : TDSP_RAISE_FACTOR;
    const tdsp_status found = tdsp_path_margin(scene, how, legs, count, departure, &margin);
    fuzz_require(found == TDSP_OK || found == TDSP_INVALID_ARGUMENT || found == TDSP_BAD_PATH || found == TDSP_NOT_SUPPORTED, "a margin with another status");
    fuzz_require(found != TDSP_OK || !isnan(margin.most), "a margin that is no number");
    return status == TDSP_OK && verdict.problems == 0;
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    fuzz_input in = {data, size, 0};
    tdsp_leg legs[LEGS];
    size_t count = 0;
    tdsp_scene *scene = legs_scene(input_byte(&in));
    const double departure = legs_double(&in), arrival = legs_double(&in), time = legs_double(&in);
    while (count < LEGS && input_left(&in)) {
        legs[count] = legs_read(&in, count ? &legs[count - 1] : NULL);
        count++;
    }
    const int is_good = legs_judge(scene, legs, count, departure, arrival);
    if (count) legs_move(legs, count, time, is_good);
    tdsp_scene_free(scene);
    return 0;
}
