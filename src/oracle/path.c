/* SPDX-License-Identifier: MIT */
/*
 * A path is judged by what tdsp/types.h says of legs: no leg's motion is looked into, for only the oracle knows what its places mean. Places join up to
 * rounding: 1e-9 of the extent of the path, and 1e-13 of its largest coordinate.
 */
#include "oracle/path.h"

#include "base/hash.h"
#include "base/math.h"
#include "base/round.h"
#include "table/check.h"

#define JOIN_SHARE 1e-9
#define JOIN_ROUNDING 1e-13
#define MAX_BYTES 0x7fffffffu

static int are_finite(const double *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!round_is_finite(numbers[i])) return 0;
    return 1;
}

static int leg_is_finite(const tdsp_leg *leg)
{
    const double numbers[] = {leg->start_time,  leg->end_time,  leg->from.x,     leg->from.y, leg->to.x,      leg->to.y,
                              leg->center.x,    leg->center.y,  leg->radius_from, leg->radius_to, leg->angle_from, leg->sweep,
                              leg->rate_from, leg->rate_to, leg->bend_from, leg->bend_to, leg->speed};
    return are_finite(numbers, sizeof numbers / sizeof numbers[0]);
}

static int has_no_curve(const tdsp_leg *leg)
{
    return leg->rate_from == 0 && leg->rate_to == 0 && leg->bend_from == 0 && leg->bend_to == 0 && leg->speed == 0;
}

static int has_no_ride(const tdsp_leg *leg)
{
    return leg->disc == TDSP_NO_DISC && leg->turn == 0 && leg->center.x == 0 && leg->center.y == 0 && leg->radius_from == 0 &&
           leg->radius_to == 0 && leg->angle_from == 0 && leg->sweep == 0 && has_no_curve(leg);
}

static int has_ride(const tdsp_leg *leg)
{
    return (leg->turn == 1 || leg->turn == -1) && leg->sweep >= 0 && leg->radius_from > 0 && leg->radius_to > 0;
}

static int leg_is_well_formed(const tdsp_leg *leg)
{
    if (leg->reserved != 0 || !leg_is_finite(leg) || !(leg->start_time <= leg->end_time)) return 0;
    switch (leg->kind) {
    case TDSP_LEG_LINE: return has_no_ride(leg);
    case TDSP_LEG_ARC: return has_ride(leg) && has_no_curve(leg);
    case TDSP_LEG_CURVE: return has_ride(leg) && check_curve(leg);
    default: return 0;
    }
}

static int has_memory(const tdsp_oracle_path *path)
{
    int bad_legs = path->leg_count > 0 && (!path->legs || path->leg_count > SIZE_MAX / sizeof *path->legs);
    int bad_bytes = path->byte_count > 0 && (!path->bytes || path->byte_count > MAX_BYTES);
    return !bad_legs && !bad_bytes;
}

/* 1 when the path can be read at all. */
static int judge_form(examiner *x, double departure, const tdsp_oracle_path *path)
{
    const tdsp_oracle_finding wrong = {TDSP_RULE_PATH_FORM, TDSP_ORACLE_PATH, TDSP_OK, departure, NAN, NAN, NAN, NAN};
    examiner_look(x, TDSP_RULE_PATH_FORM);
    if (!has_memory(path)) {
        examiner_note(x, &wrong);
        return 0;
    }
    for (size_t i = 0; i < path->leg_count; i++) {
        if (leg_is_well_formed(&path->legs[i])) continue;
        examiner_note(x, &(tdsp_oracle_finding){wrong.rule, wrong.callback, TDSP_OK, departure, NAN, NAN, (double)i, NAN});
        return 0;
    }
    return 1;
}

typedef struct box {
    double low, high;
} box;

static void box_add(box *b, double from, double to)
{
    b->low = math_min(b->low, math_min(from, to));
    b->high = math_max(b->high, math_max(from, to));
}

static double join_tolerance(const tdsp_oracle_path *path)
{
    box wide = {INFINITY, -INFINITY}, tall = wide;
    for (size_t i = 0; i < path->leg_count; i++) {
        box_add(&wide, path->legs[i].from.x, path->legs[i].to.x);
        box_add(&tall, path->legs[i].from.y, path->legs[i].to.y);
    }
    double largest = math_max(math_max(fabs(wide.low), fabs(wide.high)), math_max(fabs(tall.low), fabs(tall.high)));
    return JOIN_SHARE * math_hypot(wide.high - wide.low, tall.high - tall.low) + JOIN_ROUNDING * largest;
}

static void judge_joins(examiner *x, double departure, const tdsp_oracle_path *path)
{
    double tolerance = join_tolerance(path);
    examiner_look(x, TDSP_RULE_PATH_JOINS);
    for (size_t i = 1; i < path->leg_count; i++) {
        const tdsp_leg *before = &path->legs[i - 1], *leg = &path->legs[i];
        double gap = math_hypot(leg->from.x - before->to.x, leg->from.y - before->to.y);
        tdsp_oracle_finding wrong = {TDSP_RULE_PATH_JOINS, TDSP_ORACLE_PATH, TDSP_OK, departure, NAN, NAN, leg->start_time, before->end_time};
        if (leg->start_time != before->end_time) examiner_note(x, &wrong);
        wrong.seen = gap;
        wrong.expected = tolerance;
        if (!(gap <= tolerance)) examiner_note(x, &wrong);
    }
}

static void judge_ends(examiner *x, double departure, double arrival, const tdsp_oracle_path *path)
{
    double start = path->legs[0].start_time, end = path->legs[path->leg_count - 1].end_time;
    tdsp_oracle_finding wrong = {TDSP_RULE_PATH_ENDS, TDSP_ORACLE_PATH, TDSP_OK, departure, NAN, NAN, start, departure};
    examiner_look(x, TDSP_RULE_PATH_ENDS);
    if (start != departure) examiner_note(x, &wrong);
    wrong.seen = end;
    wrong.expected = arrival;
    if (!(fabs(end - arrival) <= examiner_noise(x, departure, arrival))) examiner_note(x, &wrong);
}

/* Legs have no padding: integers first, then doubles. */
static uint64_t hash_of(const tdsp_oracle_path *path)
{
    uint64_t hash = hash_fnv1a(HASH_FNV1A_SEED, &path->leg_count, sizeof path->leg_count);
    hash = hash_fnv1a(hash, path->legs, path->leg_count * sizeof *path->legs);
    return hash_fnv1a(hash, path->bytes, path->byte_count);
}

/* Call it. 1 when there is a path that can be read. */
static int ask_path(examiner *x, double departure, tdsp_oracle_path *out)
{
    if (!x->oracle.path || !examiner_may_call(x)) return 0;
    *out = (tdsp_oracle_path){NULL, 0, NULL, 0};
    double began = examiner_begin(x);
    tdsp_status status = x->oracle.path(x->oracle.ctx, out);
    examiner_end(x, TDSP_ORACLE_PATH, departure, began);
    return examiner_allows(x, TDSP_ORACLE_PATH, departure, status, ALLOW_OK) && judge_form(x, departure, out);
}

int path_examine(examiner *x, double departure, double arrival, uint64_t *hash)
{
    tdsp_oracle_path path;
    if (!ask_path(x, departure, &path)) return 0;
    if (path.leg_count > 0) {
        judge_joins(x, departure, &path);
        judge_ends(x, departure, arrival, &path);
    }
    *hash = hash_of(&path);
    return 1;
}

void path_examine_again(examiner *x, double departure, uint64_t hash)
{
    tdsp_oracle_path path;
    if (!ask_path(x, departure, &path)) return;
    examiner_look(x, TDSP_RULE_PATH_REPEATABLE);
    if (hash_of(&path) == hash) return;
    examiner_note(x, &(tdsp_oracle_finding){TDSP_RULE_PATH_REPEATABLE, TDSP_ORACLE_PATH, TDSP_OK, departure, NAN, NAN, NAN, NAN});
}
