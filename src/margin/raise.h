/* SPDX-License-Identifier: MIT */
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

/* Does a disc grow otherwise than by rates that hold for a while? Such growth is raised without a cap. */
int raise_bends(const tdsp_scene *scene);

/* The slowest rate over 0 and the fastest rate that are below the cap; infinite and 0 where there is none. Of what bends, those at which it begins. */
void raise_range(const tdsp_scene *scene, double *slowest, double *fastest);

#endif
