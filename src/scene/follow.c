/* SPDX-License-Identifier: MIT */
/*
 * Laws by callback, followed by pieces of polynomials.
 *
 * Between two kinks the time is halved until a piece agrees: its rate is the Chebyshev interpolant of the law's rate at 8 places (no end
 * is among them: the rate may jump there), its radius the integral of that, begun at the law's radius, and moved by a constant rate so that it
 * ends at the law's. It is compared with the law at the extrema in between, where the interpolant's first neglected term is largest, and,
 * where the piece is long, at many places more: radius within 1e-13 of that at the piece's end (and what the disc grows while a clock of doubles
 * ticks), rate within what adds up to that over the piece. As R never falls and the piece does not either, between two places that agree the piece is off by no more than what the disc
 * grows between them, whatever the law does there.
 *
 * The piece's rate is proven not to be negative by its Bernstein form. Where the proof fails, the rate is raised by what is missing and scaled down to
 * the same growth, if that stays within the tolerance.
 *
 * A kink that was not told is enclosed by halving: over a piece of length h, a rate that is wrong by J moves the radius by J h at most, and the tolerance accepts
 * that when it no longer matters. At 2^-50 of the whole time the law is joined by a line, if the radius does not grow by more than 1e-13 of the
 * largest radius; if it does, it jumps.
 */
#include <float.h>

#include "base/math.h"
#include "scene/growth.h"

/* How far a piece may be off, as a share of the radius. */
#define AGREES 1e-13

/* ... and a time is rounded by so much of itself, in which the disc grows. */
#define CLOCK (16.0 * DBL_EPSILON)

/* What a law's own round-off may be, likewise. */
#define NOISE 1e-14

/* Pieces of one law. */
#define MOST_PIECES 16384u

/* What is left out of an interpolant, as a share of the largest rate: its round-off. */
#define SERIES_ERROR (16.0 * DBL_EPSILON)

/* No piece is halved below this share of the whole time. */
#define SHORTEST 0x1p-50

/* A piece shorter than this share has a law that looks straight: the mean rate must then be among the rates. */
#define STRAIGHT 0x1p-30

/* A piece as long as the whole time is compared at so many places more, half as long at half as many, ... */
#define MORE_PLACES 64

#define NODES 8
#define PLACES (2 * NODES + 1) /* 0: the begin; odd: nodes; even: extrema; the last: the end */

typedef struct follower {
    const tdsp_growing_disc *disc;
    piece_list *list;
    double largest; /* radius */
    const char *wrong;
} follower;

typedef struct law_sample {
    double time;
    double radius;
    double rate;
} law_sample;

/* A stretch between two times, with the law at its places. */
typedef struct stretch {
    double length;
    double tolerance;
    law_sample at[PLACES];
} stretch;

/* (1 - cos(k pi / 16)) / 2 */
static const double places[PLACES] = {
    0.0, 0.009607359798384776, 0.038060233744356624, 0.084265193848727382, 0.14644660940672624, 0.22221488349019888,
    0.30865828381745514, 0.40245483899193585, 0.5, 0.5975451610080641, 0.69134171618254492, 0.77778511650980109,
    0.85355339059327373, 0.91573480615127267, 0.96193976625564337, 0.99039264020161522, 1.0};

/* 1 where the law gives numbers in their range. */
static int law_ask(follower *f, double time, law_sample *sample)
{
    const tdsp_growth *growth = &f->disc->growth;
    sample->time = time;
    sample->radius = sample->rate = NAN;
    growth->law(growth->ctx, time, &sample->radius, &sample->rate);
    double noise = f->largest > 0.0 ? AGREES * f->largest / growth->until : 0.0;
    if (!(sample->radius >= 0.0 && sample->radius <= GROWTH_LARGEST)) f->wrong = "the law gives a radius that is not between 0 and 1e100";
    else if (!(sample->rate >= -noise && sample->rate <= GROWTH_LARGEST)) f->wrong = "the law gives a rate that is not between 0 and 1e100";
    if (sample->rate < 0.0) sample->rate = 0.0;
    return !f->wrong;
}

/* Does the radius not fall from one sample to the next? */
static int law_rises(follower *f, const law_sample *from, const law_sample *to)
{
    if (!f->wrong && to->radius < from->radius * (1.0 - NOISE)) f->wrong = "the law's radius falls";
    return !f->wrong;
}

/* Ask the law everywhere in the stretch but at its ends. */
static int stretch_ask(follower *f, stretch *s, const law_sample *from, const law_sample *to)
{
    s->length = to->time - from->time;
    s->at[0] = *from;
    s->at[PLACES - 1] = *to;
    double fastest = 0.0;
    for (int k = 1; k < PLACES - 1; ++k) {
        if (!law_ask(f, from->time + s->length * places[k], &s->at[k])) return 0;
        fastest = math_max(fastest, s->at[k].rate);
    }
    for (int k = 1; k < PLACES; ++k)
        if (!law_rises(f, &s->at[k - 1], &s->at[k])) return 0;
    s->tolerance = AGREES * to->radius + CLOCK * to->time * fastest;
    return 1;
}

/* Coefficients of the Chebyshev polynomials on [-1, 1] that take the rates at the nodes; returns how many matter. */
static int rate_series(const stretch *s, double series[NODES])
{
    double largest = 0.0, dropped = 0.0;
    int count = NODES;
    for (int m = 0; m < NODES; ++m) series[m] = 0.0;
    for (int j = 0; j < NODES; ++j) {
        double x = 2.0 * places[2 * j + 1] - 1.0, before = 1.0, now = x, rate = s->at[2 * j + 1].rate;
        largest = math_max(largest, rate);
        series[0] += rate / NODES;
        for (int m = 1; m < NODES; ++m) {
            double next = 2.0 * x * now - before;
            series[m] += 2.0 / NODES * rate * now;
            before = now;
            now = next;
        }
    }
    while (count > 1 && (dropped += fabs(series[count - 1])) <= SERIES_ERROR * largest) --count;
    return count;
}

/* The same in powers of the share of the stretch. */
static void series_powers(const double *series, int count, double powers[NODES])
{
    double before[NODES] = {1.0}, now[NODES] = {-1.0, 2.0};
    for (int k = 0; k < NODES; ++k) powers[k] = 0.0;
    powers[0] = series[0];
    for (int m = 1; m < count; ++m) {
        double next[NODES] = {0.0};
        for (int k = 0; k <= m; ++k) powers[k] += series[m] * now[k];
        for (int k = 0; k < NODES; ++k) next[k] = (k > 0 ? 4.0 * now[k - 1] : 0.0) - 2.0 * now[k] - before[k];
        for (int k = 0; k < NODES; ++k) {
            before[k] = now[k];
            now[k] = next[k];
        }
    }
}

static law_piece piece_over(const stretch *s)
{
    double series[NODES], powers[NODES];
    int count = rate_series(s, series);
    law_piece piece = {s->at[0].time, {s->at[0].radius}, (uint32_t)count};
    series_powers(series, count, powers);
    for (int k = 1; k <= count; ++k) {
        piece.c[k] = powers[k - 1] / k;
        for (int i = 1; i < k; ++i) piece.c[k] /= s->length;
    }
    return piece;
}

/* The growth over the stretch, by the law. */
static double stretch_growth(const stretch *s)
{
    return math_max(0.0, s->at[PLACES - 1].radius - s->at[0].radius);
}

/* Move the piece by a constant rate to the law's radius at the end. */
static void piece_meet_end(const stretch *s, law_piece *piece)
{
    double missing = s->at[PLACES - 1].radius - law_piece_jet(piece, s->at[PLACES - 1].time).radius;
    if (fabs(missing) > 4.0 * DBL_EPSILON * s->at[PLACES - 1].radius) piece->c[1] += missing / s->length;
}

/* A rate that is nowhere negative, up to the round-off that growth.c allows polynomials. 0 where too much is missing. */
static int piece_raise(const stretch *s, law_piece *piece)
{
    polynomial rate = growth_rate_raised(piece);
    double least = 0.0, growth = stretch_growth(s);
    for (int k = 0; k < 4; ++k) least = math_min(least, polynomial_least(&rate, 0.25 * k * s->length, 0.25 * (k + 1) * s->length));
    if (!(-least * s->length <= s->tolerance)) return 0;
    if (least >= 0.0) return 1;
    double scale = growth > 0.0 ? growth / (growth - least * s->length) : 0.0;
    piece->c[1] -= least;
    for (uint32_t k = 1; k <= piece->degree; ++k) piece->c[k] *= scale;
    return 1;
}

static int piece_agrees_at(const stretch *s, const law_piece *piece, const law_sample *sample, int with_rate)
{
    law_jet jet = law_piece_jet(piece, sample->time);
    if (!(fabs(jet.radius - sample->radius) <= s->tolerance)) return 0;
    return !with_rate || fabs(jet.rate - sample->rate) * s->length <= s->tolerance;
}

/* Is the mean rate among the rates, as the law's own must be? Only where the stretch is so short that the places show them. */
static int stretch_is_consistent(follower *f, const stretch *s)
{
    double least = INFINITY, most = 0.0, mean = stretch_growth(s) / s->length;
    if (s->length > STRAIGHT * f->disc->growth.until) return 1;
    for (int k = 0; k < PLACES; ++k) {
        least = math_min(least, s->at[k].rate);
        most = math_max(most, s->at[k].rate);
    }
    double slack = 1e-3 * most + NOISE * s->at[PLACES - 1].radius / s->length;
    if (mean < least - slack || mean > most + slack) f->wrong = "the law's rate disagrees with its radius";
    return !f->wrong;
}

/* Compare at the places between the nodes, and at more where the stretch is long; the rate at the end may be another's. */
static int piece_agrees(follower *f, const stretch *s, const law_piece *piece)
{
    int more = (int)(MORE_PLACES * s->length / f->disc->growth.until);
    for (int k = 0; k < PLACES; ++k)
        if (!piece_agrees_at(s, piece, &s->at[k], k < PLACES - 1)) return 0;
    for (int k = 0; k < more; ++k) {
        law_sample sample;
        if (!law_ask(f, s->at[0].time + s->length * (k + 0.382) / more, &sample)) return 0;
        if (!piece_agrees_at(s, piece, &sample, 1)) return 0;
    }
    return stretch_is_consistent(f, s);
}

static int is_uniform(const stretch *s)
{
    for (int k = 0; k < PLACES - 1; ++k)
        if (s->at[k].rate != s->at[0].rate) return 0;
    return 1;
}

/* 1 where the list took it. */
static int piece_take(follower *f, const law_piece *piece)
{
    if (f->list->count - f->list->begun >= MOST_PIECES) f->wrong = "the law takes over 16384 pieces: kinks that were not told, or a rate that disagrees with the radius";
    if (f->wrong) return 0;
    return piece->degree <= 1 ? pieces_add_line(f->list, piece->start, piece->c[0], piece->c[1]) : pieces_add(f->list, *piece);
}

/* Where the law's rate is one number, it stays that one to the bit. */
static int stretch_follow_line(follower *f, const stretch *s)
{
    law_piece line = {s->at[0].time, {s->at[0].radius, s->at[0].rate}, 1};
    return is_uniform(s) && piece_agrees(f, s, &line) && piece_take(f, &line);
}

static int stretch_follow(follower *f, const stretch *s)
{
    if (stretch_follow_line(f, s)) return 1;
    if (f->wrong || f->list->status != TDSP_OK) return 0;
    law_piece piece = piece_over(s);
    piece_meet_end(s, &piece);
    return piece_raise(s, &piece) && piece_agrees(f, s, &piece) && piece_take(f, &piece);
}

/* A stretch too short to be halved: a line, if the radius does not jump. */
static void stretch_join(follower *f, const stretch *s)
{
    double growth = stretch_growth(s);
    law_piece line = {s->at[0].time, {s->at[0].radius, growth / s->length}, 1};
    if (growth > AGREES * f->largest) f->wrong = "the law's radius jumps";
    else piece_take(f, &line);
}

static int follower_is_stuck(const follower *f)
{
    return f->wrong != NULL || f->list->status != TDSP_OK;
}

/* From one kink to the next. */
static void follow_between(follower *f, law_sample from, law_sample to)
{
    law_sample ends[64] = {to};
    int open = 1;
    while (open > 0 && !follower_is_stuck(f)) {
        stretch s;
        const law_sample *end = &ends[open - 1];
        double middle = from.time + 0.5 * (end->time - from.time);
        if (!stretch_ask(f, &s, &from, end)) return;
        int followed = stretch_follow(f, &s);
        if (follower_is_stuck(f)) return;
        if (!followed && s.length > SHORTEST * f->disc->growth.until && middle > from.time && middle < end->time) {
            law_ask(f, middle, &ends[open++]);
            continue;
        }
        if (!followed) stretch_join(f, &s);
        from = *end;
        --open;
    }
}

static const char *law_wrong(const tdsp_growth *growth)
{
    if (!growth->law) return "the law is missing";
    if (!(growth->until > 0.0 && growth->until <= GROWTH_LARGEST)) return "the law's last time is not over 0 and up to 1e100";
    if (growth->count > 0 && !growth->times) return "the law's kinks are missing";
    for (size_t k = 0; k < growth->count; ++k) {
        double before = k > 0 ? growth->times[k - 1] : 0.0;
        if (!(growth->times[k] > before && growth->times[k] <= GROWTH_LARGEST)) return "the law's kinks are not over 0, increasing, and up to 1e100";
    }
    return NULL;
}

/* The law at both ends of its time. */
static int follower_begin(follower *f, law_sample *first, law_sample *last)
{
    const tdsp_growing_disc *disc = f->disc;
    f->wrong = law_wrong(&disc->growth);
    if (f->wrong || !law_ask(f, disc->growth.until, last)) return 0;
    f->largest = last->radius;
    if (!law_ask(f, 0.0, first)) return 0;
    if (fabs(first->radius - disc->radius) > AGREES * disc->radius) f->wrong = "the radius is not the law's at time 0";
    first->radius = disc->radius;
    return law_rises(f, first, last);
}

const char *growth_follow(const tdsp_growing_disc *disc, piece_list *list)
{
    const tdsp_growth *growth = &disc->growth;
    follower f = {disc, list, 0.0, NULL};
    law_sample from, last;
    if (!follower_begin(&f, &from, &last)) return f.wrong;
    for (size_t k = 0; k < growth->count && growth->times[k] < growth->until && !follower_is_stuck(&f); ++k) {
        law_sample kink;
        if (!law_ask(&f, growth->times[k], &kink) || !law_rises(&f, &from, &kink)) return f.wrong;
        follow_between(&f, from, kink);
        from = kink;
    }
    if (!follower_is_stuck(&f)) follow_between(&f, from, last);
    if (!follower_is_stuck(&f)) pieces_add_line(list, growth->until, last.radius, last.rate);
    return f.wrong;
}
