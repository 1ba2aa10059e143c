/*
 * Inverting a value that may jump, be flat, and wobble by the oracle's noise.
 *
 * Invariant: low fits under the cap and high does not; every step evaluates a departure strictly between them and replaces one. So any
 * rule of choosing steps is safe, and the rules below only save calls:
 *
 *   steer    inverse interpolation through the curve's last points, aimed at the middle of the slack. One step on smooth pieces.
 *   halve    every third step, when the bracket has not halved since; and where steering has failed twice.
 *   reverse  the curve seems to jump: two steps in a row left the distance to the aim as it was. Then sup { t : A(t) <= a } lands on the
 *            jump for any a inside it. With values T and the cap at travel time c, a = low + c never leaves { T <= c }, and hits
 *            the jump at J when T(J) <= c - (J - low); a = high + c hits it when T(J+) > c + (high - J). The one with more room is
 *            asked, once the bracket is narrower than that room. With values A, a = c is the answer itself.
 *   gallop   from a reverse answer, whose distance to the forward function's own jump is the oracle's error: next double
 *            first, then steps that grow by 16, then halving between the last two. A jump farther away than the error is another one.
 */
#include "build/invert.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/round.h"

#define GALLOP_GROWTH 16
#define STALLED 2u
#define FAR_RATIO 4
#define NEAR 64     /* blurs */
#define PATIENCE 8u /* halvings towards 0 before the bits are halved instead */

typedef enum gait { STEADY, SEEDED, GALLOPING } gait;

typedef struct hunt {
    probe *probe;
    const inversion *goal;
    trail *trail;
    bracket *bracket;
    gait gait;
    int from_low; /* galloping upwards from low, else downwards from high */
    double reach; /* the next distance of a gallop */
    double seed;
    unsigned calls;
    unsigned stalls; /* steps in a row that brought the value no nearer to the aim */
    unsigned reversals;
    double width; /* of the bracket three calls ago */
} hunt;

int sample_fits(const sample *s, double cap)
{
    return s->ceiling <= cap;
}

int bracket_is_closed(const bracket *b)
{
    return round_next_up(b->low.departure) >= b->high.departure;
}

/* How far under the cap a row may end at s. Nothing under the sample's own margin can be told from noise. */
static double tolerance(const inversion *goal, const sample *s)
{
    double asked = fmin(goal->slack, s->departure - goal->anchor);
    return fmax(asked, s->ceiling - s->value);
}

static int is_over(const hunt *h)
{
    const sample *low = &h->bracket->low;
    double rest = h->goal->cap - low->ceiling;
    int late_enough = low->departure > h->goal->after && rest <= tolerance(h->goal, low) && rest < h->goal->room / 2;
    double width = h->bracket->high.departure - low->departure;
    return late_enough || width <= h->goal->width || bracket_is_closed(h->bracket);
}

/* The value in the middle of the slack; the tolerance is that of a departure beyond the anchor. */
static double aim(const hunt *h)
{
    const sample *low = &h->bracket->low;
    const sample *reference = low->departure > h->goal->anchor ? low : &h->bracket->high;
    double margin = low->ceiling - low->value;
    double window = fmax(fmin(h->goal->slack, reference->departure - h->goal->anchor), margin);
    return h->goal->cap - window / 2 - margin;
}

static double between_bits(double low, double high)
{
    uint64_t a, b;
    memcpy(&a, &low, sizeof a);
    memcpy(&b, &high, sizeof b);
    a += (b - a) / 2;
    memcpy(&low, &a, sizeof low);
    return low;
}

/* Halve the distance, or over far ranges the number of doubles between: departures are not negative. */
static double midpoint(const hunt *h)
{
    double low = h->bracket->low.departure;
    double high = h->bracket->high.departure;
    int far = low > 0 ? high / FAR_RATIO > low : h->calls > PATIENCE;
    return far ? between_bits(low, high) : low + (high - low) / 2;
}

static double steer(const hunt *h)
{
    const sample *low = &h->bracket->low;
    const sample *high = &h->bracket->high;
    double target = aim(h);
    double t = trail_predict(h->trail, target);
    if (t > low->departure && t < high->departure) return t;
    double share = (target - low->value) / (high->value - low->value);
    int usable = isnan(t) && share > 0 && share < 1;
    return usable ? low->departure + share * (high->departure - low->departure) : midpoint(h);
}

/* The arrival to ask a reverse call for, or NaN while the bracket is too wide to be sure of the jump. */
static double arrival_inside_jump(const hunt *h)
{
    const bracket *b = h->bracket;
    double most = h->goal->cap - (b->low.ceiling - b->low.value);
    if (h->probe->by_arrival) return most;
    double below = most - b->low.value;
    double above = b->high.value - most;
    double width = b->high.departure - b->low.departure;
    if (fmax(below, above) < width) return NAN;
    return most + (below >= above ? b->low.departure : b->high.departure);
}

static int may_reverse(const hunt *h)
{
    return h->probe->oracle->latest_departure && h->reversals < h->goal->reversals && isfinite(h->bracket->high.value);
}

static tdsp_status ask_reverse(hunt *h, double *t)
{
    *t = midpoint(h);
    double arrival = may_reverse(h) ? arrival_inside_jump(h) : NAN;
    if (isnan(arrival)) return TDSP_OK;
    double found;
    tdsp_status status = probe_reverse(h->probe, arrival, &found);
    if (status != TDSP_OK) return status;
    h->reversals++;
    h->gait = SEEDED;
    *t = found;
    return TDSP_OK;
}

static double gallop(const hunt *h)
{
    return h->from_low ? h->bracket->low.departure + h->reach : h->bracket->high.departure - h->reach;
}

static tdsp_status choose(hunt *h, double *t)
{
    double width = h->bracket->high.departure - h->bracket->low.departure;
    if (h->calls % 3 == 0) h->width = width;
    if (h->gait == SEEDED)
        *t = h->seed;
    else if (h->gait == GALLOPING)
        *t = gallop(h);
    else if (h->stalls >= STALLED)
        return ask_reverse(h, t);
    else if (h->calls % 3 == 2 && width > h->width / 2)
        *t = midpoint(h);
    else
        *t = steer(h);
    return TDSP_OK;
}

static double clamped(const bracket *b, double t)
{
    double least = round_next_up(b->low.departure);
    double most = round_next_down(b->high.departure);
    return t > least ? (t < most ? t : most) : least;
}

/*
 * After a seed or a step of a gallop. A seed whose value is nearly right lies on a continuous piece: steer on. The first step is to the neighbouring double, the second as long as errors are likely to be.
 */
static void pace_gallop(hunt *h, const sample *s, int fits)
{
    if (h->gait == SEEDED) {
        int near = fabs(s->value - aim(h)) <= NEAR * probe_blur(h->probe, s);
        h->gait = near ? STEADY : GALLOPING;
        h->from_low = fits;
        h->reach = 0;
    } else if (h->gait == GALLOPING) {
        double most = probe_blur(h->probe, s);
        int crossed = fits != h->from_low;
        if (crossed) h->reversals = h->goal->reversals; /* there is nothing more to learn from it here */
        if (crossed || h->reach > most) h->gait = STEADY;
        h->reach = fmax(h->reach * GALLOP_GROWTH, most / 4096);
    }
}

static tdsp_status learn(hunt *h, const sample *s)
{
    int fits = sample_fits(s, h->goal->cap);
    sample *side = fits ? &h->bracket->low : &h->bracket->high;
    double target = aim(h);
    int stalled = fabs(s->value - target) >= 0.75 * fabs(side->value - target);
    h->stalls = stalled ? h->stalls + 1 : 0;
    h->calls++;
    pace_gallop(h, s, fits);
    *side = *s;
    trail_note(h->trail, s);
    if (fits) return probe_keep_path(h->probe, s);
    trail_push_ahead(h->trail, s);
    return TDSP_OK;
}

tdsp_status invert(probe *p, const inversion *goal, trail *t, bracket *b)
{
    hunt h = {.probe = p, .goal = goal, .trail = t, .bracket = b, .seed = goal->seed};
    h.gait = isnan(goal->seed) ? STEADY : SEEDED;
    while (!is_over(&h)) {
        double departure;
        tdsp_status status = choose(&h, &departure);
        if (status != TDSP_OK) return status;
        sample s;
        status = probe_between(p, &b->low, &b->high, clamped(b, departure), &s);
        if (status == TDSP_OK) status = learn(&h, &s);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}
