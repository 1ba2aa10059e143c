/* SPDX-License-Identifier: MIT */
/*
 * A world without discs or roads: a grid that is flooded cell by cell while mud makes each step slower. The same sampler builds its tables.
 *
 * Entering cell v at time x takes cost_v + mud_v x, and must be over when v is flooded; the way leads from cell to neighbouring cell. Floods stay, mud
 * only deepens: a way for a later departure is one for every earlier departure, which takes no longer. So T never decreases, and the oracle is
 * monotone in travel. Where a flood closes a passage T jumps; between jumps it rises with the mud.
 *
 * The oracle is a label-setting search in both directions; the independent answer relaxes every step of the grid over and over until nothing
 * changes, and inverts that by bisection.
 */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "tdsp/build.h"
#include "tdsp/oracle_check.h"
#include "tdsp/search.h"
#include "tdsp/table.h"

#define WIDTH 6
#define CELLS (WIDTH * WIDTH)
#define GOAL (CELLS - 1)

typedef struct flood {
    uint64_t seed;
    double cost[CELLS], mud[CELLS], flooded[CELLS];
    tdsp_search *search;
    unsigned char settled[CELLS];
    uint32_t previous[CELLS];
    double reached[CELLS]; /* time at each cell settled, in the last forward search */
    double departed;
    tdsp_leg legs[CELLS];
} flood;

/* The neighbours of a cell; returns how many. */
static int neighbours(uint32_t cell, uint32_t found[4])
{
    uint32_t x = cell % WIDTH, y = cell / WIDTH;
    int count = 0;
    if (x > 0) found[count++] = cell - 1;
    if (x + 1 < WIDTH) found[count++] = cell + 1;
    if (y > 0) found[count++] = cell - WIDTH;
    if (y + 1 < WIDTH) found[count++] = cell + WIDTH;
    return count;
}

/* When the step into `cell` that begins at `time` is over; infinite when the cell is flooded first. */
static double step_from(const flood *f, uint32_t cell, double time)
{
    double over = time + (f->cost[cell] + f->mud[cell] * time);
    return over <= f->flooded[cell] ? over : INFINITY;
}

/* When a step into `cell` that is over by `time` must begin. */
static double step_until(const flood *f, uint32_t cell, double time)
{
    return (time - f->cost[cell]) / (1 + f->mud[cell]);
}

/* ------------------------------------------------------------------------------------------------------------ the oracle */

static tdsp_status expand_forward(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    flood *f = ctx;
    uint32_t next[4];
    if (f->settled[label->id]) return TDSP_OK;
    f->settled[label->id] = 1;
    f->previous[label->id] = label->kind;
    f->reached[label->id] = label->time;
    *done = label->id == GOAL;
    for (int i = 0, count = neighbours(label->id, next); i < count && !*done; i++) {
        tdsp_label to = {step_from(f, next[i], label->time), next[i], label->id};
        if (isinf(to.time) || f->settled[next[i]]) continue;
        tdsp_status status = tdsp_search_push(open, &to);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}

/* Labels hold the latest moment in a cell with its sign turned. */
static tdsp_status expand_backward(void *ctx, const tdsp_label *label, tdsp_search *open, int *done)
{
    flood *f = ctx;
    uint32_t next[4];
    if (f->settled[label->id]) return TDSP_OK;
    f->settled[label->id] = 1;
    *done = label->id == 0;
    f->departed = -label->time;
    for (int i = 0, count = neighbours(label->id, next); i < count && !*done; i++) {
        tdsp_label to = {-fmin(step_until(f, label->id, -label->time), f->flooded[next[i]]), next[i], label->id};
        if (f->settled[next[i]] || to.time > 0) continue; /* nobody is anywhere before 0 */
        tdsp_status status = tdsp_search_push(open, &to);
        if (status != TDSP_OK) return status;
    }
    return TDSP_OK;
}

static tdsp_status flood_run(flood *f, uint32_t start, double time, int forward, int *found)
{
    tdsp_search_problem problem = {.size = sizeof problem, .ctx = f, .expand = forward ? expand_forward : expand_backward};
    tdsp_label first = {time, start, start};
    memset(f->settled, 0, sizeof f->settled);
    return tdsp_search_run(f->search, &problem, &first, 1, found);
}

static tdsp_status flood_arrival(void *ctx, double departure, double *arrival)
{
    flood *f = ctx;
    int found = 0;
    if (departure > f->flooded[0]) return TDSP_SOURCE_COVERED;
    tdsp_status status = flood_run(f, 0, departure, 1, &found);
    if (status != TDSP_OK) return status;
    if (!found) return TDSP_CUT_OFF;
    *arrival = f->reached[GOAL];
    return TDSP_OK;
}

static tdsp_status flood_departure(void *ctx, double arrival, double *departure)
{
    flood *f = ctx;
    int found = 0;
    double first = 0;
    tdsp_status status = flood_run(f, GOAL, -fmin(arrival, f->flooded[GOAL]), 0, &found);
    if (status == TDSP_OK && found && f->departed >= 0) {
        *departure = f->departed;
        return TDSP_OK;
    }
    if (status == TDSP_OK) status = flood_arrival(f, 0, &first);
    return status == TDSP_OK ? TDSP_ARRIVAL_TOO_EARLY : status;
}

static tdsp_point center_of(uint32_t cell)
{
    return (tdsp_point){cell % WIDTH, cell / WIDTH};
}

static tdsp_status flood_path(void *ctx, tdsp_oracle_path *out)
{
    flood *f = ctx;
    size_t first = CELLS;
    for (uint32_t cell = GOAL; cell != 0; cell = f->previous[cell]) {
        uint32_t before = f->previous[cell];
        f->legs[--first] = (tdsp_leg){.disc = TDSP_NO_DISC, .start_time = f->reached[before], .end_time = f->reached[cell],
                                      .from = center_of(before), .to = center_of(cell)};
    }
    *out = (tdsp_oracle_path){f->legs + first, CELLS - first, NULL, 0};
    return TDSP_OK;
}

static tdsp_oracle flood_oracle(flood *f)
{
    tdsp_oracle oracle;
    tdsp_oracle_init(&oracle);
    oracle.ctx = f;
    oracle.monotone = TDSP_MONOTONE_TRAVEL;
    oracle.error = 1e-13;
    oracle.time_scale = WIDTH;
    oracle.earliest_arrival = flood_arrival;
    oracle.latest_departure = flood_departure;
    oracle.path = flood_path;
    return oracle;
}

static void flood_make(flood *f, uint64_t seed)
{
    uint64_t chance = seed;
    memset(f, 0, sizeof *f);
    f->seed = seed;
    for (int i = 0; i < CELLS; i++) {
        f->cost[i] = chance_between(&chance, 0.5, 2);
        f->mud[i] = chance_below(&chance, 3) ? chance_between(&chance, 0, 0.02) : 0;
        f->flooded[i] = chance_below(&chance, 5) ? chance_between(&chance, 5, 60) : chance_between(&chance, 0, 10);
    }
    f->flooded[0] = f->flooded[GOAL] = chance_between(&chance, 30, 70);
    assert_int_equal(tdsp_search_create(NULL, &f->search), TDSP_OK);
}

static void flood_holds(int holds, const flood *f, const char *what, double departure, double got, double expected)
{
    if (holds) return;
    print_error("seed %llu: %s at %.17g: %.17g against %.17g\n", (unsigned long long)f->seed, what, departure, got, expected);
    fail();
}

/* ------------------------------------------------------------------------------------------------- the independent answer */

static double relaxed_arrival(const flood *f, double departure)
{
    double at[CELLS];
    for (int i = 0; i < CELLS; i++) at[i] = INFINITY;
    if (departure <= f->flooded[0]) at[0] = departure;
    for (int changed = 1; changed;) {
        changed = 0;
        for (uint32_t cell = 0; cell < CELLS; cell++) {
            uint32_t next[4];
            int count = isinf(at[cell]) ? 0 : neighbours(cell, next);
            for (int i = 0; i < count; i++) {
                double over = step_from(f, next[i], at[cell]);
                if (over >= at[next[i]]) continue;
                at[next[i]] = over;
                changed = 1;
            }
        }
    }
    return at[GOAL];
}

static double relaxed_departure(const flood *f, double arrival)
{
    double low = 0, high = f->flooded[0];
    if (relaxed_arrival(f, high) <= arrival) return high;
    for (int i = 0; i < 100; i++) {
        double middle = (low + high) / 2;
        *(relaxed_arrival(f, middle) <= arrival ? &low : &high) = middle;
    }
    return low;
}

/* ----------------------------------------------------------------------------------------------------------------- tests */

#define SEEDS 60

static void both_searches_find_what_relaxing_finds(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        flood f;
        uint64_t chance = seed;
        flood_make(&f, seed);
        for (int i = 0; i < 50; i++) {
            double departure = chance_between(&chance, 0, 60), arrival = INFINITY, latest = -1;
            (void)flood_arrival(&f, departure, &arrival);
            flood_holds(arrival == relaxed_arrival(&f, departure), &f, "arrival", departure, arrival, relaxed_arrival(&f, departure));
            double a = chance_between(&chance, 0, 80);
            if (flood_departure(&f, a, &latest) != TDSP_OK) continue;
            flood_holds(fabs(latest - relaxed_departure(&f, a)) <= 1e-11, &f, "departure", a, latest, relaxed_departure(&f, a));
        }
        tdsp_search_free(f.search);
    }
}

static void its_oracle_keeps_every_rule(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        flood f;
        tdsp_oracle_findings found;
        flood_make(&f, seed);
        tdsp_oracle oracle = flood_oracle(&f);
        tdsp_status status = tdsp_oracle_check(&oracle, NULL, NULL, &found);
        for (size_t i = 0; status == TDSP_BAD_ORACLE && i < found.count; i++)
            print_error("%s of %s\n", tdsp_oracle_rule_name(found.found[i].rule), tdsp_oracle_callback_name(found.found[i].callback));
        flood_holds(status == TDSP_OK, &f, "a rule is broken", found.found[0].asked, found.found[0].seen, found.found[0].expected);
        tdsp_search_free(f.search);
    }
}

static void table_keeps_its_word(const flood *f, const tdsp_table *table, const tdsp_build_options *options, uint64_t *chance)
{
    for (int i = 0; i < 100; i++) {
        double lower = INFINITY, upper = INFINITY, departure = chance_between(chance, 0, 40), truth = relaxed_arrival(f, departure);
        tdsp_status status = tdsp_table_arrival(table, departure, &lower, &upper);
        flood_holds((status == TDSP_OK) == isfinite(truth), f, tdsp_status_name(status), departure, upper, truth);
        if (status != TDSP_OK) continue;
        flood_holds(lower <= truth && truth <= upper, f, "the interval", departure, lower, truth);
        double most = options->guarantee == TDSP_GUARANTEE_TRAVEL ? departure + (1 + options->epsilon) * (lower - departure)
                                                                  : lower + options->delta;
        flood_holds(upper <= most * (1 + 1e-14), f, "the guarantee", departure, upper, most);
    }
}

/* 1 when there was a table to judge. */
static int build_and_judge(flood *f, const tdsp_build_options *options, int forward_only, uint64_t *chance)
{
    void *bytes = NULL;
    size_t length = 0;
    tdsp_table table;
    tdsp_build_report report;
    tdsp_oracle oracle = flood_oracle(f);
    if (forward_only) oracle.latest_departure = NULL;
    tdsp_status status = tdsp_build(&oracle, options, NULL, &bytes, &length, &report);
    if (isinf(relaxed_arrival(f, 0))) {
        assert_int_equal(status, TDSP_CUT_OFF);
        return 0;
    }
    flood_holds(status == TDSP_OK, f, tdsp_status_name(status), 0, 0, 0);
    flood_holds(fabs(report.last_departure - relaxed_departure(f, 1e9)) <= 1e-10, f, "the end", report.last_departure, 0, 0);
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    table_keeps_its_word(f, &table, options, chance);
    tdsp_bytes_free(NULL, bytes, length);
    return 1;
}

static void the_sampler_builds_tables_that_hold_what_relaxing_finds(void **state)
{
    (void)state;
    int tables = 0;
    for (uint64_t seed = 1; seed <= SEEDS; seed++) {
        flood f;
        uint64_t chance = seed;
        tdsp_build_options options;
        flood_make(&f, seed);
        tdsp_build_options_init(&options);
        options.epsilon = 0.03;
        tables += build_and_judge(&f, &options, seed % 2 == 0, &chance);
        options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
        options.delta = 0.5;
        tables += build_and_judge(&f, &options, seed % 4 < 2, &chance);
        tdsp_search_free(f.search);
    }
    assert_true(tables >= SEEDS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_searches_find_what_relaxing_finds),
        cmocka_unit_test(its_oracle_keeps_every_rule),
        cmocka_unit_test(the_sampler_builds_tables_that_hold_what_relaxing_finds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
