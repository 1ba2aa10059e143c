/* SPDX-License-Identifier: MIT */
/* Calls counted and timed, findings kept, and the arithmetic of comparisons; see examiner.h. */
#include "oracle/examiner.h"

#include <math.h>
#include <string.h>

#define ROUNDING 0x1p-49
#define BLUR 10.0

int examiner_may_call(examiner *x)
{
    if (x->out->calls >= x->options->calls) {
        x->out->complete = 0;
        return 0;
    }
    x->out->calls++;
    return 1;
}

double examiner_begin(const examiner *x)
{
    return x->options->clock ? x->options->clock(x->options->clock_ctx) : 0;
}

void examiner_end(examiner *x, tdsp_oracle_callback callback, double asked, double began)
{
    if (!x->options->clock) return;
    double took = x->options->clock(x->options->clock_ctx) - began;
    double limit = x->options->seconds;
    examiner_look(x, TDSP_RULE_SLOW);
    if (took > x->out->slowest) x->out->slowest = took;
    if (took > limit) examiner_note(x, &(tdsp_oracle_finding){TDSP_RULE_SLOW, callback, TDSP_OK, asked, NAN, NAN, took, limit});
}

void examiner_look(examiner *x, tdsp_oracle_rule rule)
{
    x->out->looked_at |= UINT64_C(1) << rule;
}

/* What every other rule rests on. */
static int is_fundamental(const tdsp_oracle_finding *finding)
{
    return finding->callback == TDSP_ORACLE_EARLIEST_ARRIVAL && finding->rule <= TDSP_RULE_NO_WAY;
}

void examiner_note(examiner *x, const tdsp_oracle_finding *finding)
{
    tdsp_oracle_findings *out = x->out;
    examiner_look(x, finding->rule);
    out->broken |= UINT64_C(1) << finding->rule;
    if (is_fundamental(finding)) x->unsound = 1;
    /* There is room for all: TDSP_ORACLE_RULES * TDSP_ORACLE_EXAMPLES is less than TDSP_ORACLE_FINDINGS. */
    if (out->times[finding->rule]++ < TDSP_ORACLE_EXAMPLES) out->found[out->count++] = *finding;
}

/* An error by name may come of any callback; everything else is nothing that a status can be there. */
static int is_error(tdsp_status status)
{
    return !tdsp_status_is_answer(status) && strcmp(tdsp_status_name(status), "unknown") != 0;
}

int examiner_allows(examiner *x, tdsp_oracle_callback callback, double asked, tdsp_status status, unsigned allowed)
{
    examiner_look(x, TDSP_RULE_ERROR);
    examiner_look(x, TDSP_RULE_STATUS);
    if (tdsp_status_is_answer(status) && (allowed >> (unsigned)status & 1u) != 0) return 1;
    tdsp_oracle_rule rule = is_error(status) ? TDSP_RULE_ERROR : TDSP_RULE_STATUS;
    examiner_note(x, &(tdsp_oracle_finding){rule, callback, status, asked, NAN, NAN, NAN, NAN});
    return 0;
}

static double noise_of(const examiner *x, double travel, double arrival)
{
    double error = x->oracle.error;
    return error / (1 - error) * (travel + x->oracle.time_scale) + ROUNDING * arrival;
}

double examiner_noise(const examiner *x, double departure, double arrival)
{
    return arrival > departure ? noise_of(x, arrival - departure, arrival) : 0;
}

double examiner_blur(const examiner *x, double arrival)
{
    return BLUR * noise_of(x, arrival, arrival);
}

int examiner_same(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0; /* NOLINT(bugprone-suspicious-memory-comparison,cert-exp42-c,cert-flp37-c): the same bits are meant */
}

/* SplitMix64. */
static uint64_t next_chance(examiner *x)
{
    uint64_t z = (x->chance += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return z ^ z >> 31;
}

double examiner_unit(examiner *x)
{
    return (double)(next_chance(x) >> 11) * 0x1p-53;
}

size_t examiner_below(examiner *x, size_t count)
{
    return (size_t)(next_chance(x) % count);
}
