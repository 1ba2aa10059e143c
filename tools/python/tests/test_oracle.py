# SPDX-License-Identifier: MIT
"""Oracles in Python: tables over worlds of one's own, what exceptions in callbacks become, and the conformance kit."""
from __future__ import annotations

import math
import traceback
import unittest
from typing import Optional

from support import gate

import tdsp
from tdsp import Label, Oracle, Status


class Ferry(Oracle):
    """Leaves every 30 minutes, eight times; its path is the number of the ferry."""

    def __init__(self) -> None:
        self.taken = 0

    def earliest_arrival(self, departure: float) -> float:
        self.taken = math.ceil(departure / 30)
        if self.taken > 8:
            raise tdsp.Unreachable
        return 30.0 * self.taken + 20.0

    def path(self) -> bytes:
        return self.taken.to_bytes(2, "little")


class Wrapped(Oracle):
    """A solver's every method, by way of Python."""

    monotone = "travel"

    def __init__(self, solver: tdsp.Solver) -> None:
        self.solver, inner = solver, solver.oracle()
        self.error, self.time_scale = inner.error, inner.time_scale
        self.last: Optional[tdsp.Path] = None
        self.asked = 0

    def earliest_arrival(self, departure: float) -> float:
        self.asked += 1
        self.last = self.solver.path(departure)
        return self.last.arrival

    def latest_departure(self, arrival: float) -> float:
        return self.solver.latest_departure(arrival)

    def latest_departure_between(self, arrival: float, after: float, before: float) -> tuple[float, float]:
        self.last = self.solver.path_to_arrive(arrival)
        return self.last.departure, self.last.arrival

    def earliest_arrival_within(self, departure: float, delta: float) -> tuple[float, float]:
        self.last = self.solver.path_within(departure, delta)
        return self.solver.arrival_within(departure, delta)

    def path(self) -> Optional[tdsp.Path]:
        return self.last

    def last_reason(self, departure: float) -> Status:
        return self.solver.last_departure().reason

    def jump_gap(self, departure: float, before: float, after: float) -> Optional[tdsp.Gap]:
        return self.solver.gap(departure)


class OracleTest(unittest.TestCase):
    def test_a_ferry_s_table_holds_its_bytes(self) -> None:
        table = tdsp.build(Ferry(), guarantee="absolute", delta=0.5)
        self.assertEqual(int.from_bytes(table.row_bytes(table.row_at(65.0)), "little"), 3)
        self.assertAlmostEqual(table.arrival(65.0).upper, 110.0)
        self.assertEqual(table.info.last_reason, Status.UNREACHABLE)
        self.assertEqual(table.info.monotone, "arrival")
        with self.assertRaises(tdsp.Unreachable):
            table.arrival(250.0)
        with self.assertRaises(tdsp.NoAnswer):
            table.position(65.0, 70.0)

    def test_a_solver_by_way_of_python_makes_a_table_of_the_scene(self) -> None:
        scene = gate()
        about = tdsp.About(scene.hash(), scene.speed, scene.source, scene.destination, "m", "s")
        wrapped = Wrapped(scene.solver())
        table = tdsp.build(wrapped, about=about)
        self.assertGreater(wrapped.asked, 0)
        self.assertEqual(next(table.jumps()).gap, next(scene.build().jumps()).gap)
        self.assertEqual(table.info.last_reason, Status.DESTINATION_COVERED)
        self.assertTrue(table.verify(scene))
        self.assertTrue(tdsp.check_oracle(wrapped))

    def test_what_an_oracle_raises_comes_out_of_the_build(self) -> None:
        class Broken(Ferry):
            def earliest_arrival(self, departure: float) -> float:
                if departure > 100:
                    raise LookupError("no timetable")
                return super().earliest_arrival(departure)

        try:
            tdsp.build(Broken(), guarantee="absolute", delta=0.5)
            self.fail("nothing was raised")
        except LookupError:
            self.assertIn("no timetable", traceback.format_exc())
            self.assertIn("in earliest_arrival\n    raise LookupError", traceback.format_exc())
        with self.assertRaises(LookupError):
            tdsp.check_oracle(Broken())

    def test_an_answer_that_is_no_number_is_a_type_error(self) -> None:
        class Wordy(Oracle):
            def earliest_arrival(self, departure: float) -> float:
                return "soon"  # type: ignore[return-value]

        with self.assertRaises(ValueError):
            tdsp.build(Wordy(), guarantee="absolute", delta=1.0, horizon=5.0)
        with self.assertRaises(NotImplementedError):
            tdsp.build(Oracle(), guarantee="absolute", delta=1.0, horizon=5.0)

    def test_an_oracle_that_breaks_its_promise_is_found_out(self) -> None:
        class Impatient(Oracle):
            def earliest_arrival(self, departure: float) -> float:
                return 30.0 - departure if departure < 10 else departure + 1.0

        with self.assertRaises(tdsp.BadOracle):
            tdsp.build(Impatient(), guarantee="absolute", delta=1.0, horizon=50.0)
        findings = tdsp.check_oracle(Impatient())
        self.assertFalse(findings)
        self.assertEqual({finding.rule for finding in findings.found}, {"order"})
        self.assertEqual(findings.found[0].callback, "earliest_arrival")
        self.assertTrue(findings.found[0].text)
        self.assertTrue(tdsp.check_oracle(Ferry(), horizon=100.0, departures=20))
        self.assertFalse(tdsp.check_oracle(Ferry(), calls=5).complete)

    def test_slow_answers_are_noticed(self) -> None:
        self.assertIn("slow", tdsp.check_oracle(Ferry(), seconds=0.0).times)

    def test_infinity_is_no_way(self) -> None:
        class Closing(Oracle):
            def earliest_arrival(self, departure: float) -> float:
                return math.inf if departure > 7 else departure + 1

        table = tdsp.build(Closing(), guarantee="absolute", delta=0.5)
        self.assertAlmostEqual(table.info.last_departure, 7)
        self.assertEqual(table.info.last_reason, Status.UNREACHABLE)

    def test_a_solver_s_oracle_may_be_asked_in_python(self) -> None:
        oracle = gate().solver().oracle()
        self.assertEqual(oracle.earliest_arrival(0.0), 20.0)
        self.assertAlmostEqual(oracle.latest_departure(33.0), 9.849623113)
        self.assertLessEqual(oracle.earliest_arrival_within(0.0, 0.1).lower, 20.0)
        self.assertTrue(tdsp.check_oracle(oracle))


class MatrixTest(unittest.TestCase):
    SOURCES = [((-10, 0), "gate"), (-10, 2)]
    DESTINATIONS = [((10, 0), "camp"), (0, 3), tdsp.End(tdsp.Point(10, 2), "fjord ø")]

    def test_each_pair_has_its_table_or_a_reason(self) -> None:
        scene = gate()
        matrix = tdsp.build_matrix(scene, self.SOURCES, self.DESTINATIONS)
        self.assertEqual(matrix.shape, (2, 3))
        self.assertEqual([end.name for end in matrix.sources + matrix.destinations], ["gate", "", "camp", "", "fjord ø"])
        self.assertEqual(matrix.statuses().tolist(), [[0, 2, 0], [0, 2, 0]])
        self.assertEqual(bytes(matrix[1, 2]), bytes(scene.build(ends=((-10, 2), (10, 2)))))
        self.assertEqual(matrix.report.tables, 4)  # type: ignore[union-attr]
        with self.assertRaisesRegex(tdsp.DestinationCovered, "pair 0, 1"):
            matrix[0, 1]
        with self.assertRaisesRegex(tdsp.InvalidArgument, "the matrix has 2 sources and 3 destinations"):
            matrix[2, 0]
        self.assertEqual(bytes(tdsp.Matrix(bytes(matrix))), bytes(matrix))

    def test_threads_change_no_byte_and_progress_counts_pairs(self) -> None:
        told: list[float] = []
        alone = tdsp.build_matrix(gate(), self.SOURCES, self.DESTINATIONS, progress=lambda done, all: told.append(all))
        self.assertEqual(set(told), {6.0})
        self.assertEqual(bytes(tdsp.build_matrix(gate(), self.SOURCES, self.DESTINATIONS, threads=3)), bytes(alone))

    def test_a_pair_that_fails_is_named(self) -> None:
        with self.assertRaisesRegex(tdsp.NeedsHorizon, "pair 0, 0: "):
            tdsp.build_matrix(tdsp.Scene(1.0, (0, 0), (5, 0)), [(0, 0)], [(1, 0)])
        with self.assertRaises(tdsp.Cancelled):
            tdsp.build_matrix(gate(), self.SOURCES, self.DESTINATIONS, progress=lambda *_: True)
        with self.assertRaises(tdsp.InvalidArgument):
            tdsp.build_matrix(gate(), [], self.DESTINATIONS)

    def test_oracles_of_one_s_own_make_a_matrix_too(self) -> None:
        matrix = tdsp.build_matrix(lambda i, j: (Ferry(), 10 * i + j), [(0, 0), (0, 1)], [(1, 0)], guarantee="absolute", delta=0.5)
        self.assertEqual(matrix[1, 0].info.scene_hash, 10)
        self.assertAlmostEqual(matrix[1, 0].arrival(65.0).upper, 110.0)
        with self.assertRaises(ZeroDivisionError):
            tdsp.build_matrix(lambda i, j: (Ferry(), 1 // 0), [(0, 0)], [(1, 0)], guarantee="absolute", delta=0.5)


class SearchTest(unittest.TestCase):
    ROADS = {(x, y): [(x + 1, y), (x, y + 1), (x - 1, y), (x, y - 1)] for x in range(20) for y in range(20)}

    def search(self, bound: Optional[tdsp.labels.Bound], limit: float = math.inf) -> tuple[bool, dict[int, float], int]:
        reached: dict[int, float] = {}
        taken = 0

        def expand(label: Label, open: tdsp.Open) -> bool:
            nonlocal taken
            open.limit(limit)
            if label.id in reached:
                return False
            taken += 1
            reached[label.id] = label.time
            for x, y in self.ROADS[label.id % 20, label.id // 20]:
                if (x, y) in self.ROADS:
                    open.push(Label(label.time + 1 + 0.1 * ((x * y) % 3), x + 20 * y))
            return label.id == 399

        return tdsp.search([Label(0.0, 0)], expand, bound), reached, taken

    def test_a_bound_finds_the_same_with_fewer_labels(self) -> None:
        done, reached, taken = self.search(None)
        done_too, reached_too, fewer = self.search(lambda label: float(38 - label.id % 20 - label.id // 20))
        self.assertTrue(done and done_too)
        self.assertAlmostEqual(reached[399], reached_too[399])
        self.assertLess(fewer, taken)

    def test_a_limit_drops_what_is_beyond(self) -> None:
        done, reached, _ = self.search(None, limit=10.0)
        self.assertFalse(done)
        self.assertLessEqual(max(reached.values()), 10.0)

    def test_what_callbacks_raise_comes_out(self) -> None:
        with self.assertRaises(ZeroDivisionError):
            tdsp.search([Label(0.0, 0)], lambda label, open: 1 / 0)
        with self.assertRaises(ZeroDivisionError):
            tdsp.search([Label(0.0, 0)], lambda label, open: None, lambda label: 1 / 0)
        with self.assertRaises(tdsp.InvalidArgument):
            tdsp.search([Label(0.0, 0)], lambda label, open: open.push(Label(math.nan, 0)))
