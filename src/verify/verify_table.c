/* SPDX-License-Identifier: MIT */
/*
 * The check of a table against its scene.
 *
 * Row i answers the departures in (b_(i-1), b_i] with T between right_(i-1) and left_i. Held against each other: the
 * departures rise, left and right never fall, right_(i-1) <= left_i; the guarantee at the departure of the interval where it
 * is tightest, which is its beginning (a fixed gap in arrival weighs most against the smallest arrival). The row's path must
 * arrive by b_i + left_i: moved earlier it then serves every departure of the interval, for discs only grow.
 *
 * A table that is monotone in arrival states A instead: b_(i-1) + right_(i-1) <= A <= b_i + left_i.
 */
#include "tdsp/verify.h"

#include <float.h>

#include "base/math.h"
#include "scene/allocator.h"
#include "scene/scene.h" /* the allocator, nothing else */
#include "verify/check.h"
#include "verify/nearby.h"

typedef struct table_check {
    const tdsp_scene *scene;
    tdsp_journey journey;
    const tdsp_table *table;
    tdsp_table_info info;
    nearby_index index;
    tdsp_leg *legs; /* of one row */
    size_t capacity;
    tdsp_table_verdict verdict;
} table_check;

/* Sums and products of the numbers at hand are off by this share of them. */
static double rounding_of(double a, double b)
{
    return 8.0 * DBL_EPSILON * (fabs(a) + fabs(b));
}

static void check_bad_row(table_check *check, uint64_t row, uint64_t *counter)
{
    (*counter)++;
    if (row < check->verdict.first_bad_row) check->verdict.first_bad_row = row;
}

static int rows_ordered(const table_check *check, const tdsp_row *before, const tdsp_row *row)
{
    if (!(row->departure > before->departure)) return 0;
    const double slack = rounding_of(row->departure, row->left);
    if (check->info.monotone == TDSP_MONOTONE_ARRIVAL) {
        const double lower = before->departure + before->right;
        return row->departure + row->left >= math_max(lower, before->departure + before->left) - slack &&
               row->departure + row->right >= lower - slack;
    }
    return row->left >= before->left && row->right >= before->right && before->right <= row->left;
}

static int row_keeps_guarantee(const table_check *check, const tdsp_row *before, const tdsp_row *row)
{
    const double epsilon = check->info.epsilon, begin = before->departure;
    const int arrival = check->info.monotone == TDSP_MONOTONE_ARRIVAL;
    const double lower = before->right, upper = arrival ? row->departure + row->left - begin : row->left;
    const double slack = rounding_of(begin, upper);
    if (check->info.guarantee == TDSP_GUARANTEE_TRAVEL) return upper <= (1.0 + epsilon) * lower + slack;
    if (check->info.guarantee == TDSP_GUARANTEE_ARRIVAL) return begin + upper <= (1.0 + epsilon) * (begin + lower) + slack;
    return upper - lower <= check->info.delta + slack;
}

/* Opening has held rows and legs to their bounds: reading them cannot fail. */
static tdsp_status row_legs(table_check *check, uint64_t row, size_t count)
{
    void *block = check->legs;
    const tdsp_status status = memory_reserve(&check->index.allocator, &block, &check->capacity, count, sizeof *check->legs);
    check->legs = block;
    if (status != TDSP_OK) return status;
    for (size_t i = 0; i < count; i++) (void)tdsp_table_row_leg(check->table, row, i, &check->legs[i]);
    return TDSP_OK;
}

static void keep_worst(tdsp_verdict *worst, const tdsp_verdict *verdict)
{
    if (worst->problems) return;
    if (verdict->problems || verdict->min_clearance < worst->min_clearance) *worst = *verdict;
}

/* The path arrives when its last leg ends; opening has refused one that is later than the row promises. */
static tdsp_status check_row_path(table_check *check, uint64_t i, const tdsp_row *row)
{
    const size_t count = (size_t)row->legs;
    const tdsp_status status = row_legs(check, i, count);
    if (status != TDSP_OK) return status;
    const double arrival = count > 0 ? check->legs[count - 1].end_time : row->departure + row->left;
    if (!check_is_described(check->scene, arrival)) return TDSP_SHRINKS;
    tdsp_verdict verdict = check_path(check->scene, &check->journey, &check->index, check->legs, count, row->departure, arrival);
    if (verdict.problems) check_bad_row(check, i, &check->verdict.bad_paths);
    keep_worst(&check->verdict.worst, &verdict);
    return TDSP_OK;
}

/* What stands before row 0, which answers departure 0 alone: its lower end. */
static tdsp_status first_interval(const table_check *check, tdsp_row *out)
{
    double lower = 0.0;
    const tdsp_status status = tdsp_table_arrival(check->table, 0.0, &lower, NULL);
    *out = (tdsp_row){0.0, lower, lower, 0};
    return status;
}

static void check_row(table_check *check, uint64_t i, const tdsp_row *before, const tdsp_row *row)
{
    const int ordered = i > 0 ? rows_ordered(check, before, row) : row->departure == 0.0 && before->right <= row->left;
    if (!ordered) check_bad_row(check, i, &check->verdict.bad_order);
    if (!row_keeps_guarantee(check, before, row)) check_bad_row(check, i, &check->verdict.bad_ratio);
}

static tdsp_status check_rows(table_check *check)
{
    tdsp_row before, row;
    tdsp_status status = first_interval(check, &before);
    for (uint64_t i = 0; status == TDSP_OK && i < check->info.rows; i++) {
        (void)tdsp_table_row(check->table, i, &row);
        check_row(check, i, &before, &row);
        status = check_row_path(check, i, &row);
        before = row;
    }
    return status;
}

/* No path of the table goes on after this: opening has held each against its row. */
static double last_arrival(const table_check *check)
{
    tdsp_row row;
    double last = 0.0;
    for (uint64_t i = 0; i < check->info.rows; i++) {
        (void)tdsp_table_row(check->table, i, &row);
        last = math_max(last, row.departure + row.left);
    }
    return nextafter(last, INFINITY);
}

tdsp_status tdsp_verify_table(const tdsp_scene *scene, const tdsp_table *table, tdsp_table_verdict *out)
{
    return tdsp_verify_table_for(scene, NULL, table, out);
}

tdsp_status tdsp_verify_table_for(const tdsp_scene *scene, const tdsp_ends *ends, const tdsp_table *table,
                                  tdsp_table_verdict *out)
{
    if (!scene || !table || !out) return TDSP_INVALID_ARGUMENT;
    table_check check = {
        .scene = scene, .journey = check_journey(scene, ends), .table = table, .verdict = {.first_bad_row = UINT64_MAX}};
    check.verdict.worst = (tdsp_verdict){.min_clearance = INFINITY, .disc = TDSP_NO_DISC};
    if (tdsp_journey_check(&check.journey)) return TDSP_INVALID_ARGUMENT;
    tdsp_status status = tdsp_table_get_info(table, &check.info);
    if (status != TDSP_OK) return status;
    status = nearby_build(scene, last_arrival(&check), &scene->allocator, &check.index);
    if (status != TDSP_OK) return status;
    check.verdict.stale = check.info.scene_hash != tdsp_scene_hash_for(scene, ends);
    status = check_rows(&check);
    memory_free(&check.index.allocator, check.legs, check.capacity * sizeof *check.legs);
    nearby_free(&check.index);
    if (status != TDSP_OK) return status;
    check.verdict.ok = !check.verdict.stale && check.verdict.first_bad_row == UINT64_MAX;
    *out = check.verdict;
    return TDSP_OK;
}
