/* SPDX-License-Identifier: MIT */
/*
 * The table format's numbers: docs/format.md in C. Reader and writer both take them from here.
 *
 * All offsets are in bytes from the start of the table; the sections follow the header in the order of the offsets
 * below, each starting at the next multiple of 8.
 */
#ifndef TABLE_FORMAT_H
#define TABLE_FORMAT_H

#include <stddef.h>

#define FORMAT_MAGIC "\x89TDSP\r\n\x1a" /* 8 bytes; shows a transfer as text, and is no text itself */
#define FORMAT_MAGIC_LENGTH 8
#define FORMAT_MAJOR 1
#define FORMAT_MINOR 2             /* a table is written in the lowest version that has what it holds */
#define FORMAT_HEADER_LENGTH 296   /* of version 1.0 */
#define FORMAT_HEADER_LENGTH_1 344 /* of version 1.1, which adds guides */
/* Of version 1.2, which adds curves and gaps; later minor versions may have more. */
#define FORMAT_HEADER_LENGTH_2 (FORMAT_AT_FURTHER + FORMAT_FURTHER_SIZE * (FORMAT_SECTIONS_2 - FORMAT_SECTIONS_1))

/* Places in the header. */
#define FORMAT_AT_MAJOR 8          /* u16 */
#define FORMAT_AT_MINOR 10         /* u16 */
#define FORMAT_AT_HEADER_LENGTH 12 /* u32 */
#define FORMAT_AT_LENGTH 16        /* u64 */
#define FORMAT_AT_BODY_CRC 24      /* u32, CRC-32C of everything after the header */
#define FORMAT_AT_HEADER_CRC 28    /* u32, CRC-32C of the header without these four bytes */
#define FORMAT_AFTER_HEADER_CRC 32
#define FORMAT_AT_MONOTONE 32    /* u32 */
#define FORMAT_AT_GUARANTEE 36   /* u32 */
#define FORMAT_AT_SAMPLING 40    /* u32 */
#define FORMAT_AT_LAST_REASON 44 /* u32 */
#define FORMAT_AT_SCENE_HASH 48  /* u64 */
#define FORMAT_AT_EPSILON 56     /* f64, as all down to the units */
#define FORMAT_AT_DELTA 64
#define FORMAT_AT_ERROR 72
#define FORMAT_AT_TIME_SCALE 80
#define FORMAT_AT_SPEED 88
#define FORMAT_AT_SOURCE 96       /* x, y */
#define FORMAT_AT_DESTINATION 112 /* x, y */
#define FORMAT_AT_FIRST_DEPARTURE 128
#define FORMAT_AT_FIRST_LOWER 136
#define FORMAT_AT_LAST_DEPARTURE 144
#define FORMAT_AT_LENGTH_UNIT 152 /* 16 bytes of text */
#define FORMAT_AT_TIME_UNIT 168   /* 16 bytes of text */
#define FORMAT_UNIT_SIZE 16
#define FORMAT_AT_ROWS 184 /* u64, as all down to the offsets */
#define FORMAT_AT_LEGS 192
#define FORMAT_AT_WAYPOINTS 200
#define FORMAT_AT_ARCS 208
#define FORMAT_AT_OPAQUE_LENGTH 216
#define FORMAT_AT_OFFSETS 224  /* u64 for each section, in the order below */
#define FORMAT_AT_JOINT 288    /* u32 */
#define FORMAT_AT_RESERVED 292 /* u32, 0 */

/* From version 1.1 on: for each guide its offset, its number of cells (u64) and its scale (f64). */
#define FORMAT_AT_GUIDES 296
#define FORMAT_GUIDE_SIZE 24
#define FORMAT_GUIDE_AT_CELLS 8
#define FORMAT_GUIDE_AT_SCALE 16

/* From version 1.2 on: for each further section its offset and how many items it has (u64). */
#define FORMAT_AT_FURTHER 344
#define FORMAT_FURTHER_SIZE 16
#define FORMAT_FURTHER_AT_COUNT 8

/* The sections, in order. */
enum {
    FORMAT_DEPARTURES,
    FORMAT_LEFT,
    FORMAT_RIGHT,
    FORMAT_FIRST_WAYPOINT,
    FORMAT_WAYPOINTS,
    FORMAT_ARCS,
    FORMAT_FIRST_BYTE,
    FORMAT_OPAQUE,
    FORMAT_SECTIONS, /* of version 1.0 */
    FORMAT_BY_DEPARTURE = FORMAT_SECTIONS,
    FORMAT_BY_ARRIVAL,
    FORMAT_SECTIONS_1, /* of version 1.1 */
    FORMAT_CURVES = FORMAT_SECTIONS_1,
    FORMAT_GAPS,
    FORMAT_SECTIONS_2 /* of version 1.2 */
};

/* A waypoint: a moment and a place on a path, and how the path goes on from there. */
#define FORMAT_WAYPOINT_SIZE 32
#define FORMAT_WAYPOINT_AT_TIME 0  /* f64 */
#define FORMAT_WAYPOINT_AT_X 8     /* f64 */
#define FORMAT_WAYPOINT_AT_Y 16    /* f64 */
#define FORMAT_WAYPOINT_AT_DISC 24 /* u32 */
#define FORMAT_WAYPOINT_AT_ARC 28  /* u32 */
#define FORMAT_NONE 0xffffffffu    /* no disc, no arc */

/* An arc: what a leg on a disc has besides its ends. */
#define FORMAT_ARC_SIZE 48
#define FORMAT_ARC_AT_CENTER 0       /* f64 x, y */
#define FORMAT_ARC_AT_RADIUS_FROM 16 /* f64 */
#define FORMAT_ARC_AT_RADIUS_TO 24   /* f64 */
#define FORMAT_ARC_AT_ANGLE_FROM 32  /* f64 */
#define FORMAT_ARC_AT_TURNED 40      /* f64, turn times sweep */

/* A curve: what an arc has, and how the rate changes. Curves are numbered behind the arcs. */
#define FORMAT_CURVE_SIZE 88
#define FORMAT_CURVE_AT_RATE_FROM 48 /* f64, as the rest */
#define FORMAT_CURVE_AT_RATE_TO 56
#define FORMAT_CURVE_AT_BEND_FROM 64
#define FORMAT_CURVE_AT_BEND_TO 72
#define FORMAT_CURVE_AT_SPEED 80

/* A gap: what closes where the travel time jumps after a row. */
#define FORMAT_GAP_SIZE 40
#define FORMAT_GAP_AT_ROW 0    /* u64 */
#define FORMAT_GAP_AT_FIRST 8  /* u32 */
#define FORMAT_GAP_AT_SECOND 12 /* u32 */
#define FORMAT_GAP_AT_TIME 16  /* f64 */
#define FORMAT_GAP_AT_PLACE 24 /* f64 x, y */

#define FORMAT_MAX_ROW_BYTES 0x7fffffffu

/* A guide: a u32 for each block of cells and one more, then a byte for each cell. */
#define FORMAT_GUIDE_BLOCK 64u
#define FORMAT_GUIDE_FULL 255u       /* the greatest byte: that many, or more */
#define FORMAT_GUIDE_MAX 0xffffffffu /* rows, and cells */

/* Where the header says at which offset a section starts. */
static inline size_t format_at_offset(size_t section)
{
    if (section < FORMAT_SECTIONS) return FORMAT_AT_OFFSETS + 8 * section;
    if (section < FORMAT_SECTIONS_1) return FORMAT_AT_GUIDES + FORMAT_GUIDE_SIZE * (section - FORMAT_SECTIONS);
    return FORMAT_AT_FURTHER + FORMAT_FURTHER_SIZE * (section - FORMAT_SECTIONS_1);
}

/* How many of the sections named here a minor version has. */
static inline size_t format_sections(unsigned minor)
{
    if (minor == 0) return FORMAT_SECTIONS;
    return minor == 1 ? FORMAT_SECTIONS_1 : FORMAT_SECTIONS_2;
}

/* The header's length in a minor version, the least in one that is not known here. */
static inline size_t format_header_length(unsigned minor)
{
    if (minor == 0) return FORMAT_HEADER_LENGTH;
    return minor == 1 ? FORMAT_HEADER_LENGTH_1 : FORMAT_HEADER_LENGTH_2;
}

#endif
