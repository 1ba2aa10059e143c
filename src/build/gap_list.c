/* SPDX-License-Identifier: MIT */
/* A list that is appended to. */
#include "build/gap_list.h"

#include "base/bytes.h"
#include "base/round.h"
#include "scene/allocator.h"
#include "table/format.h"

void gap_list_free(gap_list *list, const tdsp_allocator *allocator)
{
    memory_free(allocator, list->items, list->capacity * sizeof *list->items);
}

static int gap_is_good(const tdsp_gap *gap)
{
    return gap->first != FORMAT_NONE && round_is_finite(gap->time) && round_is_finite(gap->place.x) && round_is_finite(gap->place.y);
}

tdsp_status gap_list_add(gap_list *list, const tdsp_allocator *allocator, size_t row, const tdsp_gap *gap)
{
    void *items = list->items;
    if (list->count > 0 && row <= list->items[list->count - 1].row) return TDSP_INVALID_ARGUMENT;
    if (!gap_is_good(gap)) return TDSP_BAD_ORACLE;
    tdsp_status status = memory_reserve(allocator, &items, &list->capacity, list->count + 1, sizeof *list->items);
    list->items = items;
    if (status == TDSP_OK) list->items[list->count++] = (gap_entry){row, *gap};
    return status;
}

void gap_list_put(const gap_list *list, unsigned char *bytes)
{
    for (size_t i = 0; i < list->count; i++, bytes += FORMAT_GAP_SIZE) {
        const gap_entry *entry = &list->items[i];
        bytes_put_u64(bytes + FORMAT_GAP_AT_ROW, entry->row);
        bytes_put_u32(bytes + FORMAT_GAP_AT_FIRST, entry->gap.first);
        bytes_put_u32(bytes + FORMAT_GAP_AT_SECOND, entry->gap.second);
        bytes_put_f64(bytes + FORMAT_GAP_AT_TIME, entry->gap.time);
        bytes_put_f64(bytes + FORMAT_GAP_AT_PLACE, entry->gap.place.x);
        bytes_put_f64(bytes + FORMAT_GAP_AT_PLACE + 8, entry->gap.place.y);
    }
}
