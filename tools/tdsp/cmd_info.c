/* SPDX-License-Identifier: MIT */
/* tdsp info: what a table's header says, and its jumps. */
#include <string.h>

#include "commands.h"
#include "file_in.h"
#include "json_out.h"
#include "matrix_pair.h"
#include "numbers.h"
#include "shape_asked.h"
#include "tdsp/table.h"
#include "words.h"

#define JUMPS_SHOWN 10 /* in text; JSON lists all */

typedef struct Facts {
    tdsp_table_info info;
    tdsp_row first, last;
    GArray *jumps; /* of tdsp_jump */
} Facts;

static void facts_clear(Facts *facts)
{
    g_clear_pointer(&facts->jumps, g_array_unref);
}
G_DEFINE_AUTO_CLEANUP_CLEAR_FUNC(Facts, facts_clear)

/* The next jump is looked for from the row behind the last one. */
static tdsp_status find_jumps(const tdsp_table *table, guint64 rows, GArray *jumps)
{
    double from = 0;
    for (;;) {
        tdsp_jump jump;
        tdsp_row next;
        tdsp_status status = tdsp_table_next_jump(table, from, &jump);
        if (status == TDSP_NO_ANSWER) return TDSP_OK;
        if (status != TDSP_OK) return status;
        g_array_append_val(jumps, jump);
        if (jump.row + 1 >= rows) return TDSP_OK;
        status = tdsp_table_row(table, jump.row + 1, &next);
        if (status != TDSP_OK) return status;
        from = next.departure;
    }
}

static gboolean gather(const tdsp_table *table, Facts *facts, GError **error)
{
    facts->jumps = g_array_new(FALSE, FALSE, sizeof(tdsp_jump));
    tdsp_status status = tdsp_table_get_info(table, &facts->info);
    if (status == TDSP_OK) status = tdsp_table_row(table, 0, &facts->first);
    if (status == TDSP_OK) status = tdsp_table_row(table, facts->info.rows - 1, &facts->last);
    if (status == TDSP_OK) status = find_jumps(table, facts->info.rows, facts->jumps);
    return status == TDSP_OK ? TRUE : cli_fail_status(error, "table", status);
}

static double bytes_per_row(const tdsp_table_info *info)
{
    return (double)info->length / (double)info->rows;
}

static void json_units(JsonOut *out, const tdsp_table_info *info)
{
    json_out_key(out, "units");
    json_out_begin(out, '{');
    json_out_member_string(out, "length", info->length_unit);
    json_out_member_string(out, "time", info->time_unit);
    json_out_end(out, '}');
}

static void json_jumps(JsonOut *out, const GArray *jumps)
{
    json_out_key(out, "jumps");
    json_out_begin(out, '[');
    for (guint i = 0; i < jumps->len; i++) {
        const tdsp_jump *jump = &g_array_index(jumps, tdsp_jump, i);
        json_out_line(out);
        json_out_begin(out, '{');
        json_out_member_whole(out, "row", jump->row);
        json_out_member_number(out, "departure", jump->departure);
        json_out_member_number(out, "before", jump->before);
        json_out_member_number(out, "after", jump->after);
        json_out_member_number(out, "size", jump->after - jump->before);
        shape_json_gap(out, &jump->gap);
        json_out_end(out, '}');
    }
    json_out_end(out, ']');
}

static void json_guarantee(JsonOut *out, const tdsp_table_info *info)
{
    gboolean absolute = info->guarantee == TDSP_GUARANTEE_ABSOLUTE;
    json_out_member_string(out, "guarantee", words_guarantee(info->guarantee));
    json_out_key(out, "epsilon");
    absolute ? json_out_null(out) : json_out_number(out, info->epsilon);
    json_out_key(out, "delta");
    absolute ? json_out_number(out, info->delta) : json_out_null(out);
    json_out_member_string(out, "sampling", words_sampling(info->sampling));
    json_out_member_string(out, "monotone", words_monotone(info->monotone));
    json_out_member_number(out, "error", info->error);
}

static gboolean print_json(const char *path, const Facts *facts, GError **error)
{
    const tdsp_table_info *info = &facts->info;
    g_autofree char *version = g_strdup_printf("%u.%u", info->version_major, info->version_minor);
    g_autofree char *hash = g_strdup_printf("%016" G_GINT64_MODIFIER "x", info->scene_hash);
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_string(&out, "table", path);
    json_out_member_string(&out, "format_version", version);
    json_out_member_whole(&out, "bytes", info->length);
    json_out_member_whole(&out, "rows", info->rows);
    json_out_member_whole(&out, "legs", info->legs);
    json_out_member_whole(&out, "curves", info->curves);
    json_out_member_number(&out, "bytes_per_row", bytes_per_row(info));
    json_out_member_whole(&out, "guide_bytes", info->guide_length);
    json_guarantee(&out, info);
    json_out_member_string(&out, "scene_hash", hash);
    json_units(&out, info);
    json_out_member_number(&out, "speed", info->speed);
    json_out_member_point(&out, "source", info->source);
    json_out_member_point(&out, "destination", info->destination);
    json_out_member_number(&out, "first_departure", info->first_departure);
    json_out_member_number(&out, "last_departure", info->last_departure);
    json_out_member_string(&out, "last_reason", tdsp_status_name(info->last_reason));
    json_out_member_number(&out, "first_travel_time", facts->first.left);
    json_out_member_number(&out, "last_travel_time", facts->last.left);
    json_jumps(&out, facts->jumps);
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static void text_number(GString *text, const char *label, double value, const char *unit)
{
    char buffer[NUMBER_ROOM];
    g_string_append_printf(text, "%-18s%s%s%s\n", label, number_format(buffer, value), *unit ? " " : "", unit);
}

static void text_point(GString *text, const char *label, tdsp_point point, const char *unit)
{
    char x[NUMBER_ROOM], y[NUMBER_ROOM];
    g_string_append_printf(text, "%-18s(%s, %s)%s%s\n", label, number_format(x, point.x), number_format(y, point.y),
                           *unit ? " " : "", unit);
}

static void text_head(GString *text, const char *path, const tdsp_table_info *info)
{
    char per_row[NUMBER_ROOM], bound[NUMBER_ROOM];
    gboolean absolute = info->guarantee == TDSP_GUARANTEE_ABSOLUTE;
    g_string_append_printf(text, "%s: table, format %u.%u\n", path, info->version_major, info->version_minor);
    g_string_append_printf(
        text, "%-18s%" G_GUINT64_FORMAT " rows, %" G_GUINT64_FORMAT " legs, %" G_GUINT64_FORMAT " bytes (%s a row)\n", "size",
        info->rows, info->legs, info->length, number_brief(per_row, bytes_per_row(info), 5));
    if (info->curves > 0) g_string_append_printf(text, "%-18s%" G_GUINT64_FORMAT "\n", "curves", info->curves);
    if (info->guide_length > 0)
        g_string_append_printf(text, "%-18s%" G_GUINT64_FORMAT " bytes\n", "guides", info->guide_length);
    g_string_append_printf(text, "%-18s%s, %s %s, %s sampling\n", "guarantee", words_guarantee(info->guarantee),
                           absolute ? "delta" : "epsilon", number_format(bound, absolute ? info->delta : info->epsilon),
                           words_sampling(info->sampling));
    g_string_append_printf(text, "%-18s%s\n", "monotone in", words_monotone(info->monotone));
    g_string_append_printf(text, "%-18s%016" G_GINT64_MODIFIER "x\n", "scene hash", info->scene_hash);
}

/* What closes, when and where. */
static void text_gap(GString *text, const tdsp_gap *gap, const tdsp_table_info *info)
{
    char time[NUMBER_ROOM], x[NUMBER_ROOM], y[NUMBER_ROOM];
    if (gap->first == TDSP_NO_DISC) return;
    g_autofree char *discs = shape_gap_discs(gap);
    g_string_append_printf(text, "    discs %s close at %s%s%s, at (%s, %s)%s%s\n", discs, number_brief(time, gap->time, 10),
                           *info->time_unit ? " " : "", info->time_unit, number_brief(x, gap->place.x, 10), number_brief(y, gap->place.y, 10),
                           *info->length_unit ? " " : "", info->length_unit);
}

/* The first ones. */
static void text_jumps(GString *text, const GArray *jumps, const tdsp_table_info *info)
{
    char departure[NUMBER_ROOM], before[NUMBER_ROOM], after[NUMBER_ROOM];
    g_string_append_printf(text, "%-18s%u\n", "jumps", jumps->len);
    for (guint i = 0; i < MIN(jumps->len, JUMPS_SHOWN); i++) {
        const tdsp_jump *jump = &g_array_index(jumps, tdsp_jump, i);
        g_string_append_printf(text, "  after departure %s the travel time jumps from %s to %s\n",
                               number_format(departure, jump->departure), number_format(before, jump->before),
                               number_format(after, jump->after));
        text_gap(text, &jump->gap, info);
    }
    if (jumps->len > JUMPS_SHOWN) g_string_append_printf(text, "  and %u more (--json lists all)\n", jumps->len - JUMPS_SHOWN);
}

static gboolean print_text(const char *path, const Facts *facts, GError **error)
{
    const tdsp_table_info *info = &facts->info;
    g_autofree char *per_time =
        *info->length_unit && *info->time_unit ? g_strdup_printf("%s/%s", info->length_unit, info->time_unit) : g_strdup("");
    g_autoptr(GString) text = g_string_new(NULL);
    text_head(text, path, info);
    text_number(text, "speed", info->speed, per_time);
    text_point(text, "source", info->source, info->length_unit);
    text_point(text, "destination", info->destination, info->length_unit);
    text_number(text, "first departure", info->first_departure, info->time_unit);
    text_number(text, "  travel time", facts->first.left, info->time_unit);
    text_number(text, "last departure", info->last_departure, info->time_unit);
    text_number(text, "  travel time", facts->last.left, info->time_unit);
    g_autofree char *reason = cli_reason(info->last_reason);
    g_string_append_printf(text, "  %-16s%s: %s\n", "then", tdsp_status_name(info->last_reason), reason);
    text_jumps(text, facts->jumps, info);
    return cli_print(text, error);
}

int cmd_info(const CliCommand *command, int argc, char **argv, GError **error)
{
    gboolean json = FALSE;
    g_auto(FileIn) file = {0};
    g_auto(Facts) facts = {0};
    if (!cli_parse(command, NULL, &json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error) ||
        !file_in_load_any(argv[1], &file, error))
        return CLI_FAILED;
    if (file.kind == FILE_MATRIX) return matrix_pair_print(&file, json, error) ? CLI_DONE : CLI_FAILED;
    if (!file_in_need_table(&file, error) || !gather(&file.table, &facts, error))
        return CLI_FAILED;
    if (!(json ? print_json(argv[1], &facts, error) : print_text(argv[1], &facts, error))) return CLI_FAILED;
    return CLI_DONE;
}
