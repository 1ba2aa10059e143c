/* SPDX-License-Identifier: MIT */
/*
 * The road network of the examples, as it is shown: its own source is part of this test, with its main() renamed.
 *
 * The independent answer is brute force: every simple path from source to destination, each road entered when the one before is left. In a FIFO
 * network neither waiting nor a circle ever helps, so the best of them is A(t). Random networks have plateaus (slopes of -1), jumps,
 * steep jams, roads in both directions and several between two places; times are multiples of 1/64, so that what is a plateau is one to the bit.
 */
#include "support/cmocka_all.h"

#define main road_network_main
#include "../../examples/c/road_network.c"
#undef main

#include "support/chance.h"

#define MOST_PLACES 7
#define MOST_ROADS 22
#define MOST_POINTS 8
#define DAY 64.0 /* profiles change up to here */

typedef struct random_town {
    uint64_t seed;
    uint32_t places, count;
    profile_point points[MOST_ROADS][MOST_POINTS];
    road roads[MOST_ROADS];
    network network;
} random_town;

/* ---------------------------------------------------------------------------------------------------------- brute force */

typedef struct walk {
    const network *n;
    uint32_t count;
    unsigned char visited[MOST_PLACES + 1];
    double best;
    uint64_t paths;
} walk;

static void walk_on(walk *w, uint32_t place, double time)
{
    if (place == w->n->destination) {
        w->best = fmin(w->best, time);
        w->paths++;
        return;
    }
    w->visited[place] = 1;
    for (uint32_t i = 0; i < w->count; i++) {
        const road *r = &w->n->roads[i];
        if (r->from == place && !w->visited[r->to]) walk_on(w, r->to, road_arrival(r, time));
    }
    w->visited[place] = 0;
}

/* Infinite without a way. */
static double brute_arrival(const network *n, uint32_t count, double departure)
{
    walk w = {.n = n, .count = count, .best = INFINITY};
    walk_on(&w, n->source, departure);
    return w.best;
}

/* --------------------------------------------------------------------------------------------------------- random towns */

static double chance_grid(uint64_t *chance, double low, double high)
{
    return floor(chance_between(chance, low, high) * 64) / 64;
}

/* Arrivals that never fall: a plateau, a jump, a jam or an ordinary slope from each point to the next. */
static uint32_t random_profile(uint64_t *chance, profile_point *p)
{
    uint32_t points = 1 + (uint32_t)chance_below(chance, MOST_POINTS);
    p[0] = (profile_point){chance_grid(chance, 0, DAY / 4), chance_grid(chance, 0, 10)};
    for (uint32_t i = 1; i < points; i++) {
        uint64_t kind = chance_below(chance, 4);
        double later = kind == 1 ? 0 : chance_grid(chance, 0.1, DAY / MOST_POINTS);
        double slower = kind == 0 ? 0 : kind == 1 ? chance_grid(chance, 0.1, 8) : later * (kind == 2 ? 3 : 0.5);
        p[i].time = p[i - 1].time + later;
        p[i].minutes = point_arrival(&p[i - 1]) + floor(slower * 64) / 64 - p[i].time;
        if (p[i].minutes < 0) p[i].minutes = 0; /* nobody leaves before he enters */
    }
    return points;
}

static void random_town_make(random_town *t, uint64_t seed)
{
    uint64_t chance = seed;
    char message[200];
    memset(t, 0, sizeof *t);
    t->seed = seed;
    t->places = 2 + (uint32_t)chance_below(&chance, MOST_PLACES - 1);
    t->count = t->places + (uint32_t)chance_below(&chance, MOST_ROADS - MOST_PLACES);
    for (uint32_t i = 0; i < t->count; i++) {
        road *r = &t->roads[i];
        r->profile = t->points[i];
        r->points = random_profile(&chance, t->points[i]);
        r->from = i + 1 < t->places ? i : (uint32_t)chance_below(&chance, t->places); /* a chain, so that there is a way */
        r->to = i + 1 < t->places ? i + 1 : (uint32_t)chance_below(&chance, t->places);
    }
    if (!network_make(&t->network, t->places, t->roads, t->count, message, sizeof message)) {
        print_error("seed %llu: %s\n", (unsigned long long)seed, message);
        fail();
    }
}

static void town_holds(int holds, const random_town *t, const char *what, double departure, double got, double expected)
{
    if (holds) return;
    print_error("seed %llu, %u places, %u roads: %s at %.17g: %.17g against %.17g\n", (unsigned long long)t->seed, t->places, t->count,
                what, departure, got, expected);
    fail();
}

/* A departure: at random, or at, just before or just after a point of a profile. */
static double choose_departure(const random_town *t, uint64_t *chance)
{
    uint64_t kind = chance_below(chance, 4);
    if (kind == 0) return chance_between(chance, 0, 1.5 * DAY);
    const road *r = &t->roads[chance_below(chance, t->count)];
    double time = r->profile[chance_below(chance, r->points)].time;
    return fmax(time + ((double)kind - 2) * 1e-5, 0);
}

static double arrival_of(random_town *t, double departure)
{
    double arrival = NAN;
    assert_int_equal(earliest_arrival(&t->network, departure, &arrival), TDSP_OK);
    return arrival;
}

/* ---------------------------------------------------------------------------------------------------------------- tests */

static void the_town_of_the_example_is_searched_as_brute_force_has_it(void **state)
{
    (void)state;
    char message[200];
    network n;
    assert_true(network_make(&n, PLACES, town, ROADS, message, sizeof message));
    for (double t = 0; t < 300; t += 0.0625) {
        double arrival = NAN;
        assert_int_equal(earliest_arrival(&n, t, &arrival), TDSP_OK);
        assert_near(arrival, brute_arrival(&n, ROADS, t), 1e-11);
    }
    network_free(&n);
}

static void searches_of_random_networks_find_what_brute_force_finds(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 300; seed++) {
        random_town t;
        uint64_t chance = seed;
        random_town_make(&t, seed);
        for (int i = 0; i < 40; i++) {
            double departure = choose_departure(&t, &chance);
            double found = arrival_of(&t, departure), best = brute_arrival(&t.network, t.count, departure);
            town_holds(fabs(found - best) <= 1e-11, &t, "arrival", departure, found, best);
        }
        network_free(&t.network);
    }
}

static void oracles_of_random_networks_keep_every_rule(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 300; seed++) {
        random_town t;
        tdsp_oracle_findings found;
        random_town_make(&t, seed);
        tdsp_oracle oracle = oracle_over(&t.network);
        tdsp_status status = tdsp_oracle_check(&oracle, NULL, NULL, &found);
        for (size_t i = 0; status == TDSP_BAD_ORACLE && i < found.count; i++)
            print_error("%s of %s\n", tdsp_oracle_rule_name(found.found[i].rule), tdsp_oracle_callback_name(found.found[i].callback));
        town_holds(status == TDSP_OK, &t, "a rule is broken", found.found[0].asked, found.found[0].seen, found.found[0].expected);
        network_free(&t.network);
    }
}

/* Who takes the row's route, leaving when the row does, arrives in time. */
static void route_serves(const random_town *t, const tdsp_table *table, double departure)
{
    const void *bytes = NULL;
    size_t count = 0;
    uint64_t row = 0;
    double upper = 0;
    tdsp_row stored;
    assert_int_equal(tdsp_table_find(table, departure, &row), TDSP_OK);
    assert_int_equal(tdsp_table_row_bytes(table, row, &bytes, &count), TDSP_OK);
    assert_int_equal(tdsp_table_row(table, row, &stored), TDSP_OK);
    assert_int_equal(tdsp_table_arrival(table, departure, NULL, &upper), TDSP_OK);
    const unsigned char *places = bytes;
    double time = stored.departure;
    for (size_t i = 0; i + 3 < count; i += 2) {
        uint32_t from = places[i] + 256u * places[i + 1], to = places[i + 2] + 256u * places[i + 3];
        double best = INFINITY;
        for (uint32_t k = 0; k < t->count; k++)
            if (t->roads[k].from == from && t->roads[k].to == to) best = fmin(best, road_arrival(&t->roads[k], time));
        time = best;
    }
    town_holds(count >= 2 && places[count - 2] == t->network.destination, t, "the route's end", departure, (double)count, 2);
    town_holds(stored.departure >= departure && time <= upper, t, "the route's arrival", departure, time, upper);
}

static void table_keeps_its_word(const random_town *t, const tdsp_table *table, const tdsp_build_options *options, uint64_t *chance)
{
    for (int i = 0; i < 60; i++) {
        double lower = 0, upper = 0, departure = choose_departure(t, chance);
        double truth = brute_arrival(&t->network, t->count, departure);
        assert_int_equal(tdsp_table_arrival(table, departure, &lower, &upper), TDSP_OK);
        town_holds(lower <= truth, t, "lower", departure, lower, truth);
        town_holds(truth <= upper, t, "upper", departure, upper, truth);
        double most = options->guarantee == TDSP_GUARANTEE_ABSOLUTE ? lower + options->delta : (1 + options->epsilon) * lower;
        town_holds(upper <= most * (1 + 1e-14), t, "the guarantee", departure, upper, most);
        if (i % 6 == 0) route_serves(t, table, departure);
    }
}

static void latest_departures_keep_their_word(const random_town *t, const tdsp_table *table, uint64_t *chance)
{
    for (int i = 0; i < 10; i++) {
        double departure = 0, latest = 0, a = brute_arrival(&t->network, t->count, chance_between(chance, 0, DAY)) + chance_unit(chance);
        if (tdsp_table_departure(table, a, &departure, &latest) != TDSP_OK) continue;
        town_holds(brute_arrival(&t->network, t->count, departure) <= a, t, "a latest departure", a, departure, latest);
        double after = latest + 1e-6;
        if (after < 1.5 * DAY) town_holds(brute_arrival(&t->network, t->count, after) > a, t, "a later departure", a, after, latest);
    }
}

static void build_and_judge(random_town *t, const tdsp_build_options *options, int forward_only, uint64_t *chance)
{
    void *bytes = NULL;
    size_t length = 0;
    tdsp_table table;
    tdsp_oracle oracle = oracle_over(&t->network);
    if (forward_only) oracle.latest_departure = NULL;
    tdsp_status status = tdsp_build(&oracle, options, NULL, &bytes, &length, NULL);
    town_holds(status == TDSP_OK, t, tdsp_status_name(status), 0, 0, 0);
    assert_int_equal(tdsp_table_open(&table, bytes, length), TDSP_OK);
    table_keeps_its_word(t, &table, options, chance);
    latest_departures_keep_their_word(t, &table, chance);
    tdsp_bytes_free(NULL, bytes, length);
}

static void tables_of_random_networks_hold_what_brute_force_finds(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 80; seed++) {
        random_town t;
        uint64_t chance = seed;
        tdsp_build_options options;
        random_town_make(&t, seed);
        tdsp_build_options_init(&options);
        options.horizon = 1.5 * DAY;
        options.guarantee = TDSP_GUARANTEE_ABSOLUTE;
        options.delta = 0.5;
        build_and_judge(&t, &options, seed % 2 == 0, &chance);
        options.guarantee = TDSP_GUARANTEE_ARRIVAL;
        options.epsilon = 0.03;
        if (arrival_of(&t, 0) > 1) build_and_judge(&t, &options, seed % 4 < 2, &chance);
        network_free(&t.network);
    }
}

static void is_refused(const road *roads, uint32_t count, const char *expected)
{
    char message[200] = "";
    network n;
    assert_int_equal(network_make(&n, 3, roads, count, message, sizeof message), 0);
    assert_string_equal(message, expected);
}

static void networks_that_are_not_fifo_are_refused_with_the_road_and_the_reason(void **state)
{
    (void)state;
    static const profile_point fine[] = {{0, 5}, {5, 0}}, steep[] = {{0, 5}, {4, 0}}, down[] = {{3, 5}, {3, 4}}, back[] = {{3, 5}, {2, 9}};
    static const profile_point negative[] = {{3, -1}}, nowhere[] = {{NAN, 1}};
    const road overtaking[] = {ROAD(0, 1, fine), ROAD(1, 2, steep)}, falling[] = {ROAD(0, 1, down)}, turned[] = {ROAD(0, 1, back)};
    const road early[] = {ROAD(0, 1, negative)}, lost[] = {ROAD(0, 1, nowhere)}, empty[] = {{0, 1, fine, 0}}, outside[] = {ROAD(0, 3, fine)};
    is_refused(overtaking, 2, "road 1 from 1 to 2 is not FIFO: who enters at 0 arrives at 5, who enters at 4 overtakes and arrives at 4");
    is_refused(falling, 1, "road 0 from 0 to 1 is not FIFO: who enters at 3 arrives at 8, who enters at 3 overtakes and arrives at 7");
    is_refused(turned, 1, "road 0 from 0 to 1: its times run back from 3 (arriving at 8) to 2 (arriving at 11)");
    is_refused(early, 1, "road 0 from 0 to 1: point 0 is -1 minutes at 3");
    is_refused(lost, 1, "road 0 from 0 to 1: point 0 is 1 minutes at nan");
    is_refused(empty, 1, "road 0 from 0 to 1 has no profile");
    is_refused(outside, 1, "road 0 from 0 to 3: there are only 3 places");
}

static void a_destination_that_no_road_leads_to_is_unreachable_both_ways(void **state)
{
    (void)state;
    static const profile_point fine[] = {{0, 5}};
    const road away[] = {ROAD(2, 0, fine), ROAD(0, 1, fine)};
    char message[200];
    double time;
    tdsp_oracle_findings found;
    network n;
    assert_true(network_make(&n, 3, away, 2, message, sizeof message));
    assert_int_equal(earliest_arrival(&n, 0, &time), TDSP_UNREACHABLE);
    assert_int_equal(latest_departure(&n, 50, &time), TDSP_UNREACHABLE);
    tdsp_oracle oracle = oracle_over(&n);
    assert_int_equal(tdsp_oracle_check(&oracle, NULL, NULL, &found), TDSP_OK);
    network_free(&n);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_town_of_the_example_is_searched_as_brute_force_has_it),
        cmocka_unit_test(searches_of_random_networks_find_what_brute_force_finds),
        cmocka_unit_test(oracles_of_random_networks_keep_every_rule),
        cmocka_unit_test(tables_of_random_networks_hold_what_brute_force_finds),
        cmocka_unit_test(networks_that_are_not_fifo_are_refused_with_the_road_and_the_reason),
        cmocka_unit_test(a_destination_that_no_road_leads_to_is_unreachable_both_ways),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
