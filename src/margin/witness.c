/* Two touches at one moment. */
#include "margin/witness.h"

#include <math.h>

#include "margin/close.h"
#include "scene/scene.h" /* the allocator, nothing else */
#include "tdsp/growth.h"
#include "tdsp/path.h"

/* Touches count as simultaneous within this share of the time that the path takes. */
#define SAME_MOMENT 1e-6

/* A disc touched over [from, to], on the robot's left (+1) or right (-1). */
typedef struct contact {
    uint32_t disc;
    int side;
    double from, to;
} contact;

typedef struct contact_list {
    const tdsp_allocator *memory;
    contact *items;
    size_t count, capacity;
    tdsp_status status;
} contact_list;

static void contact_add(contact_list *list, contact item)
{
    if (list->status == TDSP_OK)
        list->status = memory_reserve(list->memory, (void **)&list->items, &list->capacity, list->count + 1, sizeof item);
    if (list->status == TDSP_OK) list->items[list->count++] = item;
}

static int side_of(const way *leg, tdsp_point center, double time)
{
    const tdsp_point heading = way_heading(leg, time), place = tdsp_leg_position(leg->leg, time);
    return heading.x * (center.y - place.y) - heading.y * (center.x - place.x) >= 0.0 ? 1 : -1;
}

static void contacts_of_leg(contact_list *list, const closeness *scales, const tdsp_leg *leg, const tdsp_disc *discs,
                            size_t count)
{
    const way w = way_of(leg);
    for (size_t i = 0; i < count; i++) {
        if (close_is_far(scales, &w, &discs[i], discs[i].growth)) continue;
        if (leg->kind == TDSP_LEG_ARC && leg->disc == i) {
            contact_add(list, (contact){(uint32_t)i, leg->turn, leg->start_time, leg->end_time});
            continue;
        }
        const close_call call = close_look(scales, &w, &discs[i]);
        if (call.kind == CLOSE_CLEAR) continue;
        const double time = call.touch.time;
        contact_add(list, (contact){(uint32_t)i, side_of(&w, discs[i].center, time), time, time});
    }
}

/* How long the two touches are apart. */
static double contact_apart(const contact *a, const contact *b)
{
    return fmax(fmax(a->from - b->to, b->from - a->to), 0.0);
}

static void witness_pair(const contact *a, const contact *b, const tdsp_leg *legs, size_t count, tdsp_witness *out)
{
    *out = (tdsp_witness){
        TDSP_LIMIT_GAP, a->disc < b->disc ? a->disc : b->disc, a->disc < b->disc ? b->disc : a->disc, 0.0, {0.0, 0.0}};
    out->time = 0.5 * (fmax(a->from, b->from) + fmin(a->to, b->to));
    if (contact_apart(a, b) == 0.0) out->time = fmax(a->from, b->from);
    tdsp_path_position(legs, count, out->time, &out->place);
}

static void witness_choose(const contact_list *list, const tdsp_leg *legs, size_t count, tdsp_witness *out)
{
    double least = SAME_MOMENT * (legs[count - 1].end_time - legs[0].start_time);
    for (size_t i = 0; i < list->count; i++) {
        for (size_t j = i + 1; j < list->count; j++) {
            const contact *a = &list->items[i], *b = &list->items[j];
            if (a->disc == b->disc || a->side == b->side || contact_apart(a, b) >= least) continue;
            least = contact_apart(a, b);
            witness_pair(a, b, legs, count, out);
        }
    }
}

tdsp_status witness_gap(const tdsp_scene *scene, const tdsp_leg *legs, size_t count, tdsp_witness *out)
{
    size_t disc_count;
    const tdsp_disc *discs = tdsp_scene_discs(scene, &disc_count);
    const closeness scales = close_scales(scene, legs, count);
    contact_list list = {&scene->allocator, NULL, 0, 0, TDSP_OK};
    *out = (tdsp_witness){TDSP_LIMIT_NONE, TDSP_NO_DISC, TDSP_NO_DISC, INFINITY, {0.0, 0.0}};
    if (!tdsp_scene_has_rates_only(scene)) return TDSP_OK;
    for (size_t i = 0; i < count; i++) contacts_of_leg(&list, &scales, &legs[i], discs, disc_count);
    if (list.status == TDSP_OK && count > 0) witness_choose(&list, legs, count, out);
    memory_free(list.memory, list.items, list.capacity * sizeof *list.items);
    return list.status;
}
