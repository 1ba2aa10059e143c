/* SPDX-License-Identifier: MIT */
/*
 * Little-endian numbers at any alignment, on any host.
 *
 * Bytes are copied, or put together by shifts, never read through a cast of the pointer: no alignment and no aliasing is
 * assumed, and a byte order only where the compiler states it. Compilers turn each of these into one load or store where the host allows it; for
 * size, some do so with a copy alone. A double travels as the 64 bits of its IEEE 754 binary64 form.
 */
#ifndef BASE_BYTES_H
#define BASE_BYTES_H

#include <stdint.h>
#include <string.h>

/* Where a copy is a load. What shifts do is clearer to a proof. */
#if defined(__BYTE_ORDER__) && defined(__ORDER_LITTLE_ENDIAN__) && !defined(__FRAMAC__) && \
    (!defined(__arm__) || defined(__ARM_FEATURE_UNALIGNED))
#define BYTES_COPIED (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
#else
#define BYTES_COPIED 0
#endif

static inline uint16_t bytes_get_u16(const unsigned char *p)
{
    return (uint16_t)(p[0] | (uint16_t)(p[1] << 8));
}

static inline uint32_t bytes_get_u32(const unsigned char *p)
{
#if BYTES_COPIED
    uint32_t value;
    memcpy(&value, p, sizeof value);
    return value;
#else
    return (uint32_t)p[0] | (uint32_t)p[1] << 8 | (uint32_t)p[2] << 16 | (uint32_t)p[3] << 24;
#endif
}

static inline uint64_t bytes_get_u64(const unsigned char *p)
{
    return (uint64_t)bytes_get_u32(p) | (uint64_t)bytes_get_u32(p + 4) << 32;
}

static inline double bytes_get_f64(const unsigned char *p)
{
    uint64_t bits = bytes_get_u64(p);
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline void bytes_put_u16(unsigned char *p, uint16_t value)
{
    p[0] = (unsigned char)(value & 0xff);
    p[1] = (unsigned char)(value >> 8);
}

static inline void bytes_put_u32(unsigned char *p, uint32_t value)
{
    bytes_put_u16(p, (uint16_t)(value & 0xffff));
    bytes_put_u16(p + 2, (uint16_t)(value >> 16));
}

static inline void bytes_put_u64(unsigned char *p, uint64_t value)
{
    bytes_put_u32(p, (uint32_t)(value & 0xffffffff));
    bytes_put_u32(p + 4, (uint32_t)(value >> 32));
}

static inline void bytes_put_f64(unsigned char *p, double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    bytes_put_u64(p, bits);
}

#endif
