# SPDX-License-Identifier: MIT
"""The shape of A(t): where it jumps, and of which pieces it is made."""
from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Callable, NamedTuple, Optional

from . import _abi
from ._abi import Change
from ._callbacks import Caught
from ._library import Handle, lib, owned
from .sampler import Progress, progress_callback
from .errors import check
from .solver import INF, Solver
from .values import Gap, gap_from


@dataclass(frozen=True)
class ArrivalJump:
    """A jump: leaving up to `departure` takes `travel_before`, right after it `travel_after`. Times."""

    departure: float
    travel_before: float
    travel_after: float
    size: float
    #: What closes on the path; None where it was not found.
    gap: Optional[Gap]


class Ride(NamedTuple):
    """A disc that is ridden, and how: +1 counter-clockwise, -1 clockwise."""

    disc: int
    turn: int


@dataclass(frozen=True)
class Piece:
    """Departures from `start` up to `until` whose fastest paths ride the same discs in the same order."""

    start: float
    until: float
    #: Travel times right after `start` and at `until`.
    travel_start: float
    travel_until: float
    rides: tuple[Ride, ...]
    #: Pieces of the same form have the same number.
    form: int
    #: How the piece ends.
    change: Change
    #: What closes, where it ends with a jump.
    gap: Optional[Gap]


@dataclass(frozen=True)
class Envelope:
    """The pieces of A in order, the number of different forms among them, and the resolution that was used (a time)."""

    pieces: tuple[Piece, ...]
    forms: int
    resolution: float

    def __len__(self) -> int:
        return len(self.pieces)


def _options(start: float, until: float, progress: Optional[Progress], caught: Caught) -> _abi.tdsp_shape_options:
    options = _abi.tdsp_shape_options()
    lib.tdsp_shape_options_init(ctypes.byref(options))
    setattr(options, "from", start)
    options.until, options.progress = until, progress_callback(progress, caught)
    return options


Find = Callable[..., int]


def _find(find: Find, free: Any, solver: Solver, options: _abi.tdsp_shape_options, caught: Caught) -> Handle:
    out = ctypes.c_void_p()
    with solver._asking() as pointer, caught.interruptible():
        status = find(pointer, ctypes.byref(options), ctypes.byref(out))
    handle = owned(out, free)
    caught.check(status, "departures")
    return handle


def find_jumps(solver: Solver, start: float = 0.0, until: float = INF, least: float = 0.0, progress: Optional[Progress] = None) -> list[ArrivalJump]:
    """All jumps of A at departures from `start` up to `until`, larger than `least`. None is missed.

    :param least: a time; 0: a 256th of the rise of the travel time over all
    :param progress: called now and then with the departure up to which all is known, and the last; a true value cancels
    :raises NeedsHorizon: nothing ever ends the departures, and `until` is infinite

    >>> from tdsp import Scene
    >>> scene = Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.1)
    >>> [jump] = find_jumps(scene.solver())
    >>> round(jump.departure, 6), round(jump.size, 4), jump.gap.first, jump.gap.second
    (9.849623, 3.7179, 0, 1)
    """
    caught = Caught()
    options = _options(start, until, progress, caught)
    options.least = least
    handle = _find(lib.tdsp_jumps_find, lib.tdsp_jumps_free, solver, options, caught)
    return [_jump(handle.pointer, i) for i in range(lib.tdsp_jumps_count(handle.pointer))]


def _jump(pointer: int, i: int) -> ArrivalJump:
    out = _abi.tdsp_arrival_jump()
    check(lib.tdsp_jumps_get(pointer, i, ctypes.byref(out)))
    return ArrivalJump(out.departure, out.travel_before, out.travel_after, out.size, gap_from(out.gap))


def find_envelope(solver: Solver, start: float = 0.0, until: float = INF, resolution: float = 0.0, progress: Optional[Progress] = None) -> Envelope:
    """The pieces of A: the sequence of the fastest paths' forms.

    :param resolution: a time, how narrow pieces are found for certain; 0: a 1024th of the departures looked at
    """
    caught = Caught()
    options = _options(start, until, progress, caught)
    options.resolution = resolution
    handle = _find(lib.tdsp_envelope_find, lib.tdsp_envelope_free, solver, options, caught)
    pieces = tuple(_piece(handle.pointer, i) for i in range(lib.tdsp_envelope_pieces(handle.pointer)))
    return Envelope(pieces, lib.tdsp_envelope_forms(handle.pointer), lib.tdsp_envelope_resolution(handle.pointer))


def _piece(pointer: int, i: int) -> Piece:
    out = _abi.tdsp_piece()
    check(lib.tdsp_envelope_piece(pointer, i, ctypes.byref(out)))
    rides = (_abi.tdsp_ride * out.ride_count).from_address(out.rides) if out.rides else ()
    return Piece(getattr(out, "from"), out.until, out.travel_from, out.travel_until, tuple(Ride(int(r.disc), int(r.turn)) for r in rides),
                 int(out.form), Change(out.change), gap_from(out.gap))
