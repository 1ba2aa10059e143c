/* SPDX-License-Identifier: MIT */
/*
 * Real scenes against the answers of an unrelated solver: arrivals within 1e-8, departures within 1e-7, each path verified.
 *
 * The scenes and answers are in $TDSP_DATA, or ../shared/data; where that is not there, the shipped scenes and
 * tests/property/expected_examples.json stand in for them. A better answer than the one on file is no failure when its path
 * is verified: the number is then wrong, and is printed. TDSP_SECONDS=1 prints how long each scene took.
 */
#include "support/cmocka_all.h"

#include <json-glib/json-glib.h>
#include <stdlib.h>
#include <time.h>

#include "slow/slow.h"
#include "tdsp/scene_file.h"
#include "tdsp/solver.h"
#include "tdsp/verify.h"

#define ARRIVAL_ERROR 1e-8
#define DEPARTURE_ERROR 1e-7

typedef struct real_scene {
    const char *name;
    SceneFile file;
    tdsp_solver *solver;
    tdsp_leg *legs;
    size_t capacity;
    int wrong;
} real_scene;

typedef struct place_of_data {
    char *expected;
    char *scenes; /* directory */
} place_of_data;

static place_of_data find_data(void)
{
    const char *named = getenv("TDSP_DATA");
    const char *directory = named && *named ? named : "../shared/data";
    place_of_data found = {g_build_filename(directory, "expected.json", NULL), g_build_filename(directory, "scenes", NULL)};
    if (g_file_test(found.expected, G_FILE_TEST_EXISTS)) return found;
    print_message("%s is not there: only the shipped scenes are tested\n", found.expected);
    g_free(found.expected);
    g_free(found.scenes);
    return (place_of_data){g_strdup("tests/property/expected_examples.json"), g_strdup("examples/scenes")};
}

static void complain(real_scene *s, const char *what, double asked, double got, double expected)
{
    print_error("%s: %s for %.17g: %.17g, expected %.17g\n", s->name, what, asked, got, expected);
    s->wrong++;
}

static void check_path(real_scene *s, double departure, double arrival)
{
    size_t count;
    tdsp_verdict verdict;
    if (tdsp_solver_path(s->solver, s->legs, s->capacity, &count) == TDSP_BUFFER_TOO_SMALL) {
        s->legs = g_renew(tdsp_leg, s->legs, count);
        s->capacity = count;
    }
    assert_int_equal(tdsp_solver_path(s->solver, s->legs, s->capacity, &count), TDSP_OK);
    assert_int_equal(tdsp_verify_path(s->file.scene, s->legs, count, departure, arrival, &verdict), TDSP_OK);
    if (verdict.problems) complain(s, "the path is rejected", departure, verdict.min_clearance, -verdict.tolerance);
}

static double number_or(JsonArray *pair, guint index, double otherwise)
{
    JsonNode *node = json_array_get_element(pair, index);
    return json_node_is_null(node) ? otherwise : json_node_get_double(node);
}

static void check_arrival(real_scene *s, JsonArray *pair)
{
    const double departure = number_or(pair, 0, NAN), expected = number_or(pair, 1, INFINITY);
    double arrival = NAN;
    const tdsp_status status = tdsp_earliest_arrival(s->solver, departure, &arrival);
    if (!tdsp_status_is_answer(status)) complain(s, tdsp_status_name(status), departure, arrival, expected);
    if (status == TDSP_OK) check_path(s, departure, arrival);
    if (arrival == expected || fabs(arrival - expected) <= ARRIVAL_ERROR * expected) return;
    if (arrival < expected)
        print_message("%s: leaving at %.17g arrives at %.17g, better than %.17g\n", s->name, departure, arrival, expected);
    else
        complain(s, "arrival", departure, arrival, expected);
}

static void check_departure(real_scene *s, JsonArray *pair)
{
    const double arrival = number_or(pair, 0, NAN), expected = number_or(pair, 1, NAN);
    double departure = NAN, arrives = NAN;
    const tdsp_status status = tdsp_latest_departure(s->solver, arrival, &departure, &arrives);
    if (status != TDSP_OK) {
        complain(s, tdsp_status_name(status), arrival, departure, expected);
        return;
    }
    check_path(s, departure, arrives);
    if (!(arrives <= arrival * (1.0 + 1e-12))) complain(s, "arrives too late", arrival, arrives, arrival);
    if (fabs(departure - expected) <= DEPARTURE_ERROR * expected) return;
    if (departure > expected)
        print_message("%s: to arrive by %.17g leave at %.17g, better than %.17g\n", s->name, arrival, departure, expected);
    else
        complain(s, "departure", arrival, departure, expected);
}

/* Does the slow solver too find no path right after this departure? It takes small scenes only. */
static int surely_last(const real_scene *s, double departure)
{
    size_t count;
    const tdsp_disc *discs = tdsp_scene_discs(s->file.scene, &count);
    const double after = departure * (1.0 + 1e-6);
    return count <= 64 && slow_arrival(tdsp_scene_journey(s->file.scene), discs, count, after) == INFINITY;
}

static void check_last(real_scene *s, JsonObject *expected)
{
    if (!json_object_has_member(expected, "last_departure")) return;
    JsonNode *node = json_object_get_member(expected, "last_departure");
    tdsp_last_departure last = {.departure = NAN};
    if (json_node_is_null(node)) return;
    assert_int_equal(tdsp_solver_last_departure(s->solver, &last), TDSP_OK);
    const double number = json_node_get_double(node);
    if (fabs(last.departure - number) <= DEPARTURE_ERROR * number) return;
    if (last.departure < number && surely_last(s, last.departure))
        print_message("%s: the last departure is %.17g, not %.17g: a second solver finds none after it either\n", s->name,
                      last.departure, number);
    else
        complain(s, "last departure", 0.0, last.departure, number);
}

static void check_pairs(real_scene *s, JsonObject *expected, const char *member, void (*check)(real_scene *, JsonArray *))
{
    if (!json_object_has_member(expected, member)) return;
    JsonArray *pairs = json_object_get_array_member(expected, member);
    for (guint i = 0; i < json_array_get_length(pairs); i++)
        check(s, json_array_get_array_element(pairs, i));
}

static int check_scene(const place_of_data *data, const char *name, JsonObject *expected)
{
    real_scene s = {.name = name};
    GError *error = NULL;
    char *base = g_strconcat(name, ".json", NULL), *path = g_build_filename(data->scenes, base, NULL);
    if (!scene_file_load(path, &s.file, &error)) fail_msg("%s", error->message);
    assert_int_equal(tdsp_solver_create(s.file.scene, &s.solver), TDSP_OK);
    const clock_t begin = clock();
    check_pairs(&s, expected, "arrivals", check_arrival);
    check_pairs(&s, expected, "departures", check_departure);
    check_last(&s, expected);
    if (getenv("TDSP_SECONDS")) print_message("%-45s %8.3f s\n", name, (double)(clock() - begin) / CLOCKS_PER_SEC);
    tdsp_solver_free(s.solver);
    scene_file_clear(&s.file);
    g_free(s.legs);
    g_free(base);
    g_free(path);
    return s.wrong;
}

static void every_real_scene_has_the_answers_on_file(void **state)
{
    (void)state;
    place_of_data data = find_data();
    JsonParser *parser = json_parser_new();
    GError *error = NULL;
    int wrong = 0;
    if (!json_parser_load_from_file(parser, data.expected, &error)) fail_msg("%s", error->message);
    JsonObject *scenes = json_node_get_object(json_parser_get_root(parser));
    GList *names = json_object_get_members(scenes);
    for (GList *name = names; name; name = name->next)
        wrong += check_scene(&data, name->data, json_object_get_object_member(scenes, name->data));
    g_list_free(names);
    g_object_unref(parser);
    g_free(data.expected);
    g_free(data.scenes);
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_real_scene_has_the_answers_on_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
