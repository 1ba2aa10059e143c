/* SPDX-License-Identifier: MIT */
/* tdsp jumps: where the earliest arrival jumps, by how much, and what closes there. */
#include <math.h>

#include "commands.h"
#include "shape_asked.h"
#include "text_table.h"

static void json_jump(JsonOut *out, const tdsp_arrival_jump *jump)
{
    json_out_line(out);
    json_out_begin(out, '{');
    json_out_member_number(out, "departure", jump->departure);
    json_out_member_number(out, "before", jump->travel_before);
    json_out_member_number(out, "after", jump->travel_after);
    json_out_member_number(out, "size", jump->size);
    shape_json_gap(out, &jump->gap);
    json_out_end(out, '}');
}

static gboolean print_json(const tdsp_jumps *jumps, tdsp_status status, GError **error)
{
    g_auto(JsonOut) out = json_out_new();
    tdsp_arrival_jump jump;
    json_out_begin(&out, '{');
    json_out_member_string(&out, "status", tdsp_status_name(status));
    json_out_key(&out, "jumps");
    json_out_begin(&out, '[');
    for (gsize i = 0; tdsp_jumps_get(jumps, i, &jump) == TDSP_OK; i++) json_jump(&out, &jump);
    json_out_end(&out, ']');
    json_out_end(&out, '}');
    return json_out_print(&out, error);
}

static gboolean print_text(const tdsp_jumps *jumps, GError **error)
{
    static const char *const heading[] = {"departure", "before", "after", "size", "closing discs", "time", "x", "y", NULL};
    g_auto(TextTable) table = text_table_new(heading);
    tdsp_arrival_jump jump;
    for (gsize i = 0; tdsp_jumps_get(jumps, i, &jump) == TDSP_OK; i++) {
        gboolean known = jump.gap.first != TDSP_NO_DISC;
        g_autofree char *discs = shape_gap_discs(&jump.gap);
        const double numbers[] = {jump.departure, jump.travel_before, jump.travel_after, jump.size};
        const double where[] = {jump.gap.time, jump.gap.place.x, jump.gap.place.y};
        for (gsize k = 0; k < G_N_ELEMENTS(numbers); k++) text_table_number(&table, numbers[k]);
        text_table_string(&table, discs);
        for (gsize k = 0; k < G_N_ELEMENTS(where); k++)
            known ? text_table_number(&table, where[k]) : text_table_string(&table, "-");
    }
    return text_table_print(&table, error);
}

static int answer(const ShapeAsked *asked, const tdsp_jumps *jumps, tdsp_status status, GError **error)
{
    if (asked->json && !print_json(jumps, status, error)) return CLI_FAILED;
    if (status != TDSP_OK) {
        g_autofree char *reason = cli_reason(status);
        cli_warn("no path at departure 0: %s", reason);
        return CLI_NO;
    }
    return asked->json || print_text(jumps, error) ? CLI_DONE : CLI_FAILED;
}

int cmd_jumps(const CliCommand *command, int argc, char **argv, GError **error)
{
    g_auto(ShapeAsked) asked = {0};
    tdsp_jumps *jumps = NULL;
    const GOptionEntry entries[] = {
        SHAPE_ASKED_HORIZON(&asked.horizon),
        {"least", 0, 0, G_OPTION_ARG_STRING, &asked.fineness, "Leave out jumps up to this (default: a 256th of the rise of all travel times)",
         "D"},
        G_OPTION_ENTRY_NULL,
    };
    if (!cli_parse(command, entries, &asked.json, &argc, &argv, error) || !cli_positional(command, argc, 1, 1, error) ||
        !shape_asked_fineness(&asked, "--least", &asked.options.least, error) ||
        !shape_asked_begin(&asked, argv[1], command->name, error))
        return CLI_FAILED;
    tdsp_status status = tdsp_jumps_find(asked.solver.solver, &asked.options, &jumps);
    if (!shape_asked_done(&asked, status, error)) return CLI_FAILED;
    int done = answer(&asked, jumps, status, error);
    tdsp_jumps_free(jumps);
    return done;
}
