/* SPDX-License-Identifier: MIT */
/* Who may be met at all: the discs above the laws, the index over them, and what a chunk's legs can see, against every law looked at. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "geom/angle.h"
#include "growth/ahead.h"
#include "support/shapes.h"

#define SEED 5202

static const double signs[2] = {1.0, -1.0};

/* Everything is a member, seen between 0 and `until`. */
static growth_engine *engine_of(shape_world *w, double sign, double until)
{
    growth_engine *engine = &w->growth->engine;
    for (uint32_t i = 0; i < engine->shape_count; ++i) engine->members[i] = i;
    engine->member_count = engine->shape_count;
    engine->question.sign = sign;
    engine->question.explain = 0;
    engine->question.goal = point_make(chance_between(&w->chance, -1.0, 1.0), chance_between(&w->chance, -1.0, 1.0));
    engine->limit = engine->question.limit = sign > 0.0 ? until : 0.0;
    reach_question ask = {engine->shapes, engine->members, engine->member_count, sign, 0.0, until};
    assert_int_equal(reach_build(&engine->reach, &engine->allocator, &ask), TDSP_OK);
    reach_limit(&engine->reach, engine->question.goal, engine->limit);
    return engine;
}

static void check_above(shape_world *w)
{
    for (int s = 0; s < 2; ++s) {
        double until = chance_between(&w->chance, 0.01, 4.0);
        const growth_reach *reach = &engine_of(w, signs[s], until)->reach;
        for (uint32_t i = 0; i < reach->count; ++i)
            for (int k = 0; k <= 100; ++k) {
                double time = until * k / 100.0;
                assert_true(disc_radius(&reach->discs[i], signs[s] * time) > shape_radius(&w->shapes[reach->given[i]], time));
            }
    }
}

static void laws_lie_below_the_discs_above_them(void **state)
{
    (void)state;
    shapes_each(10, 10, SEED, check_above);
}

static int visit_mark(void *ctx, uint32_t shape)
{
    ((int *)ctx)[shape] = 1;
    return 1;
}

static void check_line(shape_world *w, const growth_engine *engine, const sight_line *line, double end)
{
    int *met = calloc(engine->shape_count, sizeof *met);
    double hit;
    reach_line(&engine->reach, line, end, visit_mark, met);
    for (uint32_t i = 0; i < engine->shape_count; ++i)
        if (!met[i]) assert_false(sight_is_blocked(&w->shapes[i], engine->question.sign, line, end, SHAPE_NONE, SHAPE_NONE, &hit));
    free(met);
}

static void check_lines(shape_world *w)
{
    for (int s = 0; s < 2; ++s) {
        growth_engine *engine = engine_of(w, signs[s], 2.0);
        for (int k = 0; k < 200; ++k) {
            double a = chance_between(&w->chance, 0.0, 2.5), b = chance_between(&w->chance, 0.0, 2.5);
            sight_line line = {point_make(chance_between(&w->chance, -1.0, 1.0), chance_between(&w->chance, -1.0, 1.0)),
                               point_unit(chance_between(&w->chance, 0.0, GEOM_TURN)), signs[s] > 0.0 ? fmin(a, b) : -fmax(a, b)};
            check_line(w, engine, &line, line.start + fabs(a - b));
        }
    }
}

static void nothing_that_stops_a_motion_is_left_out(void **state)
{
    (void)state;
    shapes_each(10, GROWTH_MOST_DISCS, SEED + 1000, check_lines);
}

/* A chunk of a ride somewhere; 0 where nobody can ride. */
static int chunk_draw(shape_world *w, growth_engine *engine, double until, growth_ride *ride, growth_chunk *chunk)
{
    uint32_t disc = (uint32_t)chance_below(&w->chance, engine->shape_count);
    growth_shape *shape = &engine->shapes[disc];
    double sign = engine->question.sign, time = sign * chance_between(&w->chance, 0.0, until);
    growth_moment start = {sight_span_at(shape, sign, time), 0, time, 0.0};
    growth_ride made = {.disc = disc, .run = shape->spans[start.span].run, .side = chance_below(&w->chance, 2) ? 1 : -1, .start = start, .now = start};
    if (made.run == SHAPE_NONE) return 0;
    made.normal = chance_between(&w->chance, 0.0, GEOM_TURN);
    assert_int_equal(shape_measure(shape, &engine->allocator, made.run), TDSP_OK);
    *ride = made;
    if (!rider_next_chunk(shape, sign, ride, chunk)) return 0;
    chunk->to = fmin(chunk->to, engine->limit);
    return chunk->to > chunk->from;
}

/* What is met in time is in the list, no sooner than said; where it is hidden another disc stops who goes there. */
static void check_meeting(const growth_engine *engine, const ahead_view *view, const sight_line *line, const growth_ahead *found, uint32_t disc, int hidden)
{
    double time, sooner, sign = engine->question.sign;
    if (!sight_is_blocked(&engine->shapes[disc], sign, line, engine->limit, SHAPE_NONE, SHAPE_NONE, &time)) return;
    if (time + point_distance(sight_place(line, time), engine->question.goal) > engine->limit - 1e-12) return;
    assert_non_null(found);
    assert_true(time - line->start >= found->nearest - 1e-12);
    double heading = atan2(point_cross(view->middle, line->unit), point_dot(view->middle, line->unit));
    assert_true(fabs(angle_wrap(heading - found->direction)) <= found->window + 1e-9);
    if (!hidden) return;
    int stopped = 0;
    for (uint32_t i = 0; i < engine->shape_count && !stopped; ++i)
        stopped = i != disc && &engine->shapes[i] != view->chunk->shape &&
                  sight_is_blocked(&engine->shapes[i], sign, line, time, SHAPE_NONE, SHAPE_NONE, &sooner);
    assert_true(stopped);
}

static int hidden_count;

static void check_chunk(shape_world *w, growth_engine *engine, const growth_chunk *chunk)
{
    growth_moment first = chunk_moment(chunk, chunk->from), last = chunk_moment(chunk, chunk->to);
    const sight_line ends[2] = {rider_leaves(chunk->shape, chunk->sign, chunk->ride, &first), rider_leaves(chunk->shape, chunk->sign, chunk->ride, &last)};
    ahead_view view = ahead_look(chunk, ends);
    const growth_ahead **found = calloc(engine->shape_count, sizeof *found);
    int *hidden = calloc(engine->shape_count, sizeof *hidden);
    assert_int_equal(ahead_list(engine, &view), TDSP_OK);
    for (size_t i = 0; i < engine->ahead_count; ++i) {
        const growth_ahead *ahead = &engine->ahead[i];
        uint32_t disc = engine->reach.given[ahead->place];
        found[disc] = ahead;
        hidden[disc] = ahead_ends(&view, ahead) || ahead_hides(&view, ahead);
        hidden_count += hidden[disc];
        if (&engine->shapes[disc] != chunk->shape) ahead_cover(&view, ahead, &engine->shapes[disc]);
    }
    for (int k = 0; k <= 10; ++k) {
        growth_moment moment = chunk_moment(chunk, chunk->from + (chunk->to - chunk->from) * k / 10.0);
        sight_line line = rider_leaves(chunk->shape, chunk->sign, chunk->ride, &moment);
        for (uint32_t i = 0; i < engine->shape_count; ++i)
            if (&w->shapes[i] != chunk->shape) check_meeting(engine, &view, &line, found[i], i, hidden[i]);
    }
    free(found);
    free(hidden);
}

static void check_chunks(shape_world *w)
{
    for (int s = 0; s < 2; ++s) {
        growth_engine *engine = engine_of(w, signs[s], 3.0);
        for (int k = 0; k < 60; ++k) {
            growth_ride ride;
            growth_chunk chunk;
            if (chunk_draw(w, engine, 2.0, &ride, &chunk)) check_chunk(w, engine, &chunk);
        }
    }
}

static void what_a_chunk_does_not_look_at_nobody_meets_who_leaves_it(void **state)
{
    (void)state;
    hidden_count = 0;
    shapes_each(12, GROWTH_MOST_DISCS, SEED + 2000, check_chunks);
    assert_true(hidden_count > 100);
}

typedef struct visits {
    uint32_t count, stop_at;
} visits;

static int visit_count(void *ctx, uint32_t shape)
{
    visits *v = ctx;
    (void)shape;
    return ++v->count != v->stop_at;
}

/* Those near a far place in a moment of travel, which are none, or all where the moment is not within the window. */
static uint32_t visits_at(growth_engine *engine, double sign, double time, uint32_t stop_at)
{
    visits v = {0, stop_at};
    double from = sign > 0.0 ? time : -time;
    reach_near(&engine->reach, point_make(1e6, 1e6), 0.01, from, from, visit_count, &v);
    return v.count;
}

static void check_window(shape_world *w)
{
    for (int s = 0; s < 2; ++s) {
        growth_engine *engine = engine_of(w, signs[s], 2.0);
        const reach_question ask = {engine->shapes, engine->members, engine->member_count, signs[s], 0.5, 2.0};
        const uint32_t all = engine->member_count;
        assert_int_equal(reach_build(&engine->reach, &engine->allocator, &ask), TDSP_OK);
        reach_limit(&engine->reach, engine->question.goal, engine->limit);
        assert_int_equal(visits_at(engine, signs[s], 1.0, 0), 0);
        assert_int_equal(visits_at(engine, signs[s], 0.25, 0), all);
        assert_int_equal(visits_at(engine, signs[s], 3.0, 0), all);
        assert_int_equal(visits_at(engine, signs[s], 3.0, 1), 1);
    }
}

static void beyond_its_window_everything_is_looked_at_until_that_is_enough(void **state)
{
    (void)state;
    shapes_each(4, 8, SEED + 3000, check_window);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(laws_lie_below_the_discs_above_them),
        cmocka_unit_test(nothing_that_stops_a_motion_is_left_out),
        cmocka_unit_test(beyond_its_window_everything_is_looked_at_until_that_is_enough),
        cmocka_unit_test(what_a_chunk_does_not_look_at_nobody_meets_who_leaves_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
