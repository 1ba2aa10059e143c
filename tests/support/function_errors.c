/* SPDX-License-Identifier: MIT */
#include "support/function_errors.h"

#include <float.h>
#include <math.h>

#define BEYOND_DOUBLES (LDBL_MANT_DIG >= 64)

const function_reference function_references[] = {
    {"sin", sinl, NULL, sin, NULL, 0.65},      {"cos", cosl, NULL, cos, NULL, 0.65},      {"sine of both", sinl, NULL, sin, NULL, 0.65},
    {"cosine of both", cosl, NULL, cos, NULL, 0.65}, {"atan2", NULL, atan2l, NULL, atan2, 0.65}, {"asin", asinl, NULL, asin, NULL, 0.65},
    {"acos", acosl, NULL, acos, NULL, 0.65},   {"log", logl, NULL, log, NULL, 0.7},       {"log1p", log1pl, NULL, log1p, NULL, 0.7},
    {"exp", expl, NULL, exp, NULL, 0.6},       {"expm1", expm1l, NULL, expm1, NULL, 0.75}, {"hypot", NULL, hypotl, NULL, hypot, 0.75},
};

double function_reference_error(void)
{
    return BEYOND_DOUBLES ? 0.0 : 1.0;
}

function_number function_true(int function, double x, double y)
{
    const function_reference *reference = &function_references[function];
    return reference->one ? reference->one(x) : reference->two(x, y);
}

int function_is_small(function_number wanted)
{
    return fabsl(wanted) < DBL_MIN;
}

static function_number last_place(function_number x)
{
    int exponent;
    frexpl(x, &exponent);
    return ldexpl(1.0L, exponent < -1021 ? -1074 : exponent - 53);
}

double function_error(double found, function_number wanted)
{
    double nearest = (double)wanted;
    if (found == nearest && (isinf(found) || wanted == 0.0L)) return !signbit(found) == !signbit(nearest) ? 0.0 : INFINITY;
    if (isnan(found) && isnan(nearest)) return 0.0;
    if (!isfinite(found) || !isfinite(nearest)) return INFINITY;
    return (double)(fabsl(found - wanted) / last_place(wanted));
}

double function_bound(int function, function_number wanted)
{
    return (function_is_small(wanted) ? 1.0 : function_references[function].bound) + function_reference_error();
}

function_worst function_measure(int function, const function_range *range, long count, uint64_t seed)
{
    const function_reference *reference = &function_references[function];
    function_worst worst = {0};
    for (long i = 0; i < count; i++) {
        double x = function_argument(range, &seed), y = reference->two ? function_argument(range, &seed) : 0.0;
        function_number wanted = function_true(function, x, y);
        double error = function_error(function_value(&function_cases[function], x, y), wanted), part = error / function_bound(function, wanted);
        double peer = function_error(reference->one ? reference->peer(x) : reference->peer_two(x, y), wanted);
        worst.peer_error = fmax(worst.peer_error, peer);
        if (!(part > worst.part)) continue;
        worst = (function_worst){error, worst.peer_error, part, x, y};
    }
    return worst;
}
