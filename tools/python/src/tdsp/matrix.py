# SPDX-License-Identifier: MIT
"""Matrices: the tables between many sources and many destinations, in one file."""
from __future__ import annotations

import ctypes
import math
from contextlib import ExitStack
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _abi
from ._abi import Status
from ._arrays import PointLike, Statuses, address, bytes_at, point, text_address, view
from ._callbacks import Caught
from ._library import lib
from ._opened import Opened
from .sampler import About, Call, Options, Progress, built_bytes, scene_about
from .errors import InvalidArgument, check, error_for
from .scene import Scene
from .solver import Solver
from .table import Table
from .values import Ends, Point, point_from, statuses

if TYPE_CHECKING:
    from .oracle import Oracle


class End(NamedTuple):
    """A source or a destination: a place, and a name or ""."""

    place: Point
    name: str = ""


EndLike = Union[End, PointLike, "tuple[PointLike, str]"]
#: The oracle from source i to destination j, and a number that identifies their world.
PairOracle = Callable[[int, int], "tuple[Oracle, int]"]


@dataclass(frozen=True)
class MatrixReport:
    """What was built, and what it cost. `tables` are pairs with a way."""

    tables: int
    rows: int
    bytes: int
    forward_calls: int
    reverse_calls: int


class Matrix(Opened[_abi.tdsp_matrix]):
    """A matrix, opened over bytes that are not copied; tables of it show the same bytes.

    >>> import tdsp
    >>> scene = tdsp.Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.1)
    >>> matrix = tdsp.build_matrix(scene, [((-10, 0), "gate")], [((10, 0), "camp"), ((0, 3), "fire")])
    >>> matrix
    <tdsp.Matrix: 1 sources, 2 destinations, 8816 bytes>
    >>> matrix.status(0, 1)
    <Status.DESTINATION_COVERED: 2>
    >>> matrix[0, 0].departure(33.0) == scene.build().departure(33.0)
    True
    """

    _kind = "matrix"

    def __init__(self, buffer: Any, *, _report: Optional[MatrixReport] = None, _about: str = "matrix") -> None:
        self._bytes = view(buffer)
        self._struct = _abi.tdsp_matrix()
        #: What building it cost; None for a matrix that was opened.
        self.report = _report
        check(lib.tdsp_matrix_open(ctypes.byref(self._struct), address(self._bytes), len(self._bytes)), _about)

    def __repr__(self) -> str:
        if self._struct is None:
            return "<tdsp.Matrix: closed>"
        sources, destinations = self.shape
        return f"<tdsp.Matrix: {sources} sources, {destinations} destinations, {len(self._bytes)} bytes>"

    @property
    def shape(self) -> tuple[int, int]:
        """How many sources and destinations there are."""
        sources, destinations = ctypes.c_uint64(), ctypes.c_uint64()
        check(lib.tdsp_matrix_size(self._pointer, ctypes.byref(sources), ctypes.byref(destinations)))
        return sources.value, destinations.value

    @property
    def sources(self) -> list[End]:
        """The sources, with their names."""
        return [self._end(lib.tdsp_matrix_source, i) for i in range(self.shape[0])]

    @property
    def destinations(self) -> list[End]:
        """The destinations, with their names."""
        return [self._end(lib.tdsp_matrix_destination, j) for j in range(self.shape[1])]

    def _end(self, read: Any, index: int) -> End:
        out = _abi.tdsp_matrix_end()
        check(read(self._pointer, index, ctypes.byref(out)))
        name = bytes_at(out.name or 0, out.name_length, self._bytes).tobytes().decode() if out.name_length else ""
        return End(point_from(out.place), name)

    def _table(self, i: int, j: int) -> tuple[int, _abi.tdsp_table]:
        sources, destinations = self.shape
        if not 0 <= i < sources or not 0 <= j < destinations:
            raise InvalidArgument(f"pair {i}, {j}: the matrix has {sources} sources and {destinations} destinations")
        out = _abi.tdsp_table()
        return lib.tdsp_matrix_table(self._pointer, i, j, ctypes.byref(out)), out

    def status(self, i: int, j: int) -> Status:
        """OK where there is a table from source i to destination j, else why there is none."""
        return Status(self._table(i, j)[0])

    def statuses(self) -> Statuses:
        """The same of all pairs: an array of the matrix's shape."""
        out = statuses(self.shape)
        for i, j in np.ndindex(*self.shape):
            out[i, j] = self.status(i, j)
        return out

    def __getitem__(self, pair: tuple[int, int]) -> Table:
        """The table from source i to destination j. :raises NoWay: there is none, and why"""
        i, j = pair
        status, struct = self._table(i, j)
        check(status, f"pair {i}, {j}")
        return Table._inside(struct, self._bytes)


def _ends(values: Sequence[Any], what: str) -> tuple[Any, list[bytes]]:
    """The library's array for ends, with what must stay alive meanwhile."""
    ends, names = (_abi.tdsp_matrix_end * len(values))(), []
    for i, value in enumerate(values):
        place, name = value if len(value) == 2 and isinstance(value[1], str) else (value, "")
        text = name.encode()
        names.append(text)
        ends[i] = _abi.tdsp_matrix_end(point(place, f"{what}[{i}]"), text_address(text), len(text))
    return ends, names


class _Pairs:
    """Answers the library's question for the oracle of a pair; one worker asks for one at a time."""

    def __init__(self, workers: int, caught: Caught) -> None:
        self.caught = caught
        self.structs: list[Any] = [None] * workers

    def callback(self, _: Any, i: int, j: int, worker: int, oracle: int, scene_hash: int) -> None:
        from .oracle import Struct
        chosen, number = self.oracle_for(i, j, worker)
        self.structs[worker] = struct = Struct(chosen, self.caught)
        ctypes.memmove(oracle, ctypes.byref(struct.value), ctypes.sizeof(_abi.tdsp_oracle))
        ctypes.c_uint64.from_address(scene_hash).value = number

    def oracle_for(self, i: int, j: int, worker: int) -> tuple[Oracle, int]:
        raise NotImplementedError


class _ScenePairs(_Pairs):
    """Pairs of places in one scene: a solver for each worker."""

    def __init__(self, scene: Scene, sources: Any, destinations: Any, workers: int, caught: Caught) -> None:
        super().__init__(workers, caught)
        self.scene, self.sources, self.destinations = scene, sources, destinations
        self.solvers = [Solver(scene) for _ in range(workers)]

    def oracle_for(self, i: int, j: int, worker: int) -> tuple[Oracle, int]:
        ends = Ends(point_from(self.sources[i].place), point_from(self.destinations[j].place))
        self.solvers[worker].ends = ends
        return self.solvers[worker].oracle(), self.scene.hash(ends)


class _OraclePairs(_Pairs):
    """Pairs of whatever a user's function knows."""

    def __init__(self, function: PairOracle, caught: Caught) -> None:
        super().__init__(1, caught)
        self.function = function

    def oracle_for(self, i: int, j: int, worker: int) -> tuple[Oracle, int]:
        return self.function(i, j)


def build_matrix(world: Union[Scene, PairOracle], sources: Sequence[EndLike], destinations: Sequence[EndLike], *, guarantee: str = "travel",
                 epsilon: float = 0.01, delta: float = 0.0, sampling: str = "adaptive", horizon: float = math.inf, max_rows: int = _abi.MAX_ROWS,
                 oracle_share: Optional[float] = None, threads: int = 1, about: Optional[About] = None, progress: Optional[Progress] = None) -> Matrix:
    """Build the tables of all pairs into one matrix.

    :param world: a Scene, or a function that answers the oracle of a pair, and a number that identifies its world
    :param sources: places, each with a name beside it where it has one: `((x, y), "gate")`
    :param destinations: likewise
    :param threads: for a Scene; whole pairs are spread over them. The matrix does not depend on it
    :param progress: told the number of pairs done, and of all

    The other parameters are those of `tdsp.build`, for each table. A pair without a way has a status in the place of a table.
    """
    if not callable(world) and not isinstance(world, Scene):
        raise InvalidArgument("world: a Scene, or a function that answers the oracle of a pair")
    if threads < 1 or (threads > 1 and not isinstance(world, Scene)):
        raise InvalidArgument(f"threads: at least 1, and 1 for oracles of your own, not {threads}")
    caught = Caught()
    starts, names = _ends(sources, "sources")
    goals, more = _ends(destinations, "destinations")
    pairs = _ScenePairs(world, starts, goals, threads, caught) if isinstance(world, Scene) else _OraclePairs(world, caught)
    if about is None:
        about = scene_about(world) if isinstance(world, Scene) else About()
    call = Call(Options(guarantee, epsilon, delta, sampling, horizon, max_rows, oracle_share), about, progress, caught)
    plan = _abi.tdsp_matrix_plan(ctypes.addressof(starts), len(starts), ctypes.addressof(goals), len(goals),
                                 _abi.tdsp_pair_oracle(caught.status(pairs.callback)), None)
    out, length, report = ctypes.c_void_p(), ctypes.c_size_t(), _abi.tdsp_matrix_report()
    with ExitStack() as stack:
        if threads > 1:
            call.use_threads(stack, threads)
        stack.enter_context(caught.interruptible())
        status = lib.tdsp_matrix_build(ctypes.byref(plan), ctypes.byref(call.options), None, ctypes.byref(out), ctypes.byref(length),
                                       ctypes.byref(report))
    del names, more
    data = built_bytes(out, length.value)
    caught.raise_first()
    if status != Status.OK:
        raise error_for(status, _culprit(report, len(starts), len(goals)))
    return Matrix(data, _report=MatrixReport(report.tables, report.rows, report.bytes, report.forward_calls, report.reverse_calls))


def _culprit(report: _abi.tdsp_matrix_report, sources: int, destinations: int) -> str:
    """The pair that failed; "" when none did, and it was all of it."""
    if report.source >= sources or report.destination >= destinations:
        return "matrix"
    return f"pair {report.source}, {report.destination}"
