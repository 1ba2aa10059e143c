#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A second reader of table files, written from docs/format.md alone: checks a file and prints everything in it as JSON.

    read_table.py FILE [--arrive T]... [--depart A]...

Exact arithmetic (fractions) stands in for the rounded sums of the C reader. Infinity is printed as null, hashes and
bytes as hexadecimal text. Exit status 1 with one line on standard error when the file is no valid table.
"""
import argparse
import bisect
import json
import math
import struct
import sys
from fractions import Fraction

MAGIC = bytes.fromhex("89544453500d0a1a")
NONE = 0xFFFFFFFF
MONOTONE = {0: "travel", 1: "arrival"}
GUARANTEE = {0: "travel", 1: "arrival", 2: "absolute"}
SAMPLING = {0: "adaptive", 1: "geometric"}
REASON = {1: "source_covered", 2: "destination_covered", 3: "cut_off", 5: "horizon", 6: "outside_table", 7: "unreachable"}
SECTIONS = ["departures", "left", "right", "first_waypoint", "waypoints", "arcs", "first_byte", "opaque"]
GUIDES = ["guide to departures", "guide to arrivals"]
FURTHER = ["curves", "gaps"]
HEADERS = [296, 344, 376]


class Bad(Exception):
    """The file is no valid table; the text says why."""


def need(holds, why):
    if not holds:
        raise Bad(why)


def crc32c(*parts):
    state = 0xFFFFFFFF
    for part in parts:
        for byte in part:
            state ^= byte
            for _ in range(8):
                state = (state >> 1) ^ (0x82F63B78 if state & 1 else 0)
    return state ^ 0xFFFFFFFF


def up(x):
    """The least double that is not below the fraction x; infinity when there is none."""
    try:
        near = float(x)
    except OverflowError:
        return math.inf
    return near if Fraction(near) >= x else math.nextafter(near, math.inf)


def down(x):
    near = float(x)
    return near if Fraction(near) <= x else math.nextafter(near, -math.inf)


def add_up(a, b):
    return math.inf if math.inf in (a, b) else up(Fraction(a) + Fraction(b))


def add_down(a, b):
    return math.inf if math.inf in (a, b) else down(Fraction(a) + Fraction(b))


def check_curve(curve, h, what):
    """Numbers of a curve that takes the time h."""
    _, _, r0, r1, _, turned, rate0, rate1, bend0, bend1, speed = curve
    need(all(map(math.isfinite, curve)) and r0 > 0 and r1 > 0 and speed > abs(rate0) and speed > abs(rate1), what)
    distance = r0 + r1 + h * (abs(rate0) + abs(rate1)) + h * h * (abs(bend0) + abs(bend1))
    slopes, bends = 0.0, 0.0
    for r, rate, bend in (r0, rate0, bend0), (r1, rate1, bend1):
        slope = speed / r
        slopes += slope
        share = (speed - rate) / speed * ((speed + rate) / speed)
        bends += abs(rate) / speed / share * (abs(bend) / r) + abs(rate) / r * slope
    need(distance <= 2.0**1000 and abs(turned) + h * slopes + h * h * bends <= 2.0**1000, what)


class Table:
    """`known` is the highest minor version that the reader knows; what came later it passes over, as docs/format.md says it must."""

    def __init__(self, data, known=2):
        self.data = data
        self.known = known
        self.check_frame()
        self.read_header()
        self.place_sections()
        self.check_header()
        self.departures = self.doubles("departures")
        self.left = self.doubles("left")
        self.right = self.doubles("right")
        self.check_rows()
        self.read_arcs()
        self.read_curves()
        self.read_paths()
        self.read_opaque()
        self.check_guide(GUIDES[0], self.departures)
        self.check_guide(GUIDES[1], [b + left for b, left in zip(self.departures, self.left)])
        self.read_gaps()

    def at(self, form, offset):
        return struct.unpack_from("<" + form, self.data, offset)

    def u32(self, offset):
        return self.at("I", offset)[0]

    def u64(self, offset):
        return self.at("Q", offset)[0]

    def f64(self, offset):
        return self.at("d", offset)[0]

    def check_frame(self):
        need(self.data[:8] == MAGIC, "magic")
        need(len(self.data) >= 12 and self.at("H", 8)[0] == 1, "version")
        need(len(self.data) >= 296 and self.u64(16) == len(self.data), "length")
        self.minor = self.at("H", 10)[0]
        self.header = self.u32(12)
        newer = self.minor > self.known
        need(self.header >= HEADERS[self.known] if newer else self.header == HEADERS[self.minor], "header length")
        need(self.header % 8 == 0 and self.header <= len(self.data), "header length")
        need(crc32c(self.data[:28], self.data[32:self.header]) == self.u32(28), "header checksum")
        need(crc32c(self.data[self.header:]) == self.u32(24), "body checksum")

    def text(self, offset):
        raw = self.data[offset:offset + 16]
        text, zero, rest = raw.partition(b"\0")
        need(zero and not any(rest), "unit")
        try:
            return text.decode("utf-8")
        except UnicodeDecodeError:
            raise Bad("unit") from None

    def name(self, names, offset, what):
        value = self.u32(offset)
        need(value in names, what)
        return names[value]

    def read_header(self):
        self.monotone = self.name(MONOTONE, 32, "monotone")
        self.guarantee = self.name(GUARANTEE, 36, "guarantee")
        self.sampling = self.name(SAMPLING, 40, "sampling")
        self.last_reason = self.name(REASON, 44, "last reason")
        self.scene_hash = self.u64(48)
        self.epsilon, self.delta, self.error, self.time_scale, self.speed = self.at("5d", 56)
        self.source = self.at("2d", 96)
        self.destination = self.at("2d", 112)
        self.first_departure, self.first_lower, self.last_departure = self.at("3d", 128)
        self.length_unit = self.text(152)
        self.time_unit = self.text(168)
        self.rows, self.legs, self.waypoints, self.arc_count, self.opaque_length = self.at("5Q", 184)
        self.joint = self.u32(288)
        has = min(self.minor, self.known)
        self.cells = {name: self.u64(304 + 24 * i) if has >= 1 else 0 for i, name in enumerate(GUIDES)}
        self.scale = {name: self.f64(312 + 24 * i) if has >= 1 else 0 for i, name in enumerate(GUIDES)}
        self.items = {name: self.u64(352 + 16 * i) if has >= 2 else 0 for i, name in enumerate(FURTHER)}

    def place_sections(self):
        bounds = self.rows + 1
        sizes = [8 * self.rows] * 3
        sizes += [4 * bounds if self.waypoints else 0, 32 * self.waypoints, 48 * self.arc_count]
        sizes += [8 * bounds if self.opaque_length else 0, self.opaque_length]
        places = [224 + 8 * i for i in range(len(SECTIONS))]
        if min(self.minor, self.known) >= 1:
            sizes += [4 * (-(-self.cells[name] // 64) + 1) + self.cells[name] if self.cells[name] else 0 for name in GUIDES]
            places += [296, 320]
        if min(self.minor, self.known) >= 2:
            sizes += [88 * self.items["curves"], 40 * self.items["gaps"]]
            places += [344, 360]
        need(self.rows > 0, "rows")
        self.sections = {}
        cursor = self.header
        for section, size, place in zip(SECTIONS + GUIDES + FURTHER, sizes, places):
            offset = self.u64(place)
            need(offset == cursor or (self.minor > self.known and offset > cursor and offset % 8 == 0), "offset of " + section)
            cursor = (offset + size + 7) // 8 * 8
            need(cursor <= len(self.data), "end of " + section)
            need(not any(self.data[offset + size:cursor]), "padding of " + section)
            self.sections[section] = (offset, size)
        need(cursor == len(self.data) or self.minor > self.known, "end of file")

    def check_header(self):
        bound, other = (self.delta, self.epsilon) if self.guarantee == "absolute" else (self.epsilon, self.delta)
        need(bound > 0 and math.isfinite(bound) and other == 0, "bound")
        numbers = [self.error, self.time_scale, self.speed]
        need(all(x >= 0 and math.isfinite(x) for x in numbers), "stated error or speed")
        need(all(map(math.isfinite, self.source + self.destination)), "source or destination")
        need(self.monotone == "travel" or self.guarantee != "travel", "guarantee")
        need(self.sampling == "adaptive" or self.guarantee == "arrival", "sampling")
        need(self.joint in (1, 2) and self.u32(292) == 0, "joint")

    def doubles(self, section):
        offset, size = self.sections[section]
        return list(self.at("%dd" % (size // 8), offset))

    def check_rows(self):
        b, left, right = self.departures, self.left, self.right
        need(b[0] == 0 == self.first_departure and b[-1] == self.last_departure, "ends of the departures")
        need(0 <= self.first_lower <= left[0], "first lower")
        need(all(x < y for x, y in zip(b, b[1:])), "order of departures")
        need(all(x >= 0 for x in left + right) and all(math.isfinite(x) for x in b + left + right[:-1]), "travel times")
        need(math.isfinite(right[-1]) == (self.last_reason in ("horizon", "outside_table")), "last right")
        need(all(math.isfinite(add_up(x, y)) for x, y in list(zip(b, left)) + list(zip(b, right[:-1]))), "sums")
        for i in range(self.rows - 1):
            if self.monotone == "travel":
                need(left[i] <= left[i + 1] and right[i] <= min(right[i + 1], left[i + 1]), "order of row %d" % i)
            else:
                next_left = add_up(b[i + 1], left[i + 1])
                need(add_down(b[i], left[i]) <= next_left, "order of row %d" % i)
                need(add_down(b[i], right[i]) <= min(next_left, add_up(b[i + 1], right[i + 1])), "order of row %d" % i)

    def read_arcs(self):
        self.arcs = []
        for i in range(self.arc_count):
            arc = self.at("6d", self.sections["arcs"][0] + 48 * i)
            need(all(map(math.isfinite, arc)) and arc[2] > 0 and arc[3] > 0, "arc %d" % i)
            self.arcs.append(arc)

    def read_curves(self):
        self.curves = []
        need(self.arc_count + self.items["curves"] <= NONE, "number of arcs and curves")
        for i in range(self.items["curves"]):
            curve = self.at("11d", self.sections["curves"][0] + 88 * i)
            check_curve(curve, 0.0, "curve %d" % i)
            self.curves.append(curve)

    def indices(self, section, form, last):
        offset, size = self.sections[section]
        width = struct.calcsize("<" + form)
        found = list(self.at("%d%s" % (size // width, form), offset)) or [0] * (self.rows + 1)
        need(found[0] == 0 and found[-1] == last and all(x <= y for x, y in zip(found, found[1:])), section)
        return found

    def waypoint(self, number):
        return self.at("3d2I", self.sections["waypoints"][0] + 32 * number)

    def leg(self, start, end):
        time, x, y, disc, arc = start
        leg = {"type": "line", "start_time": time, "end_time": end[0], "from": [x, y], "to": [end[1], end[2]]}
        if arc == NONE:
            need(disc == NONE, "a line with a disc")
            return leg
        need(arc < self.arc_count + len(self.curves), "number of an arc")
        numbers = self.arcs[arc] if arc < self.arc_count else self.curves[arc - self.arc_count]
        center_x, center_y, radius_from, radius_to, angle, turned = numbers[:6]
        leg.update(type="arc", disc=disc, center=[center_x, center_y], turn="cw" if math.copysign(1, turned) < 0 else "ccw",
                   radii=[radius_from, radius_to], angle_from=angle, sweep=abs(turned))
        if arc >= self.arc_count:
            check_curve(numbers, end[0] - time, "curve %d" % (arc - self.arc_count))
            leg.update(rates=list(numbers[6:8]), bends=list(numbers[8:10]), speed=numbers[10])
        return leg

    def path(self, row, first, end):
        points = [self.waypoint(i) for i in range(first, end)]
        if not points:
            return []
        need(len(points) >= 2 and len(points) % self.joint == 0, "waypoints of row %d" % row)
        need(all(math.isfinite(x) for p in points for x in p[:3]), "waypoint of row %d" % row)
        need(all(p[0] <= q[0] for p, q in zip(points, points[1:])), "times of row %d" % row)
        starts = range(0, len(points) - 1, self.joint)
        ends = set(range(len(points))) - set(starts)
        need(all(points[i][3:] == (NONE, NONE) for i in ends), "end of a leg in row %d" % row)
        need(self.joint == 1 or all(points[i][0] == points[i - 1][0] for i in starts if i), "joint in row %d" % row)
        need(points[0][0] == self.departures[row], "start of row %d" % row)
        need(points[-1][0] <= add_up(self.departures[row], self.left[row]), "end of row %d" % row)
        return [self.leg(points[i], points[i + 1]) for i in starts]

    def read_paths(self):
        first = self.indices("first_waypoint", "I", self.waypoints)
        self.paths = [self.path(row, first[row], first[row + 1]) for row in range(self.rows)]
        need(sum(map(len, self.paths)) == self.legs, "number of legs")

    def read_opaque(self):
        first = self.indices("first_byte", "Q", self.opaque_length)
        offset = self.sections["opaque"][0]
        self.opaque = [self.data[offset + a:offset + b] for a, b in zip(first, first[1:])]
        need(all(len(part) < 2**31 for part in self.opaque), "opaque bytes")

    def check_guide(self, name, times):
        """The stored guide against one made anew; floats here round as the format says."""
        cells, scale = self.cells[name], self.scale[name]
        if cells == 0:
            return need(scale == 0, name)
        need(0 < scale < math.inf and self.rows < 2**32 and (times[-1] - times[0]) * scale < 2**32 - 1, name)
        need(name != GUIDES[0] or math.copysign(1, times[0]) > 0, name)
        need(all(x <= y for x, y in zip(times, times[1:])), name)
        cell = [int((x - times[0]) * scale) for x in times]
        need(cell[-1] + 1 == cells, name)
        start = [bisect.bisect_left(cell, k) for k in range(cells)]
        base = start[::64]
        offset = self.sections[name][0]
        need(list(self.at("%dI" % (len(base) + 1), offset)) == base + [self.rows], name)
        counts = bytes(min(255, row - base[k // 64]) for k, row in enumerate(start))
        need(self.data[offset + 4 * len(base) + 4:][:cells] == counts, name)

    def read_gaps(self):
        """{row: (first, second, time, x, y)}"""
        self.gaps, last = {}, -1
        for i in range(self.items["gaps"]):
            row, first, second, time, x, y = self.at("Q2I3d", self.sections["gaps"][0] + 40 * i)
            need(last < row < self.rows and first != NONE and all(map(math.isfinite, (time, x, y))), "gap %d" % i)
            self.gaps[row], last = (first, second, time, x, y), row

    def arrive(self, t):
        """(row, lower, upper) for a departure, or None after the last."""
        row = next((i for i, b in enumerate(self.departures) if b >= t), None)
        if row is None:
            return None
        if row == 0:
            return row, self.first_lower, self.left[0]
        if self.monotone == "travel":
            return row, add_down(t, self.right[row - 1]), add_up(t, self.left[row])
        return row, max(t, add_down(self.departures[row - 1], self.right[row - 1])), add_up(self.departures[row], self.left[row])

    def depart(self, a):
        """The greatest safe departure for an arrival and an upper bound of all, or None when it is too early."""
        b, left, right = self.departures, self.left, self.right
        safe = [i for i in range(self.rows) if add_up(b[i], left[i]) <= a]
        if not safe:
            return None
        i = safe[-1]
        best = b[i]
        if self.monotone == "travel" and i + 1 < self.rows:
            best = max(best, down(Fraction(a) - Fraction(left[i + 1])))
        open_rows = [j for j in range(self.rows) if math.isfinite(right[j]) and Fraction(b[j]) + Fraction(right[j]) <= a]
        if not open_rows:
            return best, 0.0
        j = open_rows[-1]
        bound = up(Fraction(a) - Fraction(right[j])) if self.monotone == "travel" else a
        return best, min(bound, b[j + 1]) if j + 1 < self.rows else bound

    def jump(self, i):
        margin = 2 * self.error * (self.left[i] + self.time_scale) + 2.0**-40 * (self.departures[i] + self.left[i])
        return math.isfinite(self.right[i]) and self.right[i] - self.left[i] > margin

    def dump(self):
        rows = [{"departure": self.departures[i], "left": self.left[i], "right": finite(self.right[i]), "jump": self.jump(i),
                 "legs": self.paths[i], "bytes": self.opaque[i].hex()} for i in range(self.rows)]
        return {"version": [1, self.minor], "length": len(self.data), "monotone": self.monotone, "guarantee": self.guarantee,
                "sampling": self.sampling, "last_reason": self.last_reason, "scene_hash": "%016x" % self.scene_hash,
                "epsilon": self.epsilon, "delta": self.delta, "error": self.error, "time_scale": self.time_scale,
                "speed": self.speed, "source": list(self.source), "destination": list(self.destination),
                "first_departure": self.first_departure, "first_lower": self.first_lower, "last_departure": self.last_departure,
                "length_unit": self.length_unit, "time_unit": self.time_unit, "leg_count": self.legs, "joint": self.joint,
                "rows": rows, **({"cells": list(self.cells.values())} if self.minor else {}),
                **({"curves": len(self.curves), "gaps": [[row, *gap] for row, gap in self.gaps.items()]} if self.minor > 1 else {})}


def finite(x):
    return x if math.isfinite(x) else None


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file")
    parser.add_argument("--arrive", type=float, action="append", default=[], metavar="T")
    parser.add_argument("--depart", type=float, action="append", default=[], metavar="A")
    options = parser.parse_args()
    with open(options.file, "rb") as file:
        data = file.read()
    try:
        table = Table(data)
    except Bad as why:
        print("%s: %s" % (options.file, why), file=sys.stderr)
        return 1
    result = table.dump()
    result["arrive"] = [table.arrive(t) for t in options.arrive]
    result["depart"] = [table.depart(a) for a in options.depart]
    json.dump(result, sys.stdout, indent=1)
    print()
    return 0


if __name__ == "__main__":
    sys.exit(main())
