/* SPDX-License-Identifier: MIT */
/* Geodesics on WGS84 against published values, and against GeographicLib, which gets them by another method to 15 nanometres. */
#include "support/cmocka_all.h"

#include "tdsp/geodesic.h"

#define DEGREE (G_PI / 180)

/* GeographicLib 2.1 (Karney): from, to, metres, degrees. */
typedef struct Known {
    GeoPlace from, to;
    double distance, azimuth;
} Known;

static const Known known[] = {
    {{-120.0, 44.3}, {-119.6, 44.6}, 46097.943575287, 43.54403315903477},
    {{179.9, -16.5}, {-179.8, -17.2}, 83805.266180958, 157.61719595010095},
    {{-179.999, 65}, {179.999, 65.001}, 146.05613332, -40.23826418208485},
    {{0, 89.9}, {180, 89.8}, 33508.192835871, 0.0},
    {{30, 90}, {75, 85}, 558455.588646477, 135.0},
    {{-30, -90}, {120, -88.5}, 167540.58244227, 150.0},
    {{0, 0}, {1, 0}, 111319.490793274, 90.0},
    {{0, 0}, {0, 1}, 110574.388557799, 0.0},
    {{10, 0.5}, {10.00001, 0.5}, 1.113152805, 89.99999995636732},
    {{151, -33.9}, {147, -42.9}, 1058030.195980659, -161.94411977367673},
    {{-0.1276, 51.5072}, {-8.5, 40}, 1433111.293406805, -149.91321175282994},
    {{12, -5}, {25, -8}, 1475485.973062034, 103.67590973517613},
    {{25, 70}, {5, 80}, 1241255.122358076, -17.94502704019219},
};

/* 1e-11 of the distance, as the series have it, and what the last digits above leave open. */
static double allowed(double distance)
{
    return 1e-9 + 1e-11 * distance;
}

static void distances_and_directions_are_those_of_another_method(void **state)
{
    (void)state;
    for (gsize i = 0; i < G_N_ELEMENTS(known); i++) {
        double distance, azimuth;
        assert_true(geodesic_inverse(known[i].from, known[i].to, &distance, &azimuth));
        assert_near(distance, known[i].distance, allowed(distance));
        assert_near(remainder(azimuth - known[i].azimuth * DEGREE, 2 * G_PI) * distance, 0, allowed(distance));
    }
}

static void going_there_gets_there(void **state)
{
    (void)state;
    for (gsize i = 0; i < G_N_ELEMENTS(known); i++) {
        double off, azimuth;
        GeoPlace there = geodesic_direct(known[i].from, known[i].azimuth * DEGREE, known[i].distance);
        assert_null(geodesic_check(there));
        assert_true(geodesic_inverse(known[i].to, there, &off, &azimuth));
        assert_near(off, 0, allowed(known[i].distance));
    }
}

/* C. F. F. Karney, Algorithms for geodesics, J. Geodesy 87 (2013), tables 2 and 3. */
static void published_geodesics_come_out(void **state)
{
    (void)state;
    double distance, azimuth;
    GeoPlace there = geodesic_direct((GeoPlace){0, 40}, 30 * DEGREE, 10e6);
    assert_near(there.lat, 41.79331020506, 1e-9);
    assert_near(there.lon, 137.84490004377, 1e-9);
    assert_true(geodesic_inverse((GeoPlace){0, -30.12345}, (GeoPlace){0.00005, -30.12344}, &distance, &azimuth));
    assert_near(distance, 4.944208, 5e-7);
    assert_near(azimuth / DEGREE, 77.0435335, 5e-7);
}

/* A quarter of a meridian of WGS84 has 10001965.729 m. */
static void the_pole_is_a_quarter_meridian_from_the_equator(void **state)
{
    (void)state;
    double distance, azimuth;
    assert_true(geodesic_inverse((GeoPlace){17, 0}, (GeoPlace){-100, 90}, &distance, &azimuth));
    assert_near(distance, 10001965.729, 1e-3);
    assert_near(azimuth, 0, 1e-12);
}

static void a_place_is_no_distance_from_itself(void **state)
{
    (void)state;
    static const GeoPlace places[] = {{0, 0}, {180, 0}, {-180, 12}, {33, 90}, {33, -90}, {-71.25, 42.5}};
    for (gsize i = 0; i < G_N_ELEMENTS(places); i++) {
        double distance = 1, azimuth;
        assert_true(geodesic_inverse(places[i], places[i], &distance, &azimuth));
        assert_near(distance, 0, 1e-9);
        GeoPlace there = geodesic_direct(places[i], 1, 0);
        assert_near(there.lat, places[i].lat, 1e-13);
        assert_near(geodesic_turned(there.lon - places[i].lon), 0, places[i].lat == 0 ? 1e-13 : 360);
    }
}

static void opposite_places_are_refused(void **state)
{
    (void)state;
    double distance, azimuth;
    assert_false(geodesic_inverse((GeoPlace){0, 0}, (GeoPlace){179.9, 0.1}, &distance, &azimuth));
    assert_false(geodesic_inverse((GeoPlace){0, 0.5}, (GeoPlace){180, -0.5}, &distance, &azimuth));
}

static void places_out_of_range_are_named(void **state)
{
    (void)state;
    assert_string_equal(geodesic_check((GeoPlace){0, 90.0001}), "a latitude is from -90 to 90");
    assert_string_equal(geodesic_check((GeoPlace){0, NAN}), "a latitude is from -90 to 90");
    assert_string_equal(geodesic_check((GeoPlace){-180.5, 0}), "a longitude is from -180 to 180");
    assert_string_equal(geodesic_check((GeoPlace){NAN, 0}), "a longitude is from -180 to 180");
    assert_null(geodesic_check((GeoPlace){-180, -90}));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(distances_and_directions_are_those_of_another_method),
        cmocka_unit_test(going_there_gets_there),
        cmocka_unit_test(published_geodesics_come_out),
        cmocka_unit_test(the_pole_is_a_quarter_meridian_from_the_equator),
        cmocka_unit_test(a_place_is_no_distance_from_itself),
        cmocka_unit_test(opposite_places_are_refused),
        cmocka_unit_test(places_out_of_range_are_named),
    };
    return cmocka_run_group_tests_name("geodesic", tests, NULL, NULL);
}
