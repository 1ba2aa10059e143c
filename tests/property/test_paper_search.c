/* SPDX-License-Identifier: MIT */
/*
 * What the paper's search leaves to get right (docs/math/gaps.md): each rule in its careless form, as support/literal.h has it, gives a wrong
 * answer here, and the library the right one. The scenes are those of the chapter, and a real one where $TDSP_DATA (or ../shared/data) has it.
 */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "support/chance.h"
#include "support/example.h"
#include "support/literal.h"
#include "support/property.h"

#define NEAR 1e-9

static const literal_rules right = {LITERAL_NOBODY, 0, 0};

static double literal_forward(const example *e, double departure, literal_rules rules)
{
    return literal_arrival(e->journey, e->discs, e->count, departure, rules);
}

static double literal_backward(const example *e, double by, literal_rules rules)
{
    return literal_departure(e->journey, e->discs, e->count, by, rules);
}

/* --------------------------------------------------------------------------------------------- the literal search itself */

static void forward_is_right(property_case *c)
{
    for (int i = 0; i < 2; i++) {
        const double t = i == 0 ? 0.0 : c->unit * chance_between(&c->chance, 0.0, 0.8);
        const double expected = property_arrival(c, t);
        if (!(expected < INFINITY)) return;
        const double found = literal_arrival(&c->journey, c->discs, c->count, t, right);
        property_relates(c, fabs(found - expected), <=, 1e-8 * (c->unit + expected - t));
    }
}

static void with_the_right_rules_it_finds_the_earliest_arrival(void **state)
{
    (void)state;
    property_each(12, 6, forward_is_right);
}

/* Backwards it is right for an arrival that is A(t): no jump is in the way then. A source on a boundary is left by no tangent. */
static void backward_is_right(property_case *c)
{
    const double t = c->unit * chance_between(&c->chance, 0.01, 0.6), by = property_arrival(c, t);
    if (!(by < INFINITY)) return;
    const double found = literal_departure(&c->journey, c->discs, c->count, by, right);
    property_relates(c, fabs(found - t), <=, 1e-7 * (c->unit + by - t));
}

static void backwards_it_undoes_the_arrival(void **state)
{
    (void)state;
    property_each(12, 6, backward_is_right);
}

/* ------------------------------------------------------------------------------------------- 11.6 edges that are not FIFO */

static const literal_rules settle_first = {.settling = LITERAL_FIRST};

static void a_departure_point_settled_by_whoever_comes_first_loses_the_path(void **state)
{
    (void)state;
    example e = example_load("examples/scenes/gaps/settled-too-soon.json");
    for (double t = 0.0; t < 0.115; t += 0.01) {
        const double found = example_agreed_arrival(&e, t);
        assert_true(found < 12.8);
        assert_near(literal_forward(&e, t, right), found, NEAR * found);
        assert_true(isinf(literal_forward(&e, t, settle_first)));
    }
    example_free(&e);
}

/* Backwards in time: who passes the departure point first has the longer way left to the source, and is there last. */
static void so_does_one_settled_by_whose_tangent_is_free_first(void **state)
{
    (void)state;
    const literal_rules settle_free = {.settling = LITERAL_FREE};
    example e = example_load("examples/scenes/gaps/first-to-leave.json");
    const double by = example_agreed_arrival(&e, 5.0);
    assert_near(example_latest(&e, by), 5.0, NEAR);
    assert_near(literal_backward(&e, by, right), 5.0, NEAR);
    assert_near(literal_backward(&e, by, settle_free), 4.6230162, 1e-7);
    example_free(&e);
}

static void so_it_does_in_a_real_scene(void **state)
{
    (void)state;
    const char *named = getenv("TDSP_DATA"), *directory = named && *named ? named : "../shared/data";
    char *path = g_build_filename(directory, "scenes", "sdd-nexus-video5-f1021-n34-measured.json", NULL);
    if (g_file_test(path, G_FILE_TEST_EXISTS)) {
        example e = example_load(path);
        const double t = 0.05514210235695719;
        assert_near(example_arrival(&e, t), 9.06225906726848, NEAR);
        assert_near(literal_forward(&e, t, right), 9.06225906726848, NEAR);
        assert_true(isinf(literal_forward(&e, t, settle_first)));
        example_free(&e);
    } else {
        print_message("%s is not there: the made scene stands for it\n", path);
    }
    g_free(path);
}

/* -------------------------------------------------------------------------------------------------------- 11.8 both roots */

static const literal_rules one_root = {.first_root_only = 1};

static void without_the_second_root_the_search_backwards_misses_the_source(void **state)
{
    (void)state;
    example e = example_load("examples/scenes/gaps/close-to-the-source.json");
    for (double t = 0.5; t < 2.0; t += 0.25) {
        const double by = example_agreed_arrival(&e, t);
        assert_near(example_latest(&e, by), t, 1e-8);
        assert_near(literal_backward(&e, by, right), t, 1e-8);
        assert_true(literal_backward(&e, by, one_root) < 0.0);
    }
    example_free(&e);
}

static void without_it_the_search_forwards_misses_a_disc_that_comes_out_of_another(void **state)
{
    (void)state;
    example e = example_load("examples/scenes/gaps/emerging.json");
    const double found = example_agreed_arrival(&e, 0.0);
    assert_near(literal_forward(&e, 0.0, right), found, NEAR);
    assert_true(literal_forward(&e, 0.0, one_root) > found + 3.0);
    example_free(&e);
}

/* ------------------------------------------------------------------------------------------------------- 11.9 one centre */

static void without_legs_between_discs_about_one_centre_there_is_no_path(void **state)
{
    (void)state;
    const literal_rules general = {.no_concentric = 1};
    example e = example_load("examples/scenes/gaps/one-centre.json");
    for (double t = 0.0; t <= 2.5; t += 0.5) {
        const double found = example_agreed_arrival(&e, t);
        assert_near(literal_forward(&e, t, right), found, NEAR * found);
        assert_true(isinf(literal_forward(&e, t, general)));
    }
    example_free(&e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(with_the_right_rules_it_finds_the_earliest_arrival),
        cmocka_unit_test(backwards_it_undoes_the_arrival),
        cmocka_unit_test(a_departure_point_settled_by_whoever_comes_first_loses_the_path),
        cmocka_unit_test(so_does_one_settled_by_whose_tangent_is_free_first),
        cmocka_unit_test(so_it_does_in_a_real_scene),
        cmocka_unit_test(without_the_second_root_the_search_backwards_misses_the_source),
        cmocka_unit_test(without_it_the_search_forwards_misses_a_disc_that_comes_out_of_another),
        cmocka_unit_test(without_legs_between_discs_about_one_centre_there_is_no_path),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
