/* SPDX-License-Identifier: MIT */
/* Statuses: names are an interface of the command line's JSON, values one of the binary interface. */
#include "support/cmocka_all.h"

#include <ctype.h>
#include <stdio.h>

#include "tdsp/status.h"
#include "tdsp/types.h"

static const struct {
    tdsp_status status;
    int value;
    const char *name;
} known[] = {
    {TDSP_OK, 0, "ok"},
    {TDSP_SOURCE_COVERED, 1, "source_covered"},
    {TDSP_DESTINATION_COVERED, 2, "destination_covered"},
    {TDSP_CUT_OFF, 3, "cut_off"},
    {TDSP_ARRIVAL_TOO_EARLY, 4, "arrival_too_early"},
    {TDSP_HORIZON, 5, "horizon"},
    {TDSP_OUTSIDE_TABLE, 6, "outside_table"},
    {TDSP_UNREACHABLE, 7, "unreachable"},
    {TDSP_INVALID_ARGUMENT, 16, "invalid_argument"},
    {TDSP_BUFFER_TOO_SMALL, 17, "buffer_too_small"},
    {TDSP_NO_ANSWER, 18, "no_answer"},
    {TDSP_NOT_SUPPORTED, 19, "not_supported"},
    {TDSP_NEEDS_HORIZON, 20, "needs_horizon"},
    {TDSP_TOO_MANY_ROWS, 21, "too_many_rows"},
    {TDSP_BAD_SCENE, 32, "bad_scene"},
    {TDSP_BAD_MAGIC, 33, "bad_magic"},
    {TDSP_BAD_VERSION, 34, "bad_version"},
    {TDSP_BAD_LENGTH, 35, "bad_length"},
    {TDSP_BAD_CHECKSUM, 36, "bad_checksum"},
    {TDSP_BAD_TABLE, 37, "bad_table"},
    {TDSP_BAD_PATH, 38, "bad_path"},
    {TDSP_STALE_TABLE, 39, "stale_table"},
    {TDSP_BAD_ORACLE, 40, "bad_oracle"},
    {TDSP_SHRINKS, 41, "shrinks"},
    {TDSP_NO_MEMORY, 64, "no_memory"},
    {TDSP_CANCELLED, 65, "cancelled"},
    {TDSP_FAILED, 66, "failed"},
};
#define KNOWN (sizeof known / sizeof known[0])

static void each_status_keeps_its_value_and_its_name(void **state)
{
    (void)state;
    for (size_t i = 0; i < KNOWN; i++) {
        assert_int_equal(known[i].status, known[i].value);
        assert_string_equal(tdsp_status_name(known[i].status), known[i].name);
    }
}

static void only_the_family_of_answers_is_an_answer(void **state)
{
    (void)state;
    for (size_t i = 0; i < KNOWN; i++)
        assert_int_equal(tdsp_status_is_answer(known[i].status), known[i].value < 16);
    assert_false(tdsp_status_is_answer((tdsp_status)-1));
}

static void each_text_is_one_sentence_of_its_own_without_a_full_stop(void **state)
{
    (void)state;
    for (size_t i = 0; i < KNOWN; i++) {
        const char *text = tdsp_status_text(known[i].status);
        assert_true(isupper((unsigned char)text[0]));
        assert_int_not_equal(text[strlen(text) - 1], '.');
        assert_string_not_equal(text, "Unknown status");
        for (size_t j = 0; j < i; j++)
            assert_string_not_equal(text, tdsp_status_text(known[j].status));
    }
}

static void a_value_outside_the_enumeration_is_unknown(void **state)
{
    (void)state;
    size_t next = 0;
    for (int value = -100; value < 1000; value++) {
        if (next < KNOWN && known[next].value == value) {
            next++;
            continue;
        }
        assert_string_equal(tdsp_status_name((tdsp_status)value), "unknown");
        assert_string_equal(tdsp_status_text((tdsp_status)value), "Unknown status");
    }
    assert_int_equal(next, KNOWN);
}

static void the_linked_version_is_that_of_the_headers(void **state)
{
    (void)state;
    char parts[32];
    snprintf(parts, sizeof parts, "%d.%d.%d", TDSP_VERSION_MAJOR, TDSP_VERSION_MINOR, TDSP_VERSION_PATCH);
    assert_string_equal(tdsp_version(), TDSP_VERSION_STRING);
    assert_string_equal(tdsp_version(), parts);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_status_keeps_its_value_and_its_name),
        cmocka_unit_test(only_the_family_of_answers_is_an_answer),
        cmocka_unit_test(each_text_is_one_sentence_of_its_own_without_a_full_stop),
        cmocka_unit_test(a_value_outside_the_enumeration_is_unknown),
        cmocka_unit_test(the_linked_version_is_that_of_the_headers),
    };
    return cmocka_run_group_tests_name("status", tests, NULL, NULL);
}
