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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_piece_that_holds_is_the_last_that_has_begun),
        cmocka_unit_test(a_jet_is_the_polynomial_and_its_derivatives),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
