/* SPDX-License-Identifier: MIT */
/* Tables, opened from bytes. */
#include <string.h>

#include "page.h"

/* The bytes are owned. */
typedef struct PageTable {
    tdsp_table view;
    void *bytes;
} PageTable;

PAGE_EXPORT(table_free) void page_table_free(PageTable *page)
{
    if (!page) return;
    page_release(page->bytes);
    page_release(page);
}

/* Takes over `bytes`, which come from allocate(), when it succeeds. */
PAGE_EXPORT(table_open) tdsp_status page_table_open(void *bytes, size_t length, PageTable **out)
{
    PageTable *page = page_allocate(sizeof *page);
    if (!page) return TDSP_NO_MEMORY;
    tdsp_status status = tdsp_table_open(&page->view, bytes, length);
    page->bytes = bytes;
    if (status == TDSP_OK) {
        *out = page;
    } else {
        page_release(page);
    }
    return status;
}

static tdsp_table_info info_of(const PageTable *page)
{
    tdsp_table_info info;
    memset(&info, 0, sizeof info);
    (void)tdsp_table_get_info(&page->view, &info); /* the table is open: nothing can fail */
    return info;
}

PAGE_EXPORT(table_info) void page_table_info(const PageTable *page, double out[22])
{
    tdsp_table_info info = info_of(page);
    const double parts[] = {info.version_major, info.version_minor,  info.monotone,      info.guarantee,      info.sampling, (double)info.rows,
                            (double)info.legs,  (double)info.length, info.epsilon,       info.delta,          info.error,    info.time_scale,
                            info.speed,         info.source.x,       info.source.y,      info.destination.x,  info.destination.y,
                            info.first_departure, info.last_departure, info.last_reason, (double)info.guide_length, (double)info.curves};
    memcpy(out, parts, sizeof parts);
}

PAGE_EXPORT(table_hash) uint64_t page_table_hash(const PageTable *page)
{
    return info_of(page).scene_hash;
}

/* The units of length and time, each ended by a zero byte. */
PAGE_EXPORT(table_units) void page_table_units(const PageTable *page, char length[16], char time[16])
{
    tdsp_table_info info = info_of(page);
    memcpy(length, info.length_unit, sizeof info.length_unit);
    memcpy(time, info.time_unit, sizeof info.time_unit);
}

/* All departures, then all travel times left, then all right. */
PAGE_EXPORT(table_rows) void page_table_rows(const PageTable *page, double *out, size_t rows)
{
    tdsp_row row = {0, 0, 0, 0};
    for (size_t i = 0; i < rows && tdsp_table_row(&page->view, i, &row) == TDSP_OK; i++) {
        out[i] = row.departure;
        out[rows + i] = row.left;
        out[2 * rows + i] = row.right;
    }
}

PAGE_EXPORT(table_arrival) tdsp_status page_table_arrival(const PageTable *page, double departure, double out[2])
{
    return tdsp_table_arrival(&page->view, departure, &out[0], &out[1]);
}

PAGE_EXPORT(table_departure) tdsp_status page_table_departure(const PageTable *page, double arrival, double out[2])
{
    return tdsp_table_departure(&page->view, arrival, &out[0], &out[1]);
}

/* The row that answers, the departure that it was computed for, and its travel time. */
PAGE_EXPORT(table_find) tdsp_status page_table_find(const PageTable *page, double departure, double out[3])
{
    uint64_t number;
    tdsp_row row;
    tdsp_status status = tdsp_table_find(&page->view, departure, &number);
    if (status == TDSP_OK) status = tdsp_table_row(&page->view, number, &row);
    if (status != TDSP_OK) return status;
    out[0] = (double)number;
    out[1] = row.departure;
    out[2] = row.left;
    return TDSP_OK;
}

PAGE_EXPORT(table_path) tdsp_status page_table_path(const PageTable *page, double departure, PageNumbers *out)
{
    size_t count;
    tdsp_status status = tdsp_table_path(&page->view, departure, NULL, 0, &count);
    if (status != TDSP_OK && status != TDSP_BUFFER_TOO_SMALL) return status;
    tdsp_leg *legs = page_allocate(count * sizeof *legs);
    if (!legs) return TDSP_NO_MEMORY;
    status = tdsp_table_path(&page->view, departure, legs, count, &count);
    if (status == TDSP_OK) status = page_legs_write(legs, count, out);
    page_release(legs);
    return status;
}

/* The first jump at `departure` or later: row, departure, before, after, gap. */
PAGE_EXPORT(table_next_jump) tdsp_status page_table_next_jump(const PageTable *page, double departure, double out[4 + PAGE_GAP_NUMBERS])
{
    tdsp_jump jump;
    tdsp_status status = tdsp_table_next_jump(&page->view, departure, &jump);
    if (status != TDSP_OK) return status;
    out[0] = (double)jump.row;
    out[1] = jump.departure;
    out[2] = jump.before;
    out[3] = jump.after;
    page_gap_write(&jump.gap, out + 4);
    return TDSP_OK;
}
