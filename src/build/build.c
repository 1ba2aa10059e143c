/* SPDX-License-Identifier: MIT */
/*
 * tdsp_build(): arguments in, a table out. The order of work is the order of the answers that can end it early: arguments, the way at
 * departure 0, the end of the domain, the rows, the bytes.
 */
#include "tdsp/build.h"

#include <float.h>
#include <string.h>

#include "base/math.h"
#include "build/invert.h"
#include "build/sampler.h"
#include "build/writer.h"
#include "scene/allocator.h"

#define MIN_EPSILON 1e-9
#define MAX_EPSILON 1.0
#define MAX_ERROR 0.1
#define MAX_SHARE 0.9
#define SHARE 0.75
#define UNIT_BYTES 15u

void tdsp_oracle_init(tdsp_oracle *oracle)
{
    if (!oracle) return;
    *oracle = (tdsp_oracle){.size = sizeof *oracle, .monotone = TDSP_MONOTONE_TRAVEL};
}

void tdsp_build_options_init(tdsp_build_options *options)
{
    if (!options) return;
    *options = (tdsp_build_options){.size = sizeof *options,
                                    .guarantee = TDSP_GUARANTEE_TRAVEL,
                                    .sampling = TDSP_SAMPLING_ADAPTIVE,
                                    .epsilon = 0.01,
                                    .horizon = INFINITY,
                                    .max_rows = TDSP_MAX_ROWS,
                                    .oracle_share = SHARE};
}

static int oracle_is_valid(const tdsp_oracle *oracle)
{
    if (!oracle || oracle->size != sizeof *oracle || !oracle->earliest_arrival) return 0;
    int known = oracle->monotone == TDSP_MONOTONE_TRAVEL || oracle->monotone == TDSP_MONOTONE_ARRIVAL;
    int error_in_range = oracle->error >= 0 && oracle->error <= MAX_ERROR;
    return known && error_in_range && oracle->time_scale >= 0 && oracle->time_scale <= DBL_MAX;
}

/* Workers stand in for the oracle: what they declare is what it declares. */
static int worker_is_valid(const tdsp_oracle *worker, const tdsp_oracle *oracle)
{
    return oracle_is_valid(worker) && worker->monotone == oracle->monotone && worker->error == oracle->error &&
           worker->time_scale == oracle->time_scale && !worker->latest_departure == !oracle->latest_departure &&
           !worker->path == !oracle->path && !worker->earliest_arrival_within == !oracle->earliest_arrival_within &&
           !worker->latest_departure_between == !oracle->latest_departure_between;
}

static int workers_are_valid(const tdsp_build_options *options, const tdsp_oracle *oracle)
{
    if (!options->workers) return options->worker_count == 0;
    if (options->worker_count == 0) return 0;
    for (size_t i = 0; i < options->worker_count; i++)
        if (!worker_is_valid(&options->workers[i], oracle)) return 0;
    return 1;
}

static int unit_is_valid(const char *unit)
{
    if (!unit) return 1;
    for (size_t i = 0; i <= UNIT_BYTES; i++)
        if (unit[i] == '\0') return 1;
    return 0;
}

static int world_is_valid(const tdsp_build_world *world)
{
    int finite = isfinite(world->source.x) && isfinite(world->source.y) && isfinite(world->destination.x) &&
                 isfinite(world->destination.y);
    return finite && world->speed >= 0 && world->speed <= DBL_MAX && unit_is_valid(world->length_unit) &&
           unit_is_valid(world->time_unit);
}

static int bound_is_valid(const tdsp_build_options *options)
{
    switch (options->guarantee) {
    case TDSP_GUARANTEE_TRAVEL:
    case TDSP_GUARANTEE_ARRIVAL:
        return options->epsilon >= MIN_EPSILON && options->epsilon <= MAX_EPSILON;
    case TDSP_GUARANTEE_ABSOLUTE:
        return options->delta > 0 && options->delta <= DBL_MAX;
    }
    return 0;
}

static int options_are_valid(const tdsp_build_options *options, const tdsp_oracle *oracle)
{
    if (!options || options->size != sizeof *options) return 0;
    int sampling = options->sampling == TDSP_SAMPLING_ADAPTIVE || options->sampling == TDSP_SAMPLING_GEOMETRIC;
    int share = options->oracle_share >= 0 && options->oracle_share <= MAX_SHARE;
    int limits = share && options->horizon >= 0 && options->max_rows >= 1 && options->max_rows <= TDSP_MAX_ROWS;
    return sampling && limits && bound_is_valid(options) && world_is_valid(&options->world) && workers_are_valid(options, oracle);
}

static int is_supported(const tdsp_build_options *options, tdsp_monotone monotone)
{
    if (options->sampling == TDSP_SAMPLING_GEOMETRIC) return options->guarantee == TDSP_GUARANTEE_ARRIVAL;
    return options->guarantee != TDSP_GUARANTEE_TRAVEL || monotone == TDSP_MONOTONE_TRAVEL;
}

/* The answer for departure 0 alone must keep the guarantee, or the oracle is too coarse for it. */
static int first_is_certified(const sampler *s)
{
    const sample *first = &s->domain.first;
    return sample_fits(first, rows_cap(s->options, s->monotone, 0, first->lower));
}

/* May answers be rough? Not where rows are promised to be no more than those of geometric sampling, whose answers are exact. */
static int may_be_rough(const sampler *s)
{
    int promised = s->options->guarantee == TDSP_GUARANTEE_ARRIVAL;
    return s->probe.oracle->earliest_arrival_within && s->options->sampling == TDSP_SAMPLING_ADAPTIVE && !promised;
}

/* The oracle's part of a relative guarantee, or of an absolute one for travel times up to `travel`. */
static double oracle_delta(const sampler *s, double travel)
{
    const tdsp_build_options *options = s->options;
    if (!may_be_rough(s)) return 0;
    if (options->guarantee != TDSP_GUARANTEE_ABSOLUTE) return options->oracle_share * options->epsilon;
    return travel > 0 ? math_min(options->oracle_share * options->delta / travel, 1) : 0;
}

static tdsp_status place_rows(sampler *s)
{
    s->probe.delta = oracle_delta(s, 0);
    tdsp_status status = domain_find(&s->domain, &s->probe, s->options->horizon);
    if (status != TDSP_OK) return status;
    if (!first_is_certified(s)) return TDSP_NOT_SUPPORTED;
    s->probe.delta = oracle_delta(s, probe_travel_upper(&s->probe, &s->domain.last));
    s->probe.all = s->domain.last.departure;
    return s->options->sampling == TDSP_SAMPLING_GEOMETRIC ? sampler_geometric(s) : sampler_adaptive(s);
}

static writer_header header_of(const sampler *s)
{
    const tdsp_build_options *options = s->options;
    int absolute = options->guarantee == TDSP_GUARANTEE_ABSOLUTE;
    return (writer_header){.monotone = s->monotone,
                           .guarantee = options->guarantee,
                           .sampling = options->sampling,
                           .epsilon = absolute ? 0 : options->epsilon,
                           .delta = absolute ? options->delta : 0,
                           .error = s->probe.oracle->error,
                           .time_scale = s->probe.oracle->time_scale,
                           .first_lower = s->domain.first.lower,
                           .last_reason = s->domain.reason,
                           .world = options->world};
}

static tdsp_build_report report_of(const sampler *s, size_t length)
{
    return (tdsp_build_report){.rows = s->rows.count,
                               .bytes = length,
                               .forward_calls = s->probe.forward_calls,
                               .reverse_calls = s->probe.reverse_calls,
                               .last_departure = s->domain.last.departure,
                               .last_reason = s->domain.reason,
                               .oracle_delta = s->probe.delta,
                               .rough_calls = s->probe.rough_calls,
                               .gaps = s->gaps};
}

static tdsp_status sample_and_write(sampler *s, void **bytes, size_t *length)
{
    tdsp_status status = place_rows(s);
    if (status == TDSP_OK) status = sampler_ask_gaps(s, &s->gaps);
    if (status != TDSP_OK) return status;
    writer_header header = header_of(s);
    return writer_finish(s->rows.writer, &header, bytes, length);
}

tdsp_status tdsp_build(const tdsp_oracle *oracle, const tdsp_build_options *options, const tdsp_allocator *allocator,
                       void **bytes, size_t *length, tdsp_build_report *report)
{
    if (!bytes || !length || !oracle_is_valid(oracle) || !options_are_valid(options, oracle)) return TDSP_INVALID_ARGUMENT;
    if (allocator && !allocator->resize) return TDSP_INVALID_ARGUMENT;
    if (!is_supported(options, oracle->monotone)) return TDSP_NOT_SUPPORTED;
    tdsp_allocator from = memory_allocator(allocator);
    int by_arrival = oracle->monotone == TDSP_MONOTONE_ARRIVAL || options->sampling == TDSP_SAMPLING_GEOMETRIC;
    sampler s = {.options = options, .monotone = oracle->monotone, .probe = probe_over(oracle, &from, by_arrival)};
    s.probe.progress = options->progress;
    s.probe.progress_ctx = options->progress_ctx;
    void *table = NULL;
    size_t size = 0;
    tdsp_status status = rows_begin(&s.rows, options, oracle->monotone, &from);
    if (status == TDSP_OK) status = sample_and_write(&s, &table, &size);
    if (status == TDSP_OK) {
        *bytes = table;
        *length = size;
        if (report) *report = report_of(&s, size);
    }
    rows_release(&s.rows);
    domain_release(&s.domain, &from);
    probe_release(&s.probe);
    return status;
}
