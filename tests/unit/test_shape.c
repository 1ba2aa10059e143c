/* SPDX-License-Identifier: MIT */
/* Jumps, the gaps behind them, and pieces: known scenes, wrong options, and memory that runs out. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/tight.h"
#include "support/world.h"
#include "tdsp/growth.h"
#include "tdsp/shape.h"

#define V 1.0

static const tdsp_journey across = {V, 0.0, {-10.0, 0.0}, {10.0, 0.0}};
static const tdsp_disc gate[] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}};

/* The corner of the gate's discs slows down to the robot's speed when their radius is 3 / sqrt(0.99). */
static double gate_radius(void)
{
    return 3.0 / sqrt(0.99);
}

static double gate_departure(void)
{
    return 30.0 * sqrt(0.99) - 20.0;
}

static tdsp_shape_options until(double last)
{
    tdsp_shape_options options;
    tdsp_shape_options_init(&options);
    options.until = last;
    return options;
}

static void the_gate_has_one_jump_with_its_gap(void **state)
{
    (void)state;
    world w = world_make(across, gate, 2);
    tdsp_jumps *jumps;
    tdsp_arrival_jump jump;
    assert_int_equal(tdsp_jumps_find(w.solver, NULL, &jumps), TDSP_OK);
    assert_int_equal(tdsp_jumps_count(jumps), 1);
    assert_int_equal(tdsp_jumps_get(jumps, 0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_jumps_get(jumps, 0, &jump), TDSP_OK);
    assert_near(jump.departure, gate_departure(), 1e-9);
    assert_near(jump.travel_before, 20.0, 1e-9);
    assert_near(jump.travel_after, world_arrival(w, jump.departure + 1e-7) - jump.departure - 1e-7, 1e-6);
    assert_exact(jump.size, jump.travel_after - jump.travel_before);
    assert_int_equal(jump.gap.first, 0);
    assert_int_equal(jump.gap.second, 1);
    assert_near(jump.gap.time, (gate_radius() - 1.0) / 0.1, 1e-8);
    assert_near(jump.gap.place.x, 0.1 * gate_radius(), 1e-8);
    assert_near(jump.gap.place.y, 0.0, 1e-8);
    assert_int_equal(tdsp_jumps_get(jumps, 1, &jump), TDSP_INVALID_ARGUMENT);
    tdsp_jumps_free(jumps);
    world_free(w);
}

static size_t jumps_of(world w, tdsp_shape_options options)
{
    tdsp_jumps *jumps;
    assert_int_equal(tdsp_jumps_find(w.solver, &options, &jumps), TDSP_OK);
    size_t count = tdsp_jumps_count(jumps);
    tdsp_jumps_free(jumps);
    return count;
}

static void jumps_are_found_from_and_until_the_departures_asked_for(void **state)
{
    (void)state;
    world w = world_make(across, gate, 2);
    tdsp_shape_options late = until(INFINITY);
    late.from = gate_departure() + 1e-3;
    assert_int_equal(jumps_of(w, until(gate_departure() - 1e-3)), 0);
    assert_int_equal(jumps_of(w, until(gate_departure() + 1e-3)), 1);
    assert_int_equal(jumps_of(w, until(1e9)), 1);
    assert_int_equal(jumps_of(w, late), 0);
    world_free(w);
}

static void a_jump_no_larger_than_asked_for_is_left_out(void **state)
{
    (void)state;
    world w = world_make(across, gate, 2);
    tdsp_shape_options options = until(INFINITY);
    options.least = 3.7;
    assert_int_equal(jumps_of(w, options), 1);
    options.least = 3.8;
    assert_int_equal(jumps_of(w, options), 0);
    world_free(w);
}

static void a_jump_at_the_first_departure_counts(void **state)
{
    (void)state;
    world w = world_make(across, gate, 2);
    tdsp_shape_options options = until(INFINITY);
    assert_int_equal(tdsp_latest_departure(w.solver, 31.0, &options.from, NULL), TDSP_OK);
    assert_int_equal(jumps_of(w, options), 1);
    world_free(w);
}

/* A third disc lies over the place where the corner would become as slow as the robot: no gap event, but a place that is squeezed shut. */
static void a_corner_within_a_third_disc_is_found_by_the_look(void **state)
{
    (void)state;
    const tdsp_disc discs[] = {{{0.0, 3.0}, 1.0, 0.1}, {{0.0, -3.0}, 1.0, 0.1}, {{0.5, 1.2}, 0.1, 0.05}};
    world w = world_make(across, discs, 3);
    tdsp_jumps *jumps;
    tdsp_arrival_jump jump;
    assert_int_equal(tdsp_jumps_find(w.solver, NULL, &jumps), TDSP_OK);
    assert_true(tdsp_jumps_count(jumps) >= 1);
    for (size_t i = 0; tdsp_jumps_get(jumps, i, &jump) == TDSP_OK; i++) {
        assert_true(jump.gap.first < jump.gap.second && jump.gap.second < 3);
        for (int k = 0; k < 2; k++) {
            const tdsp_disc *disc = &discs[k == 0 ? jump.gap.first : jump.gap.second];
            double distance = hypot(jump.gap.place.x - disc->center.x, jump.gap.place.y - disc->center.y);
            assert_near(distance, disc->radius + disc->growth * jump.gap.time, 1e-5);
        }
    }
    tdsp_jumps_free(jumps);
    world_free(w);
}

/* A gate whose discs grow faster and faster: the same questions, another engine. */
static void discs_whose_rates_change_have_jumps_gaps_and_pieces_too(void **state)
{
    (void)state;
    const double powers[] = {0.1, 0.001};
    tdsp_growing_disc discs[2];
    tdsp_scene *scene;
    tdsp_solver *solver;
    tdsp_jumps *jumps;
    tdsp_envelope *envelope;
    tdsp_arrival_jump jump;
    tdsp_piece piece;
    tdsp_shape_options options = until(10.0);
    memset(discs, 0, sizeof discs);
    for (int k = 0; k < 2; k++) {
        discs[k].center.y = k == 0 ? 3.0 : -3.0;
        discs[k].radius = 1.0;
        discs[k].growth.kind = TDSP_GROWTH_POLYNOMIAL;
        discs[k].growth.count = 2;
        discs[k].growth.values = powers;
    }
    assert_int_equal(tdsp_scene_create_growing(&across, discs, 2, NULL, &scene), TDSP_OK);
    assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
    assert_int_equal(tdsp_jumps_find(solver, &options, &jumps), TDSP_OK);
    assert_int_equal(tdsp_jumps_count(jumps), 1);
    assert_int_equal(tdsp_jumps_get(jumps, 0, &jump), TDSP_OK);
    assert_near(jump.travel_before, 20.0, 1e-9);
    assert_int_equal(jump.gap.first, 0);
    assert_int_equal(jump.gap.second, 1);
    /* By symmetry the corner is on the axis, at sqrt(R^2 - 9), and as slow as the robot where R R' is that: a time by halving. */
    double low = 0.0, high = 100.0;
    for (int i = 0; i < 100; i++) {
        const double t = 0.5 * (low + high), radius = 1.0 + 0.1 * t + 0.001 * t * t, rate = 0.1 + 0.002 * t;
        *(radius * radius * (1.0 - rate * rate) < 9.0 ? &low : &high) = t;
    }
    const double radius = 1.0 + 0.1 * low + 0.001 * low * low;
    assert_near(jump.gap.time, low, 1e-4);
    assert_near(jump.gap.place.x, sqrt(radius * radius - 9.0), 1e-3);
    assert_near(jump.departure, low - 10.0 - sqrt(radius * radius - 9.0), 1e-8);
    assert_int_equal(tdsp_envelope_find(solver, &options, &envelope), TDSP_OK);
    assert_int_equal(tdsp_envelope_pieces(envelope), 2);
    assert_int_equal(tdsp_envelope_piece(envelope, 0, &piece), TDSP_OK);
    assert_int_equal(piece.change, TDSP_CHANGE_JUMP);
    assert_near(piece.until, jump.departure, 1e-9);
    tdsp_envelope_free(envelope);
    tdsp_jumps_free(jumps);
    tdsp_solver_free(solver);
    tdsp_scene_free(scene);
}

static void a_departure_without_a_squeeze_or_a_way_has_no_gap(void **state)
{
    (void)state;
    tdsp_gap gap = {5, 6, 7, {8, 9}};
    world w = world_make(across, gate, 2);
    assert_int_equal(tdsp_solver_gap(w.solver, 5.0, &gap), TDSP_NO_ANSWER);
    assert_int_equal(tdsp_solver_gap(w.solver, 1000.0, &gap), TDSP_NO_ANSWER);
    assert_int_equal(tdsp_solver_gap(w.solver, -1.0, &gap), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_gap(w.solver, INFINITY, &gap), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_gap(NULL, 5.0, &gap), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_solver_gap(w.solver, 5.0, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(gap.first, 5);
    world_free(w);
}

/* One disc beside the way: a straight line until it is touched, a ride until the destination is covered. */
static void a_disc_that_grows_into_the_way_makes_a_touch(void **state)
{
    (void)state;
    const tdsp_disc discs[] = {{{0.0, 2.0}, 1.0, 0.05}};
    world w = world_make(across, discs, 1);
    tdsp_envelope *envelope;
    tdsp_piece piece;
    assert_int_equal(tdsp_envelope_find(w.solver, NULL, &envelope), TDSP_OK);
    assert_int_equal(tdsp_envelope_pieces(envelope), 2);
    assert_int_equal(tdsp_envelope_forms(envelope), 2);
    assert_int_equal(tdsp_envelope_piece(envelope, 0, &piece), TDSP_OK);
    assert_int_equal(piece.ride_count, 0);
    assert_null(piece.rides);
    assert_int_equal(piece.change, TDSP_CHANGE_TOUCH);
    assert_exact(piece.from, 0.0);
    /* On the line the disc is nearest, with 2 sin(theta) between, 2 cos(theta) past the foot of the perpendicular. */
    assert_near(piece.until, (2.0 / sqrt(1.0 - 0.0025) - 1.0) / 0.05 - 10.0 - 0.05 * 2.0 / sqrt(1.0 - 0.0025), 1e-5);
    assert_near(piece.travel_until, 20.0, 1e-9);
    double changed = piece.until;
    assert_int_equal(tdsp_envelope_piece(envelope, 1, &piece), TDSP_OK);
    assert_exact(piece.from, changed);
    assert_int_equal(piece.ride_count, 1);
    assert_int_equal(piece.rides[0].disc, 0);
    assert_int_equal(piece.rides[0].turn, 1);
    assert_int_equal(piece.change, TDSP_CHANGE_END);
    assert_int_equal(piece.gap.first, TDSP_NO_DISC);
    assert_int_equal(tdsp_envelope_piece(envelope, 2, &piece), TDSP_INVALID_ARGUMENT);
    tdsp_envelope_free(envelope);
    world_free(w);
}

static void the_gate_has_two_pieces_with_a_jump_between(void **state)
{
    (void)state;
    world w = world_make(across, gate, 2);
    tdsp_envelope *envelope;
    tdsp_piece piece;
    assert_int_equal(tdsp_envelope_find(w.solver, NULL, &envelope), TDSP_OK);
    assert_int_equal(tdsp_envelope_pieces(envelope), 2);
    assert_int_equal(tdsp_envelope_piece(envelope, 0, &piece), TDSP_OK);
    assert_int_equal(piece.change, TDSP_CHANGE_JUMP);
    assert_near(piece.until, gate_departure(), 1e-9);
    assert_int_equal(piece.gap.first, 0);
    assert_int_equal(piece.gap.second, 1);
    tdsp_envelope_free(envelope);
    world_free(w);
}

/* The standing disc is passed on its nearer hand, until the growing one behind it makes the other way as short. */
static void another_way_that_becomes_as_short_makes_a_switch(void **state)
{
    (void)state;
    const tdsp_disc discs[] = {{{-3.0, 0.05}, 1.0, 0.0}, {{3.0, -0.5}, 0.1, 0.02}};
    world w = world_make(across, discs, 2);
    tdsp_envelope *envelope;
    tdsp_piece piece;
    size_t switches = 0;
    tdsp_shape_options options = until(60.0);
    assert_int_equal(tdsp_envelope_find(w.solver, &options, &envelope), TDSP_OK);
    for (size_t i = 0; tdsp_envelope_piece(envelope, i, &piece) == TDSP_OK; i++) switches += piece.change == TDSP_CHANGE_SWITCH;
    assert_int_equal(switches, 1);
    tdsp_envelope_free(envelope);
    world_free(w);
}

static void a_narrow_piece_is_found_with_a_resolution_below_its_width(void **state)
{
    (void)state;
    world w = world_make(across, gate, 2);
    tdsp_envelope *envelope;
    tdsp_shape_options options = until(30.0);
    options.resolution = 0.5;
    assert_int_equal(tdsp_envelope_find(w.solver, &options, &envelope), TDSP_OK);
    assert_exact(tdsp_envelope_resolution(envelope), 0.5);
    assert_int_equal(tdsp_envelope_pieces(envelope), 2);
    tdsp_envelope_free(envelope);
    world_free(w);
}

static void where_nothing_grows_there_is_one_piece_and_no_jump(void **state)
{
    (void)state;
    const tdsp_disc discs[] = {{{0.0, 0.5}, 1.0, 0.0}};
    world w = world_make(across, discs, 1);
    tdsp_envelope *envelope;
    tdsp_shape_options options = until(100.0);
    assert_int_equal(jumps_of(w, options), 0);
    assert_int_equal(tdsp_envelope_find(w.solver, &options, &envelope), TDSP_OK);
    assert_int_equal(tdsp_envelope_pieces(envelope), 1);
    tdsp_envelope_free(envelope);
    world_free(w);
}

typedef tdsp_status (*finder)(tdsp_solver *solver, const tdsp_shape_options *options);

static tdsp_status find_jumps(tdsp_solver *solver, const tdsp_shape_options *options)
{
    tdsp_jumps *jumps = NULL;
    tdsp_status status = tdsp_jumps_find(solver, options, &jumps);
    assert_int_equal(status == TDSP_OK, jumps != NULL);
    tdsp_jumps_free(jumps);
    return status;
}

static tdsp_status find_envelope(tdsp_solver *solver, const tdsp_shape_options *options)
{
    tdsp_envelope *envelope = NULL;
    tdsp_status status = tdsp_envelope_find(solver, options, &envelope);
    assert_int_equal(status == TDSP_OK, envelope != NULL);
    tdsp_envelope_free(envelope);
    return status;
}

static const finder finders[] = {find_jumps, find_envelope};

static int stop(void *ctx, double settled, double all)
{
    int *calls = ctx;
    assert_true(settled >= 0.0 && settled <= all);
    return ++*calls == 3;
}

static void wrong_options_are_refused(void **state)
{
    (void)state;
    world w = world_make(across, gate, 2);
    tdsp_shape_options good = until(20.0);
    for (size_t k = 0; k < 2; k++) {
        tdsp_shape_options bad[10];
        for (size_t i = 0; i < 10; i++) bad[i] = good;
        bad[0].size = 8;
        bad[1].from = -1.0;
        bad[2].from = INFINITY;
        bad[3].from = 21.0;
        bad[4].until = NAN;
        bad[5].least = -1.0;
        bad[6].resolution = NAN;
        bad[7].least = 1e-12;
        bad[8].resolution = INFINITY;
        bad[9].least = INFINITY;
        for (size_t i = 0; i < 10; i++) assert_int_equal(finders[k](w.solver, &bad[i]), TDSP_INVALID_ARGUMENT);
        assert_int_equal(finders[k](NULL, &good), TDSP_INVALID_ARGUMENT);
        assert_int_equal(finders[k](w.solver, &good), TDSP_OK);
    }
    assert_int_equal(tdsp_jumps_find(w.solver, &good, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_envelope_find(w.solver, &good, NULL), TDSP_INVALID_ARGUMENT);
    tdsp_shape_options_init(NULL);
    world_free(w);
}

static void nothing_is_no_list(void **state)
{
    (void)state;
    tdsp_arrival_jump jump;
    tdsp_piece piece;
    assert_int_equal(tdsp_jumps_count(NULL), 0);
    assert_int_equal(tdsp_jumps_get(NULL, 0, &jump), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_envelope_pieces(NULL), 0);
    assert_int_equal(tdsp_envelope_forms(NULL), 0);
    assert_exact(tdsp_envelope_resolution(NULL), 0.0);
    assert_int_equal(tdsp_envelope_piece(NULL, 0, &piece), TDSP_INVALID_ARGUMENT);
    tdsp_jumps_free(NULL);
    tdsp_envelope_free(NULL);
}

static void the_caller_can_stop_it(void **state)
{
    (void)state;
    world w = world_make(across, gate, 2);
    for (size_t k = 0; k < 2; k++) {
        int calls = 0;
        tdsp_shape_options options = until(20.0);
        options.progress = stop;
        options.progress_ctx = &calls;
        assert_int_equal(finders[k](w.solver, &options), TDSP_CANCELLED);
        assert_int_equal(calls, 3);
    }
    world_free(w);
}

static void no_way_and_no_end_are_told(void **state)
{
    (void)state;
    const tdsp_disc prison[] = {{{-10.0, 0.0}, 1.0, 0.0}}, aside[] = {{{0.0, 50.0}, 1.0, 0.0}};
    world closed = world_make(across, prison, 1), open = world_make(across, aside, 1);
    for (size_t k = 0; k < 2; k++) {
        assert_int_equal(finders[k](closed.solver, NULL), TDSP_SOURCE_COVERED);
        assert_int_equal(finders[k](open.solver, NULL), TDSP_NEEDS_HORIZON);
    }
    world_free(closed);
    world_free(open);
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    for (size_t k = 0; k < 2; k++) {
        tight_heap heap = {0};
        tdsp_allocator memory = tight_allocator(&heap);
        tdsp_scene *scene;
        tdsp_solver *solver;
        tdsp_status status = TDSP_NO_MEMORY;
        for (size_t refuse = 1; status != TDSP_OK; refuse++) {
            heap.refuse = 0;
            assert_int_equal(tdsp_scene_create(&across, gate, 2, &memory, &scene), TDSP_OK);
            assert_int_equal(tdsp_solver_create(scene, &solver), TDSP_OK);
            heap.refuse = heap.calls + refuse;
            status = finders[k](solver, NULL);
            assert_true(status == TDSP_OK || status == TDSP_NO_MEMORY);
            tdsp_solver_free(solver);
            tdsp_scene_free(scene);
            assert_int_equal(heap.blocks, 0);
            assert_int_equal(heap.held, 0);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_gate_has_one_jump_with_its_gap),
        cmocka_unit_test(jumps_are_found_from_and_until_the_departures_asked_for),
        cmocka_unit_test(a_jump_no_larger_than_asked_for_is_left_out),
        cmocka_unit_test(a_jump_at_the_first_departure_counts),
        cmocka_unit_test(a_corner_within_a_third_disc_is_found_by_the_look),
        cmocka_unit_test(discs_whose_rates_change_have_jumps_gaps_and_pieces_too),
        cmocka_unit_test(a_departure_without_a_squeeze_or_a_way_has_no_gap),
        cmocka_unit_test(a_disc_that_grows_into_the_way_makes_a_touch),
        cmocka_unit_test(the_gate_has_two_pieces_with_a_jump_between),
        cmocka_unit_test(another_way_that_becomes_as_short_makes_a_switch),
        cmocka_unit_test(a_narrow_piece_is_found_with_a_resolution_below_its_width),
        cmocka_unit_test(where_nothing_grows_there_is_one_piece_and_no_jump),
        cmocka_unit_test(wrong_options_are_refused),
        cmocka_unit_test(nothing_is_no_list),
        cmocka_unit_test(the_caller_can_stop_it),
        cmocka_unit_test(no_way_and_no_end_are_told),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
