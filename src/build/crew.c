/* SPDX-License-Identifier: MIT */
/* Tasks over probes; what the tasks are is the samplers' business. Where there are workers there is at least one (tdsp_build()). */
#include "build/crew.h"

#include "scene/allocator.h"

static probe hire(const sampler *s, const tdsp_oracle *worker)
{
    probe p = probe_over(worker, &s->probe.allocator, s->probe.by_arrival);
    p.delta = s->probe.delta;
    return p;
}

tdsp_status crew_begin(crew *c, sampler *s)
{
    const tdsp_build_options *options = s->options;
    *c = (crew){s, &s->probe, 1};
    if (!options->run_tasks || !options->workers) return TDSP_OK;
    c->probes = memory_array(&s->probe.allocator, options->worker_count, sizeof *c->probes);
    if (!c->probes) return TDSP_NO_MEMORY;
    c->count = options->worker_count;
    for (size_t i = 0; i < c->count; i++) c->probes[i] = hire(s, &options->workers[i]);
    c->probes[0].progress = s->probe.progress;
    c->probes[0].progress_ctx = s->probe.progress_ctx;
    return TDSP_OK;
}

int crew_is_alone(const crew *c)
{
    return c->probes == &c->sampler->probe;
}

void crew_end(crew *c)
{
    probe *own = &c->sampler->probe;
    if (crew_is_alone(c) || !c->probes) return;
    for (size_t i = 0; i < c->count; i++) {
        own->forward_calls += c->probes[i].forward_calls;
        own->rough_calls += c->probes[i].rough_calls;
        own->reverse_calls += c->probes[i].reverse_calls;
        probe_release(&c->probes[i]);
    }
    memory_free(&own->allocator, c->probes, c->count * sizeof *c->probes);
}

probe *crew_probe(const crew *c, size_t worker)
{
    return worker < c->count ? &c->probes[worker] : NULL;
}

tdsp_status crew_run(const crew *c, tdsp_task task, void *ctx, size_t count)
{
    const tdsp_build_options *options = c->sampler->options;
    if (!crew_is_alone(c)) {
        c->probes[0].settled = c->sampler->probe.settled;
        c->probes[0].all = c->sampler->probe.all;
        options->run_tasks(options->run_tasks_ctx, task, ctx, count);
        return c->probes[0].is_cancelled ? TDSP_CANCELLED : probe_report_progress(&c->sampler->probe);
    }
    for (size_t i = 0; i < count; i++) task(ctx, i, 0);
    return TDSP_OK;
}
