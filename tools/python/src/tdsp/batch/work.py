# SPDX-License-Identifier: MIT
"""What a worker does: the items of one part, their tables, and the two files of rows that say that it is done.

A part is done when its file of items is there. Tables and answers are written before it, each whole or not at all, under names that depend on the part alone:
a part that is begun again writes over what was left, and two workers on the same part write the same.
"""
from __future__ import annotations

import functools
import io
import pathlib
import re
import time
from dataclasses import dataclass
from typing import Any, Optional

import pyarrow
import pyarrow.parquet

from .._files import write_atomically
from ..errors import NoWay, TdspError, status_name
from ..sampler import build
from ..scene import Scene
from ..solver import Solver
from ..values import Arrivals, Ends, LatestDepartures, Point
from .plan import Item, Questions

ANSWERS = pyarrow.schema([
    ("item", pyarrow.int64()), ("name", pyarrow.string()), ("question", pyarrow.string()), ("departure", pyarrow.float64()),
    ("arrival", pyarrow.float64()), ("status", pyarrow.string()), ("error", pyarrow.string())])
ITEMS = pyarrow.schema([
    ("item", pyarrow.int64()), ("name", pyarrow.string()), ("status", pyarrow.string()), ("error", pyarrow.string()),
    ("scene_hash", pyarrow.uint64()), ("discs", pyarrow.int64()), ("table", pyarrow.string()), ("rows", pyarrow.int64()), ("bytes", pyarrow.int64()),
    ("forward_calls", pyarrow.int64()), ("reverse_calls", pyarrow.int64()), ("last_departure", pyarrow.float64()), ("last_reason", pyarrow.string()),
    ("seconds", pyarrow.float64())])

Row = dict[str, Any]


@dataclass
class Rows:
    """The rows of some items."""

    answers: list[Row]
    items: list[Row]


@dataclass(frozen=True)
class Done:
    """What became of a part. `found`: it had been done before."""

    part: int
    items: int
    errors: int
    seconds: float
    found: bool


def part_name(part: int) -> str:
    return f"part-{part:06d}"


def items_file(folder: str, part: int) -> pathlib.Path:
    return pathlib.Path(folder) / "items" / f"{part_name(part)}.parquet"


def answers_file(folder: str, part: int) -> pathlib.Path:
    return pathlib.Path(folder) / "answers" / f"{part_name(part)}.parquet"


def work_part(folder: str, part: int, items: list[tuple[int, Item]], questions: Questions) -> Done:
    """Do a part, unless it is done."""
    if items_file(folder, part).exists():
        return found_part(folder, part)
    return commit(folder, part, work_items(folder, part, items, questions))


def found_part(folder: str, part: int) -> Done:
    """What became of a part that is done."""
    table = pyarrow.parquet.read_table(items_file(folder, part), columns=["error", "seconds"])
    return Done(part, len(table), len(table) - table["error"].null_count, sum(table["seconds"].to_pylist()), True)


def commit(folder: str, part: int, rows: Rows) -> Done:
    """Write the rows of a part. The file of items comes last: with it the part is done."""
    _write(answers_file(folder, part), rows.answers, ANSWERS)
    _write(items_file(folder, part), rows.items, ITEMS)
    return Done(part, len(rows.items), sum(row["error"] is not None for row in rows.items), sum(row["seconds"] for row in rows.items), False)


def _write(path: pathlib.Path, rows: list[Row], schema: Any) -> None:
    out = io.BytesIO()
    pyarrow.parquet.write_table(pyarrow.Table.from_pylist(rows, schema=schema), out)
    path.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(path, out.getbuffer())


def work_items(folder: str, part: int, items: list[tuple[int, Item]], questions: Questions) -> Rows:
    """Answer for some items of a part, and write their tables."""
    rows = Rows([], [])
    for group in _groups(items):
        begun = time.perf_counter()
        shared = _shared_arrivals(group, questions)
        share = (time.perf_counter() - begun) / len(group)
        for number, item in group:
            _work_item(folder, part, number, item, questions, shared.get(number, {}), share, rows)
    return rows


def _groups(items: list[tuple[int, Item]]) -> list[list[tuple[int, Item]]]:
    """Neighbours that have the scene and the source in common: one search serves them all."""
    groups: list[list[tuple[int, Item]]] = []
    for entry in items:
        last = groups[-1][-1][1] if groups else None
        item = entry[1]
        if last is not None and item.ends is not None and last.ends is not None and (last.path, last.ends[0]) == (item.path, item.ends[0]):
            groups[-1].append(entry)
        else:
            groups.append([entry])
    return groups


def _shared_arrivals(group: list[tuple[int, Item]], questions: Questions) -> dict[int, dict[float, tuple[float, int]]]:
    """Arrival and status of each item of a group for each departure, by number and departure. Empty for one alone, and where one of them is wrong:
    each is then asked about by itself, and its row says what."""
    if len(group) < 2 or not questions.departures:
        return {}
    found: dict[int, dict[float, tuple[float, int]]] = {number: {} for number, _ in group}
    places = [Ends(Point(*item.ends[0]), Point(*item.ends[1])) for _, item in group if item.ends is not None]
    try:
        solver = load(group[0][1])[1]
        for departure in questions.departures:
            arrivals = solver.arrivals_to([ends.destination for ends in places], departure, source=places[0].source)
            for (number, _), arrival, status in zip(group, arrivals.arrival, arrivals.status):
                found[number][departure] = float(arrival), int(status)
    except (TdspError, OSError):
        return {}
    return found


def load(item: Item) -> tuple[Scene, Solver]:
    """The scene of an item and a solver for its ends. Pairs share the scene, which a process prepares once."""
    if item.ends is not None:
        stat = pathlib.Path(item.path).stat()
        scene = _prepared(item.path, stat.st_mtime_ns, stat.st_size)
        solver = scene.solver()
        solver.ends = item.ends
        return scene, solver
    if item.length is not None:
        with open(item.path, "rb") as file:
            file.seek(item.offset)
            text = file.read(item.length).decode()
        return _with_solver(Scene.loads(text, item.name))
    return _with_solver(Scene.load(item.path))


def _with_solver(scene: Scene) -> tuple[Scene, Solver]:
    return scene, scene.solver()


@functools.lru_cache(maxsize=1)
def _prepared(path: str, changed: int, size: int) -> Scene:
    return Scene.load(path)


def _work_item(folder: str, part: int, number: int, item: Item, questions: Questions, shared: dict[float, tuple[float, int]], seconds: float,
               rows: Rows) -> None:
    """The rows of one item. What is wrong with it becomes a row, whatever it is; what is wrong with the machine does not: it is tried again."""
    begun = time.perf_counter()
    row: Row = {"item": number, "name": item.name, "status": "ok", "error": None}
    try:
        scene, solver = load(item)
        row["scene_hash"], row["discs"] = scene.hash(item.ends), len(scene)
    except (TdspError, FileNotFoundError, PermissionError, IsADirectoryError, UnicodeDecodeError) as error:
        row["status"], row["error"] = _words(error)
        answers = error_answers(number, item, questions, row["status"], row["error"])
    else:
        answers = _answers(number, item, questions, solver, shared)
        if questions.tables:
            row.update(_table(folder, part, number, item, questions, scene))
    row["seconds"] = seconds + time.perf_counter() - begun
    rows.answers += answers
    rows.items.append(row)


def _words(error: BaseException) -> tuple[str, str]:
    return (status_name(error.status) if isinstance(error, TdspError) else "failed"), str(error)


def error_answers(number: int, item: Item, questions: Questions, status: str, error: str) -> list[Row]:
    """A row for each question to an item that has no answers."""
    base = {"item": number, "name": item.name, "status": status, "error": error}
    return ([{**base, "question": "arrive", "departure": departure} for departure in questions.departures]
            + [{**base, "question": "depart", "arrival": arrival} for arrival in questions.arrivals])


def _answers(number: int, item: Item, questions: Questions, solver: Solver, shared: dict[float, tuple[float, int]]) -> list[Row]:
    rows = []
    for departure in questions.departures:
        base: Row = {"item": number, "name": item.name, "question": "arrive", "departure": departure}
        rows.append({**base, **_asked(lambda: _arrival(shared.get(departure), solver, departure))})
    for arrival in questions.arrivals:
        base = {"item": number, "name": item.name, "question": "depart", "arrival": arrival}
        rows.append({**base, **_asked(lambda: _departure(solver.latest_departures([arrival])))})
    return rows


def _asked(ask: Any) -> Row:
    """The answer to one question, or what is wrong with it."""
    try:
        answer: Row = ask()
        return answer
    except TdspError as error:
        status, text = _words(error)
        return {"status": status, "error": text}


def _arrival(known: Optional[tuple[float, int]], solver: Solver, departure: float) -> Row:
    if known is None:
        answer: Arrivals = solver.arrivals([departure])
        known = float(answer.arrival[0]), int(answer.status[0])
    arrival, status = known
    return {"arrival": arrival if status == 0 else None, "status": status_name(status)}


def _departure(answer: LatestDepartures) -> Row:
    status = int(answer.status[0])
    return {"departure": float(answer.departure[0]) if status == 0 else None, "status": status_name(status)}


def table_path(part: int, number: int, name: str) -> str:
    """Where in the folder the table of an item is."""
    plain = re.sub(r"[^A-Za-z0-9._-]+", "-", name)[:80].strip(".-")
    return f"tables/{part_name(part)}/{number:07d}-{plain}.tdsp"


def _table(folder: str, part: int, number: int, item: Item, questions: Questions, scene: Scene) -> Row:
    """Build and write the table of an item. No way at departure 0 is an answer: there is no table, and no error. A file that cannot be written is no
    matter of the item's, and raises."""
    options = questions.options
    try:
        table = build(scene, guarantee=options.guarantee, epsilon=options.epsilon, delta=options.delta, sampling=options.sampling,
                      horizon=options.horizon, max_rows=options.max_rows, oracle_share=options.oracle_share, ends=item.ends)
    except NoWay as no:
        return {"status": status_name(no.status)}
    except TdspError as error:
        status, text = _words(error)
        return {"status": status, "error": text}
    name = table_path(part, number, item.name)
    path = pathlib.Path(folder) / name
    path.parent.mkdir(parents=True, exist_ok=True)
    table.save(path)
    report = table.report
    assert report is not None
    return {"table": name, "rows": report.rows, "bytes": report.bytes, "forward_calls": report.forward_calls, "reverse_calls": report.reverse_calls,
            "last_departure": report.last_departure, "last_reason": status_name(report.last_reason)}


def killed_row(number: int, item: Item, questions: Questions, times: int) -> Rows:
    """The rows of an item that ended the worker each time it was tried."""
    text = f"the worker died {times} times over it"
    return Rows(error_answers(number, item, questions, "failed", text), [{"item": number, "name": item.name, "status": "failed", "error": text,
                                                                         "seconds": 0.0}])
