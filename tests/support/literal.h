/* SPDX-License-Identifier: MIT */
/*
 * The search among growing discs as one writes it down first: a graph whose places are the ends of tangents, explored in the order of time.
 *
 * A rider on a disc passes the departure points of its tangents to all other discs, and to the goal; each is a label, whose tangent is tested when the
 * label is taken. Small scenes only: there are no bounds. The tangents are the library's (geom/tangent.h), the search is not.
 *
 * Each rule that a careless reading of the literature gets wrong can be put in its careless form, so that tests can show what that costs.
 */
#ifndef SUPPORT_LITERAL_H
#define SUPPORT_LITERAL_H

#include <stddef.h>

#include "tdsp/scene.h"

#define LITERAL_DISCS 40

/*
 * Who settles a departure point, so that nobody else's tangent there is looked at? It moves, and is known by its discs, its sides and its root.
 */
typedef enum literal_settling {
    LITERAL_NOBODY, /* right: riders are forgotten at places instead, where another was before (docs/math/search.md, 7.2) */
    LITERAL_FREE,   /* the first rider whose tangent is free */
    LITERAL_FIRST   /* the first rider; only then is the tangent tested */
} literal_settling;

typedef struct literal_rules {
    literal_settling settling;
    int first_root_only; /* tangents of the second root are left out */
    int no_concentric;   /* so are those between discs about one centre, for which the formula has no direction */
} literal_rules;

/* The earliest arrival, infinite where there is none. */
double literal_arrival(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, double departure, literal_rules rules);

/*
 * The search backwards in time from the destination at `arrival`, which may not wait: the latest departure of a path that arrives exactly
 * then, negative where there is none.
 */
double literal_departure(const tdsp_journey *journey, const tdsp_disc *discs, size_t count, double arrival, literal_rules rules);

#endif
