/* SPDX-License-Identifier: MIT */
/* Verdicts of the library's verifier, in sentences. */
#include "verify_report.h"

#include <math.h>

#include "cli.h"
#include "tdsp/verify.h"

VerifyReport verify_report_new(void)
{
    return (VerifyReport){g_ptr_array_new_with_free_func(g_free), g_ptr_array_new_with_free_func(g_free), INFINITY, INFINITY,
                          TDSP_NO_DISC};
}

void verify_report_clear(VerifyReport *report)
{
    g_clear_pointer(&report->problems, g_ptr_array_unref);
    g_clear_pointer(&report->checked, g_ptr_array_unref);
}

gboolean verify_report_ok(const VerifyReport *report)
{
    return report->problems->len == 0;
}

void verify_report_json(const GPtrArray *sentences, JsonOut *out)
{
    json_out_begin(out, '[');
    for (guint i = 0; i < sentences->len; i++) json_out_string(out, g_ptr_array_index(sentences, i));
    json_out_end(out, ']');
}

void verify_report_problem(VerifyReport *report, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_ptr_array_add(report->problems, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

void verify_report_checked(VerifyReport *report, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    g_ptr_array_add(report->checked, g_strdup_vprintf(format, arguments));
    va_end(arguments);
}

static void take_verdict(VerifyReport *report, const char *what, const tdsp_verdict *verdict)
{
    static const struct {
        guint32 problem;
        const char *sentence;
    } sentences[] = {
        {TDSP_PROBLEM_START, "does not start at the source at the departure"},
        {TDSP_PROBLEM_END, "does not end at the destination at the arrival"},
        {TDSP_PROBLEM_JOIN, "legs do not join in place or time"},
        {TDSP_PROBLEM_SPEED, "faster than the robot"},
        {TDSP_PROBLEM_CLEARANCE, "enters a disc"},
        {TDSP_PROBLEM_LEG, "a leg is not well formed"},
    };
    for (gsize i = 0; i < G_N_ELEMENTS(sentences); i++)
        if (verdict->problems & sentences[i].problem)
            verify_report_problem(report, "%s: %s (leg %" G_GSIZE_FORMAT ")", what, sentences[i].sentence, verdict->leg);
    if (verdict->disc == TDSP_NO_DISC) return;
    report->min_clearance = verdict->min_clearance;
    report->time = verdict->time;
    report->disc = verdict->disc;
}

gboolean verify_report_path(VerifyReport *report, const tdsp_scene *scene, const PathFile *path, GError **error)
{
    tdsp_verdict verdict;
    if (!isfinite(path->arrival)) {
        verify_report_problem(report, "the file holds no path: its status is %s", path->status);
        return TRUE;
    }
    tdsp_status status = tdsp_verify_path(scene, (const tdsp_leg *)path->legs->data, path->legs->len, path->departure,
                                          path->arrival, &verdict);
    if (status != TDSP_OK) return cli_fail_status(error, "verify", status);
    take_verdict(report, "path", &verdict);
    verify_report_checked(report,
                          "path of %u leg%s: well formed, starts, joins and ends, top speed, clearance over the whole motion",
                          path->legs->len, path->legs->len == 1 ? "" : "s");
    return TRUE;
}

static void count_problem(VerifyReport *report, guint64 rows, const char *sentence)
{
    if (rows > 0) verify_report_problem(report, "%" G_GUINT64_FORMAT " row%s %s", rows, rows == 1 ? "" : "s", sentence);
}

gboolean verify_report_table(VerifyReport *report, const tdsp_scene *scene, const tdsp_table *table, GError **error)
{
    tdsp_table_verdict verdict;
    tdsp_table_info info;
    tdsp_status status = tdsp_verify_table(scene, table, &verdict);
    if (status == TDSP_OK) status = tdsp_table_get_info(table, &info);
    if (status != TDSP_OK) return cli_fail_status(error, "verify", status);
    if (verdict.stale) verify_report_problem(report, "the table was built for another scene");
    count_problem(report, verdict.bad_order, "out of order");
    count_problem(report, verdict.bad_ratio, "break the guarantee");
    count_problem(report, verdict.bad_paths, "with a path that was rejected");
    if (verdict.first_bad_row != UINT64_MAX)
        verify_report_problem(report, "the first of them is row %" G_GUINT64_FORMAT, verdict.first_bad_row);
    take_verdict(report, "worst path", &verdict.worst);
    if (!verdict.ok && verify_report_ok(report)) verify_report_problem(report, "the verifier rejects the table");
    verify_report_checked(report, "bytes, order, interval ratios, scene hash, and the paths of %" G_GUINT64_FORMAT " rows",
                          info.rows);
    return TRUE;
}
