/* SPDX-License-Identifier: MIT */
/*
 * Two sums over bytes: FNV-1a (64 bits), which names a scene, and CRC-32C, which guards a table.
 *
 * CRC-32C (Castagnoli: polynomial 0x1EDC6F41 reflected, start and final xor 0xffffffff; "123456789" gives e3069283)
 * finds every change of up to three bits in a table below 256 MiB and every burst of up to 32 bits in any.
 */
#ifndef BASE_HASH_H
#define BASE_HASH_H

#include <stddef.h>
#include <stdint.h>

/* The seed of an FNV-1a hash that starts here; else pass on the hash so far. */
#define HASH_FNV1A_SEED UINT64_C(0xcbf29ce484222325)

uint64_t hash_fnv1a(uint64_t seed, const void *bytes, size_t length);

/* Feeds 8 little-endian bytes; -0 counts as 0, so that equal numbers hash alike. */
uint64_t hash_double(uint64_t seed, double value);

/* CRC-32C of the bytes seen so far followed by those from `first` to before `end`; start with 0. */
uint32_t hash_crc32c(uint32_t crc, const void *bytes, size_t first, size_t end);

#endif
