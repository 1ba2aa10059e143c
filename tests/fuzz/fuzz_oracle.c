/* SPDX-License-Identifier: MIT */
/*
 * An oracle whose every answer comes from the input: what it declares, its statuses, its numbers, its paths. The conformance kit and the sampler must
 * come back with a status whatever it says, and what the sampler calls a table must be one.
 *
 * Numbers are drawn from those that break things (NaN, infinities, huge, tiny, negative) and from ordinary ones, so that both sane and mad
 * oracles come up. When the input is used up it starts anew.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tdsp/build.h"
#include "tdsp/oracle_check.h"
#include "tdsp/table.h"

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size);

enum { LEGS = 4, MOST_CALLS = 3000, MOST_ROWS = 200 };

typedef struct fuzz_input {
    const unsigned char *data;
    size_t size, at;
    uint64_t calls;
    double departure, arrival; /* of the last answer, for paths that fit */
    double offset;             /* a function that is nearly sound: departure + offset + slope * departure */
    double slope;
    tdsp_leg legs[LEGS];
    unsigned char bytes[8];
} fuzz_input;

static void fuzz_require(int holds)
{
    if (!holds) abort();
}

static unsigned fuzz_byte(fuzz_input *in)
{
    if (in->at >= in->size) in->at = 0;
    return in->data[in->at++];
}

static double fuzz_double(fuzz_input *in)
{
    static const double odd[] = {0, -0.0, 1, -1, 0x1p-1074, 1e308, -1e308, 0x1p52, 1e-300};
    const size_t count = sizeof odd / sizeof odd[0];
    unsigned kind = fuzz_byte(in);
    if (kind < count) return odd[kind];
    if (kind == 9) return NAN;
    if (kind == 10) return INFINITY;
    if (kind == 11) return -INFINITY;
    if (kind < 128) return (double)fuzz_byte(in) / 8;
    unsigned char raw[8];
    double number;
    for (int i = 0; i < 8; i++) raw[i] = (unsigned char)fuzz_byte(in);
    memcpy(&number, raw, sizeof number);
    return number;
}

/* Mostly what is asked for; now and then any status, also one that does not exist. */
static tdsp_status fuzz_status(fuzz_input *in, tdsp_status usual)
{
    unsigned kind = fuzz_byte(in);
    in->calls++;
    return kind < 240 ? usual : kind == 255 ? (tdsp_status)(int)(fuzz_byte(in) - 5) : (tdsp_status)(kind - 240);
}

static double fuzz_near(fuzz_input *in, double sound)
{
    return fuzz_byte(in) < 220 ? sound : fuzz_double(in);
}

static tdsp_status fuzz_earliest_arrival(void *ctx, double departure, double *arrival)
{
    fuzz_input *in = ctx;
    fuzz_require(departure >= 0 && isfinite(departure));
    *arrival = fuzz_near(in, departure + in->offset + in->slope * departure);
    in->departure = departure;
    in->arrival = *arrival;
    return fuzz_status(in, departure > 40 ? TDSP_CUT_OFF : TDSP_OK);
}

static tdsp_status fuzz_latest_departure(void *ctx, double arrival, double *departure)
{
    fuzz_input *in = ctx;
    fuzz_require(arrival >= 0);
    *departure = fuzz_near(in, isinf(arrival) ? 40 : fmin((arrival - in->offset) / (1 + in->slope), 40));
    return fuzz_status(in, arrival < in->offset ? TDSP_ARRIVAL_TOO_EARLY : TDSP_OK);
}

static tdsp_status fuzz_between(void *ctx, double arrival, double after, double before, double *departure, double *arrives)
{
    fuzz_input *in = ctx;
    fuzz_require(after >= 0 && after <= before);
    tdsp_status status = fuzz_latest_departure(ctx, arrival, departure);
    in->departure = *departure;
    *arrives = in->arrival = fuzz_near(in, *departure + in->offset + in->slope * *departure);
    return status;
}

static tdsp_status fuzz_within(void *ctx, double departure, double delta, double *arrival, double *lower)
{
    fuzz_input *in = ctx;
    fuzz_require(departure >= 0 && isfinite(departure) && delta >= 0 && delta <= 1);
    tdsp_status status = fuzz_earliest_arrival(ctx, departure, arrival);
    *lower = fuzz_near(in, departure + (*arrival - departure) / (1 + delta));
    return status;
}

/* Memory is always there: how much of it a path claims is the oracle's word. */
static tdsp_status fuzz_path(void *ctx, tdsp_oracle_path *out)
{
    fuzz_input *in = ctx;
    unsigned kind = fuzz_byte(in);
    out->leg_count = kind % (LEGS + 1);
    out->legs = kind == 200 ? NULL : in->legs;
    out->byte_count = kind > 230 ? sizeof in->bytes : 0;
    out->bytes = kind == 240 ? NULL : in->bytes;
    for (size_t i = 0; i < out->leg_count; i++) {
        double start = in->departure + (in->arrival - in->departure) * (double)i / (double)out->leg_count;
        double end = i + 1 == out->leg_count ? in->arrival : in->departure + (in->arrival - in->departure) * (double)(i + 1) / (double)out->leg_count;
        in->legs[i] = (tdsp_leg){.kind = fuzz_byte(in) > 250 ? fuzz_byte(in) : TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = fuzz_near(in, start),
                                 .end_time = fuzz_near(in, end), .from = {(double)i, 0}, .to = {(double)i + 1, fuzz_near(in, 0)}};
    }
    return fuzz_status(in, TDSP_OK);
}

static tdsp_status fuzz_reason(void *ctx, double departure, tdsp_status *reason)
{
    fuzz_input *in = ctx;
    (void)departure;
    *reason = fuzz_status(in, TDSP_CUT_OFF);
    return fuzz_status(in, TDSP_OK);
}

static double fuzz_clock(void *ctx)
{
    return fuzz_double(ctx);
}

static int fuzz_enough(void *ctx, double settled, double all)
{
    const fuzz_input *in = ctx;
    (void)settled;
    (void)all;
    return in->calls > MOST_CALLS;
}

static tdsp_oracle fuzz_oracle(fuzz_input *in)
{
    tdsp_oracle oracle;
    tdsp_oracle_init(&oracle);
    unsigned members = fuzz_byte(in);
    oracle.ctx = in;
    oracle.monotone = (tdsp_monotone)(fuzz_byte(in) < 250 ? members & 1u : members);
    oracle.error = fuzz_byte(in) < 200 ? 1e-9 : fuzz_double(in);
    oracle.time_scale = fuzz_byte(in) < 200 ? 1 : fuzz_double(in);
    oracle.earliest_arrival = fuzz_byte(in) < 254 ? fuzz_earliest_arrival : NULL;
    if (members & 2u) oracle.latest_departure = fuzz_latest_departure;
    if (members & 4u) oracle.path = fuzz_path;
    if (members & 8u) oracle.last_reason = fuzz_reason;
    if (members & 16u) oracle.earliest_arrival_within = fuzz_within;
    if (members & 32u) oracle.latest_departure_between = fuzz_between;
    in->offset = fuzz_near(in, 5);
    in->slope = fuzz_near(in, 0.25);
    return oracle;
}

static void fuzz_check(fuzz_input *in, const tdsp_oracle *oracle)
{
    tdsp_oracle_check_options options;
    tdsp_oracle_findings found;
    tdsp_oracle_check_options_init(&options);
    options.departures = 8;
    options.calls = 400;
    options.seed = fuzz_byte(in);
    options.horizon = fuzz_byte(in) < 128 ? INFINITY : 30;
    options.clock = fuzz_byte(in) < 128 ? NULL : fuzz_clock;
    options.clock_ctx = in;
    options.seconds = 1;
    tdsp_status status = tdsp_oracle_check(oracle, &options, NULL, &found);
    fuzz_require(status == TDSP_OK || status == TDSP_BAD_ORACLE);
    fuzz_require((found.broken != 0) == (status == TDSP_BAD_ORACLE) && (found.count > 0) == (found.broken != 0));
    fuzz_require(found.count <= TDSP_ORACLE_FINDINGS && found.calls <= options.calls && (found.broken & ~found.looked_at) == 0);
    for (size_t i = 0; i < found.count; i++) {
        fuzz_require((found.broken >> found.found[i].rule & 1u) == 1u && found.times[found.found[i].rule] > 0);
        fuzz_require(strcmp(tdsp_oracle_finding_text(&found.found[i]), "unknown") != 0);
        fuzz_require(strcmp(tdsp_oracle_rule_name(found.found[i].rule), "unknown") != 0 && strcmp(tdsp_oracle_callback_name(found.found[i].callback), "unknown") != 0);
    }
}

static void fuzz_build(fuzz_input *in, const tdsp_oracle *oracle)
{
    static const tdsp_guarantee guarantees[] = {TDSP_GUARANTEE_TRAVEL, TDSP_GUARANTEE_ARRIVAL, TDSP_GUARANTEE_ABSOLUTE};
    tdsp_build_options options;
    tdsp_table table;
    void *bytes = NULL;
    size_t length = 0;
    double lower = 0, upper = 0;
    tdsp_build_options_init(&options);
    options.guarantee = guarantees[fuzz_byte(in) % 3];
    options.sampling = fuzz_byte(in) < 200 ? TDSP_SAMPLING_ADAPTIVE : TDSP_SAMPLING_GEOMETRIC;
    options.epsilon = options.delta = 0.125;
    options.max_rows = MOST_ROWS;
    options.horizon = fuzz_byte(in) < 128 ? INFINITY : 30;
    options.progress = fuzz_enough;
    options.progress_ctx = in;
    in->calls = 0;
    if (tdsp_build(oracle, &options, NULL, &bytes, &length, NULL) != TDSP_OK) return;
    fuzz_require(tdsp_table_open(&table, bytes, length) == TDSP_OK);
    if (tdsp_table_arrival(&table, 0, &lower, &upper) == TDSP_OK) fuzz_require(lower >= 0 && lower <= upper && isfinite(upper));
    tdsp_bytes_free(NULL, bytes, length);
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    if (size == 0) return 0;
    fuzz_input in = {.data = data, .size = size};
    tdsp_oracle oracle = fuzz_oracle(&in);
    fuzz_check(&in, &oracle);
    fuzz_build(&in, &oracle);
    return 0;
}
