/* SPDX-License-Identifier: MIT */
/*
 * The pieces of A: the sequence of the fastest paths' combinatorial forms.
 *
 * A stretch of departures whose ends have one form is halved down to the resolution, except where T is the same at both: then the path of the later end,
 * started earlier, is a fastest one all along. One whose ends differ is halved until they are as near as departures are told apart: there the
 * form changes. Stretches are looked at from the earliest to the latest, so the pieces come in order.
 *
 * Why no finer test for stretches of one form: a path of another form may be shorter for a while and the first one again after that, which no value of
 * T outside of that while gives away.
 */
#include <string.h>

#include "base/math.h"
#include "scene/allocator.h"
#include "shape/asked.h"
#include "shape/forms.h"

/* A ride that turns by less is a touch. The solver's angles are exact to 1e-12 or so. */
#define SWEEP 1e-9

/* Rides that have begun or end within the accuracy of a change have turned by no more. */
#define SWEEP_NEAR_CHANGE 1e-6

/* Departures are told apart down to this share of the arrival and the time scale. */
#define ACCURACY 1e-10

/* A rise of T within that, in units of the noise, which may be a jump's. */
#define STEEP 16.0

/* Pieces narrower than this many accuracies are no pieces. */
#define NARROW 4.0

#define DEFAULT_RESOLUTION (1.0 / 1024.0)

struct tdsp_envelope {
    tdsp_allocator allocator;
    double resolution;
    shape_forms forms;
    size_t form_count; /* forms numbered for the caller */
    tdsp_piece *pieces;
    size_t count, capacity;
};

/* A departure with its T and its path's form. */
typedef struct formed {
    shape_point at;
    size_t form;
} formed;

typedef struct envelope_task {
    formed low, high;
} envelope_task;

typedef struct envelope_search {
    asked ask;
    envelope_task *tasks;
    size_t count, capacity;
    formed begin; /* of the piece under way */
    tdsp_envelope *envelope;
} envelope_search;

/* Departures are not told apart within this. */
static double accuracy_at(const envelope_search *self, shape_point at)
{
    return ACCURACY * (at.departure + at.travel + self->ask.scale);
}

static tdsp_status ask_formed(envelope_search *self, double departure, double sweep, formed *out)
{
    tdsp_status status = asked_travel(&self->ask, departure, &out->at);
    return status == TDSP_OK ? forms_of_path(&self->envelope->forms, self->ask.solver, sweep, &out->form) : status;
}

static tdsp_status push_stretch(envelope_search *self, formed low, formed high)
{
    void *tasks = self->tasks;
    tdsp_status status = memory_reserve(&self->ask.allocator, &tasks, &self->capacity, self->count + 1, sizeof *self->tasks);
    self->tasks = tasks;
    if (status == TDSP_OK) self->tasks[self->count++] = (envelope_task){low, high};
    return status;
}

static tdsp_status push_piece(envelope_search *self, const tdsp_piece *piece)
{
    tdsp_envelope *envelope = self->envelope;
    void *pieces = envelope->pieces;
    tdsp_status status = memory_reserve(&envelope->allocator, &pieces, &envelope->capacity, envelope->count + 1, sizeof *piece);
    envelope->pieces = pieces;
    if (status == TDSP_OK) envelope->pieces[envelope->count++] = *piece;
    return status;
}

/* The piece under way ends at `end`. */
static tdsp_status close_piece(envelope_search *self, shape_point end, tdsp_change change, tdsp_gap gap)
{
    tdsp_piece piece = {self->begin.at.departure, end.departure, self->begin.at.travel, end.travel, NULL, 0, self->begin.form, change, gap};
    return push_piece(self, &piece);
}

/* Is the piece under way, if it ended there, only what rounding makes of a change? Then it is left out, and what went on before it goes on. */
static int drop_narrow(envelope_search *self, shape_point end, formed next)
{
    tdsp_envelope *envelope = self->envelope;
    if (envelope->count == 0 || end.departure - self->begin.at.departure > NARROW * accuracy_at(self, end)) return 0;
    const tdsp_piece *before = &envelope->pieces[envelope->count - 1];
    if (next.at.travel - before->travel_until > STEEP * asked_noise(&self->ask, next.at)) return 0;
    self->begin.form = next.form;
    if (before->form != next.form || before->change == TDSP_CHANGE_JUMP) return 1;
    self->begin = (formed){{before->from, before->travel_from}, before->form};
    --envelope->count;
    return 1;
}

/* Rides of next to no angle make the whole difference: a touch. */
static tdsp_status change_of(envelope_search *self, formed low, formed high, tdsp_change *change)
{
    formed one, other;
    tdsp_status status = ask_formed(self, low.at.departure, SWEEP_NEAR_CHANGE, &one);
    if (status == TDSP_OK) status = ask_formed(self, high.at.departure, SWEEP_NEAR_CHANGE, &other);
    if (status == TDSP_OK) *change = one.form == other.form ? TDSP_CHANGE_TOUCH : TDSP_CHANGE_SWITCH;
    return status;
}

/* T rises steeply from one form to the next: by a jump? */
static tdsp_status close_at_jump(envelope_search *self, formed low, formed high, int *jumps)
{
    shape_point before, after;
    tdsp_gap gap;
    tdsp_status status = asked_middle(&self->ask, low.at, high.at, &before, &after, jumps);
    if (status != TDSP_OK || !*jumps) return status;
    status = asked_gap(&self->ask, before, &gap);
    if (status == TDSP_OK) status = close_piece(self, before, TDSP_CHANGE_JUMP, gap);
    self->begin = (formed){{before.departure, after.travel}, high.form};
    return status;
}

/* The form changes between two departures that are hardly told apart. */
static tdsp_status change_form(envelope_search *self, formed low, formed high)
{
    const tdsp_gap none = {TDSP_NO_DISC, TDSP_NO_DISC, 0.0, {0, 0}};
    double rise = high.at.travel - low.at.travel;
    tdsp_change change = TDSP_CHANGE_SWITCH;
    tdsp_status status = TDSP_OK;
    int jumps = 0;
    if (drop_narrow(self, low.at, high)) return TDSP_OK;
    if (rise > STEEP * asked_noise(&self->ask, high.at)) status = close_at_jump(self, low, high, &jumps);
    if (status != TDSP_OK || jumps) return status;
    status = change_of(self, low, high, &change);
    if (status == TDSP_OK) status = close_piece(self, low.at, change, none);
    self->begin = (formed){{low.at.departure, high.at.travel}, high.form};
    return status;
}

static int is_whole(const envelope_search *self, const envelope_task *task)
{
    double length = task->high.at.departure - task->low.at.departure;
    double middle = task->low.at.departure + 0.5 * length;
    if (middle <= task->low.at.departure || middle >= task->high.at.departure) return 1;
    if (task->low.form != task->high.form) return length <= accuracy_at(self, task->high.at);
    return length <= self->envelope->resolution ||
           task->high.at.travel - task->low.at.travel <= 4.0 * asked_noise(&self->ask, task->high.at);
}

static tdsp_status look_at_stretch(envelope_search *self, const envelope_task *task)
{
    formed middle;
    if (is_whole(self, task)) return task->low.form == task->high.form ? TDSP_OK : change_form(self, task->low, task->high);
    tdsp_status status = asked_progress(&self->ask, task->low.at.departure);
    double departure = task->low.at.departure + 0.5 * (task->high.at.departure - task->low.at.departure);
    if (status == TDSP_OK) status = ask_formed(self, departure, SWEEP, &middle);
    if (status == TDSP_OK) status = push_stretch(self, middle, task->high);
    return status == TDSP_OK ? push_stretch(self, task->low, middle) : status;
}

static tdsp_status search_pieces(envelope_search *self)
{
    const tdsp_shape_options *options = &self->ask.options;
    const tdsp_gap none = {TDSP_NO_DISC, TDSP_NO_DISC, 0.0, {0, 0}};
    formed last;
    double resolution = options->resolution > 0.0 ? options->resolution : DEFAULT_RESOLUTION * (options->until - options->from);
    self->envelope->resolution = math_max(resolution, accuracy_at(self, self->ask.last));
    tdsp_status status = ask_formed(self, options->from, SWEEP, &self->begin);
    if (status == TDSP_OK) status = ask_formed(self, options->until, SWEEP, &last);
    if (status == TDSP_OK) status = push_stretch(self, self->begin, last);
    while (status == TDSP_OK && self->count > 0) {
        envelope_task task = self->tasks[--self->count];
        status = look_at_stretch(self, &task);
    }
    return status == TDSP_OK ? close_piece(self, last.at, TDSP_CHANGE_END, none) : status;
}

/* Number the forms in the order of their pieces, now that every ride has its place. */
static tdsp_status finish(tdsp_envelope *self)
{
    size_t *numbers = memory_array(&self->allocator, self->forms.count, sizeof *numbers);
    if (!numbers) return TDSP_NO_MEMORY;
    for (size_t i = 0; i < self->forms.count; ++i) numbers[i] = SIZE_MAX;
    for (size_t i = 0; i < self->count; ++i) {
        tdsp_piece *piece = &self->pieces[i];
        const shape_form *form = &self->forms.forms[piece->form];
        if (numbers[piece->form] == SIZE_MAX) numbers[piece->form] = self->form_count++;
        piece->rides = form->count > 0 ? self->forms.rides + form->first : NULL;
        piece->ride_count = form->count;
        piece->form = numbers[piece->form];
    }
    memory_free(&self->allocator, numbers, self->forms.count * sizeof *numbers);
    return TDSP_OK;
}

tdsp_status tdsp_envelope_find(tdsp_solver *solver, const tdsp_shape_options *options, tdsp_envelope **out)
{
    envelope_search search;
    memset(&search, 0, sizeof search);
    if (!out) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = asked_begin(&search.ask, solver, options);
    if (status != TDSP_OK) return status;
    tdsp_envelope *envelope = search.envelope = memory_array(&search.ask.allocator, 1, sizeof *envelope);
    if (!envelope) return TDSP_NO_MEMORY;
    memset(envelope, 0, sizeof *envelope);
    envelope->allocator = search.ask.allocator;
    forms_begin(&envelope->forms, &envelope->allocator);
    status = search_pieces(&search);
    memory_free(&search.ask.allocator, search.tasks, search.capacity * sizeof *search.tasks);
    if (status == TDSP_OK) status = finish(envelope);
    if (status == TDSP_OK)
        *out = envelope;
    else
        tdsp_envelope_free(envelope);
    return status;
}

size_t tdsp_envelope_pieces(const tdsp_envelope *envelope)
{
    return envelope ? envelope->count : 0;
}

size_t tdsp_envelope_forms(const tdsp_envelope *envelope)
{
    return envelope ? envelope->form_count : 0;
}

double tdsp_envelope_resolution(const tdsp_envelope *envelope)
{
    return envelope ? envelope->resolution : 0.0;
}

tdsp_status tdsp_envelope_piece(const tdsp_envelope *envelope, size_t i, tdsp_piece *out)
{
    if (!envelope || !out || i >= envelope->count) return TDSP_INVALID_ARGUMENT;
    *out = envelope->pieces[i];
    return TDSP_OK;
}

void tdsp_envelope_free(tdsp_envelope *envelope)
{
    if (!envelope) return;
    tdsp_allocator allocator = envelope->allocator;
    forms_end(&envelope->forms);
    memory_free(&allocator, envelope->pieces, envelope->capacity * sizeof *envelope->pieces);
    memory_free(&allocator, envelope, sizeof *envelope);
}
