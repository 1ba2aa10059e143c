/* SPDX-License-Identifier: MIT */
/*
 * What the paper leaves to get right (docs/math/gaps.md): for each gap its literal version gives a wrong answer here, and the library the right one.
 *
 * The literal versions are small functions of this file; the search backwards in them is that of support/literal.h, which may not wait. The scenes are
 * those of the chapter.
 */
#include "support/cmocka_all.h"

#include "support/example.h"
#include "support/literal.h"
#include "support/property.h"
#include "tdsp/build.h"
#include "tdsp/table.h"

#define NEAR 1e-9
#define EPSILON 0.01
#define MOST_ROWS 1000

static double literal_backward(const example *e, double by)
{
    return literal_departure(e->journey, e->discs, e->count, by, (literal_rules){LITERAL_NOBODY, 0, 0});
}

/* The last departure through the gap of two-discs.json. */
static double last_through(void)
{
    return 30.0 * sqrt(0.99) - 20.0;
}

/* -------------------------------------------------------------------------------------------------------------- tables */

typedef struct built {
    void *bytes;
    size_t length;
    tdsp_table table;
    tdsp_table_info info;
} built;

static tdsp_status try_build(const example *e, tdsp_guarantee guarantee, tdsp_sampling sampling, built *out)
{
    tdsp_oracle oracle;
    tdsp_build_options options;
    tdsp_build_options_init(&options);
    options.guarantee = guarantee;
    options.sampling = sampling;
    options.epsilon = EPSILON;
    assert_int_equal(tdsp_solver_oracle(e->solver, &oracle), TDSP_OK);
    return tdsp_build(&oracle, &options, NULL, &out->bytes, &out->length, NULL);
}

static built build(const example *e, tdsp_guarantee guarantee, tdsp_sampling sampling)
{
    built b;
    assert_int_equal(try_build(e, guarantee, sampling, &b), TDSP_OK);
    assert_int_equal(tdsp_table_open(&b.table, b.bytes, b.length), TDSP_OK);
    assert_int_equal(tdsp_table_get_info(&b.table, &b.info), TDSP_OK);
    return b;
}

static void built_free(built *b)
{
    tdsp_bytes_free(NULL, b->bytes, b->length);
}

static double row_departure(const built *b, uint64_t row)
{
    tdsp_row found;
    assert_int_equal(tdsp_table_row(&b->table, row, &found), TDSP_OK);
    return found.departure;
}

/* (upper - t) / (lower - t) of a table's answer, which holds the true one. */
static double travel_ratio(const example *e, const built *b, double departure)
{
    double lower, upper;
    const double truth = example_arrival(e, departure);
    assert_int_equal(tdsp_table_arrival(&b->table, departure, &lower, &upper), TDSP_OK);
    assert_true(lower <= truth && truth <= upper);
    return (upper - departure) / (lower - departure);
}

/*
 * Algorithm 1 to the letter: a_i = (1 + eps) a_(i-1) from A(0) on, and b_i by the search backwards, until that finds no departure or `most` rows are
 * there. Returns how many.
 */
typedef struct literal_row {
    double b;
    double a;
} literal_row;

static size_t algorithm_1(const example *e, size_t most, literal_row *rows)
{
    double a = example_arrival(e, 0.0);
    for (size_t i = 0; i < most; i++, a *= 1.0 + EPSILON) {
        rows[i] = (literal_row){literal_backward(e, a), a};
        if (rows[i].b < 0.0) return i;
    }
    return most;
}

/* --------------------------------------------------------------------------------------------------------------- 11.1 jumps */

static void a_search_backwards_that_may_not_wait_leaves_too_early_for_an_arrival_inside_a_jump(void **state)
{
    (void)state;
    example e = example_load("examples/scenes/two-discs.json");
    const double inside[] = {30.0, 30.35, 32.0, 33.0, 33.5};
    for (size_t i = 0; i < sizeof inside / sizeof *inside; i++) {
        assert_near(example_latest(&e, inside[i]), last_through(), NEAR);
        assert_true(literal_backward(&e, inside[i]) < last_through() - 0.05);
    }
    /* Where A is continuous the literal search is right. */
    assert_near(literal_backward(&e, 25.0), example_latest(&e, 25.0), NEAR);
    assert_near(literal_backward(&e, 36.0), example_latest(&e, 36.0), NEAR);
    example_free(&e);
}

static void with_it_algorithm_1_makes_rows_whose_departures_go_back(void **state)
{
    (void)state;
    literal_row rows[MOST_ROWS];
    example e = example_load("examples/scenes/two-discs.json");
    const size_t count = algorithm_1(&e, MOST_ROWS, rows);
    size_t back = 0;
    for (size_t i = 1; i < count; i++) back += rows[i].b < rows[i - 1].b;
    assert_true(back > 0);
    built ours = build(&e, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC);
    for (uint64_t i = 1; i < ours.info.rows; i++) assert_true(row_departure(&ours, i) > row_departure(&ours, i - 1));
    built_free(&ours);
    example_free(&e);
}

/* A departure just after the one of a row that lies inside the jump is told to arrive seconds later than it can. */
static void with_it_algorithm_1_breaks_its_own_guarantee(void **state)
{
    (void)state;
    literal_row rows[MOST_ROWS];
    example e = example_load("examples/scenes/two-discs.json");
    const size_t count = algorithm_1(&e, MOST_ROWS, rows);
    double worst = 1.0;
    for (size_t i = 1; i < count; i++) {
        const double t = rows[i].b + 1e-6;
        if (rows[i - 1].b < rows[i].b && i + 1 < count && t <= rows[i + 1].b)
            worst = fmax(worst, rows[i + 1].a / example_arrival(&e, t));
    }
    assert_true(worst > 1.1);
    built ours = build(&e, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC);
    for (size_t i = 0; i < count; i++) {
        double lower, upper;
        assert_int_equal(tdsp_table_arrival(&ours.table, rows[i].b, &lower, &upper), TDSP_OK);
        assert_true(upper <= (1.0 + EPSILON) * lower);
    }
    built_free(&ours);
    example_free(&e);
}

/* ----------------------------------------------------------------------------------------------------------- 11.2 which row */

/* Rows (b_i, a_i) with the right b_i: which a answers a departure? */
static void only_the_first_row_that_is_not_before_a_departure_answers_it(void **state)
{
    (void)state;
    example e = example_load("examples/scenes/gaps/slow-disc.json");
    double a[40], b[40];
    a[0] = example_arrival(&e, 0.0);
    for (int i = 0; i < 40; i++) {
        if (i > 0) a[i] = (1.0 + EPSILON) * a[i - 1];
        b[i] = example_latest(&e, a[i]);
    }
    for (int i = 1; i + 1 < 40; i++) {
        const double t = b[i - 1] + 0.25 * (b[i] - b[i - 1]), truth = example_arrival(&e, t);
        assert_true(truth <= a[i] && a[i] <= (1.0 + EPSILON) * truth);
        assert_true(a[i - 1] < truth);                   /* the row before it promises what nobody can keep */
        assert_true(a[i + 1] > (1.0 + EPSILON) * truth); /* the row after it breaks the guarantee */
    }
    built ours = build(&e, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC);
    for (uint64_t i = 1; i < ours.info.rows; i++) {
        uint64_t found;
        const double middle = 0.5 * (row_departure(&ours, i - 1) + row_departure(&ours, i));
        assert_int_equal(tdsp_table_find(&ours.table, middle, &found), TDSP_OK);
        assert_int_equal(found, i);
        assert_int_equal(tdsp_table_find(&ours.table, row_departure(&ours, i), &found), TDSP_OK);
        assert_int_equal(found, i);
    }
    built_free(&ours);
    example_free(&e);
}

/* ------------------------------------------------------------------------------------------------------ 11.3 ends of a row */

static void the_arrival_at_a_jump_bounds_no_arrival_after_it(void **state)
{
    (void)state;
    double lower, upper;
    example e = example_load("examples/scenes/two-discs.json");
    const double jump = example_latest(&e, 33.0), after = nextafter(jump, INFINITY) + 1e-9;
    /* Read as A(b) <= A(t) <= (1 + eps) A(b) the claim of a row that starts at the jump fails by a factor of 12. */
    assert_true(example_arrival(&e, after) > (1.0 + 12.0 * EPSILON) * example_arrival(&e, jump));
    built ours = build(&e, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    assert_int_equal(tdsp_table_arrival(&ours.table, after, &lower, &upper), TDSP_OK);
    assert_true(lower <= example_arrival(&e, after) && example_arrival(&e, after) <= upper &&
                upper - after <= (1.0 + EPSILON) * (lower - after));
    built_free(&ours);
    example_free(&e);
}

/* T(b + h) stands above what it should bound from below, however small h is, wherever T rises. */
static void the_travel_time_a_little_later_is_no_lower_bound(void **state)
{
    (void)state;
    example e = example_load("examples/scenes/gaps/slow-disc.json");
    for (double b = 100.0; b < 800.0; b += 100.0) {
        const double h = 1e-3, t = b + 0.25 * h;
        assert_true(example_travel_time(&e, b + h) > example_travel_time(&e, t) + 1e-7);
    }
    built ours = build(&e, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    for (uint64_t i = 0; i + 1 < ours.info.rows; i++) {
        tdsp_row row;
        assert_int_equal(tdsp_table_row(&ours.table, i, &row), TDSP_OK);
        assert_true(row.right <= example_travel_time(&e, nextafter(row.departure, INFINITY)));
    }
    built_free(&ours);
    example_free(&e);
}

/* ------------------------------------------------------------------------------------------------------- 11.4 the guarantee */

static void a_share_of_the_arrival_says_little_of_the_travel_time(void **state)
{
    (void)state;
    literal_row rows[MOST_ROWS];
    example e = example_load("examples/scenes/gaps/slow-disc.json");
    const size_t count = algorithm_1(&e, MOST_ROWS, rows);
    double early = 0.0, late = 0.0;
    for (size_t i = 1; i < count; i++) {
        const double t = rows[i - 1].b + 1e-6, ratio = (rows[i].a - t) / example_travel_time(&e, t);
        if (t < 10.0) early = fmax(early, ratio);
        if (t > 800.0) late = fmax(late, ratio);
    }
    assert_true(early < 1.02 && late > 1.25);
    built arrivals = build(&e, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_ADAPTIVE);
    built travel = build(&e, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    assert_true(travel_ratio(&e, &arrivals, 400.0) > 1.1);
    for (double t = 0.5; t < 869.0; t += 7.0) assert_true(travel_ratio(&e, &travel, t) <= 1.0 + EPSILON);
    built_free(&arrivals);
    built_free(&travel);
    example_free(&e);
}

static void algorithm_1_never_leaves_an_arrival_of_zero(void **state)
{
    (void)state;
    property_case c = {
        .name = "no journey", .count = 1, .journey = {1.0, 0.0, {0.0, 0.0}, {0.0, 0.0}}, .discs = {{{5.0, 0.0}, 1.0, 0.5}}};
    property_prepare(&c);
    example e = {.journey = &c.journey, .discs = c.discs, .count = 1, .solver = c.solver};
    double a = example_arrival(&e, 0.0);
    for (int i = 0; i < 1000; i++) a *= 1.0 + EPSILON;
    assert_exact(a, 0.0);
    assert_near(example_last(&e), 8.0, NEAR);
    built ours;
    assert_int_equal(try_build(&e, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC, &ours), TDSP_NOT_SUPPORTED);
    ours = build(&e, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_ADAPTIVE);
    double lower, upper;
    assert_int_equal(tdsp_table_arrival(&ours.table, 7.5, &lower, &upper), TDSP_OK);
    assert_true(lower == 7.5 && upper == 7.5);
    built_free(&ours);
    property_drop(&c);
}

/* ------------------------------------------------------------------------------------------------------------ 11.5 the end */

static void algorithm_1_leaves_the_last_departures_without_a_row(void **state)
{
    (void)state;
    literal_row rows[MOST_ROWS];
    example e = example_load("examples/scenes/gaps/slow-disc.json");
    const size_t count = algorithm_1(&e, MOST_ROWS, rows);
    const double last = example_last(&e), lost = 0.5 * (rows[count - 1].b + last);
    assert_true(count < MOST_ROWS && rows[count - 1].b < last - 0.1);
    built ours = build(&e, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC);
    assert_exact(ours.info.last_departure, last);
    assert_int_equal(ours.info.last_reason, TDSP_DESTINATION_COVERED);
    assert_true(travel_ratio(&e, &ours, lost) >= 1.0);
    built_free(&ours);
    example_free(&e);
}

static void algorithm_1_never_ends_where_nothing_grows(void **state)
{
    (void)state;
    literal_row rows[MOST_ROWS];
    example e = example_load("examples/scenes/gaps/standing.json");
    assert_int_equal(algorithm_1(&e, MOST_ROWS, rows), MOST_ROWS);
    built ours;
    assert_int_equal(try_build(&e, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC, &ours), TDSP_NEEDS_HORIZON);
    example_free(&e);
}

/* ------------------------------------------------------------------------------------------------------------- 11.7 Lemma 2 */

/* |sd| / V_min, which the last arrival cannot be after when a disc stands across the straight way at departure 0. */
static double lemma_2(const example *e)
{
    double slowest = INFINITY;
    for (size_t i = 0; i < e->count; i++) slowest = fmin(slowest, e->discs[i].growth);
    const tdsp_point s = e->journey->source, d = e->journey->destination;
    return hypot(d.x - s.x, d.y - s.y) / slowest;
}

static void the_upper_bound_of_lemma_2_needs_a_disc_across_the_straight_way(void **state)
{
    (void)state;
    literal_row rows[MOST_ROWS];
    example across = example_load("examples/scenes/gaps/slow-disc.json"),
            aside = example_load("examples/scenes/gaps/far-aside.json");
    assert_true(example_arrival(&across, example_last(&across)) <= lemma_2(&across));
    assert_near(lemma_2(&aside), 2.0, NEAR);
    assert_true(example_last(&aside) > 197.0 && example_arrival(&aside, 197.0) == 198.0);
    /* So log(v / V_min) / log(1 + eps), 70 rows, are not enough by far. */
    assert_true((double)algorithm_1(&aside, MOST_ROWS, rows) > 500.0 && log(lemma_2(&aside)) / log(1.0 + EPSILON) < 70.0);
    built ours = build(&aside, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    assert_int_equal(ours.info.rows, 2);
    assert_exact(ours.info.last_departure, example_last(&aside));
    built_free(&ours);
    example_free(&aside);
    example_free(&across);
}

static void it_says_nothing_where_a_disc_stands(void **state)
{
    (void)state;
    example e = example_load("examples/scenes/gaps/standing.json");
    assert_true(isinf(lemma_2(&e)));
    example_free(&e);
}

/* --------------------------------------------------------------------------------------------------------- 11.10 rounding */

/* Up to the jump the straight way is free, and takes 20 exactly. */
static void bounds_stored_as_they_are_computed_exclude_the_truth(void **state)
{
    (void)state;
    example e = example_load("examples/scenes/two-discs.json");
    int late = 0, early = 0;
    for (double t = 0.1; t < 9.8; t += 0.1) {
        const double sum = t + example_travel_time(&e, 0.0); /* less 20 it is exact: which side of t is it on? */
        late += sum - 20.0 > t;
        early += sum - 20.0 < t;
    }
    assert_true(late > 0 && early > 0); /* wrong as a lower bound, wrong as an upper one */
    built ours = build(&e, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE);
    for (double t = 0.1; t < 9.8; t += 0.1) {
        double lower, upper;
        assert_int_equal(tdsp_table_arrival(&ours.table, t, &lower, &upper), TDSP_OK);
        assert_true(lower - 20.0 <= t && t <= upper - 20.0);
    }
    built_free(&ours);
    example_free(&e);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_search_backwards_that_may_not_wait_leaves_too_early_for_an_arrival_inside_a_jump),
        cmocka_unit_test(with_it_algorithm_1_makes_rows_whose_departures_go_back),
        cmocka_unit_test(with_it_algorithm_1_breaks_its_own_guarantee),
        cmocka_unit_test(only_the_first_row_that_is_not_before_a_departure_answers_it),
        cmocka_unit_test(the_arrival_at_a_jump_bounds_no_arrival_after_it),
        cmocka_unit_test(the_travel_time_a_little_later_is_no_lower_bound),
        cmocka_unit_test(a_share_of_the_arrival_says_little_of_the_travel_time),
        cmocka_unit_test(algorithm_1_never_leaves_an_arrival_of_zero),
        cmocka_unit_test(algorithm_1_leaves_the_last_departures_without_a_row),
        cmocka_unit_test(algorithm_1_never_ends_where_nothing_grows),
        cmocka_unit_test(the_upper_bound_of_lemma_2_needs_a_disc_across_the_straight_way),
        cmocka_unit_test(it_says_nothing_where_a_disc_stands),
        cmocka_unit_test(bounds_stored_as_they_are_computed_exclude_the_truth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
