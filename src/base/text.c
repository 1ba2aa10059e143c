/* SPDX-License-Identifier: MIT */
/*
 * A character is well formed exactly when its first byte gives the length and its second lies in the range of the first.
 *
 * Places are offsets, and a character is held against the last place that it may begin at: so each read is inside by the bounds of single numbers, as tests/proof needs.
 */
#include "base/text.h"

static int text_in_range(unsigned char byte, unsigned low, unsigned high)
{
    return byte >= low && byte <= high;
}

/* The range of the second byte leaves out overlong forms (e0, f0), surrogates (ed) and what is over U+10FFFF (f4). */
static int text_second_fits(unsigned char first, unsigned char second)
{
    if (first == 0xe0) return text_in_range(second, 0xa0, 0xbf);
    if (first == 0xed) return text_in_range(second, 0x80, 0x9f);
    if (first == 0xf0) return text_in_range(second, 0x90, 0xbf);
    if (first == 0xf4) return text_in_range(second, 0x80, 0x8f);
    return text_in_range(second, 0x80, 0xbf);
}

/* How long a character with this first byte is; 0 when none begins so. */
static size_t text_length_by_first(unsigned char first)
{
    if (first < 0x80) return 1;
    if (!text_in_range(first, 0xc2, 0xf4)) return 0;
    return first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

size_t text_utf8_length(const unsigned char *bytes, size_t at, size_t end)
{
    if (at >= end) return 0;
    size_t length = text_length_by_first(bytes[at]);
    if (length <= 1) return length;
    if (end < length || at > end - length || !text_second_fits(bytes[at], bytes[at + 1])) return 0;
    for (size_t i = 2; i < length; i++) {
        if (!text_in_range(bytes[at + i], 0x80, 0xbf)) return 0;
    }
    return length;
}

int text_is_utf8(const unsigned char *bytes, size_t first, size_t end)
{
    size_t step;
    for (size_t at = first; at < end; at += step) {
        step = text_utf8_length(bytes, at, end);
        if (step == 0) return 0;
    }
    return 1;
}
