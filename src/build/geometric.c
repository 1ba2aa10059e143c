/* SPDX-License-Identifier: MIT */
/*
 * Geometric sampling: Algorithm 1 of Maheshwari, Nouri, Sack (arXiv 1808.01984), its indices mended.
 *
 *     a_0 = A(0),  a_i = (1 + eps) a_(i-1),  b_i = sup { t : A(t) <= a_i }
 *
 * up to the first a_i that is not under A(t_last), whose row is at t_last. For t in (b_(i-1), b_i] the answer lies over a_(i-1), because t
 * is after b_(i-1), and not over a_i. Where A jumps over several a_i their rows coincide and one is kept.
 *
 * Rounding: let m(a) bound noise and comparisons at an arrival of a. A row ends within 1.5 m under its a_i or at a jump over it, so its
 * right side certifies at least a_i - 18.5 m, of which 16 m are allowed for at a jump that a reverse call certifies, and
 * a_i = (1 + eps) (a_(i-1) - 20 m) keeps the guarantee.
 *
 * Rows do not depend on each other: they are solved in batches of a fixed size, each from what was known before its batch, and
 * then added in order. So the bytes do not depend on how many workers there are, or on who is first. Without workers a row is added at
 * once, and targets that turn out to lie in its jump need no call.
 */
#include <math.h>

#include "build/crew.h"
#include "build/invert.h"
#include "build/sampler.h"
#include "build/trail.h"

#define BATCH 16
#define GIVE 16.0
#define LOSS 20.0
#define WINDOW 1.5
#define ASKED 1.25

typedef struct slot {
    double target; /* a_i */
    tdsp_status status;
    bracket bracket;
    kept_path path;
} slot;

typedef struct geometric {
    sampler *sampler;
    sample base; /* what the rows added so far leave to start from */
    trail trail;
    sample batch_base; /* the same when the batch began: what its rows start from */
    trail batch_trail;
    double target; /* the last a_i that was taken or skipped */
    slot slots[BATCH];
    size_t count;
    crew crew;
} geometric;

static double next_target(const geometric *g, double a)
{
    return (1 + g->sampler->options->epsilon) * (a - LOSS * probe_margin(&g->sampler->probe, a));
}

/* The largest a (1 + eps)^m that is not over the limit: the targets between lie in a jump that has its row already. */
static double skip_targets(double a, double ratio, double limit)
{
    double power[64];
    size_t n = 0;
    for (double square = ratio; n < 64 && a * square <= limit; square *= square) power[n++] = square;
    while (n > 0) {
        double skipped = a * power[--n];
        if (skipped <= limit) a = skipped;
    }
    return a;
}

/* The targets of the next batch. TDSP_NOT_SUPPORTED when the next target drowns in the noise. */
static tdsp_status take_targets(geometric *g)
{
    const sample *last = &g->sampler->domain.last;
    g->target = skip_targets(g->target, 1 + g->sampler->options->epsilon, g->base.lower);
    for (g->count = 0; g->count < BATCH;) {
        double a = next_target(g, g->target);
        if (!(a > g->target)) return TDSP_NOT_SUPPORTED;
        if (sample_fits(last, a)) return TDSP_OK;
        g->target = a;
        if (sample_fits(&g->base, a)) g->slots[g->count++].target = a;
    }
    return TDSP_OK;
}

/* Where the oracle can be asked backwards, its answer is the place to begin. */
static tdsp_status seed_of(probe *p, const bracket *b, inversion *goal)
{
    goal->seed = NAN;
    goal->asked = goal->cap - ASKED * probe_margin(p, goal->cap);
    if (!p->oracle->latest_departure) return TDSP_OK;
    tdsp_status status = probe_reverse_between(p, goal->asked, &b->low, &b->high, &goal->answer, &goal->seed_is_known);
    goal->seed = goal->answer.departure;
    return status;
}

static tdsp_status solve(const geometric *g, probe *p, slot *out)
{
    double margin = probe_margin(p, out->target);
    inversion goal = {.cap = out->target,
                      .slack = WINDOW * margin,
                      .give = GIVE * margin,
                      .room = out->target - g->batch_base.ceiling,
                      .anchor = -INFINITY,
                      .after = g->batch_base.departure};
    out->bracket = (bracket){.low = g->batch_base, .high = g->sampler->domain.last};
    tdsp_status status = seed_of(p, &out->bracket, &goal);
    if (status != TDSP_OK) return status;
    trail t = g->batch_trail;
    p->path.departure = -1;
    status = invert(p, &goal, &t, &out->bracket);
    int is_row = out->bracket.low.departure > g->sampler->rows.held.departure;
    if (status == TDSP_OK && is_row) status = sampler_recall_path(p, &out->bracket.low, out->target);
    kept_path_swap(&out->path, &p->path);
    return status;
}

static void solve_task(void *ctx, size_t i, size_t worker)
{
    geometric *g = ctx;
    if (i >= g->count) return;
    probe *p = crew_probe(&g->crew, worker);
    g->slots[i].status = p ? solve(g, p, &g->slots[i]) : TDSP_INVALID_ARGUMENT;
}

/*
 * Add a solved row. A target under what the rows so far leave to start from has its row already: their jump. Where the value jumps
 * right after the row held, the solved row only tells to where.
 */
static tdsp_status merge(geometric *g, slot *solved)
{
    sampler *s = g->sampler;
    const bracket *b = &solved->bracket;
    if (!sample_fits(&g->base, solved->target)) return TDSP_OK;
    if (solved->status != TDSP_OK) return solved->status;
    const sample *after = b->jumps ? &b->high : &b->low;
    row next = sampler_row(s, &b->low, b->after);
    if (next.departure <= s->rows.held.departure) {
        if (next.departure < s->rows.held.departure) return TDSP_OK;
        rows_raise_right(&s->rows, next.right);
    } else {
        tdsp_status status = rows_add(&s->rows, &next, &solved->path);
        if (status != TDSP_OK) return status;
    }
    s->probe.settled = next.departure;
    g->base = *after;
    if (b->jumps)
        trail_restart(&g->trail, after);
    else
        trail_note(&g->trail, after);
    return TDSP_OK;
}

static tdsp_status run_parallel(geometric *g)
{
    for (size_t i = 0; i < g->count; i++) g->slots[i].status = TDSP_FAILED; /* until it was run */
    tdsp_status status = crew_run(&g->crew, solve_task, g, g->count);
    for (size_t i = 0; i < g->count && status == TDSP_OK; i++) status = merge(g, &g->slots[i]);
    return status;
}

static tdsp_status run_alone(geometric *g)
{
    tdsp_status status = TDSP_OK;
    for (size_t i = 0; i < g->count && status == TDSP_OK; i++) {
        if (!sample_fits(&g->base, g->slots[i].target)) continue;
        solve_task(g, i, 0);
        status = merge(g, &g->slots[i]);
    }
    return status;
}

static tdsp_status run_batch(geometric *g)
{
    if (g->count == 0) return TDSP_OK;
    g->batch_base = g->base;
    g->batch_trail = g->trail;
    return crew_is_alone(&g->crew) ? run_alone(g) : run_parallel(g);
}

static tdsp_status sample_all(geometric *g)
{
    sampler *s = g->sampler;
    row first = sampler_row(s, &g->base, g->base.lower);
    tdsp_status status = rows_add(&s->rows, &first, &s->domain.first_path);
    if (s->domain.last.departure == 0 || status != TDSP_OK) return status;
    do {
        status = take_targets(g);
        if (status != TDSP_OK) return status;
        status = run_batch(g);
    } while (status == TDSP_OK && g->count == BATCH);
    return status;
}

tdsp_status sampler_geometric(sampler *s)
{
    const sample *first = &s->domain.first;
    if (!(first->lower > 0)) return TDSP_NOT_SUPPORTED;
    geometric g = {.sampler = s, .base = *first, .trail = trail_begin(first, &s->domain.last), .target = first->lower};
    for (size_t i = 0; i < BATCH; i++) g.slots[i].path = kept_path_none();
    tdsp_status status = crew_begin(&g.crew, s);
    if (status == TDSP_OK) status = sample_all(&g);
    for (size_t i = 0; i < BATCH; i++) kept_path_release(&g.slots[i].path, &s->probe.allocator);
    crew_end(&g.crew);
    return status == TDSP_OK ? sampler_finish(s) : status;
}
