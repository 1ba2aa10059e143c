/* SPDX-License-Identifier: MIT */
/*
 * What the headers promise to threads, one promise after the other: many threads do the same at once, on what they may share. Each must get what one thread alone
 * gets, and the thread sanitizer, with which this and the library are compiled, must find no race.
 *
 *   threads ROUNDS
 *   threads race       a race on purpose: the sanitizer must find it
 */
#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "support/random_scene.h"
#include "tdsp/tdsp.h"

#define THREADS 8
#define DISCS 24
#define LEGS 256

/* Made before the threads start, and never changed while they run. */
typedef struct shared {
    tdsp_journey journey;
    tdsp_disc discs[DISCS];
    tdsp_scene *scene, *growing;
    void *table_bytes, *matrix_bytes;
    size_t table_length, matrix_length;
    tdsp_table table;
    tdsp_matrix matrix;
    tdsp_leg legs[LEGS];
    size_t leg_count;
    double arrival, last;
    tdsp_jumps *jumps;
    tdsp_envelope *envelope;
} shared;

typedef uint64_t thread_job(const shared *all, int round);

static void mix(uint64_t *hash, const void *bytes, size_t length)
{
    const unsigned char *p = bytes;
    for (size_t i = 0; i < length; i++) *hash = (*hash ^ p[i]) * UINT64_C(0x100000001b3);
}

static void mix_number(uint64_t *hash, double x)
{
    mix(hash, &x, sizeof x);
}

static void need(int holds, const char *what)
{
    if (holds) return;
    fprintf(stderr, "threads: %s\n", what);
    abort();
}

/* -------------------------------------------------------------------------------------------------- what the jobs share */

static void make_scenes(shared *all)
{
    static const double coefficients[] = {0.02, 0.01};
    tdsp_growing_disc growing[DISCS] = {{{0, 0}, 0, {0}}};
    random_scene(5, RANDOM_WALL, DISCS, &all->journey, all->discs);
    for (int i = 0; i < DISCS; i++) {
        growing[i].center = all->discs[i].center;
        growing[i].radius = all->discs[i].radius;
        growing[i].growth = (tdsp_growth){.kind = TDSP_GROWTH_POLYNOMIAL, .count = 1 + (size_t)(i % 2), .values = coefficients};
    }
    need(tdsp_scene_create(&all->journey, all->discs, DISCS, NULL, &all->scene) == TDSP_OK, "no scene");
    need(tdsp_scene_create_growing(&all->journey, growing, DISCS / 3, NULL, &all->growing) == TDSP_OK, "no growing scene");
}

static tdsp_build_options table_options(const shared *all)
{
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.epsilon = 0.1;
    options.horizon = 4.0 * all->arrival;
    options.world = (tdsp_build_world){tdsp_scene_hash(all->scene), all->journey.speed, all->journey.source, all->journey.destination, "m", "s"};
    return options;
}

static void build_with(tdsp_solver *solver, const tdsp_build_options *options, void **bytes, size_t *length)
{
    tdsp_oracle oracle;
    need(tdsp_solver_oracle(solver, &oracle) == TDSP_OK, "no oracle");
    need(tdsp_build(&oracle, options, NULL, bytes, length, NULL) == TDSP_OK, "no table");
}

/* The ends of a small matrix, and oracles for its pairs: a solver for each worker. */
typedef struct pairs {
    const shared *all;
    tdsp_matrix_end ends[2];
    tdsp_solver *solvers[THREADS];
} pairs;

static tdsp_status pair_oracle(void *ctx, size_t i, size_t j, size_t worker, tdsp_oracle *oracle, uint64_t *hash)
{
    pairs *p = ctx;
    const tdsp_ends ends = {p->ends[i].place, p->ends[j].place};
    if (!p->solvers[worker] && tdsp_solver_create(p->all->scene, &p->solvers[worker]) != TDSP_OK) return TDSP_NO_MEMORY;
    *hash = tdsp_scene_hash_for(p->all->scene, &ends);
    tdsp_status status = tdsp_solver_set_ends(p->solvers[worker], &ends);
    return status == TDSP_OK ? tdsp_solver_oracle(p->solvers[worker], oracle) : status;
}

static void build_matrix(const shared *all, const tdsp_build_options *options, void **bytes, size_t *length)
{
    pairs p = {all, {{all->journey.source, "here", 4}, {all->journey.destination, NULL, 0}}, {NULL}};
    const tdsp_matrix_plan plan = {p.ends, 2, p.ends, 2, pair_oracle, &p};
    need(tdsp_matrix_build(&plan, options, NULL, bytes, length, NULL) == TDSP_OK, "no matrix");
    for (int i = 0; i < THREADS; i++) tdsp_solver_free(p.solvers[i]);
}

static void make_shared(shared *all)
{
    tdsp_solver *solver = NULL;
    tdsp_last_departure last;
    make_scenes(all);
    need(tdsp_solver_create(all->scene, &solver) == TDSP_OK, "no solver");
    need(tdsp_earliest_arrival(solver, 0.0, &all->arrival) == TDSP_OK, "no arrival");
    need(tdsp_solver_path(solver, all->legs, LEGS, &all->leg_count) == TDSP_OK, "no path");
    need(tdsp_solver_last_departure(solver, &last) == TDSP_OK, "no last departure");
    all->last = isfinite(last.departure) ? last.departure : all->arrival;
    need(tdsp_jumps_find(solver, NULL, &all->jumps) == TDSP_OK, "no jumps");
    need(tdsp_envelope_find(solver, NULL, &all->envelope) == TDSP_OK, "no envelope");
    const tdsp_build_options options = table_options(all);
    build_with(solver, &options, &all->table_bytes, &all->table_length);
    build_matrix(all, &options, &all->matrix_bytes, &all->matrix_length);
    need(tdsp_table_open(&all->table, all->table_bytes, all->table_length) == TDSP_OK, "the table does not open");
    need(tdsp_matrix_open(&all->matrix, all->matrix_bytes, all->matrix_length) == TDSP_OK, "the matrix does not open");
    tdsp_solver_free(solver);
}

static void free_shared(shared *all)
{
    tdsp_jumps_free(all->jumps);
    tdsp_envelope_free(all->envelope);
    tdsp_bytes_free(NULL, all->table_bytes, all->table_length);
    tdsp_bytes_free(NULL, all->matrix_bytes, all->matrix_length);
    tdsp_scene_free(all->scene);
    tdsp_scene_free(all->growing);
}

/* ------------------------------------------------------------------------------------------------------------- the jobs */

static uint64_t ask(const shared *all, const tdsp_scene *scene, int round)
{
    tdsp_solver *solver = NULL;
    uint64_t hash = 1;
    need(tdsp_solver_create(scene, &solver) == TDSP_OK, "no solver");
    for (int i = 0; i < 6; i++) {
        double arrival = -1, lower = -1, departure = -1;
        tdsp_leg legs[LEGS];
        size_t count = 0;
        const double t = all->last * (i + round % 2) / 8;
        mix_number(&hash, tdsp_earliest_arrival(solver, t, &arrival));
        if (tdsp_solver_path(solver, legs, LEGS, &count) == TDSP_OK) mix(&hash, legs, count * sizeof *legs);
        mix_number(&hash, tdsp_earliest_arrival_within(solver, t, 0.25, &arrival, &lower));
        mix_number(&hash, tdsp_latest_departure(solver, all->arrival + t, &departure, NULL));
        mix_number(&hash, arrival + lower);
        mix_number(&hash, departure);
    }
    tdsp_solver_free(solver);
    return hash;
}

static uint64_t one_scene_a_solver_each(const shared *all, int round)
{
    return ask(all, all->scene, round);
}

static uint64_t one_scene_of_changing_rates_a_solver_each(const shared *all, int round)
{
    return ask(all, all->growing, round);
}

static uint64_t one_scene_read(const shared *all, int round)
{
    uint64_t hash = tdsp_scene_hash(all->scene);
    uint32_t disc = 0;
    size_t count = 0;
    for (int i = 0; i < 40; i++) {
        const tdsp_point place = {all->journey.source.x + 0.1 * i, all->journey.source.y + round};
        double radius = 0, rate = 0;
        mix_number(&hash, tdsp_scene_free_until(all->scene, place, &disc));
        mix_number(&hash, tdsp_scene_disc_at(all->growing, (uint32_t)i % 8, 0.1 * i, &radius, &rate));
        mix_number(&hash, radius + rate + disc);
    }
    mix_number(&hash, tdsp_scene_source_free_until(all->scene, NULL) + tdsp_scene_valid_until(all->growing, NULL));
    mix(&hash, tdsp_scene_discs(all->scene, &count), count * sizeof(tdsp_disc));
    return hash;
}

static void read_table(uint64_t *hash, const tdsp_table *table, double last)
{
    for (int i = 0; i <= 40; i++) {
        double lower = 0, upper = 0;
        tdsp_leg legs[LEGS];
        tdsp_point place = {0, 0};
        tdsp_jump jump;
        size_t count = 0;
        const double t = last * i / 40;
        mix_number(hash, tdsp_table_arrival(table, t, &lower, &upper));
        mix_number(hash, lower);
        mix_number(hash, upper);
        mix_number(hash, tdsp_table_departure(table, upper, &lower, &upper));
        mix_number(hash, lower);
        if (tdsp_table_path(table, t, legs, LEGS, &count) == TDSP_OK) mix(hash, legs, count * sizeof *legs);
        if (tdsp_table_position(table, t, t + 1, &place) == TDSP_OK) mix_number(hash, place.x + place.y);
        if (tdsp_table_next_jump(table, t, &jump) == TDSP_OK) mix_number(hash, jump.departure);
    }
}

static uint64_t one_table_read(const shared *all, int round)
{
    uint64_t hash = (uint64_t)round;
    double lower[32], upper[32], departures[32];
    tdsp_status statuses[32];
    for (int i = 0; i < 32; i++) departures[i] = all->last * i / 30;
    read_table(&hash, &all->table, all->last);
    mix_number(&hash, tdsp_table_arrivals(&all->table, departures, 32, lower, upper, statuses));
    mix(&hash, lower, sizeof lower);
    mix_number(&hash, tdsp_table_departures(&all->table, upper, 32, lower, NULL, statuses));
    mix(&hash, lower, sizeof lower);
    return hash;
}

/* Opening reads the bytes only, so many may open the same ones. */
static uint64_t the_same_bytes_opened(const shared *all, int round)
{
    uint64_t hash = (uint64_t)round;
    tdsp_table table;
    tdsp_matrix matrix;
    need(tdsp_table_open(&table, all->table_bytes, all->table_length) == TDSP_OK, "not opened");
    need(tdsp_matrix_open(&matrix, all->matrix_bytes, all->matrix_length) == TDSP_OK, "not opened");
    read_table(&hash, &table, all->last);
    return hash;
}

static uint64_t one_matrix_read(const shared *all, int round)
{
    uint64_t hash = (uint64_t)round;
    for (size_t i = 0; i < 4; i++) {
        tdsp_table table;
        tdsp_matrix_end end;
        if (tdsp_matrix_source(&all->matrix, i / 2, &end) == TDSP_OK) mix(&hash, end.name, end.name_length);
        if (tdsp_matrix_table(&all->matrix, i / 2, i % 2, &table) == TDSP_OK) read_table(&hash, &table, all->last);
    }
    return hash;
}

static uint64_t one_path_and_table_verified(const shared *all, int round)
{
    tdsp_verdict path;
    tdsp_table_verdict table;
    tdsp_point place;
    uint64_t hash = (uint64_t)round;
    need(tdsp_verify_path(all->scene, all->legs, all->leg_count, 0.0, all->arrival, &path) == TDSP_OK && path.problems == 0, "a bad path");
    need(tdsp_verify_table(all->scene, &all->table, &table) == TDSP_OK && table.ok, "a bad table");
    need(tdsp_path_position(all->legs, all->leg_count, 0.5 * all->arrival, &place) == TDSP_OK, "no position");
    mix_number(&hash, path.min_clearance);
    mix_number(&hash, table.worst.min_clearance);
    mix_number(&hash, place.x + place.y);
    return hash;
}

static uint64_t margins_in_one_scene(const shared *all, int round)
{
    tdsp_margin departure, path;
    uint64_t hash = (uint64_t)round;
    need(tdsp_departure_margin(all->scene, TDSP_RAISE_FACTOR, 0.0, 2.0 * all->arrival, &departure) == TDSP_OK, "no margin");
    need(tdsp_path_margin(all->scene, TDSP_RAISE_ADDED, all->legs, all->leg_count, 0.0, &path) == TDSP_OK, "no margin of a path");
    mix_number(&hash, departure.most);
    mix_number(&hash, path.most);
    return hash;
}

static uint64_t one_envelope_and_jumps_read(const shared *all, int round)
{
    uint64_t hash = (uint64_t)round;
    for (size_t i = 0; i < tdsp_envelope_pieces(all->envelope); i++) {
        tdsp_piece piece;
        need(tdsp_envelope_piece(all->envelope, i, &piece) == TDSP_OK, "no piece");
        mix_number(&hash, piece.until);
        if (piece.ride_count > 0) mix(&hash, piece.rides, piece.ride_count * sizeof *piece.rides);
    }
    for (size_t i = 0; i < tdsp_jumps_count(all->jumps); i++) {
        tdsp_arrival_jump jump;
        need(tdsp_jumps_get(all->jumps, i, &jump) == TDSP_OK, "no jump");
        mix_number(&hash, jump.departure);
    }
    return hash;
}

static uint64_t names_and_texts(const shared *all, int round)
{
    uint64_t hash = (uint64_t)round + all->leg_count;
    for (int i = 0; i < 70; i++) {
        const char *texts[] = {tdsp_status_name((tdsp_status)i), tdsp_status_text((tdsp_status)i), tdsp_method_name((tdsp_method)i), tdsp_version(),
                               tdsp_limit_name((tdsp_limit)i),   tdsp_oracle_rule_name((tdsp_oracle_rule)i)};
        for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) mix(&hash, texts[k], strlen(texts[k]));
    }
    return hash;
}

static uint64_t a_scene_and_a_table_each(const shared *all, int round)
{
    tdsp_scene *scene = NULL;
    tdsp_solver *solver = NULL;
    void *bytes = NULL;
    size_t length = 0;
    uint64_t hash = (uint64_t)round;
    const tdsp_build_options options = table_options(all);
    need(tdsp_scene_create(&all->journey, all->discs, DISCS, NULL, &scene) == TDSP_OK, "no scene");
    need(tdsp_solver_create(scene, &solver) == TDSP_OK, "no solver");
    build_with(solver, &options, &bytes, &length);
    mix(&hash, bytes, length);
    tdsp_bytes_free(NULL, bytes, length);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
    return hash;
}

/* --------------------------------------------------------------------------------------------- workers for one building */

typedef struct crowd {
    pthread_mutex_t lock;
    size_t next, count;
    tdsp_task task;
    void *ctx;
    int helpers; /* who have taken their number as a worker */
} crowd;

static int crowd_take(crowd *c, size_t *i)
{
    pthread_mutex_lock(&c->lock);
    *i = c->next;
    const int any = c->next < c->count;
    c->next += (size_t)any;
    pthread_mutex_unlock(&c->lock);
    return any;
}

static void crowd_work(crowd *c, size_t worker)
{
    size_t i;
    while (crowd_take(c, &i)) c->task(c->ctx, i, worker);
}

static void *crowd_help(void *ctx)
{
    crowd *c = ctx;
    pthread_mutex_lock(&c->lock);
    const int worker = ++c->helpers;
    pthread_mutex_unlock(&c->lock);
    crowd_work(c, (size_t)worker);
    return NULL;
}

static void crowd_run(void *ctx, tdsp_task task, void *task_ctx, size_t count)
{
    (void)ctx;
    crowd c = {.next = 0, .count = count, .task = task, .ctx = task_ctx, .helpers = 0};
    pthread_t threads[THREADS];
    pthread_mutex_init(&c.lock, NULL);
    for (int i = 1; i < THREADS; i++) need(pthread_create(&threads[i], NULL, crowd_help, &c) == 0, "no thread");
    crowd_work(&c, 0);
    for (int i = 1; i < THREADS; i++) pthread_join(threads[i], NULL);
    pthread_mutex_destroy(&c.lock);
}

/* Run once, not by every thread: it has threads of its own. */
static int a_table_by_many_workers_is_that_by_one(const shared *all)
{
    tdsp_solver *solvers[THREADS] = {NULL};
    tdsp_oracle oracles[THREADS];
    tdsp_build_options options = table_options(all);
    void *bytes = NULL;
    size_t length = 0;
    for (int i = 0; i < THREADS; i++) {
        need(tdsp_solver_create(all->scene, &solvers[i]) == TDSP_OK, "no solver");
        need(tdsp_solver_oracle(solvers[i], &oracles[i]) == TDSP_OK, "no oracle");
    }
    options.run_tasks = crowd_run;
    options.workers = oracles;
    options.worker_count = THREADS;
    need(tdsp_build(&oracles[0], &options, NULL, &bytes, &length, NULL) == TDSP_OK, "no table");
    const int same = length == all->table_length && memcmp(bytes, all->table_bytes, length) == 0;
    tdsp_bytes_free(NULL, bytes, length);
    for (int i = 0; i < THREADS; i++) tdsp_solver_free(solvers[i]);
    return same;
}

static int a_matrix_by_many_workers_is_that_by_one(const shared *all)
{
    tdsp_build_options options = table_options(all);
    void *bytes = NULL;
    size_t length = 0;
    options.run_tasks = crowd_run;
    options.worker_count = THREADS;
    build_matrix(all, &options, &bytes, &length);
    const int same = length == all->matrix_length && memcmp(bytes, all->matrix_bytes, length) == 0;
    tdsp_bytes_free(NULL, bytes, length);
    return same;
}

/* ------------------------------------------------------------------------------------------------------------ all at once */

typedef struct runner {
    const shared *all;
    thread_job *job;
    int rounds;
    pthread_barrier_t *start;
    uint64_t hash;
} runner;

static uint64_t run_rounds(const shared *all, thread_job *job, int rounds)
{
    uint64_t hash = 0;
    for (int round = 0; round < rounds; round++) {
        const uint64_t one = job(all, round);
        mix(&hash, &one, sizeof one);
    }
    return hash;
}

static void *run_thread(void *ctx)
{
    runner *r = ctx;
    pthread_barrier_wait(r->start);
    r->hash = run_rounds(r->all, r->job, r->rounds);
    return NULL;
}

static int all_at_once(const shared *all, thread_job *job, int rounds)
{
    pthread_t threads[THREADS];
    runner runners[THREADS];
    pthread_barrier_t start;
    int same = 1;
    const uint64_t alone = run_rounds(all, job, rounds);
    pthread_barrier_init(&start, NULL, THREADS);
    for (int i = 0; i < THREADS; i++) {
        runners[i] = (runner){all, job, rounds, &start, 0};
        need(pthread_create(&threads[i], NULL, run_thread, &runners[i]) == 0, "no thread");
    }
    for (int i = 0; i < THREADS; i++) {
        pthread_join(threads[i], NULL);
        same = same && runners[i].hash == alone;
    }
    pthread_barrier_destroy(&start);
    return same;
}

static int say(const char *name, int good)
{
    printf("%s threads: %s\n", good ? "ok" : "not ok", name);
    return good;
}

static uint64_t racing;

static uint64_t a_race(const shared *all, int round)
{
    racing += all->leg_count + (uint64_t)round;
    return racing;
}

#define AT_ONCE(name) good = say(#name, all_at_once(&all, name, rounds)) && good

int main(int argc, char **argv)
{
    static shared all;
    const int rounds = argc > 1 ? atoi(argv[1]) : 1;
    int good = 1;
    make_shared(&all);
    if (argc > 1 && strcmp(argv[1], "race") == 0) return all_at_once(&all, a_race, 300000) ? 0 : 1;
    AT_ONCE(one_scene_a_solver_each);
    AT_ONCE(one_scene_of_changing_rates_a_solver_each);
    AT_ONCE(one_scene_read);
    AT_ONCE(one_table_read);
    AT_ONCE(the_same_bytes_opened);
    AT_ONCE(one_matrix_read);
    AT_ONCE(one_path_and_table_verified);
    AT_ONCE(margins_in_one_scene);
    AT_ONCE(one_envelope_and_jumps_read);
    AT_ONCE(names_and_texts);
    AT_ONCE(a_scene_and_a_table_each);
    good = say("a_table_by_many_workers_is_that_by_one", a_table_by_many_workers_is_that_by_one(&all)) && good;
    good = say("a_matrix_by_many_workers_is_that_by_one", a_matrix_by_many_workers_is_that_by_one(&all)) && good;
    free_shared(&all);
    return good ? 0 : 1;
}
