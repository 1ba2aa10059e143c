/* SPDX-License-Identifier: MIT */
/*
 * Fixed work for the gates: how many instructions does each hot path take? tests/bench/gates.py runs this under callgrind,
 * whose counts repeat exactly, and compares them with the record. Only the work between COUNT and COUNTED is counted, what
 * prepares it is not.
 *     gates SCENES            all workloads; SCENES is the directory of the example scenes
 *     gates --environment     what the counts depend on besides the sources
 *
 * Each workload checks that it did what it is meant to do: work that fails early would be cheap.
 */
#include <gnu/libc-version.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <valgrind/callgrind.h>

#include "bench/worlds.h"
#include "tdsp/scene_file.h"
#include "tdsp/tdsp.h"

#define COUNT                                                                                                                    \
    do {                                                                                                                         \
        CALLGRIND_START_INSTRUMENTATION;                                                                                         \
        CALLGRIND_ZERO_STATS;                                                                                                    \
    } while (0)
#define COUNTED(name)                                                                                                            \
    do {                                                                                                                         \
        CALLGRIND_DUMP_STATS_AT(name);                                                                                           \
        CALLGRIND_STOP_INSTRUMENTATION;                                                                                          \
    } while (0)

static gboolean fine = TRUE;

static void expect(gboolean condition, const char *name, const char *what)
{
    if (condition) return;
    fprintf(stderr, "gates: %s: %s\n", name, what);
    fine = FALSE;
}

static tdsp_scene *made_scene(const char *kind, guint discs, gboolean near)
{
    Generated made = {.discs = g_array_new(FALSE, FALSE, sizeof(tdsp_disc))};
    tdsp_scene *scene = NULL;
    const char *wrong = world_make(&(World){kind, discs, near, 1}, &made);
    expect(!wrong, kind, wrong ? wrong : "");
    tdsp_scene_create(&made.journey, (tdsp_disc *)(void *)made.discs->data, made.discs->len, NULL, &scene);
    expect(scene != NULL, kind, "no scene");
    g_array_unref(made.discs);
    return scene;
}

/* Likewise, but 0.6 of the rate at first, and more by 0.6 of it in the time that the straight way takes. */
static tdsp_scene *accelerating_scene(const char *kind, guint discs)
{
    Generated made = {.discs = g_array_new(FALSE, FALSE, sizeof(tdsp_disc))};
    tdsp_scene *scene = NULL;
    const char *wrong = world_make(&(World){kind, discs, FALSE, 1}, &made);
    expect(!wrong, kind, wrong ? wrong : "");
    tdsp_point a = made.journey.source, b = made.journey.destination;
    double straight = hypot(a.x - b.x, a.y - b.y) / made.journey.speed;
    g_autofree tdsp_growing_disc *growing = g_new0(tdsp_growing_disc, made.discs->len);
    g_autofree double *rates = g_new(double, 2 * made.discs->len);
    for (guint i = 0; i < made.discs->len; i++) {
        tdsp_disc disc = g_array_index(made.discs, tdsp_disc, i);
        rates[2 * i] = 0.6 * disc.growth;
        rates[2 * i + 1] = 0.3 * disc.growth / straight;
        growing[i] = (tdsp_growing_disc){disc.center, disc.radius, {.kind = TDSP_GROWTH_POLYNOMIAL, .count = 2, .values = &rates[2 * i]}};
    }
    tdsp_scene_create_growing(&made.journey, growing, made.discs->len, NULL, &scene);
    expect(scene != NULL, kind, "no scene of growing discs");
    g_array_unref(made.discs);
    return scene;
}

static tdsp_scene *example_scene(const char *folder, const char *name)
{
    g_autofree char *path = g_build_filename(folder, name, NULL);
    g_autoptr(GError) error = NULL;
    SceneFile file = {0};
    if (!scene_file_load(path, &file, &error)) expect(FALSE, name, error->message);
    tdsp_scene *scene = file.scene;
    file.scene = NULL;
    scene_file_clear(&file);
    return scene;
}

static tdsp_solver *solver_for(const tdsp_scene *scene)
{
    tdsp_solver *solver = NULL;
    expect(tdsp_solver_create(scene, &solver) == TDSP_OK, "solver", "not created");
    return solver;
}

/* The first question to a new solver. */
static void forward(const char *name, tdsp_scene *scene, tdsp_status answer)
{
    double arrival;
    COUNT;
    tdsp_solver *solver = solver_for(scene);
    tdsp_status status = tdsp_earliest_arrival(solver, 0.0, &arrival);
    tdsp_solver_free(solver);
    COUNTED(name);
    expect(status == answer, name, tdsp_status_name(status));
    tdsp_scene_free(scene);
}

static void within(const char *name, tdsp_scene *scene)
{
    double arrival, lower = 0.0;
    COUNT;
    tdsp_solver *solver = solver_for(scene);
    tdsp_status status = tdsp_earliest_arrival_within(solver, 0.0, 0.01, &arrival, &lower);
    tdsp_solver_free(solver);
    COUNTED(name);
    expect(status == TDSP_OK && arrival <= 1.01 * lower, name, tdsp_status_name(status));
    tdsp_scene_free(scene);
}

/* What comes after the first question, at departures a hundredth of the journey apart. */
static void neighbours(const char *name, tdsp_scene *scene)
{
    tdsp_solver *solver = solver_for(scene);
    double journey, arrival;
    expect(tdsp_earliest_arrival(solver, 0.0, &journey) == TDSP_OK, name, "no path at 0");
    COUNT;
    for (int i = 1; i <= 4; i++) expect(tdsp_earliest_arrival(solver, 0.01 * i * journey, &arrival) == TDSP_OK, name, "no path");
    COUNTED(name);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

static void reverse(const char *name, tdsp_scene *scene)
{
    tdsp_solver *solver = solver_for(scene);
    double arrival, departure, arrives;
    expect(tdsp_earliest_arrival(solver, 0.0, &arrival) == TDSP_OK, name, "no path at 0");
    tdsp_solver_free(solver);
    COUNT;
    solver = solver_for(scene);
    tdsp_status status = tdsp_latest_departure(solver, 1.05 * arrival, &departure, &arrives);
    tdsp_solver_free(solver);
    COUNTED(name);
    expect(status == TDSP_OK && departure > 0.0, name, tdsp_status_name(status));
    tdsp_scene_free(scene);
}

static void prepare(const char *name, guint discs)
{
    Generated made = {.discs = g_array_new(FALSE, FALSE, sizeof(tdsp_disc))};
    tdsp_scene *scene = NULL;
    expect(!world_make(&(World){"mixed", discs, FALSE, 1}, &made), name, "no world");
    COUNT;
    tdsp_scene_create(&made.journey, (tdsp_disc *)(void *)made.discs->data, made.discs->len, NULL, &scene);
    COUNTED(name);
    expect(scene != NULL, name, "no scene");
    tdsp_scene_free(scene);
    g_array_unref(made.discs);
}

/* A table of a scene, and the proof that all of it is sound. */
static void build_and_verify(const char *build_name, const char *verify_name, tdsp_scene *scene)
{
    tdsp_solver *solver = solver_for(scene);
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_table table;
    tdsp_table_verdict verdict = {0};
    void *bytes = NULL;
    size_t length = 0;
    tdsp_build_options_init(&options);
    options.world.scene_hash = tdsp_scene_hash(scene);
    options.world.speed = tdsp_scene_journey(scene)->speed;
    options.world.source = tdsp_scene_journey(scene)->source;
    options.world.destination = tdsp_scene_journey(scene)->destination;
    tdsp_solver_oracle(solver, &oracle);
    COUNT;
    tdsp_status status = tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL);
    COUNTED(build_name);
    expect(status == TDSP_OK && tdsp_table_open(&table, bytes, length) == TDSP_OK, build_name, tdsp_status_name(status));
    COUNT;
    status = tdsp_verify_table(scene, &table, &verdict);
    COUNTED(verify_name);
    expect(status == TDSP_OK && verdict.ok, verify_name, "the table is rejected");
    tdsp_bytes_free(NULL, bytes, length);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

/* T(t) = 1 + t: a relative guarantee then needs rows all the way. */
static tdsp_status growing_arrival(void *ctx, double departure, double *arrival)
{
    (void)ctx;
    *arrival = departure + (1.0 + departure);
    return TDSP_OK;
}

#define LOOKUPS 4096

/* Departures all over the table, in no order. */
static void scatter(double *departures, double last)
{
    for (int i = 0; i < LOOKUPS; i++) departures[i] = last * fmod(i * 0.61803398874989484820, 1.0);
}

static void look_up(const char *single_name, const char *batch_name, const char *back_name, const tdsp_table *table, double last)
{
    static double departures[LOOKUPS], lower[LOOKUPS], upper[LOOKUPS], single[LOOKUPS];
    scatter(departures, last);
    COUNT;
    for (int i = 0; i < LOOKUPS; i++) tdsp_table_arrival(table, departures[i], &lower[i], &single[i]);
    COUNTED(single_name);
    COUNT;
    tdsp_status status = tdsp_table_arrivals(table, departures, LOOKUPS, lower, upper, NULL);
    COUNTED(batch_name);
    expect(status == TDSP_OK && memcmp(single, upper, sizeof upper) == 0, batch_name, "answers otherwise than one by one");
    COUNT;
    for (int i = 0; i < LOOKUPS; i++) tdsp_table_departure(table, upper[i], &lower[i], NULL);
    COUNTED(back_name);
    for (int i = 0; i < LOOKUPS; i++) expect(lower[i] >= departures[i], back_name, "the way back ends too early");
}

static void look_up_growing(void)
{
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_table table;
    void *bytes = NULL;
    size_t length = 0;
    tdsp_oracle_init(&oracle);
    oracle.earliest_arrival = growing_arrival;
    tdsp_build_options_init(&options);
    options.epsilon = 1e-3;
    options.horizon = 1e4;
    tdsp_status status = tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL);
    COUNT;
    if (status == TDSP_OK) status = tdsp_table_open(&table, bytes, length);
    COUNTED("open");
    expect(status == TDSP_OK, "open", tdsp_status_name(status));
    if (status == TDSP_OK) look_up("look-up", "look-up-batch", "look-up-back", &table, options.horizon);
    tdsp_bytes_free(NULL, bytes, length);
}

static void print_environment(void)
{
#if defined(__clang__)
    const char *compiler = "clang " __clang_version__;
#else
    const char *compiler = "gcc " __VERSION__;
#endif
#if defined(__x86_64__)
    const char *machine = "x86_64";
#elif defined(__aarch64__)
    const char *machine = "aarch64";
#else
    const char *machine = "another machine";
#endif
    printf("%s; glibc %s; %s\n", compiler, gnu_get_libc_version(), machine);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: gates SCENES | gates --environment\n");
        return 2;
    }
    if (strcmp(argv[1], "--environment") == 0) {
        print_environment();
        return 0;
    }
    forward("forward-crowd", made_scene("crowd", 1000, FALSE), TDSP_OK);
    forward("forward-random", made_scene("random", 300, FALSE), TDSP_OK);
    forward("forward-wall", made_scene("wall", 100, FALSE), TDSP_OK);
    forward("forward-near", made_scene("mixed", 10000, TRUE), TDSP_OK);
    forward("forward-fire", example_scene(argv[1], "fire-oregon-c.json"), TDSP_OK);
    forward("forward-changing", accelerating_scene("crowd", 300), TDSP_OK);
    within("within", made_scene("random", 3000, FALSE));
    forward("no-path", made_scene("sealed", 1000, FALSE), TDSP_CUT_OFF);
    neighbours("neighbours", made_scene("mixed", 300, FALSE));
    reverse("reverse", made_scene("mixed", 200, FALSE));
    prepare("prepare", 10000);
    build_and_verify("table", "verify", made_scene("crowd", 50, FALSE));
    look_up_growing();
    return fine ? 0 : 1;
}
