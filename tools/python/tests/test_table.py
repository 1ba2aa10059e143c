# SPDX-License-Identifier: MIT
"""Tables: built, saved, opened in place, asked, and freed when nobody looks any more."""
from __future__ import annotations

import gc
import os
import pathlib
import pickle
import signal
import subprocess
import tempfile
import threading
import unittest
import weakref

import numpy as np
from support import SCENES, command_environment, crowd, gate

import tdsp
from tdsp import Status


class TableTest(unittest.TestCase):
    def test_the_command_builds_the_same_bytes(self) -> None:
        command = os.environ.get("TDSP")
        if command is None:
            self.skipTest("TDSP does not name the command")
        for name, options in [("two-discs.json", []), ("fire-oregon-c.json", ["--guarantee", "arrival", "--epsilon", "0.05"])]:
            with tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder) / "table.tdsp"
                subprocess.run([command, "build", SCENES / name, "-o", file, *options], check=True, capture_output=True,
                               env=command_environment())
                built = tdsp.Scene.load(SCENES / name).build(**({"guarantee": "arrival", "epsilon": 0.05} if options else {}))
                self.assertEqual(bytes(built), file.read_bytes())

    def test_the_exact_arrival_lies_in_every_interval(self) -> None:
        for seed in range(12):
            scene = crowd(seed)
            if scene.solver().arrivals([0.0]).status[0] != Status.OK:
                continue
            table = scene.build(epsilon=0.05)
            self.assertTrue(table.verify(scene))
            times = np.linspace(0, table.info.last_departure * 0.999, 40)
            lower, upper, status = table.arrivals(times)
            exact = scene.solver().arrivals(times).arrival
            self.assertTrue((status == 0).all())
            self.assertTrue((lower <= exact + 1e-9).all() and (exact <= upper + 1e-9).all())
            self.assertTrue((upper - times <= 1.05 * (lower - times) + 1e-9).all())
            safe, none, status = table.departures(upper)
            self.assertTrue((safe >= times - 1e-9).all() and (none >= safe).all())

    def test_floats_contain_what_doubles_say(self) -> None:
        table = gate().build(epsilon=0.01)
        for departure in np.linspace(0, table.info.last_departure * 0.999, 50).astype(np.float32):
            exact, rounded = table.arrival(float(departure)), table.arrival_float(float(departure))
            self.assertTrue(rounded.lower <= exact.lower and exact.upper <= rounded.upper)
            self.assertAlmostEqual(rounded.upper - rounded.lower, exact.upper - exact.lower, delta=2e-5)
        with self.assertRaises(tdsp.NoWay):
            table.arrival_float(1e9)

    def test_bytes_accepted_before_are_opened_without_being_checked(self) -> None:
        stored = bytearray(bytes(gate().build(epsilon=0.01)))
        self.assertEqual(tdsp.Table(stored, accepted=True).arrival(5.0), tdsp.Table(stored).arrival(5.0))
        stored[24] ^= 1
        with self.assertRaises(tdsp.BadChecksum):
            tdsp.Table(stored)
        self.assertEqual(len(tdsp.Table(stored, accepted=True)), len(gate().build(epsilon=0.01)))
        with self.assertRaises(tdsp.BadLength):
            tdsp.Table(stored[:-8], accepted=True)

    def test_threads_and_workers_change_no_byte(self) -> None:
        scene = tdsp.Scene.load(SCENES / "fire-oregon-c.json")
        table = scene.build()
        self.assertEqual(bytes(scene.build(threads=3)), bytes(table))
        self.assertEqual(bytes(tdsp.build(scene.solver())), bytes(table))
        self.assertEqual(bytes(tdsp.build([scene.solver().oracle(), scene.solver().oracle()], about=tdsp.About(
            scene.hash(), scene.speed, scene.source, scene.destination, "m", "s"))), bytes(table))
        self.assertEqual(table.report.rows, len(table))  # type: ignore[union-attr]

    def test_guarantees_are_kept(self) -> None:
        scene = gate()
        for options in [{"guarantee": "absolute", "delta": 0.5}, {"guarantee": "arrival", "epsilon": 0.1}, {"guarantee": "arrival", "sampling": "geometric"},
                        {"oracle_share": 0.0}, {"horizon": 5.0}]:
            table = scene.build(**options)
            self.assertTrue(table.verify(scene), options)
        self.assertEqual(scene.build(horizon=5.0).info.last_reason, Status.HORIZON)
        with self.assertRaises(tdsp.AfterHorizon):
            scene.build(horizon=5.0).arrival(6.0)

    def test_other_ends_make_another_table(self) -> None:
        scene, ends = gate(), ((-10, 1), (10, 1))
        table = scene.build(ends=ends)
        self.assertEqual((table.info.source, table.info.scene_hash), ((-10, 1), scene.hash(ends)))
        self.assertTrue(table.verify(scene, ends))
        self.assertTrue(table.verify(scene).stale)
        with self.assertRaisesRegex(tdsp.InvalidArgument, "ends: go with a scene"):
            tdsp.build(scene.solver(), ends=ends)

    def test_what_cannot_be_built_says_why(self) -> None:
        for world, options, error, message in [
                (gate(), {"epsilon": 7.0}, tdsp.InvalidArgument, "table: "), (gate(), {"guarantee": "best"}, tdsp.InvalidArgument, "guarantee: one of travel, arrival"),
                (gate(), {"max_rows": 2}, tdsp.TooManyRows, "table: "), (tdsp.Scene(1.0, (0, 0), (5, 0)), {}, tdsp.NeedsHorizon, "table: "),
                (tdsp.Scene(1.0, (0, 0), (5, 0), [(0, 0)], 1.0), {}, tdsp.SourceCovered, "table: The source"), (gate(), {"threads": 0}, tdsp.InvalidArgument, "threads"),
                (gate(length_unit="x" * 16), {}, tdsp.InvalidArgument, "length_unit"), ([], {}, tdsp.InvalidArgument, "world: no oracle")]:
            with self.subTest(message), self.assertRaisesRegex(error, message):
                tdsp.build(world, **options)

    def test_a_file_appears_whole_and_is_read_in_place(self) -> None:
        table = gate().build()
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "gate.tdsp"
            table.save(file)
            table.save(file)
            self.assertEqual([path.name for path in pathlib.Path(folder).iterdir()], ["gate.tdsp"])
            with tdsp.Table.open(file) as opened:
                self.assertEqual(opened.arrival(5.0), table.arrival(5.0))
                shown = opened.buffer
            for ask in (lambda: opened.arrival(5.0), lambda: opened.info, lambda: len(opened), lambda: opened.buffer):
                with self.assertRaisesRegex(ValueError, "this table is closed"):
                    ask()
            self.assertEqual(repr(opened), "<tdsp.Table: closed>")
            self.assertEqual(shown, bytes(table))
            file.write_bytes(b"")
            with self.assertRaisesRegex(tdsp.BadMagic, "gate.tdsp: "):
                tdsp.Table.open(file)
            with self.assertRaises(FileNotFoundError):
                tdsp.Table.open(pathlib.Path(folder) / "none.tdsp")
            with self.assertRaises(OSError):
                table.save(pathlib.Path(folder) / "none" / "table.tdsp")
            self.assertEqual([path.name for path in pathlib.Path(folder).iterdir()], ["gate.tdsp"])

    def test_any_buffer_at_any_address_will_do(self) -> None:
        data = bytes(gate().build())
        for buffer in (data, bytearray(data), memoryview(b"x" + data)[1:], np.frombuffer(data, np.uint8)):
            self.assertEqual(bytes(tdsp.Table(buffer)), data)
        self.assertEqual(pickle.loads(pickle.dumps(tdsp.Table(data))).buffer, data)
        with self.assertRaises(tdsp.InvalidArgument):
            tdsp.Table(memoryview(data)[::2])
        with self.assertRaises(TypeError):
            tdsp.Table(5)

    def test_arrays_in_order_are_not_copied_and_others_are(self) -> None:
        table = gate().build()
        times = np.linspace(0, 9, 100)
        lower, upper = np.empty(100), np.empty(100)
        out = table.arrivals(times, out=(lower, upper))
        self.assertIs(out.lower, lower)
        np.testing.assert_array_equal(table.arrivals(times[::-1]).upper, upper[::-1])
        np.testing.assert_array_equal(table.arrivals(np.array([0, 9], np.float32)).upper, table.arrivals([0.0, 9.0]).upper)
        self.assertEqual(table.arrivals(times.reshape(4, 25)).lower.shape, (4, 25))
        self.assertEqual(table.arrivals(3.0).lower.shape, ())
        self.assertEqual(table.arrivals([]).lower.shape, (0,))
        for wrong in ((lower, lower), (times, upper), (lower[:5], upper[:5]), (lower.astype(np.float32), upper)):
            with self.assertRaisesRegex(tdsp.InvalidArgument, "out: "):
                table.arrivals(times, out=wrong)

    def test_rows_paths_and_jumps(self) -> None:
        table = gate().build()
        rows = table.rows()
        self.assertTrue((np.diff(rows["departure"]) > 0).all())
        self.assertEqual(tuple(rows[3]), tuple(table.row(3)))
        self.assertEqual(table.row_at(rows["departure"][3]), 3)
        self.assertEqual(table.row_path(3).departure, rows["departure"][3])
        self.assertEqual(len(table.row_path(3)), rows["legs"][3])
        [jump] = table.jumps()
        self.assertEqual((jump.gap.first, jump.gap.second), (0, 1))  # type: ignore[union-attr]
        self.assertEqual(table.previous_jump(50.0), jump)
        self.assertIsNone(table.next_jump(50.0))
        path = table.path(12.0)
        self.assertLessEqual(path.arrival, table.arrival(12.0).upper)
        self.assertEqual(table.position(12.0, 20.0), path.position(20.0))
        np.testing.assert_array_equal(table.positions(12.0, [20.0, 21.0]), path.positions([20.0, 21.0]))
        for ask in (lambda: table.row(-1), lambda: table.row(10**6), lambda: table.leg(5.0, -1), lambda: table.row_path(10**6)):
            with self.assertRaises(tdsp.InvalidArgument):
                ask()
        with self.assertRaises(tdsp.NoAnswer):
            table.leg(5.0, 999)


class LifetimeTest(unittest.TestCase):
    def test_built_bytes_live_as_long_as_anything_shows_them(self) -> None:
        table = gate().build()
        shown, data = table.buffer, bytes(table)
        rest = weakref.ref(table)
        del table
        gc.collect()
        self.assertIsNone(rest())
        np.zeros(len(data))
        self.assertEqual(shown, data)

    def test_a_matrix_s_tables_outlive_it(self) -> None:
        matrix = tdsp.build_matrix(gate(), [(-10, 0)], [(10, 0)])
        table = matrix[0, 0]
        matrix.close()
        del matrix
        gc.collect()
        self.assertEqual(bytes(table), bytes(gate().build()))

    def test_a_solver_keeps_its_scene_and_discs_keep_theirs(self) -> None:
        solver, discs = gate().solver(), gate().discs
        gc.collect()
        self.assertEqual(solver.arrival(0.0), 20.0)
        self.assertEqual(discs["radius"].tolist(), [1.0, 1.0])

    def test_a_scene_and_its_solver_in_a_circle_are_freed_in_order(self) -> None:
        # The collector finalizes what refers to itself in any order: once, a scene was freed before the solver on it.
        for _ in range(200):
            solver = gate().solver()
            circle = [solver, solver.scene]
            circle.append(circle)  # type: ignore[arg-type]
            del solver, circle
        gc.collect()


class LeakTest(unittest.TestCase):
    def test_ten_thousand_scenes_leave_nothing_behind(self) -> None:
        def resident() -> int:
            gc.collect()
            return int(pathlib.Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")

        def work(count: int) -> None:
            for _ in range(count):
                scene = gate()
                scene.solver().path(5.0)
                tdsp.Table(data).arrivals([1.0, 2.0])

        data = bytes(gate().build())
        work(2000)
        before = resident()
        work(8000)
        self.assertLess(resident() - before, 2_000_000)


class ThreadTest(unittest.TestCase):
    def test_threads_may_share_a_table_and_a_solver(self) -> None:
        scene = tdsp.Scene.load(SCENES / "fire-oregon-c.json")
        solver, table, times = scene.solver(), scene.build(), np.linspace(0, 5000, 24)
        expected, found = solver.arrivals(times).arrival, {}

        def ask(worker: int) -> None:
            one_by_one = [solver.arrivals([time]).arrival[0] for time in times]
            inside = [table.arrivals([time]).lower[0] <= exact for time, exact in zip(times, one_by_one)]
            found[worker] = one_by_one == expected.tolist() and all(inside)

        threads = [threading.Thread(target=ask, args=(worker,)) for worker in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, {worker: True for worker in range(4)})

    def test_a_question_lets_other_threads_go_on(self) -> None:
        times, table = np.random.default_rng(1).uniform(0, 60, 2_000_000), gate().build()
        counted, done = [0], threading.Event()

        def meanwhile() -> int:
            before = counted[0]
            table.arrivals(times)
            return counted[0] - before

        def count() -> None:
            while not done.is_set():
                counted[0] += 1
                done.wait(0.0005)

        other = threading.Thread(target=count)
        other.start()
        # With the lock held, the other thread counts once before and once after, however often this is tried.
        most = 0
        for _ in range(20):
            most = most if most > 3 else meanwhile()
        done.set()
        other.join()
        self.assertGreater(most, 3)

    def test_a_solver_asked_inside_its_own_callback_says_so(self) -> None:
        solver = gate().solver()
        with self.assertRaisesRegex(RuntimeError, "in the middle of an answer"):
            solver.jumps(progress=lambda *_: bool(solver.arrival(0.0)))
        self.assertEqual(solver.arrival(0.0), 20.0)

    def test_progress_is_told_cancels_and_raises(self) -> None:
        told: list[tuple[float, float]] = []
        gate().build(progress=lambda settled, last: told.append((settled, last)))
        self.assertEqual(sorted(settled for settled, _ in told), [settled for settled, _ in told])
        self.assertAlmostEqual(told[-1][1], 60.3085, places=3)
        for threads in (1, 2):
            with self.assertRaises(tdsp.Cancelled):
                gate().build(threads=threads, progress=lambda *_: True)
            with self.assertRaisesRegex(ZeroDivisionError, "division"):
                gate().build(threads=threads, progress=lambda *_: 1 / 0)

    def test_ctrl_c_stops_a_build(self) -> None:
        for threads in (1, 2):
            with self.assertRaises(KeyboardInterrupt):
                gate().build(threads=threads, epsilon=1e-6, progress=lambda *_: signal.raise_signal(signal.SIGINT))
            self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
