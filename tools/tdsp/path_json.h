/* SPDX-License-Identifier: MIT */
/* Paths as JSON: the output of `tdsp path --json`, and back. */
#ifndef PATH_JSON_H
#define PATH_JSON_H

#include <glib.h>

#include "json_out.h"
#include "tdsp/types.h"

/* The value of "legs". */
void path_json_legs(JsonOut *out, const tdsp_leg *legs, gsize count);

typedef struct PathFile {
    double departure;
    double arrival; /* infinite when there is no path */
    char *status;
    GArray *legs; /* of tdsp_leg */
} PathFile;

/**
 * Read a path from `text`, which messages call `file`. The format leaves out how far an arc turns unless it is a curve: the two ends
 * tell it up to full laps, and `speed`, the robot's, tells the laps.
 */
gboolean path_json_parse(const char *file, const char *text, gsize length, double speed, PathFile *path, GError **error);

void path_file_clear(PathFile *path);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(PathFile, path_file_clear)

#endif
