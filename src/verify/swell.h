/* SPDX-License-Identifier: MIT */
/*
 * How the scene's discs grow, as the verifier reads it: pieces of polynomials, R(t) = sum c[k] (t - start)^k from a piece's start to the next one's. R never falls
 * (the scene refuses other laws, and what lies beyond tdsp_scene_valid_until() is not verified).
 */
#ifndef VERIFY_SWELL_H
#define VERIFY_SWELL_H

#include <stdint.h>

#include "tdsp/scene.h"
#include "verify/bernstein.h"

#define SWELL_DEGREE 8

/* A piece, the robot's radius included. */
typedef struct swell_piece {
    double start;
    double end; /* infinite for the last */
    int degree;
    double c[SWELL_DEGREE + 1];
} swell_piece;

/* A disc of one rate. */
swell_piece swell_of_rate(double radius, double growth);

/* Where rates change: the piece of a disc of the scene that holds at a time and right after it; the first for a time before 0. O(log pieces). */
swell_piece swell_at(const tdsp_scene *scene, uint32_t disc, double time);

/* Likewise: does a disc of the scene grow at one rate? */
int swell_is_rate(const tdsp_scene *scene, uint32_t disc);

double swell_radius(const swell_piece *piece, double time);

/* The largest number that the radius is computed from. */
double swell_magnitude(const swell_piece *piece, double time);

/* The radius over a time. */
bernstein swell_over(const swell_piece *piece, double from, double to);

#endif
