/* SPDX-License-Identifier: MIT */
/*
 * Rows and the guarantee.
 *
 * Let b be the departure of a row and L the certified lower bound right after it. For t in (b, b'] the answer is the interval
 *
 *     monotone in travel    [t + T_L, t + T(b')]     T(b') <= (1 + eps) T_L          travel
 *                                                    T(b') <= T_L + delta            absolute
 *                                                    T(b') <= T_L + eps (b + T_L)    arrival: (t + T(b')) / (t + T_L) falls with t
 *     monotone in arrival   [A_L, A(b')]             A(b') <= A_L + delta            absolute
 *                                                    A(b') <= (1 + eps) A_L          arrival
 */
#include "build/rows.h"

#include "base/math.h"

tdsp_status rows_begin(rows *r, const tdsp_build_options *options, tdsp_monotone monotone, const tdsp_allocator *allocator)
{
    *r = (rows){.options = options, .monotone = monotone, .allocator = *allocator, .path = kept_path_none()};
    return writer_create(allocator, &r->writer);
}

void rows_release(rows *r)
{
    writer_free(r->writer);
    kept_path_release(&r->path, &r->allocator);
}

double rows_cap(const tdsp_build_options *options, tdsp_monotone monotone, double departure, double lower)
{
    if (options->guarantee == TDSP_GUARANTEE_ABSOLUTE) return lower + options->delta;
    int shifted = options->guarantee == TDSP_GUARANTEE_ARRIVAL && monotone == TDSP_MONOTONE_TRAVEL;
    return lower + options->epsilon * (shifted ? departure + lower : lower);
}

static tdsp_status write_held(rows *r)
{
    writer_row out = {r->held.departure, r->held.left,  r->held.right,     r->path.legs,
                      r->path.leg_count, r->path.bytes, r->path.byte_count};
    return writer_add(r->writer, &out);
}

/* Bounds in the order of the truth between them, and near enough to each other. */
static int is_certified(const rows *r, const row *next)
{
    int by_arrival = r->monotone == TDSP_MONOTONE_ARRIVAL;
    double lower = r->held.right + (by_arrival ? r->held.departure : 0);
    double upper = next->left + (by_arrival ? next->departure : 0);
    return lower <= upper && upper <= rows_cap(r->options, r->monotone, r->held.departure, lower);
}

row rows_raised(tdsp_monotone monotone, const row *before, const row *next)
{
    double waited = monotone == TDSP_MONOTONE_ARRIVAL ? next->departure - before->departure : 0;
    row out = *next;
    out.left = math_max(out.left, before->left - waited);
    out.right = math_max(out.right, before->right - waited);
    return out;
}

tdsp_status rows_add(rows *r, const row *next, kept_path *path)
{
    if (r->count == r->options->max_rows) return TDSP_TOO_MANY_ROWS;
    row added = *next;
    if (r->count > 0) {
        if (!(next->departure > r->held.departure)) return TDSP_BAD_ORACLE;
        added = rows_raised(r->monotone, &r->held, next);
        if (!is_certified(r, &added)) return TDSP_BAD_ORACLE;
        tdsp_status status = write_held(r);
        if (status != TDSP_OK) return status;
    }
    r->held = added;
    r->count++;
    kept_path_swap(&r->path, path);
    return TDSP_OK;
}

void rows_raise_right(rows *r, double right)
{
    r->held.right = math_max(r->held.right, right);
}

tdsp_status rows_end(rows *r)
{
    return write_held(r);
}
