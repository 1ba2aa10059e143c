/* SPDX-License-Identifier: MIT */
/* What a rider sees while it rides one chunk, against solving for every leg there is: none is overlooked that is not blocked, or too late. */
#include "support/cmocka_all.h"

#include <string.h>

#include "geom/angle.h"
#include "geom/tangent.h"
#include "support/chance.h"
#include "support/chunk.h"

/* Which branches to each disc are shown: bit 0 and 1 for the sides -1 and +1 with the root +1, 2 and 3 with the root -1. */
typedef unsigned char shown_to[CHUNK_MOST];

static int branch_bit(int to_side, int root)
{
    return 1 << ((to_side > 0) + (root > 0 ? 0 : 2));
}

static void visit(const chunk_world *w, look_wedge *wedge, uint32_t disc, double bearing, shown_to shown)
{
    const geom_disc *other = &w->discs[disc];
    wedge_sight sight;
    if (!disc_ridable(other)) return;
    double distance = point_distance(other->center, w->motion.disc->center);
    if (!wedge_look_at_disc(wedge, other, distance, bearing, &sight)) return;
    if (wedge_shows(wedge, &sight.same, sight.shortest)) shown[disc] |= (unsigned char)branch_bit(w->motion.side, 1);
    if (wedge_shows(wedge, &sight.other, sight.shortest)) shown[disc] |= (unsigned char)branch_bit(-w->motion.side, 1);
    if (!sight.is_apart) shown[disc] |= (unsigned char)(branch_bit(1, -1) | branch_bit(-1, -1));
    wedge_cover(wedge, other, &sight);
}

static void look_at_ring(chunk_world *w, look_wedge *wedge, const neighbour_ring *ring, shown_to shown)
{
    int seen[NEIGHBOUR_BLOCK];
    for (uint32_t first = 0; first < ring->count; first += NEIGHBOUR_BLOCK) {
        const neighbour_block *block = &w->around.blocks[ring->first + first / NEIGHBOUR_BLOCK];
        int count = wedge_look_at_block(wedge, block, seen);
        for (int i = 0; i < count; ++i) {
            assert_true(first + (uint32_t)seen[i] < ring->count);
            if (i) assert_true(block->gap[seen[i - 1]] <= block->gap[seen[i]]);
            visit(w, wedge, block->disc[seen[i]], block->bearing[seen[i]], shown);
        }
    }
}

typedef struct far_disc {
    uint32_t disc;
    double shortest; /* no leg to it is shorter */
} far_disc;

/* The discs beyond the rings that may be seen, nearest first. */
static int find_far(const chunk_world *w, const look_wedge *wedge, double rings, far_disc found[CHUNK_MOST])
{
    int count = 0;
    for (uint32_t k = 0; k < w->set.count; ++k) {
        const geom_disc *disc = &w->discs[k];
        double radius = fmax(disc_radius(disc, w->motion.start), disc_radius(disc, w->motion.end)), shortest;
        if (k == w->self || point_distance(disc->center, w->motion.disc->center) - w->set.forward[k].radius <= rings) continue;
        if (!wedge_look_at_place(wedge, disc->center, radius, disc->rate, &shortest)) continue;
        int at = count++;
        for (; at > 0 && found[at - 1].shortest > shortest; --at) found[at] = found[at - 1];
        found[at].disc = k;
        found[at].shortest = shortest;
    }
    return count;
}

static void look_far(const chunk_world *w, look_wedge *wedge, double rings, shown_to shown)
{
    far_disc found[CHUNK_MOST];
    int count = find_far(w, wedge, rings, found);
    for (int i = 0; i < count && sky_advance(&wedge->sky, found[i].shortest); ++i) {
        tdsp_point offset = point_sub(w->discs[found[i].disc].center, w->motion.disc->center);
        visit(w, wedge, found[i].disc, angle_near(offset.y, offset.x), shown);
    }
}

/* Look ring by ring, and then beyond them, as far as anything can be seen. */
static void look_around(chunk_world *w, look_wedge *wedge, shown_to shown)
{
    uint32_t place;
    tdsp_status status = w->self != INDEX_NONE ? neighbours_of_disc(&w->around, &w->memory, w->self, &place)
                                               : neighbours_of_point(&w->around, &w->memory, w->point.center, &place);
    assert_int_equal(status, TDSP_OK);
    double radius = -INFINITY;
    for (uint32_t ring = 0;; ++ring) {
        double shortest = wedge_shortest(wedge, radius);
        int added;
        if (shortest > wedge->longest || !sky_advance(&wedge->sky, shortest)) return;
        assert_int_equal(neighbours_widen(&w->around, &w->memory, place, NEIGHBOURS_MOST, &added), TDSP_OK);
        if (ring == w->around.rings[place].ring_count) {
            look_far(w, wedge, radius, shown);
            return;
        }
        look_at_ring(w, wedge, &w->around.rings[place].rings[ring], shown);
        radius = w->around.rings[place].rings[ring].radius;
    }
}

static void every_sight(chunk_world *w, shown_to shown, tdsp_point goal, double limit)
{
    memset(shown, 0, CHUNK_MOST);
    for (int sector = 0; sector < (chunk_sectors(w)); ++sector) {
        look_wedge wedge = chunk_wedge(w, sector);
        wedge_set_limit(&wedge, goal, limit);
        look_around(w, &wedge, shown);
    }
}

static int shown_legs, hidden_legs, points_seen;

static void check_all_seen(chunk_world *w, uint64_t *chance)
{
    static chunk_leg legs[4 * CHUNK_MOST];
    shown_to shown;
    (void)chance;
    every_sight(w, shown, point_make(0.0, 0.0), INFINITY);
    int count = chunk_legs(w, legs);
    for (int i = 0; i < count; ++i) {
        if (shown[legs[i].disc] & branch_bit(legs[i].to_side, legs[i].root)) {
            ++shown_legs;
            continue;
        }
        ++hidden_legs;
        assert_true(chunk_leg_blocked(w, &legs[i]));
    }
}

static void a_leg_that_is_not_shown_is_blocked(void **state)
{
    (void)state;
    shown_legs = hidden_legs = 0;
    chunk_each(6000, 1, check_all_seen);
    assert_true(shown_legs > 10000 && hidden_legs > 3000);
}

/* Each disc by itself: nothing is hidden then. */
static void check_alone(chunk_world *w, uint64_t *chance)
{
    static chunk_leg legs[4 * CHUNK_MOST];
    (void)chance;
    int count = chunk_legs(w, legs);
    for (int i = 0; i < count; ++i) {
        const geom_disc *disc = &w->discs[legs[i].disc];
        tdsp_point offset = point_sub(disc->center, w->motion.disc->center);
        double gap = point_length(offset) - w->set.forward[legs[i].disc].radius;
        int shows = 0;
        for (int sector = 0; sector < (chunk_sectors(w)); ++sector) {
            look_wedge wedge = chunk_wedge(w, sector);
            wedge_sight sight;
            assert_int_equal(wedge_look_at_disc(&wedge, disc, point_length(offset), atan2(offset.y, offset.x), &sight), 1);
            assert_true(sight.shortest <= legs[i].length * (1.0 + 1e-9) + 1e-12);
            assert_true(wedge_shortest(&wedge, gap) <= legs[i].length * (1.0 + 1e-9) + 1e-12);
            if (sight.is_apart) assert_int_equal(legs[i].root, 1);
            if (legs[i].root < 0) assert_true(legs[i].to_side == w->motion.side ? w->motion.disc->rate < disc->rate : w->motion.disc->rate + disc->rate < 0.0);
            shows |= legs[i].root < 0 || wedge_shows(&wedge, legs[i].to_side == w->motion.side ? &sight.same : &sight.other, sight.shortest);
        }
        assert_true(shows);
    }
}

static void a_disc_alone_shows_all_its_legs_and_no_shorter_one(void **state)
{
    (void)state;
    chunk_each(3000, 2, check_alone);
}

static int apart_legs;

/* Of discs that are apart no domain need be found. */
static void check_apart(chunk_world *w, uint64_t *chance)
{
    (void)chance;
    look_wedge wedge = chunk_wedge(w, 0);
    for (uint32_t k = 0; k < w->set.count; ++k) {
        wedge_sight sight;
        geom_pair pair = pair_make(w->motion.disc, &w->discs[k]);
        if (w->self == INDEX_NONE || k == w->self || !disc_ridable(&w->discs[k])) continue;
        if (!wedge_look_at_disc(&wedge, &w->discs[k], pair.distance, pair.bearing, &sight) || !sight.is_apart) continue;
        for (int to_side = -1; to_side <= 1; to_side += 2) {
            geom_tangent tangent = tangent_make(&pair, w->motion.side, to_side, 1);
            double any = -1.0, apart = -1.0;
            int found = tangent_leave(&tangent, w->motion.angle, w->motion.start, w->motion.end, &any);
            assert_int_equal(tangent_leave_apart(&tangent, w->motion.angle, w->motion.start, w->motion.end, &apart), found);
            if (found) assert_exact(apart, any);
            apart_legs += found;
        }
    }
}

static void legs_between_discs_that_are_apart_exist_all_the_time(void **state)
{
    (void)state;
    apart_legs = 0;
    chunk_each(3000, 9, check_apart);
    assert_true(apart_legs > 3000);
}

/* A point is a disc that nobody rides on: the leg to it is shown as one to its own side. */
static void check_point(chunk_world *w, uint64_t *chance)
{
    if (w->self == INDEX_NONE) return;
    for (int i = 0; i < 20; ++i) {
        geom_disc point = disc_point(point_make(chance_between(chance, -2.0, 2.0), chance_between(chance, -2.0, 2.0)));
        geom_pair pair = pair_make(w->motion.disc, &point);
        geom_tangent tangent = tangent_make(&pair, w->motion.side, w->motion.side, 1);
        look_wedge wedge = chunk_wedge(w, 0);
        wedge_sight sight;
        double leave;
        assert_int_equal(wedge_look_at_disc(&wedge, &point, pair.distance, pair.bearing, &sight), 1);
        if (!sight.is_apart || !tangent_possible(&tangent) || !tangent_leave(&tangent, w->motion.angle, w->motion.start, w->motion.end, &leave)) continue;
        assert_true(sight.shortest <= tangent_length(&tangent, leave) * (1.0 + 1e-9) + 1e-12);
        assert_true(wedge_shows(&wedge, &sight.same, sight.shortest));
        ++points_seen;
    }
}

static void a_point_shows_the_leg_to_it(void **state)
{
    (void)state;
    points_seen = 0;
    chunk_each(6000, 8, check_point);
    assert_true(points_seen > 2000);
}

static void check_places(chunk_world *w, uint64_t *chance)
{
    static chunk_leg legs[4 * CHUNK_MOST];
    (void)chance;
    int count = chunk_legs(w, legs);
    for (int i = 0; i < count; ++i) {
        const geom_disc *disc = &w->discs[legs[i].disc], *known = &w->set.forward[legs[i].disc];
        double now = fmax(disc_radius(disc, w->motion.start), disc_radius(disc, w->motion.end)), shortest;
        int seen = 0, seen_from_afar = 0;
        for (int sector = 0; sector < (chunk_sectors(w)); ++sector) {
            look_wedge wedge = chunk_wedge(w, sector);
            seen |= wedge_look_at_place(&wedge, disc->center, now, disc->rate, &shortest);
            assert_true(shortest <= legs[i].length * (1.0 + 1e-9) + 1e-12);
            double reach = known->radius + w->rate * fmax(w->late, 0.0) + 0.1;
            seen_from_afar |= wedge_look_at_place(&wedge, point_make(disc->center.x + 0.08, disc->center.y - 0.06), reach, w->rate, &shortest);
            assert_true(shortest <= legs[i].length * (1.0 + 1e-9) + 1e-12);
        }
        assert_true(seen && seen_from_afar);
    }
}

static void a_place_that_holds_a_disc_shows_where_its_legs_do(void **state)
{
    (void)state;
    chunk_each(3000, 3, check_places);
}

static void check_seen_within_limit(chunk_world *w, uint64_t *chance)
{
    static chunk_leg legs[4 * CHUNK_MOST];
    shown_to shown;
    tdsp_point goal = point_make(chance_between(chance, -2.0, 2.0), chance_between(chance, -2.0, 2.0));
    double limit = w->motion.start + point_distance(goal, w->motion.disc->center) * chance_between(chance, 0.9, 1.5);
    every_sight(w, shown, goal, limit);
    int count = chunk_legs(w, legs);
    for (int i = 0; i < count; ++i) {
        tdsp_point end = point_along(legs[i].line.from, legs[i].length, legs[i].line.heading);
        if (shown[legs[i].disc] & branch_bit(legs[i].to_side, legs[i].root)) continue;
        assert_true(legs[i].line.start + legs[i].length + point_distance(end, goal) > limit || chunk_leg_blocked(w, &legs[i]));
    }
}

static void a_leg_that_is_not_shown_within_a_limit_is_blocked_or_too_late(void **state)
{
    (void)state;
    chunk_each(6000, 6, check_seen_within_limit);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_leg_that_is_not_shown_is_blocked),
        cmocka_unit_test(a_disc_alone_shows_all_its_legs_and_no_shorter_one),
        cmocka_unit_test(legs_between_discs_that_are_apart_exist_all_the_time),
        cmocka_unit_test(a_point_shows_the_leg_to_it),
        cmocka_unit_test(a_place_that_holds_a_disc_shows_where_its_legs_do),
        cmocka_unit_test(a_leg_that_is_not_shown_within_a_limit_is_blocked_or_too_late),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
