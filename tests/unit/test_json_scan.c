/* SPDX-License-Identifier: MIT */
/* What is JSON and what is not, where json-glib would be lenient: escapes, numbers, words, ends. */
#include "support/cmocka_all.h"

#include <string.h>

#include "tdsp/cli.h"
#include "tdsp/json_read.h"
#include "tdsp/json_scan.h"

/* 1 and what is wrong otherwise. */
static gboolean is_json(const char *text, char **wrong)
{
    g_autoptr(GError) error = NULL;
    GString *clean = json_scan("text", text, strlen(text), &error);
    *wrong = error ? g_strdup(error->message) : NULL;
    if (!clean) return FALSE;
    g_string_free(clean, TRUE);
    return TRUE;
}

static void assert_accepted(const char *text)
{
    g_autofree char *wrong = NULL;
    if (!is_json(text, &wrong)) fail_msg("%s: %s", text, wrong);
}

/* The message begins with file, line and column. */
static void assert_refused(const char *text, const char *place, const char *word)
{
    g_autofree char *wrong = NULL;
    g_autofree char *begin = g_strdup_printf("text:%s:", place);
    if (is_json(text, &wrong)) fail_msg("%s is accepted", text);
    if (!g_str_has_prefix(wrong, begin) || !strstr(wrong, word)) fail_msg("%s: %s, not %s ... %s", text, wrong, begin, word);
}

/* The text of a document that is a string. */
static char *string_of(const char *text)
{
    g_autoptr(GError) error = NULL;
    g_autoptr(JsonParser) parser = NULL;
    JsonValue root;
    const char *string;
    if (!json_read_document("text", text, strlen(text), &parser, &root, &error) || !json_read_string(&root, &string, &error))
        fail_msg("%s: %s", text, error->message);
    return g_strdup(string);
}

static void escapes_stand_for_their_characters(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"\"\\u00e9\"", "\xc3\xa9"},
        {"\"\\uD83D\\uDE00\"", "\xf0\x9f\x98\x80"},
        {"\"\\ue000\\uffff\"", "\xee\x80\x80\xef\xbf\xbf"},
        {"\"\\\"\\\\\\/\\b\\f\\n\\r\\t\"", "\"\\/\b\f\n\r\t"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(cases); i++) {
        g_autofree char *string = string_of(cases[i][0]);
        assert_string_equal(string, cases[i][1]);
    }
}

static void halves_of_characters_are_refused(void **state)
{
    (void)state;
    static const char *const halves[] = {"\"\\ud83d\"",        "\"\\ude00\"",        "\"\\ud83dx\"",     "\"\\ud83d\\n\"",
                                         "\"\\ud83d\\u0041\"", "\"\\ud83d\\ue000\"", "\"\\ud83d\\u12\"", "\"\\udc00\\udc00\""};
    for (size_t i = 0; i < G_N_ELEMENTS(halves); i++) assert_refused(halves[i], "1:2", "surrogate");
}

static void escapes_that_are_none_are_refused(void **state)
{
    (void)state;
    assert_refused("\"\\u12g4\"", "1:2", "four hexadecimal digits");
    assert_refused("\"\\u12", "1:2", "four hexadecimal digits");
    assert_refused("\"\\q\"", "1:2", "");
    assert_refused("\"\\", "1:2", "");
    assert_refused("{\"a\\q\": 1}", "1:4", "");
    assert_refused("\"line\nbreak\"", "1:6", "");
}

static void numbers_are_those_of_json(void **state)
{
    (void)state;
    static const char *const good[] = {"0", "-0", "0e1", "0E1", "1E5", "1e+5", "1.5e-5", "10.25"};
    static const char *const bad[] = {"01", "1.", ".5", "+1", "1e", "1e+", "-", "0x10", "00", "1.e5", "NaN", "-a"};
    for (size_t i = 0; i < G_N_ELEMENTS(good); i++) assert_accepted(good[i]);
    for (size_t i = 0; i < G_N_ELEMENTS(bad); i++) assert_refused(bad[i], "1:1", "");
}

static void what_ends_too_early_or_is_no_word_is_refused(void **state)
{
    (void)state;
    assert_refused("", "1:1", "ends too early");
    assert_refused(" \n ", "2:2", "ends too early");
    assert_refused("[1, ", "1:5", "ends too early");
    assert_refused("perhaps", "1:1", "perhaps");
    assert_refused("averyveryveryveryveryveryveryveryverylongword", "1:1", "averyveryveryveryveryveryveryveryverylon");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(escapes_stand_for_their_characters),
        cmocka_unit_test(halves_of_characters_are_refused),
        cmocka_unit_test(escapes_that_are_none_are_refused),
        cmocka_unit_test(numbers_are_those_of_json),
        cmocka_unit_test(what_ends_too_early_or_is_no_word_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
