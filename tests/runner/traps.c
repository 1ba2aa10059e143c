/* SPDX-License-Identifier: MIT */
/* Misbehaves as its argument says: what tests/run.sh must not take for success. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MANY = 256 };

static void passes(void **state)
{
    (void)state;
    assert_true(1);
}

static void fails(void **state)
{
    (void)state;
    fail();
}

static void is_skipped(void **state)
{
    (void)state;
    skip();
}

static void aborts(void **state)
{
    (void)state;
    abort();
}

static void leaves(void **state)
{
    (void)state;
    exit(0);
}

/* CMocka returns the number of failures: 256 of them look like success to whoever asks for the exit status. */
static int fail_many(void)
{
    struct CMUnitTest tests[MANY];
    const struct CMUnitTest one = cmocka_unit_test(fails);
    for (int i = 0; i < MANY; i++) {
        tests[i] = one;
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest good[] = {cmocka_unit_test(passes), cmocka_unit_test(passes)};
    const struct CMUnitTest skipped[] = {cmocka_unit_test(passes), cmocka_unit_test(is_skipped)};
    const struct CMUnitTest aborted[] = {cmocka_unit_test(passes), cmocka_unit_test(aborts)};
    const struct CMUnitTest left[] = {cmocka_unit_test(passes), cmocka_unit_test(leaves), cmocka_unit_test(passes)};
    const char *what = argc > 1 ? argv[1] : "";
    if (strcmp(what, "good") == 0) return cmocka_run_group_tests(good, NULL, NULL);
    if (strcmp(what, "many") == 0) return fail_many();
    if (strcmp(what, "skip") == 0) return cmocka_run_group_tests(skipped, NULL, NULL);
    if (strcmp(what, "abort") == 0) return cmocka_run_group_tests(aborted, NULL, NULL);
    if (strcmp(what, "exit") == 0) return cmocka_run_group_tests(left, NULL, NULL);
    if (strcmp(what, "lines") == 0) return puts("ok one\nnot ok two\nok three") < 0;
    if (strcmp(what, "sum") == 0) return puts("3 passed, 1 failed") < 0;
    if (strcmp(what, "after") == 0) return cmocka_run_group_tests(good, NULL, NULL) + 1;
    return 0;
}
