# SPDX-License-Identifier: MIT
"""Exact answers: questions to a scene, forwards and backwards."""
from __future__ import annotations

import ctypes
import threading
from contextlib import contextmanager
from typing import TYPE_CHECKING, Iterator, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from . import _abi
from ._abi import Method, Status
from ._arrays import PointLike, address, floats, point, points
from ._library import Handle, lib, owned
from .errors import InvalidArgument, NoAnswer, check, check_answer
from .path import Path, read_legs
from .scene import Scene
from .values import (Arrivals, Deadline, Ends, EndsLike, Gap, LastDeparture, LatestDepartures, Point, Slack, Work, deadline_from, disc_or_none,
                     ends_struct, gap_from, point_from, statuses)

if TYPE_CHECKING:
    from .sampler import Progress
    from .oracle import SolverOracle
    from .shape import ArrivalJump, Envelope

INF = float("inf")


class Within(NamedTuple):
    """A path's arrival, and a time before which nothing arrives: `lower <= A <= arrival`."""

    arrival: float
    lower: float


class Solver:
    """A workspace for questions to one scene. Make one for each thread that asks at the same time.

    Threads may share a solver: they then wait for one another. Inside a callback of one of its own questions a solver may not be asked: RuntimeError.

    :param scene: kept alive by the solver
    :param method: "auto", "same_speed", "different_speeds" or "general"; the answers are the same
    :raises NotSupported: the method does not apply to the scene

    >>> scene = Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.1)
    >>> solver = Solver(scene)
    >>> solver
    <tdsp.Solver: same_speed, <tdsp.Scene: 2 discs, speed 1, (-10, 0) to (10, 0)>>
    >>> solver.arrivals([0.0, 9.0, 100.0])
    Arrivals(arrival=array([20., 29., inf]), status=array([0, 0, 1], dtype=uint32))
    >>> round(solver.latest_departure(33.0), 6)
    9.849623
    >>> solver.arrival(100.0)
    Traceback (most recent call last):
    ...
    tdsp.errors.SourceCovered: departure 100.0: The source lies inside a disc at the departure
    """

    def __init__(self, scene: Scene, method: str = "auto") -> None:
        out = ctypes.c_void_p()
        if method == "auto":
            check(lib.tdsp_solver_create(scene._handle.pointer, ctypes.byref(out)), "solver")
        else:
            check(lib.tdsp_solver_create_for(scene._handle.pointer, method_from(method), ctypes.byref(out)), f"method {method}")
        self._scene = scene
        self._handle: Handle = owned(out, lib.tdsp_solver_free, scene._handle)
        self._lock = threading.RLock()
        self._busy = False

    @property
    def scene(self) -> Scene:
        """The scene that the solver was made for."""
        assert lib.tdsp_solver_scene(self._handle.pointer) == self._scene._handle.pointer
        return self._scene

    @property
    def method(self) -> str:
        """How it solves: "same_speed", "different_speeds" or "general"."""
        name: bytes = lib.tdsp_method_name(lib.tdsp_solver_method(self._handle.pointer))
        return name.decode()

    def __repr__(self) -> str:
        return f"<tdsp.Solver: {self.method}, {self._scene!r}>"

    @contextmanager
    def _asking(self) -> Iterator[int]:
        """The solver's pointer, for one thread at a time; never twice in one thread."""
        with self._lock:
            if self._busy:
                raise RuntimeError("tdsp: this solver is in the middle of an answer: inside its callbacks ask another solver of the scene")
            self._busy = True
            try:
                yield self._handle.pointer
            finally:
                self._busy = False

    @property
    def ends(self) -> Ends:
        """The ends asked about: the scene's own, unless set. Set to None for the scene's own again."""
        out = _abi.tdsp_ends()
        with self._asking() as pointer:
            check(lib.tdsp_solver_ends(pointer, ctypes.byref(out)))
        return Ends(point_from(out.source), point_from(out.destination))

    @ends.setter
    def ends(self, ends: Optional[EndsLike]) -> None:
        struct = ends_struct(ends)
        with self._asking() as pointer:
            check(lib.tdsp_solver_set_ends(pointer, ctypes.byref(struct) if struct else None), f"ends {ends}")

    def _earliest(self, pointer: int, departure: float, ends: Optional[_abi.tdsp_ends]) -> tuple[int, float]:
        arrival = ctypes.c_double(INF)
        if ends is None:
            status = lib.tdsp_earliest_arrival(pointer, departure, ctypes.byref(arrival))
        else:
            status = lib.tdsp_earliest_arrival_for(pointer, ctypes.byref(ends), departure, ctypes.byref(arrival))
        return status, arrival.value

    def _latest(self, pointer: int, arrival: float, ends: Optional[_abi.tdsp_ends]) -> tuple[int, float, float]:
        departure, arrives = ctypes.c_double(-INF), ctypes.c_double(INF)
        if ends is None:
            status = lib.tdsp_latest_departure(pointer, arrival, ctypes.byref(departure), ctypes.byref(arrives))
        else:
            status = lib.tdsp_latest_departure_for(pointer, ctypes.byref(ends), arrival, ctypes.byref(departure), ctypes.byref(arrives))
        return status, departure.value, arrives.value

    def arrival(self, departure: float, ends: Optional[EndsLike] = None) -> float:
        """A(t): the earliest arrival for a robot that leaves at `departure`.

        :param ends: other ends than the solver's, for this question
        :raises NoWay: why there is no way (`SourceCovered`, `DestinationCovered`, `CutOff`)
        """
        with self._asking() as pointer:
            status, arrival = self._earliest(pointer, departure, ends_struct(ends))
        check(status, f"departure {departure}")
        return arrival

    def arrivals(self, departures: npt.ArrayLike, ends: Optional[EndsLike] = None) -> Arrivals:
        """A(t) for departures of any shape, one question each."""
        asked, struct = floats(departures, "departures"), ends_struct(ends)
        out = Arrivals(np.full(asked.shape, INF), statuses(asked.shape))
        with self._asking() as pointer:
            for i, departure in enumerate(asked.ravel()):
                status, arrival = self._earliest(pointer, float(departure), struct)
                check_answer(status, f"departures[{i}] {departure}")
                out.arrival.flat[i], out.status.flat[i] = arrival, status
        return out

    def arrival_within(self, departure: float, delta: float) -> Within:
        """An arrival whose travel time is at most `1 + delta` times the least, and a lower bound, for a part of the work of an exact answer.

        :param delta: from 0, exact, to 1
        """
        with self._asking() as pointer:
            return self._within(pointer, departure, delta)

    def _within(self, pointer: int, departure: float, delta: float) -> Within:
        arrival, lower = ctypes.c_double(), ctypes.c_double()
        check(lib.tdsp_earliest_arrival_within(pointer, departure, delta, ctypes.byref(arrival), ctypes.byref(lower)),
              f"departure {departure} within {delta}")
        return Within(arrival.value, lower.value)

    def latest_departure(self, arrival: float, ends: Optional[EndsLike] = None) -> float:
        """The latest departure that arrives at `arrival` or before; infinity asks for the last departure of all.

        :raises ArrivalTooEarly: `arrival` is before A(0)
        :raises NoWay: there is no way at all
        """
        with self._asking() as pointer:
            status, departure, _ = self._latest(pointer, arrival, ends_struct(ends))
        check(status, f"arrival {arrival}")
        return departure

    def latest_departures(self, arrivals: npt.ArrayLike, ends: Optional[EndsLike] = None) -> LatestDepartures:
        """Latest departures for arrivals of any shape, one question each."""
        asked, struct = floats(arrivals, "arrivals"), ends_struct(ends)
        out = LatestDepartures(np.full(asked.shape, -INF), np.full(asked.shape, INF), statuses(asked.shape))
        with self._asking() as pointer:
            for i, arrival in enumerate(asked.ravel()):
                status, departure, arrives = self._latest(pointer, float(arrival), struct)
                check_answer(status, f"arrivals[{i}] {arrival}")
                out.departure.flat[i], out.arrives.flat[i], out.status.flat[i] = departure, arrives, status
        return out

    def arrivals_to(self, destinations: npt.ArrayLike, departure: float, source: Optional[PointLike] = None) -> Arrivals:
        """A(t) from one source to many destinations, in one search.

        :param destinations: n places, lengths of the shape (n, 2)
        :param source: the solver's, unless given
        """
        places = points(destinations, "destinations")
        out = Arrivals(np.full(len(places), INF), statuses(len(places)))
        start = point(self.ends.source if source is None else source, "source")
        with self._asking() as pointer:
            check(lib.tdsp_earliest_arrivals(pointer, start, departure, address(places), len(places), address(out.arrival), address(out.status)),
                  f"departure {departure}")
        return out

    def departures_from(self, sources: npt.ArrayLike, arrival: float, destination: Optional[PointLike] = None) -> LatestDepartures:
        """Latest departures from many sources to one destination; they share the search backwards.

        :param sources: n places, lengths of the shape (n, 2)
        :param destination: the solver's, unless given
        """
        places = points(sources, "sources")
        out = LatestDepartures(np.full(len(places), -INF), np.full(len(places), INF), statuses(len(places)))
        goal = point(self.ends.destination if destination is None else destination, "destination")
        with self._asking() as pointer:
            check(lib.tdsp_latest_departures(pointer, address(places), len(places), goal, arrival, address(out.departure), address(out.arrives),
                                             address(out.status)), f"arrival {arrival}")
        out.departure[out.status != Status.OK] = -INF
        out.arrives[out.status != Status.OK] = INF
        return out

    def path(self, departure: float, ends: Optional[EndsLike] = None) -> Path:
        """The fastest path for a departure. :raises NoWay: why there is none"""
        struct = ends_struct(ends)
        with self._asking() as pointer:
            status, arrival = self._earliest(pointer, departure, struct)
            check(status, f"departure {departure}")
            return self._last_path(pointer, departure, arrival, struct)

    def path_within(self, departure: float, delta: float) -> Path:
        """The path of `arrival_within`."""
        with self._asking() as pointer:
            return self._last_path(pointer, departure, self._within(pointer, departure, delta).arrival, None)

    def path_to_arrive(self, arrival: float, ends: Optional[EndsLike] = None) -> Path:
        """The path of the latest departure that arrives at `arrival` or before. :raises NoAnswer: nothing ever ends the departures, and none was asked for"""
        struct = ends_struct(ends)
        with self._asking() as pointer:
            status, departure, arrives = self._latest(pointer, arrival, struct)
            check(status, f"arrival {arrival}")
            if departure == INF:
                raise NoAnswer(f"arrival {arrival}: there is no last departure")
            return self._last_path(pointer, departure, arrives, struct)

    def _last_path(self, pointer: int, departure: float, arrival: float, ends: Optional[_abi.tdsp_ends]) -> Path:
        legs = read_legs(lambda *room: lib.tdsp_solver_path(pointer, *room), "path")
        place = self._source(pointer, ends) if not len(legs) else None
        return Path(legs, departure, arrival, place)

    def _source(self, pointer: int, ends: Optional[_abi.tdsp_ends]) -> Point:
        if ends is None:
            ends = _abi.tdsp_ends()
            check(lib.tdsp_solver_ends(pointer, ctypes.byref(ends)))
        return point_from(ends.source)

    def last_departure(self) -> LastDeparture:
        """What ends the departures, when and where. Raises NoWay where there is no way at 0."""
        out = _abi.tdsp_last_departure()
        with self._asking() as pointer:
            check(lib.tdsp_solver_last_departure(pointer, ctypes.byref(out)))
        return LastDeparture(out.departure, out.arrival, Status(out.reason), disc_or_none(out.disc), disc_or_none(out.other), out.time,
                             point_from(out.place))

    def gap(self, departure: float) -> Optional[Gap]:
        """What closes where the arrival jumps right after `departure`; None when there is no such place."""
        out = _abi.tdsp_gap()
        with self._asking() as pointer:
            status = lib.tdsp_solver_gap(pointer, departure, ctypes.byref(out))
        if status == Status.NO_ANSWER:
            return None
        check(status, f"departure {departure}")
        return gap_from(out)

    def deadline(self, deadline: float) -> Deadline:
        """The latest departure for a deadline, and what keeps one from leaving later; infinity asks for the last of all."""
        out = _abi.tdsp_deadline_answer()
        with self._asking() as pointer:
            check(lib.tdsp_solver_deadline(pointer, deadline, ctypes.byref(out)), f"deadline {deadline}")
        return deadline_from(out)

    def slack(self, departure: float, deadline: float = INF) -> Slack:
        """What a departure has to spare against a deadline."""
        out = _abi.tdsp_slack()
        with self._asking() as pointer:
            check(lib.tdsp_solver_slack(pointer, departure, deadline, ctypes.byref(out)), f"departure {departure}")
        latest = deadline_from(out.latest) if out.latest_status == Status.OK else None
        return Slack(Status(out.status), out.arrival, out.early, out.later, Status(out.latest_status), latest)

    def jumps(self, start: float = 0.0, until: float = INF, least: float = 0.0, progress: Optional[Progress] = None) -> list[ArrivalJump]:
        """All jumps of A at departures from `start` up to `until`, larger than `least`; times. See `tdsp.shape`."""
        from .shape import find_jumps
        return find_jumps(self, start, until, least, progress)

    def envelope(self, start: float = 0.0, until: float = INF, resolution: float = 0.0, progress: Optional[Progress] = None) -> Envelope:
        """The pieces of A: which discs are ridden, from when until when. See `tdsp.shape`."""
        from .shape import find_envelope
        return find_envelope(self, start, until, resolution, progress)

    def oracle(self) -> SolverOracle:
        """The solver as an oracle for tables, about the ends that it holds: leave them as they are while the oracle is used."""
        from .oracle import SolverOracle
        return SolverOracle(self)

    @property
    def work(self) -> Work:
        """What the solver has done since it was made."""
        out = _abi.tdsp_solver_work()
        with self._asking() as pointer:
            check(lib.tdsp_solver_work_done(pointer, ctypes.byref(out)))
        return Work(out.forward_searches, out.reverse_searches, out.rounds, out.labels, out.legs_tested, out.bytes)


def method_from(name: str) -> int:
    words = {method.name.lower(): method for method in Method}
    if name not in words:
        raise InvalidArgument(f"method: one of {', '.join(words)}, not {name!r}")
    return words[name]
