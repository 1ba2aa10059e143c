/* SPDX-License-Identifier: MIT */
/* The numbers are chosen so that every sum and difference in the tests is exact, but for a few tenths that are not. */
#include "support/golden.h"

#include <math.h>

#include "base/bytes.h"
#include "base/hash.h"
#include "table/format.h"

#define LINE(t0, t1, x0, y0, x1, y1) \
    {.kind = TDSP_LEG_LINE, .disc = TDSP_NO_DISC, .start_time = t0, .end_time = t1, .from = {x0, y0}, .to = {x1, y1}}
#define ARC(which, side, t0, t1, x0, y0, x1, y1, cx, cy, r0, r1, angle, turned) \
    {.kind = TDSP_LEG_ARC, .disc = which, .turn = side, .start_time = t0, .end_time = t1, .from = {x0, y0}, .to = {x1, y1}, .center = {cx, cy}, .radius_from = r0, .radius_to = r1, .angle_from = angle, .sweep = turned}
#define CURVE(which, side, t0, t1, x0, y0, x1, y1, cx, cy, r0, r1, angle, turned, a0, a1, b0, b1, v) \
    {.kind = TDSP_LEG_CURVE, .disc = which, .turn = side, .start_time = t0, .end_time = t1, .from = {x0, y0}, .to = {x1, y1}, .center = {cx, cy}, .radius_from = r0, .radius_to = r1, .angle_from = angle, .sweep = turned, .rate_from = a0, .rate_to = a1, .bend_from = b0, .bend_to = b1, .speed = v}
#define LEGS(legs) legs, sizeof legs / sizeof legs[0]

static const tdsp_leg gap_0[] = {LINE(0, 20, -10, 0, 10, 0)};
static const tdsp_leg gap_1[] = {LINE(4, 12.5, -10, 0, -1, 2),
                                 ARC(3, -1, 12.5, 16.25, -1, 2, 1, 2.1, 0, 3, 1.4, 1.6, -2.35, 0.75),
                                 LINE(16.25, 24.5, 1, 2.1, 10, 0)};
static const tdsp_leg gap_2[] = {LINE(9.75, 15, -10, 0, -5, -1), ARC(4, 1, 15, 17, -5, -1, -4, -1.5, -4.5, 1, 2, 2.5, 4.5, 0.5),
                                 ARC(0, -1, 17, 21, -4, -1.5, 0, -2, -1, -4, 1, 1, 2, 0.25), LINE(21, 30.5, 0, -2, 10, 0)};
static const tdsp_leg gap_3[] = {LINE(12.5, 37.25, -10, 0, 10, 0)};

static const writer_row gap_rows[] = {{0, 20, 20, LEGS(gap_0), NULL, 0},
                                      {4, 20.5, 20.25, LEGS(gap_1), NULL, 0},
                                      {9.75, 20.75, 24.5, LEGS(gap_2), NULL, 0},
                                      {12.5, 24.75, INFINITY, LEGS(gap_3), NULL, 0}};

static const writer_row road_rows[] = {{0, 5, 5, NULL, 0, "\x00\x01\xff", 3},
                                       {2, 4, 7, NULL, 0, NULL, 0},
                                       {5, 4, 4, NULL, 0, "nine-byte", 9},
                                       {6, 3, 3.5, NULL, 0, "x", 1}};

static const tdsp_leg loose_0[] = {LINE(0, 1, 0, 0, 1, 0), LINE(1, 2, 1.0000000000000002, 0, 2, 0)};
static const tdsp_leg loose_2[] = {ARC(TDSP_NO_DISC, -1, 1, 1.5, 0, 0, 0.5, 0, 1, 0, 1, 1.5, 3, 0.0), LINE(1.5, 3, 0.5, 0, 2, 0)};

static const writer_row loose_rows[] = {
    {0, 2, 2, LEGS(loose_0), NULL, 0}, {0.1, 2, 2, NULL, 0, "why", 3}, {1, 2.1, INFINITY, LEGS(loose_2), NULL, 0}};

static const writer_row still_rows[] = {{0, 0, 0, NULL, 0, NULL, 0}};

static const tdsp_leg swell_0[] = {LINE(0, 2, -6, 0, -4, 1),
                                   CURVE(7, 1, 2, 3, -4, 1, -3, 2, 0.5, 1, 4.5, 4.75, 3.125, 0.375, 0.25, 0.375, 0.125, 0.0625, 2),
                                   CURVE(7, 1, 3, 5, -3, 2, -1, 2.5, 0.5, 1, 4.75, 5.5, 3.5, 0.75, 0.375, 0.5, 0.0625, 0, 2),
                                   ARC(2, -1, 5, 6, -1, 2.5, 0, 2, 0, 0, 2.25, 2.5, 1.75, 0.25), LINE(6, 12, 0, 2, 6, 0)};
static const tdsp_leg swell_1[] = {CURVE(4, -1, 1.5, 1.5, -6, 0, -6, 0, -5, 0, 1, 1, 3, 0.0, -0.25, 1.75, -8, 16, 2),
                                   LINE(1.5, 14.5, -6, 0, 6, 0)};

static const writer_row swell_rows[] = {{0, 12, 12, LEGS(swell_0), NULL, 0}, {1.5, 13, INFINITY, LEGS(swell_1), NULL, 0}};

#define CROWD(t, left) {t, left, left, NULL, 0, NULL, 0}
static const writer_row crowd_rows[] = {CROWD(0, 8),      CROWD(0.25, 8.5),  CROWD(0.5, 9),     CROWD(0.75, 9.5),
                                        CROWD(1, 10),     CROWD(1.25, 10.5), CROWD(1.5, 11),    CROWD(1.75, 11.5),
                                        CROWD(2, 12),     CROWD(2.25, 12.5), CROWD(2.5, 13),    CROWD(2.75, 13.5),
                                        CROWD(3, 14),     CROWD(3.25, 14.5), CROWD(3.5, 15),    {64, 16, INFINITY, NULL, 0, NULL, 0}};

/* Jumps at the first three rows. */
static const writer_row squeeze_rows[] = {
    {0, 4, 5, NULL, 0, NULL, 0}, {1, 5.5, 8, NULL, 0, NULL, 0}, {2.5, 8, 9.25, NULL, 0, NULL, 0}, {6, 10, INFINITY, NULL, 0, NULL, 0}};
static const gap_entry squeeze_gaps[] = {{0, {3, 7, 2.5, {0.25, -1}}}, {2, {7, 4000000000u, 6.125, {1, 0}}}};

const golden_table golden_tables[GOLDEN_COUNT] = {
    {"gap",
     {TDSP_MONOTONE_TRAVEL, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 0.25, 0, 1e-11, 20, 19.75, TDSP_CUT_OFF,
      {UINT64_C(0x0123456789abcdef), 1, {-10, 0}, {10, 0}, "m", "s"}},
     gap_rows,
     4,
     NULL,
     0},
    {"road",
     {TDSP_MONOTONE_ARRIVAL, TDSP_GUARANTEE_ARRIVAL, TDSP_SAMPLING_GEOMETRIC, 1, 0, 0, 0, 4.9, TDSP_HORIZON,
      {UINT64_MAX, 0, {0, 0}, {0, 0}, NULL, "\xce\xbcs"}},
     road_rows,
     4,
     NULL,
     0},
    {"loose",
     {TDSP_MONOTONE_TRAVEL, TDSP_GUARANTEE_ABSOLUTE, TDSP_SAMPLING_ADAPTIVE, 0, 0.5, 1e-9, 2, 2, TDSP_SOURCE_COVERED,
      {7, 1, {0, 0}, {2, 0}, "fifteen bytes!!", ""}},
     loose_rows,
     3,
     NULL,
     0},
    {"still",
     {TDSP_MONOTONE_TRAVEL, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 0.01, 0, 0, 0, 0, TDSP_OUTSIDE_TABLE,
      {0, 2.5, {1.5, -1.5}, {1.5, -1.5}, "km", "h"}},
     still_rows,
     1,
     NULL,
     0},
    {"crowd",
     {TDSP_MONOTONE_TRAVEL, TDSP_GUARANTEE_ABSOLUTE, TDSP_SAMPLING_ADAPTIVE, 0, 4, 0, 0, 8, TDSP_DESTINATION_COVERED,
      {12, 3, {0, 1}, {20, 1}, "m", "s"}},
     crowd_rows,
     16,
     NULL,
     0},
    {"swell",
     {TDSP_MONOTONE_TRAVEL, TDSP_GUARANTEE_TRAVEL, TDSP_SAMPLING_ADAPTIVE, 0.25, 0, 1e-11, 12, 11.75, TDSP_SOURCE_COVERED,
      {UINT64_C(0xfedcba9876543210), 2, {-6, 0}, {6, 0}, "m", "s"}},
     swell_rows,
     2,
     NULL,
     0},
    {"squeeze",
     {TDSP_MONOTONE_TRAVEL, TDSP_GUARANTEE_ABSOLUTE, TDSP_SAMPLING_ADAPTIVE, 0, 8, 1e-11, 4, 4, TDSP_CUT_OFF,
      {99, 2, {-4, 0}, {4, 0}, "m", "s"}},
     squeeze_rows,
     4,
     squeeze_gaps,
     2}};

static writer *golden_fill_rows(const writer_row *rows, size_t count, const tdsp_allocator *allocator)
{
    writer *w;
    if (writer_create(allocator, &w) != TDSP_OK) return NULL;
    for (size_t i = 0; i < count; i++) {
        if (writer_add(w, &rows[i]) != TDSP_OK) {
            writer_free(w);
            return NULL;
        }
    }
    return w;
}

static unsigned char *golden_finish(writer *w, const writer_header *header, size_t *length)
{
    void *bytes = NULL;
    if (w && writer_finish(w, header, &bytes, length) != TDSP_OK) bytes = NULL;
    writer_free(w);
    return bytes;
}

writer *golden_fill(const golden_table *golden, const tdsp_allocator *allocator)
{
    writer *w = golden_fill_rows(golden->rows, golden->row_count, allocator);
    for (size_t i = 0; w && i < golden->gap_count; i++) {
        if (writer_add_gap(w, golden->gaps[i].row, &golden->gaps[i].gap) == TDSP_OK) continue;
        writer_free(w);
        return NULL;
    }
    return w;
}

unsigned char *golden_write(const golden_table *golden, size_t *length)
{
    return golden_finish(golden_fill(golden, NULL), &golden->header, length);
}

unsigned char *golden_rows(const writer_header *header, const writer_row *rows, size_t count, size_t *length)
{
    return golden_finish(golden_fill_rows(rows, count, NULL), header, length);
}

/* Where the header's length is out of range the file is refused before its checksums are looked at. */
void golden_seal(unsigned char *bytes, size_t length)
{
    if (length < FORMAT_HEADER_LENGTH) return;
    size_t header = bytes_get_u32(bytes + FORMAT_AT_HEADER_LENGTH);
    if (header < FORMAT_HEADER_LENGTH || header > length) return;
    bytes_put_u32(bytes + FORMAT_AT_BODY_CRC, hash_crc32c(0, bytes, header, length));
    uint32_t crc = hash_crc32c(0, bytes, 0, FORMAT_AT_HEADER_CRC);
    crc = hash_crc32c(crc, bytes, FORMAT_AFTER_HEADER_CRC, header);
    bytes_put_u32(bytes + FORMAT_AT_HEADER_CRC, crc);
}
