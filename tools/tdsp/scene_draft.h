/* SPDX-License-Identifier: MIT */
/*
 * A scene while it is put together: what a file of any format says, with its places as the file has them, and then what options and another scene add.
 */
#ifndef SCENE_DRAFT_H
#define SCENE_DRAFT_H

#include <glib.h>

#include "scene_description.h"

/* What fields, columns or properties, are called; and what stands in for a disc's missing values (negative: nothing does). */
typedef struct DraftFields {
    const char *role, *radius, *growth; /* not NULL */
    const char *x, *y, *lon, *lat;      /* of CSV; NULL: by their usual names */
    double missing_radius, missing_growth;
} DraftFields;

/* What options say: NULL where they are not given, as text. */
typedef struct DraftOptions {
    char *name, *units, *origin, *from, *to, *speed, *robot_radius;
} DraftOptions;

typedef struct SceneDraft {
    const char *file;
    gboolean geographic; /* places are longitude and latitude, as x and y */
    gboolean features;   /* items are features; else lines */
    SceneDescription scene;
    gboolean has_source, has_destination;
    guint source_item, destination_item;
    GArray *items;       /* of guint: for each disc, the item that it comes from */
    GHashTable *ignored; /* names of fields that nothing was made of */
} SceneDraft;

/* One line or feature. Numbers that it does not say are NAN. */
typedef struct DraftItem {
    guint item;
    const char *role; /* "" for a disc */
    tdsp_point place;
    double radius, speed;
    gboolean has_growth;
    tdsp_growth growth; /* points into scene.kept */
} DraftItem;

SceneDraft scene_draft_new(const char *file);

/* Take an item up. NULL, or what is wrong with it. */
const char *scene_draft_add(SceneDraft *draft, const DraftItem *item, const DraftFields *fields);

/*
 * Complete the draft: what the options say goes before what the file says, and that before `like`, another scene (or NULL). Units and origins may not
 * contradict each other. Geographic places are projected.
 */
gboolean scene_draft_finish(SceneDraft *draft, const DraftOptions *options, const SceneDescription *like, GError **error);

/* Only its name and units; `plane` receives the georeference that options or `like` ask for. */
gboolean scene_draft_head(SceneDraft *draft, const DraftOptions *options, const SceneDescription *like, Georeference *plane, GError **error);

void scene_draft_clear(SceneDraft *draft);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(SceneDraft, scene_draft_clear)

#endif
