# SPDX-License-Identifier: MIT
"""The library's label-setting search, for oracles of your own: Dijkstra, and A* with a bound."""
from __future__ import annotations

import ctypes
import math
from typing import Any, Callable, Iterable, NamedTuple, Optional

from . import _abi
from ._callbacks import Caught, member_type
from ._library import lib, owned
from .errors import check


class Label(NamedTuple):
    """Something reached, or still to be confirmed, at a time. What `id` and `kind`, whole numbers from 0 to 2^32 - 1, mean is yours."""

    time: float
    id: int
    kind: int = 0


class Open:
    """The open labels, inside `expand`."""

    def __init__(self, pointer: int) -> None:
        self._pointer = pointer

    def push(self, label: Label) -> None:
        """Add a label. Not before the time plus bound of the one that is expanded."""
        struct = _abi.tdsp_label(*label)
        check(lib.tdsp_search_push(self._pointer, ctypes.byref(struct)), f"{label}")

    def limit(self, limit: float) -> None:
        """Labels whose time plus bound is over `limit` are dropped when pushed, from now to the end of the run."""
        lib.tdsp_search_limit(self._pointer, limit)


Expand = Callable[[Label, Open], object]
Bound = Callable[[Label], float]


def search(starts: Iterable[Label], expand: Expand, bound: Optional[Bound] = None) -> bool:
    """Expand labels in the order of time plus bound, until `expand` says done or none is left.

    :param starts: labels to begin with
    :param expand: called with a label and what is open; pushes what follows. A true value ends the search, an exception comes out of it
    :param bound: a lower bound on the time from a label to the goal, consistent; none: Dijkstra
    :return: did `expand` end it?

    >>> roads = {0: [(1, 4.0), (2, 1.0)], 2: [(1, 2.0)], 1: []}
    >>> reached = {}
    >>> def expand(label, open):
    ...     if label.id not in reached:
    ...         reached[label.id] = label.time
    ...         for to, length in roads[label.id]:
    ...             open.push(Label(label.time + length, to))
    >>> search([Label(0.0, 0)], expand)
    False
    >>> reached
    {0: 0.0, 2: 1.0, 1: 3.0}
    """
    caught, out, done = Caught(), ctypes.c_void_p(), ctypes.c_int()
    check(lib.tdsp_search_create(None, ctypes.byref(out)), "search")
    handle = owned(out, lib.tdsp_search_free)
    first = [_abi.tdsp_label(*label) for label in starts]
    labels = (_abi.tdsp_label * len(first))(*first)
    problem = _problem(Open(handle.pointer), expand, bound, caught)
    with caught.interruptible():
        status = lib.tdsp_search_run(handle.pointer, ctypes.byref(problem), ctypes.byref(labels), len(first), ctypes.byref(done))
    caught.check(status, "search")
    return bool(done.value)


def _problem(open: Open, expand: Expand, bound: Optional[Bound], caught: Caught) -> _abi.tdsp_search_problem:
    def label_at(pointer: int) -> Label:
        label = _abi.tdsp_label.from_address(pointer)
        return Label(label.time, int(label.id), int(label.kind))

    def expanded(_: Any, label: int, __: int, done: int) -> None:
        ctypes.c_int.from_address(done).value = int(bool(expand(label_at(label), open)))

    problem = _abi.tdsp_search_problem(ctypes.sizeof(_abi.tdsp_search_problem))
    problem.expand = member_type(_abi.tdsp_search_problem, "expand")(caught.status(expanded))
    if bound is not None:
        ask = bound
        problem.bound = member_type(_abi.tdsp_search_problem, "bound")(caught.guard(math.nan, lambda _, label: float(ask(label_at(label)))))
    return problem
