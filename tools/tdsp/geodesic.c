/* SPDX-License-Identifier: MIT */
/*
 * Geodesics by Vincenty's formulas (Survey Review 23 (1975) 88-93): a place on the ellipsoid goes to the one on a sphere that has its reduced latitude,
 * tan U = (1 - f) tan lat. There the geodesic is a great circle; its length and the longitude along it come out by series in u^2, the second eccentricity
 * squared times cos^2 of the azimuth at the equator. What the series leave out is under 1e-11 of the distance: 11 micrometres in 1500 km.
 * The names of variables are Vincenty's.
 */
#include "geodesic.h"

#include <math.h>

#define DEGREE (G_PI / 180)
#define MOST_STEPS 200
#define SETTLED 1e-15  /* rad; rounding stirs up less */
#define UNSETTLED 1e-12

const char *geodesic_check(GeoPlace place)
{
    if (!(fabs(place.lat) <= 90)) return "a latitude is from -90 to 90";
    return fabs(place.lon) <= 180 ? NULL : "a longitude is from -180 to 180";
}

double geodesic_turned(double degrees)
{
    return fabs(degrees) <= 180 ? degrees : remainder(degrees, 360);
}

static double reduced(double latitude)
{
    /* atan2, so that a pole stays one */
    return atan2((1 - GEODESIC_F) * sin(latitude * DEGREE), cos(latitude * DEGREE));
}

/* The great circle, seen from its equator. */
typedef struct Circle {
    double sin_alpha, cos2_alpha; /* of the azimuth there */
    double sigma, sin_sigma, cos_sigma;
    double cos_2sigma_m; /* of twice the way from the equator to the middle */
} Circle;

/* Longitude on the sphere minus longitude on the ellipsoid. */
static double longitude_gained(const Circle *c)
{
    double C = GEODESIC_F / 16 * c->cos2_alpha * (4 + GEODESIC_F * (4 - 3 * c->cos2_alpha));
    double middle = 2 * c->cos_2sigma_m * c->cos_2sigma_m - 1;
    return (1 - C) * GEODESIC_F * c->sin_alpha * (c->sigma + C * c->sin_sigma * (c->cos_2sigma_m + C * c->cos_sigma * middle));
}

static double second_eccentricity(const Circle *c)
{
    return c->cos2_alpha * (GEODESIC_A * GEODESIC_A - GEODESIC_B * GEODESIC_B) / (GEODESIC_B * GEODESIC_B);
}

static double series_a(double u2)
{
    return 1 + u2 / 16384 * (4096 + u2 * (-768 + u2 * (320 - 175 * u2)));
}

static double sigma_gained(const Circle *c, double u2)
{
    double B = u2 / 1024 * (256 + u2 * (-128 + u2 * (74 - 47 * u2)));
    double m = c->cos_2sigma_m, s = c->sin_sigma;
    return B * s * (m + B / 4 * (c->cos_sigma * (2 * m * m - 1) - B / 6 * m * (4 * s * s - 3) * (4 * m * m - 3)));
}

/* Both places on the sphere. */
typedef struct Sphere {
    double sin1, cos1, sin2, cos2; /* of the reduced latitudes */
    double sin_apart;              /* of their difference */
} Sphere;

static Sphere sphere_of(GeoPlace from, GeoPlace to)
{
    double U1 = reduced(from.lat), U2 = reduced(to.lat);
    return (Sphere){sin(U1), cos(U1), sin(U2), cos(U2), sin(U2 - U1)};
}

/* What the way to the other place has northwards as one leaves; sin(U2 - U1) keeps the digits of places close together. */
static double northwards(const Sphere *on, double lambda)
{
    double half = sin(lambda / 2);
    return on->sin_apart + 2 * on->sin1 * on->cos2 * half * half;
}

static Circle circle_through(const Sphere *on, double lambda)
{
    Circle c = {0};
    double east = on->cos2 * sin(lambda), both = on->sin1 * on->sin2;
    c.sin_sigma = hypot(east, northwards(on, lambda));
    c.cos_sigma = both + on->cos1 * on->cos2 * cos(lambda);
    c.sigma = atan2(c.sin_sigma, c.cos_sigma);
    c.sin_alpha = c.sin_sigma > 0 ? on->cos1 * east / c.sin_sigma : 0;
    c.cos2_alpha = 1 - c.sin_alpha * c.sin_alpha;
    /* along the equator there is no middle to speak of, and u^2 is 0 */
    c.cos_2sigma_m = c.cos2_alpha > 0 ? c.cos_sigma - 2 * both / c.cos2_alpha : 0;
    return c;
}

gboolean geodesic_inverse(GeoPlace from, GeoPlace to, double *distance, double *azimuth)
{
    const Sphere on = sphere_of(from, to);
    const double L = geodesic_turned(to.lon - from.lon) * DEGREE;
    double lambda = L, moved = INFINITY;
    for (int i = 0; i < MOST_STEPS && moved > SETTLED; i++) {
        Circle c = circle_through(&on, lambda);
        double next = L + longitude_gained(&c);
        moved = fabs(next - lambda);
        lambda = next;
    }
    if (!(moved <= UNSETTLED && fabs(lambda) <= G_PI)) return FALSE;
    Circle c = circle_through(&on, lambda);
    double u2 = second_eccentricity(&c);
    *distance = GEODESIC_B * series_a(u2) * (c.sigma - sigma_gained(&c, u2));
    *azimuth = c.sin_sigma > 0 ? atan2(on.cos2 * sin(lambda), northwards(&on, lambda)) : 0;
    return TRUE;
}

static void circle_reach(Circle *c, double sigma, double sigma1)
{
    c->sigma = sigma;
    c->sin_sigma = sin(sigma);
    c->cos_sigma = cos(sigma);
    c->cos_2sigma_m = cos(2 * sigma1 + sigma);
}

GeoPlace geodesic_direct(GeoPlace from, double azimuth, double distance)
{
    const double U1 = reduced(from.lat), sin1 = sin(U1), cos1 = cos(U1), north = cos(azimuth), east = sin(azimuth);
    const double sigma1 = atan2(sin1, cos1 * north);
    Circle c = {.sin_alpha = cos1 * east};
    c.cos2_alpha = 1 - c.sin_alpha * c.sin_alpha;
    const double u2 = second_eccentricity(&c), round = distance / (GEODESIC_B * series_a(u2));
    double moved = INFINITY;
    circle_reach(&c, round, sigma1);
    for (int i = 0; i < MOST_STEPS && moved > SETTLED; i++) {
        double next = round + sigma_gained(&c, u2);
        moved = fabs(next - c.sigma);
        circle_reach(&c, next, sigma1);
    }
    double up = sin1 * c.cos_sigma + cos1 * c.sin_sigma * north, in = sin1 * c.sin_sigma - cos1 * c.cos_sigma * north;
    double lambda = atan2(c.sin_sigma * east, cos1 * c.cos_sigma - sin1 * c.sin_sigma * north);
    double L = lambda - longitude_gained(&c);
    double latitude = atan2(up, (1 - GEODESIC_F) * hypot(c.sin_alpha, in));
    return (GeoPlace){geodesic_turned(from.lon + L / DEGREE), latitude / DEGREE};
}
