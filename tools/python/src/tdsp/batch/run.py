# SPDX-License-Identifier: MIT
"""Running a batch: which parts are missing, handing them to the cluster, and what to do when workers die."""
from __future__ import annotations

import contextlib
import fcntl
import os
import pathlib
from collections import Counter
from dataclasses import dataclass, field
from typing import Any, Callable, Iterator, Optional

import pyarrow.dataset
from distributed import CancelledError, Client, KilledWorker, as_completed

from .._files import TEMPORARY, PathLike
from .._library import version
from ..errors import Failed
from .plan import BadInput, FILE, Plan
from .work import Done, Rows, commit, found_part, items_file, killed_row, work_items, work_part

#: Told the items done so far, those of all, and those that ended in an error.
Progress = Callable[[int, int, int], object]


@dataclass
class Outcome:
    """What became of a batch. `unfinished` are parts that failed for a reason of the machine's, with it: run the batch again."""

    items: int = 0
    errors: int = 0
    parts: int = 0
    #: Parts that had been done before.
    found: int = 0
    #: Seconds that workers spent on items, in this run.
    seconds: float = 0.0
    unfinished: dict[int, str] = field(default_factory=dict)

    def add(self, done: Done) -> None:
        self.items, self.errors, self.parts = self.items + done.items, self.errors + done.errors, self.parts + 1
        if done.found:
            self.found += 1
        else:
            self.seconds += done.seconds


def run(plan: Plan, folder: PathLike, client: Client, *, retries: int = 3, progress: Optional[Progress] = None) -> Outcome:
    """Run a batch, or go on with it.

    :param folder: where the results go; every worker must see it under this name. A new one, or one of the same plan
    :param client: of the cluster
    :param retries: how often a part that fails is tried again. A worker that dies is another matter: the cluster hands its parts to others, and an
        item over which workers die again and again becomes a row that says so
    :raises BadInput: the folder belongs to another batch, or somebody is at work in it
    :raises Failed: a worker has no tdsp, or another version
    """
    place = pathlib.Path(folder).absolute()
    place.mkdir(parents=True, exist_ok=True)
    _check_workers(client)
    with _locked(place):
        _same_plan(plan, place)
        _sweep(place)
        outcome = _Batch(plan, str(place), client, retries, progress).run()
        # What workers that died in this run left: their parts are done by now, or nobody is at them.
        _sweep(place)
        return outcome


def _check_workers(client: Client) -> None:
    """A worker that cannot read its tasks says so nowhere; so ask first. The function travels as it is: it names nothing that a worker may not have."""
    try:
        found = client.run(lambda: __import__("importlib").import_module("tdsp.batch") and __import__("tdsp").version())
    except ImportError as error:
        raise Failed(f"a worker has no tdsp.batch: {error}") from None
    others = sorted(set(found.values()) - {version()})
    if others:
        raise Failed(f"workers have tdsp {', '.join(others)}, where this is {version()}")


@contextlib.contextmanager
def _locked(place: pathlib.Path) -> Iterator[None]:
    """One run in a folder at a time. The lock goes with the process, however that ends."""
    with open(place / ".lock", "w") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise BadInput(f"{place}: another run is at work in this folder") from None
        yield


def _same_plan(plan: Plan, place: pathlib.Path) -> None:
    if not (place / FILE).exists():
        if any(entry.name != ".lock" for entry in place.iterdir()):
            raise BadInput(f"{place}: neither empty nor the folder of a batch")
        plan.save(place)
        return
    old = Plan.load(place)
    if old.digest == plan.digest:
        return
    differs = [what for what, same in [("other questions", old.questions.to_dict() == plan.questions.to_dict()), ("parts of another size", old.part_size == plan.part_size),
                                       (f"{len(old.items)} items", len(old.items) == len(plan.items))] if not same]
    raise BadInput(f"{place}: the folder of another batch: it has {', '.join(differs) or 'other files, or files that have changed since'}")


def _sweep(place: pathlib.Path) -> None:
    """Remove what killed writers left under temporary names."""
    for folder, _, files in os.walk(place):
        for name in files:
            if name.startswith(TEMPORARY):
                pathlib.Path(folder, name).unlink(missing_ok=True)


class _Batch:
    """One run. Parts are handed out a few for each thread at a time, so that neither this process nor the scheduler holds all of them."""

    AHEAD = 3

    def __init__(self, plan: Plan, folder: str, client: Client, retries: int, progress: Optional[Progress]) -> None:
        self.plan, self.folder, self.client, self.retries, self.progress = plan, folder, client, retries, progress
        self.outcome = Outcome()
        self.names: dict[str, int] = {}
        self.cancelled: Counter[int] = Counter()  # how often each part was

    def run(self) -> Outcome:
        missing = []
        for part in range(self.plan.parts):
            if items_file(self.folder, part).exists():
                self.outcome.add(found_part(self.folder, part))
            else:
                missing.append(part)
        self._tell()
        rest = iter(missing)
        queue = as_completed(loop=self.client.loop)
        for part in self._first(rest):
            queue.add(self._submit(part))
        for future in queue:
            again = self._settle(future)
            following = again if again is not None else next(rest, None)
            if following is not None:
                queue.add(self._submit(following))
        return self.outcome

    def _first(self, rest: Iterator[int]) -> list[int]:
        threads = max(1, sum(self.client.nthreads().values()))
        return [part for _, part in zip(range(self.AHEAD * threads), rest)]

    def _submit(self, part: int) -> Any:
        future = self.client.submit(work_part, self.folder, part, self.plan.part(part), self.plan.questions, pure=False, retries=self.retries)
        self.names[future.key] = part
        return future

    def _settle(self, future: Any) -> Optional[int]:
        """Take what came of a part; the part where it has to be handed out again."""
        part = self.names.pop(future.key)
        try:
            self.outcome.add(self._done(part, future))
        except CancelledError as error:
            self.cancelled[part] += 1
            if self.cancelled[part] <= self.retries:
                return part
            self.outcome.unfinished[part] = _reason(error)
        except Exception as error:
            self.outcome.unfinished[part] = _reason(error)
        self._tell()
        return None

    def _done(self, part: int, future: Any) -> Done:
        """What became of a part. Only `result` tells: by its status a future may have ended, and its worker die before the result is fetched. The cluster
        then does the task again, `result` waits for that, and it may end otherwise."""
        try:
            done: Done = future.result()
            return done
        except KilledWorker:
            return self._one_by_one(part)

    def _one_by_one(self, part: int) -> Done:
        """A part over which workers died: which item is it? Each by itself; the others' rows are kept."""
        rows = Rows([], [])
        for number, item in self.plan.part(part):
            future = self.client.submit(work_items, self.folder, part, [(number, item)], self.plan.questions, pure=False, retries=self.retries)
            try:
                one = future.result()
            except KilledWorker:
                one = killed_row(number, item, self.plan.questions, _attempts())
            rows.answers += one.answers
            rows.items += one.items
        return commit(self.folder, part, rows)

    def _tell(self) -> None:
        if self.progress is not None:
            self.progress(self.outcome.items, len(self.plan.items), self.outcome.errors)


def _reason(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}"


def _attempts() -> int:
    """How often a task's worker may die before the cluster gives it up, the last time included."""
    import dask
    return int(dask.config.get("distributed.scheduler.allowed-failures")) + 1


def _dataset(folder: PathLike, kind: str) -> Any:
    """The files of a kind, of parts that are done."""
    place = pathlib.Path(folder)
    done = sorted(path.name for path in (place / "items").glob("part-*.parquet"))
    from . import work
    schema = {"items": work.ITEMS, "answers": work.ANSWERS}[kind]
    return pyarrow.dataset.dataset([str(place / kind / name) for name in done], schema=schema, format="parquet")


def answers(folder: PathLike) -> Any:
    """The answers of a batch, as far as it is done: a `pyarrow.dataset.Dataset`; `answers(folder).to_table().to_pandas()` is a data frame."""
    return _dataset(folder, "answers")


def items(folder: PathLike) -> Any:
    """The items of a batch, as far as it is done: a `pyarrow.dataset.Dataset`."""
    return _dataset(folder, "items")
