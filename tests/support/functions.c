/* SPDX-License-Identifier: MIT */
#include "support/functions.h"

#include <inttypes.h>

#include "base/math.h"
#include "support/chance.h"

#define SAID 24   /* arguments of each range whose values are said one by one */
#define HASHED 2000

static double sine_of_both(double x)
{
    double sine, cosine;
    math_sincos(x, &sine, &cosine);
    return sine;
}

static double cosine_of_both(double x)
{
    double sine, cosine;
    math_sincos(x, &sine, &cosine);
    return cosine;
}

#define ANGLES                                                                                                                   \
    {                                                                                                                            \
        {"small", 1, 0, -60, 0}, {"quarter", 0, 0, -0.8, 0.8}, {"turns", 0, 0, -20, 20}, {"many turns", 1, 0, 3, 20},            \
        {"huge", 1, 0, 20, 1023},                                                                                                \
    }

const function_case function_cases[] = {
    {"sin", math_sin, NULL, ANGLES},
    {"cos", math_cos, NULL, ANGLES},
    {"sine of both", sine_of_both, NULL, ANGLES},
    {"cosine of both", cosine_of_both, NULL, ANGLES},
    {"atan2", NULL, math_atan2, {{"square", 0, 0, -1, 1}, {"near", 1, 0, -10, 10}, {"far", 1, 0, -300, 300}, {"all", 1, 0, -1074, 1023}}},
    {"asin", math_asin, NULL, {{"all", 0, 0, -1, 1}, {"small", 1, 0, -60, -1}, {"end", 0, 0, 0.99, 1}}},
    {"acos", math_acos, NULL, {{"all", 0, 0, -1, 1}, {"small", 1, 0, -60, -1}, {"end", 0, 0, 0.99, 1}, {"other end", 0, 0, -1, -0.99}}},
    {"log", math_log, NULL, {{"about 1", 0, 1, 0.5, 2}, {"next to 1", 0, 1, 0.99, 1.01}, {"all", 1, 1, -1074, 1023}}},
    {"log1p", math_log1p, NULL,
     {{"small", 1, 0, -60, -1}, {"about 0", 0, 0, -0.2, 0.2}, {"down", 0, 0, -1, 0}, {"up", 0, 1, 0, 10}, {"large", 1, 1, -1, 1023}}},
    {"exp", math_exp, NULL, {{"small", 1, 0, -60, 0}, {"about 0", 0, 0, -1, 1}, {"all", 0, 0, -708, 709}, {"less than normal", 0, 0, -746, -708}}},
    {"expm1", math_expm1, NULL, {{"small", 1, 0, -60, -3}, {"about 0", 0, 0, -0.2, 0.2}, {"middle", 0, 0, -10, 25}, {"all", 0, 0, -60, 709}}},
    {"hypot", NULL, math_hypot, {{"square", 0, 0, -1, 1}, {"near", 1, 0, -10, 10}, {"far", 1, 0, -300, 300}, {"all", 1, 0, -1000, 1000}}},
};
const int function_count = (int)(sizeof function_cases / sizeof *function_cases);

#define BESIDE(x) (x), (x) * (1 - 0x1p-53), (x) * (1 + 0x1p-52)
const double function_specials[] = {
    0.0, INFINITY, NAN, 0x1p-1074, 0x1p-1022, 0x1p-500, 0x1p-54, 0x1p-30, BESIDE(0.125), BESIDE(0.25), BESIDE(0.5), BESIDE(1.0), BESIDE(2.0),
    0x1.921fb54442d18p-1, 0x1.921fb54442d18p+0, 0x1.921fb54442d18p+1, 0x1.921fb54442d18p+2, 0x1.921fb54442d18p+9,
    0x1.6ac5b262ca1ffp+849, BESIDE(1e5), 0x1.62e42fefa39efp-1, 8.0, 20.0, 50.0, BESIDE(0x1.62e42fefa39efp+9), BESIDE(0x1.74910d52d3051p+9),
    BESIDE(0x1.6232bdd7abcd2p+9), 0x1p52, 0x1p60, 0x1p500, 0x1.8p700, 0x1.fffffffffffffp+1023,
};
const int function_special_count = (int)(sizeof function_specials / sizeof *function_specials);

double function_argument(const function_range *range, uint64_t *chance)
{
    if (!range->is_wide) return chance_between(chance, range->low, range->high);
    double share = 1.0 + chance_unit(chance);
    double size = ldexp(share, (int)range->low + (int)chance_below(chance, (size_t)(range->high - range->low)));
    return !range->is_positive && chance_u64(chance) & 1 ? -size : size;
}

double function_value(const function_case *function, double x, double y)
{
    return function->one ? function->one(x) : function->two(x, y);
}

uint64_t function_bits(double x)
{
    return x == x ? math_bits(x) : UINT64_C(0x7ff8000000000000);
}

static void say(FILE *out, const function_case *function, double x, double y)
{
    fprintf(out, "%s %016" PRIx64, function->name, function_bits(x));
    if (function->two) fprintf(out, " %016" PRIx64, function_bits(y));
    fprintf(out, " %016" PRIx64 "\n", function_bits(function_value(function, x, y)));
}

static void say_specials(FILE *out, const function_case *function)
{
    for (int i = 0; i < 2 * function_special_count; i++) {
        double x = i & 1 ? -function_specials[i / 2] : function_specials[i / 2];
        if (!function->two) say(out, function, x, 0.0);
        for (int k = 0; function->two && k < 14; k++) say(out, function, x, k & 1 ? -function_specials[k / 2 * 3] : function_specials[k / 2 * 3]);
    }
}

static void say_range(FILE *out, const function_case *function, const function_range *range)
{
    uint64_t chance = 1, hash = UINT64_C(0xcbf29ce484222325);
    for (int i = 0; i < HASHED; i++) {
        double x = function_argument(range, &chance), y = function->two ? function_argument(range, &chance) : 0.0;
        if (i < SAID) say(out, function, x, y);
        hash = (hash ^ function_bits(function_value(function, x, y))) * UINT64_C(0x100000001b3);
        hash ^= hash >> 29;
    }
    fprintf(out, "%s %s: %d values %016" PRIx64 "\n", function->name, range->name, HASHED, hash);
}

void functions_say(FILE *out)
{
    for (int i = 0; i < function_count; i++) {
        const function_case *function = &function_cases[i];
        say_specials(out, function);
        for (const function_range *range = function->ranges; range->name; range++) say_range(out, function, range);
    }
}
