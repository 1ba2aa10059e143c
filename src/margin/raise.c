/* SPDX-License-Identifier: MIT */
/* Scenes with raised rates. */
#include "margin/raise.h"

#include "base/math.h"
#include "scene/scene.h" /* its discs' pieces, and the making of scenes */
#include "tdsp/growth.h"

double raise_cap(const tdsp_scene *scene)
{
    return TDSP_MARGIN_CAP * tdsp_scene_journey(scene)->speed;
}

double raise_rate(tdsp_raise how, double amount, double rate, double cap)
{
    if (rate >= cap || (how == TDSP_RAISE_FACTOR && rate == 0.0)) return rate;
    return math_min(how == TDSP_RAISE_FACTOR ? amount * rate : math_max(rate + amount, 0.0), cap);
}

double raise_amount(tdsp_raise how, double most, double rate, double cap)
{
    if (rate >= cap) return most >= rate ? INFINITY : -INFINITY;
    if (most >= cap) return INFINITY;
    if (most < 0.0) return -INFINITY;
    if (how == TDSP_RAISE_ADDED) return most - rate;
    return rate > 0.0 ? most / rate : INFINITY;
}

static int raise_known(tdsp_raise how, double amount)
{
    if (how == TDSP_RAISE_FACTOR) return amount >= 0.0;
    return how == TDSP_RAISE_ADDED && !isnan(amount);
}

/* A scene whose discs have one rate each. */
static tdsp_status raise_rates(const tdsp_scene *scene, tdsp_raise how, double amount, tdsp_scene **out)
{
    size_t count;
    const tdsp_disc *given = tdsp_scene_discs(scene, &count);
    const tdsp_allocator *memory = &scene->allocator;
    tdsp_disc *discs = memory_array(memory, count, sizeof *discs);
    if (!discs && count > 0) return TDSP_NO_MEMORY;
    for (size_t i = 0; i < count; i++) {
        discs[i] = given[i];
        discs[i].growth = raise_rate(how, amount, given[i].growth, raise_cap(scene));
    }
    const tdsp_status status = tdsp_scene_create(tdsp_scene_journey(scene), discs, count, memory, out);
    memory_free(memory, discs, count * sizeof *discs);
    return status;
}

/* A piece that begins with a radius: lines have one rate each, which has the cap; what bends is raised as it is. */
static law_piece piece_raised(law_piece piece, tdsp_raise how, double amount, double cap, double radius)
{
    piece.c[0] = radius;
    if (piece.degree <= 1) {
        piece.c[1] = raise_rate(how, amount, piece.c[1], cap);
        piece.degree = 1;
    } else if (how == TDSP_RAISE_ADDED) {
        piece.c[1] += amount;
    } else {
        for (uint32_t k = 1; k <= piece.degree; k++) piece.c[k] *= amount;
    }
    while (piece.degree > 0 && piece.c[piece.degree] == 0.0) piece.degree--;
    return piece;
}

static void raise_law(tdsp_scene *raised, const tdsp_scene *scene, uint32_t disc, tdsp_raise how, double amount)
{
    const uint32_t first = scene->first_piece[disc], end = scene->first_piece[disc + 1];
    double radius = scene->pieces[first].c[0];
    raised->first_piece[disc + 1] = end;
    for (uint32_t k = first; k < end; k++) {
        raised->pieces[k] = piece_raised(scene->pieces[k], how, amount, raise_cap(scene), radius);
        if (k + 1 < end) radius = law_piece_jet(&raised->pieces[k], scene->pieces[k + 1].start).radius;
    }
    raised->discs[disc] = scene->discs[disc];
    raised->discs[disc].growth = raised->pieces[first].c[1];
}

/* A scene of pieces: the same pieces, each begun where the raised one before it ends. */
static tdsp_status raise_laws(const tdsp_scene *scene, tdsp_raise how, double amount, tdsp_scene **out)
{
    const tdsp_allocator *memory = &scene->allocator;
    const size_t starts = scene->count + 1, pieces = scene->first_piece[scene->count];
    tdsp_scene *raised;
    tdsp_status status = scene_begin(&scene->journey, scene->count, memory, &raised);
    if (status != TDSP_OK) return status;
    raised->first_piece = memory_array(memory, starts, sizeof *raised->first_piece);
    raised->pieces = raised->first_piece ? memory_array(memory, pieces, sizeof *raised->pieces) : NULL;
    if (!raised->pieces) {
        memory_free(memory, raised->first_piece, starts * sizeof *raised->first_piece);
        raised->first_piece = NULL;
        return scene_finish(raised, TDSP_NO_MEMORY, out);
    }
    raised->first_piece[0] = 0;
    for (uint32_t i = 0; i < scene->count; i++) raise_law(raised, scene, i, how, amount);
    raised->valid_until = scene->valid_until;
    raised->shrinks = scene->shrinks;
    return scene_finish(raised, TDSP_OK, out);
}

int raise_bends(const tdsp_scene *scene)
{
    if (tdsp_scene_has_rates_only(scene)) return 0;
    for (uint32_t k = 0; k < scene->first_piece[scene->count]; k++)
        if (scene->pieces[k].degree > 1) return 1;
    return 0;
}

void raise_range(const tdsp_scene *scene, double *slowest, double *fastest)
{
    const double cap = raise_cap(scene);
    const int is_law = !tdsp_scene_has_rates_only(scene);
    const size_t count = is_law ? scene->first_piece[scene->count] : scene->count;
    *slowest = INFINITY;
    *fastest = 0.0;
    for (size_t k = 0; k < count; k++) {
        const double rate = is_law ? scene->pieces[k].c[1] : scene->discs[k].growth;
        if (rate >= cap || !(rate >= 0.0)) continue;
        *slowest = math_min(*slowest, rate > 0.0 ? rate : *slowest);
        *fastest = math_max(*fastest, rate);
    }
}

tdsp_status tdsp_scene_raise(const tdsp_scene *scene, tdsp_raise how, double amount, tdsp_scene **out)
{
    if (!scene || !out || !raise_known(how, amount)) return TDSP_INVALID_ARGUMENT;
    if (tdsp_scene_has_rates_only(scene)) return raise_rates(scene, how, amount, out);
    if (raise_bends(scene) && (isinf(amount) || (how == TDSP_RAISE_ADDED && amount < 0.0))) return TDSP_NOT_SUPPORTED;
    return raise_laws(scene, how, amount, out);
}
