/* SPDX-License-Identifier: MIT */
/* Printing margins. */
#include "margins.h"

#include <math.h>

#include "text_table.h"

static void json_disc(JsonOut *out, const char *key, guint32 disc)
{
    json_out_key(out, key);
    if (disc == TDSP_NO_DISC)
        json_out_null(out);
    else
        json_out_whole(out, disc);
}

void margins_json_witness(JsonOut *out, const tdsp_witness *witness)
{
    json_out_member_string(out, "limit", tdsp_limit_name(witness->limit));
    json_disc(out, "disc", witness->disc);
    json_disc(out, "other", witness->other);
    json_out_member_number(out, "time", witness->time);
    json_out_key(out, "place");
    if (witness->limit == TDSP_LIMIT_NONE)
        json_out_null(out);
    else
        json_out_point(out, witness->place);
}

/* "unlimited", or a status word. */
static const char *word_of(const tdsp_margin *margin)
{
    return margin->most == INFINITY ? "unlimited" : tdsp_status_name(margin->status);
}

static void json_margin(JsonOut *out, const char *key, const tdsp_margin *margin)
{
    json_out_key(out, key);
    json_out_begin(out, '{');
    json_out_member_number(out, "most", margin->most);
    json_out_member_string(out, "status", word_of(margin));
    json_out_member_number(out, "arrival", margin->arrival);
    margins_json_witness(out, &margin->witness);
    json_out_end(out, '}');
}

static void json_latest(JsonOut *out, const tdsp_slack *slack)
{
    const tdsp_deadline_answer *latest = &slack->latest;
    const tdsp_witness none = {TDSP_LIMIT_NONE, TDSP_NO_DISC, TDSP_NO_DISC, INFINITY, {0, 0}};
    gboolean found = slack->latest_status == TDSP_OK;
    json_out_key(out, "latest");
    json_out_begin(out, '{');
    json_out_member_number(out, "departure", found ? latest->departure : INFINITY);
    json_out_member_number(out, "arrives", found ? latest->arrival : INFINITY);
    json_out_member_string(out, "status", tdsp_status_name(slack->latest_status));
    margins_json_witness(out, found ? &latest->witness : &none);
    json_out_end(out, '}');
}

static void json_departure(JsonOut *out, const DepartureMargins *one)
{
    json_out_line(out);
    json_out_begin(out, '{');
    json_out_member_number(out, "departure", one->departure);
    json_out_member_number(out, "arrival", one->slack.arrival);
    json_out_member_string(out, "status", tdsp_status_name(one->slack.status));
    json_out_member_number(out, "early", one->slack.early);
    json_out_member_number(out, "later", one->slack.later);
    json_latest(out, &one->slack);
    json_margin(out, "factor", &one->anew[TDSP_RAISE_FACTOR]);
    json_margin(out, "added", &one->anew[TDSP_RAISE_ADDED]);
    for (guint how = 0; how < 2; how++) {
        const char *key = how == TDSP_RAISE_FACTOR ? "path_factor" : "path_added";
        if (one->path_status == TDSP_OK) {
            json_margin(out, key, &one->path[how]);
        } else {
            json_out_key(out, key);
            json_out_null(out);
        }
    }
    json_out_member_number(out, "seconds", one->seconds);
    json_out_end(out, '}');
}

gboolean margins_print_json(const GArray *all, double deadline, double prepare_seconds, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_number(&out, "prepare_seconds", prepare_seconds);
    json_out_member_number(&out, "deadline", deadline);
    json_out_key(&out, "results");
    json_out_begin(&out, '[');
    for (guint i = 0; i < all->len; i++) json_departure(&out, &g_array_index(all, DepartureMargins, i));
    json_out_end(&out, ']');
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

/* "gap 0 1 at 20.15": what limits the factor. */
static char *limit_text(const tdsp_witness *witness)
{
    g_autoptr(GString) text = g_string_new(tdsp_limit_name(witness->limit));
    if (witness->disc != TDSP_NO_DISC) g_string_append_printf(text, " %u", witness->disc);
    if (witness->other != TDSP_NO_DISC) g_string_append_printf(text, " %u", witness->other);
    if (isfinite(witness->time)) g_string_append_printf(text, " at %.6g", witness->time);
    return g_string_free(g_steal_pointer(&text), FALSE);
}

static void text_path(TextTable *table, const DepartureMargins *one)
{
    for (guint how = 0; how < 2; how++) {
        if (one->path_status == TDSP_OK)
            text_table_number(table, one->path[how].most);
        else
            text_table_string(table, "-");
    }
}

gboolean margins_print_text(const GArray *all, GError **error)
{
    static const char *const heading[] = {"departure", "arrival",     "status",     "early", "later", "factor",
                                          "added",     "path_factor", "path_added", "limit", NULL};
    g_auto(TextTable) table = text_table_new(heading);
    for (guint i = 0; i < all->len; i++) {
        const DepartureMargins *one = &g_array_index(all, DepartureMargins, i);
        g_autofree char *limit = limit_text(&one->anew[TDSP_RAISE_FACTOR].witness);
        text_table_number(&table, one->departure);
        text_table_number(&table, one->slack.arrival);
        text_table_string(&table, tdsp_status_name(one->slack.status));
        text_table_number(&table, one->slack.early);
        text_table_number(&table, one->slack.later);
        text_table_number(&table, one->anew[TDSP_RAISE_FACTOR].most);
        text_table_number(&table, one->anew[TDSP_RAISE_ADDED].most);
        text_path(&table, one);
        text_table_string(&table, limit);
    }
    return text_table_print(&table, error);
}
