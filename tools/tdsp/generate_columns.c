/* SPDX-License-Identifier: MIT */
/*
 * A chain of discs and two columns of gaps, n = 3 k discs of one rate, growing far slower than the robot: what comes to mind first where A(t) is to have
 * many pieces (arXiv 1808.01984). It has 2 k: the chain joins the path once, for tangents to one side never turn between discs of one rate, and each
 * gap that closes adds one more. Its sibling generate_nsquared.c has k^2 (docs/math/pieces.md).
 *
 * A chain of k discs stands on the x axis between source and destination. Two columns of k discs stand above and below the
 * first of them. While the lowest gap of a column is open the robot passes there and then along the chain, whose discs join the path
 * one after the other; each gap that closes sends it one farther out, and the chain joins all over again.
 */
#include <math.h>

#include "generate.h"

#define SPEED 1000.0
#define HALF 1000.0 /* source and destination are this far from the middle */
#define FIRST_RADIUS 20.0
#define COLUMN_RADIUS 0.01
#define STEP 10.0 /* of departures, from one disc of the chain to the next */

typedef struct Plan {
    guint k;
    double growth;
    double share; /* of the way from the last disc of the chain to the destination */
} Plan;

/* The radius for which the path over the disc before just meets this one when leaving at the chosen departure. Bisection: the
 * larger the disc, the steeper the last tangent. */
static double chain_radius(const Plan *plan, double x, double distance, double before, double time)
{
    double phi = asin(plan->growth / SPEED), low = 0, high = before;
    for (int i = 0; i < 100; i++) {
        double radius = 0.5 * (low + high);
        double slope = asin(fmin(1, (radius + plan->growth * time) * cos(phi) / (HALF - x)));
        if (radius + sin(slope + phi) * distance > before)
            high = radius;
        else
            low = radius;
    }
    return high;
}

static void add(Generated *out, double x, double y, double radius, double growth)
{
    tdsp_disc disc = {{x, y}, radius, growth};
    g_array_append_val(out->discs, disc);
}

static void add_chain(const Plan *plan, Generated *out)
{
    double x = 0, radius = FIRST_RADIUS, distance = (1 - plan->share) * HALF / (plan->k - 1);
    add(out, x, 0, radius, plan->growth);
    for (guint j = 2; j <= plan->k; j++) {
        double time = STEP * j + (HALF + x + distance) / SPEED;
        double next = x + distance;
        radius = chain_radius(plan, next, distance, radius, time);
        x = next;
        add(out, x, 0, radius, plan->growth);
    }
}

/* Gap m closes at a time at which the chain has joined anew since gap m - 1 closed; a closing time fixes the next disc's place. */
static void add_columns(const Plan *plan, Generated *out)
{
    double closing = STEP * (plan->k + 1) + HALF / SPEED, top = FIRST_RADIUS, q = plan->share / (1 - plan->share);
    for (guint m = 0; m < plan->k; m++) {
        double y = top + 2 * plan->growth * closing + COLUMN_RADIUS;
        add(out, 0, -y, COLUMN_RADIUS, plan->growth);
        add(out, 0, y, COLUMN_RADIUS, plan->growth);
        top = y + COLUMN_RADIUS;
        closing = (closing + 1.2 * q * 2 * COLUMN_RADIUS / plan->growth) / (1 - 1.2 * q * 2);
    }
}

void generate_columns(const GenerateOptions *options, Generated *out)
{
    Plan plan = {.k = options->n / 3};
    plan.growth = 1e-3 * fmin(1, 20.0 / plan.k);
    plan.share = fmin(0.05, 0.25 / plan.k);
    out->journey = (tdsp_journey){SPEED, 0, {-HALF, 0}, {HALF, 0}};
    add_chain(&plan, out);
    add_columns(&plan, out);
}
