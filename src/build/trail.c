/* SPDX-License-Identifier: MIT */
/*
 * Guessing where a curve reaches a value, by Neville's scheme for the inverse function: departure as a polynomial of the value.
 *
 * The nodes are neighbours on a curve that rows cut into equal ratios, so the cubic through the last four boundaries is off by
 * O(epsilon^3) of a row on a smooth piece, and the first guess is usually the last. Where the curve has a kink the cubic is not to be
 * trusted; its step may differ from the secant's by a factor of two at most, else the secant is used.
 */
#include "build/trail.h"

#include <math.h>
#include <string.h>

trail trail_begin(const sample *first, const sample *last)
{
    trail t;
    memset(&t, 0, sizeof t);
    t.node[0] = *first;
    t.nodes = 1;
    t.ahead[0] = *last;
    t.ahead_count = 1;
    return t;
}

void trail_note(trail *t, const sample *s)
{
    if (!isfinite(s->value)) return;
    size_t kept = t->nodes < TRAIL_NODES ? t->nodes : TRAIL_NODES - 1;
    memmove(t->node + 1, t->node, kept * sizeof *t->node);
    t->node[0] = *s;
    t->nodes = kept + 1;
    if (t->nodes < 2) return;
    double rise = t->node[0].value - t->node[1].value;
    double run = t->node[0].departure - t->node[1].departure;
    if (rise != 0 && run / rise > 0) t->pace = run / rise;
}

void trail_restart(trail *t, const sample *after)
{
    t->node[0] = *after;
    t->nodes = isfinite(after->value) ? 1 : 0;
}

void trail_push_ahead(trail *t, const sample *s)
{
    if (t->ahead_count == TRAIL_AHEAD) {
        t->ahead_count--;
        memmove(t->ahead + 1, t->ahead + 2, (t->ahead_count - 1) * sizeof *t->ahead);
    }
    t->ahead[t->ahead_count++] = *s;
}

/* Two points from which a slope can be told: apart by more than their noise, and rising. */
static int tells_slope(const sample *a, const sample *b)
{
    double rise = a->value - b->value;
    double noise = (a->upper - a->value) + (b->upper - b->value);
    return fabs(rise) > 4 * noise && (a->departure - b->departure) / rise > 0;
}

static size_t usable_nodes(const trail *t)
{
    for (size_t n = 1; n < t->nodes; n++)
        for (size_t i = 0; i < n; i++)
            if (!tells_slope(&t->node[i], &t->node[n])) return n;
    return t->nodes;
}

static double neville(const sample *node, size_t n, double value)
{
    double p[TRAIL_NODES] = {0.0};
    for (size_t i = 0; i < n; i++)
        p[i] = node[i].departure;
    for (size_t span = 1; span < n; span++)
        for (size_t i = 0; i + span < n; i++) {
            double a = node[i].value;
            double b = node[i + span].value;
            p[i] = p[i] + (p[i + 1] - p[i]) * ((value - a) / (b - a));
        }
    return p[0];
}

double trail_predict(const trail *t, double value)
{
    size_t n = usable_nodes(t);
    if (n == 0 || (n == 1 && t->pace == 0)) return NAN;
    double from = t->node[0].departure;
    if (n == 1) return from + t->pace * (value - t->node[0].value);
    double secant = neville(t->node, 2, value);
    double curve = neville(t->node, n, value);
    double ratio = (curve - from) / (secant - from);
    return ratio > 0.5 && ratio < 2 ? curve : secant;
}
