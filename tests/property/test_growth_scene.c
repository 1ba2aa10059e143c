/* SPDX-License-Identifier: MIT */
/* What the scene makes of a growth law is that law. */
#include "support/cmocka_all.h"

#include "support/chance.h"
#include "support/growth_solved.h"
#include "tdsp/growth.h"

/* The least rate of a polynomial at a time. */
static double least_rate(const grown_case *c, double time)
{
    double least = INFINITY;
    for (size_t i = 0; i < c->scene.count; i++) {
        const slow_law_disc law = slow_law_of(&c->scene.discs[i]);
        if (c->scene.discs[i].growth.kind == TDSP_GROWTH_POLYNOMIAL) least = fmin(least, law.jet(law.ctx, 0, time).rate);
    }
    return least;
}

static void radii_are_the_laws(grown_case *c)
{
    tdsp_scene *scene;
    grown_holds(c, tdsp_scene_create_growing(&c->scene.journey, c->scene.discs, c->scene.count, NULL, &scene) == TDSP_OK);
    const double valid = tdsp_scene_valid_until(scene, NULL), until = fmin(c->valid, valid);
    /* Where a rate only just falls below 0, and stays near it, the two may differ in when it does. */
    const double nothing = 1e-12 * c->scene.journey.speed;
    if (valid < c->valid) grown_relates(c, least_rate(c, valid), <=, nothing);
    if (valid > c->valid && c->valid < 19.0 * c->scene.unit)
        grown_relates(c, least_rate(c, fmin(valid, 1.001 * c->valid)), >=, -nothing);
    for (uint32_t i = 0; i < c->scene.count; i++) {
        const slow_law_disc law = slow_law_of(&c->scene.discs[i]);
        for (int k = 0; k < 50; k++) {
            const double time = until * chance_unit(&c->chance);
            double radius, rate;
            grown_holds(c, tdsp_scene_disc_at(scene, i, time, &radius, &rate) == TDSP_OK);
            const double expected = grown_radius(&c->scene.discs[i], time);
            grown_relates(c, fabs(radius - expected), <=, 1e-12 * (expected + c->scene.unit * c->scene.journey.speed));
            size_t piece = 0;
            while (piece < law.break_count && law.breaks[piece] <= time) piece++;
            const double speed = c->scene.journey.speed;
            grown_relates(c, fabs(rate - law.jet(law.ctx, piece, time).rate), <=, 1e-9 * (speed + rate));
        }
    }
    tdsp_scene_free(scene);
}

static void radii_and_rates_are_those_of_the_law(void **state)
{
    (void)state;
    grown_each(40, 6, radii_are_the_laws);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(radii_and_rates_are_those_of_the_law),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
