/* SPDX-License-Identifier: MIT */
/* Numbers to text and back, by GLib's locale-independent functions. */
#include "numbers.h"

#include <math.h>
#include <string.h>

const char *number_brief(char buffer[NUMBER_ROOM], double value, int digits)
{
    char format[8];
    if (isinf(value)) {
        g_strlcpy(buffer, value > 0 ? "inf" : "-inf", NUMBER_ROOM);
        return buffer;
    }
    g_snprintf(format, sizeof format, "%%.%dg", digits);
    return g_ascii_formatd(buffer, NUMBER_ROOM, format, value);
}

const char *number_format(char buffer[NUMBER_ROOM], double value)
{
    for (int digits = 15; digits < 17; digits++) {
        number_brief(buffer, value, digits);
        if (isinf(value) || g_ascii_strtod(buffer, NULL) == value) return buffer;
    }
    return number_brief(buffer, value, 17);
}

static const char *skip_digits(const char *text)
{
    while (g_ascii_isdigit(*text)) text++;
    return text;
}

/* [+-] digits [. digits] [e [+-] digits], at least one digit before or after the point. */
static gboolean is_decimal(const char *text)
{
    if (*text == '+' || *text == '-') text++;
    const char *whole = skip_digits(text);
    gsize digits = (gsize)(whole - text);
    text = whole;
    if (*text == '.') {
        const char *fraction = skip_digits(text + 1);
        digits += (gsize)(fraction - text - 1);
        text = fraction;
    }
    if (digits == 0) return FALSE;
    if (*text == 'e' || *text == 'E') {
        text++;
        if (*text == '+' || *text == '-') text++;
        const char *exponent = skip_digits(text);
        if (exponent == text) return FALSE;
        text = exponent;
    }
    return *text == '\0';
}

const char *number_parse(const char *text, double *value)
{
    if (!is_decimal(text)) return "not a finite decimal number";
    double parsed = g_ascii_strtod(text, NULL);
    if (!isfinite(parsed)) return "too large for a double";
    *value = parsed;
    return NULL;
}

const char *number_parse_time(const char *text, double *value)
{
    double parsed;
    const char *wrong = number_parse(text, &parsed);
    if (wrong) return wrong;
    if (parsed < 0) return "negative";
    *value = parsed == 0 ? 0 : parsed;
    return NULL;
}

const char *number_parse_whole(const char *text, guint64 least, guint64 most, guint64 *value)
{
    g_autoptr(GError) wrong = NULL;
    if (g_ascii_string_to_unsigned(text, 10, least, most, value, &wrong)) return NULL;
    if (g_error_matches(wrong, G_NUMBER_PARSER_ERROR, G_NUMBER_PARSER_ERROR_OUT_OF_BOUNDS)) return "out of range";
    return "not a whole number";
}
