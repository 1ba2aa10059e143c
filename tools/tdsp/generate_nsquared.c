/* SPDX-License-Identifier: MIT */
/*
 * Discs of one rate for which A(t) has at least N^2 pieces: N gaps, and a chain of N discs that joins the path anew for each of them. The
 * derivation is in docs/math/pieces.md, with the same names.
 *
 * A large disc, the floor, carries it all; heights are over its top, and the x axis is the direction of the path. Between the
 * floor and N + 1 wall discs in a row that rises to the right runs a tunnel from left to right; behind it stands the chain, half sunk into the floor. Gap m
 * is the way between wall discs m - 1 and m: over the one, clockwise, under the other, counter-clockwise, and on over the chain, clockwise. A disc
 * m sinks towards the floor at the rate at which it grows, and the chain rises as fast: so the tangent from one to the other sweeps over
 * the whole chain, disc by disc, before disc m meets the floor and closes the tunnel on everything to its left. Then the path takes the next gap, whose
 * disc is higher, and the chain begins anew.
 *
 * A tower on the last wall disc keeps the robot from going over the wall instead; a last disc covers the destination when all gaps are closed.
 */
#include <math.h>

#include "generate.h"

#define SPEED 1.0
#define RATE 1e-5
#define SPREAD 1.0  /* of the heights at which disc m meets the chain's edges */
#define MARGIN 0.25 /* from those to the floor below, and to the disc before above */
#define RADIUS 1.0  /* of wall discs at time 0 */
#define STEP (1.25 * (SPREAD + 2 * MARGIN)) /* from one wall disc's height to the next; a quarter is for the floor's curve */
#define SLOT 10.0   /* what is left of a gap between wall discs at the end */

typedef struct Plan {
    guint gaps;
    double grown;  /* by how much all radii have grown when the last gap closes, at most */
    double drop;   /* of the floor, from its top to where source and destination are */
    double apart;  /* wall discs, along x */
    double half;   /* of the wall's length; its middle is the floor's top, x = 0 */
    double away;   /* source and destination are at x = -away and away */
    double floor;  /* radius */
    double begin;  /* x of the chain's first disc */
    double pitch;  /* from one disc of the chain to the next */
    double bend;   /* by how much each edge of the chain is steeper than the one before */
    double low, high; /* heights of the chain's edges over the wall, with the margin */
} Plan;

/* The height of the chain's edge from disc j to j + 1, or of the line through it, at x. The first disc's top has height 0. */
static double edge(const Plan *plan, guint j, double x)
{
    double first = plan->bend * 0.5 * (plan->gaps - 2.0);
    double top = plan->pitch * (first * j - plan->bend * 0.5 * j * (j - 1.0));
    return top + (first - plan->bend * j) * (x - plan->begin - j * plan->pitch);
}

static void plan_edges(Plan *plan)
{
    plan->low = plan->high = edge(plan, 0, plan->half);
    for (guint j = 0; j + 1 < plan->gaps; j++) {
        double left = edge(plan, j, -plan->half), right = edge(plan, j, plan->half);
        plan->low = fmin(plan->low, fmin(left, right) - MARGIN);
        plan->high = fmax(plan->high, fmax(left, right) + MARGIN);
    }
}

static Plan plan_for(guint gaps)
{
    Plan plan = {.gaps = gaps};
    plan.grown = 0.5 * gaps * STEP + RADIUS;
    plan.drop = plan.grown + 4;
    plan.apart = 2 * (RADIUS + plan.grown) + SLOT;
    plan.half = 0.5 * gaps * plan.apart;
    plan.away = fmax(plan.half * sqrt(4 * plan.drop / (SPREAD + 2 * MARGIN)), plan.half + 200);
    plan.floor = plan.away * plan.away / (2 * plan.drop);
    plan.begin = plan.half + 0.4 * (plan.away - plan.half);
    plan.pitch = 0.4 * (plan.away - plan.half) / gaps;
    double reach = plan.begin + (gaps - 1) * plan.pitch + plan.half;
    plan.bend = SPREAD / ((gaps - 1) * reach);
    plan_edges(&plan);
    return plan;
}

static void add(Generated *out, double x, double y, double radius)
{
    tdsp_disc disc = {{x, y}, radius, RATE};
    g_array_append_val(out->discs, disc);
}

/* The lowest point of wall disc m. The rise steepens a little, so that the way over one disc passes clear of those before it. */
static double wall_height(const Plan *plan, guint m)
{
    return plan->high + STEP * (m - 1.0 + 0.02 * m * m / plan->gaps);
}

static void add_chain(const Plan *plan, Generated *out)
{
    for (guint j = 0; j < plan->gaps; j++) {
        double x = plan->begin + j * plan->pitch;
        guint of = MIN(j, plan->gaps - 2);
        add(out, x, edge(plan, of, x) - plan->drop, plan->drop);
    }
}

/* Each disc twice as large as the one below, up to where the way over them is far longer than any other. */
static void add_tower(const Plan *plan, Generated *out)
{
    double foot = wall_height(plan, plan->gaps), y = foot + 1.5 * RADIUS;
    for (double radius = 2; y < foot + plan->away / 4; radius *= 2) {
        add(out, plan->half, y + 0.9 * radius, radius);
        y += 1.8 * radius;
    }
}

/* By how much wall disc m and the floor have grown together when they meet. */
static double meeting(const Plan *plan, guint m)
{
    double x = m * plan->apart - plan->half, y = wall_height(plan, m) + RADIUS - (plan->low - plan->floor);
    return hypot(x, y) - plan->floor - RADIUS;
}

/* The last disc reaches the destination when the last gap is closed, and time enough for the last journey has passed. */
static void add_end(const Plan *plan, Generated *out)
{
    double time = meeting(plan, plan->gaps) / (2 * RATE) + 3 * plan->away / SPEED;
    tdsp_point destination = out->journey.destination;
    add(out, destination.x + RATE * time + RADIUS, destination.y, RADIUS);
}

void generate_nsquared(const GenerateOptions *options, Generated *out)
{
    Plan plan = plan_for(options->n);
    double end = edge(&plan, plan.gaps - 2, plan.away) - 0.5;
    out->journey = (tdsp_journey){SPEED, 0, {-plan.away, plan.high}, {plan.away, end}};
    for (guint m = 0; m <= plan.gaps; m++) add(out, m * plan.apart - plan.half, wall_height(&plan, m) + RADIUS, RADIUS);
    add_chain(&plan, out);
    add(out, 0, plan.low - plan.floor, plan.floor);
    add_tower(&plan, out);
    add_end(&plan, out);
}
