/* SPDX-License-Identifier: MIT */
/*
 * Any text at all as a list of times, as `tdsp query --times` reads it: a message, or times that are finite, not negative, as many as there are lines with a number,
 * and the same when they are written out and read again.
 */
#include <math.h>
#include <string.h>

#include "input.h"
#include "tdsp/numbers.h"
#include "tdsp/times.h"

static gboolean read_times(const unsigned char *data, size_t size, GArray *times, GError **error)
{
    char *text = g_malloc(size + 1); /* exactly as long as it is, so that a read past its end is seen */
    if (size) memcpy(text, data, size);
    text[size] = '\0';
    const gboolean read = times_add_text(times, "input", text, size, error);
    g_free(text);
    return read;
}

static void check_again(const GArray *times)
{
    g_autoptr(GString) text = g_string_new(NULL);
    g_autoptr(GArray) again = times_new();
    g_autoptr(GError) error = NULL;
    char number[NUMBER_ROOM];
    for (guint i = 0; i < times->len; i++) g_string_append_printf(text, "%s # %u\r\n\n", number_format(number, g_array_index(times, double, i)), i);
    fuzz_require(read_times((const unsigned char *)text->str, text->len, again, &error), "what was written is refused");
    fuzz_require(again->len == times->len && memcmp(again->data, times->data, times->len * sizeof(double)) == 0, "other numbers are read than were written");
}

int LLVMFuzzerTestOneInput(const unsigned char *data, size_t size)
{
    g_autoptr(GArray) times = times_new();
    g_autoptr(GError) error = NULL;
    size_t lines = 1;
    for (size_t i = 0; i < size; i++) lines += data[i] == '\n';
    const gboolean read = read_times(data, size, times, &error);
    fuzz_require(read ? !error : error != NULL, "no message, or one too many");
    if (!read) return 0;
    fuzz_require(times->len > 0 && times->len <= lines, "more numbers than lines");
    for (guint i = 0; i < times->len; i++) {
        const double time = g_array_index(times, double, i);
        fuzz_require(isfinite(time) && time >= 0.0 && !signbit(time), "a time that is none");
    }
    check_again(times);
    return 0;
}
