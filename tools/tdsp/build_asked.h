/* SPDX-License-Identifier: MIT */
/* What is asked of the sampler: the options that `build` and `matrix` share. */
#ifndef BUILD_ASKED_H
#define BUILD_ASKED_H

#include "scene_file.h"
#include "tdsp/build.h"

typedef struct BuildAsked {
    gboolean exact;
    char *guarantee, *sampling, *epsilon, *delta, *horizon, *max_rows, *threads, *output; /* as given; NULL: not given */
    guint threads_count;
    tdsp_build_options options;
} BuildAsked;

/* Entries for cli_parse(); `what` is what is written. */
#define BUILD_ASKED_ENTRIES(asked, file, what)                                                                                   \
    {"output", 'o', 0, G_OPTION_ARG_FILENAME, &(asked)->output, "Write the " what " to " file, file},                            \
    {"guarantee", 0, 0, G_OPTION_ARG_STRING, &(asked)->guarantee, "travel (default), arrival or absolute", "GUARANTEE"},        \
    {"epsilon", 0, 0, G_OPTION_ARG_STRING, &(asked)->epsilon,                                                                    \
     "Travel and arrival: bound of the ratio, 1e-9 to 1 (default 0.01)", "E"},                                                   \
    {"delta", 0, 0, G_OPTION_ARG_STRING, &(asked)->delta, "Absolute: bound of the difference, in the scene's unit of time",      \
     "D"},                                                                                                                       \
    {"sampling", 0, 0, G_OPTION_ARG_STRING, &(asked)->sampling, "adaptive (default), or geometric (guarantee arrival)",         \
     "SAMPLING"},                                                                                                                \
    {"horizon", 0, 0, G_OPTION_ARG_STRING, &(asked)->horizon, "Latest departure; needed where no disc ever ends them", "H"},      \
    {"max-rows", 0, 0, G_OPTION_ARG_STRING, &(asked)->max_rows, "Give up when a table needs more rows (default and most: 2^24)", "N"}, \
    {"exact", 0, 0, G_OPTION_ARG_NONE, &(asked)->exact,                                                                          \
     "Ask for exact arrivals only, also where nearly the best would do and cost far less", NULL},                                \
    {"threads", 0, 0, G_OPTION_ARG_STRING, &(asked)->threads, "Threads (default: one a processor); never changes the " what,     \
     "N"}

/* Turn what was given into options; the output is needed. */
gboolean build_asked_parse(BuildAsked *asked, const char *file, GError **error);

/* The world that tables of the scene are about. */
gboolean build_asked_world(const char *path, const SceneFile *scene, tdsp_build_world *world, GError **error);

/* Turn the sampler's status that is no answer into an error. Returns FALSE. */
gboolean build_asked_fail(const BuildAsked *asked, const SceneFile *scene, tdsp_status status, GError **error);

void build_asked_clear(BuildAsked *asked);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(BuildAsked, build_asked_clear)

#endif
