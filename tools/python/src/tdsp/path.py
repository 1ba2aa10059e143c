# SPDX-License-Identifier: MIT
"""Paths: what the robot does, leg by leg."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _abi
from ._arrays import LEG_DTYPE, Floats, address, floats
from ._library import lib
from .errors import InvalidArgument, check
from .values import EndsLike, Point

if TYPE_CHECKING:
    from .scene import Scene
    from .verify import Verdict



class Path:
    """A path: legs that the robot drives one after the other, each a line or a ride on a disc's boundary. Immutable.

    `legs` is an array of records, the library's own: `start_time`, `end_time`, `from`, `to`; for a ride also `disc`, `turn`, `center`, `radius_from`, ...
    (docs/python.md). A path without legs stays where it is: source and destination are one place.

    >>> import tdsp
    >>> scene = tdsp.Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.1)
    >>> path = scene.solver().path(0.0)
    >>> path
    <tdsp.Path: 1 leg, leaves 0, arrives 20>
    >>> path.position(5.0)
    Point(x=-5.0, y=0.0)
    >>> path.positions([0, 5, 20])
    array([[-10.,   0.],
           [ -5.,   0.],
           [ 10.,   0.]])
    """

    __slots__ = ("_legs", "_departure", "_arrival", "_place")

    def __init__(self, legs: npt.NDArray[Any], departure: float, arrival: float, place: Optional[Point] = None) -> None:
        if legs.dtype != LEG_DTYPE or legs.ndim != 1:
            raise InvalidArgument("legs: must be an array of one dimension of tdsp.LEG_DTYPE")
        # A view that does not write: who owns the array may go on using it.
        self._legs = np.ascontiguousarray(legs).view()
        self._legs.flags.writeable = False
        self._departure, self._arrival, self._place = float(departure), float(arrival), place

    @property
    def legs(self) -> npt.NDArray[Any]:
        """The legs in order of time: a read-only array of LEG_DTYPE."""
        return self._legs

    @property
    def departure(self) -> float:
        """When the path leaves; a time."""
        return self._departure

    @property
    def arrival(self) -> float:
        """When it arrives; a time."""
        return self._arrival

    @property
    def travel_time(self) -> float:
        """How long it takes."""
        return self._arrival - self._departure

    def __len__(self) -> int:
        return len(self._legs)

    def __repr__(self) -> str:
        count = f"{len(self)} leg" + ("s" if len(self) != 1 else "")
        return f"<tdsp.Path: {count}, leaves {self._departure:.7g}, arrives {self._arrival:.7g}>"

    def position(self, time: float) -> Point:
        """Where the robot is at a time: before the departure at the source, after the arrival at the destination."""
        if not len(self) and self._place is not None:
            return self._place
        out = _abi.tdsp_point()
        check(lib.tdsp_path_position(address(self._legs), len(self), time, ctypes.byref(out)), f"time {time}")
        return Point(out.x, out.y)

    def positions(self, times: npt.ArrayLike) -> Floats:
        """Where the robot is at each of many times: lengths, of the shape of `times` and one dimension of 2 more."""
        asked = floats(times, "times")
        out = np.empty((*asked.shape, 2))
        for time, place in zip(asked.ravel(), out.reshape(-1, 2)):
            place[:] = self.position(float(time))
        return out

    def shifted(self, delay: float) -> Path:
        """The same path driven later (negative: earlier). Places stay; on growing discs only an earlier path stays clear."""
        legs = np.empty_like(self._legs)
        for i in range(len(legs)):
            leg = _abi.tdsp_leg.from_address(address(legs) + i * LEG_DTYPE.itemsize)
            leg_pointer = address(self._legs) + i * LEG_DTYPE.itemsize
            ctypes.memmove(ctypes.byref(leg), ctypes.byref(lib.tdsp_leg_shifted(leg_pointer, delay)), LEG_DTYPE.itemsize)
        return Path(legs, self._departure + delay, self._arrival + delay, self._place)

    def polyline(self, points_per_leg: int = 32) -> Floats:
        """Places along the path, for a picture: lines by their ends, rides by `points_per_leg` places; lengths of the shape (n, 2)."""
        if points_per_leg < 2:
            raise InvalidArgument("points_per_leg: must be at least 2")
        if not len(self):
            return np.array([self._place]) if self._place is not None else np.empty((0, 2))
        parts = []
        for i, leg in enumerate(self._legs):
            times = np.linspace(leg["start_time"], leg["end_time"], 2 if leg["kind"] == _abi.LEG_LINE else points_per_leg)
            parts.append([self.position_on(i, float(time)) for time in times])
        return np.array([place for part in parts for place in part])

    def position_on(self, leg: int, time: float) -> Point:
        """Where the robot is on one leg, `time` clamped to it."""
        if not 0 <= leg < len(self):
            raise InvalidArgument(f"leg {leg}: the path has {len(self)} legs")
        place = lib.tdsp_leg_position(address(self._legs) + leg * LEG_DTYPE.itemsize, time)
        return Point(place.x, place.y)

    def to_dict(self) -> dict[str, Any]:
        """The path as `tdsp path --json` prints it; `tdsp verify` reads it."""
        return {"departure": self._departure, "arrival": self._arrival, "status": "ok", "legs": [_leg_to_dict(leg) for leg in self._legs]}

    def verify(self, scene: Scene, ends: Optional[EndsLike] = None) -> Verdict:
        """Check the path against a scene, by means that share nothing with the search."""
        from .verify import verify_path
        return verify_path(scene, self, ends)


def _leg_to_dict(leg: Any) -> dict[str, Any]:
    def pair(name: str) -> list[float]:
        return [float(leg[name][0]), float(leg[name][1])]

    out: dict[str, Union[str, int, float, list[float]]] = {
        "type": "line" if leg["kind"] == _abi.LEG_LINE else "arc", "start_time": float(leg["start_time"]), "end_time": float(leg["end_time"]), "from": pair("from"), "to": pair("to")}
    if leg["kind"] == _abi.LEG_LINE:
        return out
    out.update(disc=int(leg["disc"]), center=pair("center"), turn="ccw" if leg["turn"] > 0 else "cw",
               radii=[float(leg["radius_from"]), float(leg["radius_to"])])
    if leg["kind"] == _abi.LEG_CURVE:
        out.update(sweep=float(leg["sweep"]), rates=[float(leg["rate_from"]), float(leg["rate_to"])],
                   bends=[float(leg["bend_from"]), float(leg["bend_to"])], speed=float(leg["speed"]))
    return out


def read_legs(ask: Any, about: str) -> npt.NDArray[Any]:
    """The legs that `ask(address, capacity, count)` writes: asked for with room for most paths, and again with enough where that was too small."""
    count, legs = ctypes.c_size_t(), np.zeros(64, LEG_DTYPE)
    status = ask(address(legs), len(legs), ctypes.byref(count))
    if status == _abi.Status.BUFFER_TOO_SMALL:
        legs = np.zeros(count.value, LEG_DTYPE)
        status = ask(address(legs), len(legs), ctypes.byref(count))
    check(status, about)
    return legs[:count.value].copy()
