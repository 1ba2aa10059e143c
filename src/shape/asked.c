/* SPDX-License-Identifier: MIT */
/*
 * Questions to a solver about the shape of T.
 *
 * A departure that a solver gives for an arrival inside a jump lies at the jump up to a few times the stated error, and on either side of a jump the
 * solver may take the wrong side for departures as near as ten times that. So T(t+) is asked for at distances behind the jump that grow from twice
 * the error until T has left its low value, which adds no more to it than T rises within so short a time.
 */
#include "shape/asked.h"

#include "base/math.h"
#include "search/solver.h"

/* Distances behind a jump grow by this, so often at most: up to 4^20 times the error is far beyond what a solver can be off. */
#define STEP_GROWTH 4.0
#define STEPS 20

/* Travel times are told apart from here on, in units of the noise. */
#define TOLD_APART 4.0

/* `least` may not be less than this share of T(until). */
#define FINEST 1e-9

void tdsp_shape_options_init(tdsp_shape_options *options)
{
    if (!options) return;
    tdsp_shape_options defaults = {sizeof defaults, 0.0, INFINITY, 0.0, 0.0, NULL, NULL};
    *options = defaults;
}

static int options_good(const tdsp_shape_options *options)
{
    return options->size == sizeof *options && options->from >= 0.0 && !isinf(options->from) && options->until >= options->from &&
           options->least >= 0.0 && !isinf(options->least) && options->resolution >= 0.0 && !isinf(options->resolution);
}

/* The last departure of all, where that ends what is looked at. */
static tdsp_status asked_last(asked *self)
{
    double last;
    tdsp_status status = tdsp_latest_departure(self->solver, INFINITY, &last, NULL);
    int endless = status == TDSP_NOT_SUPPORTED || (status == TDSP_OK && isinf(last));
    if (endless && isinf(self->options.until)) return TDSP_NEEDS_HORIZON;
    if (status != TDSP_OK) return status;
    self->options.until = math_max(math_min(self->options.until, last), self->options.from);
    return asked_travel(self, self->options.until, &self->last);
}

static tdsp_status asked_end(asked *self)
{
    if (isinf(self->options.until)) return asked_last(self);
    tdsp_status status = asked_travel(self, self->options.until, &self->last);
    return status != TDSP_OK && tdsp_status_is_answer(status) ? asked_last(self) : status;
}

tdsp_status asked_begin(asked *self, tdsp_solver *solver, const tdsp_shape_options *options)
{
    if (!solver) return TDSP_INVALID_ARGUMENT;
    self->solver = solver;
    self->allocator = solver->scene->allocator;
    self->scale = solver->ends.time;
    tdsp_shape_options_init(&self->options);
    if (options) self->options = *options;
    if (!options_good(&self->options)) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = asked_travel(self, self->options.from, &self->first);
    if (status == TDSP_OK) status = asked_end(self);
    if (status != TDSP_OK) return status;
    int too_fine = self->options.least > 0.0 && self->options.least < FINEST * self->last.travel;
    return too_fine ? TDSP_INVALID_ARGUMENT : TDSP_OK;
}

tdsp_status asked_travel(asked *self, double departure, shape_point *out)
{
    double arrival;
    tdsp_status status = tdsp_earliest_arrival(self->solver, departure, &arrival);
    if (status != TDSP_OK) return status;
    *out = (shape_point){departure, arrival - departure};
    return TDSP_OK;
}

double asked_noise(const asked *self, shape_point at)
{
    return TDSP_SOLVER_ERROR * (at.travel + self->scale) + 0x1p-50 * (at.departure + at.travel);
}

tdsp_status asked_progress(const asked *self, double settled)
{
    tdsp_progress progress = self->options.progress;
    return progress && progress(self->options.progress_ctx, settled, self->options.until) ? TDSP_CANCELLED : TDSP_OK;
}

/* The first departure asked behind the jump whose T is over `level`. */
static tdsp_status asked_behind(asked *self, shape_point before, shape_point high, double level, shape_point *after)
{
    double step = 2.0 * asked_noise(self, high);
    for (int i = 0; i < STEPS; ++i, step *= STEP_GROWTH) {
        double departure = before.departure + step;
        if (departure >= high.departure) break;
        tdsp_status status = asked_travel(self, departure, after);
        if (status != TDSP_OK || after->travel > level) return status;
    }
    *after = high;
    return TDSP_OK;
}

tdsp_status asked_middle(asked *self, shape_point low, shape_point high, shape_point *before, shape_point *after, int *jumps)
{
    double middle = 0.5 * (low.departure + low.travel + high.departure + high.travel), departure, arrives;
    tdsp_status status = tdsp_latest_departure(self->solver, middle, &departure, &arrives);
    if (status != TDSP_OK) return status == TDSP_ARRIVAL_TOO_EARLY ? TDSP_FAILED : status;
    *before = (shape_point){departure, arrives - departure};
    if (departure <= low.departure) *before = low;
    if (departure >= high.departure) *before = high;
    *after = *before;
    double short_of = middle - before->departure - before->travel;
    *jumps = short_of > TOLD_APART * asked_noise(self, high);
    return *jumps ? asked_behind(self, *before, high, before->travel + 0.5 * short_of, after) : TDSP_OK;
}

tdsp_status asked_gap(asked *self, shape_point before, tdsp_gap *out)
{
    *out = (tdsp_gap){TDSP_NO_DISC, TDSP_NO_DISC, 0.0, {0, 0}};
    tdsp_status status = tdsp_solver_gap(self->solver, before.departure, out);
    return status == TDSP_NO_ANSWER ? TDSP_OK : status;
}
