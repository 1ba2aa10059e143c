# SPDX-License-Identifier: MIT
"""Building tables: any oracle in, a table out."""
from __future__ import annotations

import ctypes
import math
import threading
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Optional, Sequence, Union

from . import _abi
from ._abi import Guarantee, Sampling, Status
from ._arrays import PointLike, bytes_at, point, text_address
from ._callbacks import Caught
from ._library import Handle, lib, owned
from .errors import InvalidArgument
from .scene import Scene
from .solver import Solver
from .values import Ends, EndsLike, ends_struct, point_from

if TYPE_CHECKING:
    from .oracle import Oracle
    from .table import Table

#: Called with what is settled so far and with all there is (infinite until it is known); a true value cancels, and an exception comes out of the build.
Progress = Callable[[float, float], object]
World = Union[Scene, Solver, "Oracle", "Sequence[Oracle]"]


@dataclass(frozen=True)
class About:
    """What a table says of the world it was built for. `hash` is any number that identifies the world."""

    hash: int = 0
    speed: float = 0.0
    source: PointLike = (0.0, 0.0)
    destination: PointLike = (0.0, 0.0)
    length_unit: str = ""
    time_unit: str = ""


@dataclass(frozen=True)
class BuildReport:
    """What was built, and what it cost."""

    rows: int
    bytes: int
    forward_calls: int
    reverse_calls: int
    #: The end of the departures, a time, and why there is no answer after it.
    last_departure: float
    last_reason: Status
    #: What paths not known to be the best were asked for within; 0: exact answers only. How many there were.
    oracle_delta: float
    rough_calls: int
    #: Jumps at rows of which the table says what closes.
    gaps: int


@dataclass(frozen=True)
class Options:
    """What is asked of a table: the parameters of `build`."""

    guarantee: str = "travel"
    epsilon: float = 0.01
    delta: float = 0.0
    sampling: str = "adaptive"
    horizon: float = math.inf
    max_rows: int = _abi.MAX_ROWS
    oracle_share: Optional[float] = None


class Call:
    """The options of one build as the library takes them, with what must stay alive meanwhile."""

    def __init__(self, asked: Options, about: About, progress: Optional[Progress], caught: Caught) -> None:
        self.options = _abi.tdsp_build_options()
        self.caught = caught
        lib.tdsp_build_options_init(ctypes.byref(self.options))
        self.options.guarantee = _word(Guarantee, asked.guarantee, "guarantee")
        self.options.sampling = _word(Sampling, asked.sampling, "sampling")
        self.options.epsilon, self.options.delta, self.options.horizon = asked.epsilon, asked.delta, asked.horizon
        self.options.max_rows = asked.max_rows
        if asked.oracle_share is not None:
            self.options.oracle_share = asked.oracle_share
        units = _unit(about.length_unit, "length_unit"), _unit(about.time_unit, "time_unit")
        self.kept: list[Any] = [units]
        self.options.world = _abi.tdsp_build_world(about.hash, about.speed, point(about.source, "source"), point(about.destination, "destination"),
                                                   *map(text_address, units))
        self.options.progress = progress_callback(progress, caught)

    def use_threads(self, stack: ExitStack, threads: int) -> None:
        """Spread the tasks over so many threads, this one among them."""
        pool = stack.enter_context(ThreadPoolExecutor(threads - 1, "tdsp"))
        self.options.run_tasks = _abi.tdsp_run_tasks(_Tasks(pool, threads, self.caught).run)
        self.options.worker_count = threads

    def use_workers(self, structs: Sequence[_abi.tdsp_oracle]) -> None:
        """One oracle for each thread."""
        workers = (_abi.tdsp_oracle * len(structs))(*structs)
        self.kept.append(workers)
        self.options.workers, self.options.worker_count = ctypes.addressof(workers), len(structs)


class _Tasks:
    """Runs tasks of the library on threads. It may not return before all have run, whatever is raised meanwhile: what is raised is kept, and the
    progress callback, which sees it, makes the tasks short."""

    def __init__(self, pool: ThreadPoolExecutor, threads: int, caught: Caught) -> None:
        self.pool, self.threads, self.caught = pool, threads, caught

    def run(self, _: Optional[int], task: Any, context: Optional[int], count: int) -> None:
        indexes, lock = iter(range(count)), threading.Lock()

        def work(worker: int) -> None:
            while True:
                with lock:
                    i = next(indexes, None)
                if i is None:
                    return
                task(context, i, worker)

        others = [self.pool.submit(work, worker) for worker in range(1, min(self.threads, count))]
        while True:
            try:
                work(0)
                break
            except BaseException as error:  # a signal handler's: the library counts on every task
                self.caught.keep(error)
        for other in others:
            raised = other.exception()
            if raised is not None:
                self.caught.keep(raised)


def progress_callback(progress: Optional[Progress], caught: Caught) -> Any:
    """The callback for a progress function. There is one even without a function: coming back to Python is what lets Ctrl-C through."""

    def call(_: Optional[int], settled: float, all: float) -> int:
        return int(bool(progress(settled, all))) if progress is not None else 0

    guarded = caught.guard(1, call)
    return _abi.tdsp_progress(lambda *arguments: 1 if caught.any else guarded(*arguments))


def _word(kind: Any, word: str, what: str) -> int:
    words = {item.name.lower(): int(item) for item in kind}
    if word not in words:
        raise InvalidArgument(f"{what}: one of {', '.join(words)}, not {word!r}")
    return words[word]


def _unit(text: str, what: str) -> bytes:
    unit = text.encode()
    if len(unit) > 15 or b"\0" in unit:
        raise InvalidArgument(f"{what}: at most 15 bytes of UTF-8, not {text!r}")
    return unit


def scene_about(scene: Scene, ends: Optional[EndsLike] = None) -> About:
    """What a table says of a scene, with its own ends or others."""
    struct = ends_struct(ends)
    own = Ends(scene.source, scene.destination) if struct is None else Ends(point_from(struct.source), point_from(struct.destination))
    return About(scene.hash(ends), scene.speed, own.source, own.destination, scene.length_unit, scene.time_unit)


def report_from(report: _abi.tdsp_build_report) -> BuildReport:
    return BuildReport(int(report.rows), int(report.bytes), int(report.forward_calls), int(report.reverse_calls), report.last_departure,
                       Status(report.last_reason), report.oracle_delta, int(report.rough_calls), int(report.gaps))


def _oracles(world: World, threads: int, ends: Optional[EndsLike], about: Optional[About]) -> tuple[list[Oracle], About]:
    """The oracles to ask, one for each thread, and what the table is to say."""
    from .oracle import Oracle
    if isinstance(world, Scene):
        solvers = [Solver(world) for _ in range(threads)]
        for solver in solvers:
            solver.ends = ends
        return [solver.oracle() for solver in solvers], about or scene_about(world, ends)
    if ends is not None:
        raise InvalidArgument("ends: go with a scene; a solver holds its own")
    if isinstance(world, Solver):
        oracles: list[Oracle] = [world.oracle()]
        about = about or scene_about(world.scene, world.ends)
    else:
        oracles = [world] if isinstance(world, Oracle) else list(world)
    if threads != len(oracles) and threads != 1:
        raise InvalidArgument(f"threads: {len(oracles)} oracles are asked by as many threads; a scene may have any number")
    return oracles, about or About()


def build(world: World, *, guarantee: str = "travel", epsilon: float = 0.01, delta: float = 0.0, sampling: str = "adaptive",
          horizon: float = math.inf, max_rows: int = _abi.MAX_ROWS, oracle_share: Optional[float] = None, threads: int = 1,
          ends: Optional[EndsLike] = None, about: Optional[About] = None, progress: Optional[Progress] = None) -> Table:
    """Build a table of earliest arrivals.

    :param world: a Scene; a Solver, about the ends that it holds; an Oracle; or several Oracles that answer alike, each asked in a thread of its own
    :param guarantee: "travel": `upper - t <= (1 + epsilon) (lower - t)`; "arrival": `upper <= (1 + epsilon) lower`; "absolute": `upper - lower <= delta`
    :param epsilon: 1e-9 to 1, for the first two
    :param delta: over 0, a time, for the third
    :param sampling: "adaptive" or "geometric" (guarantee arrival only)
    :param horizon: departures are sampled up to this, a time; needed where nothing ever ends them
    :param max_rows: at most so many rows
    :param oracle_share: how much of the guarantee paths that are not the best may take up, 0 to 0.9
    :param threads: for a Scene; the table does not depend on it
    :param ends: other ends than the Scene's own
    :param about: what the table says of its world; a Scene's or Solver's own unless given
    :param progress: called often, in this thread, with the departure settled so far and the last of all; a true value cancels
    :raises NoWay: why there is no way at departure 0
    :raises Cancelled: `progress` said so
    :raises UsageError: `NeedsHorizon`, `TooManyRows`, `NotSupported`, ...

    `table.report` says what it cost. Ctrl-C stops a build, and leaves nothing behind.

    >>> scene = Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.1)
    >>> table = build(scene, epsilon=0.01)
    >>> lower, upper = table.arrival(9.9)
    >>> round(lower, 2), round(upper, 2)
    (33.62, 33.85)
    """
    from .oracle import Struct
    from .table import Table
    if threads < 1:
        raise InvalidArgument(f"threads: at least 1, not {threads}")
    oracles, about = _oracles(world, threads, ends, about)
    if not oracles:
        raise InvalidArgument("world: no oracle")
    caught = Caught()
    call = Call(Options(guarantee, epsilon, delta, sampling, horizon, max_rows, oracle_share), about, progress, caught)
    structs = [Struct(oracle, caught) for oracle in oracles]
    out, length, report = ctypes.c_void_p(), ctypes.c_size_t(), _abi.tdsp_build_report()
    with ExitStack() as stack:
        hold_solvers(stack, oracles)
        if len(structs) > 1:
            call.use_workers([struct.value for struct in structs])
            call.use_threads(stack, len(structs))
        stack.enter_context(caught.interruptible())
        status = lib.tdsp_build(ctypes.byref(structs[0].value), ctypes.byref(call.options), None, ctypes.byref(out), ctypes.byref(length),
                                ctypes.byref(report))
    data = built_bytes(out, length.value)
    caught.check(status, "table")
    return Table(data, _report=report_from(report))


def hold_solvers(stack: ExitStack, oracles: Sequence[Oracle]) -> None:
    """Keep the solvers of these oracles from being asked by anybody else meanwhile."""
    from .oracle import SolverOracle
    for oracle in oracles:
        if isinstance(oracle, SolverOracle):
            stack.enter_context(oracle.solver._asking())


def built_bytes(out: ctypes.c_void_p, length: int) -> Any:
    """The bytes that the library built, not copied, and freed with the last array that shows them."""
    handle: Handle = owned(out, lambda pointer: lib.tdsp_bytes_free(None, pointer, length))
    return bytes_at(handle.pointer, length, handle)


def check_options(options: Options) -> None:
    """Raise what is wrong with the words among the options, before anything is begun."""
    Call(options, About(), None, Caught())
