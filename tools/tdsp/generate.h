/* SPDX-License-Identifier: MIT */
/* Made-up scenes. The same kind, n, seed and growth give the same scene on every machine. */
#ifndef GENERATE_H
#define GENERATE_H

#include <glib.h>

#include "tdsp/scene.h"

typedef struct Generated {
    tdsp_journey journey;
    GArray *discs; /* of tdsp_disc */
} Generated;

typedef struct GenerateOptions {
    guint n; /* discs; nsquared: discs of the chain, and gaps */
    guint64 seed;
    double growth; /* radius gained, in mean spacings, while the robot crosses the scene once; negative: the kind's own */
} GenerateOptions;

typedef struct GenerateKind {
    const char *name;
    guint least;   /* n */
    guint most;
    double growth; /* the kind's own; negative where the kind has no such choice */
    void (*make)(const GenerateOptions *options, Generated *out);
} GenerateKind;

/* The kind called `name`, or NULL. */
const GenerateKind *generate_kind(const char *name);
/* All names, for messages. */
char *generate_kinds(void);
/* The same as a list that ends with NULL. Free the list, not the names. */
const char **generate_kind_names(void);

void generate_columns(const GenerateOptions *options, Generated *out);
void generate_nsquared(const GenerateOptions *options, Generated *out);

#endif
