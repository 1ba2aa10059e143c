/*
 * Rates raised by an amount, and back: which amount a rate stands for.
 *
 * Both ways of raising are monotone in the amount x and in the rate V, up to the cap: x V, or V + x, which is never below 0. A rate at or over the
 * cap stays.
 */
#ifndef MARGIN_RAISE_H
#define MARGIN_RAISE_H

#include "tdsp/margin.h"

/* The scene's cap: no rate is raised over it. */
double raise_cap(const tdsp_scene *scene);

/* What a rate becomes. */
double raise_rate(tdsp_raise how, double amount, double rate, double cap);

/* The largest amount at which `rate` becomes no more than `most`: infinite when none is too large, -infinity when none is small enough. */
double raise_amount(tdsp_raise how, double most, double rate, double cap);

#endif
