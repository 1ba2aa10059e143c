#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files that a reader must refuse: a sound table or matrix with one rule of docs/format.md broken, and checksums that fit unless they are the rule.

    refuse.py            write refused/NAME and the list of the statuses they must give, refused.txt
    refuse.py --check    hold the files in the tree, and the second reader, to this list
"""
import math
import pathlib
import struct
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "independent"))
sys.dont_write_bytecode = True
from read_table import Bad, Table, crc32c  # noqa: E402

SOUND = HERE.parent / "independent" / "golden"
MATRIX = HERE / "answered" / "two-discs.tdspm"
NAN, INF = math.nan, math.inf
HUGE = 2**64 - 1


class File:
    """The bytes of a sound file, to be changed."""

    def __init__(self, base):
        matrix = base == "matrix"
        self.data = bytearray((MATRIX if matrix else SOUND / (base + ".tdsp")).read_bytes())
        self.table = None if matrix else Table(bytes(self.data))

    def at(self, place):
        """A place is an offset, or (section, bytes from its start)."""
        if isinstance(place, int):
            return place
        section, offset = place
        if self.table:
            return self.table.sections[section][0] + offset
        return struct.unpack_from("<Q", self.data, {"points": 48, "name ends": 56, "names": 64, "pairs": 72, "tables": 80}[section])[0] + offset

    def put(self, form, place, value):
        struct.pack_into("<" + form, self.data, self.at(place), value)

    def seal(self):
        """Both checksums, and the file's length, made right."""
        struct.pack_into("<Q", self.data, 16, len(self.data))
        header = min(struct.unpack_from("<I", self.data, 12)[0], len(self.data))
        struct.pack_into("<I", self.data, 24, crc32c(self.data[header:]))
        struct.pack_into("<I", self.data, 28, crc32c(self.data[:28], self.data[32:header]))


def changed(base, *changes):
    """A sound file with (form, place, value) put in, sealed."""
    file = File(base)
    for change in changes:
        file.put(*change)
    file.seal()
    return bytes(file.data)


def unsealed(base, *changes):
    file = File(base)
    for change in changes:
        file.put(*change)
    return bytes(file.data)


def cut(base, length):
    return bytes(File(base).data[:length])


def longer(base, more):
    """With bytes behind the end that the header's length admits to."""
    file = File(base)
    file.data += more
    file.seal()
    return bytes(file.data)


def newer(base, header_length, *changes):
    """As if written by minor version 3, with a header of this length."""
    return changed(base, ("H", 10, 3), ("I", 12, header_length), *changes)


def row(section, number):
    return (section, 8 * number)


def waypoint(number, member):
    return ("waypoints", 32 * number + {"time": 0, "x": 8, "disc": 24, "arc": 28}[member])


def arc(number, member):
    return ("arcs", 48 * number + 8 * ["x", "y", "r0", "r1", "angle", "turned"].index(member))


def curve(number, member):
    names = ["x", "y", "r0", "r1", "angle", "turned", "rate0", "rate1", "bend0", "bend1", "speed"]
    return ("curves", 88 * number + 8 * names.index(member))


def gap(number, member):
    return ("gaps", 40 * number + {"row": 0, "first": 8, "time": 16, "x": 24}[member])


def f64(base, place, value):
    return changed(base, ("d", place, value))


def u32(base, place, value):
    return changed(base, ("I", place, value))


def u64(base, place, value):
    return changed(base, ("Q", place, value))


def text(offset, raw):
    return [("B", offset + i, byte) for i, byte in enumerate(raw.ljust(16, b"\0"))]


def frames(base):
    """What is asked before anything else, of tables and of matrices alike: (name, status, bytes)."""
    length = len(File(base).data)
    return [
        ("empty", "bad_magic", b""),
        ("magic", "bad_magic", unsealed(base, ("B", 0, 0x88))),
        ("text", "bad_magic", b'{"name": "no table", "robot": {"speed": 1}}'),
        ("magic-only", "bad_length", cut(base, 8)),
        ("version-2", "bad_version", changed(base, ("H", 8, 2))),
        ("version-0", "bad_version", changed(base, ("H", 8, 0))),
        ("cut-in-the-header", "bad_length", cut(base, 80)),
        ("cut-by-a-byte", "bad_length", cut(base, length - 1)),
        ("a-byte-more", "bad_length", cut(base, length) + b"\0"),
        ("length-that-overflows", "bad_length", unsealed(base, ("Q", 16, HUGE))),
        ("header-longer-than-its-version", "bad_table", changed(base, ("I", 12, struct.unpack_from("<I", File(base).data, 12)[0] + 8))),
        ("header-longer-than-the-file", "bad_table", unsealed(base, ("H", 10, 9), ("I", 12, 0xfffffff8))),
        ("header-of-a-newer-version-not-a-multiple-of-8", "bad_table", changed(base, ("H", 10, 9), ("I", 12, 380))),
        ("header-of-a-newer-version-too-short", "bad_table", changed(base, ("H", 10, 9), ("I", 12, 80))),
        ("header-checksum", "bad_checksum", unsealed(base, ("B", 40, File(base).data[40] ^ 4))),
        ("body-checksum", "bad_checksum", unsealed(base, ("B", length - 1, File(base).data[length - 1] ^ 128))),
        ("more-behind-the-last-section", "bad_table", longer(base, bytes(8))),
    ]


def headers():
    """Values of the header, and which go together (section 3)."""
    return {
        "monotone-2": u32("gap", 32, 2), "guarantee-3": u32("gap", 36, 3), "sampling-2": u32("gap", 40, 2),
        "last-reason-0": u32("gap", 44, 0), "last-reason-4": u32("gap", 44, 4), "last-reason-8": u32("gap", 44, 8),
        "travel-promised-of-arrivals": changed("road", ("I", 36, 0)),
        "geometric-for-travel": u32("gap", 40, 1),
        "epsilon-0": f64("gap", 56, 0.0), "epsilon-negative": f64("gap", 56, -0.25), "epsilon-nan": f64("gap", 56, NAN),
        "epsilon-infinite": f64("gap", 56, INF), "delta-beside-epsilon": f64("gap", 64, 0.5), "delta-0": f64("loose", 64, 0.0),
        "epsilon-beside-delta": f64("loose", 56, 0.5),
        "error-negative": f64("gap", 72, -1e-300), "error-nan": f64("gap", 72, NAN), "time-scale-infinite": f64("gap", 80, INF),
        "speed-negative": f64("gap", 88, -1.0), "source-nan": f64("gap", 96, NAN), "source-infinite": f64("gap", 104, -INF),
        "destination-nan": f64("gap", 120, NAN),
        "first-departure-not-0": f64("gap", 128, 5e-324), "first-lower-negative": f64("gap", 136, -1.0), "first-lower-nan": f64("gap", 136, NAN),
        "first-lower-over-left": f64("gap", 136, 20.000000000000004), "last-departure-another": f64("gap", 144, 12.500000000000002),
        "unit-not-utf-8": changed("gap", *text(152, b"\xc3(")), "unit-overlong": changed("gap", *text(152, b"\xc0\xaf")),
        "unit-surrogate": changed("gap", *text(168, b"\xed\xa0\x80")), "unit-without-end": changed("gap", *text(168, b"sixteen-bytes-xx")),
        "unit-text-behind-its-end": changed("gap", *text(152, b"m\0n")),
        "joint-0": u32("gap", 288, 0), "joint-3": u32("gap", 288, 3), "reserved-not-0": u32("gap", 292, 1),
    }


def sections():
    """Counts and offsets (sections 2 and 3): every product and sum that could wrap round, every gap and overlap."""
    wide = "squeeze"
    return {
        "rows-0": u64("gap", 184, 0), "rows-that-overflow": u64("gap", 184, HUGE), "rows-whose-bytes-overflow": u64("gap", 184, 2**61 + 4),
        "rows-one-more": u64("gap", 184, 5), "legs-one-more": u64("gap", 192, 10), "waypoints-that-overflow": u64("gap", 200, 2**59 + 1),
        "waypoints-whose-bytes-overflow": u64("gap", 200, HUGE), "arcs-that-overflow": u64("gap", 208, HUGE), "arcs-over-32-bits": u64("gap", 208, 2**32),
        "opaque-that-overflows": u64("road", 216, HUGE - 6), "cells-that-overflow": u64("crowd", 304, HUGE), "cells-over-32-bits": u64("crowd", 328, 2**32),
        "curves-that-overflow": u64("swell", 352, HUGE), "curves-over-32-bits": u64("swell", 352, 2**32), "gaps-that-overflow": u64(wide, 368, HUGE // 40 + 2),
        "departures-inside-the-header": u64("gap", 224, 288), "departures-behind-the-end": u64("gap", 224, 2**40), "left-on-departures": u64("gap", 232, 296),
        "right-not-aligned": u64("gap", 240, 361), "waypoints-elsewhere": u64("gap", 256, 0), "arcs-that-end-behind-2-to-64": u64("gap", 264, HUGE - 7),
        "first-byte-elsewhere": u64("road", 272, 8), "opaque-elsewhere": u64("road", 280, 8), "guide-elsewhere": u64("crowd", 296, 8),
        "curves-elsewhere": u64("swell", 344, 8), "gaps-elsewhere": u64(wide, 360, 8),
        "padding-of-first-waypoints": changed("gap", ("B", ("first_waypoint", 23), 1)), "padding-of-opaque": changed("road", ("B", ("opaque", 15), 1)),
        "padding-of-guides": changed("crowd", ("B", len(File("crowd").data) - 1, 1)),
        "newer-version-with-sections-that-overlap": newer("squeeze", 376, ("Q", 232, 376)),
        "newer-version-with-a-section-not-aligned": newer("squeeze", 376, ("Q", 360, 516)),
        "newer-version-with-a-section-behind-the-end": newer("squeeze", 376, ("Q", 360, 4096)),
    }


def rows():
    """Order and finiteness of the rows (section 4)."""
    b, left, right = "departures", "left", "right"
    return {
        "departures-equal": f64("gap", row(b, 2), 4.0), "departures-out-of-order": f64("gap", row(b, 2), 3.0), "departure-nan": f64("gap", row(b, 1), NAN),
        "departure-first-not-0": f64("gap", row(b, 0), 1.0), "departure-first-nan": f64("gap", row(b, 0), NAN),
        "departure-last-infinite": changed("gap", ("d", row(b, 3), INF), ("d", 144, INF)),
        "left-negative": f64("still", row(left, 0), -1.0), "left-nan": f64("gap", row(left, 2), NAN), "left-infinite": f64("gap", row(left, 3), INF),
        "left-that-decreases": f64("gap", row(left, 3), 20.5), "right-negative": f64("gap", row(right, 0), -20.0), "right-nan": f64("gap", row(right, 1), NAN),
        "right-infinite-inside": f64("gap", row(right, 1), INF), "right-finite-at-the-end": f64("gap", row(right, 3), 30.0),
        "right-infinite-at-a-horizon": f64("road", row(right, 3), INF), "right-that-decreases": f64("gap", row(right, 1), 19.0),
        "right-over-the-next-left": f64("gap", row(right, 2), 24.750000000000004),
        "sum-that-overflows": changed("still", ("d", row(left, 0), 1.7976931348623157e308), ("d", row(right, 0), 1.7976931348623157e308),
                                      ("d", row(b, 0), 1.7976931348623157e308), ("d", 128, 1.7976931348623157e308), ("d", 144, 1.7976931348623157e308)),
        "arrival-that-decreases": f64("road", row(left, 1), 2.5), "arrival-right-over-the-next-left": f64("road", row(right, 1), 7.5),
        "arrival-right-that-decreases": changed("road", ("d", row(right, 1), 6.9), ("d", row(right, 2), 3.5)),
    }


def paths():
    """Waypoints, arcs and curves (section 5)."""
    first = "first_waypoint"
    return {
        "first-waypoint-not-0": u32("gap", (first, 0), 1), "first-waypoint-that-decreases": u32("gap", (first, 8), 1),
        "first-waypoint-behind-the-end": u32("gap", (first, 4), 0xffffffff), "first-waypoint-last-is-less": u32("gap", (first, 16), 11),
        "row-of-one-waypoint": u32("gap", (first, 4), 1), "row-of-three-waypoints-in-pairs": u32("loose", (first, 4), 3),
        "times-that-decrease": f64("gap", waypoint(3, "time"), 3.0), "time-nan": f64("gap", waypoint(3, "time"), NAN),
        "time-first-not-the-departure": f64("gap", waypoint(2, "time"), 4.25), "time-after-the-arrival": f64("gap", waypoint(5, "time"), 25.0),
        "time-infinite": f64("gap", waypoint(5, "time"), INF), "time-two-at-a-joint": f64("loose", waypoint(1, "time"), 0.5),
        "place-nan": f64("gap", waypoint(1, "x"), NAN), "place-infinite": f64("gap", waypoint(4, "x"), INF),
        "line-with-a-disc": u32("gap", waypoint(0, "disc"), 3), "arc-of-no-such-number": u32("gap", waypoint(3, "arc"), 3),
        "arc-behind-the-last-leg": changed("gap", ("I", waypoint(5, "disc"), 3), ("I", waypoint(5, "arc"), 0)),
        "disc-behind-the-last-leg": u32("gap", waypoint(1, "disc"), 0),
        "arc-at-the-end-of-a-pair": changed("loose", ("I", waypoint(1, "disc"), 0), ("I", waypoint(1, "arc"), 0)),
        "arc-radius-0": f64("gap", arc(0, "r0"), 0.0), "arc-radius-negative": f64("gap", arc(1, "r1"), -2.5), "arc-radius-nan": f64("gap", arc(1, "r0"), NAN),
        "arc-centre-infinite": f64("gap", arc(2, "x"), INF), "arc-angle-nan": f64("gap", arc(0, "angle"), NAN), "arc-turned-nan": f64("gap", arc(0, "turned"), NAN),
        "curve-radius-0": f64("swell", curve(0, "r0"), 0.0), "curve-radius-nan": f64("swell", curve(0, "r1"), NAN),
        "curve-no-faster-than-its-rate": f64("swell", curve(0, "rate1"), 2.0), "curve-speed-nan": f64("swell", curve(0, "speed"), NAN),
        "curve-bend-infinite": f64("swell", curve(1, "bend0"), INF), "curve-turned-nan": f64("swell", curve(1, "turned"), NAN),
        "curve-centre-nan": f64("swell", curve(2, "y"), NAN), "curve-beyond-2-to-1000": f64("swell", curve(0, "bend0"), 2.0**1001),
        "curve-beyond-2-to-1000-at-once": f64("swell", curve(2, "r0"), 1.5 * 2.0**1000),
        "curve-at-so-small-a-radius-that-it-whirls": f64("swell", curve(0, "r1"), 5e-324),
        "first-byte-not-0": u64("road", ("first_byte", 0), 1), "first-byte-that-decreases": u64("road", ("first_byte", 16), 2),
        "first-byte-behind-the-end": u64("road", ("first_byte", 8), HUGE), "first-byte-last-is-less": u64("road", ("first_byte", 32), 12),
    }


def guides():
    """Guides and gaps (sections 7 and 4)."""
    departures, arrivals = "guide to departures", "guide to arrivals"
    return {
        "guide-scale-0": f64("crowd", 312, 0.0), "guide-scale-nan": f64("crowd", 312, NAN), "guide-scale-infinite": f64("crowd", 336, INF),
        "guide-scale-another": f64("crowd", 336, 1e-3), "guide-scale-without-cells": f64("squeeze", 312, 1.0),
        "guide-base-another": u32("crowd", (departures, 0), 1), "guide-base-last-another": u32("crowd", (arrivals, 4), 15),
        "guide-count-another": changed("crowd", ("B", (departures, 9), 255)), "guide-count-first-another": changed("crowd", ("B", (arrivals, 8), 1)),
        "guide-to-departures-from-minus-0": f64("crowd", row("departures", 0), -0.0),
        "gap-behind-the-last-row": u64("squeeze", gap(1, "row"), 4), "gaps-of-one-row": u64("squeeze", gap(1, "row"), 0),
        "gap-of-no-disc": u32("squeeze", gap(0, "first"), 0xffffffff), "gap-time-nan": f64("squeeze", gap(0, "time"), NAN),
        "gap-place-infinite": f64("squeeze", gap(1, "x"), INF),
    }


def inner(base):
    """Where the matrix's first table starts."""
    return struct.unpack_from("<Q", File(base).data, File(base).at(("pairs", 0)))[0]


def matrices():
    """Section 12."""
    first = inner("matrix")
    return {
        "sources-0": u64("matrix", 32, 0), "sources-over-32-bits": u64("matrix", 32, 2**32), "destinations-0": u64("matrix", 40, 0),
        "pairs-that-overflow": changed("matrix", ("Q", 32, 2**32 - 1), ("Q", 40, 2**32 - 1)), "points-elsewhere": u64("matrix", 48, 96),
        "name-ends-elsewhere": u64("matrix", 56, HUGE - 7), "names-elsewhere": u64("matrix", 64, 0), "pairs-elsewhere": u64("matrix", 72, 8),
        "tables-elsewhere": u64("matrix", 80, 2**63), "point-nan": f64("matrix", ("points", 0), NAN), "point-infinite": f64("matrix", ("points", 8), INF),
        "point-another-than-its-tables": f64("matrix", ("points", 0), 1e9), "name-that-ends-before-it-begins": u64("matrix", ("name ends", 0), HUGE),
        "names-without-end": u64("matrix", ("name ends", 8 * (sum(struct.unpack_from("<2Q", File("matrix").data, 32)) - 1)), HUGE),
        "name-not-utf-8": changed("matrix", ("B", ("names", 0), 0xff)), "pair-reserved-not-0": u32("matrix", ("pairs", 20), 1),
        "pair-with-both-a-table-and-a-reason": u32("matrix", ("pairs", 16), 3), "pair-of-a-horizon": changed("matrix", ("I", ("pairs", 16), 5)),
        "pair-at-no-table": u64("matrix", ("pairs", 0), first + 8), "pair-behind-the-end": u64("matrix", ("pairs", 8), HUGE),
        "pair-of-length-0": u64("matrix", ("pairs", 8), 0), "table-inside-with-a-changed-byte": changed("matrix", ("B", first + 300, 1)),
        "table-inside-of-another-version": changed("matrix", ("H", first + 8, 2)),
    }


def cases():
    """[(file name, status, bytes)]"""
    found = [(f"frame-{name}.tdsp", status, data) for name, status, data in frames("gap")]
    for part in (headers, sections, rows, paths, guides):
        found += [(f"{part.__name__}-{name}.tdsp", "bad_table", data) for name, data in part().items()]
    found += [(f"matrix-frame-{name}.tdspm", status, data) for name, status, data in frames("matrix")]
    return found + [(f"matrix-{name}.tdspm", "bad_table", data) for name, data in matrices().items()]


def write():
    folder = HERE / "refused"
    folder.mkdir(exist_ok=True)
    for path in folder.iterdir():
        path.unlink()
    for name, _, data in cases():
        (folder / name).write_bytes(data)
    (HERE / "refused.txt").write_text("".join(f"{name} {status}\n" for name, status, _ in cases()))
    return 0


def report(name, problems):
    print(f"not ok {name}: {'; '.join(problems)}" if problems else f"ok {name}")
    return bool(problems)


def read_by_second(data):
    try:
        Table(data)
    except (Bad, struct.error, OverflowError):
        return False
    return True


def check():
    made = cases()
    there = {path.name: path.read_bytes() for path in (HERE / "refused").iterdir()}
    bad = report("the refused files are those that the list makes", sorted(
        {n for n, _, data in made if there.get(n) != data} | (there.keys() - {n for n, _, _ in made})))
    sound = [n for n, _, data in made if n.endswith(".tdsp") and read_by_second(data)]
    bad |= report("the second reader refuses each refused table", sound)
    bases = [path.stem for path in SOUND.glob("*.tdsp")]
    return report("each refused table is a sound one but for what its name says", [b for b in bases if changed(b) != bytes(File(b).data)]) or bad


if __name__ == "__main__":
    sys.exit(check() if sys.argv[1:] == ["--check"] else write())
