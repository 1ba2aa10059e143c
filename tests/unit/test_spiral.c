/* SPDX-License-Identifier: MIT */
/* Rides: the closed form against the differential equation and against the motion in the plane. */
#include "support/cmocka_all.h"

#include "geom/spiral.h"
#include "support/chance.h"

/* d(angle)/dt = sin(theta) / R(t), by Runge and Kutta's classical method; R alone matters, so it is Simpson's rule. */
static double integrated_angle(const geom_disc *disc, double t0, double t1)
{
    const int steps = 4000;
    double h = (t1 - t0) / steps, sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        double t = t0 + h * i;
        double k1 = 1.0 / (disc->radius + disc->rate * t);
        double k2 = 1.0 / (disc->radius + disc->rate * (t + 0.5 * h));
        double k4 = 1.0 / (disc->radius + disc->rate * (t + h));
        sum += h / 6.0 * (k1 + 4.0 * k2 + k4);
    }
    return sum * sqrt(1.0 - disc->rate * disc->rate);
}

static void angle_is_the_integral_of_its_differential_equation(void **state)
{
    (void)state;
    static const double rates[] = {0.0, 1e-300, 1e-14, -1e-9, 1e-5, 0.1, -0.1, 0.5, -0.5, 0.9, -0.9, 0.999, -0.999, 1.0 - 1e-12};
    uint64_t chance = 1;
    for (size_t i = 0; i < sizeof rates / sizeof rates[0]; ++i) {
        for (int k = 0; k < 20; ++k) {
            geom_disc disc = disc_make(point_make(3.0, -2.0), chance_between(&chance, 2.0, 5.0), rates[i]);
            double t0 = chance_between(&chance, -0.5, 0.5), t1 = t0 + chance_between(&chance, 0.0, 1.2);
            double expected = integrated_angle(&disc, t0, t1);
            assert_near(spiral_angle(&disc, t0, t1), expected, 1e-11 * expected + 1e-300);
        }
    }
}

/* One step of Runge and Kutta's classical method for x' = unit(arg x + side theta): a robot of speed 1 at angle theta from the normal. */
static tdsp_point motion_heading(tdsp_point x, double turn)
{
    return point_unit(atan2(x.y, x.x) + turn);
}

static tdsp_point motion_step(tdsp_point x, double turn, double h)
{
    tdsp_point k1 = motion_heading(x, turn);
    tdsp_point k2 = motion_heading(point_along(x, 0.5 * h, k1), turn);
    tdsp_point k3 = motion_heading(point_along(x, 0.5 * h, k2), turn);
    tdsp_point k4 = motion_heading(point_along(x, h, k3), turn);
    tdsp_point sum = point_add(point_add(k1, k4), point_scale(2.0, point_add(k2, k3)));
    return point_along(x, h / 6.0, sum);
}

static void a_robot_at_the_angle_theta_from_the_normal_stays_on_the_boundary(void **state)
{
    (void)state;
    uint64_t chance = 2;
    for (int k = 0; k < 100; ++k) {
        geom_disc disc = disc_make(point_make(0.0, 0.0), chance_between(&chance, 0.5, 2.0), chance_between(&chance, -0.4, 0.95));
        int side = k % 2 ? 1 : -1;
        double duration = chance_between(&chance, 0.0, 1.0), normal = chance_between(&chance, -3.0, 3.0);
        tdsp_point x = disc_boundary(&disc, normal, 0.0);
        for (int i = 0; i < 2000; ++i) x = motion_step(x, side * disc.theta, duration / 2000.0);
        double angle = normal + side * spiral_angle(&disc, 0.0, duration);
        assert_near(point_distance(x, disc_boundary(&disc, angle, duration)), 0.0, 1e-10);
    }
}

static void duration_undoes_angle(void **state)
{
    (void)state;
    uint64_t chance = 3;
    for (int k = 0; k < 2000; ++k) {
        double rate = k % 4 ? chance_between(&chance, -0.999, 0.999) : chance_between(&chance, -1e-6, 1e-6);
        geom_disc disc = disc_make(point_make(0.0, 0.0), chance_between(&chance, 0.1, 3.0), rate);
        double angle = chance_between(&chance, 0.0, 1.0) * disc.sine; /* no more than a few doublings of the radius */
        double duration = spiral_duration(&disc, 0.0, angle);
        assert_near(spiral_angle(&disc, 0.0, duration), angle, 1e-12 * angle);
    }
}

static void the_series_and_the_closed_form_meet(void **state)
{
    (void)state;
    for (int k = -50; k <= 50; ++k) {
        double ratio = 1e-5 * (1.0 + 1e-3 * k); /* rate * (t1 - t0) / R, about where the form changes */
        for (int sign = -1; sign <= 1; sign += 2) {
            geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0, sign * 0.01);
            long double rate = disc.rate, sine = sqrtl(1.0L - rate * rate), time = ratio / 0.01;
            assert_near(spiral_angle(&disc, 0.0, (double)time), (double)(sine / rate * log1pl(rate * time)), 1e-18);
            long double angle = sine * ratio / 0.01L;
            assert_near(spiral_duration(&disc, 0.0, (double)angle), (double)(expm1l(rate * angle / sine) / rate), 1e-17);
        }
    }
}

static void a_static_disc_is_ridden_on_a_circle(void **state)
{
    (void)state;
    geom_disc disc = disc_make(point_make(0.0, 0.0), 2.0, 0.0);
    assert_near(spiral_angle(&disc, 5.0, 6.0), 0.5, 1e-16);
    assert_near(spiral_duration(&disc, 5.0, GEOM_PI), 2.0 * GEOM_PI, 1e-15);
}

static void a_ride_takes_no_time_to_turn_by_nothing(void **state)
{
    (void)state;
    geom_disc disc = disc_make(point_make(0.0, 0.0), 2.0, 0.3);
    assert_exact(spiral_duration(&disc, 1.0, 0.0), 0.0);
    assert_exact(spiral_angle(&disc, 1.0, 1.0), 0.0);
}

static void longer_rides_turn_further(void **state)
{
    (void)state;
    uint64_t chance = 4;
    for (int k = 0; k < 100; ++k) {
        geom_disc disc = disc_make(point_make(0.0, 0.0), 1.0, chance_between(&chance, -0.9, 0.99));
        double before = 0.0;
        for (int i = 1; i <= 100; ++i) {
            double angle = spiral_angle(&disc, 0.0, 0.01 * i);
            assert_true(angle > before);
            before = angle;
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angle_is_the_integral_of_its_differential_equation),
        cmocka_unit_test(a_robot_at_the_angle_theta_from_the_normal_stays_on_the_boundary),
        cmocka_unit_test(duration_undoes_angle),
        cmocka_unit_test(the_series_and_the_closed_form_meet),
        cmocka_unit_test(a_static_disc_is_ridden_on_a_circle),
        cmocka_unit_test(a_ride_takes_no_time_to_turn_by_nothing),
        cmocka_unit_test(longer_rides_turn_further),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
