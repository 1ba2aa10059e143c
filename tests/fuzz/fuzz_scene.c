/* SPDX-License-Identifier: MIT */
/*
 * Any text at all as a scene file: the reader must refuse it with a message or hand out a scene that can be solved. Scenes of a few discs are
 * solved, whatever their numbers are: an arrival is never earlier than the straight line allows, and a latest departure keeps its word.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tdsp/growth.h"
#include "tdsp/scene_file.h"
#include "tdsp/solver.h"

enum { FEW = 6 };

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size);

static void fuzz_quiet(const char *text)
{
    (void)text;
}

static void fuzz_require(int holds)
{
    if (!holds) abort();
}

/* Times too many journeys away are refused: the solver's header says so. So are those at which a radius would shrink. */
static void fuzz_answered(tdsp_status status)
{
    fuzz_require(tdsp_status_is_answer(status) || status == TDSP_NOT_SUPPORTED || status == TDSP_SHRINKS || status == TDSP_NO_MEMORY);
}

/* No radius falls, as far as its round-off shows, and what stands after it would is a radius that stays. */
static void fuzz_radii(const tdsp_scene *scene, size_t count)
{
    static const double times[] = {0.0, 1e-9, 1e-3, 0.5, 1.0, 2.0, 7.0, 1e2, 1e4, 1e7, 1e12, 1e30};
    uint32_t shrinks;
    fuzz_require((tdsp_scene_valid_until(scene, &shrinks) < INFINITY) == (shrinks != TDSP_NO_DISC));
    fuzz_require(tdsp_scene_valid_until(scene, NULL) > 0.0);
    for (uint32_t i = 0; i < count; ++i) {
        double before = 0.0;
        for (size_t k = 0; k < sizeof times / sizeof *times; ++k) {
            double radius, rate;
            fuzz_require(tdsp_scene_disc_at(scene, i, times[k], &radius, &rate) == TDSP_OK);
            fuzz_require(!(radius < before * (1.0 - 1e-6)));
            before = radius;
        }
    }
}

/* The straight line's time, a little less for rounding: of the journey, and of the angles around the largest disc. */
static double fuzz_least(const tdsp_scene *scene)
{
    const tdsp_journey *journey = tdsp_scene_journey(scene);
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(scene, &count);
    double across = hypot(journey->destination.x - journey->source.x, journey->destination.y - journey->source.y), largest = 0.0;
    for (size_t i = 0; i < count; ++i) largest = fmax(largest, discs[i].radius + journey->radius);
    return (across * (1.0 - 1e-9) - 0x1p-50 * largest) / journey->speed;
}

static void fuzz_solve(const tdsp_scene *scene, double departure)
{
    double arrival = 0.0, latest = 0.0, arrives = 0.0;
    tdsp_solver *solver = NULL;
    if (tdsp_solver_create(scene, &solver) != TDSP_OK) return;
    tdsp_status status = tdsp_earliest_arrival(solver, departure, &arrival);
    fuzz_answered(status);
    if (status == TDSP_OK && isfinite(arrival)) {
        fuzz_require(arrival >= departure + fuzz_least(scene) - 1e-15 * arrival);
        status = tdsp_latest_departure(solver, arrival, &latest, &arrives);
        fuzz_answered(status);
        if (status == TDSP_OK) fuzz_require(latest >= 0.0 && arrives >= latest);
    }
    tdsp_solver_free(solver);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    g_auto(SceneFile) scene = {0};
    g_autoptr(GError) error = NULL;
    size_t count = 0;
    g_set_printerr_handler(fuzz_quiet);
    char *text = g_malloc(size + 1); /* exactly as long as it is, so that a read past its end is seen */
    if (size) memcpy(text, data, size);
    text[size] = '\0';
    gboolean read = scene_file_parse("input", text, size, &scene, &error);
    g_free(text);
    fuzz_require(read ? scene.scene != NULL && !error : error != NULL);
    if (!read) return 0;
    (void)tdsp_scene_discs(scene.scene, &count);
    if (count > FEW) return 0;
    fuzz_radii(scene.scene, count);
    fuzz_solve(scene.scene, 0.0);
    fuzz_solve(scene.scene, 1.0);
    return 0;
}
