/* SPDX-License-Identifier: MIT */
/* The conformance kit: a mutant for each way of breaking a rule, caught by that rule and by no other; sound oracles of every kind pass. */
#include "support/cmocka_all.h"
#include "support/tight.h"

#include <string.h>

#include "support/mutant_oracles.h"
#include "support/toy_tables.h"
#include "tdsp/oracle_check.h"

#define BIT(rule) (UINT64_C(1) << (rule))

static tdsp_oracle_check_options defaults(void)
{
    tdsp_oracle_check_options options;
    tdsp_oracle_check_options_init(&options);
    return options;
}

static void print_findings(const char *name, const tdsp_oracle_findings *found)
{
    for (size_t i = 0; i < found->count; i++) {
        const tdsp_oracle_finding *f = &found->found[i];
        print_error("%s: %s of %s: %s: asked %.17g answered %.17g other %.17g seen %.17g expected %.17g\n", name,
                    tdsp_oracle_rule_name(f->rule), tdsp_oracle_callback_name(f->callback), tdsp_oracle_finding_text(f), f->asked,
                    f->answered, f->other, f->seen, f->expected);
    }
}

static tdsp_oracle_findings passes(const char *name, const tdsp_oracle *oracle, const tdsp_oracle_check_options *options)
{
    tdsp_oracle_findings found;
    tdsp_status status = tdsp_oracle_check(oracle, options, NULL, &found);
    if (status != TDSP_OK) print_findings(name, &found);
    assert_int_equal(status, TDSP_OK);
    assert_true(found.broken == 0 && found.count == 0 && found.complete);
    return found;
}

/* ---------------------------------------------------------------------------------------------------------- mutants */

static void is_caught(int which, uint64_t seed)
{
    mutant m;
    mutation change;
    tdsp_oracle_findings found;
    mutant_make(&m);
    tdsp_oracle oracle = mutant_sound(&m);
    tdsp_oracle_check_options options = defaults();
    assert_true(mutant_spoil(which, &oracle, &change));
    options.seed = seed;
    options.clock = mutant_clock;
    options.clock_ctx = &m;
    options.seconds = 1;
    tdsp_status status = tdsp_oracle_check(&oracle, &options, NULL, &found);
    int caught = status == TDSP_BAD_ORACLE && found.broken == BIT(change.rule) && found.found[0].callback == change.callback;
    if (!caught) print_findings(change.name, &found);
    if (!caught)
        print_error("%s with seed %u: %s, %llx broken, not only %s\n", change.name, (unsigned)seed, tdsp_status_name(status),
                    (unsigned long long)found.broken, tdsp_oracle_rule_name(change.rule));
    assert_true(caught);
    assert_true(found.times[change.rule] >= found.count && found.count >= 1 && found.count <= TDSP_ORACLE_EXAMPLES);
}

static void each_mutant_is_caught_by_its_rule_and_no_other(void **state)
{
    (void)state;
    mutation change;
    uint64_t caught = 0;
    for (int which = 0;; which++) {
        mutant m;
        mutant_make(&m);
        tdsp_oracle oracle = mutant_sound(&m);
        if (!mutant_spoil(which, &oracle, &change)) break;
        for (uint64_t seed = 1; seed <= 20; seed++) is_caught(which, seed);
        caught |= BIT(change.rule);
    }
    assert_true(caught == BIT(TDSP_ORACLE_RULES) - 1); /* every rule has one */
}

static void the_oracle_that_mutants_are_made_of_passes_every_rule(void **state)
{
    (void)state;
    mutant m;
    mutant_make(&m);
    tdsp_oracle oracle = mutant_sound(&m);
    tdsp_oracle_check_options options = defaults();
    options.clock = mutant_clock;
    options.clock_ctx = &m;
    for (options.seed = 0; options.seed < 200; options.seed++) {
        tdsp_oracle_findings found = passes("sound", &oracle, &options);
        assert_true(found.looked_at == BIT(TDSP_ORACLE_RULES) - 1);
        assert_near(found.last_departure, 30, 1e-12);
    }
}

static tdsp_status breaks_two_at_once(void *ctx, double departure, tdsp_status *reason)
{
    (void)ctx;
    (void)departure;
    *reason = TDSP_HORIZON;
    return TDSP_OK;
}

static tdsp_status forgets_the_path(void *ctx, tdsp_oracle_path *out)
{
    (void)ctx;
    *out = (tdsp_oracle_path){NULL, 1, NULL, 0};
    return TDSP_OK;
}

static void several_rules_are_found_broken_at_once(void **state)
{
    (void)state;
    mutant m;
    tdsp_oracle_findings found;
    mutant_make(&m);
    tdsp_oracle oracle = mutant_sound(&m);
    oracle.last_reason = breaks_two_at_once;
    oracle.path = forgets_the_path;
    oracle.error = NAN;
    assert_int_equal(tdsp_oracle_check(&oracle, NULL, NULL, &found), TDSP_BAD_ORACLE);
    assert_true(found.broken == (BIT(TDSP_RULE_REASON) | BIT(TDSP_RULE_PATH_FORM) | BIT(TDSP_RULE_DECLARED)));
    assert_true(found.times[TDSP_RULE_PATH_FORM] > TDSP_ORACLE_EXAMPLES);
    assert_int_equal(found.count, 1 + 1 + TDSP_ORACLE_EXAMPLES);
}

static tdsp_status dips_between_12_and_14(void *ctx, double departure, double *arrival)
{
    mutant *m = ctx;
    tdsp_status status = m->sound.earliest_arrival(m->sound.ctx, departure, arrival);
    if (departure > 12 && departure < 14) *arrival -= 1.5;
    return status;
}

static void a_finding_says_where_and_what(void **state)
{
    (void)state;
    mutant m;
    tdsp_oracle_findings found;
    mutant_make(&m);
    tdsp_oracle oracle = mutant_sound(&m);
    oracle.earliest_arrival = dips_between_12_and_14;
    oracle.path = NULL;
    assert_int_equal(tdsp_oracle_check(&oracle, NULL, NULL, &found), TDSP_BAD_ORACLE);
    const tdsp_oracle_finding *first = &found.found[0];
    assert_int_equal(first->rule, TDSP_RULE_ORDER);
    assert_true(first->asked > 12 && first->asked < 14 && first->other > 10 && first->other <= 12);
    assert_near(first->expected, (double)toy_value(&m.toy, first->other), 1e-12);
    assert_near(first->seen, (double)toy_value(&m.toy, first->asked) - 1.5, 1e-12);
    assert_true((found.looked_at & BIT(TDSP_RULE_LATE)) == 0); /* nothing is held against a function that is not sound */
}

/* -------------------------------------------------------------------------------------------------------- sound ones */

static void pass_all(const toy_world *worlds, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        for (int kind = 0; kind < 8; kind++) {
            toy t = worlds[i].toy;
            t.legs = kind & 1;
            t.rough = (kind & 2) != 0;
            tdsp_oracle oracle = toy_oracle(&t, (kind & 4) != 0);
            tdsp_oracle_check_options options = defaults();
            options.seed = (uint64_t)kind;
            passes(worlds[i].name, &oracle, &options);
            options.horizon = 7.5;
            passes(worlds[i].name, &oracle, &options);
        }
    }
}

static void sound_toys_of_every_kind_pass(void **state)
{
    (void)state;
    size_t count;
    const toy_world *worlds = toy_worlds(&count);
    pass_all(worlds, count);
    worlds = toy_networks(&count);
    pass_all(worlds, count);
}

static tdsp_status no_way(void *ctx, double departure, double *arrival)
{
    (void)ctx;
    (void)departure;
    *arrival = NAN;
    return TDSP_SOURCE_COVERED;
}

static tdsp_status no_way_back(void *ctx, double arrival, double *departure)
{
    (void)ctx;
    (void)arrival;
    *departure = NAN;
    return TDSP_SOURCE_COVERED;
}

static tdsp_status a_way_back(void *ctx, double arrival, double *departure)
{
    (void)ctx;
    *departure = arrival;
    return TDSP_OK;
}

static void an_oracle_without_any_way_is_sound_when_both_directions_say_so(void **state)
{
    (void)state;
    tdsp_oracle oracle;
    tdsp_oracle_findings found;
    tdsp_oracle_init(&oracle);
    oracle.earliest_arrival = no_way;
    oracle.latest_departure = no_way_back;
    found = passes("no way", &oracle, NULL);
    assert_true(found.last_departure < 0);
    oracle.latest_departure = a_way_back;
    assert_int_equal(tdsp_oracle_check(&oracle, NULL, NULL, &found), TDSP_BAD_ORACLE);
    assert_true(found.broken == BIT(TDSP_RULE_BOTH_WAYS));
}

static tdsp_status refuses_the_last(void *ctx, double arrival, double *departure)
{
    mutant *m = ctx;
    return isinf(arrival) ? TDSP_NOT_SUPPORTED : m->sound.latest_departure(m->sound.ctx, arrival, departure);
}

static tdsp_status shrinks_at_last(void *ctx, double arrival, double after, double before, double *departure, double *arrives)
{
    mutant *m = ctx;
    return isinf(arrival) ? TDSP_SHRINKS
                          : m->sound.latest_departure_between(m->sound.ctx, arrival, after, before, departure, arrives);
}

static tdsp_status refuses_the_late(void *ctx, double arrival, double *departure)
{
    mutant *m = ctx;
    return arrival > 20 ? TDSP_NOT_SUPPORTED : m->sound.latest_departure(m->sound.ctx, arrival, departure);
}

static void only_the_last_departure_of_all_may_be_refused(void **state)
{
    (void)state;
    mutant m;
    tdsp_oracle_findings found;
    mutant_make(&m);
    tdsp_oracle oracle = mutant_sound(&m);
    oracle.latest_departure = refuses_the_last;
    passes("refuses the last", &oracle, NULL);
    oracle.latest_departure_between = shrinks_at_last;
    passes("shrinks at last", &oracle, NULL);
    oracle.latest_departure = refuses_the_late;
    assert_int_equal(tdsp_oracle_check(&oracle, NULL, NULL, &found), TDSP_BAD_ORACLE);
    assert_true(found.broken == BIT(TDSP_RULE_ERROR));
}

/* A journey so long that times end before it does. */
static tdsp_status arrives_at_the_end_of_numbers(void *ctx, double departure, double *arrival)
{
    (void)ctx;
    *arrival = departure + 1e306;
    return TDSP_OK;
}

/* Within the noise of the moment of a jump, and of the end, an answer may be that of either side. */
static tdsp_status wavers_at_jumps(void *ctx, double departure, double *arrival)
{
    mutant *m = ctx;
    const double noise = m->toy.error * (departure + 10);
    double asked = departure;
    for (double jump = 10; jump <= 30; jump += 10)
        if (fabs(departure - jump) < noise) asked = departure < jump ? fmin(jump + noise, 30.5) : jump - noise;
    tdsp_status status = m->sound.earliest_arrival(m->sound.ctx, asked, arrival);
    *arrival += departure - asked;
    return status;
}

static void times_at_the_end_of_numbers_and_sides_that_waver_are_sound(void **state)
{
    (void)state;
    tdsp_oracle endless;
    tdsp_oracle_init(&endless);
    endless.earliest_arrival = arrives_at_the_end_of_numbers;
    passes("end of numbers", &endless, NULL);
    mutant m;
    mutant_make(&m);
    m.toy.error = 1e-3;
    tdsp_oracle oracle;
    tdsp_oracle_init(&oracle);
    oracle.ctx = &m;
    oracle.error = 1e-3;
    oracle.earliest_arrival = wavers_at_jumps;
    (void)mutant_sound(&m);
    tdsp_oracle_check_options options = defaults();
    for (options.seed = 0; options.seed < 40; options.seed++) passes("wavers", &oracle, &options);
}

static void what_is_no_rule_has_a_text_too(void **state)
{
    (void)state;
    const tdsp_oracle_finding odd = {.rule = (tdsp_oracle_rule)99};
    assert_true(strlen(tdsp_oracle_finding_text(&odd)) > 0);
    assert_string_equal(tdsp_oracle_rule_name(odd.rule), "unknown");
}

/* What is wrong with the form of a path is wrong for a builder too: no table holds it. */
static void a_builder_refuses_the_paths_that_the_kit_refuses(void **state)
{
    (void)state;
    mutation change;
    int refused = 0;
    for (int which = 0;; which++) {
        mutant m;
        void *bytes = NULL;
        size_t length;
        mutant_make(&m);
        tdsp_oracle oracle = mutant_sound(&m);
        tdsp_build_options options;
        tdsp_build_options_init(&options);
        if (!mutant_spoil(which, &oracle, &change)) break;
        if (change.rule != TDSP_RULE_PATH_FORM) continue;
        const tdsp_status status = tdsp_build(&oracle, &options, NULL, &bytes, &length, NULL);
        if (status != TDSP_BAD_ORACLE && status != TDSP_BAD_PATH) fail_msg("%s: %s", change.name, tdsp_status_name(status));
        assert_null(bytes);
        refused++;
    }
    assert_true(refused > 20);
}

/* Whenever the calls end: a mutant is accused of what it does or of nothing. */
static void a_limit_of_calls_makes_no_other_rule_look_broken(void **state)
{
    (void)state;
    mutation change;
    for (int which = 0;; which++) {
        mutant m;
        tdsp_oracle_findings found;
        mutant_make(&m);
        tdsp_oracle oracle = mutant_sound(&m);
        if (!mutant_spoil(which, &oracle, &change)) break;
        if (change.rule != TDSP_RULE_LATE && change.rule != TDSP_RULE_BOUNDS && change.rule != TDSP_RULE_ARRIVES) continue;
        tdsp_oracle_check_options options = defaults();
        for (options.calls = 1; options.calls < 1200; options.calls += options.calls < 300 ? 1 : 7) {
            assert_true(tdsp_oracle_check(&oracle, &options, NULL, &found) != TDSP_INVALID_ARGUMENT);
            assert_true((found.broken & ~BIT(change.rule)) == 0);
        }
    }
}

/* ------------------------------------------------------------------------------------------ limits, arguments, memory */

static void calls_are_limited_and_the_findings_say_so(void **state)
{
    (void)state;
    mutant m;
    tdsp_oracle_findings found;
    mutant_make(&m);
    tdsp_oracle oracle = mutant_sound(&m);
    tdsp_oracle_check_options options = defaults();
    for (options.calls = 1; options.calls < 1500; options.calls += 7) {
        assert_int_equal(tdsp_oracle_check(&oracle, &options, NULL, &found), TDSP_OK);
        assert_true(found.calls <= options.calls);
        assert_true(found.complete == (found.calls < options.calls) || found.complete);
    }
    options.calls = 10;
    assert_int_equal(tdsp_oracle_check(&oracle, &options, NULL, &found), TDSP_OK);
    assert_int_equal(found.complete, 0);
    assert_int_equal(found.calls, 10);
}

/* Member by member: between them are bytes that belong to none. */
static void assert_same_finding(const tdsp_oracle_finding *a, const tdsp_oracle_finding *b)
{
    const double numbers[2][5] = {{a->asked, a->answered, a->other, a->seen, a->expected}, {b->asked, b->answered, b->other, b->seen, b->expected}};
    assert_int_equal(a->rule, b->rule);
    assert_int_equal(a->callback, b->callback);
    assert_int_equal(a->status, b->status);
    assert_memory_equal(numbers[0], numbers[1], sizeof numbers[0]);
}

static void the_same_seed_finds_the_same(void **state)
{
    (void)state;
    static tdsp_oracle_findings found[2];
    for (int i = 0; i < 2; i++) {
        mutant m;
        mutant_make(&m);
        tdsp_oracle oracle = mutant_sound(&m);
        oracle.earliest_arrival = dips_between_12_and_14;
        assert_int_equal(tdsp_oracle_check(&oracle, NULL, NULL, &found[i]), TDSP_BAD_ORACLE);
    }
    assert_int_equal(found[0].broken, found[1].broken);
    assert_memory_equal(found[0].times, found[1].times, sizeof found[0].times);
    assert_int_equal(found[0].count, found[1].count);
    assert_int_equal(found[0].calls, found[1].calls);
    for (size_t i = 0; i < found[0].count; i++) assert_same_finding(&found[0].found[i], &found[1].found[i]);
}

static void bad_arguments_are_refused(void **state)
{
    (void)state;
    mutant m;
    tdsp_oracle_findings found;
    tdsp_allocator empty = {NULL, NULL};
    mutant_make(&m);
    tdsp_oracle oracle = mutant_sound(&m);
    tdsp_oracle_check_options options = defaults();
    assert_int_equal(tdsp_oracle_check(NULL, &options, NULL, &found), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_oracle_check(&oracle, &options, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_oracle_check(&oracle, &options, &empty, &found), TDSP_INVALID_ARGUMENT);
#define REFUSED(change)                                                                                                          \
    do {                                                                                                                         \
        options = defaults();                                                                                                    \
        options.change;                                                                                                          \
        assert_int_equal(tdsp_oracle_check(&oracle, &options, NULL, &found), TDSP_INVALID_ARGUMENT);                             \
    } while (0)
    REFUSED(size = 3);
    REFUSED(horizon = -1);
    REFUSED(horizon = NAN);
    REFUSED(departures = 1);
    REFUSED(departures = 1000001);
    REFUSED(calls = 0);
    REFUSED(seconds = -1);
    REFUSED(seconds = NAN);
    assert_int_equal(m.toy.forward_calls, 0);
    tdsp_oracle_check_options_init(NULL);
}

static void without_memory_nothing_is_handed_out_and_nothing_leaks(void **state)
{
    (void)state;
    tdsp_status status = TDSP_NO_MEMORY;
    for (size_t refuse = 1; status == TDSP_NO_MEMORY; refuse++) {
        mutant m;
        tight_heap heap = {.refuse = refuse};
        tdsp_allocator allocator = tight_allocator(&heap);
        tdsp_oracle_findings found = {.calls = 77};
        mutant_make(&m);
        tdsp_oracle oracle = mutant_sound(&m);
        status = tdsp_oracle_check(&oracle, NULL, &allocator, &found);
        assert_true(status == TDSP_OK || (status == TDSP_NO_MEMORY && found.calls == 77));
        assert_true(refuse > 1 || status == TDSP_NO_MEMORY);
        assert_int_equal(heap.blocks, 0);
        assert_int_equal(heap.held, 0);
    }
    assert_int_equal(status, TDSP_OK);
}

static void names_and_sentences_are_there_for_every_rule(void **state)
{
    (void)state;
    for (int rule = 0; rule < TDSP_ORACLE_RULES; rule++) {
        tdsp_oracle_finding finding = {.rule = (tdsp_oracle_rule)rule};
        assert_string_not_equal(tdsp_oracle_rule_name((tdsp_oracle_rule)rule), "unknown");
        assert_string_not_equal(tdsp_oracle_finding_text(&finding), "unknown");
    }
    for (int callback = 0; callback <= TDSP_ORACLE_LATEST_DEPARTURE_BETWEEN; callback++)
        assert_string_not_equal(tdsp_oracle_callback_name((tdsp_oracle_callback)callback), "unknown");
    assert_string_equal(tdsp_oracle_rule_name((tdsp_oracle_rule)TDSP_ORACLE_RULES), "unknown");
    assert_string_equal(tdsp_oracle_callback_name((tdsp_oracle_callback)99), "unknown");
    assert_string_equal(tdsp_oracle_finding_text(NULL), "unknown");
    assert_true(TDSP_ORACLE_FINDINGS >= TDSP_ORACLE_RULES * TDSP_ORACLE_EXAMPLES);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_mutant_is_caught_by_its_rule_and_no_other),
        cmocka_unit_test(the_oracle_that_mutants_are_made_of_passes_every_rule),
        cmocka_unit_test(several_rules_are_found_broken_at_once),
        cmocka_unit_test(a_finding_says_where_and_what),
        cmocka_unit_test(sound_toys_of_every_kind_pass),
        cmocka_unit_test(an_oracle_without_any_way_is_sound_when_both_directions_say_so),
        cmocka_unit_test(only_the_last_departure_of_all_may_be_refused),
        cmocka_unit_test(times_at_the_end_of_numbers_and_sides_that_waver_are_sound),
        cmocka_unit_test(what_is_no_rule_has_a_text_too),
        cmocka_unit_test(a_builder_refuses_the_paths_that_the_kit_refuses),
        cmocka_unit_test(a_limit_of_calls_makes_no_other_rule_look_broken),
        cmocka_unit_test(calls_are_limited_and_the_findings_say_so),
        cmocka_unit_test(the_same_seed_finds_the_same),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(without_memory_nothing_is_handed_out_and_nothing_leaks),
        cmocka_unit_test(names_and_sentences_are_there_for_every_rule),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
