/* SPDX-License-Identifier: MIT */
/*
 * Discs that grow otherwise than at one rate: polynomials, rates that change at given times, and laws by callback.
 *
 * Whatever the law, a disc never shrinks, and the robot's own top speed decides which of its boundary can be ridden. See docs/math.md.
 */
#ifndef TDSP_GROWTH_H
#define TDSP_GROWTH_H

#include "tdsp/scene.h"
#include "tdsp/status.h"
#include "tdsp/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The highest power of time in a polynomial. */
#define TDSP_GROWTH_DEGREE 8u

/** How a disc grows. */
typedef enum tdsp_growth_kind {
    TDSP_GROWTH_RATE = 0,       /* R(t) = radius + rate t */
    TDSP_GROWTH_POLYNOMIAL = 1, /* R(t) = radius + values[0] t + values[1] t^2 + ... */
    TDSP_GROWTH_RATES = 2,      /* R'(t) = values[k] for t from times[k] to times[k + 1], the last for ever */
    TDSP_GROWTH_LAW = 3         /* whatever `law` says */
} tdsp_growth_kind;

/**
 * A law of growth: *radius = R(time), a length, without the robot's radius, and *rate = R'(time), a length per time; where the rate jumps,
 * the one that holds from then on.
 *
 * Conditions: R is continuous and never falls; between the kinks that are given (tdsp_growth.times) it is smooth; the same time always has the same
 * answer. It is called while the scene is made, for times from 0 to `until`, in no order, and not afterwards: the scene keeps pieces of polynomials
 * that follow it to 1e-13 of the radius at the end of each piece, and to what the disc grows in the rounding of a time. Kinks that are not given
 * are found by halving, which takes some thousand calls each, and ends where what is left of the jump moves the radius by less than that. What happens
 * between two times at which the law was asked, at most 1/64 of `until` apart, can hide only as far as the disc grows between them.
 *
 * A law that breaks a condition where it is looked at, or takes more than 16384 pieces, is refused.
 */
typedef void (*tdsp_growth_law)(void *ctx, double time, double *radius, double *rate);

/** One disc's growth. Initialise with zeros; members that a kind does not name are not looked at. No number is beyond 1e100. */
typedef struct tdsp_growth {
    tdsp_growth_kind kind; /* which of the members count */
    double rate;          /* RATE: not negative */
    size_t count;         /* POLYNOMIAL: coefficients, 1 to TDSP_GROWTH_DEGREE; RATES: rates, 1 to 2^31 - 1; LAW: kinks, 0 or more */
    const double *values; /* POLYNOMIAL: the coefficients, of any sign; RATES: the rates, not negative */
    const double *times;  /* RATES: when each begins, times[0] = 0, increasing; LAW: the kinks, over 0, increasing: where R is not smooth */
    tdsp_growth_law law;  /* LAW */
    void *ctx;            /* LAW: handed to it */
    double until;         /* LAW: followed up to this time, over 0, finite; from then on the disc keeps the rate that it has there */
} tdsp_growth;

/** A disc with any growth. */
typedef struct tdsp_growing_disc {
    tdsp_point center; /* length */
    double radius;     /* length, at t = 0, not negative; the robot's radius is not included. LAW: the law's at 0, to 1e-13 of it */
    tdsp_growth growth; /* how it grows from then on */
} tdsp_growing_disc;

/**
 * As tdsp_scene_create(), for discs with any growth. Everything is copied.
 *
 * A polynomial must not shrink from t = 0 on. It may later: questions are then answered as long as the answer needs no time after that
 * (tdsp_scene_valid_until()), and refused with TDSP_SHRINKS otherwise. Where a rate comes down to zero and rises again, its coefficients' last bits do not
 * make it shrink: each is taken to be known to 2^-46 of itself.
 *
 * @return as tdsp_scene_create(); TDSP_BAD_SCENE also for a growth out of its range (which: tdsp_growing_disc_check())
 *
 * A scene in which every disc comes down to one rate is the same as from tdsp_scene_create(), to the bit of every answer. In others, the `growth` of
 * tdsp_scene_discs() is the rate at time 0, and 88 bytes are held for each piece: one for a polynomial (two where it shrinks), one for each rate.
 * O(pieces). Since 0.1.
 */
TDSP_API tdsp_status tdsp_scene_create_growing(const tdsp_journey *journey, const tdsp_growing_disc *discs, size_t count,
                                               const tdsp_allocator *allocator, tdsp_scene **out);

/** NULL when the disc is in range, else a static sentence that says what is wrong. A law is followed to its end. No memory. Since 0.1. */
TDSP_API const char *tdsp_growing_disc_check(const tdsp_growing_disc *disc);

/** Does every disc come down to one rate? O(1). Since 0.1. */
TDSP_API int tdsp_scene_has_rates_only(const tdsp_scene *scene);

/**
 * A disc of the scene at a time: its radius without the robot's, and its rate (from then on where it jumps). Either may be NULL. From the moment on
 * at which a radius would shrink, it stays.
 *
 * @return TDSP_OK; TDSP_INVALID_ARGUMENT for NULL, an index out of range, a time that is negative or not finite. O(log pieces). Since 0.1.
 */
TDSP_API tdsp_status tdsp_scene_disc_at(const tdsp_scene *scene, uint32_t disc, double time, double *radius, double *rate);

/**
 * The last moment up to which no radius shrinks; infinite when none ever does. `disc`, where not NULL, receives the disc that shrinks first, or
 * TDSP_NO_DISC. O(1). Since 0.1.
 */
TDSP_API double tdsp_scene_valid_until(const tdsp_scene *scene, uint32_t *disc);

#ifdef __cplusplus
}
#endif

#endif
