/* SPDX-License-Identifier: MIT */
/* Paths as points: straight from one to the next is never farther from the robot than the tolerance, on lines, arcs and curves, in the plane and on the earth. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/curve.h"
#include "tdsp/path.h"
#include "tdsp/path_points.h"

enum { LEGS = 6 };

#define PROBES 3000

/* A line, a ride on a disc whose rate changes as three curves, a line, and one that stands still. */
static PathFile make_path(double size)
{
    const curve_law law = {{size, 0.1 * size, 0.02 * size}};
    tdsp_leg legs[LEGS];
    curve_legs(&law, (tdsp_point){0.5 * size, -0.25 * size}, 1.5 * size, 1, 1.75, 2, 1, legs + 1, 3);
    legs[0] = (tdsp_leg){.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .end_time = 1, .from = {-size, 2 * size}, .to = legs[1].from};
    legs[4] = (tdsp_leg){.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = 1.75, .end_time = 3, .from = legs[3].to, .to = {4 * size, 5 * size}};
    legs[5] = (tdsp_leg){.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = 3, .end_time = 4, .from = legs[4].to, .to = legs[4].to};
    PathFile path = {.departure = 0, .arrival = 4, .legs = g_array_new(FALSE, FALSE, sizeof(tdsp_leg))};
    g_array_append_vals(path.legs, legs, LEGS);
    return path;
}

static const PathPoint *at(const PathPoints *points, guint i)
{
    return &g_array_index(points->points, PathPoint, i);
}

static tdsp_point robot_at(const PathFile *path, double time)
{
    tdsp_point place;
    assert_int_equal(tdsp_path_position((const tdsp_leg *)(void *)path->legs->data, path->legs->len, time, &place), TDSP_OK);
    return place;
}

/* Where one is who goes straight from point to point, along longitude and latitude where there is an origin. */
static tdsp_point straight_at(const PathPoints *points, const Georeference *geo, double time)
{
    guint i = 1;
    while (i + 1 < points->points->len && at(points, i)->time < time) i++;
    const PathPoint *a = at(points, i - 1), *b = at(points, i);
    double x = (time - a->time) / (b->time - a->time);
    tdsp_point place = {a->place.x + (b->place.x - a->place.x) * x, a->place.y + (b->place.y - a->place.y) * x};
    if (geo->known) {
        GeoPlace between = {geodesic_turned(a->geo.lon + geodesic_turned(b->geo.lon - a->geo.lon) * x), a->geo.lat + (b->geo.lat - a->geo.lat) * x};
        assert_true(georeference_forward(geo, 1, between, &place));
    }
    return place;
}

static void assert_dense(double size, const Georeference *geo, double tolerance)
{
    g_auto(PathFile) path = make_path(size);
    g_auto(PathPoints) points = {0};
    g_autoptr(GError) error = NULL;
    if (!path_points_make("path", &path, geo, 1, tolerance, &points, &error)) fail_msg("%s", error->message);
    for (int i = 0; i <= PROBES; i++) {
        double time = 4.0 * i / PROBES;
        tdsp_point robot = robot_at(&path, time), straight = straight_at(&points, geo, time);
        assert_near(hypot(straight.x - robot.x, straight.y - robot.y), 0, tolerance + 1e-9);
    }
    assert_near(at(&points, 0)->time, 0, 0);
    assert_near(at(&points, points.points->len - 1)->time, 4, 0);
}

static void points_are_dense_enough_in_the_plane(void **state)
{
    (void)state;
    for (double tolerance = 1; tolerance > 1e-7; tolerance /= 10) assert_dense(1, &(Georeference){0}, tolerance);
}

static void points_are_dense_enough_on_the_earth(void **state)
{
    (void)state;
    static const GeoPlace origins[] = {{-119.8, 44.45}, {0, 0}, {180, 70}, {-77, 89.9}, {12, -90}};
    for (gsize i = 0; i < G_N_ELEMENTS(origins); i++)
        for (double tolerance = 1000; tolerance > 0.05; tolerance /= 10) assert_dense(3e4, &(Georeference){TRUE, origins[i]}, tolerance);
}

static void every_leg_has_its_ends_and_says_its_number(void **state)
{
    (void)state;
    g_auto(PathFile) path = make_path(1);
    g_auto(PathPoints) points = {0};
    assert_true(path_points_make("path", &path, &(Georeference){0}, 1, 10, &points, NULL));
    guint point = 0;
    for (guint i = 0; i < LEGS; i++) {
        double end = g_array_index(path.legs, tdsp_leg, i).end_time;
        while (at(&points, point)->time < end) point++;
        assert_exact(at(&points, point)->time, end);
        assert_int_equal(at(&points, point)->leg, i);
    }
}

static void a_path_that_stands_still_is_two_points_on_the_earth_too(void **state)
{
    (void)state;
    g_auto(PathFile) path = make_path(1);
    g_auto(PathPoints) points = {0};
    g_array_remove_range(path.legs, 0, 5);
    path.departure = 3;
    assert_true(path_points_make("path", &path, &(Georeference){TRUE, {33, 44}}, 1, 0, &points, NULL));
    assert_int_equal(points.points->len, 2);
}

/* A curve of forged rates swings out by millions of metres between its ends. */
static void a_curve_that_leads_out_of_the_plane_is_refused(void **state)
{
    (void)state;
    g_auto(PathFile) path = make_path(1);
    g_auto(PathPoints) points = {0};
    g_autoptr(GError) error = NULL;
    tdsp_leg *leg = &g_array_index(path.legs, tdsp_leg, 2);
    leg->rate_from = 1e9;
    leg->speed = 2e9;
    assert_false(path_points_make("path", &path, &(Georeference){TRUE, {33, 44}}, 1, 0, &points, &error));
    assert_string_equal(error->message, "path: legs[2]: leads out of the plane");
}

static void a_curve_beyond_all_numbers_is_refused(void **state)
{
    (void)state;
    g_auto(PathFile) path = make_path(1);
    g_auto(PathPoints) points = {0};
    g_autoptr(GError) error = NULL;
    g_array_index(path.legs, tdsp_leg, 2).bend_from = 1e308;
    g_array_index(path.legs, tdsp_leg, 2).bend_to = -1e308;
    g_array_index(path.legs, tdsp_leg, 2).rate_from = 1.7e308;
    assert_false(path_points_make("path", &path, &(Georeference){0}, 1, 0, &points, &error));
    assert_string_equal(error->message, "path: legs[2]: leads out of the plane");
}

static PathFile one_leg(tdsp_leg leg)
{
    PathFile path = {.departure = leg.start_time, .arrival = leg.end_time, .legs = g_array_new(FALSE, FALSE, sizeof(tdsp_leg))};
    g_array_append_val(path.legs, leg);
    return path;
}

static tdsp_leg half_circle(double start, double end, double laps)
{
    return (tdsp_leg){.kind = TDSP_LEG_ARC, .turn = 1, .start_time = start, .end_time = end, .from = {1, 0}, .to = {-1, 0}, .radius_from = 1, .radius_to = 1,
                      .sweep = G_PI * (1 + 2 * laps)};
}

static void halving_ends_where_time_has_no_number_in_between(void **state)
{
    (void)state;
    const double from[] = {1, nextafter(1, 2)};
    for (int i = 0; i < 2; i++) {
        g_auto(PathFile) path = one_leg(half_circle(from[i], nextafter(from[i], 2), 0));
        g_auto(PathPoints) points = {0};
        assert_true(path_points_make("path", &path, &(Georeference){0}, 1, 1e-3, &points, NULL));
        assert_int_equal(points.points->len, 2);
    }
}

static void more_laps_than_points_are_refused(void **state)
{
    (void)state;
    g_auto(PathFile) path = one_leg(half_circle(0, 1, 1e6));
    g_auto(PathPoints) points = {0};
    g_autoptr(GError) error = NULL;
    assert_false(path_points_make("path", &path, &(Georeference){0}, 1, 10, &points, &error));
    assert_non_null(strstr(error->message, "more than 1000000 points"));
}

/* Beside the pole, the short way from one longitude to the other leads behind it, and there too far from the origin. */
static void a_long_line_beside_the_pole_is_cut_until_longitudes_serve(void **state)
{
    (void)state;
    g_auto(PathFile) path = one_leg((tdsp_leg){.kind = TDSP_LEG_LINE, .end_time = 10, .from = {-1.49e6, 5e4}, .to = {1.49e6, 5e4}});
    const Georeference geo = {TRUE, {0, 89.9}};
    g_auto(PathPoints) points = {0};
    assert_true(path_points_make("path", &path, &geo, 1, 1000, &points, NULL));
    for (double time = 0; time <= 10; time += 0.01) {
        tdsp_point robot = robot_at(&path, time), straight = straight_at(&points, &geo, time);
        assert_near(hypot(straight.x - robot.x, straight.y - robot.y), 0, 1000);
    }
}

static void a_tolerance_that_degrees_cannot_keep_is_refused(void **state)
{
    (void)state;
    g_auto(PathFile) path = make_path(1);
    g_auto(PathPoints) points = {0};
    g_autoptr(GError) error = NULL;
    assert_false(path_points_make("path", &path, &(Georeference){TRUE, {33, 44}}, 1, 1e-7, &points, &error));
    assert_string_equal(error->message, "--tolerance: on the earth at least a micrometre");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_dense_enough_in_the_plane),
        cmocka_unit_test(points_are_dense_enough_on_the_earth),
        cmocka_unit_test(every_leg_has_its_ends_and_says_its_number),
        cmocka_unit_test(a_path_that_stands_still_is_two_points_on_the_earth_too),
        cmocka_unit_test(a_curve_that_leads_out_of_the_plane_is_refused),
        cmocka_unit_test(a_curve_beyond_all_numbers_is_refused),
        cmocka_unit_test(halving_ends_where_time_has_no_number_in_between),
        cmocka_unit_test(more_laps_than_points_are_refused),
        cmocka_unit_test(a_long_line_beside_the_pole_is_cut_until_longitudes_serve),
        cmocka_unit_test(a_tolerance_that_degrees_cannot_keep_is_refused),
    };
    return cmocka_run_group_tests_name("path_points", tests, NULL, NULL);
}
