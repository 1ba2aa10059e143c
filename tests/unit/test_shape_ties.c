/* SPDX-License-Identifier: MIT */
/* Pieces where ways are equally long and discs are touched at the same departure: rounding decides, and must not show. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "support/world.h"
#include "tdsp/shape.h"

#define LAST 30.0

/* A scene on an axis through the origin, turned by an angle, so that no coordinate is exact. */
typedef struct axis {
    double x, y;
} axis;

static axis axis_of(uint64_t *chance)
{
    const double angle = chance_between(chance, 0.0, 6.28);
    return (axis){cos(angle), sin(angle)};
}

static tdsp_point turned(axis a, double x, double y)
{
    return (tdsp_point){x * a.x - y * a.y, x * a.y + y * a.x};
}

static world world_on(axis a, const tdsp_disc discs[2])
{
    const tdsp_journey journey = {1.0, 0.0, turned(a, -10.0, 0.0), turned(a, 10.0, 0.0)};
    const tdsp_disc moved[2] = {{turned(a, discs[0].center.x, discs[0].center.y), discs[0].radius, discs[0].growth},
                                {turned(a, discs[1].center.x, discs[1].center.y), discs[1].radius, discs[1].growth}};
    return world_make(journey, moved, 2);
}

static tdsp_envelope *envelope_of(world w)
{
    tdsp_envelope *envelope;
    tdsp_shape_options options;
    tdsp_shape_options_init(&options);
    options.until = LAST;
    assert_int_equal(tdsp_envelope_find(w.solver, &options, &envelope), TDSP_OK);
    return envelope;
}

static tdsp_piece piece_at(const tdsp_envelope *envelope, size_t i)
{
    tdsp_piece piece;
    assert_int_equal(tdsp_envelope_piece(envelope, i, &piece), TDSP_OK);
    return piece;
}

/*
 * The pieces follow each other without a hole, T at their ends is that of the scene which is not turned, and the two sides of the axis come in turn: no piece
 * has the form of the one before it.
 */
static void ways_that_mirror_each_other_take_turns_without_a_hole(void **state)
{
    (void)state;
    const uint64_t seeds[2] = {3, 18};
    for (int k = 0; k < 2; k++) {
        uint64_t chance = seeds[k];
        const axis straight = {1.0, 0.0}, a = axis_of(&chance);
        const double y = chance_between(&chance, 0.0, 3.0), x = chance_between(&chance, -4.0, 4.0);
        const double radius = chance_between(&chance, 0.5, 1.5), growth = chance_between(&chance, 0.02, 0.2);
        const tdsp_disc discs[2] = {{{x, y}, radius, growth}, {{x, -y}, radius, growth}};
        world w = world_on(a, discs), plain = world_on(straight, discs);
        tdsp_envelope *envelope = envelope_of(w);
        const size_t count = tdsp_envelope_pieces(envelope);
        assert_int_equal(tdsp_envelope_piece(envelope, 0, NULL), TDSP_INVALID_ARGUMENT);
        assert_true(count > 1);
        for (size_t i = 0; i < count; i++) {
            const tdsp_piece piece = piece_at(envelope, i);
            assert_near(piece.travel_until, world_arrival(plain, piece.until) - piece.until, 1e-8);
            if (i == 0) continue;
            const tdsp_piece before = piece_at(envelope, i - 1);
            assert_exact(piece.from, before.until);
            assert_true(piece.form != before.form);
        }
        tdsp_envelope_free(envelope);
        world_free(w);
        world_free(plain);
    }
}

/*
 * A line is touched by a disc at a distance h where the disc has the radius R = h / sqrt(1 - V^2) and is V R behind the robot's foot: for the departure
 * h sqrt(1 - V^2) / V - radius / V - 10 - x. Two discs on either side have their radii chosen so that this is 7 for both.
 */
static void two_discs_that_touch_the_way_at_the_same_departure_make_one_change(void **state)
{
    (void)state;
    const uint64_t seeds[2] = {4, 10};
    for (int k = 0; k < 2; k++) {
        uint64_t chance = seeds[k];
        const axis a = axis_of(&chance);
        const double h = chance_between(&chance, 3.0, 4.0), x = chance_between(&chance, -4.0, 0.0),
                     growth = chance_between(&chance, 0.05, 0.1);
        tdsp_disc discs[2] = {{{x, h}, 0.0, growth}, {{x + 2.0, -h}, 0.0, growth}};
        for (int i = 0; i < 2; i++) discs[i].radius = h * sqrt(1.0 - growth * growth) - growth * (17.0 + discs[i].center.x);
        world w = world_on(a, discs);
        tdsp_envelope *envelope = envelope_of(w);
        const tdsp_piece first = piece_at(envelope, 0), second = piece_at(envelope, 1);
        assert_int_equal(first.ride_count, 0);
        assert_near(first.until, 7.0, 1e-6);
        assert_int_equal(first.change, TDSP_CHANGE_TOUCH);
        assert_int_equal(second.ride_count, 2);
        tdsp_envelope_free(envelope);
        world_free(w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ways_that_mirror_each_other_take_turns_without_a_hole),
        cmocka_unit_test(two_discs_that_touch_the_way_at_the_same_departure_make_one_change),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
