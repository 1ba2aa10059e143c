/* SPDX-License-Identifier: MIT */
/*
 * The sampler's view of an oracle: every call checked, counted, and turned into certified numbers.
 *
 * A sample's value is T(t) or A(t), whichever of the two the rows are placed by; both never decrease over departures (A always, T
 * where the oracle is monotone in travel). What the oracle says is within
 *
 *     noise(t) = error / (1 - error) * (T + time_scale) + 2^-50 A
 *
 * of the truth (at either end of what it says, where it leaves an interval open): the first term is the stated error with the computed T in
 * place of the true one, |T' - T| <= error (T + scale) giving T + scale <= (T' + scale) / (1 - error); the second is eight half units of rounding of A, for the oracle's own sum, for the
 * subtraction that makes T, and for the sum that a reader of the table makes. An arrival equal to its departure is exact.
 */
#ifndef BUILD_PROBE_H
#define BUILD_PROBE_H

#include "build/kept_path.h"
#include "tdsp/build.h"
#include "tdsp/oracle.h"
#include "tdsp/status.h"
#include "tdsp/types.h"

typedef struct sample {
    double departure;
    double value;       /* as the oracle said it; infinite, like the next three, when there is no way */
    double lower;       /* certified: value less the noise */
    double upper;       /* certified: value and the noise */
    double ceiling;     /* over upper by what the arithmetic of comparing bounds may lose */
    double beyond;      /* a hint: values right after seem to be over this */
    tdsp_status status; /* TDSP_OK, or why there is no way */
} sample;

typedef struct probe {
    const tdsp_oracle *oracle;
    tdsp_allocator allocator;
    int by_arrival;         /* values are A(t), not T(t) */
    tdsp_progress progress; /* asked before each call; may be NULL */
    void *progress_ctx;
    int is_cancelled; /* it said so: not asked again, and no call is made any more */
    double settled;   /* for progress */
    double all;
    double delta; /* of the travel time: what probe_roughly() leaves to the oracle; 0 for exact answers everywhere */
    uint64_t forward_calls;
    uint64_t rough_calls; /* of these: answered by less than an exact arrival */
    uint64_t reverse_calls;
    kept_path path; /* of the last sample that was kept */
} probe;

/* Nothing is allocated until a path is kept. */
probe probe_over(const tdsp_oracle *oracle, const tdsp_allocator *allocator, int by_arrival);
void probe_release(probe *p);

/* Ask for A(departure). TDSP_OK also when there is no way; TDSP_BAD_ORACLE for NaN, infinity or an arrival before the departure. */
tdsp_status probe_forward(probe *p, double departure, sample *out);

/* The same, but where the oracle can and p->delta lets it, the answer may be a path that is not the best for certain and a lower bound. */
tdsp_status probe_roughly(probe *p, double departure, sample *out);

/*
 * Bring a sample into order with those around it: TDSP_BAD_ORACLE when the value falls by more than the
 * noise. Within probe_blur() of a jump an oracle may take the wrong side; there the sample takes its neighbour's numbers. Right behind a jump it may also take
 * a way longer than that of a much later departure, whose numbers hold for every earlier one.
 */
tdsp_status probe_order(const probe *p, const sample *low, const sample *high, sample *s);

/* sup { t : A(t) <= arrival }; 0 when the arrival is too early. Only where the oracle can; only after A(0) was answered. */
tdsp_status probe_reverse(probe *p, double arrival, double *departure);

/*
 * The same for an arrival between those of two samples, which the oracle may make use of. Where it can it also hands out the answer at
 * that departure, as probe_forward() would, and the path: *known is 1 then, else only out->departure is set.
 */
tdsp_status probe_reverse_between(probe *p, double arrival, const sample *low, const sample *high, sample *out, int *known);

/* The last departure of all, as above; only out->departure, infinite, when nothing ever ends them. Only after A(0) was answered. */
tdsp_status probe_reverse_last(probe *p, sample *out, int *known);

/* Keep the path of the last answer in p->path, where the oracle has paths. */
tdsp_status probe_keep_path(probe *p, const sample *s);

/* Is this a reason why there is no way? */
int probe_means_no_way(tdsp_status status);

/* The arrival that a sample stands for. */
double probe_arrival(const probe *p, const sample *s);

/* How far a jump may seem displaced. */
double probe_blur(const probe *p, const sample *s);

/* The most that a sample's ceiling is over its value, at any departure that arrives at `arrival`. */
double probe_margin(const probe *p, double arrival);

/* Ask whether to go on: TDSP_OK or TDSP_CANCELLED. */
tdsp_status probe_report_progress(probe *p);

/* A sample's travel time at most, whatever its value is. */
double probe_travel_upper(const probe *p, const sample *s);

#endif
