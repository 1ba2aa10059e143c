/* SPDX-License-Identifier: MIT */
/* Laws that break a condition only somewhere: refused wherever they are looked at. */
#include "support/cmocka_all.h"

#include <string.h>

#include "tdsp/growth.h"

static void vast(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = t > 50.0 ? 2e100 : 1.0;
    *rate = 0.0;
}

static void swift(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 1.0;
    *rate = t > 50.0 ? 2e100 : 0.0;
}

static void backwards_at_first(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 1.0;
    *rate = t == 0.0 ? -1.0 : 0.0;
}

static void dips_at_40(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = t == 40.0 ? 0.5 : 1.0 + 0.01 * t;
    *rate = 0.01;
}

static void lost_at_40(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = t == 40.0 ? NAN : 1.0 + 0.01 * t;
    *rate = 0.01;
}

/* Grows by steps that no kink tells of and no rate shows. */
static void stepping(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 1.0 + floor(t * 64.0) / 6400.0;
    *rate = 0.0;
}

static void assert_refused(tdsp_growing_disc disc, const char *word)
{
    const char *text = tdsp_growing_disc_check(&disc);
    if (!text || !strstr(text, word)) fail_msg("%s: %s", word, text ? text : "nothing is wrong");
}

static tdsp_growing_disc law_disc(tdsp_growth_law ask, size_t count, const double *kinks)
{
    return (tdsp_growing_disc){{1.0, 2.0}, 1.0, {TDSP_GROWTH_LAW, 0.0, count, NULL, kinks, ask, NULL, 100.0}};
}

static void a_law_that_breaks_a_condition_only_somewhere_is_refused_too(void **state)
{
    (void)state;
    const double kinks[2] = {40.0, 60.0}, far[1] = {2e100};
    assert_refused(law_disc(vast, 0, NULL), "radius");
    assert_refused(law_disc(swift, 0, NULL), "rate");
    assert_refused(law_disc(backwards_at_first, 0, NULL), "rate");
    assert_refused(law_disc(dips_at_40, 2, kinks), "radius falls");
    assert_refused(law_disc(lost_at_40, 2, kinks), "radius");
    assert_refused(law_disc(stepping, 0, NULL), "");
    assert_refused(law_disc(stepping, 1, far), "kinks");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_law_that_breaks_a_condition_only_somewhere_is_refused_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
