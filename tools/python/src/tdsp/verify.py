# SPDX-License-Identifier: MIT
"""Checking paths and tables by means that share nothing with the search."""
from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional

from . import _abi
from ._arrays import address
from ._library import lib
from .errors import check
from .path import Path
from .scene import Scene
from .values import EndsLike, disc_or_none, ends_struct

if TYPE_CHECKING:
    from .table import Table

PROBLEMS = {_abi.PROBLEM_START: "does not start at the source at the departure", _abi.PROBLEM_END: "does not end at the destination at the arrival",
            _abi.PROBLEM_JOIN: "legs do not join in place or time", _abi.PROBLEM_SPEED: "faster than the robot",
            _abi.PROBLEM_CLEARANCE: "enters a disc", _abi.PROBLEM_LEG: "a leg is not well formed"}


@dataclass(frozen=True)
class Verdict:
    """What became of checking a path. True where it is good."""

    #: What is wrong, a sentence each; empty when nothing is.
    problems: tuple[str, ...]
    #: A lower bound on the clearance to the discs, inflated by the robot, over the whole motion; a length. At least minus `tolerance` where all is well.
    min_clearance: float
    #: When, to which disc, and on which leg it is least.
    time: float
    disc: Optional[int]
    leg: int
    #: What is taken for rounding; a length.
    tolerance: float

    def __bool__(self) -> bool:
        return not self.problems


@dataclass(frozen=True)
class TableVerdict:
    """What became of checking a table. True where it is good."""

    ok: bool
    #: It was built for another scene.
    stale: bool
    #: Rows out of order, that break the guarantee, whose path was rejected.
    bad_order: int
    bad_ratio: int
    bad_paths: int
    #: The first row with any problem.
    first_bad_row: Optional[int]
    #: Of the path with the least clearance, or of the first rejected one.
    worst: Verdict

    def __bool__(self) -> bool:
        return self.ok


def _verdict(verdict: _abi.tdsp_verdict) -> Verdict:
    problems = tuple(text for bit, text in PROBLEMS.items() if verdict.problems & bit)
    return Verdict(problems, verdict.min_clearance, verdict.time, disc_or_none(verdict.disc), int(verdict.leg), verdict.tolerance)


def verify_path(scene: Scene, path: Path, ends: Optional[EndsLike] = None) -> Verdict:
    """Check a path: it starts and ends right, joins, keeps to the top speed, and stays clear of every disc over its whole motion.

    :param ends: the path's, where they are not the scene's own
    :raises Shrinks: the path goes on after a disc's radius shrinks

    >>> scene = Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.1)
    >>> bool(verify_path(scene, scene.solver().path(9.8)))
    True
    >>> verify_path(scene, scene.solver().path(9.8).shifted(5.0)).problems
    ('enters a disc',)
    """
    out, legs, struct = _abi.tdsp_verdict(), path.legs, ends_struct(ends)
    about = (address(legs), len(legs), path.departure, path.arrival, ctypes.byref(out))
    if struct is None:
        check(lib.tdsp_verify_path(scene._handle.pointer, *about), "path")
    else:
        check(lib.tdsp_verify_path_for(scene._handle.pointer, ctypes.byref(struct), *about), "path")
    return _verdict(out)


def verify_table(scene: Scene, table: Table, ends: Optional[EndsLike] = None) -> TableVerdict:
    """Check a table against its scene: the hash, the order of rows, the guarantee of each interval, and each row's path.

    :param ends: the table's, where they are not the scene's own
    """
    out, struct = _abi.tdsp_table_verdict(), ends_struct(ends)
    if struct is None:
        check(lib.tdsp_verify_table(scene._handle.pointer, table._pointer, ctypes.byref(out)), "table")
    else:
        check(lib.tdsp_verify_table_for(scene._handle.pointer, ctypes.byref(struct), table._pointer, ctypes.byref(out)), "table")
    first = None if out.first_bad_row == 2**64 - 1 else int(out.first_bad_row)
    return TableVerdict(bool(out.ok), bool(out.stale), int(out.bad_order), int(out.bad_ratio), int(out.bad_paths), first, _verdict(out.worst))
