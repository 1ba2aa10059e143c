/* SPDX-License-Identifier: MIT */
/*
 * The solver's oracle before the conformance kit: random scenes of every mix, and real ones. The kit looks closest where arrivals jump and where
 * departures end, and holds both directions against each other there.
 *
 * Real scenes are those of $TDSP_DATA, or ../shared/data; where that is not there, only the shipped ones.
 */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "support/property.h"
#include "tdsp/oracle_check.h"
#include "tdsp/scene_file.h"

#define DEPARTURES 60
#define REAL_DEPARTURES 3
#define MANY 500 /* discs, among which a call takes long */
#define CALLS_AMONG_MANY 60

static void print_finding(const char *name, const tdsp_oracle_finding *f)
{
    print_error("%s: %s of %s (%s): asked %.17g answered %.17g other %.17g seen %.17g expected %.17g\n", name,
                tdsp_oracle_rule_name(f->rule), tdsp_oracle_callback_name(f->callback), tdsp_status_name(f->status), f->asked,
                f->answered, f->other, f->seen, f->expected);
}

/* 1 when nothing is wrong, as far as so many calls tell. */
static int conforms(const char *name, tdsp_solver *solver, uint32_t departures, uint64_t calls, uint64_t seed)
{
    tdsp_oracle oracle;
    tdsp_oracle_findings found;
    tdsp_oracle_check_options options;
    tdsp_oracle_check_options_init(&options);
    options.departures = departures;
    options.calls = calls;
    options.seed = seed;
    assert_int_equal(tdsp_solver_oracle(solver, &oracle), TDSP_OK);
    tdsp_status status = tdsp_oracle_check(&oracle, &options, NULL, &found);
    for (size_t i = 0; status == TDSP_BAD_ORACLE && i < found.count; i++) print_finding(name, &found.found[i]);
    return status == TDSP_OK;
}

static void oracle_conforms(property_case *c)
{
    property_holds(c, conforms(c->name, c->solver, DEPARTURES, UINT64_MAX, c->seed));
}

static void the_oracle_of_random_scenes_keeps_every_rule(void **state)
{
    (void)state;
    property_each(5, 10, oracle_conforms);
}

static void the_oracle_of_crowded_scenes_keeps_every_rule(void **state)
{
    (void)state;
    property_each(1, RANDOM_MOST_DISCS, oracle_conforms);
}

static int real_scene_conforms(const char *path)
{
    g_auto(SceneFile) file = {0};
    g_autoptr(GError) error = NULL;
    tdsp_solver *solver = NULL;
    if (!scene_file_load(path, &file, &error)) print_error("%s\n", error->message);
    assert_non_null(file.scene);
    assert_int_equal(tdsp_solver_create(file.scene, &solver), TDSP_OK);
    size_t discs;
    (void)tdsp_scene_discs(file.scene, &discs);
    int fine = conforms(path, solver, REAL_DEPARTURES, discs > MANY ? CALLS_AMONG_MANY : UINT64_MAX, 1);
    tdsp_solver_free(solver);
    return fine;
}

/* All scenes of a directory; -1 when it is not there, else how many do not conform. */
static int scenes_that_do_not_conform(const char *directory)
{
    g_autoptr(GDir) scenes = g_dir_open(directory, 0, NULL);
    int tried = 0, wrong = 0;
    if (!scenes) return -1;
    for (const char *name = g_dir_read_name(scenes); name; name = g_dir_read_name(scenes)) {
        if (!g_str_has_suffix(name, ".json")) continue;
        g_autofree char *path = g_build_filename(directory, name, NULL);
        wrong += !real_scene_conforms(path);
        tried++;
    }
    print_message("%s: %d scenes, %d do not conform\n", directory, tried, wrong);
    assert_true(tried > 0);
    return wrong;
}

static void the_oracle_of_shipped_scenes_keeps_every_rule(void **state)
{
    (void)state;
    assert_int_equal(scenes_that_do_not_conform("examples/scenes"), 0);
}

static void the_oracle_of_real_scenes_keeps_every_rule(void **state)
{
    (void)state;
    const char *named = getenv("TDSP_DATA");
    g_autofree char *directory = g_build_filename(named && *named ? named : "../shared/data", "scenes", NULL);
    int wrong = scenes_that_do_not_conform(directory);
    if (wrong < 0) print_message("%s is not there: only the shipped scenes are tested\n", directory);
    assert_true(wrong <= 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_oracle_of_random_scenes_keeps_every_rule),
        cmocka_unit_test(the_oracle_of_crowded_scenes_keeps_every_rule),
        cmocka_unit_test(the_oracle_of_shipped_scenes_keeps_every_rule),
        cmocka_unit_test(the_oracle_of_real_scenes_keeps_every_rule),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
