# SPDX-License-Identifier: MIT
"""Batches: every item once, whatever is killed; bad items are rows; what is done is never done again."""
from __future__ import annotations

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from collections import Counter
from typing import Any, Callable, Optional

import dask
from distributed import Client, KilledWorker, LocalCluster, WorkerPlugin
from distributed.client import FutureCancelledError
from support import SCENES, crowd

import tdsp
from tdsp import batch
from tdsp.batch.run import Outcome, _Batch
from tdsp.batch.work import items_file


def cluster(workers: int = 2) -> Client:
    return Client(LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None, silence_logs=50), set_as_default=False)


def close(client: Client) -> None:
    inside = client.cluster
    client.close()
    inside.close()


def wait_for(happened: Callable[[], bool], seconds: float = 120.0) -> None:
    end = time.monotonic() + seconds
    while not happened():
        if time.monotonic() > end:
            raise AssertionError("it did not happen in time")
        time.sleep(0.02)


class Deadly(WorkerPlugin):
    """A machine on which a scene of a certain name ends the process."""

    def setup(self, worker: Any) -> None:
        load = tdsp.Scene.load

        def deadly(path: Any) -> tdsp.Scene:
            if "deadly" in str(path):
                os._exit(1)
            return load(path)

        tdsp.Scene.load = deadly  # type: ignore[assignment, method-assign]


class FullDisc(WorkerPlugin):
    """A machine whose disc is full, so many times."""

    def __init__(self, times: int) -> None:
        self.times = times

    def setup(self, worker: Any) -> None:
        from tdsp.batch import work
        commit, left = work.commit, [self.times]

        def full(*arguments: Any) -> Any:
            if left[0] > 0:
                left[0] -= 1
                raise OSError(28, "No space left on device")
            return commit(*arguments)

        work.commit = full


class Answer:
    """A stand-in for a future that seems to have ended well, until its result is asked for."""

    status, key = "finished", "work"

    def __init__(self, result: object) -> None:
        self._result = result

    def exception(self) -> None:
        """It seems that there is none."""

    def result(self) -> object:
        if isinstance(self._result, BaseException):
            raise self._result
        return self._result


class Answers:
    """A stand-in for a cluster: works here, except where it is told an end that a task has."""

    def __init__(self, ends: list[Optional[BaseException]]) -> None:
        self.ends = ends

    def submit(self, work: Callable[..., object], *arguments: Any, pure: bool, retries: int) -> Answer:
        end = self.ends.pop(0)
        return Answer(work(*arguments) if end is None else end)


CANCELLED = FutureCancelledError("work", "somebody's wish")
KILLED = KilledWorker("work", None, 4)


class BatchTest(unittest.TestCase):
    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.place = pathlib.Path(folder.name)
        self.out = self.place / "out"

    def scenes(self, count: int, discs: int = 12) -> pathlib.Path:
        folder = self.place / "scenes"
        folder.mkdir()
        for seed in range(count):
            crowd(seed, discs).save(folder / f"crowd-{seed:04d}.json")
        return folder

    def command(self, *arguments: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, "-m", "tdsp.batch", *map(str, arguments)], capture_output=True, text=True, timeout=300)

    def parts(self) -> dict[str, tuple[int, int]]:
        """What is done: inode and time of change of each part's files, and of its tables."""
        return {str(path): (path.stat().st_ino, path.stat().st_mtime_ns)
                for path in [*self.out.glob("items/part-*"), *self.out.glob("answers/part-*"), *self.out.glob("tables/*/*.tdsp")]}

    def assert_whole(self, count: int, questions: int) -> None:
        """Each item and each answer is there once, each table can be read, and nothing else is there."""
        items = batch.items(self.out).to_table().to_pylist()
        self.assertEqual(sorted(row["item"] for row in items), list(range(count)))
        answers = batch.answers(self.out).to_table().to_pylist()
        self.assertEqual(Counter(row["item"] for row in answers), Counter({item: questions for item in range(count)} if questions else {}))
        tables = {row["table"] for row in items if row["table"]}
        self.assertEqual(tables, {str(path.relative_to(self.out)) for path in self.out.glob("tables/*/*")})
        for row in items:
            if row["table"]:
                with tdsp.Table.open(self.out / row["table"]) as table:
                    self.assertEqual((table.info.scene_hash, len(table)), (row["scene_hash"], row["rows"]))
        self.assertEqual([path for path in self.out.rglob(".tdsp-*")], [])

    def test_the_rows_are_what_a_solver_answers_and_bad_scenes_are_rows(self) -> None:
        folder = self.scenes(10)
        (folder / "broken.json").write_text("{")
        (folder / "shrinks.json").write_text(json.dumps({"robot": {"speed": 1}, "source": [0, 0], "destination": [9, 0],
                                                         "discs": [{"center": [5, 1], "radius": 1, "growth": [-1]}]}))
        lines = [json.dumps(crowd(seed).to_dict()) for seed in (1, 2)]
        (self.place / "more.jsonl").write_text("\n".join([lines[0], "", "[]", lines[1]]) + "\n")
        done = self.command("scenes", folder, self.place / "more.jsonl", self.place / "none.json", "-o", self.out, "--departures", "0,3", "--arrivals",
                            "30,inf", "--tables", "--workers", 2, "--part", 3, "--json")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(json.loads(done.stdout)["errors"], 4)
        self.assert_whole(16, 4)
        items = {row["name"]: row for row in batch.items(self.out).to_table().to_pylist()}
        self.assertIn("broken.json: line 1, column 2", items["broken"]["error"])
        self.assertEqual(items["shrinks"]["status"], "bad_scene")
        self.assertEqual(items["more-3"]["error"], "more-3: must be an object, not an array")
        self.assertIn("No such file", items["none"]["error"])
        for row in batch.answers(self.out).to_table().to_pylist():
            if not row["name"].startswith("crowd"):
                continue
            solver = crowd(int(row["name"][-4:])).solver()
            if row["question"] == "arrive":
                arrival, status = solver.arrivals([row["departure"]])
                self.assertEqual((row["arrival"], row["status"]), (arrival[0] if status[0] == 0 else None, tdsp.status_name(status[0])))
            else:
                departure, _, status = solver.latest_departures([row["arrival"]])
                self.assertEqual((row["departure"], row["status"]), (departure[0] if status[0] == 0 else None, tdsp.status_name(status[0])))
        status = self.command("status", self.out, "--json")
        self.assertEqual(json.loads(status.stdout), {"items": 16, "of": 16, "parts": 6, "of_parts": 6, "errors": 4})

    def test_pairs_share_a_scene_and_a_search(self) -> None:
        scene = crowd(5)
        scene.save(self.place / "scene.json")
        (self.place / "from").write_text("# gates\n-10,0,gate\n-9 -7 back gate\n")
        (self.place / "to").write_text("".join(f"10,{y}\n" for y in range(-3, 4)) + "1e50,0,far\n")
        done = self.command("pairs", self.place / "scene.json", "--sources", self.place / "from", "--destinations", self.place / "to", "-o", self.out,
                            "--departures", "0,4", "--tables", "--epsilon", 0.1, "--workers", 2, "--part", 5)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assert_whole(16, 2)
        plan = batch.Plan.load(self.out)
        for row in batch.answers(self.out).to_table().to_pylist():
            if row["name"].endswith("far"):
                self.assertEqual((row["arrival"], row["status"]), (None, "not_supported"))
                continue
            arrival, status = scene.solver().arrivals([row["departure"]], ends=plan.items[row["item"]].ends)
            self.assertEqual(row["status"], tdsp.status_name(status[0]))
            if row["arrival"] is not None:
                self.assertAlmostEqual(row["arrival"], arrival[0], places=9)
        names = [row["name"] for row in batch.items(self.out).to_table().to_pylist()]
        self.assertEqual((names[0], names[8]), ("gate-0", "back gate-0"))

    def test_a_worker_killed_half_way_loses_nothing(self) -> None:
        plan = batch.Plan.make(batch.read_scenes([self.scenes(60)]), batch.Questions((0.0, 3.0), tables=True), 2)
        client, kept, killed = cluster(), {}, []

        def kill(done: int, all: int, errors: int) -> None:
            if done >= 20 and not killed:
                killed.append(next(iter(client.run(os.getpid).values())))
                os.kill(killed[0], signal.SIGKILL)
                kept.update({name: value for name, value in self.parts().items() if "/items/" in name})

        try:
            outcome = batch.run(plan, self.out, client, progress=kill)
        finally:
            close(client)
        self.assertEqual((outcome.items, outcome.errors, outcome.unfinished), (60, 0, {}))
        # Parts that the dead worker wrote and could not tell of any more were found by whoever got them next: outcome.found.
        self.assertTrue(killed and kept)
        self.assert_whole(60, 2)
        after = self.parts()
        self.assertEqual({name: after[name] for name in kept}, kept)

    def test_all_of_it_killed_and_begun_again_does_nothing_twice(self) -> None:
        arguments = ["scenes", self.scenes(60), "-o", self.out, "--departures", "0", "--tables", "--epsilon", "0.005", "--workers", 2, "--part", 2]
        first = subprocess.Popen([sys.executable, "-m", "tdsp.batch", *map(str, arguments)], start_new_session=True, stderr=subprocess.DEVNULL)
        wait_for(lambda: len(list(self.out.glob("items/part-*"))) >= 6)
        os.killpg(first.pid, signal.SIGKILL)
        first.wait()
        kept = self.parts()
        kept = {name: value for name, value in kept.items() if any(pathlib.Path(name).parts[-1 - deep].startswith(part) for deep in (0, 1) for part in
                                                                  [path.stem for path in self.out.glob("items/part-*.parquet")])}
        self.assertLess(len(list(self.out.glob("items/part-*"))), 30, "the batch was over before it was killed")
        done = self.command(*arguments, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreaterEqual(json.loads(done.stdout)["found"], 6)
        self.assert_whole(60, 1)
        after = self.parts()
        self.assertEqual({name: after[name] for name in kept}, kept)

    def test_an_item_that_kills_its_workers_becomes_a_row(self) -> None:
        folder = self.scenes(5)
        (folder / "crowd-0002-deadly.json").write_text("{}")
        plan = batch.Plan.make(batch.read_scenes([folder]), batch.Questions((0.0,)), 3)
        with dask.config.set({"distributed.scheduler.allowed-failures": 1}):
            client = cluster()
            try:
                client.register_plugin(Deadly())
                outcome = batch.run(plan, self.out, client)
            finally:
                close(client)
        self.assertEqual((outcome.items, outcome.errors, outcome.unfinished), (6, 1, {}))
        self.assert_whole(6, 1)
        [row] = [row for row in batch.items(self.out).to_table().to_pylist() if row["status"] != "ok"]
        self.assertEqual((row["name"], row["error"]), ("crowd-0002-deadly", "the worker died 2 times over it"))

    def settled(self, ends: list[Optional[BaseException]], retries: int = 1) -> tuple[list[Optional[int]], Outcome]:
        """A batch of one part of three items, by a cluster whose tasks end so: what is to be handed out again each time, and the outcome."""
        plan = batch.Plan.make(batch.read_scenes([self.scenes(3)]), batch.Questions((0.0,)), 3)
        alone = _Batch(plan, str(self.out), Answers(ends), retries, None)  # type: ignore[arg-type]
        again = []
        while ends:
            again.append(alone._settle(alone._submit(0)))
        return again, alone.outcome

    def test_a_result_lost_with_its_worker_is_worked_out_again(self) -> None:
        plan = batch.Plan.make(batch.read_scenes([self.scenes(3)]), batch.Questions((0.0,)), 3)
        for kept in (True, False):
            client = cluster(1)
            try:
                alone = _Batch(plan, str(self.out), client, 3, None)
                future = alone._submit(0)
                wait_for(lambda: future.status == "finished")
                if not kept:
                    items_file(str(self.out), 0).unlink()
                [worker] = client.run(os.getpid).values()
                os.kill(worker, signal.SIGKILL)
                wait_for(lambda: future.status == "lost")
                self.assertIsNone(alone._settle(future))
            finally:
                close(client)
            self.assertEqual((alone.outcome.items, alone.outcome.found, alone.outcome.unfinished), (3, int(kept), {}))
            self.assert_whole(3, 1)

    def test_a_result_lost_while_it_is_fetched_may_end_with_dead_workers(self) -> None:
        again, outcome = self.settled([KILLED, None, KILLED, None])
        self.assertEqual((again, outcome.items, outcome.errors, outcome.unfinished), ([None], 3, 1, {}))
        self.assert_whole(3, 1)

    def test_a_part_that_is_cancelled_is_handed_out_again(self) -> None:
        again, outcome = self.settled([CANCELLED, None])
        self.assertEqual((again, outcome.items, outcome.unfinished), ([0, None], 3, {}))
        self.assert_whole(3, 1)

    def test_a_part_is_handed_out_again_when_one_of_its_items_is_cancelled(self) -> None:
        again, outcome = self.settled([KILLED, None, CANCELLED, KILLED, None, None, KILLED])
        self.assertEqual((again, outcome.items, outcome.errors, outcome.unfinished), ([0, None], 3, 1, {}))
        self.assert_whole(3, 1)

    def test_a_part_that_is_cancelled_over_and_over_stays_undone_and_says_why(self) -> None:
        again, outcome = self.settled([CANCELLED, KILLED, None, CANCELLED])
        self.assertEqual((again, outcome.items), ([0, None], 0))
        self.assertEqual(outcome.unfinished, {0: "FutureCancelledError: work cancelled for reason: somebody's wish."})

    def test_an_item_for_which_the_machine_fails_leaves_its_part_undone(self) -> None:
        again, outcome = self.settled([KILLED, None, OSError(28, "No space left on device")])
        self.assertEqual((again, outcome.items, outcome.unfinished), ([None], 0, {0: "OSError: [Errno 28] No space left on device"}))

    def test_a_machine_that_fails_is_tried_again_and_makes_no_row(self) -> None:
        plan = batch.Plan.make(batch.read_scenes([self.scenes(4)]), batch.Questions((0.0,)), 2)
        for times, unfinished in [(1000, 2), (2, 0)]:
            client = cluster(1)
            try:
                client.register_plugin(FullDisc(times))
                outcome = batch.run(plan, self.out, client, retries=3)
            finally:
                close(client)
            self.assertEqual(len(outcome.unfinished), unfinished)
            for reason in outcome.unfinished.values():
                self.assertIn("No space left", reason)
        self.assert_whole(4, 1)

    def test_workers_without_the_package_are_refused(self) -> None:
        plan = batch.Plan.make(batch.read_scenes([self.scenes(1)]), batch.Questions((0.0,)), 2)
        client = cluster(1)
        try:
            client.run(lambda: __import__("sys").modules.update({"tdsp.batch": None}))
            with self.assertRaisesRegex(tdsp.Failed, "a worker has no tdsp.batch"):
                batch.run(plan, self.out, client)
            client.run(lambda: __import__("sys").modules.pop("tdsp.batch"))
            client.run(lambda: setattr(__import__("tdsp"), "version", lambda: "9.9.9"))
            with self.assertRaisesRegex(tdsp.Failed, "workers have tdsp 9.9.9"):
                batch.run(plan, self.out, client)
        finally:
            close(client)

    def test_a_folder_is_one_batch_s(self) -> None:
        folder = self.scenes(2)
        ask = ["scenes", folder, "-o", self.out, "--workers", 1]
        self.assertEqual(self.command(*ask, "--departures", "0").returncode, 0)
        for arguments, message in [([*ask, "--departures", "1"], "other questions"), ([*ask, "--departures", "0", "--part", 1], "parts of another size")]:
            done = self.command(*arguments)
            self.assertEqual(done.returncode, 3)
            self.assertIn(message, done.stderr)
        crowd(9).save(folder / "crowd-0000.json")
        done = self.command(*ask, "--departures", "0")
        self.assertEqual(done.returncode, 3)
        self.assertIn("files that have changed since", done.stderr)
        done = self.command("scenes", folder, "-o", folder, "--departures", "0", "--workers", 1)
        self.assertEqual(done.returncode, 3)
        self.assertIn("neither empty nor the folder of a batch", done.stderr)
        with open(self.out / ".lock", "w") as lock:
            import fcntl
            fcntl.flock(lock, fcntl.LOCK_EX)
            done = self.command("resume", self.out, "--workers", 1)
        self.assertEqual(done.returncode, 3)
        self.assertIn("another run is at work", done.stderr)

    def test_what_is_asked_wrongly_is_said_before_anything_is_begun(self) -> None:
        scene = SCENES / "two-discs.json"
        (self.place / "bad").write_text("1,2\n3,four\n")
        (self.place / "empty").write_text("# nothing\n")
        out = ["-o", self.out]
        for arguments, code, message in [
                (["scenes", scene, *out], 2, "departures, arrivals or tables must be asked for"), (["scenes", scene, *out, "--departures", "-1"], 2, "-1"),
                (["scenes", scene, *out, "--departures", "soon"], 2, "must be numbers"), (["scenes", scene, *out, "--departures", "0", "--part", 0], 2, "part_size"),
                (["scenes", scene, *out, "--departures", "0", "--workers", 0], 2, "--workers is at least 1"),
                (["scenes", self.place / "none", *out, "--departures", "0", "--workers", 1], 1, ""), (["pairs", scene, *out, "--departures", "0"], 2, "--pairs, or --sources"),
                (["pairs", scene, *out, "--departures", "0", "--pairs", self.place / "bad"], 3, "bad: line 1: a pair is four numbers"),
                (["pairs", scene, *out, "--departures", "0", "--sources", self.place / "bad", "--destinations", scene], 3, "bad: line 2: a place is two numbers"),
                (["pairs", scene, *out, "--departures", "0", "--pairs", self.place / "empty"], 3, "empty: no pair"),
                (["pairs", scene, *out, "--departures", "0", "--pairs", self.place / "gone"], 4, "gone"), (["resume", self.place / "gone"], 4, "gone")]:
            with self.subTest(message):
                done = self.command(*arguments)
                self.assertEqual(done.returncode, code, done.stderr)
                self.assertIn(message, done.stderr)
        self.assertTrue(items_file(str(self.out), 0).exists())
