/* SPDX-License-Identifier: MIT */
/*
 * What a question costs: prepares one world, asks it in every way, and prints a line of CSV for each.
 *     solve SHARE OPERATIONS file SCENE
 *     solve SHARE OPERATIONS made KIND DISCS far|near SEED
 * SHARE is about how many seconds each measurement may take; what takes longer is measured once. OPERATIONS is "all", or
 * names of those below:
 *
 *     prepare     a scene from its array of discs
 *     workspace   a solver for the prepared scene
 *     forward     the first question to a new solver: the earliest arrival for departure 0, or that there is none
 *     within      the first question to a new solver: an arrival for departure 0 that is certified to be within 1 %
 *     neighbour   the earliest arrival for a departure that is a hundredth of the journey after the one asked before
 *     reverse     the first question to a new solver: the latest departure for an arrival
 *
 * `answer` is the arrival, for reverse the departure; `bytes` is what the scene (prepare) or the solver then holds, `peak`
 * the most that was held on the way; the last three columns count what the solver did for one question.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/meter.h"
#include "bench/timing.h"
#include "bench/worlds.h"
#include "tdsp/scene_file.h"
#include "tdsp/solver.h"

#define WITHIN 0.01        /* share of the lower bound by which an arrival may be too late */
#define STEPS 8            /* neighbouring departures in a walk */
#define STEP_SHARE 0.01    /* of the journey, from one to the next */
#define SMALLEST_STEP 1e-6 /* of the journey; where departures end even before that, there is no neighbour to ask */

typedef struct Bench {
    const char *label; /* first columns of each line */
    const char *operations;
    const tdsp_journey *journey;
    const tdsp_disc *discs;
    size_t count;
    double share;
    Meter scene_meter, solver_meter; /* the scene's allocator counts into one or the other: see `meters` */
    Meter *meter;
    tdsp_scene *scene;
    tdsp_solver *solver;
    tdsp_solver_work before, after; /* the question */
    double step;
    guint at; /* steps walked */
    double arrival, latest_arrival, answer;
    tdsp_status status;
} Bench;

/* A solver allocates through its scene, and what it holds is counted apart. */
static void *resize(void *ctx, void *block, size_t old_size, size_t new_size)
{
    return meter_resize(((Bench *)ctx)->meter, block, old_size, new_size);
}

static int prepare(void *ctx)
{
    Bench *bench = ctx;
    tdsp_allocator allocator = {bench, resize};
    bench->scene_meter = (Meter){0, 0};
    bench->meter = &bench->scene_meter;
    bench->status = tdsp_scene_create(bench->journey, bench->discs, bench->count, &allocator, &bench->scene);
    return bench->status == TDSP_OK;
}

static void unprepare(void *ctx)
{
    tdsp_scene_free(((Bench *)ctx)->scene);
}

static int make_solver(void *ctx)
{
    Bench *bench = ctx;
    bench->solver_meter = (Meter){0, 0};
    bench->meter = &bench->solver_meter;
    bench->before = (tdsp_solver_work){0};
    bench->status = tdsp_solver_create(bench->scene, &bench->solver);
    return bench->status == TDSP_OK;
}

static void free_solver(void *ctx)
{
    Bench *bench = ctx;
    tdsp_solver_work_done(bench->solver, &bench->after);
    tdsp_solver_free(bench->solver);
    bench->solver = NULL;
}

static int ask_forward(void *ctx)
{
    Bench *bench = ctx;
    bench->status = tdsp_earliest_arrival(bench->solver, 0.0, &bench->answer);
    return tdsp_status_is_answer(bench->status);
}

static int ask_within(void *ctx)
{
    Bench *bench = ctx;
    double lower;
    bench->status = tdsp_earliest_arrival_within(bench->solver, 0.0, WITHIN, &bench->answer, &lower);
    return tdsp_status_is_answer(bench->status);
}

static int ask_reverse(void *ctx)
{
    Bench *bench = ctx;
    bench->status = tdsp_latest_departure(bench->solver, bench->latest_arrival, &bench->answer, NULL);
    return tdsp_status_is_answer(bench->status);
}

/* Begin a new walk at departure 0 when the last one is over. */
static int step_aside(void *ctx)
{
    Bench *bench = ctx;
    if (bench->at++ % STEPS == 0) {
        if (bench->solver) free_solver(bench);
        if (!make_solver(bench) || !ask_forward(bench)) return 0;
    }
    return tdsp_solver_work_done(bench->solver, &bench->before) == TDSP_OK;
}

static int ask_neighbour(void *ctx)
{
    Bench *bench = ctx;
    double departure = bench->step * (1 + (bench->at - 1) % STEPS);
    bench->status = tdsp_earliest_arrival(bench->solver, departure, &bench->answer);
    return bench->status == TDSP_OK;
}

static void count_work(void *ctx)
{
    Bench *bench = ctx;
    tdsp_solver_work_done(bench->solver, &bench->after);
}

static void print_line(const Bench *bench, const char *operation, const Timing *timing, const Meter *meter)
{
    const tdsp_solver_work *from = &bench->before, *to = &bench->after;
    printf("%s,%zu,%s,%zu,%.6g,%.6g,%.6g,%.17g,%s,%zu,%zu,%.0f,%.0f,%.0f\n", bench->label, bench->count, operation, timing->runs,
           1e3 * timing->median, 1e3 * timing->low, 1e3 * timing->high, bench->answer, tdsp_status_name(bench->status),
           meter->held, meter->peak, (double)(to->rounds - from->rounds), (double)(to->labels - from->labels),
           (double)(to->legs_tested - from->legs_tested));
    fflush(stdout);
}

static int measure_scene(Bench *bench)
{
    Timing timing;
    if (!timing_measure(&(TimingJob){NULL, prepare, unprepare, bench}, bench->share, &timing) || !prepare(bench)) return 0;
    print_line(bench, "prepare", &timing, &bench->scene_meter);
    if (!timing_measure(&(TimingJob){NULL, make_solver, free_solver, bench}, bench->share, &timing) || !make_solver(bench))
        return 0;
    bench->after = (tdsp_solver_work){0};
    print_line(bench, "workspace", &timing, &bench->solver_meter);
    free_solver(bench);
    return 1;
}

/* The solver's bytes are counted while it lives: after a question, before it is freed. */
static int measure_cold(Bench *bench, const char *operation, int (*ask)(void *ctx))
{
    Timing timing;
    if (!timing_measure(&(TimingJob){make_solver, ask, free_solver, bench}, bench->share, &timing)) return 0;
    if (timing.runs == 1) {
        print_line(bench, operation, &timing, &(Meter){(size_t)bench->after.bytes, bench->solver_meter.peak});
        return 1;
    }
    if (!make_solver(bench) || !ask(bench)) return 0;
    count_work(bench);
    print_line(bench, operation, &timing, &bench->solver_meter);
    free_solver(bench);
    return 1;
}

/* The longest step at which all departures of a walk have a path. */
static int choose_step(Bench *bench)
{
    double journey = bench->arrival;
    if (!make_solver(bench)) return 0;
    for (bench->step = STEP_SHARE * journey; bench->step > SMALLEST_STEP * journey; bench->step /= 8) {
        bench->status = tdsp_earliest_arrival(bench->solver, STEPS * bench->step, &bench->latest_arrival);
        if (!tdsp_status_is_answer(bench->status)) return 0;
        if (bench->status == TDSP_OK) break;
    }
    free_solver(bench);
    return 1;
}

static int measure_neighbours(Bench *bench)
{
    Timing timing;
    bench->at = 0;
    if (!timing_measure(&(TimingJob){step_aside, ask_neighbour, count_work, bench}, bench->share, &timing)) return 0;
    print_line(bench, "neighbour", &timing, &bench->solver_meter);
    free_solver(bench);
    return 1;
}

static int wanted(const Bench *bench, const char *operation)
{
    return strcmp(bench->operations, "all") == 0 || strstr(bench->operations, operation) != NULL;
}

/* What a neighbour and an arrival to ask backwards for are, the answers before say: a later operation needs the earlier ones. */
static int measure(Bench *bench)
{
    if (!measure_scene(bench)) return 0;
    if (wanted(bench, "within") && !measure_cold(bench, "within", ask_within)) return 0;
    if (!wanted(bench, "forward")) return 1;
    if (!measure_cold(bench, "forward", ask_forward)) return 0;
    if (bench->status != TDSP_OK || bench->answer <= 0.0) return 1; /* no path, or nowhere to go */
    bench->arrival = bench->answer;
    if (!wanted(bench, "neighbour") && !wanted(bench, "reverse")) return 1;
    if (!choose_step(bench)) return 0;
    if (bench->status != TDSP_OK) return 1; /* departures end at once */
    if (wanted(bench, "neighbour") && !measure_neighbours(bench)) return 0;
    return !wanted(bench, "reverse") || measure_cold(bench, "reverse", ask_reverse);
}

static int measure_world(Bench *bench)
{
    int fine = measure(bench);
    if (!fine) fprintf(stderr, "solve: %s: %s\n", bench->label, tdsp_status_text(bench->status));
    tdsp_solver_free(bench->solver);
    tdsp_scene_free(bench->scene);
    return fine ? 0 : 1;
}

static int measure_made(Bench *bench, char **argv)
{
    World world = {argv[0], (guint)strtoul(argv[1], NULL, 10), strcmp(argv[2], "near") == 0, strtoull(argv[3], NULL, 10)};
    Generated made = {.discs = g_array_new(FALSE, FALSE, sizeof(tdsp_disc))};
    g_autofree char *label = g_strdup_printf("%s,%s,%s,%s", argv[0], argv[1], argv[2], argv[3]);
    const char *wrong = world_make(&world, &made);
    int failed = 1;
    bench->label = label;
    bench->journey = &made.journey;
    bench->discs = (tdsp_disc *)(void *)made.discs->data;
    bench->count = made.discs->len;
    if (wrong)
        fprintf(stderr, "solve: %s: %s\n", label, wrong);
    else
        failed = measure_world(bench);
    g_array_unref(made.discs);
    return failed;
}

static int measure_file(Bench *bench, const char *path)
{
    g_auto(SceneFile) file = {0};
    g_autoptr(GError) error = NULL;
    if (!scene_file_load(path, &file, &error)) {
        fprintf(stderr, "%s\n", error->message);
        return 1;
    }
    g_autofree char *base = g_path_get_basename(path);
    if (g_str_has_suffix(base, ".json")) base[strlen(base) - strlen(".json")] = '\0';
    g_autofree char *label = g_strdup_printf("%s,,file,", base);
    bench->label = label;
    bench->journey = tdsp_scene_journey(file.scene);
    bench->discs = tdsp_scene_discs(file.scene, &bench->count);
    return measure_world(bench);
}

int main(int argc, char **argv)
{
    if (argc == 5 && strcmp(argv[3], "file") == 0)
        return measure_file(&(Bench){.share = atof(argv[1]), .operations = argv[2]}, argv[4]);
    if (argc == 8 && strcmp(argv[3], "made") == 0)
        return measure_made(&(Bench){.share = atof(argv[1]), .operations = argv[2]}, argv + 4);
    fprintf(stderr, "usage: solve SHARE OPERATIONS file SCENE | solve SHARE OPERATIONS made KIND DISCS far|near SEED\n");
    return 2;
}
