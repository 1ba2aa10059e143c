/* SPDX-License-Identifier: MIT */
/*
 * Properties over random scenes of every growth law, as property.h has them for discs of one rate, and with its environment:
 * TDSP_PROPERTY_SCENES multiplies the number of scenes (default 1), TDSP_PROPERTY_SEED moves all seeds (default 0),
 * TDSP_PROPERTY_MIX names the one mix to try (default: all).
 */
#ifndef SUPPORT_GROWTH_PROPERTY_H
#define SUPPORT_GROWTH_PROPERTY_H

#include <stddef.h>
#include <stdint.h>

#include "slow/law.h"
#include "support/random_growth.h"

typedef struct grown_case {
    const char *name; /* of the mix */
    uint64_t seed;
    grown_scene scene;
    double valid;    /* up to when no radius shrinks, at most some journeys */
    uint64_t chance; /* for the property's own choices */
} grown_case;

/* Call `check` with `scenes` scenes of each mix (times TDSP_PROPERTY_SCENES), of 1 to `most` discs. */
void grown_each(int scenes, size_t most, void (*check)(grown_case *c));

/* The slow solver's arrival, of those up to `until`. With `places`: its path. */
double grown_slow(const grown_case *c, double until, double departure);
double grown_slow_path(const grown_case *c, double until, double departure, slow_law_place *places, size_t capacity,
                       size_t *count);

/* Whether a point is clear of every disc at a time, but for `slack`. */
int grown_clear(const grown_case *c, tdsp_point at, double time, double slack);

/* Print the case and fail. */
void grown_fail(const grown_case *c, const char *text, double a, double b, const char *file, int line);

#define grown_holds(c, condition)                                                                                                \
    do {                                                                                                                         \
        if (!(condition)) grown_fail((c), #condition, 0.0, 0.0, __FILE__, __LINE__);                                             \
    } while (0)

/* The same with two numbers that say why. */
#define grown_relates(c, a, relation, b)                                                                                         \
    do {                                                                                                                         \
        const double relates_a = (a), relates_b = (b);                                                                           \
        if (!(relates_a relation relates_b)) grown_fail((c), #a " " #relation " " #b, relates_a, relates_b, __FILE__, __LINE__); \
    } while (0)

#endif
