/* SPDX-License-Identifier: MIT */
/*
 * Looking for the large jumps before any row is placed.
 *
 * Let J be a departure whose value T(J) jumps to more than the cap of any row that starts at or before it: over rows_cap(J, T(J)). The row
 * that covers J started with a lower bound of T(J) at most, so it cannot cross the jump, and its cap is not under T(J), so it need not end
 * earlier: every sampling that places rows as late as it can has a row that ends at J, and the next begins with the bound right after the jump. So
 * the rows on either side do not depend on each other.
 *
 * The search is made of rounds over stretches of departures with too much rise for one row. A task halves its stretch, or, where nearly
 * all the rise of the stretch before fell into this half, looks for the jump as a row would that starts at its low end. A stretch whose
 * middle is near the straight line is left to the rows. These are the questions that the rows would have to ask as well, only sooner: the
 * samples are kept for them. What is found depends on the answers alone, not on who asks or in what order.
 */
#include "build/survey.h"

#include <math.h>
#include <string.h>

#define HALVINGS 12u
#define STRAIGHT 0.05 /* of the rise: how far the middle of a smooth stretch is off its chord */
#define NEARLY_ALL 0.8 /* of the rise in one half: a jump */

static int has_too_much(const survey *self, const sample *low, const sample *high)
{
    const sampler *s = self->crew->sampler;
    return !sample_fits(high, rows_cap(s->options, s->monotone, low->departure, low->lower));
}

static size_t place_of(const sample *sorted, size_t count, double departure)
{
    while (count > 0 && sorted[count - 1].departure > departure) count--;
    return count;
}

/* Samples that do not fit in are forgotten, which costs a call at most. */
static void remember(survey *self, const sample *s)
{
    if (self->known_count == SURVEY_MOST) return;
    size_t at = place_of(self->known, self->known_count, s->departure);
    memmove(self->known + at + 1, self->known + at, (self->known_count - at) * sizeof *self->known);
    self->known[at] = *s;
    self->known_count++;
}

static void add_landmark(survey *self, const bracket *b, kept_path *path)
{
    if (self->landmark_count == SURVEY_MOST) return;
    size_t at = self->landmark_count;
    while (at > 0 && self->landmarks[at - 1].bracket.low.departure > b->low.departure) at--;
    memmove(self->landmarks + at + 1, self->landmarks + at, (self->landmark_count - at) * sizeof *self->landmarks);
    self->landmarks[at] = (landmark){*b, kept_path_none()};
    kept_path_swap(&self->landmarks[at].path, path);
    self->landmark_count++;
}

/* Does no row cross the jump? */
static int is_barrier(const sampler *s, const bracket *b)
{
    return b->jumps && b->after > rows_cap(s->options, s->monotone, b->low.departure, b->low.ceiling);
}

static tdsp_status find_jump(const sampler *s, probe *p, stretch *it)
{
    inversion goal = sampler_goal(s, it->low.departure, it->low.ceiling, it->low.lower);
    goal.suspected = 1;
    trail t = trail_begin(&it->low, &it->high);
    it->bracket = (bracket){.low = it->low, .high = it->high};
    p->path.departure = -1;
    tdsp_status status = invert(p, &goal, &t, &it->bracket);
    if (status == TDSP_OK && is_barrier(s, &it->bracket)) status = sampler_recall_path(p, &it->bracket.low, goal.cap);
    kept_path_swap(&it->path, &p->path);
    return status;
}

static tdsp_status halve(probe *p, stretch *it)
{
    double middle = it->low.departure + (it->high.departure - it->low.departure) / 2;
    tdsp_status status = probe_roughly(p, middle, &it->middle);
    return status == TDSP_OK ? probe_order(p, &it->low, &it->high, &it->middle) : status;
}

static void survey_task(void *ctx, size_t i, size_t worker)
{
    survey *self = ctx;
    if (i >= self->stretch_count) return;
    stretch *it = &self->stretches[i];
    probe *p = crew_probe(self->crew, worker);
    if (!p)
        it->status = TDSP_INVALID_ARGUMENT;
    else
        it->status = it->suspected ? find_jump(self->crew->sampler, p, it) : halve(p, it);
}

/* The half of a stretch, if there is more to find in it. */
static void add_half(survey *self, stretch *next, size_t *count, const stretch *of, int upper)
{
    const sample *low = upper ? &of->middle : &of->low;
    const sample *high = upper ? &of->high : &of->middle;
    if (*count == SURVEY_MOST || of->halvings == HALVINGS || !has_too_much(self, low, high)) return;
    double share = (high->value - low->value) / (of->high.value - of->low.value);
    int narrow = high->departure - low->departure <= 2 * (high->value - low->value);
    next[(*count)++] = (stretch){.low = *low,
                                 .high = *high,
                                 .halvings = of->halvings + 1,
                                 .suspected = narrow && share > NEARLY_ALL,
                                 .status = TDSP_FAILED,
                                 .path = kept_path_none()};
}

static int is_straight(const stretch *it)
{
    double off = it->middle.value - (it->low.value + it->high.value) / 2;
    return fabs(off) <= STRAIGHT * (it->high.value - it->low.value);
}

static void note_bracket(survey *self, stretch *it)
{
    const bracket *b = &it->bracket;
    if (is_barrier(self->crew->sampler, b)) {
        add_landmark(self, b, &it->path);
        return;
    }
    if (b->low.departure > it->low.departure) remember(self, &b->low);
    if (b->high.departure < it->high.departure) remember(self, &b->high);
}

static void note(survey *self, stretch *it, stretch *next, size_t *count)
{
    if (it->suspected) {
        note_bracket(self, it);
        return;
    }
    remember(self, &it->middle);
    if (is_straight(it)) return;
    add_half(self, next, count, it, 0);
    add_half(self, next, count, it, 1);
}

static tdsp_status survey_round(survey *self, stretch *next)
{
    size_t count = 0;
    tdsp_status status = crew_run(self->crew, survey_task, self, self->stretch_count);
    for (size_t i = 0; i < self->stretch_count && status == TDSP_OK; i++) {
        status = self->stretches[i].status;
        if (status == TDSP_OK) note(self, &self->stretches[i], next, &count);
    }
    for (size_t i = 0; i < self->stretch_count; i++)
        kept_path_release(&self->stretches[i].path, &self->crew->sampler->probe.allocator);
    memcpy(self->stretches, next, count * sizeof *next);
    self->stretch_count = count;
    return status;
}

tdsp_status survey_make(survey *out, const crew *c)
{
    const sampler *s = c->sampler;
    stretch next[SURVEY_MOST];
    out->stretch_count = out->landmark_count = out->known_count = 0;
    out->crew = c;
    tdsp_status status = TDSP_OK;
    if (!has_too_much(out, &s->domain.first, &s->domain.last)) return TDSP_OK;
    out->stretches[out->stretch_count++] =
        (stretch){.low = s->domain.first, .high = s->domain.last, .status = TDSP_FAILED, .path = kept_path_none()};
    while (status == TDSP_OK && out->stretch_count > 0) status = survey_round(out, next);
    return status;
}

void survey_release(survey *self, const tdsp_allocator *allocator)
{
    for (size_t i = 0; i < self->stretch_count; i++) kept_path_release(&self->stretches[i].path, allocator);
    for (size_t i = 0; i < self->landmark_count; i++) kept_path_release(&self->landmarks[i].path, allocator);
}
