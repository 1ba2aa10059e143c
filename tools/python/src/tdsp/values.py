# SPDX-License-Identifier: MIT
"""Small values that questions take and answer: points, ends, intervals, gaps, limits. All immutable.

Lengths are in the scene's unit of length, times in its unit of time. Where the library says "no disc", a value here is None.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _abi
from ._abi import Limit, Status
from ._arrays import Floats, PointLike, Statuses, point
from ._library import lib
from .errors import InvalidArgument


class Point(NamedTuple):
    """A place: two lengths."""

    x: float
    y: float


class Ends(NamedTuple):
    """A source and a destination."""

    source: Point
    destination: Point


EndsLike = Union[Ends, "tuple[PointLike, PointLike]"]


class Interval(NamedTuple):
    """A certified interval: `lower <= A(t) <= upper`; times."""

    lower: float
    upper: float


class Intervals(NamedTuple):
    """Certified intervals of many departures, arrays of one shape; infinite where the status is not OK."""

    lower: Floats
    upper: Floats
    status: Statuses


class Arrivals(NamedTuple):
    """Earliest arrivals, arrays of one shape: infinity where there is no way, and the status says why."""

    arrival: Floats
    status: Statuses


class Departure(NamedTuple):
    """Leaving at `departure` arrives in time for certain; no departure after `departure_upper` does. Times."""

    departure: float
    departure_upper: float


class Departures(NamedTuple):
    """Latest departures, arrays of one shape. Where the status is not OK no departure arrives that early, or there is no way: -infinity."""

    departure: Floats
    departure_upper: Floats
    status: Statuses


class LatestDepartures(NamedTuple):
    """Exact latest departures and when they arrive, arrays of one shape; -infinity and infinity where the status, which says why, is not OK."""

    departure: Floats
    arrives: Floats
    status: Statuses


class Row(NamedTuple):
    """A row of a table: it answers the departures after the row before up to its own."""

    departure: float
    #: Travel time at `departure`, rounded up: the row's path takes no longer.
    left: float
    #: Travel time right after it, rounded down: over `left` at a jump; infinite for the last row of a table that no horizon ended.
    right: float
    #: Legs of the row's path.
    legs: int


@dataclass(frozen=True)
class Gap:
    """What closes where the arrival jumps: two discs, when and where. An oracle may number other things than discs; `second` may then be None."""

    first: int
    second: Optional[int]
    time: float
    place: Point


@dataclass(frozen=True)
class TableJump:
    """A jump at a row of a table: leaving after `departure` takes `after` at least, up to it `before` at most. Travel times."""

    row: int
    departure: float
    before: float
    after: float
    gap: Optional[Gap]


@dataclass(frozen=True)
class LastDeparture:
    """What ends the departures. `departure` is infinite, and `reason` OK, when nothing does."""

    departure: float
    arrival: float
    reason: Status
    #: The disc that covers the end, or the first disc of the gap that closes.
    disc: Optional[int]
    #: The second disc of the gap.
    other: Optional[int]
    time: float
    place: Point


@dataclass(frozen=True)
class Witness:
    """What stands in the way of leaving later, or of growing faster, and where it shows."""

    limit: Limit
    disc: Optional[int]
    other: Optional[int]
    time: float
    place: Point


@dataclass(frozen=True)
class Deadline:
    """The latest departure for a deadline, and what keeps one from leaving later."""

    departure: float
    arrival: float
    witness: Witness
    #: Right after it: OK when there still is a way, which takes too long; else why there is none.
    after: Status
    #: The arrival right after it; infinite without a way.
    after_arrival: float


@dataclass(frozen=True)
class Slack:
    """What a departure has to spare against a deadline. `early` is the deadline minus the arrival, `later` how much later one may leave; both are
    negative when it is too late."""

    status: Status
    arrival: float
    early: float
    later: float
    latest_status: Status
    #: None when no departure is in time.
    latest: Optional[Deadline]


@dataclass(frozen=True)
class Margin:
    """How far rates may rise: `most` is a factor (1: none to spare) or a length per time (0: none). -infinity: it fails even without growth."""

    most: float
    status: Status
    arrival: float
    witness: Witness
    #: Raised scenes that were solved.
    scenes: int


@dataclass(frozen=True)
class Work:
    """What a solver has done since it was made, and the bytes that it holds now."""

    forward_searches: int
    reverse_searches: int
    rounds: int
    labels: int
    legs_tested: int
    bytes: int


def disc_or_none(index: int) -> Optional[int]:
    return None if index == _abi.NO_DISC else int(index)


def point_from(place: _abi.tdsp_point) -> Point:
    return Point(place.x, place.y)


def gap_from(gap: _abi.tdsp_gap) -> Optional[Gap]:
    if gap.first == _abi.NO_DISC:
        return None
    return Gap(int(gap.first), disc_or_none(gap.second), gap.time, point_from(gap.place))


def witness_from(witness: _abi.tdsp_witness) -> Witness:
    return Witness(Limit(witness.limit), disc_or_none(witness.disc), disc_or_none(witness.other), witness.time, point_from(witness.place))


def deadline_from(answer: _abi.tdsp_deadline_answer) -> Deadline:
    return Deadline(answer.departure, answer.arrival, witness_from(answer.witness), Status(answer.after), answer.after_arrival)


def margin_from(margin: _abi.tdsp_margin) -> Margin:
    return Margin(margin.most, Status(margin.status), margin.arrival, witness_from(margin.witness), int(margin.scenes))


def ends_struct(ends: Optional[EndsLike]) -> Optional[_abi.tdsp_ends]:
    """The library's struct for ends; None for a scene's own."""
    if ends is None:
        return None
    try:
        source, destination = ends
    except (TypeError, ValueError):
        raise InvalidArgument("ends: must be a source and a destination") from None
    return _abi.tdsp_ends(point(source, "ends: source"), point(destination, "ends: destination"))


def limit_name(limit: int) -> str:
    """A limit's stable name, as the command prints it.

    >>> limit_name(Limit.SOURCE_COVERED)
    'source_covered'
    """
    name: bytes = lib.tdsp_limit_name(limit)
    return name.decode()


def statuses(shape: Any) -> Statuses:
    return np.zeros(shape, dtype=np.uint32)


def named(values: npt.ArrayLike) -> list[str]:
    """The names of an array of statuses, e.g. for a column of a data frame.

    >>> named([Status.OK, Status.CUT_OFF])
    ['ok', 'cut_off']
    """
    return [Status(int(value)).name.lower() for value in np.asarray(values).ravel()]
