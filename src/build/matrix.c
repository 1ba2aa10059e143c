/* SPDX-License-Identifier: MIT */
/*
 * Building matrices: a table for each pair, over an oracle for each pair, and then all of them in one piece.
 *
 * A pair is one task. Each task fills in its own part of the list and nothing else, so tasks may run in any order and at the same time.
 */
#include "table/matrix.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/bytes.h"
#include "base/hash.h"
#include "base/sizes.h"
#include "base/text.h"
#include "scene/allocator.h"
#include "tdsp/build.h"

typedef struct built_pair {
    void *bytes;
    size_t length;
    tdsp_status status;
    tdsp_build_report report;
} built_pair;

typedef struct matrix_build {
    const tdsp_matrix_plan *plan;
    const tdsp_build_options *options;
    tdsp_allocator allocator;
    built_pair *pairs;
    size_t count;
    int is_cancelled; /* touched by worker 0 only */
} matrix_build;

static int ends_are_valid(const tdsp_matrix_end *ends, size_t count)
{
    if (!ends || count == 0 || count > MATRIX_MOST_ENDS) return 0;
    for (size_t k = 0; k < count; k++) {
        if (!isfinite(ends[k].place.x) || !isfinite(ends[k].place.y) || (ends[k].name_length > 0 && !ends[k].name)) return 0;
        if (!text_is_utf8((const unsigned char *)ends[k].name, 0, ends[k].name_length)) return 0;
    }
    return 1;
}

static tdsp_status pair_build(matrix_build *self, size_t k, size_t worker)
{
    const tdsp_matrix_plan *plan = self->plan;
    const size_t i = k / plan->destination_count, j = k % plan->destination_count;
    tdsp_build_options options = *self->options;
    tdsp_oracle oracle;
    options.world.source = plan->sources[i].place;
    options.world.destination = plan->destinations[j].place;
    options.run_tasks = NULL;
    options.worker_count = 0;
    options.progress = NULL;
    tdsp_status status = plan->oracle_for(plan->ctx, i, j, worker, &oracle, &options.world.scene_hash);
    if (status != TDSP_OK) return status;
    built_pair *pair = &self->pairs[k];
    return tdsp_build(&oracle, &options, &self->allocator, &pair->bytes, &pair->length, &pair->report);
}

/* After a cancellation, worker 0 takes all tasks that are left and does nothing. */
static void pair_task(void *ctx, size_t k, size_t worker)
{
    matrix_build *self = ctx;
    const tdsp_build_options *options = self->options;
    if (worker == 0 && options->progress && !self->is_cancelled)
        self->is_cancelled = options->progress(options->progress_ctx, (double)k, (double)self->count) != 0;
    self->pairs[k].status = worker == 0 && self->is_cancelled ? TDSP_CANCELLED : pair_build(self, k, worker);
}

static void build_pairs(matrix_build *self)
{
    if (self->options->run_tasks) {
        self->options->run_tasks(self->options->run_tasks_ctx, pair_task, self, self->count);
        return;
    }
    for (size_t k = 0; k < self->count; k++) pair_task(self, k, 0);
}

/* The first pair that failed, or TDSP_OK. */
static tdsp_status build_report(const matrix_build *self, tdsp_matrix_report *report)
{
    memset(report, 0, sizeof *report);
    for (size_t k = 0; k < self->count; k++) {
        const built_pair *pair = &self->pairs[k];
        if (!tdsp_status_is_answer(pair->status)) {
            report->source = k / self->plan->destination_count;
            report->destination = k % self->plan->destination_count;
            return pair->status;
        }
        report->tables += pair->status == TDSP_OK;
        report->rows += pair->report.rows;
        report->forward_calls += pair->report.forward_calls;
        report->reverse_calls += pair->report.reverse_calls;
    }
    report->source = self->plan->source_count;
    report->destination = self->plan->destination_count;
    return TDSP_OK;
}

/* Where everything goes. */
typedef struct matrix_layout {
    uint64_t points, name_ends, names, pairs, tables, length;
    uint64_t name_bytes;
} matrix_layout;

static const tdsp_matrix_end *plan_end(const tdsp_matrix_plan *plan, size_t k)
{
    return k < plan->source_count ? &plan->sources[k] : &plan->destinations[k - plan->source_count];
}

/* Add a section; 0 on overflow. */
static int layout_add(uint64_t *cursor, uint64_t items, uint64_t size, uint64_t *offset)
{
    uint64_t bytes, end;
    *offset = *cursor;
    return sizes_multiply(items, size, &bytes) && sizes_add(*cursor, bytes, &end) && sizes_align8(end, cursor);
}

static int layout_make(const matrix_build *self, matrix_layout *out)
{
    const size_t ends = self->plan->source_count + self->plan->destination_count;
    uint64_t cursor = MATRIX_HEADER_LENGTH, table;
    out->name_bytes = 0;
    for (size_t k = 0; k < ends; k++)
        if (!sizes_add(out->name_bytes, plan_end(self->plan, k)->name_length, &out->name_bytes)) return 0;
    if (!layout_add(&cursor, ends, MATRIX_POINT_SIZE, &out->points) || !layout_add(&cursor, ends, 8, &out->name_ends)) return 0;
    if (!layout_add(&cursor, out->name_bytes, 1, &out->names) || !layout_add(&cursor, self->count, MATRIX_PAIR_SIZE, &out->pairs)) return 0;
    out->tables = cursor;
    for (size_t k = 0; k < self->count; k++)
        if (!layout_add(&cursor, self->pairs[k].length, 1, &table)) return 0;
    out->length = cursor;
    return cursor <= SIZE_MAX;
}

static void write_ends(const tdsp_matrix_plan *plan, const matrix_layout *at, unsigned char *bytes)
{
    uint64_t named = 0;
    for (size_t k = 0; k < plan->source_count + plan->destination_count; k++) {
        const tdsp_matrix_end *end = plan_end(plan, k);
        bytes_put_f64(bytes + at->points + MATRIX_POINT_SIZE * k, end->place.x);
        bytes_put_f64(bytes + at->points + MATRIX_POINT_SIZE * k + 8, end->place.y);
        if (end->name_length) memcpy(bytes + at->names + named, end->name, end->name_length);
        named += end->name_length;
        bytes_put_u64(bytes + at->name_ends + 8 * k, named);
    }
}

static void write_pairs(const matrix_build *self, const matrix_layout *at, unsigned char *bytes)
{
    uint64_t cursor = at->tables;
    for (size_t k = 0; k < self->count; k++) {
        const built_pair *pair = &self->pairs[k];
        unsigned char *place = bytes + at->pairs + MATRIX_PAIR_SIZE * k;
        bytes_put_u32(place + MATRIX_PAIR_AT_STATUS, (uint32_t)pair->status);
        if (pair->status != TDSP_OK) continue;
        bytes_put_u64(place + MATRIX_PAIR_AT_OFFSET, cursor);
        bytes_put_u64(place + MATRIX_PAIR_AT_LENGTH, pair->length);
        memcpy(bytes + cursor, pair->bytes, pair->length);
        sizes_align8(cursor + pair->length, &cursor);
    }
}

static void write_header(const matrix_build *self, const matrix_layout *at, unsigned char *bytes)
{
    memcpy(bytes, MATRIX_MAGIC, MATRIX_MAGIC_LENGTH); /* NOLINT(bugprone-not-null-terminated-result): eight bytes, no text */
    bytes_put_u16(bytes + MATRIX_AT_MAJOR, MATRIX_MAJOR);
    bytes_put_u16(bytes + MATRIX_AT_MINOR, MATRIX_MINOR);
    bytes_put_u32(bytes + MATRIX_AT_HEADER_LENGTH, MATRIX_HEADER_LENGTH);
    bytes_put_u64(bytes + MATRIX_AT_LENGTH, at->length);
    bytes_put_u64(bytes + MATRIX_AT_SOURCES, self->plan->source_count);
    bytes_put_u64(bytes + MATRIX_AT_DESTINATIONS, self->plan->destination_count);
    bytes_put_u64(bytes + MATRIX_AT_POINTS, at->points);
    bytes_put_u64(bytes + MATRIX_AT_NAME_ENDS, at->name_ends);
    bytes_put_u64(bytes + MATRIX_AT_NAMES, at->names);
    bytes_put_u64(bytes + MATRIX_AT_PAIRS, at->pairs);
    bytes_put_u64(bytes + MATRIX_AT_TABLES, at->tables);
    bytes_put_u32(bytes + MATRIX_AT_BODY_CRC, hash_crc32c(0, bytes, MATRIX_HEADER_LENGTH, (size_t)at->length));
    uint32_t crc = hash_crc32c(0, bytes, 0, MATRIX_AT_HEADER_CRC);
    crc = hash_crc32c(crc, bytes, MATRIX_AFTER_HEADER_CRC, MATRIX_HEADER_LENGTH);
    bytes_put_u32(bytes + MATRIX_AT_HEADER_CRC, crc);
}

static tdsp_status write_matrix(const matrix_build *self, void **bytes, size_t *length)
{
    matrix_layout at;
    if (!layout_make(self, &at)) return TDSP_NO_MEMORY;
    unsigned char *out = memory_array(&self->allocator, (size_t)at.length, 1);
    if (!out) return TDSP_NO_MEMORY;
    memset(out, 0, (size_t)at.length);
    write_ends(self->plan, &at, out);
    write_pairs(self, &at, out);
    write_header(self, &at, out);
    *bytes = out;
    *length = (size_t)at.length;
    return TDSP_OK;
}

static void build_free(matrix_build *self)
{
    for (size_t k = 0; k < self->count; k++)
        if (self->pairs[k].bytes) tdsp_bytes_free(&self->allocator, self->pairs[k].bytes, self->pairs[k].length);
    memory_free(&self->allocator, self->pairs, self->count * sizeof *self->pairs);
}

tdsp_status tdsp_matrix_build(const tdsp_matrix_plan *plan, const tdsp_build_options *options, const tdsp_allocator *allocator, void **bytes,
                              size_t *length, tdsp_matrix_report *report)
{
    if (!plan || !plan->oracle_for || !options || options->size != sizeof *options || options->workers || !bytes || !length) return TDSP_INVALID_ARGUMENT;
    if (!ends_are_valid(plan->sources, plan->source_count) || !ends_are_valid(plan->destinations, plan->destination_count)) return TDSP_INVALID_ARGUMENT;
    matrix_build self = {plan, options, memory_allocator(allocator), NULL, 0, 0};
    if (plan->source_count > SIZE_MAX / plan->destination_count) return TDSP_NO_MEMORY;
    self.count = plan->source_count * plan->destination_count;
    self.pairs = memory_array(&self.allocator, self.count, sizeof *self.pairs);
    if (!self.pairs) return TDSP_NO_MEMORY;
    memset(self.pairs, 0, self.count * sizeof *self.pairs);
    for (size_t k = 0; k < self.count; k++) self.pairs[k].status = TDSP_CANCELLED; /* until its task has run */
    tdsp_matrix_report done;
    build_pairs(&self);
    tdsp_status status = build_report(&self, &done);
    if (status == TDSP_OK) status = write_matrix(&self, bytes, length);
    if (status == TDSP_OK) done.bytes = *length;
    if (report) *report = done;
    build_free(&self);
    return status;
}
