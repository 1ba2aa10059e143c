/* SPDX-License-Identifier: MIT */
/* What near discs hide from a rider: the rule is in skyline.h. */
#include "geom/skyline.h"

#include <math.h>

/* How much narrower a cover counts than it is, as an angle. */
#define MARGIN 1e-9

void sky_init(skyline *sky, double from, double to)
{
    sky->from = from;
    sky->to = to;
    sky->next = INFINITY;
    sky->near_count = sky->full_count = 0;
}

void sky_add(skyline *sky, double from, double to, double reach)
{
    /* The chunk's own ends are no edges of a disc: nothing is touched there. */
    if (from > sky->from) from += MARGIN;
    if (to < sky->to) to -= MARGIN;
    if (from >= to || sky->near_count == SKY_COVERS) return;
    sky_cover *cover = &sky->near[sky->near_count++];
    cover->from = from;
    cover->to = to;
    cover->reach = reach;
    if (reach < sky->next) sky->next = reach;
}

/* Merge a cover with all it touches. */
static void sky_fill(skyline *sky, sky_cover cover)
{
    int kept = 0, place = 0;
    for (int i = 0; i < sky->full_count; ++i) {
        sky_cover *other = &sky->full[i];
        if (other->to >= cover.from && other->from <= cover.to) {
            if (other->from < cover.from) cover.from = other->from;
            if (other->to > cover.to) cover.to = other->to;
            if (other->reach > cover.reach) cover.reach = other->reach;
            continue;
        }
        if (other->to < cover.from) place = kept + 1;
        sky->full[kept++] = *other;
    }
    if (kept == SKY_COVERS) return;
    for (int i = kept; i > place; --i) sky->full[i] = sky->full[i - 1];
    sky->full[place] = cover;
    sky->full_count = kept + 1;
}

static int sky_filled(const skyline *sky, double from, double to, double length)
{
    for (int i = 0; i < sky->full_count; ++i)
        if (sky->full[i].from <= from && to <= sky->full[i].to && sky->full[i].reach <= length) return 1;
    return 0;
}

/* Covers whose reach is passed hide everything from now on. */
static void sky_pass(skyline *sky, double bound)
{
    int kept = 0;
    sky->next = INFINITY;
    for (int i = 0; i < sky->near_count; ++i) {
        if (sky->near[i].reach <= bound) {
            sky_fill(sky, sky->near[i]);
            continue;
        }
        if (sky->near[i].reach < sky->next) sky->next = sky->near[i].reach;
        sky->near[kept++] = sky->near[i];
    }
    sky->near_count = kept;
}

int sky_advance(skyline *sky, double bound)
{
    if (bound >= sky->next) sky_pass(sky, bound);
    return !sky_filled(sky, sky->from, sky->to, bound);
}

int sky_hides(const skyline *sky, double from, double to, double length)
{
    if (from < sky->from) from = sky->from;
    if (to > sky->to) to = sky->to;
    if (sky_filled(sky, from, to, length)) return 1;
    for (int i = 0; i < sky->near_count; ++i)
        if (sky->near[i].from <= from && to <= sky->near[i].to && sky->near[i].reach < length) return 1;
    return 0;
}
