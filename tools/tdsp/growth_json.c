/* SPDX-License-Identifier: MIT */
/*
 * How a disc grows, as data: a rate; coefficients of a polynomial; or rates from given times on. What one number can be wrong in is said with the
 * place of that number; what the growth as a whole is wrong in, as a radius that shrinks, the library says.
 */
#include "growth_json.h"

#define LARGEST 1e100 /* as the library has it */

static gboolean read_rate(const JsonValue *value, double *rate, GError **error)
{
    if (!json_read_number(value, rate, error)) return FALSE;
    return *rate >= 0 ? TRUE : json_read_fail(&value->place, error, "must not be negative: discs never shrink");
}

static gboolean read_coefficient(const JsonValue *value, double *coefficient, GError **error)
{
    if (!json_read_number(value, coefficient, error)) return FALSE;
    return ABS(*coefficient) <= LARGEST ? TRUE : json_read_fail(&value->place, error, "is beyond 1e100");
}

/* An array of numbers, each read by `read`. */
static double *read_numbers(const JsonValue *array, guint length, gboolean (*read)(const JsonValue *, double *, GError **),
                            GPtrArray *kept, GError **error)
{
    double *numbers = g_new(double, length);
    g_ptr_array_add(kept, numbers);
    for (guint i = 0; i < length; i++) {
        JsonValue item = json_read_item(array, i);
        if (!read(&item, &numbers[i], error)) return NULL;
    }
    return numbers;
}

/* [c1, c2, ...]: R(t) = radius + c1 t + c2 t^2 + ... */
static gboolean read_polynomial(const JsonValue *value, tdsp_growth *growth, GPtrArray *kept, GError **error)
{
    guint length;
    if (!json_read_array(value, &length, error)) return FALSE;
    if (length == 0) return json_read_fail(&value->place, error, "has no coefficient");
    if (length > TDSP_GROWTH_DEGREE)
        return json_read_fail(&value->place, error, "%u coefficients, where at most %u are supported", length, TDSP_GROWTH_DEGREE);
    growth->kind = TDSP_GROWTH_POLYNOMIAL;
    growth->count = length;
    growth->values = read_numbers(value, length, read_coefficient, kept, error);
    return growth->values != NULL;
}

static gboolean read_times(const JsonValue *value, tdsp_growth *growth, GPtrArray *kept, GError **error)
{
    JsonValue times;
    guint length;
    if (!json_read_member(value, "times", &times, error) || !json_read_array(&times, &length, error)) return FALSE;
    if (length == 0) return json_read_fail(&times.place, error, "is empty");
    growth->count = length;
    growth->times = read_numbers(&times, length, json_read_number, kept, error);
    for (guint i = 0; growth->times && i < length; i++) {
        JsonValue item = json_read_item(&times, i);
        if (i == 0 && growth->times[i] != 0) return json_read_fail(&item.place, error, "the first time must be 0");
        if (i > 0 && !(growth->times[i] > growth->times[i - 1])) return json_read_fail(&item.place, error, "times must increase");
    }
    return growth->times != NULL;
}

/* {"times": [0, t1, ...], "rates": [r0, r1, ...]} */
static gboolean read_rates(const JsonValue *value, tdsp_growth *growth, GPtrArray *kept, GHashTable *warned, GError **error)
{
    static const char *const known[] = {"times", "rates", NULL};
    JsonValue rates;
    guint length;
    growth->kind = TDSP_GROWTH_RATES;
    if (!read_times(value, growth, kept, error)) return FALSE;
    if (!json_read_member(value, "rates", &rates, error) || !json_read_array(&rates, &length, error)) return FALSE;
    if (length != growth->count)
        return json_read_fail(&rates.place, error, "%u rates for %u times", length, (guint)growth->count);
    growth->values = read_numbers(&rates, length, read_rate, kept, error);
    if (growth->values) json_read_warn_unknown(value, known, warned);
    return growth->values != NULL;
}

gboolean growth_json_read(const JsonValue *value, tdsp_growing_disc *disc, GPtrArray *kept, GHashTable *warned, GError **error)
{
    gboolean read;
    if (JSON_NODE_HOLDS_ARRAY(value->node))
        read = read_polynomial(value, &disc->growth, kept, error);
    else if (JSON_NODE_HOLDS_OBJECT(value->node))
        read = read_rates(value, &disc->growth, kept, warned, error);
    else
        read = read_rate(value, &disc->growth.rate, error);
    if (!read) return FALSE;
    const char *wrong = tdsp_growing_disc_check(disc);
    return wrong ? json_read_fail(&value->place, error, "%s", wrong) : TRUE;
}

static void write_numbers(const double *numbers, gsize count, JsonOut *out)
{
    json_out_begin(out, '[');
    for (gsize i = 0; i < count; i++) json_out_number(out, numbers[i]);
    json_out_end(out, ']');
}

void growth_json_write(const tdsp_growth *growth, JsonOut *out)
{
    if (growth->kind == TDSP_GROWTH_RATE) {
        json_out_number(out, growth->rate);
    } else if (growth->kind == TDSP_GROWTH_POLYNOMIAL) {
        write_numbers(growth->values, growth->count, out);
    } else {
        json_out_begin(out, '{');
        json_out_key(out, "times");
        write_numbers(growth->times, growth->count, out);
        json_out_key(out, "rates");
        write_numbers(growth->values, growth->count, out);
        json_out_end(out, '}');
    }
}

gboolean growth_json_is_rate(const tdsp_growth *growth, double *rate)
{
    *rate = growth->kind == TDSP_GROWTH_RATE ? growth->rate : growth->values[0];
    return growth->kind == TDSP_GROWTH_RATE || growth->count == 1;
}
