/* SPDX-License-Identifier: MIT */
/* tdsp envelope: the pieces of the earliest arrival, each with the discs that its paths ride. */
#include <math.h>

#include "commands.h"
#include "shape_asked.h"
#include "text_table.h"

static const char *change_word(tdsp_change change)
{
    switch (change) {
    case TDSP_CHANGE_END: return "end";
    case TDSP_CHANGE_JUMP: return "jump";
    case TDSP_CHANGE_TOUCH: return "touch";
    case TDSP_CHANGE_SWITCH: return "switch";
    }
    return "unknown";
}

static const char *turn_word(const tdsp_ride *ride)
{
    return ride->turn > 0 ? "ccw" : "cw";
}

static void json_rides(JsonOut *out, const tdsp_piece *piece)
{
    json_out_key(out, "rides");
    json_out_begin(out, '[');
    for (gsize i = 0; i < piece->ride_count; i++) {
        json_out_begin(out, '{');
        json_out_member_whole(out, "disc", piece->rides[i].disc);
        json_out_member_string(out, "turn", turn_word(&piece->rides[i]));
        json_out_end(out, '}');
    }
    json_out_end(out, ']');
}

static void json_piece(JsonOut *out, const tdsp_piece *piece, const tdsp_piece *next)
{
    json_out_line(out);
    json_out_begin(out, '{');
    json_out_member_number(out, "from", piece->from);
    json_out_member_number(out, "until", piece->until);
    json_out_member_number(out, "travel_from", piece->travel_from);
    json_out_member_number(out, "travel_until", piece->travel_until);
    json_out_member_whole(out, "form", piece->form);
    json_rides(out, piece);
    json_out_member_string(out, "change", change_word(piece->change));
    json_out_key(out, "jump");
    if (piece->change == TDSP_CHANGE_JUMP && next) {
        json_out_begin(out, '{');
        json_out_member_number(out, "size", next->travel_from - piece->travel_until);
        shape_json_gap(out, &piece->gap);
        json_out_end(out, '}');
    } else {
        json_out_null(out);
    }
    json_out_end(out, '}');
}

static gboolean print_json(const tdsp_envelope *envelope, tdsp_status status, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    gsize count = tdsp_envelope_pieces(envelope);
    json_out_begin(&out, '{');
    json_out_member_string(&out, "status", tdsp_status_name(status));
    json_out_member_whole(&out, "F", count);
    json_out_member_whole(&out, "forms", tdsp_envelope_forms(envelope));
    json_out_member_number(&out, "resolution", tdsp_envelope_resolution(envelope));
    json_out_key(&out, "pieces");
    json_out_begin(&out, '[');
    for (gsize i = 0; i < count; i++) {
        tdsp_piece piece, next;
        tdsp_envelope_piece(envelope, i, &piece);
        gboolean has_next = tdsp_envelope_piece(envelope, i + 1, &next) == TDSP_OK;
        json_piece(&out, &piece, has_next ? &next : NULL);
    }
    json_out_end(&out, ']');
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

/* "0 cw, 3 ccw", or "straight". */
static char *rides_text(const tdsp_piece *piece)
{
    GString *text = g_string_new(piece->ride_count == 0 ? "straight" : NULL);
    for (gsize i = 0; i < piece->ride_count; i++)
        g_string_append_printf(text, "%s%u %s", i == 0 ? "" : ", ", piece->rides[i].disc, turn_word(&piece->rides[i]));
    return g_string_free(text, FALSE);
}

static char *change_text(const tdsp_piece *piece)
{
    g_autofree char *discs = shape_gap_discs(&piece->gap);
    if (piece->change != TDSP_CHANGE_JUMP) return g_strdup(change_word(piece->change));
    return g_strdup_printf("jump: %s close", discs);
}

static gboolean print_text(const tdsp_envelope *envelope, GError **error)
{
    static const char *const heading[] = {"from", "until", "travel_from", "travel_until", "rides", "then", NULL};
    g_auto(TextTable) table = text_table_new(heading);
    g_autoptr(GString) text = g_string_new(NULL);
    tdsp_piece piece;
    for (gsize i = 0; tdsp_envelope_piece(envelope, i, &piece) == TDSP_OK; i++) {
        g_autofree char *rides = rides_text(&piece), *change = change_text(&piece);
        text_table_number(&table, piece.from);
        text_table_number(&table, piece.until);
        text_table_number(&table, piece.travel_from);
        text_table_number(&table, piece.travel_until);
        text_table_string(&table, rides);
        text_table_string(&table, change);
    }
    text_table_append(&table, text);
    g_string_append_printf(text, "# F = %" G_GSIZE_FORMAT " pieces, %" G_GSIZE_FORMAT " forms\n", tdsp_envelope_pieces(envelope),
                           tdsp_envelope_forms(envelope));
    return cli_print(text, error);
}

static int answer(const ShapeAsked *asked, const tdsp_envelope *envelope, tdsp_status status, GError **error)
{
    if (asked->json && !print_json(envelope, status, error)) return CLI_FAILED;
    if (status != TDSP_OK) {
        g_autofree char *reason = cli_reason(status);
        cli_warn("no path at departure 0: %s", reason);
        return CLI_NO;
    }
    return asked->json || print_text(envelope, error) ? CLI_DONE : CLI_FAILED;
}

int cmd_envelope(const CliCommand *command, int argc, char **argv, GError **error)
{
    g_auto(ShapeAsked) asked = {0};
    tdsp_envelope *envelope = NULL;
    const GOptionEntry entries[] = {
        SHAPE_ASKED_HORIZON(&asked.horizon),
        {"resolution", 0, 0, G_OPTION_ARG_STRING, &asked.fineness,
         "Find every piece wider than this (default: a 1024th of the departures looked at)", "R"},
        G_OPTION_ENTRY_NULL,
    };
    if (!cli_parse(command, entries, &asked.json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error) ||
        !shape_asked_fineness(&asked, "--resolution", &asked.options.resolution, error) ||
        !shape_asked_begin(&asked, argv[1], command->name, error))
        return CLI_FAILED;
    tdsp_status status = tdsp_envelope_find(asked.solver.solver, &asked.options, &envelope);
    if (!shape_asked_done(&asked, status, error)) return CLI_FAILED;
    int done = answer(&asked, envelope, status, error);
    tdsp_envelope_free(envelope);
    return done;
}
