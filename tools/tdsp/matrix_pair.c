/* SPDX-License-Identifier: MIT */
/* Matrices on the command line. */
#include "matrix_pair.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "numbers.h"
#include "tdsp/verify.h"
#include "text_table.h"

typedef tdsp_status (*EndReader)(const tdsp_matrix *matrix, uint64_t i, tdsp_matrix_end *out);

/* A name wins over a number. */
static gboolean find_end(const FileIn *file, EndReader reader, guint64 count, const char *option, const char *text, guint64 *found, GError **error)
{
    guint64 named = 0, number;
    for (guint64 i = 0; i < count; i++) {
        tdsp_matrix_end end;
        if (reader(&file->matrix, i, &end) != TDSP_OK || end.name_length != strlen(text) || end.name_length == 0) continue;
        if (memcmp(end.name, text, end.name_length) != 0) continue;
        if (named++ > 0) return cli_fail(error, CLI_USAGE, "%s \"%s\": more than one has that name; give its number", option, text);
        *found = i;
    }
    if (named == 1) return TRUE;
    if (number_parse_whole(text, 0, count - 1, &number))
        return cli_fail(error, CLI_USAGE, "%s \"%s\": no name in %s, and no number from 0 to %" G_GUINT64_FORMAT, option, text,
                        cli_file_name(file->path), count - 1);
    *found = number;
    return TRUE;
}

gboolean matrix_pair_find(const FileIn *file, const char *from, const char *to, guint64 *i, guint64 *j, GError **error)
{
    uint64_t sources, destinations;
    tdsp_matrix_size(&file->matrix, &sources, &destinations);
    if (!from || !to)
        return cli_fail(error, CLI_USAGE, "%s holds many tables: say which with --from and --to", cli_file_name(file->path));
    return find_end(file, tdsp_matrix_source, sources, "--from", from, i, error) &&
           find_end(file, tdsp_matrix_destination, destinations, "--to", to, j, error);
}

static char *name_of(const tdsp_matrix_end *end)
{
    return end->name_length > 0 ? g_strndup(end->name, end->name_length) : NULL;
}

/* A pair as it is printed. */
typedef struct PairFacts {
    tdsp_status status;
    tdsp_table_info info;
} PairFacts;

static PairFacts facts_of(const tdsp_matrix *matrix, guint64 i, guint64 j)
{
    tdsp_table table;
    PairFacts facts = {.status = tdsp_matrix_table(matrix, i, j, &table)};
    if (facts.status == TDSP_OK) tdsp_table_get_info(&table, &facts.info);
    return facts;
}

static void json_ends(JsonOut *out, const char *key, const tdsp_matrix *matrix, EndReader reader, guint64 count)
{
    json_out_key(out, key);
    json_out_begin(out, '[');
    for (guint64 i = 0; i < count; i++) {
        tdsp_matrix_end end;
        reader(matrix, i, &end);
        g_autofree char *name = name_of(&end);
        json_out_begin(out, '{');
        json_out_member_point(out, "place", end.place);
        json_out_member_string(out, "name", name);
        json_out_end(out, '}');
    }
    json_out_end(out, ']');
}

static void json_pair(JsonOut *out, guint64 i, guint64 j, const PairFacts *facts)
{
    gboolean found = facts->status == TDSP_OK;
    json_out_line(out);
    json_out_begin(out, '{');
    json_out_member_whole(out, "from", i);
    json_out_member_whole(out, "to", j);
    json_out_member_string(out, "status", tdsp_status_name(facts->status));
    json_out_member_whole(out, "rows", found ? facts->info.rows : 0);
    json_out_member_whole(out, "bytes", found ? facts->info.length : 0);
    json_out_member_number(out, "last_departure", found ? facts->info.last_departure : INFINITY);
    json_out_member_string(out, "last_reason", tdsp_status_name(found ? facts->info.last_reason : facts->status));
    json_out_end(out, '}');
}

static gboolean print_json(const FileIn *file, guint64 sources, guint64 destinations, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_string(&out, "matrix", cli_file_name(file->path));
    json_out_member_whole(&out, "bytes", file->length);
    json_ends(&out, "sources", &file->matrix, tdsp_matrix_source, sources);
    json_ends(&out, "destinations", &file->matrix, tdsp_matrix_destination, destinations);
    json_out_key(&out, "pairs");
    json_out_begin(&out, '[');
    for (guint64 i = 0; i < sources; i++)
        for (guint64 j = 0; j < destinations; j++) {
            PairFacts facts = facts_of(&file->matrix, i, j);
            json_pair(&out, i, j, &facts);
        }
    json_out_end(&out, ']');
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static void text_end(TextTable *table, const tdsp_matrix *matrix, EndReader reader, guint64 i)
{
    tdsp_matrix_end end;
    reader(matrix, i, &end);
    g_autofree char *name = name_of(&end);
    g_autofree char *text = name ? g_strdup(name) : g_strdup_printf("%" G_GUINT64_FORMAT, i);
    text_table_string(table, text);
}

static gboolean print_text(const FileIn *file, guint64 sources, guint64 destinations, GError **error)
{
    static const char *const heading[] = {"from", "to", "status", "rows", "last_departure", "last_reason", NULL};
    g_auto(TextTable) table = text_table_new(heading);
    g_autoptr(GString) text = g_string_new(NULL);
    g_string_printf(text, "%s: a matrix of %" G_GUINT64_FORMAT " sources and %" G_GUINT64_FORMAT " destinations, %" G_GSIZE_FORMAT " bytes\n",
                    cli_file_name(file->path), sources, destinations, file->length);
    for (guint64 i = 0; i < sources; i++)
        for (guint64 j = 0; j < destinations; j++) {
            PairFacts facts = facts_of(&file->matrix, i, j);
            gboolean found = facts.status == TDSP_OK;
            text_end(&table, &file->matrix, tdsp_matrix_source, i);
            text_end(&table, &file->matrix, tdsp_matrix_destination, j);
            text_table_string(&table, tdsp_status_name(facts.status));
            text_table_number(&table, found ? (double)facts.info.rows : 0);
            text_table_number(&table, found ? facts.info.last_departure : INFINITY);
            text_table_string(&table, tdsp_status_name(found ? facts.info.last_reason : facts.status));
        }
    text_table_append(&table, text);
    return cli_print(text, error);
}

gboolean matrix_pair_print(const FileIn *file, gboolean json, GError **error)
{
    uint64_t sources, destinations;
    tdsp_matrix_size(&file->matrix, &sources, &destinations);
    return json ? print_json(file, sources, destinations, error) : print_text(file, sources, destinations, error);
}

/* A pair without a table. Only that an end is covered can be seen without a search. */
static void verify_reason(VerifyReport *report, const tdsp_scene *scene, const tdsp_ends *ends, guint64 i, guint64 j, tdsp_status status)
{
    gboolean covered = tdsp_scene_free_until(scene, ends->source, NULL) < 0;
    if (covered != (status == TDSP_SOURCE_COVERED))
        verify_report_problem(report, "pair %" G_GUINT64_FORMAT ", %" G_GUINT64_FORMAT ": %s, but the source is %s at departure 0", i, j,
                              tdsp_status_name(status), covered ? "covered" : "free");
}

static gboolean verify_pair(VerifyReport *report, const tdsp_scene *scene, const tdsp_matrix *matrix, guint64 i, guint64 j, GError **error)
{
    tdsp_matrix_end from, to;
    tdsp_table table;
    tdsp_table_verdict verdict;
    tdsp_matrix_source(matrix, i, &from);
    tdsp_matrix_destination(matrix, j, &to);
    const tdsp_ends ends = {from.place, to.place};
    tdsp_status status = tdsp_matrix_table(matrix, i, j, &table);
    if (status != TDSP_OK) {
        verify_reason(report, scene, &ends, i, j, status);
        return TRUE;
    }
    status = tdsp_verify_table_for(scene, &ends, &table, &verdict);
    if (status != TDSP_OK) return cli_fail_status(error, "verify", status);
    if (!verdict.ok)
        verify_report_problem(report, "pair %" G_GUINT64_FORMAT ", %" G_GUINT64_FORMAT ": %s", i, j,
                              verdict.stale ? "the table was built for another scene" : "the verifier rejects the table");
    if (verdict.worst.disc == TDSP_NO_DISC || verdict.worst.min_clearance >= report->min_clearance) return TRUE;
    report->min_clearance = verdict.worst.min_clearance;
    report->time = verdict.worst.time;
    report->disc = verdict.worst.disc;
    return TRUE;
}

gboolean matrix_pair_verify(VerifyReport *report, const tdsp_scene *scene, const tdsp_matrix *matrix, GError **error)
{
    uint64_t sources, destinations;
    tdsp_matrix_size(matrix, &sources, &destinations);
    for (guint64 i = 0; i < sources; i++)
        for (guint64 j = 0; j < destinations; j++)
            if (!verify_pair(report, scene, matrix, i, j, error)) return FALSE;
    verify_report_checked(report, "bytes, and of %" G_GUINT64_FORMAT " pairs the order, interval ratios, scene hash and all paths of their tables",
                          (guint64)sources * destinations);
    return TRUE;
}
