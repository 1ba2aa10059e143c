/* SPDX-License-Identifier: MIT */
/*
 * Paths as JSON.
 *
 * Reading an arc: with radii r0, r1 over a time dt the radial speed is V = (r1 - r0) / dt and the rest, w = sqrt(v^2 - V^2), goes
 * round. The angle is the integral of w / R(t) with R linear in t, that is w dt ln(r1 / r0) / (r1 - r0), or w dt / r0 on a circle.
 * The ends give the angle exactly up to 2 pi k; the formula gives k. An arc with rates is a curve, and says its angle itself.
 */
#include "path_json.h"

#include <math.h>
#include <string.h>

#include "cli.h"
#include "json_read.h"

static void curve_members(JsonOut *out, const tdsp_leg *leg)
{
    json_out_member_point(out, "rates", (tdsp_point){leg->rate_from, leg->rate_to});
    json_out_member_point(out, "bends", (tdsp_point){leg->bend_from, leg->bend_to});
    json_out_member_number(out, "sweep", leg->sweep);
    json_out_member_number(out, "speed", leg->speed);
}

static void arc_members(JsonOut *out, const tdsp_leg *leg)
{
    json_out_member_whole(out, "disc", leg->disc);
    json_out_member_point(out, "center", leg->center);
    json_out_member_string(out, "turn", leg->turn > 0 ? "ccw" : "cw");
    json_out_member_point(out, "radii", (tdsp_point){leg->radius_from, leg->radius_to});
    if (leg->kind == TDSP_LEG_CURVE) curve_members(out, leg);
}

void path_json_legs(JsonOut *out, const tdsp_leg *legs, gsize count)
{
    json_out_begin(out, '[');
    for (gsize i = 0; i < count; i++) {
        json_out_line(out);
        json_out_begin(out, '{');
        json_out_member_string(out, "type", legs[i].kind == TDSP_LEG_LINE ? "line" : "arc");
        json_out_member_number(out, "start_time", legs[i].start_time);
        json_out_member_number(out, "end_time", legs[i].end_time);
        json_out_member_point(out, "from", legs[i].from);
        json_out_member_point(out, "to", legs[i].to);
        if (legs[i].kind != TDSP_LEG_LINE) arc_members(out, &legs[i]);
        json_out_end(out, '}');
    }
    json_out_end(out, ']');
}

static double expected_sweep(const tdsp_leg *leg, double speed)
{
    double duration = leg->end_time - leg->start_time, growth = leg->radius_to - leg->radius_from;
    if (!(duration > 0) || !(leg->radius_from > 0)) return 0;
    double radial = growth / duration, square = speed * speed - radial * radial;
    double turning = square > 0 ? sqrt(square) : 0;
    double share = growth / leg->radius_from;
    double mean = fabs(share) < 1e-12 ? 1 : log1p(share) / share;
    return turning * duration / leg->radius_from * mean;
}

static void fill_sweep(tdsp_leg *leg, double speed)
{
    double to = atan2(leg->to.y - leg->center.y, leg->to.x - leg->center.x);
    double turned = (to - leg->angle_from) * leg->turn;
    double laps = rint((expected_sweep(leg, speed) - turned) / (2 * G_PI));
    leg->sweep = fmax(0, turned + 2 * G_PI * laps);
}

static gboolean read_word(const JsonValue *object, const char *name, const char *const *words, int *which, GError **error)
{
    JsonValue member;
    const char *word;
    if (!json_read_member(object, name, &member, error) || !json_read_string(&member, &word, error)) return FALSE;
    for (*which = 0; words[*which]; ++*which)
        if (strcmp(word, words[*which]) == 0) return TRUE;
    return json_read_fail(&member.place, error, "must be \"%s\" or \"%s\"", words[0], words[1]);
}

static gboolean read_curve(const JsonValue *value, tdsp_leg *leg, GError **error)
{
    tdsp_point rates, bends;
    if (!json_read_member_point(value, "rates", &rates, error) || !json_read_member_point(value, "bends", &bends, error) ||
        !json_read_member_number(value, "sweep", &leg->sweep, error) ||
        !json_read_member_number(value, "speed", &leg->speed, error))
        return FALSE;
    leg->kind = TDSP_LEG_CURVE;
    leg->rate_from = rates.x;
    leg->rate_to = rates.y;
    leg->bend_from = bends.x;
    leg->bend_to = bends.y;
    return TRUE;
}

static gboolean read_arc(const JsonValue *value, double speed, tdsp_leg *leg, GError **error)
{
    static const char *const turns[] = {"ccw", "cw", NULL};
    tdsp_point radii;
    double disc;
    int turn;
    JsonValue member;
    if (!json_read_member(value, "disc", &member, error) || !json_read_number(&member, &disc, error)) return FALSE;
    if (!(disc >= 0 && disc < TDSP_NO_DISC && disc == floor(disc)))
        return json_read_fail(&member.place, error, "not the index of a disc");
    if (!json_read_member_point(value, "center", &leg->center, error) || !json_read_member_point(value, "radii", &radii, error) ||
        !read_word(value, "turn", turns, &turn, error))
        return FALSE;
    leg->kind = TDSP_LEG_ARC;
    leg->disc = (guint32)disc;
    leg->turn = turn == 0 ? 1 : -1;
    leg->radius_from = radii.x;
    leg->radius_to = radii.y;
    leg->angle_from = atan2(leg->from.y - leg->center.y, leg->from.x - leg->center.x);
    if (json_read_optional(value, "rates", &member)) return read_curve(value, leg, error);
    fill_sweep(leg, speed);
    return TRUE;
}

static gboolean read_leg(const JsonValue *value, double speed, tdsp_leg *leg, GError **error)
{
    static const char *const types[] = {"line", "arc", NULL};
    int type;
    *leg = (tdsp_leg){.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC};
    if (!json_read_object(value, error) || !read_word(value, "type", types, &type, error) ||
        !json_read_member_number(value, "start_time", &leg->start_time, error) ||
        !json_read_member_number(value, "end_time", &leg->end_time, error) ||
        !json_read_member_point(value, "from", &leg->from, error) || !json_read_member_point(value, "to", &leg->to, error))
        return FALSE;
    return type == 0 ? TRUE : read_arc(value, speed, leg, error);
}

static gboolean read_legs(const JsonValue *root, double speed, GArray *legs, GError **error)
{
    JsonValue array;
    guint length;
    if (!json_read_member(root, "legs", &array, error) || !json_read_array(&array, &length, error)) return FALSE;
    for (guint i = 0; i < length; i++) {
        JsonValue item = json_read_item(&array, i);
        tdsp_leg leg;
        if (!read_leg(&item, speed, &leg, error)) return FALSE;
        g_array_append_val(legs, leg);
    }
    return TRUE;
}

static gboolean read_path(const JsonValue *root, double speed, PathFile *path, GError **error)
{
    JsonValue arrival, status;
    const char *word;
    path->arrival = INFINITY;
    if (!json_read_object(root, error) || !json_read_member_number(root, "departure", &path->departure, error) ||
        !json_read_member(root, "arrival", &arrival, error) || !json_read_member(root, "status", &status, error) ||
        !json_read_string(&status, &word, error))
        return FALSE;
    if (!JSON_NODE_HOLDS_NULL(arrival.node) && !json_read_number(&arrival, &path->arrival, error)) return FALSE;
    path->status = g_strdup(word);
    return read_legs(root, speed, path->legs, error);
}

gboolean path_json_parse(const char *file, const char *text, gsize length, double speed, PathFile *path, GError **error)
{
    g_autoptr(JsonParser) parser = NULL;
    JsonValue root;
    if (!json_read_document(file, text, length, &parser, &root, error)) return FALSE;
    PathFile read = {.legs = g_array_new(FALSE, TRUE, sizeof(tdsp_leg))};
    if (!read_path(&root, speed, &read, error)) {
        path_file_clear(&read);
        return FALSE;
    }
    *path = read;
    return TRUE;
}

void path_file_clear(PathFile *path)
{
    g_clear_pointer(&path->status, g_free);
    g_clear_pointer(&path->legs, g_array_unref);
}
