/* SPDX-License-Identifier: MIT */
/* Public functions that ask for no memory are not in its want: each is called with none to be had. */
#include "support/cmocka_all.h"

#include "support/scarce.h"

/* Asks for no memory, whatever there would be. */
#define NEEDS_NONE(function, arguments)        \
    do {                                       \
        const size_t before = f.heap.calls;    \
        (void)function arguments;              \
        assert_int_equal(f.heap.calls, before); \
    } while (0)

static void scenes_answer_without_memory(void **state)
{
    (void)state;
    const tdsp_disc disc = {{0.0, 3.0}, 1.0, 0.1};
    const tdsp_point place = {0.0, 9.5};
    for (int kind = 0; kind < SCARCE_WORLDS; ++kind) {
        scarce f;
        double radius, rate;
        size_t count;
        scarce_open(&f, (scarce_world)kind);
        f.heap.refuse = 1;
        f.heap.and_after = 1;
        NEEDS_NONE(tdsp_disc_check, (&disc));
        NEEDS_NONE(tdsp_growing_disc_check, (&scarce_bent[1]));
        NEEDS_NONE(tdsp_journey_check, (&scarce_journey));
        NEEDS_NONE(tdsp_scene_destination_free_until, (f.scene, NULL));
        NEEDS_NONE(tdsp_scene_source_free_until, (f.scene, NULL));
        NEEDS_NONE(tdsp_scene_free_until, (f.scene, place, NULL));
        NEEDS_NONE(tdsp_scene_disc_at, (f.scene, 0, 5.0, &radius, &rate));
        NEEDS_NONE(tdsp_scene_discs, (f.scene, &count));
        NEEDS_NONE(tdsp_scene_has_rates_only, (f.scene));
        NEEDS_NONE(tdsp_scene_hash, (f.scene));
        NEEDS_NONE(tdsp_scene_hash_for, (f.scene, &scarce_aside));
        NEEDS_NONE(tdsp_scene_journey, (f.scene));
        NEEDS_NONE(tdsp_scene_valid_until, (f.scene, NULL));
        NEEDS_NONE(tdsp_solver_free, (f.solver));
        NEEDS_NONE(tdsp_scene_free, (f.scene));
        assert_int_equal(f.heap.blocks, 0);
    }
}

static void solvers_tell_about_themselves_without_memory(void **state)
{
    (void)state;
    for (int kind = 0; kind < SCARCE_WORLDS; ++kind) {
        scarce f;
        tdsp_ends ends;
        tdsp_leg legs[SCARCE_LEGS];
        size_t count;
        tdsp_oracle oracle;
        tdsp_solver_work work;
        double arrival;
        scarce_open(&f, (scarce_world)kind);
        assert_int_equal(tdsp_earliest_arrival(f.solver, 1.0, &arrival), TDSP_OK);
        f.heap.refuse = 1;
        f.heap.and_after = 1;
        NEEDS_NONE(tdsp_solver_path, (f.solver, legs, SCARCE_LEGS, &count));
        NEEDS_NONE(tdsp_solver_set_ends, (f.solver, &scarce_aside));
        NEEDS_NONE(tdsp_solver_ends, (f.solver, &ends));
        NEEDS_NONE(tdsp_solver_method, (f.solver));
        NEEDS_NONE(tdsp_solver_oracle, (f.solver, &oracle));
        NEEDS_NONE(tdsp_solver_scene, (f.solver));
        NEEDS_NONE(tdsp_solver_work_done, (f.solver, &work));
        assert_true(count > 0);
        scarce_close(&f);
    }
}

static void what_was_made_is_read_and_freed_without_memory(void **state)
{
    scarce f;
    tdsp_jumps *jumps;
    tdsp_envelope *envelope;
    tdsp_search *search;
    tdsp_arrival_jump jump;
    tdsp_piece piece;
    (void)state;
    scarce_open(&f, SCARCE_GATE);
    assert_int_equal(tdsp_jumps_find(f.solver, NULL, &jumps), TDSP_OK);
    assert_int_equal(tdsp_envelope_find(f.solver, NULL, &envelope), TDSP_OK);
    assert_int_equal(tdsp_search_create(&f.memory, &search), TDSP_OK);
    void *bytes = tight_resize(&f.heap, NULL, 0, 10);
    f.heap.refuse = 1;
    f.heap.and_after = 1;
    NEEDS_NONE(tdsp_jumps_count, (jumps));
    NEEDS_NONE(tdsp_jumps_get, (jumps, 0, &jump));
    NEEDS_NONE(tdsp_jumps_free, (jumps));
    NEEDS_NONE(tdsp_envelope_pieces, (envelope));
    NEEDS_NONE(tdsp_envelope_forms, (envelope));
    NEEDS_NONE(tdsp_envelope_resolution, (envelope));
    NEEDS_NONE(tdsp_envelope_piece, (envelope, 0, &piece));
    NEEDS_NONE(tdsp_envelope_free, (envelope));
    NEEDS_NONE(tdsp_search_limit, (search, 3.0));
    NEEDS_NONE(tdsp_search_free, (search));
    NEEDS_NONE(tdsp_bytes_free, (&f.memory, bytes, 10));
    scarce_close(&f);
}

static void names_and_defaults_need_no_memory(void **state)
{
    scarce f;
    tdsp_build_options build;
    tdsp_shape_options shape;
    tdsp_oracle oracle;
    tdsp_oracle_check_options check;
    const tdsp_oracle_finding finding = {.rule = TDSP_RULE_ORDER};
    (void)state;
    scarce_open(&f, SCARCE_GATE);
    NEEDS_NONE(tdsp_build_options_init, (&build));
    NEEDS_NONE(tdsp_shape_options_init, (&shape));
    NEEDS_NONE(tdsp_oracle_init, (&oracle));
    NEEDS_NONE(tdsp_oracle_check_options_init, (&check));
    NEEDS_NONE(tdsp_limit_name, (TDSP_LIMIT_GAP));
    NEEDS_NONE(tdsp_method_name, (TDSP_METHOD_AUTO));
    NEEDS_NONE(tdsp_oracle_callback_name, (TDSP_ORACLE_PATH));
    NEEDS_NONE(tdsp_oracle_finding_text, (&finding));
    NEEDS_NONE(tdsp_oracle_rule_name, (TDSP_RULE_ORDER));
    scarce_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scenes_answer_without_memory),
        cmocka_unit_test(solvers_tell_about_themselves_without_memory),
        cmocka_unit_test(what_was_made_is_read_and_freed_without_memory),
        cmocka_unit_test(names_and_defaults_need_no_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
