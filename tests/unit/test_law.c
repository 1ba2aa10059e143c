/* SPDX-License-Identifier: MIT */
/* Growth laws as pieces: which piece holds, and its radius, rate and bend. */
#include "support/cmocka_all.h"

#include "geom/law.h"
#include "support/chance.h"

#define SEED 20261

static void the_piece_that_holds_is_the_last_that_has_begun(void **state)
{
    (void)state;
    uint64_t chance = SEED;
    law_piece pieces[40];
    print_message("seed %d\n", SEED);
    for (uint32_t count = 1; count <= 40; ++count) {
        double start = 0.0;
        for (uint32_t i = 0; i < count; ++i) {
            law_piece piece = {start, {0.0}, 0};
            pieces[i] = piece;
            start += chance_between(&chance, 1e-3, 1.0);
        }
        geom_law law = {pieces, count};
        for (uint32_t i = 0; i < count; ++i) {
            assert_int_equal(law_piece_at(&law, pieces[i].start), i);
            if (i) assert_int_equal(law_piece_at(&law, nextafter(pieces[i].start, 0.0)), i - 1);
        }
        assert_int_equal(law_piece_at(&law, INFINITY), count - 1);
        assert_int_equal(law_piece_at(&law, -1.0), 0);
    }
}

static void a_jet_is_the_polynomial_and_its_derivatives(void **state)
{
    (void)state;
    uint64_t chance = SEED + 1;
    for (int k = 0; k < 5000; ++k) {
        law_piece piece = {chance_between(&chance, -2.0, 2.0), {0.0}, (uint32_t)chance_below(&chance, LAW_DEGREE + 1)};
        double time = piece.start + chance_between(&chance, -1.0, 1.0), u = time - piece.start, radius = 0.0, rate = 0.0, bend = 0.0;
        for (uint32_t i = 0; i <= piece.degree; ++i) {
            piece.c[i] = chance_between(&chance, -1.0, 1.0);
            radius += piece.c[i] * pow(u, i);
            if (i > 0) rate += piece.c[i] * i * pow(u, i - 1.0);
            if (i > 1) bend += piece.c[i] * i * (i - 1.0) * pow(u, i - 2.0);
        }
        law_jet jet = law_piece_jet(&piece, time);
        assert_near(jet.radius, radius, 1e-14);
        assert_near(jet.rate, rate, 1e-13);
        assert_near(jet.bend, bend, 1e-12);
    }
}

/* By halving. */
static double halved_until(const geom_law *law, double radius)
{
    double lo = 0.0, hi = 1e12;
    if (law->pieces[0].c[0] > radius) return -1.0;
    if (law_piece_jet(&law->pieces[law_piece_at(law, hi)], hi).radius <= radius) return INFINITY;
    for (int k = 0; k < 200; ++k) {
        double middle = 0.5 * (lo + hi);
        *(law_piece_jet(&law->pieces[law_piece_at(law, middle)], middle).radius <= radius ? &lo : &hi) = middle;
    }
    return lo;
}

/* Pieces with coefficients that are not negative; some are flat. */
static uint32_t draw_pieces(uint64_t *chance, law_piece *pieces, uint32_t most)
{
    uint32_t count = 1 + (uint32_t)chance_below(chance, most);
    double start = 0.0, radius = chance_unit(chance);
    for (uint32_t i = 0; i < count; ++i) {
        law_piece piece = {start, {radius}, (uint32_t)chance_below(chance, LAW_DEGREE + 1)};
        for (uint32_t k = 1; k <= piece.degree; ++k) piece.c[k] = chance_between(chance, 0.1, 1.0);
        pieces[i] = piece;
        start += chance_between(chance, 0.1, 1.0);
        radius = law_piece_jet(&piece, start).radius;
    }
    return count;
}

static void a_law_is_within_a_radius_until_it_reaches_it(void **state)
{
    (void)state;
    uint64_t chance = SEED + 2;
    for (int k = 0; k < 5000; ++k) {
        law_piece pieces[6];
        geom_law law = {pieces, draw_pieces(&chance, pieces, 6)};
        double radius = chance_below(&chance, 4) ? chance_between(&chance, 0.0, 5.0) : pieces[chance_below(&chance, law.count)].c[0];
        double expected = halved_until(&law, radius), found = law_within_until(&law, radius);
        if (isinf(expected)) assert_exact(found, expected);
        else assert_near(found, expected, 1e-14 * (1.0 + fabs(expected)));
    }
}

/* A radius that the first piece reaches at its very end, and the next one begins with a little more by rounding. */
static void a_radius_reached_where_a_piece_ends_is_kept_until_there(void **state)
{
    (void)state;
    const double reached = 1.0 + 0.25;
    law_piece pieces[] = {{0.0, {1.0, 0.25}, 1}, {1.0, {nextafter(reached, 2.0), 1.0}, 1}};
    geom_law law = {pieces, 2};
    assert_exact(law_within_until(&law, reached), 1.0);
}

/* What the last piece says has to do with it only when it is that piece which holds. */
static void a_radius_at_which_a_law_rests_is_kept_until_it_grows_on(void **state)
{
    (void)state;
    law_piece pieces[] = {{0.0, {1.0}, 0}, {5.0, {nextafter(1.0, 2.0), 1.0}, 1}};
    geom_law law = {pieces, 2};
    assert_exact(law_within_until(&law, 1.0), 5.0);
    law.count = 1;
    assert_exact(law_within_until(&law, 1.0), INFINITY);
}

/* A radius that falls, by a coefficient below rounding, at 3.4e204: until then it is one piece. It was taken to cover a place at 1 at 9e50. */
static void a_radius_is_reached_early_in_a_piece_however_long_it_is(void **state)
{
    (void)state;
    for (double end = 1e2; end < 1e205; end *= 1e3) {
        law_piece pieces[] = {{0.0, {0.0, 0.1, 5.1, -1e-204}, 3}, {end, {1e200, 1.0}, 1}};
        geom_law law = {pieces, 2};
        for (double radius = 1e-200; radius < 1e3; radius *= 1e3) {
            double reached = 2.0 * radius / (0.1 + sqrt(0.01 + 20.4 * radius));
            assert_near(law_within_until(&law, radius), reached, 1e-14 * reached);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_piece_that_holds_is_the_last_that_has_begun),
        cmocka_unit_test(a_jet_is_the_polynomial_and_its_derivatives),
        cmocka_unit_test(a_law_is_within_a_radius_until_it_reaches_it),
        cmocka_unit_test(a_radius_reached_where_a_piece_ends_is_kept_until_there),
        cmocka_unit_test(a_radius_at_which_a_law_rests_is_kept_until_it_grows_on),
        cmocka_unit_test(a_radius_is_reached_early_in_a_piece_however_long_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
