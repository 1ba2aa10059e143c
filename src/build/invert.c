/* SPDX-License-Identifier: MIT */
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
 *   gallop   from a reverse answer at a jump, whose distance to the forward function's own jump is the oracle's error: upwards a few
 *            errors first, then growing steps; downwards, and where no error is stated, the next double first. A jump farther away
 *            than the error is another one.
 *   rough    while it steers, answers need only be near (probe_roughly()); once a jump is suspected, and after a few calls, they are exact.
 *   seal     a gallop has crossed the jump: one more reverse call certifies the value right after it (seal.h), and the bracket need not
 *            be narrowed. Where that fails, halving to neighbouring doubles settles it.
 */
#include "build/invert.h"

#include <float.h>
#include <stdint.h>
#include <string.h>

#include "base/math.h"
#include "base/round.h"
#include "build/seal.h"

#define GALLOP_GROWTH 16
#define CLIMB_GROWTH 4 /* upwards, where each step is one that forward calls may take the wrong side of */
#define FIRST_CLIMB 2  /* stated errors */
#define SLOPE 0.25     /* to be expected of values after a jump */
#define SEALS 3u       /* a row */
#define STALLED 2u
#define EARLY 2u /* reversals that need no two steps in vain */
#define ROUGH 6u /* calls of a row that need not be exact */
#define FAR_RATIO 4
#define PATIENCE 8u /* halvings towards 0 before the bits are halved instead */

typedef enum gait { STEADY, SEEDED, GALLOPING, SEALING } gait;

typedef struct hunt {
    probe *probe;
    const inversion *goal;
    trail *trail;
    bracket *bracket;
    gait gait;
    int from_low; /* galloping upwards from low, else downwards from high */
    double reach; /* the next distance of a gallop */
    double seed;
    double asked; /* the arrival whose latest departure the seed is */
    int is_known; /* `answer` is what a reverse call said of its departure, whose path the oracle still has */
    sample answer;
    seal known;   /* from sealing */
    unsigned seals;
    unsigned calls;
    unsigned stalls; /* steps in a row that brought the value no nearer to the aim */
    unsigned reversals;
    int missed;   /* a guess was over the aim by more than it hoped to gain */
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
    double asked = math_min(goal->slack, s->departure - goal->anchor);
    return math_max(asked, s->ceiling - s->value);
}

/* A rough answer over the cap may stand for a value under it. Nothing is gained by closing in on it: so far a row may end under its cap, too. */
static double doubt(const hunt *h)
{
    const sample *high = &h->bracket->high;
    int is_rough = high->value - high->lower > 2 * (high->upper - high->value);
    return is_rough && high->lower <= h->goal->cap ? high->ceiling - high->lower : 0;
}

static int is_over(const hunt *h)
{
    if (h->bracket->jumps) return 1;
    const sample *low = &h->bracket->low;
    double rest = h->goal->cap - low->ceiling;
    double most = math_max(tolerance(h->goal, low), doubt(h));
    int late_enough = low->departure > h->goal->after && rest <= most && rest < h->goal->room / 2;
    double width = h->bracket->high.departure - low->departure;
    return late_enough || width <= h->goal->width || bracket_is_closed(h->bracket);
}

/* The value in the middle of the slack; the tolerance is that of a departure beyond the anchor. */
static double aim(const hunt *h)
{
    const sample *low = &h->bracket->low;
    const sample *reference = low->departure > h->goal->anchor ? low : &h->bracket->high;
    double margin = low->ceiling - low->value;
    double window = math_max(math_min(h->goal->slack, reference->departure - h->goal->anchor), margin);
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

/* The arrival to ask a reverse call for, or NaN while the bracket is too wide to hope for the jump. */
static double arrival_inside_jump(const hunt *h)
{
    const bracket *b = h->bracket;
    double most = h->goal->cap - (b->low.ceiling - b->low.value);
    if (h->probe->by_arrival) return most;
    double below = most - b->low.value;
    double above = b->high.value - most;
    double width = b->high.departure - b->low.departure;
    if (below >= width && below >= above) return most + b->low.departure;
    double least = b->high.departure - below;
    double latest = b->low.departure + above;
    if (latest >= least) return most + least + (latest - least) / 4;
    return least - latest <= width / 2 ? most + (least + latest) / 2 : NAN;
}

static int may_reverse(const hunt *h)
{
    return h->probe->oracle->latest_departure && h->reversals < h->goal->reversals && isfinite(h->bracket->high.value);
}

static int may_seal(const hunt *h)
{
    int able = h->probe->oracle->latest_departure && h->goal->give > 0 && h->seals < SEALS;
    return able && isfinite(h->bracket->high.value);
}

/* A step beyond the stated error; 0 where none is stated. */
static double climb(const hunt *h, const sample *s)
{
    double travel = h->probe->by_arrival ? s->value - s->departure : s->value;
    const tdsp_oracle *oracle = h->probe->oracle;
    return FIRST_CLIMB * oracle->error * (travel + oracle->time_scale);
}

/* A gallop upwards starts beyond the stated error, downwards at the neighbouring double. */
static double first_reach(const hunt *h, const sample *s)
{
    return h->from_low && may_seal(h) ? climb(h, s) : 0;
}

/* The value is known to jump right after low. */
static void gallop_from_low(hunt *h)
{
    h->gait = GALLOPING;
    h->from_low = 1;
    h->reach = first_reach(h, &h->bracket->low);
}

static double gallop(const hunt *h)
{
    return h->from_low ? h->bracket->low.departure + h->reach : h->bracket->high.departure - h->reach;
}

static tdsp_status ask_reverse(hunt *h, double *t)
{
    *t = midpoint(h);
    double arrival = may_reverse(h) ? arrival_inside_jump(h) : NAN;
    if (isnan(arrival)) return TDSP_OK;
    h->missed = 0;
    tdsp_status status = probe_reverse_between(h->probe, arrival, &h->bracket->low, &h->bracket->high, &h->answer, &h->is_known);
    if (status != TDSP_OK) return status;
    h->reversals++;
    h->gait = SEEDED;
    h->asked = arrival;
    *t = h->answer.departure;
    if (*t > h->bracket->low.departure) return TDSP_OK;
    gallop_from_low(h);
    *t = gallop(h);
    return TDSP_OK;
}

static tdsp_status choose(hunt *h, double *t)
{
    double width = h->bracket->high.departure - h->bracket->low.departure;
    if (h->calls % 3 == 0) h->width = width;
    if (h->gait == SEEDED)
        *t = h->seed;
    else if (h->gait == GALLOPING)
        *t = gallop(h);
    else if (h->stalls >= STALLED || (h->missed && h->reversals < EARLY))
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
 * What the answer at a seed means. One that arrives when it was asked to lies on a continuous piece: steer on. One that arrives earlier ends
 * at a jump, its row's own if it fits. One that arrives later contradicts the reverse answer: the jump is a little earlier.
 */
static void judge_seed(hunt *h, sample *s, int fits)
{
    double arrival = h->probe->by_arrival ? s->value : s->departure + s->value;
    double early = h->asked - arrival;
    double blur = probe_blur(h->probe, s);
    int gallops = fits ? !(early <= blur) : !(early >= -blur);
    h->gait = gallops ? GALLOPING : STEADY;
    h->from_low = fits;
    h->reach = first_reach(h, s);
    if (early > blur) s->beyond = h->asked - (h->probe->by_arrival ? 0 : s->departure);
    if (early > blur && !fits) trail_restart(h->trail, &h->bracket->low);
    if (h->seals > 0 && !fits && may_seal(h)) h->gait = SEALING;
}

/* A step of a gallop: the second one downwards is as long as errors are likely to be. */
static void pace_gallop(hunt *h, const sample *s, int fits)
{
    double most = probe_blur(h->probe, s);
    int crossed = fits != h->from_low;
    if (crossed) h->reversals = h->goal->reversals; /* there is nothing more to learn from it here */
    if (crossed || h->reach > most) h->gait = crossed && may_seal(h) ? SEALING : STEADY;
    double growth = h->from_low && may_seal(h) ? CLIMB_GROWTH : GALLOP_GROWTH;
    h->reach = math_max(h->reach * growth, most / 4096);
}

/* A jump may have been come by without a gallop. */
static int is_narrow(const hunt *h)
{
    const bracket *b = h->bracket;
    return b->high.departure - b->low.departure <= climb(h, &b->low);
}

/* Is the jump right after low certified by what is known? */
static void apply_seal(hunt *h)
{
    bracket *b = h->bracket;
    if (isnan(h->known.departure)) return;
    b->jumps = seal_holds(h->probe, &h->known, &b->low, &b->high, h->goal->give, &b->after);
}

/* Try to certify the right side of the jump. The answer to a question in vain is where to look next, if it is in the bracket. */
static tdsp_status try_seal(hunt *h)
{
    const bracket *b = h->bracket;
    h->gait = STEADY;
    h->seals++;
    tdsp_status status = seal_ask(h->probe, &b->low, &b->high, SLOPE, h->goal->give, &h->known);
    if (status != TDSP_OK) return status;
    apply_seal(h);
    if (b->jumps || !(h->known.departure > b->low.departure) || !(h->known.departure < b->high.departure)) return TDSP_OK;
    h->gait = SEEDED;
    h->seed = h->known.departure;
    h->asked = h->known.arrival;
    return TDSP_OK;
}

static tdsp_status learn(hunt *h, const sample *s)
{
    int fits = sample_fits(s, h->goal->cap);
    sample *side = fits ? &h->bracket->low : &h->bracket->high;
    double target = aim(h);
    int stalled = fabs(s->value - target) >= 0.75 * fabs(side->value - target);
    h->stalls = stalled ? h->stalls + 1 : 0;
    if (h->gait == STEADY && !fits) h->missed |= s->value - target > 3 * (target - h->bracket->low.value);
    h->calls++;
    *side = *s;
    if (h->gait == SEEDED)
        judge_seed(h, side, fits);
    else if (h->gait == GALLOPING)
        pace_gallop(h, side, fits);
    if (h->gait == STEADY && may_seal(h) && is_narrow(h)) h->gait = SEALING;
    if (fits) apply_seal(h);
    trail_note(h->trail, s);
    if (fits) return probe_keep_path(h->probe, s);
    trail_push_ahead(h->trail, side);
    return TDSP_OK;
}

static tdsp_status ask(hunt *h, double departure, sample *out)
{
    if (h->is_known && h->answer.departure == departure) {
        *out = h->answer;
        return TDSP_OK;
    }
    int is_rough = h->gait == STEADY && h->calls < ROUGH && h->reversals == 0;
    return is_rough ? probe_roughly(h->probe, departure, out) : probe_forward(h->probe, departure, out);
}

static tdsp_status step(hunt *h)
{
    const bracket *b = h->bracket;
    double departure;
    sample s;
    tdsp_status status = choose(h, &departure);
    if (status == TDSP_OK) status = ask(h, clamped(b, departure), &s);
    h->is_known = 0;
    if (status == TDSP_OK) status = probe_order(h->probe, &b->low, &b->high, &s);
    return status == TDSP_OK ? learn(h, &s) : status;
}

tdsp_status invert(probe *p, const inversion *goal, trail *t, bracket *b)
{
    hunt h = {.probe = p, .goal = goal, .trail = t, .bracket = b, .seed = goal->seed, .asked = goal->asked, .known = {NAN, NAN}};
    h.is_known = goal->seed_is_known;
    h.stalls = goal->suspected ? STALLED : 0;
    h.answer = goal->answer;
    h.gait = isnan(goal->seed) ? STEADY : SEEDED;
    if (b->low.beyond > (b->low.value + goal->cap) / 2) gallop_from_low(&h);
    b->jumps = 0;
    while (!is_over(&h)) {
        tdsp_status status = h.gait == SEALING ? try_seal(&h) : step(&h);
        if (status != TDSP_OK) return status;
    }
    if (b->jumps) return TDSP_OK;
    b->jumps = bracket_is_closed(b);
    b->after = b->jumps ? b->high.lower : b->low.lower;
    return TDSP_OK;
}
