# SPDX-License-Identifier: MIT
"""Tables: certified answers for every departure, in bytes that are read in place."""
from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Iterator, Optional

import numpy as np
import numpy.typing as npt

from . import _abi
from ._abi import Guarantee, Monotone, Sampling, Status
from ._arrays import LEG_DTYPE, ROW_DTYPE, Floats, Statuses, address, floats, view
from ._library import lib
from ._opened import Opened
from .errors import InvalidArgument, check
from .path import Path, read_legs
from .values import (Departure, Departures, EndsLike, Interval, Intervals, Point, Row, TableJump, gap_from, point_from, statuses)

if TYPE_CHECKING:
    from .sampler import BuildReport
    from .scene import Scene
    from .verify import TableVerdict

Out = Optional["tuple[Floats, Floats]"]


@dataclass(frozen=True)
class TableInfo:
    """What a table's header says. Times, lengths and speeds are in the units that it names, "" where it names none."""

    version: tuple[int, int]
    #: "travel" or "arrival": what never decreases.
    monotone: str
    #: "travel", "arrival" or "absolute": what holds between `lower` and `upper`, with the bound `epsilon` or `delta`.
    guarantee: str
    sampling: str
    rows: int
    legs: int
    length: int
    scene_hash: int
    epsilon: float
    delta: float
    #: The stated error of arrivals: `error * (T + time_scale)`.
    error: float
    time_scale: float
    speed: float
    source: Point
    destination: Point
    first_lower: float
    first_departure: float
    last_departure: float
    #: Why there is no answer after it.
    last_reason: Status
    length_unit: str
    time_unit: str
    guide_length: int
    curves: int
    gaps: int


class Table(Opened[_abi.tdsp_table]):
    """A table, opened over bytes that are not copied: a `bytes`, a mapped file, any buffer, which must stay as it is.

    Any number of threads may read one table, and questions let go of the interpreter's lock.

    :param buffer: the table's bytes; kept alive by the table
    :param accepted: a table was opened over these bytes before, and they are still the same: they are not checked again, which takes time in proportion to
        their length. Questions to other bytes stay inside them, but their answers mean nothing.
    :raises DataError: what is wrong with the bytes: `BadMagic`, `BadVersion`, `BadLength`, `BadChecksum`, `BadTable`

    >>> import tdsp
    >>> scene = tdsp.Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.1)
    >>> table = scene.build(epsilon=0.01)
    >>> table.arrivals([5.0, 9.0, 500.0]).status
    array([0, 0, 2], dtype=uint32)
    >>> Table(bytes(table)).departure(33.0).departure == table.departure(33.0).departure
    True
    """

    _kind = "table"

    def __init__(self, buffer: Any, *, accepted: bool = False, _report: Optional[BuildReport] = None, _about: str = "table") -> None:
        self._bytes = view(buffer)
        self._struct = _abi.tdsp_table()
        #: What building it cost; None for a table that was opened.
        self.report = _report
        opening = lib.tdsp_table_reopen if accepted else lib.tdsp_table_open
        check(opening(ctypes.byref(self._struct), address(self._bytes), len(self._bytes)), _about)

    @classmethod
    def _inside(cls, struct: _abi.tdsp_table, whole: npt.NDArray[np.uint8]) -> Table:
        """A table inside a matrix, which has been opened already."""
        table = cls.__new__(cls)
        start = int(struct.bytes or 0) - address(whole)
        table._bytes, table._struct, table.report = whole[start:start + struct.length], struct, None
        return table

    def __len__(self) -> int:
        assert self._pointer is not None and self._struct is not None
        return int(self._struct.rows)

    def __repr__(self) -> str:
        if self._struct is None:
            return "<tdsp.Table: closed>"
        info = self.info
        bound = f"delta {info.delta:g}" if info.guarantee == "absolute" else f"epsilon {info.epsilon:g}"
        unit = f" {info.time_unit}" if info.time_unit else ""
        rows = f"{info.rows} row" + ("s" if info.rows != 1 else "")
        return (f"<tdsp.Table: {rows}, {info.length} bytes, {info.guarantee} {bound}, departures 0 to {info.last_departure:.7g}{unit}, "
                f"then {info.last_reason.name.lower()}>")

    @property
    def info(self) -> TableInfo:
        """What the header says."""
        out = _abi.tdsp_table_info()
        check(lib.tdsp_table_get_info(self._pointer, ctypes.byref(out)))
        return TableInfo((out.version_major, out.version_minor), Monotone(out.monotone).name.lower(), Guarantee(out.guarantee).name.lower(),
                         Sampling(out.sampling).name.lower(), out.rows, out.legs, out.length, out.scene_hash, out.epsilon, out.delta, out.error,
                         out.time_scale, out.speed, point_from(out.source), point_from(out.destination), out.first_lower, out.first_departure,
                         out.last_departure, Status(out.last_reason), out.length_unit.decode(), out.time_unit.decode(), out.guide_length,
                         out.curves, out.gaps)

    def arrival(self, departure: float) -> Interval:
        """The certified interval of the earliest arrival: `lower <= A(departure) <= upper`, and `path(departure)` arrives by `upper`.

        :raises NoWay: why there is no answer at this departure
        """
        lower, upper = ctypes.c_double(), ctypes.c_double()
        check(lib.tdsp_table_arrival(self._pointer, departure, ctypes.byref(lower), ctypes.byref(upper)), f"departure {departure}")
        return Interval(lower.value, upper.value)

    def arrival_float(self, departure: float) -> Interval:
        """What firmware that works in floats answers: `arrival` of the departure taken as a float, each end rounded outward to a float.

        :raises NoWay: why there is no answer at this departure
        """
        lower, upper = ctypes.c_float(), ctypes.c_float()
        check(lib.tdsp_table_arrival_float(self._pointer, departure, ctypes.byref(lower), ctypes.byref(upper)), f"departure {departure}")
        return Interval(lower.value, upper.value)

    def departure(self, arrival: float) -> Departure:
        """Leaving at `departure` arrives by `arrival` for certain; no departure after `departure_upper` can.

        :raises ArrivalTooEarly: no row certifies an arrival that early
        """
        departure, upper = ctypes.c_double(), ctypes.c_double()
        check(lib.tdsp_table_departure(self._pointer, arrival, ctypes.byref(departure), ctypes.byref(upper)), f"arrival {arrival}")
        return Departure(departure.value, upper.value)

    def arrivals(self, departures: npt.ArrayLike, out: Out = None) -> Intervals:
        """Intervals of many departures, in one call of the library.

        :param departures: times of any shape; an array of doubles in order is not copied
        :param out: two arrays of that shape to write `lower` and `upper` to; made anew unless given
        """
        asked = floats(departures, "departures")
        lower, upper = _outputs(asked, out)
        status = statuses(asked.shape)
        check(lib.tdsp_table_arrivals(self._pointer, address(asked), asked.size, address(lower), address(upper), address(status)))
        return Intervals(lower, upper, status)

    def departures(self, arrivals: npt.ArrayLike, out: Out = None) -> Departures:
        """Latest departures of many arrivals, in one call of the library. Parameters as of `arrivals`."""
        asked = floats(arrivals, "arrivals")
        departure, upper = _outputs(asked, out)
        status = statuses(asked.shape)
        check(lib.tdsp_table_departures(self._pointer, address(asked), asked.size, address(departure), address(upper), address(status)))
        return Departures(departure, upper, status)

    def row_at(self, departure: float) -> int:
        """The number of the row that answers a departure. :raises NoWay: none does, and why"""
        row = ctypes.c_uint64()
        check(lib.tdsp_table_find(self._pointer, departure, ctypes.byref(row)), f"departure {departure}")
        return row.value

    def rows_at(self, departures: npt.ArrayLike) -> tuple[npt.NDArray[np.uint64], Statuses]:
        """The numbers of the rows that answer many departures, and statuses; the number of rows where none does."""
        asked = floats(departures, "departures")
        rows, status = np.empty(asked.shape, np.uint64), statuses(asked.shape)
        check(lib.tdsp_table_rows(self._pointer, address(asked), asked.size, address(rows), address(status)))
        return rows, status

    def row(self, row: int) -> Row:
        """A row, by its number from 0."""
        out = _abi.tdsp_row()
        check(lib.tdsp_table_row(self._pointer, self._row(row), ctypes.byref(out)))
        return Row(out.departure, out.left, out.right, int(out.legs))

    def rows(self) -> npt.NDArray[Any]:
        """All rows: records `departure`, `left`, `right`, `legs`."""
        out = np.empty(len(self), ROW_DTYPE)
        for i in range(len(out)):
            check(lib.tdsp_table_row(self._pointer, i, address(out) + i * ROW_DTYPE.itemsize))
        return out

    def _row(self, row: int) -> int:
        if not 0 <= row < len(self):
            raise InvalidArgument(f"row {row}: the table has {len(self)} rows")
        return row

    def path(self, departure: float) -> Path:
        """The path that answers a departure: it leaves at `departure`, or waits at the source until its row's (a table monotone in arrival).

        :raises NoWay: there is none, and why
        """
        legs = read_legs(lambda *room: lib.tdsp_table_path(self._pointer, departure, *room), f"departure {departure}")
        if len(legs):
            return Path(legs, departure, float(legs["end_time"][-1]))
        return Path(legs, departure, self.arrival(departure).upper, self.info.source)

    def leg(self, departure: float, leg: int) -> Any:
        """One leg of the path that answers a departure: a record of LEG_DTYPE. :raises NoAnswer: the path has no leg of that number"""
        out = np.zeros(1, LEG_DTYPE)
        check(lib.tdsp_table_leg(self._pointer, departure, _number(leg), address(out)), f"departure {departure}, leg {leg}")
        return out[0]

    def row_path(self, row: int) -> Path:
        """The path of a row as it is stored, leaving at the row's departure."""
        about = self.row(row)
        legs = np.zeros(about.legs, LEG_DTYPE)
        for i in range(len(legs)):
            check(lib.tdsp_table_row_leg(self._pointer, row, i, address(legs) + i * LEG_DTYPE.itemsize), f"row {row}, leg {i}")
        arrival = float(legs["end_time"][-1]) if len(legs) else about.departure + about.left
        return Path(legs, about.departure, arrival, self.info.source)

    def row_bytes(self, row: int) -> memoryview:
        """The path of a row as bytes, of an oracle whose paths are bytes; empty when there are none. Not copied."""
        start, length = ctypes.c_void_p(), ctypes.c_size_t()
        check(lib.tdsp_table_row_bytes(self._pointer, self._row(row), ctypes.byref(start), ctypes.byref(length)))
        offset = int(start.value or 0) - address(self._bytes) if length.value else 0
        return self.buffer[offset:offset + length.value]

    def position(self, departure: float, time: float) -> Point:
        """Where a robot that left at `departure` is at `time`, clamped to its path. :raises NoAnswer: rows carry no legs"""
        out = _abi.tdsp_point()
        check(lib.tdsp_table_position(self._pointer, departure, time, ctypes.byref(out)), f"departure {departure}, time {time}")
        return point_from(out)

    def positions(self, departure: float, times: npt.ArrayLike) -> Floats:
        """The same for many times: lengths, of the shape of `times` and one dimension of 2 more."""
        return self.path(departure).positions(times)

    def next_jump(self, departure: float) -> Optional[TableJump]:
        """The first jump of the travel time at `departure` or later; None when there is none."""
        return self._jump(lib.tdsp_table_next_jump, departure)

    def previous_jump(self, departure: float) -> Optional[TableJump]:
        """The last jump of the travel time before `departure`; None when there is none."""
        return self._jump(lib.tdsp_table_previous_jump, departure)

    def _jump(self, find: Any, departure: float) -> Optional[TableJump]:
        out = _abi.tdsp_jump()
        status = find(self._pointer, departure, ctypes.byref(out))
        if status == Status.NO_ANSWER:
            return None
        check(status, f"departure {departure}")
        return TableJump(int(out.row), out.departure, out.before, out.after, gap_from(out.gap))

    def jumps(self) -> Iterator[TableJump]:
        """All jumps of the travel time, in order."""
        jump = self.next_jump(0.0)
        while jump is not None:
            yield jump
            jump = self.next_jump(float(np.nextafter(jump.departure, np.inf)))

    def verify(self, scene: Scene, ends: Optional[EndsLike] = None) -> TableVerdict:
        """Check the table against its scene, by means that share nothing with the search."""
        from .verify import verify_table
        return verify_table(scene, self, ends)


def _outputs(asked: Floats, out: Out) -> tuple[Floats, Floats]:
    if out is None:
        return np.empty(asked.shape), np.empty(asked.shape)
    for array in out:
        fits = isinstance(array, np.ndarray) and array.dtype == np.float64 and array.shape == asked.shape
        if not fits or not array.flags.c_contiguous or not array.flags.writeable:
            raise InvalidArgument(f"out: two writable, contiguous arrays of doubles of the shape {asked.shape}")
        if np.may_share_memory(array, asked):
            raise InvalidArgument("out: may not overlap what is asked")
    if np.may_share_memory(*out):
        raise InvalidArgument("out: the arrays may not overlap")
    return out


def _number(value: int) -> int:
    if value < 0:
        raise InvalidArgument(f"{value}: must not be negative")
    return value
