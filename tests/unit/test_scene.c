/* SPDX-License-Identifier: MIT */
/* Making scenes: what is refused, what is kept as given, the hash, the covers, the frame. */
#include "support/cmocka_all.h"

#include <string.h>

#include "scene/scene.h"
#include "support/chance.h"
#include "support/tight.h"

static const tdsp_journey good_journey = {2.0, 0.25, {-3.0, 1.0}, {5.0, -2.0}};
static const tdsp_disc good_disc = {{1.0, 2.0}, 0.5, 0.1};

static void assert_bad_journey(tdsp_journey journey, const char *word)
{
    tdsp_scene *untouched = (tdsp_scene *)&untouched, *scene = untouched;
    const char *text = tdsp_journey_check(&journey);
    assert_non_null(text);
    assert_non_null(strstr(text, word));
    assert_int_equal(tdsp_scene_create(&journey, &good_disc, 1, NULL, &scene), TDSP_BAD_SCENE);
    assert_ptr_equal(scene, untouched);
}

#define BAD_JOURNEY(member, value, word)                                                                                         \
    do {                                                                                                                         \
        tdsp_journey journey = good_journey;                                                                                     \
        journey.member = (value);                                                                                                \
        assert_bad_journey(journey, word);                                                                                       \
    } while (0)

static void each_number_of_a_journey_is_checked(void **state)
{
    (void)state;
    static const double never[] = {NAN, INFINITY, -INFINITY, 1.1e100, -1.1e100};
    assert_null(tdsp_journey_check(&good_journey));
    for (size_t i = 0; i < 5; ++i) {
        BAD_JOURNEY(speed, never[i], "speed");
        BAD_JOURNEY(radius, never[i], "radius");
        BAD_JOURNEY(source.x, never[i], "source");
        BAD_JOURNEY(source.y, never[i], "source");
        BAD_JOURNEY(destination.x, never[i], "destination");
        BAD_JOURNEY(destination.y, never[i], "destination");
    }
    BAD_JOURNEY(speed, 0.0, "speed");
    BAD_JOURNEY(speed, -1.0, "speed");
    BAD_JOURNEY(speed, 1e-101, "speed");
    BAD_JOURNEY(radius, -1e-300, "radius");
}

static void assert_bad_disc(tdsp_disc disc, const char *word)
{
    tdsp_scene *untouched = (tdsp_scene *)&untouched, *scene = untouched;
    const tdsp_disc discs[3] = {good_disc, good_disc, disc};
    const char *text = tdsp_disc_check(&disc);
    assert_non_null(text);
    assert_non_null(strstr(text, word));
    assert_int_equal(tdsp_scene_create(&good_journey, discs, 3, NULL, &scene), TDSP_BAD_SCENE);
    assert_ptr_equal(scene, untouched);
}

#define BAD_DISC(member, value, word)                                                                                            \
    do {                                                                                                                         \
        tdsp_disc disc = good_disc;                                                                                              \
        disc.member = (value);                                                                                                   \
        assert_bad_disc(disc, word);                                                                                             \
    } while (0)

static void each_number_of_a_disc_is_checked(void **state)
{
    (void)state;
    static const double never[] = {NAN, INFINITY, -INFINITY, 1.1e100, -1.1e100};
    assert_null(tdsp_disc_check(&good_disc));
    for (size_t i = 0; i < 5; ++i) {
        BAD_DISC(center.x, never[i], "centre");
        BAD_DISC(center.y, never[i], "centre");
        BAD_DISC(radius, never[i], "radius");
        BAD_DISC(growth, never[i], "growth");
    }
    BAD_DISC(radius, -1e-300, "radius");
    BAD_DISC(growth, -1e-300, "growth");
}

static void missing_arguments_and_too_many_discs_are_refused(void **state)
{
    (void)state;
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create(NULL, &good_disc, 1, NULL, &scene), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_create(&good_journey, NULL, 1, NULL, &scene), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_create(&good_journey, &good_disc, 1, NULL, NULL), TDSP_INVALID_ARGUMENT);
    assert_int_equal(tdsp_scene_create(&good_journey, &good_disc, 0x80000000u, NULL, &scene), TDSP_INVALID_ARGUMENT);
    tdsp_scene_free(NULL);
}

static void one_bad_disc_among_good_ones_is_enough(void **state)
{
    (void)state;
    const tdsp_journey journey = {1.0, 0.0, {0.0, 0.0}, {1.0, 0.0}};
    for (size_t bad = 0; bad < 3; bad++) {
        tdsp_disc discs[3] = {{{5.0, 0.0}, 1.0, 0.0}, {{6.0, 0.0}, 1.0, 0.0}, {{7.0, 0.0}, 1.0, 0.0}};
        tdsp_scene *scene;
        discs[bad].radius = -1.0;
        assert_int_equal(tdsp_scene_create(&journey, discs, 3, NULL, &scene), TDSP_BAD_SCENE);
    }
}

/* Centres that close in on a point halve the index again and again: it has more nodes than are reserved at first. */
static void an_index_of_many_levels_without_memory_is_refused(void **state)
{
    (void)state;
    enum { COUNT = 40 };
    const tdsp_journey journey = {1.0, 0.0, {-2.0, 0.0}, {2.0, 1.0}};
    tdsp_disc discs[COUNT];
    for (int i = 0; i < COUNT; i++) discs[i] = (tdsp_disc){{ldexp(1.0, -i), 0.0}, ldexp(0.1, -i), 0.0};
    tdsp_status status = TDSP_NO_MEMORY;
    for (size_t refuse = 1; status == TDSP_NO_MEMORY; refuse++) {
        tight_heap heap = {.refuse = refuse};
        tdsp_allocator memory = tight_allocator(&heap);
        tdsp_scene *scene = NULL;
        status = tdsp_scene_create(&journey, discs, COUNT, &memory, &scene);
        tdsp_scene_free(scene);
        assert_int_equal(heap.blocks, 0);
    }
    assert_int_equal(status, TDSP_OK);
}

static void a_scene_hands_out_what_it_was_given(void **state)
{
    (void)state;
    tdsp_disc discs[100];
    uint64_t chance = 1;
    tdsp_scene *scene;
    size_t count = 0;
    for (int i = 0; i < 100; ++i) {
        tdsp_disc disc = {{chance_between(&chance, -5.0, 5.0), chance_between(&chance, -5.0, 5.0)}, chance_unit(&chance), chance_unit(&chance)};
        discs[i] = disc;
    }
    assert_int_equal(tdsp_scene_create(&good_journey, discs, 100, NULL, &scene), TDSP_OK);
    assert_ptr_not_equal(tdsp_scene_discs(scene, &count), discs);
    assert_int_equal(count, 100);
    assert_memory_equal(tdsp_scene_discs(scene, NULL), discs, sizeof discs);
    assert_memory_equal(tdsp_scene_journey(scene), &good_journey, sizeof good_journey);
    tdsp_scene_free(scene);
    assert_int_equal(tdsp_scene_create(&good_journey, NULL, 0, NULL, &scene), TDSP_OK);
    (void)tdsp_scene_discs(scene, &count);
    assert_int_equal(count, 0);
    tdsp_scene_free(scene);
}

/* FNV-1a, by its definition. */
static uint64_t fnv(const double *values, size_t count)
{
    uint64_t hash = UINT64_C(14695981039346656037);
    for (size_t i = 0; i < count; ++i) {
        double value = values[i] == 0.0 ? 0.0 : values[i];
        uint64_t bits;
        memcpy(&bits, &value, sizeof bits);
        for (int k = 0; k < 64; k += 8) hash = (hash ^ (bits >> k & 255)) * UINT64_C(1099511628211);
    }
    return hash;
}

static uint64_t hash_of(tdsp_journey journey, const tdsp_disc *discs, size_t count)
{
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create(&journey, discs, count, NULL, &scene), TDSP_OK);
    uint64_t hash = tdsp_scene_hash(scene);
    tdsp_scene_free(scene);
    return hash;
}

static void the_hash_is_fnv_of_all_doubles_in_order(void **state)
{
    (void)state;
    const double values[] = {2.0, 0.25, -3.0, 1.0, 5.0, -2.0, 1.0, 2.0, 0.5, 0.1, 7.0, 8.0, 0.0, 0.0};
    const tdsp_disc discs[2] = {good_disc, {{7.0, 8.0}, 0.0, 0.0}}, swapped[2] = {discs[1], discs[0]};
    const tdsp_disc minus[2] = {good_disc, {{7.0, 8.0}, -0.0, -0.0}};
    assert_true(hash_of(good_journey, discs, 2) == fnv(values, 14));
    assert_true(hash_of(good_journey, minus, 2) == fnv(values, 14));
    assert_true(hash_of(good_journey, discs, 1) == fnv(values, 10));
    assert_true(hash_of(good_journey, NULL, 0) == fnv(values, 6));
    assert_true(hash_of(good_journey, swapped, 2) != fnv(values, 14));
}

/* The first moment at which a place is inside a disc, by sampling and halving. */
static double sampled_cover(const tdsp_disc *discs, size_t count, tdsp_point place)
{
    double least = INFINITY;
    for (size_t i = 0; i < count; ++i) {
        double lo = 0.0, hi = 1e6, far = hypot(place.x - discs[i].center.x, place.y - discs[i].center.y) - good_journey.radius;
        if (far < discs[i].radius) return -1.0;
        if (far >= discs[i].radius + discs[i].growth * hi) continue;
        for (int k = 0; k < 100; ++k) {
            double middle = 0.5 * (lo + hi);
            *(far < discs[i].radius + discs[i].growth * middle ? &hi : &lo) = middle;
        }
        least = fmin(least, lo);
    }
    return least;
}

static void the_ends_are_covered_when_samples_say_so(void **state)
{
    (void)state;
    uint64_t chance = 2;
    for (int k = 0; k < 300; ++k) {
        tdsp_disc discs[4];
        uint32_t disc;
        tdsp_scene *scene;
        for (int i = 0; i < 4; ++i) {
            tdsp_disc made = {{chance_between(&chance, -9.0, 9.0), chance_between(&chance, -9.0, 9.0)}, chance_between(&chance, 0.0, 3.0),
                              chance_below(&chance, 3) ? chance_between(&chance, 0.01, 3.0) : 0.0};
            discs[i] = made;
        }
        assert_int_equal(tdsp_scene_create(&good_journey, discs, 4, NULL, &scene), TDSP_OK);
        double source = sampled_cover(discs, 4, good_journey.source), found = tdsp_scene_source_free_until(scene, &disc);
        if (source < 0.0) assert_true(found < 0.0);
        if (source >= 0.0) assert_near(found, source, 1e-9 * (1.0 + source));
        assert_int_equal(disc == TDSP_NO_DISC, isinf(source));
        if (disc != TDSP_NO_DISC && found >= 0.0) assert_near(sampled_cover(&discs[disc], 1, good_journey.source), found, 1e-9 * (1.0 + found));
        double destination = sampled_cover(discs, 4, good_journey.destination);
        if (destination >= 0.0) assert_near(tdsp_scene_destination_free_until(scene, NULL), destination, 1e-9 * (1.0 + destination));
        if (destination < 0.0) assert_true(tdsp_scene_destination_free_until(scene, NULL) < 0.0);
        tdsp_scene_free(scene);
    }
}

static void the_frame_is_centred_on_the_journey_and_as_long_as_it(void **state)
{
    (void)state;
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create(&good_journey, &good_disc, 1, NULL, &scene), TDSP_OK);
    assert_near(point_distance(scene->ends.source, scene->ends.destination), 1.0, 1e-15);
    assert_near(point_distance(scene_place(scene, scene->ends.source), good_journey.source), 0.0, 1e-14);
    assert_near(point_distance(scene_place(scene, scene->ends.destination), good_journey.destination), 0.0, 1e-14);
    assert_near(scene->time * good_journey.speed, scene->length, 1e-15);
    assert_near(scene->length, hypot(8.0, 3.0), 1e-14);
    const geom_disc *disc = &scene->all.forward[0];
    assert_near(point_distance(scene_place(scene, disc->center), good_disc.center), 0.0, 1e-14);
    assert_near(disc->radius * scene->length, 0.75, 1e-15);
    assert_near(disc->rate, 0.05, 1e-16);
    assert_near(scene->all.reverse[0].rate, -0.05, 1e-16);
    tdsp_scene_free(scene);
}

static void a_journey_of_no_length_takes_its_unit_from_the_discs(void **state)
{
    (void)state;
    tdsp_journey journey = {1.0, 0.0, {3.0, 3.0}, {3.0, 3.0}};
    tdsp_disc disc = {{3.0, 10.0}, 1.0, 0.0};
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create(&journey, &disc, 1, NULL, &scene), TDSP_OK);
    assert_near(scene->length, 7.0, 1e-15);
    tdsp_scene_free(scene);
    assert_int_equal(tdsp_scene_create(&journey, NULL, 0, NULL, &scene), TDSP_OK);
    assert_exact(scene->length, 1.0);
    tdsp_scene_free(scene);
}

static void the_largest_numbers_allowed_make_a_scene(void **state)
{
    (void)state;
    tdsp_journey journey = {1e100, 1e100, {-1e100, -1e100}, {1e100, 1e100}};
    tdsp_disc disc = {{1e100, -1e100}, 1e100, 1e100};
    tdsp_scene *scene;
    assert_int_equal(tdsp_scene_create(&journey, &disc, 1, NULL, &scene), TDSP_OK);
    assert_true(isfinite(scene->length) && isfinite(scene->all.forward[0].radius));
    tdsp_scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_number_of_a_journey_is_checked),
        cmocka_unit_test(each_number_of_a_disc_is_checked),
        cmocka_unit_test(missing_arguments_and_too_many_discs_are_refused),
        cmocka_unit_test(one_bad_disc_among_good_ones_is_enough),
        cmocka_unit_test(an_index_of_many_levels_without_memory_is_refused),
        cmocka_unit_test(a_scene_hands_out_what_it_was_given),
        cmocka_unit_test(the_hash_is_fnv_of_all_doubles_in_order),
        cmocka_unit_test(the_ends_are_covered_when_samples_say_so),
        cmocka_unit_test(the_frame_is_centred_on_the_journey_and_as_long_as_it),
        cmocka_unit_test(a_journey_of_no_length_takes_its_unit_from_the_discs),
        cmocka_unit_test(the_largest_numbers_allowed_make_a_scene),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
