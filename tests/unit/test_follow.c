/* SPDX-License-Identifier: MIT */
/* Laws by callback: followed as closely as is said, in few pieces, or refused with the reason. */
#include "support/cmocka_all.h"
#include "support/tight.h"

#include <stdlib.h>
#include <string.h>

#include "scene/scene.h"
#include "support/chance.h"
#include "tdsp/growth.h"

#define SEED 20263
#define AGREES 1e-13

typedef struct law {
    tdsp_growth_law ask;
    const char *name;
    double until;
    double kinks[4];
    size_t count;
    uint32_t most_pieces;
} law;

static const tdsp_journey journey = {2.0, 0.25, {-30.0, 1.0}, {50.0, -2.0}};

static tdsp_growing_disc disc_of(const law *l)
{
    tdsp_growing_disc disc = {{1.0, 2.0}, 0.0, {TDSP_GROWTH_LAW, 0.0, l->count, NULL, l->kinks, l->ask, NULL, l->until}};
    double rate;
    l->ask(NULL, 0.0, &disc.radius, &rate);
    return disc;
}

/* 2 + 3 t */
static void linear(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 2.0 + 3.0 * t;
    *rate = 3.0;
}

/* Grows from 1 to 4, and stays there. */
static void capped(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = fmin(1.0 + 0.5 * t, 4.0);
    *rate = t < 6.0 ? 0.5 : 0.0;
}

/* Begins to grow at an alarm. */
static void delayed(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 0.3 + (t > 7.3 ? 1.4 * (t - 7.3) : 0.0);
    *rate = t >= 7.3 ? 1.4 : 0.0;
}

/* The same from nothing. */
static void delayed_point(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = t > 1.1 ? (t - 1.1) * (t - 1.1) : 0.0;
    *rate = t > 1.1 ? 2.0 * (t - 1.1) : 0.0;
}

/* Slows down towards a final radius. */
static void saturating(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 1.0 + 5.0 * -expm1(-0.3 * t);
    *rate = 1.5 * exp(-0.3 * t);
}

static void logistic(void *ctx, double t, double *radius, double *rate)
{
    double share = 1.0 / (1.0 + exp(-(t - 20.0)));
    (void)ctx;
    *radius = 100.0 * share;
    *rate = 100.0 * share * (1.0 - share);
}

/* Stands still again and again: the rate touches zero. */
static void pulsing(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 1.0 + t - sin(t);
    *rate = 1.0 - cos(t);
}

static void cubic(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 200.0 + (t - 5.0) * (t - 5.0) * (t - 5.0);
    *rate = 3.0 * (t - 5.0) * (t - 5.0);
}

/* Not smooth where it begins. */
static void root(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = t * sqrt(t);
    *rate = 1.5 * sqrt(t);
}

static void exponential(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = *rate = exp(t);
}

static void huge(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 1e60 * (1.0 + t * t * 1e-40);
    *rate = 2e20 * t;
}

static const law laws[] = {
    {linear, "linear", 50.0, {0.0}, 0, 1},
    {capped, "capped", 50.0, {6.0}, 1, 2},
    {capped, "capped, the kink not told", 50.0, {0.0}, 0, 120},
    {delayed, "delayed", 50.0, {7.3}, 1, 2},
    {delayed, "delayed, the kink not told", 50.0, {0.0}, 0, 120},
    {delayed_point, "a point that begins to grow", 3.0, {1.1, 9.0}, 2, 3},
    {delayed_point, "the same, the kink not told", 3.0, {0.0}, 0, 120},
    {saturating, "saturating", 60.0, {0.0}, 0, 40},
    {logistic, "logistic", 100.0, {0.0}, 0, 150},
    {pulsing, "pulsing", 40.0, {0.0}, 0, 180},
    {cubic, "cubic", 10.0, {0.0}, 0, 2},
    {root, "root", 4.0, {0.0}, 0, 300},
    {exponential, "exponential", 40.0, {0.0}, 0, 140},
    {huge, "huge", 1e30, {0.0}, 0, 2},
};
#define LAWS (sizeof laws / sizeof *laws)

static tdsp_scene *scene_of(const law *l)
{
    tdsp_growing_disc disc = disc_of(l);
    const char *wrong = tdsp_growing_disc_check(&disc);
    tdsp_scene *scene;
    if (wrong) fail_msg("%s: %s", l->name, wrong);
    assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_OK);
    return scene;
}

/* The radius that an error is a share of: that at the end of the piece, and a clock's ticks. */
static double scale_at(const tdsp_scene *scene, double time)
{
    double radius, rate;
    if (scene->pieces) {
        geom_law followed = scene_law(scene, 0);
        uint32_t k = law_piece_at(&followed, time);
        if (k + 1 < followed.count) time = followed.pieces[k + 1].start;
    }
    assert_int_equal(tdsp_scene_disc_at(scene, 0, time, &radius, &rate), TDSP_OK);
    return radius + rate * time * 0.1;
}

/* Compared with the law at random times, and beside its kinks. */
static void a_law_is_followed_as_closely_as_is_said(void **state)
{
    (void)state;
    uint64_t chance = SEED;
    print_message("seed %d\n", SEED);
    for (size_t i = 0; i < LAWS; ++i) {
        tdsp_scene *scene = scene_of(&laws[i]);
        double worst = 0.0, largest, end_rate;
        laws[i].ask(NULL, laws[i].until, &largest, &end_rate);
        for (int k = 0; k < 20000; ++k) {
            double t = laws[i].until * pow(chance_unit(&chance), 1.0 + (double)(k % 3)), expected, rate, found;
            laws[i].ask(NULL, t, &expected, &rate);
            assert_int_equal(tdsp_scene_disc_at(scene, 0, t, &found, &rate), TDSP_OK);
            assert_true(rate >= -1e-14 * (largest / laws[i].until + rate));
            worst = fmax(worst, fabs(found - expected) / (laws[i].most_pieces > 100 ? largest : scale_at(scene, t)));
        }
        uint32_t pieces = scene->pieces ? scene_law(scene, 0).count : 1;
        print_message("%-30s %3u pieces, off by %.1e\n", laws[i].name, pieces, worst);
        assert_true(worst <= 1.5 * AGREES);
        assert_true(pieces <= laws[i].most_pieces + 1);
        tdsp_scene_free(scene);
    }
}

static void the_rate_is_followed_too(void **state)
{
    (void)state;
    uint64_t chance = SEED + 1;
    const law smooth[] = {laws[7], laws[8], laws[9], laws[10], laws[12]};
    for (size_t i = 0; i < sizeof smooth / sizeof *smooth; ++i) {
        tdsp_scene *scene = scene_of(&smooth[i]);
        geom_law followed = scene_law(scene, 0);
        for (int k = 0; k < 20000; ++k) {
            double t = smooth[i].until * chance_unit(&chance), radius, expected, rate;
            uint32_t piece = law_piece_at(&followed, t);
            double length = (piece + 1 < followed.count ? followed.pieces[piece + 1].start : 2.0 * smooth[i].until) -
                            followed.pieces[piece].start;
            smooth[i].ask(NULL, t, &radius, &expected);
            (void)tdsp_scene_disc_at(scene, 0, t, &radius, &rate);
            assert_near(rate, expected, 4.0 * AGREES * smooth[i].until / length * fmax(1.0, radius));
        }
        tdsp_scene_free(scene);
    }
}

/* From one piece to the next: the radius neither jumps nor falls but by round-off. */
static void pieces_join(void **state)
{
    (void)state;
    for (size_t i = 0; i < LAWS; ++i) {
        tdsp_scene *scene = scene_of(&laws[i]);
        for (uint32_t k = 1; scene->pieces && k < scene_law(scene, 0).count; ++k) {
            const law_piece *piece = &scene->pieces[k];
            double before = law_piece_jet(piece - 1, piece->start).radius;
            assert_near(piece->c[0], before, 4e-15 * (before + piece->start * law_piece_jet(piece, piece->start).rate));
        }
        tdsp_scene_free(scene);
    }
}

/* Within a piece the rate is not negative, by Bernstein's form on parts of it. */
static void no_piece_shrinks(void **state)
{
    (void)state;
    for (size_t i = 0; i < LAWS; ++i) {
        tdsp_scene *scene = scene_of(&laws[i]);
        for (uint32_t k = 0; scene->pieces && k + 1 < scene_law(scene, 0).count; ++k) {
            polynomial radius = law_piece_polynomial(&scene->pieces[k]), rate = polynomial_derivative(&radius);
            double length = scene->pieces[k + 1].start - scene->pieces[k].start, size = 0.0;
            for (int m = rate.degree; m >= 0; --m) size = size * length + fabs(rate.c[m]);
            for (int m = 0; m < 16; ++m)
                assert_true(polynomial_least(&rate, length * m / 16.0, length * (m + 1) / 16.0) >= -64.0 * 2.3e-16 * size);
        }
        tdsp_scene_free(scene);
    }
}

static void after_its_last_time_a_law_keeps_its_rate(void **state)
{
    (void)state;
    for (size_t i = 0; i < LAWS; ++i) {
        double radius, rate, far, far_rate;
        tdsp_scene *scene = scene_of(&laws[i]);
        laws[i].ask(NULL, laws[i].until, &radius, &rate);
        assert_int_equal(tdsp_scene_disc_at(scene, 0, 3.0 * laws[i].until, &far, &far_rate), TDSP_OK);
        assert_near(far_rate, rate, 1e-15 * rate);
        assert_near(far, radius + 2.0 * laws[i].until * rate, 1e-13 * far);
        tdsp_scene_free(scene);
    }
}

static void a_law_at_one_rate_is_a_rate(void **state)
{
    (void)state;
    tdsp_scene *scene = scene_of(&laws[0]), *plain;
    const tdsp_disc disc = {{1.0, 2.0}, 2.0, 3.0};
    assert_int_equal(tdsp_scene_create(&journey, &disc, 1, NULL, &plain), TDSP_OK);
    assert_true(tdsp_scene_has_rates_only(scene));
    assert_true(tdsp_scene_hash(scene) == tdsp_scene_hash(plain));
    tdsp_scene_free(scene);
    tdsp_scene_free(plain);
}

static void the_hash_is_of_what_is_followed(void **state)
{
    (void)state;
    for (size_t i = 1; i < LAWS; ++i) {
        tdsp_scene *scene = scene_of(&laws[i]), *again = scene_of(&laws[i]), *other = scene_of(&laws[i - 1]);
        assert_true(tdsp_scene_hash(scene) == tdsp_scene_hash(again));
        assert_true(tdsp_scene_hash(scene) != tdsp_scene_hash(other));
        tdsp_scene_free(scene);
        tdsp_scene_free(again);
        tdsp_scene_free(other);
    }
}

static void jumping(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = t < 3.3 ? 1.0 : 1.0 + 1e-6;
    *rate = 0.0;
}

static void falling(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 2.0 + sin(t);
    *rate = fmax(0.0, cos(t));
}

static void shrinking(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 2.0 + t - 0.01 * t * t;
    *rate = 1.0 - 0.02 * t;
}

static void broken(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 1.0 + t;
    *rate = t > 4.0 && t < 4.6 ? NAN : 1.0;
}

static void silent(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    if (t > 0.0) return;
    *radius = 1.0;
    *rate = 1.0;
}

static void twice(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 1.0 + t * t;
    *rate = 4.0 * t;
}

static void nearly(void *ctx, double t, double *radius, double *rate)
{
    (void)ctx;
    *radius = 1.0 + t * t;
    *rate = 2.000001 * t;
}

/* A new rate every 1/8192, in times that no halving meets. */
static void jagged(void *ctx, double t, double *radius, double *rate)
{
    double x = 8192.0 * t, whole = floor(x), share = x - whole;
    (void)ctx;
    *radius = 1.0 + (whole + fmin(1.0, 3.0 * share)) / 8192.0;
    *rate = 3.0 * share < 1.0 ? 3.0 : 0.0;
}

static void assert_refused(tdsp_growing_disc disc, const char *word)
{
    tdsp_scene *scene = NULL;
    const char *text = tdsp_growing_disc_check(&disc);
    if (!text || !strstr(text, word)) fail_msg("%s: %s", word, text ? text : "nothing is wrong");
    assert_int_equal(tdsp_scene_create_growing(&journey, &disc, 1, NULL, &scene), TDSP_BAD_SCENE);
    assert_null(scene);
}

static void a_law_that_breaks_a_condition_is_refused_and_told_which(void **state)
{
    (void)state;
    const struct {
        tdsp_growth_law ask;
        const char *word;
    } bad[] = {{jumping, "jumps"},
               {falling, "falls"},
               {shrinking, "rate that is not"},
               {broken, "rate that is not"},
               {silent, "radius that is not"},
               {twice, "disagrees"},
               {nearly, "16384"},
               {jagged, "16384"}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        law l = {bad[i].ask, bad[i].word, 10.0, {0.0}, 0, 0};
        if (bad[i].ask == shrinking) l.until = 70.0;
        assert_refused(disc_of(&l), bad[i].word);
    }
}

static void what_is_said_of_a_law_is_checked(void **state)
{
    (void)state;
    tdsp_growing_disc disc = disc_of(&laws[1]);
    const double zero[1] = {0.0}, back[2] = {2.0, 1.0}, never[1] = {NAN};
    tdsp_growing_disc bad = disc;
    bad.growth.law = NULL;
    assert_refused(bad, "missing");
    bad = disc;
    bad.radius = 1.01;
    assert_refused(bad, "at time 0");
    bad = disc;
    bad.growth.times = NULL;
    assert_refused(bad, "missing");
    bad.growth.times = zero;
    assert_refused(bad, "kinks");
    bad.growth.times = never;
    assert_refused(bad, "kinks");
    bad.growth.times = back;
    bad.growth.count = 2;
    assert_refused(bad, "kinks");
    for (int k = 0; k < 4; ++k) {
        const double untils[4] = {0.0, -1.0, NAN, INFINITY};
        bad = disc;
        bad.growth.until = untils[k];
        assert_refused(bad, "last time");
    }
}

static void every_piece_of_memory_is_asked_for_and_given_back(void **state)
{
    (void)state;
    const tdsp_growing_disc discs[2] = {disc_of(&laws[7]), disc_of(&laws[0])};
    for (size_t count = 1; count <= 2; ++count) {
        tight_heap heap = {0};
        tdsp_status status = TDSP_NO_MEMORY;
        for (heap.refuse = 1; status == TDSP_NO_MEMORY; ++heap.refuse) {
            const tdsp_allocator allocator = tight_allocator(&heap);
            tdsp_scene *scene = NULL;
            heap.calls = 0;
            status = tdsp_scene_create_growing(&journey, discs + (count == 1), count, &allocator, &scene);
            assert_true(status == TDSP_OK || status == TDSP_NO_MEMORY);
            tdsp_scene_free(scene);
            assert_int_equal(heap.held, 0);
        }
        assert_true(heap.refuse > 4);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_law_is_followed_as_closely_as_is_said),
        cmocka_unit_test(the_rate_is_followed_too),
        cmocka_unit_test(pieces_join),
        cmocka_unit_test(no_piece_shrinks),
        cmocka_unit_test(after_its_last_time_a_law_keeps_its_rate),
        cmocka_unit_test(a_law_at_one_rate_is_a_rate),
        cmocka_unit_test(the_hash_is_of_what_is_followed),
        cmocka_unit_test(a_law_that_breaks_a_condition_is_refused_and_told_which),
        cmocka_unit_test(what_is_said_of_a_law_is_checked),
        cmocka_unit_test(every_piece_of_memory_is_asked_for_and_given_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
