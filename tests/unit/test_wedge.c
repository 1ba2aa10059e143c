/*
 * What a rider sees while it rides one chunk, against solving for every leg there is: none is overlooked that is not blocked, covers block what
 * they say, and no limit cuts a leg that could be in time.
 */
#include "support/cmocka_all.h"

#include <string.h>

#include "geom/angle.h"
#include "geom/spiral.h"
#include "geom/tangent.h"
#include "geom/tolerance.h"
#include "search/wedge.h"
#include "support/chance.h"

enum { MOST = 90 };

/* A start looks about in so many sectors. */
#define SECTORS 6

/* Shorter legs than this only join a disc to one that it touches. */
#define NO_LENGTH 1e-9

/* A disc that is ridden, or a start, among others, in one direction of time. */
typedef struct world {
    tdsp_allocator memory;
    disc_set set;
    neighbourhood around;
    const geom_disc *discs; /* in the direction of time */
    geom_disc point;        /* the start */
    uint32_t self;          /* the disc ridden, or INDEX_NONE */
    geom_ride motion;
    double late;
    double rate; /* the largest, or a little more */
} world;

typedef struct leg {
    uint32_t disc;
    int to_side;
    int root;
    double heading;
    double length;
    geom_line line;
} leg;

static double random_rate(uint64_t *chance)
{
    static const double special[] = {0.0, 0.0, 1e-9, 0.5, 0.99, 1.0, 1.3};
    uint64_t pick = chance_below(chance, 14);
    return pick < 7 ? special[pick] : chance_between(chance, 0.0, 0.9);
}

static void fill(world *w, uint32_t count, uint64_t *chance)
{
    double size = chance_below(chance, 2) ? 0.05 : 0.4, same = chance_below(chance, 2) ? random_rate(chance) : -1.0;
    double scale = chance_between(chance, 0.1, 1.0);
    assert_int_equal(set_reserve(&w->set, &w->memory, count), TDSP_OK);
    w->set.count = count;
    for (uint32_t i = 0; i < count; ++i) {
        tdsp_point place = point_make(chance_between(chance, -2.0, 2.0), chance_between(chance, -2.0, 2.0));
        w->set.forward[i] = disc_make(place, chance_between(chance, 1e-3, size), scale * (same >= 0.0 ? same : random_rate(chance)));
        w->set.origin[i] = i;
    }
    assert_int_equal(set_prepare(&w->set, &w->memory), TDSP_OK);
    w->rate = w->set.index.nodes[0].rate;
}

/* A chunk as rides are followed: up to 0.6 rad, the radius at most doubled or halved. */
static void choose_chunk(world *w, double start, int forwards, uint64_t *chance)
{
    for (w->self = 0; w->self + 1 < w->set.count && !disc_ridable(&w->discs[w->self]);) ++w->self;
    const geom_disc *disc = &w->discs[w->self];
    double angle = chance_between(chance, 0.0, 0.6), growth = 0.69 * disc->sine;
    if (growth < angle * fabs(disc->rate)) angle = growth / fabs(disc->rate);
    w->motion.disc = disc;
    w->motion.side = chance_below(chance, 2) ? 1 : -1;
    w->motion.angle = chance_between(chance, -9.0, 9.0);
    w->motion.start = start;
    w->motion.end = start + (chance_below(chance, 16) ? spiral_duration(disc, start, angle) : 0.0);
    w->late = forwards ? w->motion.end : -w->motion.start;
}

static void choose_start(world *w, double start, int forwards, uint64_t *chance)
{
    w->self = INDEX_NONE;
    w->point = disc_point(point_make(chance_between(chance, -2.0, 2.0), chance_between(chance, -2.0, 2.0)));
    geom_ride motion = {&w->point, 1, 0.0, start, start};
    w->motion = motion;
    w->late = forwards ? start : -start;
}

/* Half of all worlds run backwards in time. */
static void world_make(world *w, int is_start, uint64_t *chance)
{
    memset(w, 0, sizeof *w);
    w->memory = memory_allocator(NULL);
    fill(w, 2 + (uint32_t)chance_below(chance, MOST - 1), chance);
    assert_int_equal(neighbours_begin(&w->around, &w->memory, &w->set), TDSP_OK);
    int forwards = (int)chance_below(chance, 2);
    double start = chance_between(chance, 0.0, 0.8);
    w->discs = forwards ? w->set.forward : w->set.reverse;
    if (is_start) choose_start(w, forwards ? start : -start, forwards, chance);
    if (!is_start) choose_chunk(w, forwards ? start : -start, forwards, chance);
}

static void world_free(world *w)
{
    neighbours_free(&w->around, &w->memory);
    set_free(&w->set, &w->memory);
}

/* One that can be ridden from, at a chunk's start. */
static int world_is_good(const world *w)
{
    return w->self == INDEX_NONE || (disc_ridable(w->motion.disc) && disc_radius(w->motion.disc, w->motion.start) > 1e-6 && w->motion.end < 1e3);
}

static look_wedge wedge_at(const world *w, int sector)
{
    look_wedge wedge;
    memset(&wedge, 0, sizeof wedge);
    if (w->self != INDEX_NONE) wedge_of_chunk(&wedge, &w->motion, w->late, w->rate);
    double half = GEOM_PI / SECTORS, heading = (2 * sector + 1) * half;
    if (w->self == INDEX_NONE) wedge_of_sector(&wedge, &w->motion, heading > GEOM_PI ? heading - GEOM_TURN : heading, half, w->late, w->rate);
    return wedge;
}

static int solve_leg(const world *w, uint32_t disc, int to_side, int root, leg *out)
{
    geom_pair pair = pair_make(w->motion.disc, &w->discs[disc]);
    geom_tangent tangent = tangent_make(&pair, w->motion.side, to_side, root);
    double leave = w->motion.start, normal = 0.0;
    if (disc == w->self || !disc_ridable(&w->discs[disc]) || !tangent_possible(&tangent)) return 0;
    if (w->self == INDEX_NONE) {
        double ends[4];
        if (!tangent_domain(&tangent, leave, leave, ends)) return 0;
        out->heading = tangent_heading(&tangent, leave);
    } else {
        if (!tangent_leave(&tangent, w->motion.angle, w->motion.start, w->motion.end, &leave)) return 0;
        normal = tangent_normal(&tangent, ride_angle(&w->motion, leave), leave);
        out->heading = disc_heading(w->motion.disc, w->motion.side, normal);
    }
    out->disc = disc;
    out->to_side = to_side;
    out->root = root;
    out->length = tangent_length(&tangent, leave);
    geom_line line = {disc_boundary(w->motion.disc, normal, leave), point_unit(out->heading), leave, out->length};
    out->line = line;
    return out->length > NO_LENGTH;
}

/* All legs that leave, blocked or not. */
static int solve_all(const world *w, leg legs[4 * MOST])
{
    int count = 0;
    for (uint32_t disc = 0; disc < w->set.count; ++disc)
        for (int branch = 0; branch < 4; ++branch) count += solve_leg(w, disc, branch & 1 ? 1 : -1, branch & 2 ? 1 : -1, &legs[count]);
    return count;
}

static int is_blocked(const world *w, const leg *self)
{
    for (uint32_t disc = 0; disc < w->set.count; ++disc)
        if (disc != w->self && disc != self->disc && line_blocked(&self->line, &w->discs[disc])) return 1;
    return 0;
}

/* Which branches to each disc are shown: bit 0 and 1 for the sides -1 and +1 with the root +1, 2 and 3 with the root -1. */
typedef unsigned char shown_to[MOST];

static int branch_bit(int to_side, int root)
{
    return 1 << ((to_side > 0) + (root > 0 ? 0 : 2));
}

static void visit(const world *w, look_wedge *wedge, uint32_t disc, double bearing, shown_to shown)
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

static void look_at_ring(world *w, look_wedge *wedge, const neighbour_ring *ring, shown_to shown)
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
static int find_far(const world *w, const look_wedge *wedge, double rings, far_disc found[MOST])
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

static void look_far(const world *w, look_wedge *wedge, double rings, shown_to shown)
{
    far_disc found[MOST];
    int count = find_far(w, wedge, rings, found);
    for (int i = 0; i < count && sky_advance(&wedge->sky, found[i].shortest); ++i) {
        tdsp_point offset = point_sub(w->discs[found[i].disc].center, w->motion.disc->center);
        visit(w, wedge, found[i].disc, angle_near(offset.y, offset.x), shown);
    }
}

/* Look ring by ring, and then beyond them, as far as anything can be seen. */
static void look_around(world *w, look_wedge *wedge, shown_to shown)
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
        assert_int_equal(neighbours_widen(&w->around, &w->memory, place, &added), TDSP_OK);
        if (ring == w->around.rings[place].ring_count) {
            look_far(w, wedge, radius, shown);
            return;
        }
        look_at_ring(w, wedge, &w->around.rings[place].rings[ring], shown);
        radius = w->around.rings[place].rings[ring].radius;
    }
}

static void every_sight(world *w, shown_to shown, tdsp_point goal, double limit)
{
    memset(shown, 0, MOST);
    for (int sector = 0; sector < (w->self == INDEX_NONE ? SECTORS : 1); ++sector) {
        look_wedge wedge = wedge_at(w, sector);
        wedge_set_limit(&wedge, goal, limit);
        look_around(w, &wedge, shown);
    }
}

typedef void (*check_world)(world *w, uint64_t *chance);

static void each_world(int count, uint64_t seed, check_world check)
{
    uint64_t chance = seed;
    int good = 0;
    for (int k = 0; k < count; ++k) {
        static world w;
        world_make(&w, k % 4 == 0, &chance);
        if (world_is_good(&w)) {
            check(&w, &chance);
            ++good;
        }
        world_free(&w);
    }
    assert_true(good > count / 2);
}

static int shown_legs, hidden_legs, points_seen;

static void check_all_seen(world *w, uint64_t *chance)
{
    static leg legs[4 * MOST];
    shown_to shown;
    (void)chance;
    every_sight(w, shown, point_make(0.0, 0.0), INFINITY);
    int count = solve_all(w, legs);
    for (int i = 0; i < count; ++i) {
        if (shown[legs[i].disc] & branch_bit(legs[i].to_side, legs[i].root)) {
            ++shown_legs;
            continue;
        }
        ++hidden_legs;
        assert_true(is_blocked(w, &legs[i]));
    }
}

static void a_leg_that_is_not_shown_is_blocked(void **state)
{
    (void)state;
    shown_legs = hidden_legs = 0;
    each_world(6000, 1, check_all_seen);
    assert_true(shown_legs > 10000 && hidden_legs > 3000);
}

/* Each disc by itself: nothing is hidden then. */
static void check_alone(world *w, uint64_t *chance)
{
    static leg legs[4 * MOST];
    (void)chance;
    int count = solve_all(w, legs);
    for (int i = 0; i < count; ++i) {
        const geom_disc *disc = &w->discs[legs[i].disc];
        tdsp_point offset = point_sub(disc->center, w->motion.disc->center);
        double gap = point_length(offset) - w->set.forward[legs[i].disc].radius;
        int shows = 0;
        for (int sector = 0; sector < (w->self == INDEX_NONE ? SECTORS : 1); ++sector) {
            look_wedge wedge = wedge_at(w, sector);
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
    each_world(3000, 2, check_alone);
}

/* A point is a disc that nobody rides on: the leg to it is shown as one to its own side. */
static void check_point(world *w, uint64_t *chance)
{
    if (w->self == INDEX_NONE) return;
    for (int i = 0; i < 20; ++i) {
        geom_disc point = disc_point(point_make(chance_between(chance, -2.0, 2.0), chance_between(chance, -2.0, 2.0)));
        geom_pair pair = pair_make(w->motion.disc, &point);
        geom_tangent tangent = tangent_make(&pair, w->motion.side, w->motion.side, 1);
        look_wedge wedge = wedge_at(w, 0);
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
    each_world(6000, 8, check_point);
    assert_true(points_seen > 2000);
}

static void check_places(world *w, uint64_t *chance)
{
    static leg legs[4 * MOST];
    (void)chance;
    int count = solve_all(w, legs);
    for (int i = 0; i < count; ++i) {
        const geom_disc *disc = &w->discs[legs[i].disc], *known = &w->set.forward[legs[i].disc];
        double now = fmax(disc_radius(disc, w->motion.start), disc_radius(disc, w->motion.end)), shortest;
        int seen = 0, seen_from_afar = 0;
        for (int sector = 0; sector < (w->self == INDEX_NONE ? SECTORS : 1); ++sector) {
            look_wedge wedge = wedge_at(w, sector);
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
    each_world(3000, 3, check_places);
}

/* The ray of the wedge's direction x. */
static geom_line ray_of(const world *w, const look_wedge *wedge, double x, double length)
{
    const geom_disc *disc = w->motion.disc;
    double heading = wedge->heading + w->motion.side * x;
    if (w->self == INDEX_NONE) {
        geom_line from_start = {w->point.center, point_unit(heading), w->motion.start, length};
        return from_start;
    }
    double turn = w->motion.side * (ride_angle(&w->motion, w->motion.end) - w->motion.angle);
    double ridden = fmin(fmax(x + 0.5 * turn, 0.0), turn);
    double leave = fmin(w->motion.start + spiral_duration(disc, w->motion.start, ridden), w->motion.end);
    geom_line ray = {ride_position(&w->motion, leave), point_unit(disc_heading(disc, w->motion.side, w->motion.angle + w->motion.side * ridden)), leave, length};
    return ray;
}

static int covers_tried;

static void check_covers(world *w, uint64_t *chance)
{
    for (uint32_t k = 0; k < w->set.count; ++k) {
        const geom_disc *disc = &w->discs[k];
        if (k == w->self || !disc_ridable(disc)) continue;
        tdsp_point offset = point_sub(disc->center, w->motion.disc->center);
        for (int sector = 0; sector < (w->self == INDEX_NONE ? SECTORS : 1); ++sector) {
            look_wedge wedge = wedge_at(w, sector);
            wedge_sight sight;
            if (!wedge_look_at_disc(&wedge, disc, point_length(offset), atan2(offset.y, offset.x), &sight)) continue;
            wedge_cover(&wedge, disc, &sight);
            for (int i = 0; i < wedge.sky.near_count; ++i) {
                const sky_cover *cover = &wedge.sky.near[i];
                for (int sample = 0; sample <= 6; ++sample) {
                    double share = sample < 2 ? sample : chance_unit(chance);
                    geom_line ray = ray_of(w, &wedge, cover->from + share * (cover->to - cover->from), cover->reach * (1.0 + 1e-9));
                    assert_true(line_blocked(&ray, disc));
                }
                ++covers_tried;
            }
        }
    }
}

static void every_ray_inside_a_cover_runs_into_its_disc_within_the_reach(void **state)
{
    (void)state;
    covers_tried = 0;
    each_world(2000, 4, check_covers);
    assert_true(covers_tried > 3000);
}

static int in_time, too_late;

static void check_limit(world *w, uint64_t *chance)
{
    tdsp_point goal = point_make(chance_between(chance, -2.0, 2.0), chance_between(chance, -2.0, 2.0));
    double away = point_distance(goal, w->motion.disc->center);
    double limit = w->motion.start + away * chance_between(chance, 0.8, 1.6);
    int sectors = w->self == INDEX_NONE ? SECTORS : 1;
    for (int k = 0; k < 200; ++k) {
        look_wedge wedge = wedge_at(w, (int)chance_below(chance, (uint64_t)sectors));
        wedge_set_limit(&wedge, goal, limit);
        double length = chance_between(chance, 0.0, 2.0) * away, x = chance_between(chance, -1.0, 1.0) * wedge.half_angle;
        geom_line ray = ray_of(w, &wedge, x, length);
        tdsp_point end = point_along(ray.from, length, ray.heading);
        int is_in_time = ray.start + length + point_distance(end, goal) <= limit;
        if (is_in_time) assert_true(length <= wedge.longest);
        in_time += is_in_time;
        too_late += length > wedge.longest;
    }
}

static void no_limit_cuts_a_leg_that_is_in_time(void **state)
{
    (void)state;
    in_time = too_late = 0;
    each_world(4000, 5, check_limit);
    assert_true(in_time > 10000 && too_late > 100000);
}

static void check_seen_within_limit(world *w, uint64_t *chance)
{
    static leg legs[4 * MOST];
    shown_to shown;
    tdsp_point goal = point_make(chance_between(chance, -2.0, 2.0), chance_between(chance, -2.0, 2.0));
    double limit = w->motion.start + point_distance(goal, w->motion.disc->center) * chance_between(chance, 0.9, 1.5);
    every_sight(w, shown, goal, limit);
    int count = solve_all(w, legs);
    for (int i = 0; i < count; ++i) {
        tdsp_point end = point_along(legs[i].line.from, legs[i].length, legs[i].line.heading);
        if (shown[legs[i].disc] & branch_bit(legs[i].to_side, legs[i].root)) continue;
        assert_true(legs[i].line.start + legs[i].length + point_distance(end, goal) > limit || is_blocked(w, &legs[i]));
    }
}

static void a_leg_that_is_not_shown_within_a_limit_is_blocked_or_too_late(void **state)
{
    (void)state;
    each_world(6000, 6, check_seen_within_limit);
}

/* A limit that nothing is beyond, one that is past already, and a goal where the rider is. */
static void limits_at_their_ends_are_none_or_shut_everything_out(void **state)
{
    (void)state;
    uint64_t chance = 7;
    static world w;
    world_make(&w, 1, &chance);
    look_wedge wedge = wedge_at(&w, 0);
    wedge_set_limit(&wedge, point_make(1.0, 1.0), INFINITY);
    assert_true(isinf(wedge.longest));
    double away = point_distance(w.point.center, point_make(1.0, 1.0));
    wedge_set_limit(&wedge, point_make(1.0, 1.0), w.motion.start + 0.999 * away);
    assert_true(wedge.longest < 0.0);
    wedge = wedge_at(&w, 0);
    wedge_set_limit(&wedge, w.point.center, w.motion.start + 1.0);
    assert_near(wedge.longest, 0.5, 1e-9);
    world_free(&w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_leg_that_is_not_shown_is_blocked),
        cmocka_unit_test(a_disc_alone_shows_all_its_legs_and_no_shorter_one),
        cmocka_unit_test(a_point_shows_the_leg_to_it),
        cmocka_unit_test(a_place_that_holds_a_disc_shows_where_its_legs_do),
        cmocka_unit_test(every_ray_inside_a_cover_runs_into_its_disc_within_the_reach),
        cmocka_unit_test(no_limit_cuts_a_leg_that_is_in_time),
        cmocka_unit_test(a_leg_that_is_not_shown_within_a_limit_is_blocked_or_too_late),
        cmocka_unit_test(limits_at_their_ends_are_none_or_shut_everything_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
