/* Scenes with raised rates. */
#include "margin/raise.h"

#include <math.h>

#include "scene/scene.h" /* the allocator, nothing else */
#include "tdsp/growth.h"

double raise_cap(const tdsp_scene *scene)
{
    return TDSP_MARGIN_CAP * tdsp_scene_journey(scene)->speed;
}

double raise_rate(tdsp_raise how, double amount, double rate, double cap)
{
    if (rate >= cap || (how == TDSP_RAISE_FACTOR && rate == 0.0)) return rate;
    return fmin(how == TDSP_RAISE_FACTOR ? amount * rate : fmax(rate + amount, 0.0), cap);
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

tdsp_status tdsp_scene_raise(const tdsp_scene *scene, tdsp_raise how, double amount, tdsp_scene **out)
{
    if (!scene || !out || !raise_known(how, amount)) return TDSP_INVALID_ARGUMENT;
    if (!tdsp_scene_has_rates_only(scene)) return TDSP_NOT_SUPPORTED;
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
