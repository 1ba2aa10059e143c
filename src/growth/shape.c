/* SPDX-License-Identifier: MIT */
/*
 * Spans, runs, and the angle that a rider turns.
 *
 * d(angle)/dt = sqrt(1 - R'^2) / R. Where the rate is constant the integral is a logarithm; elsewhere it is kept as Chebyshev series on panels, halved until their
 * last terms are under rounding. Towards an end where R' = 1 or R = 0 the panels get smaller by halves, as deep as their share of the angle counts.
 */
#include "growth/shape.h"

#include <string.h>

#include "geom/polynomial.h"

/* A change of the rate by less is none: laws by callback join no better. Whoever rides over it is off by its square. */
#define LEAST_CORNER 1e-10

/* A rise by less ends no run: going straight over it would save its cube of a time, and touch nothing that rounding shows. */
#define LEAST_RISE 1e-7

/* A panel narrower than this share of its place in time, or of a time unit, has no angle worth halving for. */
#define LEAST_PANEL 1e-13

/* The last terms of a panel's series may be as large as this share of one radian and of the panel's angle, and of a length at its radius: just over their rounding. */
#define SERIES_ERROR 4e-16

/* R'^2 + R R'' - 1, whose sign says whether g is convex. */
static polynomial piece_convexity(const law_piece *piece)
{
    polynomial radius = law_piece_polynomial(piece);
    polynomial rate = polynomial_derivative(&radius), bend = polynomial_derivative(&rate);
    polynomial squared = polynomial_times(&rate, &rate), bent = polynomial_times(&radius, &bend);
    if (squared.degree < bent.degree) squared.degree = bent.degree;
    for (int k = 0; k <= bent.degree; ++k) squared.c[k] += bent.c[k];
    squared.c[0] -= 1.0;
    return squared;
}

static tdsp_status span_add(growth_shape *shape, const tdsp_allocator *allocator, uint32_t piece, double from, double to)
{
    if (!(from < to)) return TDSP_OK;
    tdsp_status status = memory_reserve(allocator, (void **)&shape->spans, &shape->span_capacity, shape->span_count + 1u, sizeof *shape->spans);
    if (status != TDSP_OK) return status;
    shape_span span = {from, to, piece, SHAPE_NONE, 0, 0, 0};
    const law_piece *law = &shape->pieces[piece];
    law_jet jet = law_piece_jet(law, isinf(to) ? 2.0 * from + 1.0 : 0.5 * (from + to));
    span.is_concave = jet.rate * jet.rate + jet.radius * jet.bend < 1.0;
    if (span.is_concave && jet.rate < 1.0 && jet.rate > -1.0 && jet.radius > SHAPE_LEAST_RIDE) span.run = 0;
    shape->spans[shape->span_count++] = span;
    return TDSP_OK;
}

/* The most places where a piece can be cut within one interval: roots of three polynomials. */
#define MOST_CUTS (3 * POLYNOMIAL_DEGREE)

static void cuts_insert(double *cuts, int *count, double cut)
{
    int at = (*count)++;
    for (; at > 0 && cuts[at - 1] > cut; --at) cuts[at] = cuts[at - 1];
    cuts[at] = cut;
}

/* Cut [from, to] of a piece, times since the piece's start; the last span ends at `end`, which is `to` to rounding, and where the next one begins. */
static tdsp_status piece_cut(growth_shape *shape, const tdsp_allocator *allocator, uint32_t piece, double from, double to, double end)
{
    const law_piece *law = &shape->pieces[piece];
    double at = law->start + from;
    polynomial tests[3] = {piece_convexity(law), law_piece_polynomial(law), law_piece_polynomial(law)};
    double cuts[MOST_CUTS], roots[POLYNOMIAL_DEGREE];
    int count = 0;
    tests[1] = polynomial_derivative(&tests[1]);
    tests[1].c[0] -= 1.0;
    tests[2].c[0] -= SHAPE_LEAST_RIDE;
    for (int k = 0; k < 3; ++k) {
        int found = polynomial_roots(&tests[k], from, to, roots);
        for (int i = 0; i < found; ++i) cuts_insert(cuts, &count, roots[i]);
    }
    tdsp_status status = TDSP_OK;
    for (int i = 0; i < count && status == TDSP_OK; ++i) {
        double cut = math_min(law->start + cuts[i], end);
        status = span_add(shape, allocator, piece, at, cut);
        at = cut;
    }
    return status == TDSP_OK ? span_add(shape, allocator, piece, at, end) : status;
}

/* Roots are told apart down to a share of the interval: beyond so many time units a piece is cut in parts. */
#define LONG_PART 0x1p20

/* A piece that ends where the next one begins. */
static tdsp_status inner_piece_cut(growth_shape *shape, const tdsp_allocator *allocator, uint32_t piece)
{
    double start = shape->pieces[piece].start, end = shape->pieces[piece + 1].start, length = end - start, from = 0.0;
    tdsp_status status = TDSP_OK;
    for (double to = LONG_PART; to < length && status == TDSP_OK; to *= LONG_PART) {
        status = piece_cut(shape, allocator, piece, from, to, start + to);
        from = to;
    }
    return status == TDSP_OK ? piece_cut(shape, allocator, piece, from, length, end) : status;
}

/* The last piece has no end: intervals of doubling length, up to where no coefficient but the first counts any more. */
static tdsp_status last_piece_cut(growth_shape *shape, const tdsp_allocator *allocator, uint32_t piece)
{
    const law_piece *law = &shape->pieces[piece];
    double from = 0.0, to = 1.0, most = 0.0, lead = fabs(law->c[law->degree]);
    tdsp_status status = TDSP_OK;
    if (law->degree < 2) { /* only its radius may still be too small to ride, at first */
        double begins = law->c[0] < SHAPE_LEAST_RIDE && law->c[1] > 0.0 ? (SHAPE_LEAST_RIDE - law->c[0]) / law->c[1] : 0.0;
        status = span_add(shape, allocator, piece, law->start, law->start + begins);
        return status == TDSP_OK ? span_add(shape, allocator, piece, law->start + begins, INFINITY) : status;
    }
    for (uint32_t k = 0; k < law->degree; ++k) most = math_max(most, math_exp(math_log((fabs(law->c[k]) + 1.0) / lead) / (double)(law->degree - k)));
    double end = 4.0 * (double)law->degree * math_max(most, 1.0);
    while (from < end && status == TDSP_OK) {
        status = piece_cut(shape, allocator, piece, from, to, law->start + to);
        from = to;
        to *= 2.0;
    }
    return status == TDSP_OK ? span_add(shape, allocator, piece, law->start + from, INFINITY) : status;
}

static tdsp_status shape_cut(growth_shape *shape, const tdsp_allocator *allocator)
{
    tdsp_status status = TDSP_OK;
    uint32_t last = shape->piece_count - 1;
    for (uint32_t k = 0; k < last && status == TDSP_OK; ++k) status = inner_piece_cut(shape, allocator, k);
    return status == TDSP_OK ? last_piece_cut(shape, allocator, last) : status;
}

/* A span of no duration on one side of a corner, so that the corner has a span on either side to turn from and to. */
static tdsp_status corner_insert(growth_shape *shape, const tdsp_allocator *allocator, uint32_t at, uint32_t piece, double time)
{
    tdsp_status status = memory_reserve(allocator, (void **)&shape->spans, &shape->span_capacity, shape->span_count + 1u, sizeof *shape->spans);
    if (status != TDSP_OK) return status;
    shape_span corner = {time, time, piece, 0, 1, 0, 0};
    memmove(&shape->spans[at + 1], &shape->spans[at], (shape->span_count - at) * sizeof corner);
    shape->spans[at] = corner;
    ++shape->span_count;
    return TDSP_OK;
}

/* Where the rate falls the boundary can be touched even if it can not be ridden right before, or right after. */
static tdsp_status shape_corners(growth_shape *shape, const tdsp_allocator *allocator)
{
    tdsp_status status = TDSP_OK;
    for (uint32_t k = 0; k + 1 < shape->span_count && status == TDSP_OK; ++k) {
        const shape_span left = shape->spans[k], right = shape->spans[k + 1];
        law_jet before = shape_jet(shape, k, left.to), after = shape_jet(shape, k + 1, left.to);
        if (left.piece == right.piece || !(before.rate > after.rate + LEAST_CORNER) || !(after.rate < 1.0) || !(before.radius > SHAPE_LEAST_RIDE)) continue;
        if (right.run == SHAPE_NONE) status = corner_insert(shape, allocator, k + 1, right.piece, left.to);
        if (status == TDSP_OK && left.run == SHAPE_NONE) status = corner_insert(shape, allocator, k + 1, left.piece, left.to);
        k += (right.run == SHAPE_NONE ? 1u : 0u) + (left.run == SHAPE_NONE ? 1u : 0u);
    }
    return status;
}

/* The rate does not rise from one span to the next, or only by rounding. */
static int spans_join(const growth_shape *shape, uint32_t left)
{
    double at = shape->spans[left].to;
    return shape_jet(shape, left, at).rate >= shape_jet(shape, left + 1, at).rate - LEAST_RISE;
}

static tdsp_status shape_group(growth_shape *shape, const tdsp_allocator *allocator)
{
    for (uint32_t k = 0; k < shape->span_count; ++k) {
        shape_span *span = &shape->spans[k];
        if (span->run == SHAPE_NONE) continue;
        if (k > 0 && shape->spans[k - 1].run != SHAPE_NONE && spans_join(shape, k - 1)) {
            span->run = shape->spans[k - 1].run;
            shape->runs[span->run].last = k;
            continue;
        }
        tdsp_status status = memory_reserve(allocator, (void **)&shape->runs, &shape->run_capacity, shape->run_count + 1u, sizeof *shape->runs);
        if (status != TDSP_OK) return status;
        shape_run run = {k, k, 0};
        span->run = shape->run_count;
        shape->runs[shape->run_count++] = run;
    }
    return TDSP_OK;
}

static law_piece piece_in_frame(const law_piece *piece, shape_units units)
{
    law_piece framed = {piece->start / units.time, {(piece->c[0] + units.robot_radius) / units.length}, piece->degree};
    double scale = 1.0 / units.length;
    for (uint32_t k = 1; k <= piece->degree; ++k) {
        scale *= units.time;
        framed.c[k] = piece->c[k] * scale;
    }
    while (framed.degree > 0 && framed.c[framed.degree] == 0.0) --framed.degree;
    return framed;
}

tdsp_status shape_make(growth_shape *shape, const tdsp_allocator *allocator, tdsp_point center, geom_law law, shape_units units)
{
    memset(shape, 0, sizeof *shape);
    shape->center = point_scale(1.0 / units.length, point_sub(center, units.origin));
    shape->pieces = memory_array(allocator, law.count, sizeof *shape->pieces);
    if (!shape->pieces) return TDSP_NO_MEMORY;
    shape->piece_count = law.count;
    for (uint32_t k = 0; k < law.count; ++k) shape->pieces[k] = piece_in_frame(&law.pieces[k], units);
    tdsp_status status = shape_cut(shape, allocator);
    if (status == TDSP_OK) status = shape_corners(shape, allocator);
    return status == TDSP_OK ? shape_group(shape, allocator) : status;
}

static size_t turned_bytes(const growth_shape *shape)
{
    return shape->turned ? 2 * (size_t)shape->span_count * sizeof *shape->turned : 0;
}

void shape_free(growth_shape *shape, const tdsp_allocator *allocator)
{
    memory_free(allocator, shape->pieces, shape->piece_count * sizeof *shape->pieces);
    memory_free(allocator, shape->spans, shape->span_capacity * sizeof *shape->spans);
    memory_free(allocator, shape->runs, shape->run_capacity * sizeof *shape->runs);
    memory_free(allocator, shape->panels, shape->panel_capacity * sizeof *shape->panels);
    memory_free(allocator, shape->turned, turned_bytes(shape));
}

size_t shape_bytes(const growth_shape *shape)
{
    return shape->piece_count * sizeof *shape->pieces + shape->span_capacity * sizeof *shape->spans +
           shape->run_capacity * sizeof *shape->runs + shape->panel_capacity * sizeof *shape->panels + turned_bytes(shape);
}

uint32_t shape_span_at(const growth_shape *shape, double time)
{
    uint32_t low = 0, high = shape->span_count;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (shape->spans[middle].from <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

double shape_radius(const growth_shape *shape, double time)
{
    return shape_jet(shape, shape_span_at(shape, time), time).radius;
}

static double turning(const growth_shape *shape, uint32_t span, double time)
{
    law_jet jet = shape_jet(shape, span, time);
    double squared = (1.0 - jet.rate) * (1.0 + jet.rate);
    return squared > 0.0 ? sqrt(squared) / jet.radius : 0.0;
}

/* cos(k pi / 28), k = 0 ... 28: all the cosines of a series of SHAPE_SERIES = 14 terms at its points. */
static const double shape_cosines[29] = {
    0x1p+0, 0x1.fcc7d8c64135fp-1, 0x1.f329c0558e969p-1, 0x1.e344ad05d3f86p-1, 0x1.cd4bca9cb5c71p-1, 0x1.b185d590d5a44p-1, 0x1.904c37505de4bp-1,
    0x1.6a09e667f3bcdp-1, 0x1.3f3a0e28bedd1p-1, 0x1.106682221cd8ap-1, 0x1.bc4c04d71abc1p-2, 0x1.5234aca69a9fep-2, 0x1.c7b90e3024582p-3,
    0x1.ca9b4332d6f61p-4, 0.0, -0x1.ca9b4332d6f61p-4, -0x1.c7b90e3024582p-3, -0x1.5234aca69a9fep-2, -0x1.bc4c04d71abc1p-2,
    -0x1.106682221cd8ap-1, -0x1.3f3a0e28bedd1p-1, -0x1.6a09e667f3bcdp-1, -0x1.904c37505de4bp-1, -0x1.b185d590d5a44p-1, -0x1.cd4bca9cb5c71p-1,
    -0x1.e344ad05d3f86p-1, -0x1.f329c0558e969p-1, -0x1.fcc7d8c64135fp-1, -0x1p+0,
};

/* cos(k pi (i + 1/2) / SHAPE_SERIES) */
static double cosine_at(int k, int i)
{
    int turned = k * (2 * i + 1) % (4 * SHAPE_SERIES);
    return shape_cosines[turned > 2 * SHAPE_SERIES ? 4 * SHAPE_SERIES - turned : turned];
}

/* The turning's series at the Chebyshev points of [from, to], then integrated; returns the size of its last terms beside what they may be. */
static double panel_series(const growth_shape *shape, uint32_t span, shape_panel *panel)
{
    double values[SHAPE_SERIES], c[SHAPE_SERIES + 2] = {0.0}, half = 0.5 * (panel->to - panel->from), middle = panel->from + half;
    for (int i = 0; i < SHAPE_SERIES; ++i) values[i] = turning(shape, span, middle + half * cosine_at(1, i));
    for (int k = 0; k < SHAPE_SERIES; ++k) {
        for (int i = 0; i < SHAPE_SERIES; ++i) c[k] += values[i] * cosine_at(k, i);
        c[k] *= (k > 0 ? 2.0 : 1.0) / SHAPE_SERIES;
    }
    double at_start = 0.0;
    for (int k = 1; k <= SHAPE_SERIES; ++k) {
        panel->c[k] = half * ((k == 1 ? 2.0 : 1.0) * c[k - 1] - c[k + 1]) / (2.0 * k);
        at_start += k & 1 ? -panel->c[k] : panel->c[k];
    }
    panel->c[0] = -at_start;
    double allowed = 1.0 + 2.0 * half * c[0] + (1.0 + panel->to) / shape_jet(shape, span, panel->to).radius;
    return half * (fabs(c[SHAPE_SERIES - 1]) + fabs(c[SHAPE_SERIES - 2])) / (SERIES_ERROR * allowed);
}

/* From the panel's start. */
static double panel_turned(const shape_panel *panel, double time)
{
    double x = (2.0 * time - panel->from - panel->to) / (panel->to - panel->from), b = 0.0, after = 0.0;
    for (int k = SHAPE_SERIES; k > 0; --k) {
        double next = 2.0 * x * b - after + panel->c[k];
        after = b;
        b = next;
    }
    return x * b - after + panel->c[0];
}

/*
 * Where a panel may end that is as wide as this: none is longer than the time before it, so that its error, a share of what it turns, is no more than the rounding of its times makes of
 * any ride in it.
 */
static double panel_end(const shape_span *span, double from, double width)
{
    return math_min(span->to, from + math_min(width, math_max(1.0, from)));
}

/* Panels over a span, from its start on; `to` and the parts still to come are halved as needed. */
static tdsp_status span_measure(growth_shape *shape, const tdsp_allocator *allocator, uint32_t k)
{
    shape_span *span = &shape->spans[k];
    double from = span->from, to = panel_end(span, from, INFINITY);
    span->first_panel = shape->panel_count;
    while (from < span->to) {
        shape_panel panel = {from, to, 0.0, {0}};
        double error = panel_series(shape, k, &panel), width = to - from, middle = from + 0.5 * width;
        if (error > 1.0 && width > LEAST_PANEL * (1.0 + from) && middle > from && middle < to) {
            to = middle;
            continue;
        }
        tdsp_status status = memory_reserve(allocator, (void **)&shape->panels, &shape->panel_capacity, shape->panel_count + 1u, sizeof *shape->panels);
        if (status != TDSP_OK) return status;
        shape->panels[shape->panel_count++] = panel;
        from = to;
        to = panel_end(span, from, 4.0 * width);
    }
    span->panel_count = shape->panel_count - span->first_panel;
    for (uint32_t p = span->first_panel; p < shape->panel_count; ++p) shape->panels[p].turned = panel_turned(&shape->panels[p], shape->panels[p].to);
    return TDSP_OK;
}

/* Where the rate is a constant c, the angle is sqrt(1 - c^2) / c ln(R_to / R_from); log1p keeps it as c goes to 0. */
static double linear_turned(const growth_shape *shape, const shape_span *span, double from, double to)
{
    const law_piece *piece = &shape->pieces[span->piece];
    double rate = piece->c[1], radius = piece->c[0] + rate * (from - piece->start);
    double sine = sqrt((1.0 - rate) * (1.0 + rate)), growth = rate * (to - from) / radius;
    return fabs(growth) < 1e-9 ? sine * (to - from) / radius * (1.0 - 0.5 * growth) : sine * math_log1p(growth) / rate;
}

static const shape_panel *panel_at(const growth_shape *shape, const shape_span *span, double time)
{
    uint32_t low = span->first_panel, high = low + span->panel_count;
    while (high - low > 1) {
        uint32_t middle = low + (high - low) / 2;
        if (shape->panels[middle].from <= time)
            low = middle;
        else
            high = middle;
    }
    return &shape->panels[low];
}

/* Between two times of one span. */
static double span_turned(const growth_shape *shape, uint32_t k, double from, double to)
{
    const shape_span *span = &shape->spans[k];
    if (!(from < to)) return 0.0;
    if (span->panel_count == 0) return linear_turned(shape, span, from, to);
    const shape_panel *first = panel_at(shape, span, from), *last = panel_at(shape, span, to);
    double turned = panel_turned(last, to) - panel_turned(first, from);
    for (const shape_panel *panel = first; panel < last; ++panel) turned += panel->turned;
    return turned;
}

/*
 * What whole spans turn, as a tree of sums: the leaves from span_count on, the children of node k at 2 k and 2 k + 1. Sums from one end would not do: around a disc that is nearly a point
 * riders turn without end, beside one that hardly grows they do so in times without end, and in differences of such sums nothing is left of a ride in between.
 */
static void turned_put(growth_shape *shape, uint32_t span, double turned)
{
    size_t node = (size_t)shape->span_count + span;
    shape->turned[node] = turned;
    while ((node /= 2) > 0) shape->turned[node] = shape->turned[2 * node] + shape->turned[2 * node + 1];
}

/* By the spans from one to right before another. */
static double turned_between(const growth_shape *shape, uint32_t from, uint32_t to)
{
    double sum = 0.0;
    for (size_t low = (size_t)shape->span_count + from, high = (size_t)shape->span_count + to; low < high; low /= 2, high /= 2) {
        if (low & 1) sum += shape->turned[low++];
        if (high & 1) sum += shape->turned[--high];
    }
    return sum;
}

double shape_turned(const growth_shape *shape, uint32_t from_span, double from, uint32_t to_span, double to)
{
    if (from_span == to_span) return span_turned(shape, from_span, from, to);
    return span_turned(shape, from_span, from, shape->spans[from_span].to) + turned_between(shape, from_span + 1, to_span) +
           span_turned(shape, to_span, shape->spans[to_span].from, to);
}

static tdsp_status turned_make(growth_shape *shape, const tdsp_allocator *allocator)
{
    size_t nodes = 2 * (size_t)shape->span_count;
    shape->turned = memory_array(allocator, nodes, sizeof *shape->turned);
    if (!shape->turned) return TDSP_NO_MEMORY;
    for (size_t i = 0; i < nodes; ++i) shape->turned[i] = 0.0;
    return TDSP_OK;
}

tdsp_status shape_measure(growth_shape *shape, const tdsp_allocator *allocator, uint32_t run)
{
    shape_run *self = &shape->runs[run];
    if (self->is_measured) return TDSP_OK;
    for (uint32_t k = self->first; k <= self->last; ++k) {
        tdsp_status status = shape_is_linear(shape, k) ? TDSP_OK : span_measure(shape, allocator, k);
        if (status != TDSP_OK) return status;
    }
    tdsp_status status = self->first < self->last && !shape->turned ? turned_make(shape, allocator) : TDSP_OK;
    if (status != TDSP_OK) return status;
    for (uint32_t k = self->first; k < self->last; ++k) turned_put(shape, k, span_turned(shape, k, shape->spans[k].from, shape->spans[k].to));
    self->is_measured = 1;
    return TDSP_OK;
}
