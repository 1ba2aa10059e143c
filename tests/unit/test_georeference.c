/* SPDX-License-Identifier: MIT */
/* The plane that a scene is laid out in: what its header promises of distances, held to geodesics. */
#include "support/cmocka_all.h"

#include <string.h>

#include "support/chance.h"
#include "tdsp/georeference.h"
#include "tdsp/units.h"

static const GeoPlace origins[] = {{-119.8, 44.45}, {0, 0}, {180, -17}, {25, 89.9}, {-60, -90}, {151, 0.001}};
static const double extents[] = {10, 1e4, 1e5, 5e5, GEOREFERENCE_REFUSE};

/* Two places within an extent: how long the way between them is, and how long it is in the plane. */
static void assert_promise(uint64_t *chance, const Georeference *geo, double extent)
{
    GeoPlace places[2];
    tdsp_point laid[2];
    for (int i = 0; i < 2; i++) {
        places[i] = geodesic_direct(geo->origin, chance_between(chance, -G_PI, G_PI), extent * chance_unit(chance));
        assert_true(georeference_forward(geo, 1, places[i], &laid[i]));
    }
    double way, azimuth, plane = hypot(laid[1].x - laid[0].x, laid[1].y - laid[0].y);
    assert_true(geodesic_inverse(places[0], places[1], &way, &azimuth));
    assert_true(plane >= way - 1e-8 - 1e-11 * extent);
    assert_true(plane <= way * (1 + georeference_distortion(extent)) + 1e-8 + 1e-11 * extent);
}

static void distances_are_never_too_short_and_too_long_by_the_stated_share_at_most(void **state)
{
    (void)state;
    uint64_t chance = 20261122;
    for (gsize o = 0; o < G_N_ELEMENTS(origins); o++)
        for (gsize e = 0; e < G_N_ELEMENTS(extents); e++)
            for (int i = 0; i < 200; i++) assert_promise(&chance, &(Georeference){TRUE, origins[o]}, extents[e]);
}

/* Across the ray from the origin, far out, near the equator, where the ellipsoid bends most: half of the share at least is really there. */
static void the_stated_share_is_not_idle(void **state)
{
    (void)state;
    const Georeference geo = {TRUE, {0, 0}};
    for (gsize e = 2; e < G_N_ELEMENTS(extents); e++) {
        tdsp_point a = {extents[e] * 0.999, 0}, b = {a.x, extents[e] * 0.01};
        double way, azimuth;
        assert_true(geodesic_inverse(georeference_inverse(&geo, 1, a), georeference_inverse(&geo, 1, b), &way, &azimuth));
        assert_true(0.01 * extents[e] / way - 1 > 0.9 * georeference_distortion(extents[e] * 0.999));
    }
}

static void distance_and_direction_from_the_origin_are_true(void **state)
{
    (void)state;
    const Georeference geo = {TRUE, {-120.0, 44.3}};
    tdsp_point laid;
    assert_true(georeference_forward(&geo, 1000, (GeoPlace){-119.6, 44.6}, &laid)); /* GeographicLib: 46097.943575287 m, 43.54403315903477 degrees */
    assert_near(hypot(laid.x, laid.y), 46.097943575287, 1e-9);
    assert_near(atan2(laid.x, laid.y), 43.54403315903477 * G_PI / 180, 1e-11);
}

static void places_come_back(void **state)
{
    (void)state;
    uint64_t chance = 7;
    for (gsize i = 0; i < 2000; i++) {
        const Georeference geo = {TRUE, origins[i % G_N_ELEMENTS(origins)]};
        double extent = extents[i % G_N_ELEMENTS(extents)] / 1.5, metres = i % 2 ? 1 : 1852;
        tdsp_point there = {chance_between(&chance, -1, 1) * extent / metres, chance_between(&chance, -1, 1) * extent / metres}, back;
        assert_true(georeference_forward(&geo, metres, georeference_inverse(&geo, metres, there), &back));
        assert_near(hypot(back.x - there.x, back.y - there.y) * metres, 0, 1e-8);
    }
}

static void what_is_too_far_has_no_place_in_the_plane(void **state)
{
    (void)state;
    const Georeference geo = {TRUE, {0, 0}};
    tdsp_point laid = {1, 2};
    assert_false(georeference_forward(&geo, 1, (GeoPlace){14, 0}, &laid));
    assert_false(georeference_forward(&geo, 1, (GeoPlace){180, 0}, &laid));
    assert_exact(laid.x, 1);
    assert_exact(laid.y, 2);
}

static void the_middle_of_places_is_where_they_are(void **state)
{
    (void)state;
    static const GeoPlace across[] = {{179.9, -10}, {-179.9, -10}}, polar[] = {{0, 89}, {90, 89}, {180, 89}, {-90, 89}}, zero[] = {{-0.00001, -0.00001}};
    static const GeoPlace opposite[] = {{0, 0}, {180, 0}};
    Georeference geo;
    assert_null(georeference_about(across, 2, &geo));
    assert_near(fabs(geo.origin.lon), 180, 0);
    assert_near(geo.origin.lat, -10, 0.0001);
    assert_null(georeference_about(polar, 4, &geo));
    assert_near(geo.origin.lat, 90, 0);
    assert_null(georeference_about(zero, 1, &geo));
    assert_exact(geo.origin.lon, 0);
    assert_exact(geo.origin.lat, 0);
    assert_non_null(georeference_about(opposite, 2, &geo));
    assert_non_null(georeference_about(opposite, 0, &geo));
}

static void the_share_is_that_of_the_documentation(void **state)
{
    (void)state;
    assert_near(georeference_distortion(0), 0, 0);
    assert_near(georeference_distortion(10e3), 4.1e-7, 0.05e-7);
    assert_near(georeference_distortion(100e3), 4.1e-5, 0.05e-5);
    assert_near(georeference_distortion(500e3), 1.0e-3, 0.05e-3);
    assert_near(georeference_distortion(1500e3), 9.3e-3, 0.05e-3);
    assert_true(isnan(georeference_distortion(NAN)));
}

static void units_are_what_they_are_worth(void **state)
{
    (void)state;
    static const char *const names[] = {"m", "km", "cm", "ft", "mi", "nmi"};
    static const double worth[] = {1, 1000, 0.01, 0.3048, 1609.344, 1852};
    g_autoptr(GError) error = NULL;
    double value;
    for (gsize i = 0; i < G_N_ELEMENTS(names); i++) {
        assert_true(unit_metres("it", names[i], &value, NULL));
        assert_exact(value, worth[i]);
    }
    assert_true(unit_seconds("it", "min", &value, NULL));
    assert_exact(value, 60);
    assert_false(unit_seconds("it", "m", &value, &error));
    assert_string_equal(error->message, "it needs a known unit of time, not \"m\" (s, ms, min, h, d)");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_are_never_too_short_and_too_long_by_the_stated_share_at_most),
        cmocka_unit_test(the_stated_share_is_not_idle),
        cmocka_unit_test(distance_and_direction_from_the_origin_are_true),
        cmocka_unit_test(places_come_back),
        cmocka_unit_test(what_is_too_far_has_no_place_in_the_plane),
        cmocka_unit_test(the_middle_of_places_is_where_they_are),
        cmocka_unit_test(the_share_is_that_of_the_documentation),
        cmocka_unit_test(units_are_what_they_are_worth),
    };
    return cmocka_run_group_tests_name("georeference", tests, NULL, NULL);
}
