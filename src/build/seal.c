/* SPDX-License-Identifier: MIT */
/*
 * The right side of a jump at J from two answers: the forward one at `high` = J + w, and the reverse one for an arrival a just under it.
 *
 * If latest_departure(a) = J then every t > J has A(t) > a, hence A(J+) >= a and T(J+) >= a - J, whatever A does in (J, J + w]. The
 * forward function alone could not say so: it may still report the small value a little after J, and what it reports later is
 * an upper bound of T(J+).
 *
 * Which a? With a single jump and values that rise by a slope of r or less, A(J+) >= A(high) - (1 + r) w. One noise e less makes up for the
 * error of the forward answer; the bound that is kept is yet another e lower, for the error of the reverse one:
 *
 *     a = A(high) - (1 + r) w - e      A(J+) >= a - e      T(J+) >= T(high) - r w - 2 e
 *
 * An answer inside (J, high) is a second jump or a steeper rise. The secant from it to `high` gives the slope if it is a rise, and one more
 * question; else the answer is where the forward function should be asked next.
 *
 * An answer may be earlier than `low` by the stated error, for that is how far the place of a jump may be mistaken (oracle.h); a later one
 * proves nothing of the departures up to it.
 */
#include "build/seal.h"

#include <math.h>

#define STEEPER 1.25 /* than the secant, which a curve that bends may be */

static double noise_of(const sample *s)
{
    return s->upper - s->value;
}

/* How far from a jump its stated place may be; 0 where no error is stated. */
static double reach_of(const probe *p, const sample *high)
{
    return p->oracle->error * (probe_arrival(p, high) - high->departure + p->oracle->time_scale);
}

/* The arrival to ask for, or NaN when what is given away is too much, or when `low` itself may arrive by then. */
static double question(const probe *p, const sample *low, const sample *high, double slope, double give)
{
    double width = high->departure - low->departure;
    double arrival = probe_arrival(p, high) - (1 + slope) * width - noise_of(high);
    double given = (p->by_arrival ? 1 + slope : slope) * width + 2 * noise_of(high);
    int usable = given <= give && arrival > probe_arrival(p, low) + noise_of(low);
    return usable ? arrival : NAN;
}

static int is_between(double departure, const sample *low, const sample *high)
{
    return departure > low->departure && departure < high->departure;
}

tdsp_status seal_ask(probe *p, const sample *low, const sample *high, double slope, double give, seal *out)
{
    *out = (seal){NAN, NAN};
    for (int tries = 0; tries < 2; tries++) {
        double arrival = question(p, low, high, slope, give);
        if (isnan(arrival)) return TDSP_OK;
        sample found;
        int known;
        tdsp_status status = probe_reverse_between(p, arrival, low, high, &found, &known);
        if (status != TDSP_OK) return status;
        *out = (seal){found.departure, arrival};
        if (!is_between(found.departure, low, high)) return TDSP_OK;
        slope = STEEPER * (probe_arrival(p, high) - arrival) / (high->departure - found.departure) - 1;
    }
    return TDSP_OK;
}

int seal_holds(const probe *p, const seal *known, const sample *low, const sample *high, double give, double *after)
{
    double early = low->departure - known->departure;
    if (!(early >= 0 && early <= reach_of(p, high))) return 0;
    double bound = known->arrival - noise_of(high) - (p->by_arrival ? 0 : low->departure);
    if (!(high->value - bound <= give)) return 0;
    *after = bound;
    return 1;
}
