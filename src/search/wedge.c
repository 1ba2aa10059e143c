/* SPDX-License-Identifier: MIT */
/* The wedge that a chunk's tangent ray sweeps: its geometry is in wedge.h. */
#include "search/wedge.h"

#include "geom/angle.h"
#include "geom/tolerance.h"

/* Headings from short formulas are off by a bearing's error and an arc sine's, at most. */
#define NEAR (3.0 * GEOM_ANGLE_NEAR)

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

static void wedge_init(look_wedge *self, const geom_ride *motion, double late, double rate)
{
    self->motion = *motion;
    self->late = late;
    self->rate = larger(rate, 0.0);
    self->lean = asin_near(self->rate) + NEAR;
    self->radius[0] = disc_radius(motion->disc, motion->start);
    self->radius[1] = disc_radius(motion->disc, motion->end);
    self->widest = larger(self->radius[0], self->radius[1]);
    self->longest = INFINITY;
}

void wedge_of_chunk(look_wedge *self, const geom_ride *motion, double late, double rate)
{
    wedge_init(self, motion, late, rate);
    self->half_length = 0.5 * (motion->end - motion->start);
    double turn = motion->side * (ride_angle(motion, motion->end) - motion->angle);
    double heading = disc_heading(motion->disc, motion->side, motion->angle + motion->side * 0.5 * turn);
    self->heading = heading - GEOM_TURN * floor((heading + GEOM_PI) / GEOM_TURN);
    self->half_angle = 0.5 * turn + GEOM_ANGLE_START;
    self->middle = ride_position(motion, motion->start + self->half_length);
    sky_init(&self->sky, -self->half_angle, self->half_angle);
}

void wedge_of_sector(look_wedge *self, const geom_ride *motion, double heading, double half_angle, double late, double rate)
{
    wedge_init(self, motion, late, rate);
    self->half_length = 0.0;
    self->heading = heading;
    self->half_angle = half_angle;
    self->middle = motion->disc->center;
    sky_init(&self->sky, -half_angle, half_angle);
}

double wedge_direction(const look_wedge *self, double bearing)
{
    return angle_wrap(angle_wrap(self->motion.side * (bearing - self->heading)));
}

/*
 * A leg of length L that leaves at the angle x from the goal, at the distance G, is at the goal in time when L + sqrt(L^2 + G^2 - 2 L G cos x)
 * is at most B, the time left: when L <= (B^2 - G^2) / (2 (B - G cos x)). The rider is within half a chunk of its middle.
 */
void wedge_set_limit(look_wedge *self, tdsp_point goal, double limit)
{
    if (isinf(limit)) return;
    tdsp_point offset = point_sub(goal, self->middle);
    double distance = point_length(offset), left = limit - self->motion.start + self->half_length;
    double aside = fabs(wedge_direction(self, angle_near(offset.y, offset.x))) - self->half_angle - NEAR;
    left += GEOM_CONTACT * (distance + fabs(limit));
    double spare = left - distance * (aside > 0.0 ? math_cos(aside) : 1.0);
    self->longest = left < distance ? -1.0 : spare > 0.0 ? (left - distance) * (left + distance) / (2.0 * spare) : INFINITY;
}

double wedge_shortest(const look_wedge *self, double gap)
{
    return (gap - self->rate * larger(self->late, 0.0) - self->widest) / (1.0 + self->rate);
}

/*
 * By how much each disc misses the wedge; at most 0 where it may be in it, or overlap the disc ridden. The radii of both together are
 * at most `sizes`, and |asin(x)| <= pi / 2 |x|.
 */
static void block_misses(const neighbour_block *block, float heading, float half_angle, float own, float miss[NEIGHBOUR_BLOCK])
{
    const float turn = (float)GEOM_TURN, quarter = (float)(0.5 * GEOM_PI * (1.0 + 1e-5));
    for (int i = 0; i < NEIGHBOUR_BLOCK; ++i) {
        float off = block->bearing[i] - heading;
        off = off < 0.0f ? -off : off;
        off = off < turn - off ? off : turn - off;
        float sizes = own + 1.000001f * block->distance[i] - block->gap[i];
        float aside = (off - half_angle) * block->distance[i] - quarter * sizes, apart = block->distance[i] - sizes;
        miss[i] = aside < apart ? aside : apart;
    }
}

/* Does the skyline hide all there is of a disc in a block? */
static int block_hidden(const look_wedge *self, const neighbour_block *block, int i, double own)
{
    double distance = block->distance[i], sizes = own + 1.000001 * distance - block->gap[i];
    if (sizes >= distance) return 0;
    double direction = wedge_direction(self, block->bearing[i]), window = 0.5 * GEOM_PI * sizes / distance + self->lean;
    return sky_hides(&self->sky, direction - window, direction + window, (distance - sizes) / (1.0 + self->rate));
}

int wedge_look_at_block(const look_wedge *self, const neighbour_block *block, int seen[NEIGHBOUR_BLOCK])
{
    double own = (self->widest + self->rate * larger(self->late, 0.0)) * (1.0 + 1e-6);
    int count = 0, may_hide = self->sky.near_count + self->sky.full_count > 0;
    float miss[NEIGHBOUR_BLOCK];
    block_misses(block, (float)self->heading, (float)(self->half_angle + self->lean + 1e-5), (float)own, miss);
    for (int i = 0; i < NEIGHBOUR_BLOCK; ++i) {
        if (miss[i] > 0.0f || block->disc[i] == INDEX_NONE || (may_hide && block_hidden(self, block, i, own))) continue;
        int at = count++;
        for (; at > 0 && block->gap[seen[at - 1]] > block->gap[i]; --at) seen[at] = seen[at - 1];
        seen[at] = i;
    }
    return count;
}

/* |k| counts as over 1 by this, and by the rounding of coordinates, which matters beside a pebble. */
#define TOUCH 1e-9
#define ROUNDING 1e-14

/* The arc sines of k at both ends, as a range; empty where |k| > 1 at both: then there is no leg. */
static wedge_range arc_sines(const look_wedge *self, const geom_disc *disc, double cosine, const double radius[2], double distance)
{
    double first = (self->radius[0] * cosine - radius[0]) / distance, last = (self->radius[1] * cosine - radius[1]) / distance;
    double least = smaller(first, last), most = larger(first, last), over = larger(-1.0 - most, least - 1.0);
    wedge_range none = {INFINITY, -INFINITY}, range = {asin_near(least) - NEAR, asin_near(most) + NEAR};
    if (over <= TOUCH) return range;
    return (over - TOUCH) * distance > ROUNDING * (1.0 + fabs(disc->center.x) + fabs(disc->center.y)) ? none : range;
}

int wedge_look_at_disc(const look_wedge *self, const geom_disc *disc, double distance, double bearing, wedge_sight *sight)
{
    const geom_disc *own = self->motion.disc;
    const double radius[2] = {disc_radius(disc, self->motion.start), disc_radius(disc, self->motion.end)};
    double sizes = larger(self->radius[0] + radius[0], self->radius[1] + radius[1]);
    sight->shortest = (distance - sizes) / (1.0 + larger(disc->rate, 0.0));
    sight->is_apart = distance > sizes * (1.0 + GEOM_CONTACT);
    if (sight->shortest > self->longest) return 0;
    double direction = wedge_direction(self, bearing), lean = 0.5 * GEOM_PI - disc->theta;
    double both = own->rate * disc->rate, sines = own->sine * disc->sine;
    wedge_range same = arc_sines(self, disc, both + sines, radius, distance), other = arc_sines(self, disc, both - sines, radius, distance);
    sight->same.from = direction + same.from - lean;
    sight->same.to = direction + same.to - lean;
    sight->other.from = direction - other.to + lean;
    sight->other.to = direction - other.from + lean;
    return 1;
}

int wedge_look_at_place(const look_wedge *self, tdsp_point place, double reach, double rate, double *shortest)
{
    tdsp_point offset = point_sub(place, self->middle);
    double near = reach + self->half_length, distance = point_length(offset);
    *shortest = 0.0;
    if (distance <= near || rate >= 1.0) return 1;
    *shortest = (distance - near) / (1.0 + larger(rate, 0.0));
    if (*shortest > self->longest) return 0;
    double half = asin_near(near / distance) + asin_near(fabs(rate)) + NEAR, direction = wedge_direction(self, angle_near(offset.y, offset.x));
    wedge_range range = {direction - half, direction + half};
    return wedge_shows(self, &range, *shortest);
}

int wedge_shows(const look_wedge *self, const wedge_range *range, double shortest)
{
    if (range->from > range->to) return 0;
    double half = 0.5 * (range->to - range->from), middle = angle_wrap(angle_wrap(range->from + half));
    if (fabs(middle) > self->half_angle + half) return 0;
    return middle - half < -GEOM_PI || middle + half > GEOM_PI || !sky_hides(&self->sky, middle - half, middle + half, shortest);
}

static void cover_between(look_wedge *self, double from, double to, double reach)
{
    for (int turn = -1; turn <= 1; ++turn) {
        double first = larger(from + turn * GEOM_TURN, self->sky.from), last = smaller(to + turn * GEOM_TURN, self->sky.to);
        if (first < last) sky_add(&self->sky, first, last, reach);
    }
}

/* A disc that overlaps the ridden one: seen from anywhere near the middle of the chunk it stands in the way at least as it does now. */
static void cover_overlapping(look_wedge *self, const geom_disc *disc)
{
    tdsp_point offset = point_sub(disc->center, self->middle);
    double distance = point_length(offset), far = distance + self->half_length;
    double radius = smaller(disc_radius(disc, self->motion.start), disc_radius(disc, self->motion.end + far));
    if (distance <= radius + self->half_length) return;
    double half = asin_near(radius / far) - asin_near(self->half_length / distance) - NEAR;
    double direction = wedge_direction(self, angle_near(offset.y, offset.x));
    if (half > 0.0) cover_between(self, direction - half, direction + half, sqrt((far - radius) * (far + radius)));
}

/*
 * No ray reaches a disc later than a tangent does: the smaller root of the contact equation is at most the geometric mean of both, which is the
 * tangent's length sqrt(D^2 - R^2) / sin(theta).
 */
void wedge_cover(look_wedge *self, const geom_disc *disc, const wedge_sight *sight)
{
    if (!sight->is_apart) {
        cover_overlapping(self, disc);
        return;
    }
    double far = point_distance(disc->center, self->middle) + self->half_length;
    double radius = smaller(disc_radius(disc, self->motion.start), disc_radius(disc, self->motion.end));
    if (far > radius) cover_between(self, sight->same.to, sight->other.from, sqrt((far - radius) * (far + radius)) / disc->sine);
}
