/* SPDX-License-Identifier: MIT */
/* UTF-8, as RFC 3629 has it: no overlong forms, no surrogates, nothing above U+10FFFF. */
#ifndef BASE_TEXT_H
#define BASE_TEXT_H

#include <stddef.h>

/* The length of the character that begins at `at` (1 to 4), or 0 when the bytes from there to before `end` are no character. */
size_t text_utf8_length(const unsigned char *bytes, size_t at, size_t end);

/* Are the bytes from `first` to before `end` UTF-8 throughout? `bytes` may be NULL where there are none. */
int text_is_utf8(const unsigned char *bytes, size_t first, size_t end);

#endif
