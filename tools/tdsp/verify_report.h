/* SPDX-License-Identifier: MIT */
/* What verification found, gathered from the library's verdicts and from solving again. */
#ifndef VERIFY_REPORT_H
#define VERIFY_REPORT_H

#include <glib.h>

#include "json_out.h"
#include "path_json.h"
#include "tdsp/scene.h"
#include "scene_solver.h"
#include "tdsp/table.h"

typedef struct VerifyReport {
    GPtrArray *problems; /* sentences */
    GPtrArray *checked;
    double min_clearance; /* infinite without discs, or when no path was looked at */
    double time;
    guint32 disc;
} VerifyReport;

VerifyReport verify_report_new(void);
void verify_report_clear(VerifyReport *report);
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(VerifyReport, verify_report_clear)

gboolean verify_report_ok(const VerifyReport *report);
void verify_report_json(const GPtrArray *sentences, JsonOut *out);

/* By the library's verifier. */
gboolean verify_report_path(VerifyReport *report, const tdsp_scene *scene, const PathFile *path, GError **error);
gboolean verify_report_table(VerifyReport *report, const tdsp_scene *scene, const tdsp_table *table, GError **error);

/* By solving again, forwards in time and backwards. */
gboolean verify_deep_path(VerifyReport *report, const SceneSolver *solver, const PathFile *path, GError **error);
gboolean verify_deep_table(VerifyReport *report, const SceneSolver *solver, const tdsp_table *table, guint departures, GError **error);

/* Add a sentence. */
void verify_report_problem(VerifyReport *report, const char *format, ...) G_GNUC_PRINTF(2, 3);
void verify_report_checked(VerifyReport *report, const char *format, ...) G_GNUC_PRINTF(2, 3);

#endif
