/* SPDX-License-Identifier: MIT */
/*
 * Adaptive sampling: b_i = sup { t : the guarantee holds on (b_(i-1), t] }, row by row.
 *
 * Greedy is optimal: the cap of a row rises with the lower bound it starts from, the lower bound with the departure, so a row
 * that ends later never leads to more rows (docs/sampler.md). Two rows meet in one of two ways:
 *
 *   at a jump       a lower bound of the value right after b is known, by a reverse call or by the value at the next double; the
 *                   following row starts from it;
 *   on a slope      the row stops within a thousandth of the allowed increase, and its right side is its own value,
 *                   rounded down, for values never decrease.
 *
 * Rows depend on those before, but not across the jumps that every row ends at (survey.h). The pieces between are tasks of their own, whose rows are
 * joined in order; so the bytes do not depend on how many workers there are.
 */
#include "build/sampler.h"

#include "base/math.h"
#include "build/crew.h"
#include "build/survey.h"
#include "build/trail.h"
#include "scene/allocator.h"

typedef struct piece_row {
    row row;
    kept_path path;
} piece_row;

/* The rows from one landmark, or the beginning, to before the next one, or the end. */
typedef struct piece {
    sample base; /* where the row under way starts */
    sample end;
    piece_row *rows; /* the first is at the landmark itself */
    size_t count;
    size_t capacity;
    tdsp_status status;
} piece;

typedef struct pieces {
    sampler *sampler;
    crew crew;
    survey *survey;
    piece *all;
    size_t count;
} pieces;

static tdsp_status piece_add(const sampler *s, piece *out, const row *next, kept_path *path)
{
    if (out->count > s->options->max_rows) return TDSP_TOO_MANY_ROWS;
    void *block = out->rows;
    tdsp_status status = memory_reserve(&s->probe.allocator, &block, &out->capacity, out->count + 1, sizeof *out->rows);
    out->rows = block;
    if (status != TDSP_OK) return status;
    piece_row *added = &out->rows[out->count++];
    *added = (piece_row){*next, kept_path_none()};
    kept_path_swap(&added->path, path);
    return kept_path_trim(&added->path, &s->probe.allocator);
}

static tdsp_status add_row(const sampler *s, probe *p, piece *out, const bracket *b, double cap)
{
    sample low = b->low;
    tdsp_status status = sampler_recall_path(p, &low, cap);
    if (status != TDSP_OK) return status;
    row next = sampler_row(s, &low, b->after);
    next = rows_raised(s->monotone, &out->rows[out->count - 1].row, &next);
    p->settled = low.departure;
    return piece_add(s, out, &next, &p->path);
}

/* Samples ahead that fit are where the row goes at least. Returns 1 when that is the end of the piece. */
static int pass_known(trail *t, double cap, bracket *b)
{
    while (t->ahead_count > 0 && sample_fits(&t->ahead[t->ahead_count - 1], cap)) {
        b->low = t->ahead[--t->ahead_count];
        trail_note(t, &b->low);
    }
    if (t->ahead_count == 0) return 1;
    b->high = t->ahead[t->ahead_count - 1];
    return 0;
}

/* One row more, or the right side of the last row when the value jumps just after it. */
static tdsp_status step(const sampler *s, probe *p, trail *t, piece *out, int *ended)
{
    row *held = &out->rows[out->count - 1].row;
    double lower = held->right + (s->probe.by_arrival ? held->departure : 0);
    inversion goal = sampler_goal(s, held->departure, out->base.ceiling, lower);
    if (!sample_fits(&out->base, goal.cap)) return TDSP_NOT_SUPPORTED;
    bracket b = {.low = out->base, .high = out->base};
    *ended = pass_known(t, goal.cap, &b);
    if (*ended) return TDSP_OK;
    double pace = t->pace;
    tdsp_status status = invert(p, &goal, t, &b);
    if (status != TDSP_OK) return status;
    out->base = b.jumps ? b.high : b.low;
    if (b.jumps) {
        trail_restart(t, &b.high);
        t->pace = pace;
    }
    if (b.low.departure > held->departure) return add_row(s, p, out, &b, goal.cap);
    held->right = math_max(held->right, sampler_row(s, &b.low, b.after).right);
    return TDSP_OK;
}

/* What the survey knows within a piece, the nearest last. */
static trail trail_of(const survey *known, const piece *of)
{
    trail t = trail_begin(&of->base, &of->end);
    for (size_t i = known->known_count; i-- > 0;) {
        const sample *s = &known->known[i];
        if (s->departure > of->base.departure && s->departure < of->end.departure) trail_push_ahead(&t, s);
    }
    return t;
}

static tdsp_status piece_sample(const pieces *self, probe *p, piece *out)
{
    int ended = !(out->end.departure > out->base.departure);
    trail t = trail_of(self->survey, out);
    tdsp_status status = TDSP_OK;
    p->path.departure = -1;
    while (status == TDSP_OK && !ended) status = step(self->sampler, p, &t, out, &ended);
    return status;
}

static void piece_task(void *ctx, size_t i, size_t worker)
{
    pieces *self = ctx;
    if (i >= self->count) return;
    probe *p = crew_probe(&self->crew, worker);
    self->all[i].status = p ? piece_sample(self, p, &self->all[i]) : TDSP_INVALID_ARGUMENT;
}

/* The piece after a landmark, or the first, up to the next one, or the last. */
static tdsp_status piece_begin(pieces *self, size_t i)
{
    sampler *s = self->sampler;
    landmark *from = i > 0 ? &self->survey->landmarks[i - 1] : NULL;
    const sample *start = from ? &from->bracket.low : &s->domain.first;
    piece *out = &self->all[i];
    *out = (piece){.base = from ? from->bracket.high : *start, .status = TDSP_FAILED};
    out->end = i + 1 < self->count ? self->survey->landmarks[i].bracket.low : s->domain.last;
    row first = sampler_row(s, start, from ? from->bracket.after : start->lower);
    return piece_add(s, out, &first, from ? &from->path : &s->domain.first_path);
}

/* A landmark at departure 0 is the first row, which is there. */
static tdsp_status join_row(rows *all, piece_row *next)
{
    if (all->count == 0 || next->row.departure != all->held.departure) return rows_add(all, &next->row, &next->path);
    rows_raise_right(all, next->row.right);
    return TDSP_OK;
}

static tdsp_status join(const pieces *self)
{
    for (size_t i = 0; i < self->count; i++) {
        const piece *from = &self->all[i];
        tdsp_status status = from->status;
        for (size_t k = 0; k < from->count && status == TDSP_OK; k++) status = join_row(&self->sampler->rows, &from->rows[k]);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}

static void pieces_release(pieces *self)
{
    const tdsp_allocator *memory = &self->sampler->probe.allocator;
    for (size_t i = 0; i < self->count; i++) {
        for (size_t k = 0; k < self->all[i].count; k++) kept_path_release(&self->all[i].rows[k].path, memory);
        memory_free(memory, self->all[i].rows, self->all[i].capacity * sizeof *self->all[i].rows);
    }
    memory_free(memory, self->all, (self->survey->landmark_count + 1) * sizeof *self->all);
}

static tdsp_status sample_pieces(pieces *self)
{
    tdsp_status status = TDSP_OK;
    self->all = memory_array(&self->sampler->probe.allocator, self->survey->landmark_count + 1, sizeof *self->all);
    if (!self->all) return TDSP_NO_MEMORY;
    self->count = self->survey->landmark_count + 1;
    for (size_t i = 0; i < self->count; i++) self->all[i] = (piece){.status = TDSP_FAILED};
    for (size_t i = 0; i < self->count && status == TDSP_OK; i++) status = piece_begin(self, i);
    if (status == TDSP_OK) status = crew_run(&self->crew, piece_task, self, self->count);
    if (status == TDSP_OK) status = join(self);
    return status;
}

tdsp_status sampler_adaptive(sampler *s)
{
    pieces self = {.sampler = s};
    self.survey = memory_array(&s->probe.allocator, 1, sizeof *self.survey);
    if (!self.survey) return TDSP_NO_MEMORY;
    *self.survey = (survey){.stretch_count = 0};
    tdsp_status status = crew_begin(&self.crew, s);
    if (status == TDSP_OK) status = survey_make(self.survey, &self.crew);
    if (status == TDSP_OK) status = sample_pieces(&self);
    pieces_release(&self);
    crew_end(&self.crew);
    survey_release(self.survey, &s->probe.allocator);
    memory_free(&s->probe.allocator, self.survey, sizeof *self.survey);
    return status == TDSP_OK ? sampler_finish(s) : status;
}
