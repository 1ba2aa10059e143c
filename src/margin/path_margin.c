/* SPDX-License-Identifier: MIT */
/*
 * How far all rates may rise before a fixed path meets a disc: the least, over legs and discs, of the amounts that raise a disc to the fastest
 * rate that the leg stays clear of (touch.h).
 */

#include "base/math.h"
#include "margin/close.h"
#include "margin/path_halving.h"
#include "margin/raise.h"
#include "tdsp/growth.h"
#include "tdsp/path.h"

typedef struct path_search {
    const tdsp_disc *discs;
    size_t count;
    tdsp_raise how;
    double cap;
    closeness scales;
    tdsp_margin *least;
} path_search;

static void path_note(path_search *search, const way *leg, uint32_t disc, touch met)
{
    tdsp_margin *least = search->least;
    const double amount = raise_amount(search->how, met.rate, search->discs[disc].growth, search->cap);
    if (amount == INFINITY || amount > least->most) return;
    if (amount == least->most && met.time >= least->witness.time) return;
    least->most = amount;
    least->witness = (tdsp_witness){TDSP_LIMIT_TOUCH, disc, TDSP_NO_DISC, met.time, tdsp_leg_position(leg->leg, met.time)};
}

/* The discs that are ridden allow the least as a rule: what they say keeps most others from being looked at. */
static void path_look_ridden(path_search *search, const tdsp_leg *leg)
{
    const way w = way_of(leg);
    if (leg->kind == TDSP_LEG_ARC && leg->disc < search->count)
        path_note(search, &w, leg->disc, close_look(&search->scales, &w, &search->discs[leg->disc]));
}

/* A disc that is far even at the least amount so far cannot lower it. */
static void path_look(path_search *search, const tdsp_leg *leg)
{
    const way w = way_of(leg);
    for (size_t i = 0; i < search->count; i++) {
        const tdsp_disc *disc = &search->discs[i];
        const double rate = raise_rate(search->how, math_max(search->least->most, 0.0), disc->growth, search->cap);
        if (close_is_far(&search->scales, &w, disc, math_max(rate, disc->growth))) continue;
        path_note(search, &w, (uint32_t)i, close_look(&search->scales, &w, disc));
    }
}

static tdsp_status path_check(const tdsp_leg *legs, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (legs[i].kind == TDSP_LEG_CURVE) continue; /* the verifier's business */
        if (!way_well_formed(&legs[i])) return TDSP_BAD_PATH;
        if (i > 0 && legs[i].start_time < legs[i - 1].start_time) return TDSP_BAD_PATH;
    }
    return TDSP_OK;
}

static tdsp_margin path_search_run(const tdsp_scene *scene, tdsp_raise how, const tdsp_leg *legs, size_t count)
{
    tdsp_margin margin = {INFINITY,
                          TDSP_OK,
                          legs[count - 1].end_time,
                          {TDSP_LIMIT_NONE, TDSP_NO_DISC, TDSP_NO_DISC, INFINITY, legs[count - 1].to},
                          0};
    path_search search = {NULL, 0, how, raise_cap(scene), close_scales(scene, legs, count), &margin};
    search.discs = tdsp_scene_discs(scene, &search.count);
    for (size_t i = 0; i < count; i++) path_look_ridden(&search, &legs[i]);
    for (size_t i = 0; i < count; i++) path_look(&search, &legs[i]);
    if (margin.most == -INFINITY) margin.status = TDSP_BAD_PATH;
    return margin;
}

tdsp_status tdsp_path_margin(const tdsp_scene *scene, tdsp_raise how, const tdsp_leg *legs, size_t count, double departure,
                             tdsp_margin *out)
{
    if (!scene || !out || (!legs && count > 0) || (how != TDSP_RAISE_FACTOR && how != TDSP_RAISE_ADDED))
        return TDSP_INVALID_ARGUMENT;
    if (!(departure >= 0.0) || isinf(departure)) return TDSP_INVALID_ARGUMENT;
    int curves = 0;
    for (size_t i = 0; i < count; i++) curves += legs[i].kind == TDSP_LEG_CURVE;
    const tdsp_status status = path_check(legs, count);
    if (status != TDSP_OK) return status;
    if (curves > 0 || !tdsp_scene_has_rates_only(scene)) return halving_margin(scene, how, legs, count, departure, out);
    const tdsp_point source = tdsp_scene_journey(scene)->source;
    const tdsp_leg rest = {.kind = TDSP_LEG_LINE,
                           .disc = TDSP_NO_DISC,
                           .start_time = departure,
                           .end_time = departure,
                           .from = source,
                           .to = source};
    *out = count > 0 ? path_search_run(scene, how, legs, count) : path_search_run(scene, how, &rest, 1);
    return TDSP_OK;
}
