/* SPDX-License-Identifier: MIT */
/* What tdsp convert was asked for: its options, and the kinds of files. */
#ifndef CONVERT_ASKED_H
#define CONVERT_ASKED_H

#include <glib.h>

#include "scene_draft.h"

/* The formats in the order of words.h, and the output of tdsp path --json. */
typedef enum ConvertKind { CONVERT_JSON, CONVERT_CSV, CONVERT_GEOJSON, CONVERT_GPX, CONVERT_PATH, CONVERT_KINDS } ConvertKind;

/* A word for each: "json" is a scene file. */
const char *convert_kind_word(ConvertKind kind);

typedef struct ConvertAsked {
    gboolean json;
    DraftOptions draft; /* the texts of these and of what follows: NULL where not given */
    char *format, *output, *scene, *radius, *growth, *epoch, *tolerance;
    char *role_field, *radius_field, *growth_field, *x_field, *y_field, *lon_field, *lat_field;
    DraftFields fields;      /* as read by convert_asked_check(); points to the texts */
    double tolerance_length; /* 0: not given */
} ConvertAsked;

/* Entries for GOption; free with g_free(). */
GOptionEntry *convert_asked_entries(ConvertAsked *asked);

/* Find out what a file is. */
gboolean convert_kind_of(const char *file, const char *text, gsize length, ConvertKind *kind, GError **error);

/* What the output is to be, and whether the options are for that; numbers are read. */
gboolean convert_asked_check(ConvertAsked *asked, const char *file, ConvertKind from, ConvertKind *to, GError **error);

void convert_asked_clear(ConvertAsked *asked);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(ConvertAsked, convert_asked_clear)

#endif
