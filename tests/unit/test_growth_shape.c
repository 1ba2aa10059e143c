/* SPDX-License-Identifier: MIT */
/* Growth laws cut into spans and runs, and the angles that riders turn: against the pieces themselves, closed forms, and numerical integration. */
#include "support/cmocka_all.h"

#include "growth/shape.h"
#include "support/shapes.h"
#include "support/tight.h"

#define SEED 4201

static const shape_units plain = {{0.0, 0.0}, 1.0, 1.0, 0.0};
static const tdsp_point origin = {0.0, 0.0};

static growth_shape shape_of(const law_piece *pieces, uint32_t count)
{
    growth_shape shape;
    geom_law law = {pieces, count};
    tdsp_allocator memory = memory_allocator(NULL);
    assert_int_equal(shape_make(&shape, &memory, origin, law, plain), TDSP_OK);
    for (uint32_t run = 0; run < shape.run_count; ++run) assert_int_equal(shape_measure(&shape, &memory, run), TDSP_OK);
    return shape;
}

static void drop(growth_shape *shape)
{
    tdsp_allocator memory = memory_allocator(NULL);
    shape_free(shape, &memory);
}

/* Within one span. */
static double turned(const growth_shape *shape, double from, double to)
{
    uint32_t first = shape_span_at(shape, from), last = shape_span_at(shape, to);
    if (last > first && shape->spans[last].from == to) --last;
    return shape_turned(shape, first, from, last, to);
}

static double in_span(const shape_span *span, uint64_t *chance)
{
    double to = isinf(span->to) ? 2.0 * span->from + 10.0 : span->to;
    return chance_between(chance, span->from, to);
}

/* Signs within this of their zero may be either. */
#define SIGN_UNSURE 1e-9L

static void span_is_right(const growth_shape *shape, uint32_t k, uint64_t *chance)
{
    const shape_span *span = &shape->spans[k];
    const law_piece *piece = &shape->pieces[span->piece];
    for (int i = 0; i < 20; ++i) {
        long double time = in_span(span, chance), radius = piece_law(piece, time, 0), rate = piece_law(piece, time, 1);
        long double convexity = rate * rate + radius * piece_law(piece, time, 2) - 1.0L;
        if (fabsl(convexity) > SIGN_UNSURE) assert_int_equal(span->is_concave, convexity < 0.0L);
        if (fabsl(convexity) > SIGN_UNSURE && fabsl(rate - 1.0L) > SIGN_UNSURE && fabsl(radius - 1e-12L) > 1e-14L)
            assert_int_equal(span->run != SHAPE_NONE, convexity < 0.0L && rate < 1.0L && radius > 1e-12L);
    }
}

static void a_span_is_concave_and_ridden_where_its_law_says_so_at(shape_world *w)
{
    for (uint32_t i = 0; i < w->growth->engine.shape_count; ++i) {
        const growth_shape *shape = &w->shapes[i];
        assert_exact(shape->spans[0].from, 0.0);
        assert_exact(shape->spans[shape->span_count - 1].to, INFINITY);
        for (uint32_t k = 0; k < shape->span_count; ++k) {
            const shape_span *span = &shape->spans[k];
            if (k > 0) assert_exact(span->from, shape->spans[k - 1].to);
            if (span->from < span->to) span_is_right(shape, k, &w->chance);
        }
    }
}

static void a_span_is_concave_and_ridden_where_its_law_says_so(void **state)
{
    (void)state;
    shapes_each(20, 6, SEED, a_span_is_concave_and_ridden_where_its_law_says_so_at);
}

static void runs_are_right(const growth_shape *shape)
{
    uint32_t run = 0;
    for (uint32_t k = 0; k < shape->span_count; ++k) {
        const shape_span *span = &shape->spans[k];
        if (span->run == SHAPE_NONE) continue;
        assert_int_equal(span->run, run);
        if (shape->runs[run].first != k) {
            const shape_span *before = &shape->spans[k - 1];
            assert_true(piece_law(&shape->pieces[before->piece], span->from, 1) >= piece_law(&shape->pieces[span->piece], span->from, 1) - 1.01e-7L); /* what is taken to be no rise */
        }
        if (shape->runs[run].last == k) ++run;
    }
    assert_int_equal(run, shape->run_count);
}

/* At a moment where pieces meet: may whoever touches the disc turn there? */
static int is_corner(const growth_shape *shape, uint32_t piece)
{
    double time = shape->pieces[piece].start;
    long double before = piece_law(&shape->pieces[piece - 1], time, 1), after = piece_law(&shape->pieces[piece], time, 1);
    return before > after + 1e-9L && after < 1.0L - 1e-9L && piece_law(&shape->pieces[piece], time, 0) > 1e-11L;
}

static void runs_go_on_where_the_rate_does_not_rise_at(shape_world *w)
{
    for (uint32_t i = 0; i < w->growth->engine.shape_count; ++i) {
        const growth_shape *shape = &w->shapes[i];
        runs_are_right(shape);
        for (uint32_t piece = 1; piece < shape->piece_count; ++piece) {
            if (!is_corner(shape, piece)) continue;
            uint32_t left = 0;
            while (left + 1 < shape->span_count && !(shape->spans[left].to == shape->pieces[piece].start && shape->spans[left + 1].piece == piece)) ++left;
            assert_true(left + 1 < shape->span_count);
            assert_int_not_equal(shape->spans[left].run, SHAPE_NONE);
            assert_int_equal(shape->spans[left].run, shape->spans[left + 1].run);
        }
    }
}

static void runs_go_on_where_the_rate_does_not_rise(void **state)
{
    (void)state;
    shapes_each(20, 6, SEED, runs_go_on_where_the_rate_does_not_rise_at);
}

static void pieces_join_to_runs_by_their_rates(void **state)
{
    (void)state;
    static const struct {
        double rates[3];
        uint32_t runs, spans;
    } cases[] = {
        {{0.3, 0.2, 0.1}, 1, 3}, {{0.1, 0.2, 0.3}, 3, 3}, {{0.2, 0.2, 0.4}, 2, 3}, {{2.0, 0.5, 0.6}, 2, 4}, /* the corner before 0.5 */
        {{2.0, 1.5, 1.2}, 0, 3}, {{0.5, 2.0, 0.5}, 2, 4}, {{0.5, 1.0, 0.0}, 2, 4}, {{0.0, 0.0, 0.0}, 1, 3},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        law_piece pieces[3];
        double radius = 1.0;
        for (int k = 0; k < 3; ++k) {
            law_piece piece = {k, {radius, cases[i].rates[k]}, 1};
            pieces[k] = piece;
            radius += cases[i].rates[k];
        }
        growth_shape shape = shape_of(pieces, 3);
        assert_int_equal(shape.run_count, cases[i].runs);
        assert_int_equal(shape.span_count, cases[i].spans);
        drop(&shape);
    }
}

static void a_corner_between_convex_pieces_can_be_touched(void **state)
{
    (void)state;
    /* R = 1 + 0.2 t + 0.9 t^2, then 2.1 + 0.1 u + 0.9 u^2: both convex at once, the rate falls from 2 to 0.1 */
    const law_piece pieces[2] = {{0.0, {1.0, 0.2, 0.9}, 2}, {1.0, {2.1, 0.1, 0.9}, 2}};
    growth_shape shape = shape_of(pieces, 2);
    assert_int_equal(shape.run_count, 1);
    const shape_span *left = &shape.spans[shape.runs[0].first], *right = &shape.spans[shape.runs[0].last];
    assert_int_equal(right - left, 1);
    assert_exact(left->from, 1.0);
    assert_exact(left->to, 1.0);
    assert_exact(right->from, 1.0);
    assert_exact(right->to, 1.0);
    assert_int_equal(left->piece, 0);
    assert_int_equal(right->piece, 1);
    assert_exact(turned(&shape, 1.0, 1.0), 0.0);
    drop(&shape);
}

static void a_disc_that_begins_as_a_point_is_ridden_from_the_least_radius_on(void **state)
{
    (void)state;
    const law_piece pieces[2] = {{0.0, {0.0}, 0}, {2.0, {0.0, 0.5}, 1}};
    growth_shape shape = shape_of(pieces, 2);
    assert_int_equal(shape.run_count, 1);
    assert_near(shape.spans[shape.runs[0].first].from, 2.0 + 2.0 * SHAPE_LEAST_RIDE, 1e-15);
    assert_near(turned(&shape, 2.5, 4.5), sqrt(0.75) / 0.5 * log(5.0), 1e-15);
    drop(&shape);
}

/* Of a moment t of rate c: sqrt(1 - c^2) / c ln(R / R0), the sum over the pieces. */
static void angles_at_constant_rates_are_logarithms(void **state)
{
    (void)state;
    uint64_t chance = SEED;
    print_message("seed %d\n", SEED);
    for (int k = 0; k < 2000; ++k) {
        law_piece pieces[3];
        double radius = pow(10.0, chance_between(&chance, -6.0, 2.0)), rate = chance_between(&chance, 0.5, 0.999), start = 0.0;
        double from = chance_between(&chance, 0.0, 1.0), to = chance_between(&chance, 2.0, 5.0);
        long double expected = 0.0L;
        for (int i = 0; i < 3; ++i) {
            law_piece piece = {start, {radius, rate}, 1};
            pieces[i] = piece;
            double begin = i == 0 ? from : start, end = i == 2 ? to : start + 1.0;
            long double c = rate, grown = c * ((long double)end - (long double)begin) / ((long double)radius + c * ((long double)begin - (long double)start));
            expected += sqrtl((1.0L - c) * (1.0L + c)) / c * log1pl(grown);
            radius += rate;
            rate *= chance_below(&chance, 4) ? chance_unit(&chance) : 1e-12;
            start += 1.0;
        }
        growth_shape shape = shape_of(pieces, 3);
        assert_int_equal(shape.run_count, 1);
        assert_near(turned(&shape, from, to), (double)expected, 4e-15 * (1.0 + (double)expected));
        drop(&shape);
    }
}

static void a_disc_that_stands_still_is_a_circle(void **state)
{
    (void)state;
    const law_piece circle = {0.0, {0.25}, 0};
    growth_shape shape = shape_of(&circle, 1);
    assert_near(turned(&shape, 1.0, 1.0 + 0.5 * GEOM_PI), GEOM_TURN, 1e-15);
    drop(&shape);
}

/* R = 1 + t^2/4 is concave up to 2/sqrt(3); t = 2 sin u makes the angle 2 sqrt(2) atan(sqrt(2) tan u) - 2 u. */
static void a_parabola_that_opens_has_its_closed_angle(void **state)
{
    (void)state;
    const law_piece parabola = {0.0, {1.0, 0.0, 0.25}, 2};
    growth_shape shape = shape_of(&parabola, 1);
    assert_int_equal(shape.run_count, 1);
    double end = shape.spans[shape.runs[0].last].to;
    assert_near(end, 2.0 / sqrt(3.0), 1e-15);
    for (int k = 1; k <= 1000; ++k) {
        double to = end * k / 1000.0, u = asin(0.5 * to);
        assert_near(turned(&shape, 0.0, to), 2.0 * sqrt(2.0) * atan(sqrt(2.0) * tan(u)) - 2.0 * u, 1e-15);
    }
    drop(&shape);
}

/* 2 u - 10/sqrt(30) atan(sqrt(5/6) tan u), which is the angle left to turn for sin u = R'. */
static double left_to_turn(double u)
{
    return 2.0 * u - 10.0 / sqrt(30.0) * atan2(sqrt(5.0 / 6.0) * sin(u), cos(u));
}

/* R = 3 - (2 - t)^2/2 comes down to the robot's speed at 1 and to nothing at 2, and stays: the ride begins where R' = 1. */
static void a_parabola_that_closes_has_its_closed_angle_from_the_robots_speed_on(void **state)
{
    (void)state;
    const law_piece pieces[2] = {{0.0, {1.0, 2.0, -0.5}, 2}, {2.0, {3.0}, 0}};
    growth_shape shape = shape_of(pieces, 2);
    assert_int_equal(shape.run_count, 1);
    double begins = shape.spans[shape.runs[0].first].from;
    assert_near(begins, 1.0, 1e-15);
    assert_near(turned(&shape, begins, 2.0), left_to_turn(0.5 * GEOM_PI), 1e-15);
    for (int k = 0; k < 60; ++k) {
        double from = 1.0 + pow(2.0, -k), u = asin(2.0 - from), expected = k == 0 ? 0.0 : left_to_turn(u);
        assert_near(turned(&shape, from, 2.0), expected, 2e-15);
        assert_near(turned(&shape, begins, from), left_to_turn(0.5 * GEOM_PI) - expected, 2e-15);
    }
    assert_near(turned(&shape, begins, 5.0), left_to_turn(0.5 * GEOM_PI) + 1.0, 2e-15);
    drop(&shape);
}

/*
 * R = 0.25 + 1e-15 t^2, for ten million units of time, that is 2e7 of angle: found by fuzzing, which had a path cut into a million legs, for in its first units the angle was known to no more than
 * 1e-9.
 */
static void a_long_law_is_as_exact_in_its_first_moments(void **state)
{
    (void)state;
    const law_piece pieces[2] = {{0.0, {0.25, 0.0, 1e-15}, 2}, {1e7, {0.35}, 0}};
    growth_shape shape = shape_of(pieces, 2);
    for (double from = 0.05; from < 40.0; from *= 1.7)
        for (double width = 1e-3; width < 30.0; width *= 3.0) {
            double to = from + width, expected = 4.0 * (to - from) - 4.0 * 4e-15 / 3.0 * (to * to * to - from * from * from);
            assert_near(turned(&shape, from, to), expected, 4e-15 * (1.0 + 4.0 * to));
        }
    drop(&shape);
}

/* R = 0.5 t + 0.1 t^2 turns without end towards t = 0: integrated over ln t, where nothing is large. The whole is as sure as a place at the start. */
static void angles_around_a_disc_that_was_a_point_keep_their_digits(void **state)
{
    (void)state;
    const law_piece piece = {0.0, {0.0, 0.5, 0.1}, 2};
    growth_shape shape = shape_of(&piece, 1);
    double begins = shape.spans[shape.runs[0].first].from;
    assert_near(begins, 2.0 * SHAPE_LEAST_RIDE, 1e-22);
    for (int k = 1; k < 38; ++k) {
        long double from = powl(2.0L, -k), sum = 0.0L;
        int parts = 1000 * k;
        for (int i = 0; i <= 2 * parts; ++i) { /* Simpson */
            long double t = expl(logl(from) * (1.0L - (long double)i / (2 * parts))), rate = 0.5L + 0.2L * t;
            sum += (i == 0 || i == 2 * parts ? 1.0L : i % 2 ? 4.0L : 2.0L) * sqrtl(1.0L - rate * rate) / (0.5L + 0.1L * t);
        }
        double expected = (double)(-logl(from) / (6 * parts) * sum), radius = (double)(0.5L * from + 0.1L * from * from);
        assert_near(turned(&shape, (double)from, 1.0), expected, 1e-15 * (1.0 + expected) + 4e-16 / radius);
        assert_near(turned(&shape, (double)from, 2.0 * (double)from), (double)piece_turned(&piece, from, 2.0L * from), 2e-15 + 4e-16 / radius);
    }
    drop(&shape);
}

/* Its spans double in length until its bend shows, after which it has been gone around more often than can be counted: a ride in the first ones is not to be lost in that. */
static void angles_around_a_disc_that_hardly_grows_keep_their_digits(void **state)
{
    (void)state;
    const law_piece piece = {0.0, {1.25, 1e-300, 3e-300}, 2};
    growth_shape shape = shape_of(&piece, 1);
    assert_true(shape.runs[0].last > shape.runs[0].first + 900);
    for (double from = 0.5; from < 1e6; from *= 3.0)
        for (double to = from + 0.25; to < 1e6; to *= 5.0) assert_near(turned(&shape, from, to), (to - from) / 1.25, 1e-15 * to);
    drop(&shape);
}

/* Angles are told to rounding: of a radian, of themselves, and of a length at the radius where they end. */
static double angle_error(const growth_shape *shape, uint32_t span, double to, double angle)
{
    return 4e-15 * (1.0 + angle + (1.0 + to) / shape_jet(shape, span, to).radius);
}

static void run_turns_as_integrated(const growth_shape *shape, uint32_t run, uint64_t *chance)
{
    const shape_run *self = &shape->runs[run];
    for (int i = 0; i < 5; ++i) {
        uint32_t first = self->first + (uint32_t)chance_below(chance, self->last - self->first + 1);
        uint32_t last = first + (uint32_t)chance_below(chance, self->last - first + 1);
        double a = in_span(&shape->spans[first], chance), b = in_span(&shape->spans[last], chance);
        double from = first == last ? fmin(a, b) : a, to = first == last ? fmax(a, b) : b;
        long double expected = 0.0L;
        for (uint32_t k = first; k <= last; ++k) {
            const shape_span *span = &shape->spans[k];
            expected += piece_turned(&shape->pieces[span->piece], fmax(from, span->from), fmin(to, span->to));
        }
        assert_near(shape_turned(shape, first, from, last, to), (double)expected, angle_error(shape, last, to, (double)expected));
    }
}

static void angles_are_what_integration_says_at(shape_world *w)
{
    growth_engine *engine = &w->growth->engine;
    for (uint32_t i = 0; i < engine->shape_count; ++i)
        for (uint32_t run = 0; run < w->shapes[i].run_count; ++run) {
            assert_int_equal(shape_measure(&engine->shapes[i], &engine->allocator, run), TDSP_OK);
            run_turns_as_integrated(&w->shapes[i], run, &w->chance);
        }
}

static void angles_are_what_integration_says(void **state)
{
    (void)state;
    shapes_each(4, 6, SEED, angles_are_what_integration_says_at);
}

static void the_frame_takes_out_units_and_the_robots_radius(void **state)
{
    (void)state;
    const law_piece user[2] = {{0.0, {1.0, 0.0, 3.0}, 2}, {4.0, {49.0, 2.0}, 1}};
    const shape_units units = {{5.0, -3.0}, 10.0, 8.0, 0.5};
    geom_law law = {user, 2};
    tdsp_allocator memory = memory_allocator(NULL);
    growth_shape shape;
    assert_int_equal(shape_make(&shape, &memory, point_make(25.0, 7.0), law, units), TDSP_OK);
    assert_near(shape.center.x, 2.0, 1e-15);
    assert_near(shape.center.y, 1.0, 1e-15);
    for (double t = 0.0; t < 9.0; t += 0.25) {
        double radius = t < 4.0 ? 1.0 + 3.0 * t * t : 49.0 + 2.0 * (t - 4.0), rate = t < 4.0 ? 6.0 * t : 2.0;
        uint32_t span = shape_span_at(&shape, t / 8.0);
        assert_near(shape_radius(&shape, t / 8.0), (radius + 0.5) / 10.0, 1e-14);
        assert_near(shape_jet(&shape, span, t / 8.0).rate, rate * 0.8, 1e-14);
        assert_int_equal(shape_is_linear(&shape, span), t >= 4.0);
    }
    shape_free(&shape, &memory);
}

static void a_shape_without_memory_is_told_and_leaves_nothing(void **state)
{
    (void)state;
    const law_piece pieces[3] = {{0.0, {0.0, 0.5, 0.1, -0.001}, 3}, {2.0, {1.392, 3.0}, 1}, {3.0, {4.392, 0.9, -0.02, 1e-4}, 3}};
    geom_law law = {pieces, 3};
    int is_done = 0;
    for (size_t refuse = 1; !is_done; ++refuse) {
        tight_heap heap = {.refuse = refuse};
        tdsp_allocator memory = tight_allocator(&heap);
        growth_shape shape;
        tdsp_status status = shape_make(&shape, &memory, origin, law, plain);
        for (uint32_t run = 0; run < shape.run_count && status == TDSP_OK; ++run) {
            status = shape_measure(&shape, &memory, run);
            assert_int_equal(shape.runs[run].is_measured, status == TDSP_OK);
        }
        assert_int_equal(heap.held, shape_bytes(&shape));
        is_done = status == TDSP_OK;
        if (!is_done) assert_int_equal(status, TDSP_NO_MEMORY);
        shape_free(&shape, &memory);
        assert_int_equal(heap.blocks, 0);
        assert_int_equal(heap.held, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_span_is_concave_and_ridden_where_its_law_says_so),
        cmocka_unit_test(runs_go_on_where_the_rate_does_not_rise),
        cmocka_unit_test(pieces_join_to_runs_by_their_rates),
        cmocka_unit_test(a_corner_between_convex_pieces_can_be_touched),
        cmocka_unit_test(a_disc_that_begins_as_a_point_is_ridden_from_the_least_radius_on),
        cmocka_unit_test(angles_at_constant_rates_are_logarithms),
        cmocka_unit_test(a_disc_that_stands_still_is_a_circle),
        cmocka_unit_test(a_parabola_that_opens_has_its_closed_angle),
        cmocka_unit_test(a_parabola_that_closes_has_its_closed_angle_from_the_robots_speed_on),
        cmocka_unit_test(a_long_law_is_as_exact_in_its_first_moments),
        cmocka_unit_test(angles_around_a_disc_that_was_a_point_keep_their_digits),
        cmocka_unit_test(angles_around_a_disc_that_hardly_grows_keep_their_digits),
        cmocka_unit_test(angles_are_what_integration_says),
        cmocka_unit_test(the_frame_takes_out_units_and_the_robots_radius),
        cmocka_unit_test(a_shape_without_memory_is_told_and_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
