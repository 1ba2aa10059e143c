# SPDX-License-Identifier: MIT
"""Exact answers: forwards, backwards, many at once, and what they must agree in."""
from __future__ import annotations

import math
import unittest

import numpy as np
from support import SCENES, crowd, gate

import tdsp
from tdsp import Status

LAST_THROUGH = 9.849623113198598


class SolverTest(unittest.TestCase):
    def test_forwards_and_backwards_meet(self) -> None:
        for seed in range(20):
            solver = crowd(seed).solver()
            times = np.linspace(0, 20, 9)
            arrival, status = solver.arrivals(times)
            for time, when in zip(times[status == Status.OK], arrival[status == Status.OK]):
                self.assertGreaterEqual(solver.latest_departure(float(when) + 1e-9), time - 1e-9)
                self.assertTrue(solver.path(float(time)).verify(solver.scene))

    def test_travel_times_never_fall(self) -> None:
        for seed in range(20):
            times = np.linspace(0, 20, 21)
            travel = crowd(seed).solver().arrivals(times).arrival - times
            finite = travel[np.isfinite(travel)]
            self.assertTrue((np.diff(finite) >= -1e-9).all())
            self.assertTrue(np.isfinite(travel)[:len(finite)].all())

    def test_answers_turn_with_the_scene(self) -> None:
        scene, turn = crowd(3), np.array([[0.6, -0.8], [0.8, 0.6]])
        discs = scene.discs
        turned = tdsp.Scene(1.0, turn @ scene.source, turn @ scene.destination, discs["center"] @ turn.T, discs["radius"], discs["growth"])
        times = np.linspace(0, 10, 11)
        np.testing.assert_allclose(turned.solver().arrivals(times).arrival, scene.solver().arrivals(times).arrival, rtol=1e-9)

    def test_why_there_is_no_way_is_raised_for_one_and_listed_for_many(self) -> None:
        solver = gate().solver()
        with self.assertRaisesRegex(tdsp.DestinationCovered, "departure 70.0: The destination is covered") as caught:
            solver.arrival(70.0)
        self.assertEqual(caught.exception.status, Status.DESTINATION_COVERED)
        self.assertIsInstance(caught.exception, tdsp.NoWay)
        arrivals = solver.arrivals([[0.0, 70.0], [9.0, 200.0]])
        self.assertEqual(arrivals.status.tolist(), [[0, 2], [0, 1]])
        self.assertEqual(arrivals.arrival.tolist(), [[20.0, math.inf], [29.0, math.inf]])
        with self.assertRaises(tdsp.ArrivalTooEarly):
            solver.latest_departure(5.0)
        self.assertEqual(solver.latest_departures([5.0]).departure.tolist(), [-math.inf])

    def test_mistakes_are_value_errors_that_say_about_what(self) -> None:
        solver = gate().solver()
        for ask, about in [(lambda: solver.arrival(-1.0), "departure -1.0: "), (lambda: solver.arrivals([0.0, math.nan]), r"departures\[1\] nan: "),
                           (lambda: solver.latest_departure(-3.0), "arrival -3.0: "), (lambda: solver.arrival_within(0.0, 2.0), "departure 0.0 within 2.0: "),
                           (lambda: solver.arrivals("soon"), "departures: must be numbers"), (lambda: tdsp.Solver(gate(), "magic"), "method: one of auto, "),
                           (lambda: solver.arrival(0.0, ends=((0, 0, 0), (1, 1))), "ends: source: a point has exactly two numbers")]:
            with self.subTest(about), self.assertRaisesRegex(tdsp.UsageError, about) as caught:
                ask()
            self.assertIsInstance(caught.exception, ValueError)

    def test_across_a_jump_the_latest_departure_is_the_gap_s(self) -> None:
        solver = gate().solver()
        departure, arrives, status = solver.latest_departures([30.35, 33.0, math.inf])
        np.testing.assert_allclose(departure[:2], LAST_THROUGH)
        np.testing.assert_allclose(arrives[:2], LAST_THROUGH + 20)
        self.assertEqual(status.tolist(), [0, 0, 0])
        last = solver.last_departure()
        self.assertAlmostEqual(departure[2], last.departure)
        self.assertEqual((last.reason, last.disc), (Status.DESTINATION_COVERED, 0))
        self.assertAlmostEqual(solver.path_to_arrive(33.0).arrival, LAST_THROUGH + 20)
        gap = solver.gap(solver.latest_departure(33.0))
        self.assertEqual((gap.first, gap.second), (0, 1))  # type: ignore[union-attr]
        self.assertIsNone(solver.gap(1.0))

    def test_where_nothing_ends_the_departures_the_last_is_infinite(self) -> None:
        solver = tdsp.Scene(1.0, (0, 0), (10, 0)).solver()
        self.assertEqual(solver.latest_departure(math.inf), math.inf)
        with self.assertRaises(tdsp.NoAnswer):
            solver.path_to_arrive(math.inf)
        self.assertEqual(solver.last_departure().reason, Status.OK)

    def test_other_ends_are_asked_about_for_once_or_from_now_on(self) -> None:
        solver, ends = gate().solver(), ((-10, 1), (10, 1))
        once = solver.arrival(9.9, ends=ends)
        self.assertEqual(solver.ends, ((-10, 0), (10, 0)))
        solver.ends = ends  # type: ignore[assignment]
        self.assertEqual(solver.arrival(9.9), once)
        self.assertAlmostEqual(solver.path(9.9).arrival, once)
        self.assertTrue(solver.path(9.9).verify(solver.scene, ends))
        self.assertAlmostEqual(solver.latest_departure(once, ends=ends), 9.9)
        solver.ends = None  # type: ignore[assignment]
        self.assertEqual(solver.ends.source, (-10, 0))

    def test_many_destinations_and_sources_answer_as_one_by_one(self) -> None:
        solver = crowd(5).solver()
        places = np.array([[10, y] for y in range(-5, 6)] + [[-10, 0]], dtype=float)
        together = solver.arrivals_to(places, 3.0)
        alone = [solver.arrivals([3.0], ends=(solver.ends.source, place)) for place in places]
        np.testing.assert_allclose(together.arrival, [one.arrival[0] for one in alone], rtol=1e-10)
        self.assertEqual(together.status.tolist(), [one.status[0] for one in alone])
        back = solver.departures_from(places, 30.0, destination=(10, 0))
        alone_back = [solver.latest_departures([30.0], ends=(place, (10, 0))) for place in places]
        np.testing.assert_allclose(back.departure, [one.departure[0] for one in alone_back], rtol=1e-9)
        self.assertEqual(back.status.tolist(), [one.status[0] for one in alone_back])
        self.assertEqual(len(solver.arrivals_to([], 3.0).arrival), 0)

    def test_within_a_share_is_within_it(self) -> None:
        for seed in range(10):
            solver = crowd(seed).solver()
            if solver.arrivals([0.0]).status[0] != Status.OK:
                continue
            within, exact = solver.arrival_within(0.0, 0.1), solver.arrival(0.0)
            self.assertLessEqual(within.lower, exact + 1e-9)
            self.assertLessEqual(within.arrival, 1.1 * within.lower + 1e-9)
            self.assertAlmostEqual(solver.path_within(0.0, 0.1).arrival, within.arrival)

    def test_methods_agree(self) -> None:
        times = np.linspace(0, 20, 11)
        answers = {method: tdsp.Solver(gate(), method).arrivals(times).arrival for method in ("auto", "same_speed", "different_speeds", "general")}
        for answer in answers.values():
            np.testing.assert_allclose(answer, answers["auto"], rtol=1e-9)
        self.assertEqual(gate().solver("general").method, "general")
        with self.assertRaises(tdsp.NotSupported):
            gate(growth=[0.1, 0.2]).solver("same_speed")

    def test_deadlines_and_slack_name_what_limits_them(self) -> None:
        solver = gate().solver()
        deadline = solver.deadline(33.0)
        self.assertAlmostEqual(deadline.departure, LAST_THROUGH)
        self.assertEqual(deadline.witness.limit, tdsp.Limit.GAP)
        slack = solver.slack(5.0, 30.0)
        self.assertAlmostEqual(slack.early, 5.0)
        self.assertAlmostEqual(slack.later, LAST_THROUGH - 5)
        late = solver.slack(5.0, 1.0)
        self.assertIsNone(late.latest)
        self.assertEqual(late.latest_status, Status.ARRIVAL_TOO_EARLY)

    def test_jumps_and_pieces_are_found(self) -> None:
        scene = tdsp.Scene.load(SCENES / "fire-oregon-c.json")
        seen: list[tuple[float, float]] = []
        jumps = scene.solver().jumps(least=100.0, progress=lambda settled, last: seen.append((settled, last)))
        self.assertEqual([jump.gap is not None for jump in jumps], [True] * len(jumps))
        self.assertAlmostEqual(jumps[0].departure, 52.5001, places=3)
        self.assertTrue(seen)
        envelope = gate().solver().envelope(until=20.0)
        self.assertEqual(len(envelope), len(envelope.pieces))
        self.assertEqual(envelope.pieces[0].rides, ())
        self.assertEqual(envelope.pieces[0].change, tdsp.Change.JUMP)
        self.assertGreater(envelope.resolution, 0)

    def test_a_look_at_the_shape_can_be_cancelled_and_what_progress_raises_comes_out(self) -> None:
        with self.assertRaises(tdsp.Cancelled):
            gate().solver().jumps(progress=lambda *_: True)
        with self.assertRaises(ZeroDivisionError):
            gate().solver().envelope(progress=lambda *_: 1 / 0)

    def test_a_solver_counts_its_work(self) -> None:
        solver = gate().solver()
        solver.arrivals([0.0, 1.0, 2.0])
        self.assertGreaterEqual(solver.work.forward_searches, 3)
        self.assertGreater(solver.work.bytes, 0)

    def test_a_question_beyond_what_shrinks_is_refused(self) -> None:
        scene = gate(growth=[[0.5, -0.01], [0.1]])
        self.assertEqual(scene.valid_until(), (25.0, 0))
        with self.assertRaises(tdsp.Shrinks):
            scene.solver().arrival(20.0)
