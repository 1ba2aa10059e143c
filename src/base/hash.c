/* SPDX-License-Identifier: MIT */
/* FNV-1a and CRC-32C. The check values of both are pinned in the tests. */
#include "base/hash.h"

#include "base/bytes.h"

uint64_t hash_fnv1a(uint64_t seed, const void *bytes, size_t length)
{
    const unsigned char *p = bytes;
    uint64_t hash = seed;
    for (size_t i = 0; i < length; i++)
        hash = (hash ^ p[i]) * UINT64_C(0x100000001b3);
    return hash;
}

uint64_t hash_double(uint64_t seed, double value)
{
    unsigned char bytes[8];
    bytes_put_f64(bytes, value == 0 ? 0.0 : value);
    return hash_fnv1a(seed, bytes, sizeof bytes);
}

/* Half a byte at a time: 64 bytes of table where firmware has little flash. Entry i is i shifted out bit by bit. */
static const uint32_t hash_crc32c_nibble[16] = {0x00000000u, 0x105ec76fu, 0x20bd8edeu, 0x30e349b1u, 0x417b1dbcu, 0x5125dad3u,
                                                0x61c69362u, 0x7198540du, 0x82f63b78u, 0x92a8fc17u, 0xa24bb5a6u, 0xb21572c9u,
                                                0xc38d26c4u, 0xd3d3e1abu, 0xe330a81au, 0xf36e6f75u};

uint32_t hash_crc32c(uint32_t crc, const void *bytes, size_t first, size_t end)
{
    const unsigned char *p = bytes;
    uint32_t state = ~crc;
    for (size_t i = first; i < end; i++) {
        state ^= p[i];
        state = state >> 4 ^ hash_crc32c_nibble[state & 15];
        state = state >> 4 ^ hash_crc32c_nibble[state & 15];
    }
    return ~state;
}
