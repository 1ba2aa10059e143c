# SPDX-License-Identifier: MIT
"""What the package reads in the golden files is what was recorded from C, to the bit."""
from __future__ import annotations

import pathlib
import struct
import unittest
from typing import Any, Iterator

import numpy as np
from support import GOLDEN, INDEPENDENT

import tdsp
from tdsp.values import named

KINDS = {"travel": 0, "arrival": 1, "absolute": 2, "adaptive": 0, "geometric": 1}


def bits(what: str, number: float) -> str:
    return f" {what}={struct.unpack('<Q', struct.pack('<d', number))[0]:016x}"


def file(path: pathlib.Path) -> Iterator[str]:
    """The lines of tests/portable/answers.c about a file."""
    matrix = path.suffix == ".tdspm"
    opened: Any = None
    try:
        opened = tdsp.Matrix.open(path) if matrix else tdsp.Table.open(path)
        status = tdsp.Status.OK
    except tdsp.DataError as error:
        status = error.status
        assert str(error).startswith(f"{path}: "), error
    yield f"{path.name} {named([status])[0]}"
    if opened is not None:
        yield from (pairs if matrix else table)(opened)


def pairs(matrix: tdsp.Matrix) -> Iterator[str]:
    for i, source in enumerate(matrix.sources):
        for j, destination in enumerate(matrix.destinations):
            status = matrix.status(i, j)
            yield (f" from '{source.name}'{bits('x', source.place.x)}{bits('y', source.place.y)} to '{destination.name}' {named([status])[0]}")
            if status == tdsp.Status.OK:
                yield from table(matrix[i, j])


def table(table: tdsp.Table) -> Iterator[str]:
    info = table.info
    yield (f"  info {info.version[0]}.{info.version[1]} {KINDS[info.monotone]} {KINDS[info.guarantee]} {KINDS[info.sampling]} rows {info.rows} "
           f"legs {info.legs} curves {info.curves} gaps {info.gaps} hash {info.scene_hash:016x} guide {info.guide_length} "
           f"{named([info.last_reason])[0]} '{info.length_unit}' '{info.time_unit}'" + bits("epsilon", info.epsilon) + bits("delta", info.delta)
           + bits("error", info.error) + bits("speed", info.speed) + bits("first", info.first_lower) + bits("last", info.last_departure))
    before = 0.0
    for i in range(len(table)):
        row = table.row(i)
        content = "".join(f" {byte:02x}" for byte in table.row_bytes(i))
        yield f"  row {i} ok{content}" + bits("b", row.departure) + bits("left", row.left) + bits("right", row.right)
        middle = (before + row.departure) / 2
        yield arrival(table, row.departure)
        yield arrival(table, middle)
        for late in (row.departure + row.left, row.departure + row.right, row.departure + 0.75 * row.left):
            yield departure(table, late)
        yield from path(table, middle)
        yield from jump(table, before)
        before = row.departure
    yield arrival(table, before * 2 + 1)
    yield arrival(table, -1.0)
    yield departure(table, 0.0)


def arrival(table: tdsp.Table, time: float) -> str:
    lower, upper, status = (array[0] for array in table.arrivals([time]))
    if status != tdsp.Status.OK:
        lower = upper = 0.0
    else:
        assert (lower, upper) == table.arrival(time)
    return "  arrival" + bits("t", time) + f" {named([status])[0]}" + bits("lower", lower) + bits("upper", upper)


def departure(table: tdsp.Table, time: float) -> str:
    safe, none, status = (array[0] for array in table.departures([time]))
    if status != tdsp.Status.OK:
        safe = none = 0.0
    else:
        assert (safe, none) == table.departure(time)
    return "  departure" + bits("a", time) + f" {named([status])[0]}" + bits("safe", safe) + bits("none", none)


def path(table: tdsp.Table, time: float) -> Iterator[str]:
    found = table.path(time)
    yield f"  path ok {len(found)}"
    for i, leg in enumerate(found.legs):
        assert leg == table.leg(time, i)
        numbers = [leg["start_time"], leg["end_time"], *leg["from"], *leg["to"], *leg["center"],
                   *(leg[name] for name in ("radius_from", "radius_to", "angle_from", "sweep", "rate_from", "rate_to", "bend_from", "bend_to", "speed"))]
        yield f"  leg {leg['kind']} {leg['disc']} {leg['turn']}" + "".join(bits("", number) for number in numbers)
        place = found.position_on(i, float(leg["start_time"] + 0.375 * (leg["end_time"] - leg["start_time"])))
        yield "  place" + bits("x", place.x) + bits("y", place.y)


def jump(table: tdsp.Table, time: float) -> Iterator[str]:
    found = table.next_jump(time)
    if found is not None:
        gap = found.gap
        first, second, when = (gap.first, gap.second, gap.time) if gap else (tdsp.NO_DISC, None, 0.0)
        yield (f"  jump {found.row} gap {first} {tdsp.NO_DISC if second is None else second}" + bits("at", found.departure) + bits("before", found.before)
               + bits("after", found.after) + bits("time", when))


class GoldenTest(unittest.TestCase):
    def test_answers_are_those_recorded_from_c(self) -> None:
        recorded: dict[str, list[str]] = {}
        for line in (GOLDEN / "answers.txt").read_text(encoding="utf-8").splitlines():
            if not line.startswith(" "):
                recorded[line] = []
            recorded[next(reversed(recorded))].append(line)
        paths = {path.name: path for folder in (GOLDEN / "answered", INDEPENDENT) for path in folder.glob("*.tdsp*")}
        self.assertEqual(len(recorded), len(paths))
        for first, lines in recorded.items():
            with self.subTest(first):
                self.assertEqual(list(file(paths[first.split()[0]])), lines)

    def test_broken_files_are_refused_with_the_status_that_is_listed(self) -> None:
        for line in (GOLDEN / "refused.txt").read_text(encoding="utf-8").splitlines():
            name, status = line.split()
            data = (GOLDEN / "refused" / name).read_bytes()
            with self.subTest(name), self.assertRaises(tdsp.DataError) as caught:
                tdsp.Matrix(data) if name.endswith(".tdspm") else tdsp.Table(data)
            self.assertEqual(named([caught.exception.status]), [status])

    def test_many_look_ups_are_those_one_by_one(self) -> None:
        for path in sorted((GOLDEN / "answered").glob("*.tdsp")):
            opened = tdsp.Table.open(path)
            times = np.linspace(0.0, 1.1 * opened.info.last_departure, 1000).reshape(10, 100)
            lower, upper, status = opened.arrivals(times)
            rows, _ = opened.rows_at(times)
            self.assertEqual(upper.shape, (10, 100))
            for index in [(0, 0), (3, 7), (8, 99), (9, 99)]:
                if status[index] == tdsp.Status.OK:
                    self.assertEqual(opened.arrival(times[index]), (lower[index], upper[index]))
                    self.assertEqual(opened.row_at(times[index]), rows[index])
                else:
                    self.assertEqual((upper[index], rows[index]), (np.inf, len(opened)))
