/* SPDX-License-Identifier: MIT */
/* Riders followed chunk by chunk: on the boundary, at speed 1, along their heading; and how far they are free, against a dense look. */
#include "support/cmocka_all.h"

#include "growth/ride.h"
#include "support/shapes.h"

#define SEED 4205

/* Chunks of a ride that are looked at. */
#define CHUNKS 40

/* A ride that begins anywhere on a run, in either direction of time; 0 where the disc has none. */
static int ride_draw(shape_world *w, double *sign, growth_ride *ride)
{
    uint64_t *chance = &w->chance;
    growth_engine *engine = &w->growth->engine;
    uint32_t disc = (uint32_t)chance_below(chance, engine->shape_count);
    growth_shape *shape = &engine->shapes[disc];
    if (shape->run_count == 0) return 0;
    *sign = chance_below(chance, 2) ? 1.0 : -1.0;
    uint32_t run = (uint32_t)chance_below(chance, shape->run_count), length = shape->runs[run].last - shape->runs[run].first + 1;
    uint32_t span = shape->runs[run].first + (uint32_t)chance_below(chance, length);
    double to = fmin(shape->spans[span].to, shape->spans[span].from + 3.0);
    growth_ride drawn = {.disc = disc, .run = run, .side = chance_below(chance, 2) ? 1 : -1, .leg = GROWTH_NONE};
    drawn.normal = chance_between(chance, 0.0, GEOM_TURN);
    drawn.start.span = span;
    drawn.start.time = *sign * chance_between(chance, shape->spans[span].from, to);
    drawn.now = drawn.start;
    *ride = drawn;
    assert_int_equal(shape_measure(shape, &engine->allocator, run), TDSP_OK);
    return 1;
}

static tdsp_point place_at(const growth_chunk *chunk, double at)
{
    growth_moment moment = chunk_moment(chunk, at);
    return rider_place(chunk->shape, chunk->sign, chunk->ride, &moment);
}

static double heading_at(const growth_chunk *chunk, double at)
{
    growth_moment moment = chunk_moment(chunk, at);
    return rider_heading(chunk->shape, chunk->sign, chunk->ride, &moment);
}

/* The place's derivative, by differences, is the unit vector of the heading. */
static void rider_moves_along_its_heading(const growth_chunk *chunk)
{
    double width = chunk->to - chunk->from, step = 1e-3 * width;
    for (int i = 1; i < 8 && width > 1e-7 * (1.0 + fabs(chunk->from)); ++i) {
        double at = chunk->from + width * i / 8.0, error = 1e-4 + 1e-14 * (1.0 + fabs(at)) / step;
        tdsp_point moved = point_scale(0.5 / step, point_sub(place_at(chunk, at + step), place_at(chunk, at - step))), unit = point_unit(heading_at(chunk, at));
        assert_near(moved.x, unit.x, error);
        assert_near(moved.y, unit.y, error);
    }
}

static void chunk_is_right(const growth_chunk *chunk)
{
    double first = heading_at(chunk, chunk->from), last = heading_at(chunk, chunk->to), before = first;
    assert_true(chunk->to >= chunk->from);
    assert_true(fabs(last - first) <= 0.4 + 1e-9);
    for (int i = 0; i <= 8; ++i) {
        double at = i == 8 ? chunk->to : chunk->from + (chunk->to - chunk->from) * i / 8.0, heading = heading_at(chunk, at);
        double time = chunk->sign * chunk_moment(chunk, at).time, radius = (double)shape_law(chunk->shape, time, 0);
        assert_near(shape_clearance(chunk->shape, place_at(chunk, at), time), 0.0, 1e-12 * (1.0 + radius));
        assert_true(chunk->ride->side * (heading - before) >= -1e-7); /* one way only; theta loses half its digits at the robot's speed */
        before = heading;
    }
    if (!chunk->base.in_fan) rider_moves_along_its_heading(chunk);
}

typedef void (*chunk_check)(shape_world *w, const growth_chunk *chunk);

static void follow(shape_world *w, chunk_check check)
{
    for (int k = 0; k < 12; ++k) {
        double sign;
        growth_ride ride;
        growth_chunk chunk;
        if (!ride_draw(w, &sign, &ride)) continue;
        const growth_shape *shape = &w->shapes[ride.disc];
        for (int i = 0; i < CHUNKS && rider_next_chunk(shape, sign, &ride, &chunk); ++i) {
            check(w, &chunk);
            growth_moment after = rider_after(&chunk, &ride.is_over);
            assert_near(rider_heading(shape, sign, &ride, &after), heading_at(&chunk, chunk.to), 1e-4); /* laws by callback join so far */
            assert_exact(after.time, chunk_moment(&chunk, chunk.to).time);
            ride.now = after;
            if (rider_turned(shape, sign, &ride, &after) > GEOM_TURN) break;
        }
    }
}

static void check_motion(shape_world *w, const growth_chunk *chunk)
{
    (void)w;
    chunk_is_right(chunk);
}

static void follow_motion(shape_world *w)
{
    follow(w, check_motion);
}

static void a_rider_keeps_to_the_boundary_at_speed_1_along_its_heading(void **state)
{
    (void)state;
    shapes_each(5, 6, SEED, follow_motion);
}

/* Deeper than this, of the sizes, is a collision, and less than that none. */
#define DEEP 1e-11
#define SHALLOW 1e-15

static double clearance_at(const growth_chunk *chunk, const growth_shape *other, double at)
{
    return shape_clearance(other, place_at(chunk, at), chunk->sign * at);
}

static int contacts; /* seen by the test under way */

static void check_contact(shape_world *w, const growth_chunk *chunk)
{
    const int looks = 150;
    for (uint32_t i = 0; i < w->growth->engine.shape_count && !chunk->base.in_fan; ++i) {
        const growth_shape *other = &w->shapes[i];
        const ride_meeting meeting = ride_meets(chunk, other);
        int hit = meeting.is_stopped;
        double until = meeting.free_until, deep = DEEP * (2.0 + point_distance(other->center, place_at(chunk, chunk->from)));
        if (other == chunk->shape) assert_int_equal(hit, 0);
        if (other == chunk->shape) continue;
        assert_true(until >= chunk->from && until <= chunk->to);
        contacts += hit && until > chunk->from;
        if (!hit) assert_exact(until, chunk->to);
        if (hit && until > chunk->from) assert_near(clearance_at(chunk, other, until), 0.0, deep);
        if (hit && until == chunk->from) assert_true(clearance_at(chunk, other, until) < SHALLOW);
        for (int k = 0; k <= looks; ++k) {
            double at = chunk->from + (until - chunk->from) * k / looks;
            if (hit && at >= until) break;
            assert_true(clearance_at(chunk, other, at) > -deep);
        }
    }
}

static void follow_contact(shape_world *w)
{
    follow(w, check_contact);
}

static void a_ride_is_free_until_a_dense_look_says_so(void **state)
{
    (void)state;
    contacts = 0;
    shapes_each(3, 6, SEED + 1, follow_contact);
    assert_true(contacts > 50);
}

/* Round the origin at rate 0, from the x axis on: a quarter of a turn after pi/2 radii. */
static void a_chunk_passes_in_front_of_a_place_when_it_has_turned_so_far(void **state)
{
    (void)state;
    const shape_units plain = {{0.0, 0.0}, 1.0, 1.0, 0.0};
    const law_piece circle = {0.0, {2.0}, 0};
    geom_law law = {&circle, 1};
    tdsp_allocator memory = memory_allocator(NULL);
    growth_shape shape;
    assert_int_equal(shape_make(&shape, &memory, point_make(0.0, 0.0), law, plain), TDSP_OK);
    assert_int_equal(shape_measure(&shape, &memory, 0), TDSP_OK);
    for (int side = -1; side <= 1; side += 2) {
        growth_ride ride = {.side = side};
        growth_chunk chunk = {&shape, &ride, 1.0, ride.start, 0.5, 4.0};
        double at;
        assert_int_equal(rider_passes(&chunk, point_make(0.0, 7.0 * side), &at), 1);
        assert_near(at, GEOM_PI, 1e-14);
        assert_int_equal(rider_passes(&chunk, point_make(5.0, 0.1 * side), &at), 0);
        assert_int_equal(rider_passes(&chunk, point_make(0.0, -7.0 * side), &at), 0);
    }
    shape_free(&shape, &memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rider_keeps_to_the_boundary_at_speed_1_along_its_heading),
        cmocka_unit_test(a_ride_is_free_until_a_dense_look_says_so),
        cmocka_unit_test(a_chunk_passes_in_front_of_a_place_when_it_has_turned_so_far),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
