/* SPDX-License-Identifier: MIT */
/* Paths as JSON: what is printed reads back as the same path. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/curve.h"
#include "tdsp/path.h"
#include "tdsp/path_json.h"

static char *printed(const tdsp_leg *legs, gsize count)
{
    g_auto(JsonOut) out = json_out_new();
    json_out_begin(&out, '{');
    json_out_member_number(&out, "departure", legs[0].start_time);
    json_out_member_number(&out, "arrival", legs[count - 1].end_time);
    json_out_member_string(&out, "status", "ok");
    json_out_key(&out, "legs");
    path_json_legs(&out, legs, count);
    json_out_end(&out, '}');
    return g_strdup(out.text->str);
}

/* A ride on a disc whose rate changes, as three curves, and a line before and behind. */
enum { LEGS = 5 };

static void make_path(int turn, tdsp_leg legs[LEGS])
{
    const curve_law law = {{1, 0.1, 0.02}};
    curve_legs(&law, (tdsp_point){0.5, -0.25}, 1.5, 1, 1.75, 2, turn, legs + 1, 3);
    legs[0] = (tdsp_leg){.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .end_time = 1, .from = {-1, 2}, .to = legs[1].from};
    legs[4] = (tdsp_leg){
        .kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = 1.75, .end_time = 3, .from = legs[3].to, .to = {4, 5}};
}

static void assert_same_curve(const tdsp_leg *read, const tdsp_leg *leg)
{
    assert_int_equal(read->disc, leg->disc);
    assert_int_equal(read->turn, leg->turn);
    assert_exact(read->radius_from, leg->radius_from);
    assert_exact(read->radius_to, leg->radius_to);
    assert_exact(read->sweep, leg->sweep);
    assert_exact(read->rate_from, leg->rate_from);
    assert_exact(read->rate_to, leg->rate_to);
    assert_exact(read->bend_from, leg->bend_from);
    assert_exact(read->bend_to, leg->bend_to);
    assert_exact(read->speed, leg->speed);
    for (double x = 0; x <= 1; x += 0.125) {
        double t = leg->start_time + x * (leg->end_time - leg->start_time);
        tdsp_point a = tdsp_leg_position(read, t), b = tdsp_leg_position(leg, t);
        assert_near(hypot(a.x - b.x, a.y - b.y), 0, 1e-15);
    }
}

static void curves_read_back_as_they_were(void **state)
{
    (void)state;
    for (int turn = -1; turn <= 1; turn += 2) {
        tdsp_leg legs[LEGS];
        make_path(turn, legs);
        g_autofree char *text = printed(legs, LEGS);
        g_auto(PathFile) path = {0};
        g_autoptr(GError) error = NULL;
        assert_true(path_json_parse("text", text, strlen(text), 1.5, &path, &error));
        assert_int_equal(path.legs->len, LEGS);
        for (guint i = 0; i < LEGS; i++) {
            const tdsp_leg *read = &g_array_index(path.legs, tdsp_leg, i);
            assert_int_equal(read->kind, legs[i].kind);
            if (read->kind == TDSP_LEG_CURVE) assert_same_curve(read, &legs[i]);
        }
    }
}

/* Each member of a curve that is not there is named. */
static void a_curve_without_all_its_members_is_refused(void **state)
{
    (void)state;
    static const char *const members[] = {"bends", "sweep", "speed", "radii", "disc", "turn", "center"};
    for (size_t i = 0; i < G_N_ELEMENTS(members); i++) {
        tdsp_leg legs[LEGS];
        make_path(1, legs);
        g_autofree char *text = printed(legs, LEGS), *key = g_strdup_printf("\"%s\"", members[i]);
        g_auto(PathFile) path = {0};
        g_autoptr(GError) error = NULL;
        strstr(text, key)[1] = 'X';
        assert_false(path_json_parse("text", text, strlen(text), 1.5, &path, &error));
        assert_non_null(strstr(error->message, members[i]));
    }
}

/* The laps of an arc come from the speed; an arc without rates has none. */
static void an_arc_without_rates_is_a_spiral(void **state)
{
    (void)state;
    tdsp_leg arc = {
        .kind = TDSP_LEG_ARC, .disc = 3, .turn = 1, .end_time = 8, .from = {1, 0}, .radius_from = 1, .radius_to = 1, .sweep = 8};
    arc.to = (tdsp_point){cos(8.0), sin(8.0)};
    g_autofree char *text = printed(&arc, 1);
    g_auto(PathFile) path = {0};
    g_autoptr(GError) error = NULL;
    assert_null(strstr(text, "rates"));
    assert_true(path_json_parse("text", text, strlen(text), 1, &path, &error));
    const tdsp_leg *read = &g_array_index(path.legs, tdsp_leg, 0);
    assert_int_equal(read->kind, TDSP_LEG_ARC);
    assert_near(read->sweep, 8, 1e-14);
    assert_exact(read->speed, 0.0);
}

#define PATH "{\"departure\": 1, \"arrival\": 9, \"status\": \"ok\", \"legs\": [" LEG "]}"
#define LEG "{\"type\": \"arc\", \"start_time\": 1, \"end_time\": 9, \"from\": [1, 0], \"to\": [0, 1], " ARC "}"
#define ARC                                                                                                                      \
    "\"disc\": 3, \"center\": [0, 0], \"turn\": \"ccw\", \"radii\": [1, 1], \"rates\": [0.5, 0.5], \"bends\": [0, 0], "          \
    "\"sweep\": 1, \"speed\": 2"

/* The path with one piece of its text replaced. */
static char *path_with(const char *was, const char *is)
{
    g_auto(GStrv) parts = g_strsplit(PATH, was, 2);
    assert_non_null(parts[1]);
    return g_strjoinv(is, parts);
}

/* Each member in turn is of a wrong kind or out of its range; the message names its place. */
static void a_path_with_a_member_that_means_nothing_is_refused(void **state)
{
    (void)state;
    static const char *const changes[][3] = {
        {PATH, "[]", "text"},
        {"\"departure\": 1", "\"departure\": []", "departure"},
        {"\"arrival\": 9, ", "", "arrival"},
        {"\"arrival\": 9", "\"arrival\": true", "arrival"},
        {"\"status\": \"ok\"", "\"status\": 7", "status"},
        {", \"status\": \"ok\"", "", "status"},
        {"legs", "lags", "legs"},
        {"[" LEG "]", "7", "legs"},
        {LEG, "7", "legs[0]"},
        {"\"arc\"", "7", "type"},
        {"\"arc\"", "\"spline\"", "type"},
        {"\"start_time\": 1", "\"start_time\": \"1\"", "start_time"},
        {"\"end_time\": 9", "\"end_time\": null", "end_time"},
        {"\"from\": [1, 0]", "\"from\": [\"1\", 0]", "from"},
        {"\"from\": [1, 0]", "\"from\": [1, \"0\"]", "from"},
        {"\"to\": [0, 1]", "\"to\": [0, 1, 2]", "to"},
        {"\"disc\": 3", "\"disc\": \"3\"", "disc"},
        {"\"disc\": 3", "\"disc\": -1", "disc"},
        {"\"disc\": 3", "\"disc\": 0.5", "disc"},
        {"\"disc\": 3", "\"disc\": 4294967295", "disc"},
        {"\"rates\": [0.5, 0.5]", "\"rates\": 0.5", "rates"},
        {"\"bends\": [0, 0]", "\"bends\": 0", "bends"},
        {"\"sweep\": 1", "\"sweep\": []", "sweep"},
    };
    for (size_t i = 0; i < G_N_ELEMENTS(changes); i++) {
        g_autofree char *text = path_with(changes[i][0], changes[i][1]);
        g_auto(PathFile) path = {0};
        g_autoptr(GError) error = NULL;
        if (path_json_parse("text", text, strlen(text), 1, &path, &error))
            fail_msg("%s instead of %s is accepted", changes[i][1], changes[i][0]);
        if (!strstr(error->message, changes[i][2])) fail_msg("%s is not named in: %s", changes[i][2], error->message);
    }
}

/* An arc that takes no time, begins at its centre, or moves outward as fast as the robot turns by no more than its ends say. */
static void an_arc_that_has_no_time_or_speed_to_go_round_makes_no_lap(void **state)
{
    (void)state;
    static const char *const changes[][2] = {{"\"end_time\": 9", "\"end_time\": 1"},
                                             {"\"radii\": [1, 1]", "\"radii\": [0, 1]"},
                                             {"\"radii\": [1, 1]", "\"radii\": [1, 17]"}};
    for (size_t i = 0; i < G_N_ELEMENTS(changes); i++) {
        g_autofree char *curve = path_with(changes[i][0], changes[i][1]);
        g_auto(GStrv) parts = g_strsplit(curve, ", \"rates\"", 2);
        g_autofree char *text = g_strconcat(parts[0], "}]}", NULL);
        g_auto(PathFile) path = {0};
        g_autoptr(GError) error = NULL;
        if (!path_json_parse("text", text, strlen(text), 1, &path, &error)) fail_msg("%s", error->message);
        assert_near(g_array_index(path.legs, tdsp_leg, 0).sweep, 0.5 * G_PI, 1e-15);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(curves_read_back_as_they_were),
        cmocka_unit_test(a_curve_without_all_its_members_is_refused),
        cmocka_unit_test(an_arc_without_rates_is_a_spiral),
        cmocka_unit_test(a_path_with_a_member_that_means_nothing_is_refused),
        cmocka_unit_test(an_arc_that_has_no_time_or_speed_to_go_round_makes_no_lap),
    };
    return cmocka_run_group_tests_name("path_json", tests, NULL, NULL);
}
