#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A reader of matrices written from docs/format.md alone, section 12.

    read_matrix.py FILE     what it holds
"""
import struct
import sys

from read_table import crc32c


class Matrix:
    def __init__(self, data):
        self.data = data
        if data[:8] != b"\x89TDSM\r\n\x1a":
            raise ValueError("magic")
        major, minor, header, length, body_crc, header_crc = struct.unpack_from("<HHIQII", data, 8)
        if major != 1 or length != len(data) or (minor == 0 and header != 88):
            raise ValueError("version or length")
        if crc32c(data[:28] + data[32:header]) != header_crc or crc32c(data[header:]) != body_crc:
            raise ValueError("checksum")
        count_from, count_to, points, ends, names, self.pairs, tables = struct.unpack_from("<7Q", data, 32)
        total = count_from + count_to
        places = [struct.unpack_from("<2d", data, points + 16 * k) for k in range(total)]
        bounds = [0] + [struct.unpack_from("<Q", data, ends + 8 * k)[0] for k in range(total)]
        named = [data[names + a:names + b].decode("utf-8") for a, b in zip(bounds, bounds[1:])]
        everything = list(zip(places, named))
        self.sources, self.destinations = everything[:count_from], everything[count_from:]
        if tables != self.pairs + 24 * count_from * count_to:
            raise ValueError("sections")

    def pair(self, i, j):
        return struct.unpack_from("<QQII", self.data, self.pairs + 24 * (i * len(self.destinations) + j))

    def table(self, i, j):
        """The bytes of a table, or None."""
        offset, length, status, zero = self.pair(i, j)
        if zero != 0 or offset % 8 != 0:
            raise ValueError("pair")
        return self.data[offset:offset + length] if status == 0 else None


if __name__ == "__main__":
    with open(sys.argv[1], "rb") as file:
        matrix = Matrix(file.read())
    for i, source in enumerate(matrix.sources):
        for j, destination in enumerate(matrix.destinations):
            print(source, destination, matrix.pair(i, j)[1:3])
