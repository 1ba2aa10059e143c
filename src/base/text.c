/* SPDX-License-Identifier: MIT */
/* A character is well formed exactly when its first byte gives the length and its second lies in the range of the first. */
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

size_t text_utf8_length(const unsigned char *p, const unsigned char *end)
{
    if (p == end) return 0;
    if (p[0] < 0x80) return 1;
    if (!text_in_range(p[0], 0xc2, 0xf4)) return 0;
    size_t length = p[0] < 0xe0 ? 2 : p[0] < 0xf0 ? 3 : 4;
    if ((size_t)(end - p) < length || !text_second_fits(p[0], p[1])) return 0;
    for (size_t i = 2; i < length; i++) {
        if (!text_in_range(p[i], 0x80, 0xbf)) return 0;
    }
    return length;
}

int text_is_utf8(const unsigned char *p, size_t length)
{
    size_t step; /* p may be NULL where nothing is to be read */
    for (size_t at = 0; at < length; at += step) {
        step = text_utf8_length(p + at, p + length);
        if (step == 0) return 0;
    }
    return 1;
}
