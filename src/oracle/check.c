/* SPDX-License-Identifier: MIT */
/*
 * tdsp_oracle_check(): what is declared, the forward function, and, where that is sound, everything that is held against it. Each part goes
 * on as far as the calls allow; what earlier parts have seen is what later parts compare with.
 */
#include "tdsp/oracle_check.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "oracle/backward.h"
#include "oracle/examiner.h"
#include "oracle/forward.h"
#include "oracle/within.h"
#include "scene/allocator.h"

#define MAX_ERROR 0.1
#define MAX_DEPARTURES 1000000u

void tdsp_oracle_check_options_init(tdsp_oracle_check_options *options)
{
    if (!options) return;
    *options = (tdsp_oracle_check_options){
        .size = sizeof *options, .horizon = INFINITY, .departures = 100, .calls = 100000, .seed = 1, .seconds = INFINITY};
}

static int options_are_valid(const tdsp_oracle_check_options *options)
{
    if (options->size != sizeof *options) return 0;
    int departures = options->departures >= 2 && options->departures <= MAX_DEPARTURES;
    return departures && options->horizon >= 0 && options->calls >= 1 && options->seconds >= 0;
}

static void declare_wrong(examiner *x, double number, double expected)
{
    examiner_note(x, &(tdsp_oracle_finding){TDSP_RULE_DECLARED, TDSP_ORACLE_MEMBERS, TDSP_OK, NAN, NAN, NAN, number, expected});
}

/* Members out of their range are brought into it, so that the answers can be looked at all the same. */
static void judge_numbers(examiner *x)
{
    tdsp_oracle *oracle = &x->oracle;
    if (!(oracle->error >= 0 && oracle->error <= MAX_ERROR)) {
        declare_wrong(x, oracle->error, MAX_ERROR);
        oracle->error = oracle->error > MAX_ERROR ? MAX_ERROR : 0;
    }
    if (!(oracle->time_scale >= 0 && oracle->time_scale <= DBL_MAX)) {
        declare_wrong(x, oracle->time_scale, 0);
        oracle->time_scale = 0;
    }
    if (oracle->monotone != TDSP_MONOTONE_TRAVEL && oracle->monotone != TDSP_MONOTONE_ARRIVAL) {
        declare_wrong(x, (double)oracle->monotone, TDSP_MONOTONE_ARRIVAL);
        oracle->monotone = TDSP_MONOTONE_ARRIVAL;
    }
}

/* 0 when there is nothing that could be asked. */
static int judge_declared(examiner *x, const tdsp_oracle *oracle)
{
    examiner_look(x, TDSP_RULE_DECLARED);
    if (oracle->size != sizeof *oracle) {
        declare_wrong(x, (double)oracle->size, (double)sizeof *oracle);
        return 0;
    }
    x->oracle = *oracle;
    judge_numbers(x);
    int alone = oracle->latest_departure_between && !oracle->latest_departure;
    if (alone || !oracle->earliest_arrival) declare_wrong(x, NAN, NAN);
    return oracle->earliest_arrival != NULL;
}

static void examine(examiner *x, const tdsp_oracle *oracle)
{
    if (!judge_declared(x, oracle)) return;
    forward_examine(x);
    if (x->unsound || x->failed) return;
    backward_examine(x);
    between_examine(x);
    within_examine(x);
    reason_examine(x);
}

tdsp_status tdsp_oracle_check(const tdsp_oracle *oracle, const tdsp_oracle_check_options *options, const tdsp_allocator *allocator,
                              tdsp_oracle_findings *out)
{
    tdsp_oracle_check_options defaults;
    tdsp_oracle_findings found;
    tdsp_oracle_check_options_init(&defaults);
    if (!options) options = &defaults;
    if (!oracle || !out || (allocator && !allocator->resize) || !options_are_valid(options)) return TDSP_INVALID_ARGUMENT;
    memset(&found, 0, sizeof found);
    found.complete = 1;
    found.last_departure = -1;
    examiner x = {.options = options, .allocator = memory_allocator(allocator), .out = &found, .chance = options->seed};
    examine(&x, oracle);
    memory_free(&x.allocator, x.seen, x.seen_capacity * sizeof *x.seen);
    if (x.failed) return TDSP_NO_MEMORY;
    *out = found;
    return found.broken ? TDSP_BAD_ORACLE : TDSP_OK;
}
