/* SPDX-License-Identifier: MIT */
/* Straight motions past discs with any growth law: least values, contacts and their times, against a dense look at the motion itself. */
#include "support/cmocka_all.h"

#include "growth/sight.h"
#include "support/shapes.h"

#define SEED 4202

/* A motion near a disc, in either direction of time. */
typedef struct motion {
    const growth_shape *shape;
    double sign;
    sight_line line;
    double end;
} motion;

static motion motion_draw(shape_world *w)
{
    uint64_t *chance = &w->chance;
    motion m = {&w->shapes[chance_below(chance, w->growth->engine.shape_count)], chance_below(chance, 2) ? 1.0 : -1.0, {{0.0, 0.0}, {0.0, 0.0}, 0.0}, 0.0};
    double from = chance_between(chance, 0.0, 3.0), length = chance_between(chance, 0.0, 2.0), ahead = chance_unit(chance);
    if (m.sign < 0.0) length = fmin(length, from);
    m.line.start = m.sign * from;
    m.end = m.line.start + length;
    /* where it will be next to the disc, and how far from its boundary */
    tdsp_point out = point_unit(chance_between(chance, 0.0, GEOM_TURN));
    double radius = (double)shape_law(m.shape, m.sign * (m.line.start + ahead * length), 0);
    double gap = chance_between(chance, -1.0, 1.0) * pow(10.0, chance_between(chance, -9.0, 0.0));
    m.line.unit = chance_below(chance, 2) ? point_make(-out.y, out.x) : point_unit(chance_between(chance, 0.0, GEOM_TURN));
    m.line.from = point_along(point_along(m.shape->center, fmax(radius + gap, 0.0), out), -ahead * length, m.line.unit);
    return m;
}

static double clearance(const motion *m, double time)
{
    return shape_clearance(m->shape, sight_place(&m->line, time), m->sign * time);
}

/* F on one piece of the law, in more digits. */
static long double exact_value(const motion *m, uint32_t span, long double time)
{
    long double x = (long double)m->line.from.x - (long double)m->shape->center.x + (time - m->line.start) * (long double)m->line.unit.x;
    long double y = (long double)m->line.from.y - (long double)m->shape->center.y + (time - m->line.start) * (long double)m->line.unit.y;
    long double radius = piece_law(&m->shape->pieces[m->shape->spans[span].piece], (long double)m->sign * time, 0);
    return x * x + y * y - radius * radius;
}

/* Half its slope. */
static long double exact_slope(const motion *m, uint32_t span, long double time)
{
    const law_piece *piece = &m->shape->pieces[m->shape->spans[span].piece];
    long double x = (long double)m->line.from.x - (long double)m->shape->center.x, y = (long double)m->line.from.y - (long double)m->shape->center.y;
    long double along = x * (long double)m->line.unit.x + y * (long double)m->line.unit.y + (time - m->line.start);
    return along - (long double)m->sign * piece_law(piece, (long double)m->sign * time, 0) * piece_law(piece, (long double)m->sign * time, 1);
}

/* The least of F on a span by sampling. */
static long double sampled_least(const motion *m, uint32_t span, double low, double high)
{
    long double least = INFINITY;
    for (int i = 0; i <= 300; ++i) least = fminl(least, exact_value(m, span, low + (high - low) * i / 300.0));
    return least;
}

/* What the rounding of a derivative of the law's is relative to: its terms may cancel. */
static double law_terms(const motion *m, uint32_t span, double time, int order)
{
    const law_piece *piece = &m->shape->pieces[m->shape->spans[span].piece];
    law_piece terms = *piece;
    for (uint32_t k = 0; k <= piece->degree; ++k) terms.c[k] = fabs(piece->c[k]);
    terms.start = 0.0;
    return (double)piece_law(&terms, fabs(m->sign * time - piece->start), order);
}

/* ... and that of F. */
static double squared_sizes(const motion *m, uint32_t span, double time)
{
    double size = 1.0 + point_distance(sight_place(&m->line, time), m->shape->center) + law_terms(m, span, time, 0);
    return size * size;
}

/* ... and that of F's slope, at a time that is rounded. */
static double slope_size(const motion *m, uint32_t span, double time)
{
    double radius = law_terms(m, span, time, 0), rate = law_terms(m, span, time, 1), bend = law_terms(m, span, time, 2);
    return 1.0 + fabs(time - m->line.start) + radius * rate + (1.0 + fabs(time)) * (1.0 + rate * rate + radius * bend);
}

static void is_least_on_run(const motion *m, uint32_t run, double from, const sight_nearest *nearest)
{
    const shape_run *self = &m->shape->runs[run];
    for (uint32_t span = self->first; span <= self->last; ++span) {
        double low = fmax(span_begins(&m->shape->spans[span], m->sign), from), high = fmin(span_ends(&m->shape->spans[span], m->sign), from + 20.0);
        if (low < high) assert_true(nearest->value <= (double)sampled_least(m, span, low, high) + 4e-15 * squared_sizes(m, nearest->span, nearest->time));
    }
}

/* The time is right if F falls before it and rises after it: to rounding, but for corners, and the end of the run. */
static void time_is_right(const motion *m, uint32_t run, double from, const sight_nearest *nearest)
{
    double error = 4e-15 * slope_size(m, nearest->span, nearest->time);
    long double slope = exact_slope(m, nearest->span, nearest->time);
    if (nearest->is_at_corner) {
        uint32_t next = m->sign > 0.0 ? nearest->span + 1 : nearest->span - 1;
        assert_exact(nearest->time, span_ends(&m->shape->spans[nearest->span], m->sign));
        assert_true(slope <= error);
        assert_true(exact_slope(m, next, nearest->time) >= -error);
        return;
    }
    if (nearest->time > from) assert_true(slope <= error);
    if (nearest->time < run_ends(m->shape, m->sign, run)) assert_true(slope >= -error);
}

static void a_pass_is_at_the_least_value_of_its_run_at(shape_world *w)
{
    for (int k = 0; k < 60; ++k) {
        motion m = motion_draw(w);
        for (uint32_t run = 0; run < m.shape->run_count; ++run) {
            double from = fmax(m.line.start, run_begins(m.shape, m.sign, run));
            if (!(from < run_ends(m.shape, m.sign, run)) || from > m.line.start + 5.0) continue;
            sight_nearest nearest = sight_pass(m.shape, m.sign, &m.line, run, m.line.start, 1);
            sight_nearest rough = sight_pass(m.shape, m.sign, &m.line, run, m.line.start, 0);
            assert_true(nearest.time >= from && nearest.time <= run_ends(m.shape, m.sign, run));
            assert_near(rough.value, nearest.value, 1e-13 * (1.0 + fabs(nearest.value)));
            assert_near(nearest.value, (double)exact_value(&m, nearest.span, nearest.time), 4e-15 * squared_sizes(&m, nearest.span, nearest.time));
            is_least_on_run(&m, run, from, &nearest);
            time_is_right(&m, run, from, &nearest);
        }
    }
}

static void a_pass_is_at_the_least_value_of_its_run(void **state)
{
    (void)state;
    shapes_each(6, 6, SEED, a_pass_is_at_the_least_value_of_its_run_at);
}

/* A depth that is surely a collision, relative to the sizes that meet, and one that surely is a touch. */
#define DEEP 1e-11
#define SHALLOW 3e-15

/* The least clearance over a part of the motion, by sampling and then by thirds around the least sample. */
static double least_clearance(const motion *m, double low, double high)
{
    const int looks = 600;
    double least = INFINITY, best = low, step = (high - low) / looks;
    for (int i = 0; i <= looks; ++i) {
        double found = clearance(m, low + i * step);
        if (found < least) {
            least = found;
            best = low + i * step;
        }
    }
    double a = fmax(low, best - step), b = fmin(high, best + step);
    for (int i = 0; i < 60; ++i) {
        double third = (b - a) / 3.0;
        if (clearance(m, a + third) < clearance(m, b - third)) b -= third;
        else a += third;
    }
    return fmin(least, clearance(m, 0.5 * (a + b)));
}

/* The largest radius during the motion. */
static double largest(const motion *m)
{
    return (double)shape_law(m->shape, m->sign > 0.0 ? m->end : -m->line.start, 0);
}

static int motion_is_blocked(const motion *m, double *hit)
{
    return sight_is_blocked(m->shape, m->sign, &m->line, m->end, SHAPE_NONE, SHAPE_NONE, hit);
}

static void a_motion_is_blocked_when_a_dense_look_says_so_at(shape_world *w)
{
    for (int k = 0; k < 60; ++k) {
        motion m = motion_draw(w);
        double hit = NAN, least = least_clearance(&m, m.line.start, m.end), deep = DEEP * (1.0 + 2.0 * largest(&m));
        int is_blocked = motion_is_blocked(&m, &hit);
        if (least < -deep) assert_true(is_blocked);
        if (least > -SHALLOW) assert_false(is_blocked);
        if (!is_blocked) continue;
        assert_true(hit >= m.line.start && hit <= m.end);
        if (hit > m.line.start) assert_near(clearance(&m, hit), 0.0, deep);
        assert_true(clearance(&m, hit) < 0.0);
        if (hit > m.line.start) assert_true(least_clearance(&m, m.line.start, hit) > -deep);
    }
}

static void a_motion_is_blocked_when_a_dense_look_says_so(void **state)
{
    (void)state;
    shapes_each(30, 6, SEED + 1, a_motion_is_blocked_when_a_dense_look_says_so_at);
}

static void a_place_is_inside_when_it_is_deeper_than_a_touch_at(shape_world *w)
{
    for (int k = 0; k < 200; ++k) {
        motion m = motion_draw(w);
        double depth = -clearance(&m, m.line.start);
        int is_inside = sight_is_inside(m.shape, m.sign, m.line.from, m.line.start);
        if (depth > DEEP * (1.0 + 2.0 * largest(&m))) assert_true(is_inside);
        if (depth < SHALLOW) assert_false(is_inside);
    }
}

static void a_place_is_inside_when_it_is_deeper_than_a_touch(void **state)
{
    (void)state;
    shapes_each(10, 6, SEED + 2, a_place_is_inside_when_it_is_deeper_than_a_touch_at);
}

static growth_shape shape_of(const law_piece *pieces, uint32_t count)
{
    const shape_units plain = {{0.0, 0.0}, 1.0, 1.0, 0.0};
    growth_shape shape;
    geom_law law = {pieces, count};
    tdsp_allocator memory = memory_allocator(NULL);
    assert_int_equal(shape_make(&shape, &memory, point_make(0.0, 0.0), law, plain), TDSP_OK);
    return shape;
}

static void drop(growth_shape *shape)
{
    tdsp_allocator memory = memory_allocator(NULL);
    shape_free(shape, &memory);
}

/* Past the origin at the distance y, from x = -5 at time 0. */
static sight_line passing(double y)
{
    sight_line line = {{-5.0, y}, {1.0, 0.0}, 0.0};
    return line;
}

/* R = c t: the square of the distance from a moving centre is least where (t - 5) = c^2 t, and there y^2 + 25 - 25/(1 - c^2). */
static void the_least_value_at_one_rate_has_its_closed_form(void **state)
{
    (void)state;
    const law_piece cone = {0.0, {0.0, 0.6}, 1};
    growth_shape shape = shape_of(&cone, 1);
    sight_line line = passing(4.0);
    sight_nearest nearest = sight_pass(&shape, 1.0, &line, 0, 0.0, 1);
    assert_near(nearest.time, 5.0 / 0.64, 1e-14);
    assert_near(nearest.value, 16.0 + 25.0 - 25.0 / 0.64, 1e-14);
    drop(&shape);
}

/* 2 to begin with, 3 from 1 on, at rate 1 between: the speed itself, which nobody rides. */
static void the_runs_left_and_met_do_not_stop_who_touches_them(void **state)
{
    (void)state;
    const law_piece pieces[3] = {{0.0, {2.0}, 0}, {1.0, {2.0, 1.0}, 1}, {2.0, {3.0}, 0}};
    growth_shape shape = shape_of(pieces, 3);
    sight_line line = passing(2.0);
    double hit;
    assert_int_equal(shape.run_count, 2);
    assert_int_equal(sight_is_blocked(&shape, 1.0, &line, 10.0, SHAPE_NONE, SHAPE_NONE, &hit), 1);
    assert_near(hit, 5.0 - sqrt(5.0), 1e-11);
    assert_int_equal(sight_is_blocked(&shape, 1.0, &line, 10.0, SHAPE_NONE, 0, &hit), 1);
    assert_int_equal(sight_is_blocked(&shape, 1.0, &line, 10.0, 0, SHAPE_NONE, &hit), 1);
    assert_int_equal(sight_is_blocked(&shape, 1.0, &line, 10.0, SHAPE_NONE, 1, &hit), 0);
    assert_int_equal(sight_is_blocked(&shape, 1.0, &line, 10.0, 1, 0, &hit), 0);
    drop(&shape);
}

static void a_touch_is_no_collision(void **state)
{
    (void)state;
    const law_piece circle = {0.0, {2.0}, 0};
    growth_shape shape = shape_of(&circle, 1);
    double hit;
    sight_line touching = passing(2.0), deeper = passing(2.0 - 1e-10);
    assert_int_equal(sight_is_blocked(&shape, 1.0, &touching, 10.0, SHAPE_NONE, SHAPE_NONE, &hit), 0);
    assert_int_equal(sight_is_blocked(&shape, 1.0, &deeper, 10.0, SHAPE_NONE, SHAPE_NONE, &hit), 1);
    assert_int_equal(sight_is_inside(&shape, 1.0, point_make(0.0, 2.0 - 1e-13), 3.0), 0);
    assert_int_equal(sight_is_inside(&shape, 1.0, point_make(0.0, 2.0 - 1e-11), 3.0), 1);
    drop(&shape);
}

static void backwards_in_time_the_span_before_a_moment_holds(void **state)
{
    (void)state;
    const law_piece pieces[2] = {{0.0, {2.0, 0.5}, 1}, {1.0, {2.5, 0.25}, 1}};
    growth_shape shape = shape_of(pieces, 2);
    assert_int_equal(sight_span_at(&shape, 1.0, 1.0), 1);
    assert_int_equal(sight_span_at(&shape, -1.0, -1.0), 0);
    assert_int_equal(sight_span_at(&shape, -1.0, -1.5), 1);
    assert_exact(sight_rate(&shape, 1.0, 0, 0.5), 0.5);
    assert_exact(sight_rate(&shape, -1.0, 1, -1.5), -0.25);
    assert_exact(run_begins(&shape, -1.0, 0), -INFINITY);
    assert_near(run_ends(&shape, -1.0, 0), 0.0, 0.0);
    drop(&shape);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pass_is_at_the_least_value_of_its_run),
        cmocka_unit_test(a_motion_is_blocked_when_a_dense_look_says_so),
        cmocka_unit_test(a_place_is_inside_when_it_is_deeper_than_a_touch),
        cmocka_unit_test(the_least_value_at_one_rate_has_its_closed_form),
        cmocka_unit_test(the_runs_left_and_met_do_not_stop_who_touches_them),
        cmocka_unit_test(a_touch_is_no_collision),
        cmocka_unit_test(backwards_in_time_the_span_before_a_moment_holds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
