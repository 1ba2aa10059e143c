/* SPDX-License-Identifier: MIT */
/* UTF-8, as RFC 3629 has it: no overlong forms, no surrogates, nothing above U+10FFFF. */
#ifndef BASE_TEXT_H
#define BASE_TEXT_H

#include <stddef.h>

/* The length of the character at p (1 to 4), or 0 when the bytes before `end` are no character. */
size_t text_utf8_length(const unsigned char *p, const unsigned char *end);

/* Are these bytes UTF-8 throughout? */
int text_is_utf8(const unsigned char *p, size_t length);

#endif
