#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The second reader against tables whose contents were written down by hand, and against bytes that it must refuse."""
import json
import pathlib
import struct
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
from read_table import Bad, Table, crc32c  # noqa: E402

GOLDEN = sorted((HERE / "golden").glob("*.tdsp"))


def seal(data):
    """The bytes with both checksums made right."""
    data = bytearray(data)
    header, = struct.unpack_from("<I", data, 12)
    struct.pack_into("<I", data, 24, crc32c(data[header:]))
    struct.pack_into("<I", data, 28, crc32c(data[:28], data[32:header]))
    return bytes(data)


def refused(data):
    try:
        Table(data)
    except (Bad, struct.error):
        return True
    return False


def plain(value):
    """The value as JSON gives it back: lists for tuples, None for infinity."""
    return json.loads(json.dumps(value))


def check_contents(path):
    expected = json.loads(path.with_suffix(".json").read_text(encoding="utf-8"))
    table = Table(path.read_bytes())
    found = plain(table.dump())
    found["arrive"] = [[t, plain(table.arrive(t))] for t, _ in expected["arrive"]]
    found["depart"] = [[a, plain(table.depart(a))] for a, _ in expected["depart"]]
    wrong = [key for key in sorted(set(expected) | set(found)) if expected.get(key) != found.get(key)]
    for key in wrong:
        print("%s: %s is %r, not %r" % (path.name, key, found.get(key), expected.get(key)), file=sys.stderr)
    return not wrong


def check_changed_byte(path):
    data = path.read_bytes()
    return all(refused(data[:i] + bytes([data[i] ^ 1 << i % 8]) + data[i + 1:]) for i in range(len(data)))


def check_cut(path):
    data = path.read_bytes()
    return all(refused(data[:length]) for length in range(len(data))) and refused(data + b"\0")


def check_disorder(path):
    """The last departure moved before the one before it, with checksums that fit."""
    table = Table(path.read_bytes())
    data = bytearray(path.read_bytes())
    struct.pack_into("<d", data, table.sections["departures"][0] + 8 * (table.rows - 1), -1.0)
    return refused(seal(data))


def check_earlier_reader(path):
    """A reader of each earlier minor version refuses a table with curves, which it would misread, and reads any other alike."""
    data = path.read_bytes()
    table = Table(data)
    for known in range(2):
        try:
            earlier = Table(data, known)
        except Bad:
            earlier = None
        if (earlier is None) != bool(table.curves):
            return False
        if earlier and (earlier.paths, earlier.left, earlier.right) != (table.paths, table.left, table.right):
            return False
    return True


CHECKS = {"holds what was written down by hand": check_contents, "is refused with any one bit changed": check_changed_byte,
          "is refused cut off anywhere": check_cut, "is refused with departures out of order": check_disorder,
          "is read or refused by a reader of an earlier version as it should be": check_earlier_reader}


def main():
    failed = 0 if crc32c(b"123456789") == 0xE3069283 and len(GOLDEN) >= 4 else 1
    print("ok crc-32c has its check value" if not failed else "not ok crc-32c has its check value")
    for path in GOLDEN:
        for text, check in CHECKS.items():
            good = check(path)
            failed += not good
            print("%s %s %s" % ("ok" if good else "not ok", path.stem, text))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
