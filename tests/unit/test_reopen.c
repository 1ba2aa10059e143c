/* SPDX-License-Identifier: MIT */
/* Opening again what was accepted before: the same view, at once; and nothing that could lead a read astray. */
#include "support/cmocka_all.h"

#include <stdlib.h>

#include "support/chance.h"
#include "support/sample.h"
#include "support/walk.h"

static void a_table_opened_again_is_the_table_opened(void **state)
{
    (void)state;
    for (size_t which = 0; which < GOLDEN_COUNT; which++) {
        size_t length;
        unsigned char *bytes = golden_write(&golden_tables[which], &length);
        tdsp_table first, again;
        memset(&first, 0, sizeof first);
        memset(&again, 0, sizeof again);
        assert_int_equal(tdsp_table_open(&first, bytes, length), TDSP_OK);
        assert_int_equal(tdsp_table_reopen(&again, bytes, length), TDSP_OK);
        assert_memory_equal(&first, &again, sizeof first);
        assert_null(walk_table(&again));
        free(bytes);
    }
}

static void assert_refused(const void *bytes, size_t length, tdsp_status status)
{
    tdsp_table table, before;
    memset(&table, 0x5a, sizeof table);
    before = table;
    assert_int_equal(tdsp_table_reopen(&table, bytes, length), status);
    assert_memory_equal(&table, &before, sizeof table);
}

static void what_is_no_table_of_that_length_is_refused(void **state)
{
    (void)state;
    size_t length;
    tdsp_table table;
    unsigned char *bytes = golden_write(&golden_tables[0], &length);
    assert_int_equal(tdsp_table_reopen(NULL, bytes, length), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_table_reopen(&table, NULL, length), TDSP_INVALID_ARGUMENT);
    assert_refused(bytes, 7, TDSP_BAD_MAGIC);
    assert_refused(bytes, 10, TDSP_BAD_LENGTH);
    assert_refused(bytes, length - 8, TDSP_BAD_LENGTH);
    bytes[8]++;
    assert_refused(bytes, length, TDSP_BAD_VERSION);
    free(bytes);
}

/* Sums are not looked at; every place is. Walking what opens is for the sanitizers to watch: the block ends where the table does. */
static void no_changed_byte_leads_a_read_outside(void **state)
{
    (void)state;
    uint64_t chance = 31;
    size_t opened = 0;
    for (int trial = 0; trial < 4000; trial++) {
        size_t length;
        tdsp_table table;
        unsigned char *bytes = golden_write(&golden_tables[trial % GOLDEN_COUNT], &length);
        for (size_t i = 0; i < 1 + chance_below(&chance, 3); i++) bytes[chance_below(&chance, i % 2 == 0 && length > 344 ? 344 : length)] = (unsigned char)chance_u64(&chance);
        if (tdsp_table_reopen(&table, bytes, length) == TDSP_OK) {
            opened++;
            (void)walk_table(&table);
        }
        free(bytes);
    }
    assert_in_range(opened, 100, 3900);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_table_opened_again_is_the_table_opened),
        cmocka_unit_test(what_is_no_table_of_that_length_is_refused),
        cmocka_unit_test(no_changed_byte_leads_a_read_outside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
