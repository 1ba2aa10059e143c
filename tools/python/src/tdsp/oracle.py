# SPDX-License-Identifier: MIT
"""Oracles: worlds of your own that tables are built over, and whether they keep their promises (docs/oracles.md)."""
from __future__ import annotations

import ctypes
import math
import time
from dataclasses import dataclass
from typing import Any, Callable, Optional, Union

import numpy as np

from . import _abi
from ._abi import Monotone, OracleCallback, OracleRule, Status
from ._arrays import LEG_DTYPE, address, put, view
from ._callbacks import Caught, member_type
from ._library import lib
from .errors import InvalidArgument, NoWay, check
from .path import Path
from .solver import Solver, Within
from .values import Gap

OraclePath = Union[Path, bytes, None]


class Oracle:
    """When does one arrive who leaves at `t`? Derive from it, answer `earliest_arrival`, and build tables over your world.

    `monotone` says what never decreases: "arrival" (who is early may wait: roads, ferries) or "travel" (what is in the way only grows). `error` is the
    stated error of arrivals, `|A' - A| <= error * (T + time_scale)`; `time_scale` is a time that is typical of the problem.

    These methods are looked for too, and may be left out:

    | method | answers |
    |---|---|
    | `latest_departure(arrival) -> float` | the latest departure that arrives by `arrival`, which may be infinite; raises `ArrivalTooEarly` |
    | `path() -> Path, bytes or None` | the path of the last arrival that was answered: legs, or bytes that only you understand |
    | `last_reason(departure) -> Status` | why departures end at `departure` |
    | `earliest_arrival_within(departure, delta) -> (arrival, lower)` | an arrival whose travel time is at most `1 + delta` times the least |
    | `latest_departure_between(arrival, after, before) -> (departure, arrives)` | `latest_departure` where it is known to lie between |
    | `jump_gap(departure, before, after) -> Gap or None` | what closes at a jump of the travel time |

    Where there is no way raise `NoWay` or a class of it (`SourceCovered`, `DestinationCovered`, `CutOff`, `Unreachable`), or answer infinity, which is
    `Unreachable`. Any other exception ends the build and comes out of it. One oracle is asked one question at a time.

    >>> class Bridge(Oracle):
    ...     "Open for ships from minute 20 to 30; crossing it takes 5."
    ...     def earliest_arrival(self, departure):
    ...         return 35.0 if 20 < departure < 30 else departure + 5.0
    >>> import tdsp
    >>> table = tdsp.build(Bridge(), guarantee="absolute", delta=1.0, horizon=60.0)
    >>> table.departure(34.0).departure
    20.0
    """

    monotone: str = "arrival"
    error: float = 0.0
    time_scale: float = 0.0

    def earliest_arrival(self, departure: float) -> float:
        """A(departure), a time not before the departure."""
        raise NotImplementedError("an oracle answers earliest_arrival(departure)")


class SolverOracle(Oracle):
    """A solver as an oracle, about the ends that it holds: `Solver.oracle()`. The sampler asks it without coming back to Python."""

    monotone = "travel"

    def __init__(self, solver: Solver) -> None:
        self.solver = solver
        struct = _abi.tdsp_oracle()
        with solver._asking() as pointer:
            check(lib.tdsp_solver_oracle(pointer, ctypes.byref(struct)))
        self._struct = struct
        self.error, self.time_scale = struct.error, struct.time_scale

    def earliest_arrival(self, departure: float) -> float:
        return self.solver.arrival(departure)

    def latest_departure(self, arrival: float) -> float:
        """The solver's."""
        return self.solver.latest_departure(arrival)

    def earliest_arrival_within(self, departure: float, delta: float) -> Within:
        """The solver's."""
        return self.solver.arrival_within(departure, delta)


class Struct:
    """An oracle as the library takes it. It is used while this object lives, and not longer."""

    def __init__(self, oracle: Oracle, caught: Caught) -> None:
        self.value = _abi.tdsp_oracle()
        self._oracle = oracle
        self._handed_out: Any = None
        if isinstance(oracle, SolverOracle):
            ctypes.memmove(ctypes.byref(self.value), ctypes.byref(oracle._struct), ctypes.sizeof(_abi.tdsp_oracle))
            return
        lib.tdsp_oracle_init(ctypes.byref(self.value))
        self.value.monotone = monotone_from(oracle.monotone)
        self.value.error, self.value.time_scale = float(oracle.error), float(oracle.time_scale)
        for name, body in self._bodies().items():
            setattr(self.value, name, member_type(_abi.tdsp_oracle, name)(caught.status(body)))

    def _bodies(self) -> dict[str, Callable[..., None]]:
        """A callback for each method that the oracle has."""
        known: dict[str, Callable[..., None]] = {
            "earliest_arrival": self._earliest, "latest_departure": self._latest, "path": self._path, "last_reason": self._reason,
            "earliest_arrival_within": self._within, "latest_departure_between": self._between, "jump_gap": self._gap}
        return {name: body for name, body in known.items() if callable(getattr(self._oracle, name, None))}

    def _ask(self, name: str, *arguments: float) -> Any:
        return getattr(self._oracle, name)(*arguments)

    def _earliest(self, _: Any, departure: float, arrival: int) -> None:
        answer = float(self._oracle.earliest_arrival(departure))
        if answer == math.inf:
            raise NoWay
        put(arrival, answer)

    def _latest(self, _: Any, arrival: float, departure: int) -> None:
        put(departure, float(self._ask("latest_departure", arrival)))

    def _reason(self, _: Any, departure: float, reason: int) -> None:
        ctypes.c_uint.from_address(reason).value = int(self._ask("last_reason", departure))

    def _within(self, _: Any, departure: float, delta: float, arrival: int, lower: int) -> None:
        answer, least = self._ask("earliest_arrival_within", departure, delta)
        if answer == math.inf:
            raise NoWay
        put(arrival, float(answer))
        put(lower, float(least))

    def _between(self, _: Any, arrival: float, after: float, before: float, departure: int, arrives: int) -> None:
        answer, when = self._ask("latest_departure_between", arrival, after, before)
        put(departure, float(answer))
        put(arrives, float(when))

    def _path(self, _: Any, out: int) -> None:
        path = _abi.tdsp_oracle_path.from_address(out)
        answer = self._ask("path")
        path.legs, path.leg_count, path.bytes, path.byte_count = None, 0, None, 0
        if isinstance(answer, Path):
            self._handed_out = answer.legs
            path.legs, path.leg_count = address(answer.legs), len(answer.legs)
        elif isinstance(answer, np.ndarray) and answer.dtype == LEG_DTYPE:
            self._handed_out = np.ascontiguousarray(answer)
            path.legs, path.leg_count = address(self._handed_out), len(self._handed_out)
        elif answer is not None:
            self._handed_out = view(bytes(answer))
            path.bytes, path.byte_count = address(self._handed_out), len(self._handed_out)

    def _gap(self, _: Any, departure: float, before: float, after: float, out: int) -> None:
        answer: Optional[Gap] = self._ask("jump_gap", departure, before, after)
        if answer is None:
            raise _NoGap
        gap = _abi.tdsp_gap.from_address(out)
        gap.first, gap.second = answer.first, _abi.NO_DISC if answer.second is None else answer.second
        gap.time, gap.place = answer.time, _abi.tdsp_point(*answer.place)


class _NoGap(NoWay):
    """How a callback says that there is no gap."""

    status = Status.NO_ANSWER


def monotone_from(word: str) -> int:
    words = {"travel": Monotone.TRAVEL, "arrival": Monotone.ARRIVAL}
    if word not in words:
        raise InvalidArgument(f'monotone: "travel" or "arrival", not {word!r}')
    return words[word]


@dataclass(frozen=True)
class Finding:
    """A promise that an oracle was seen to break; docs/oracles.md says what the numbers are of each rule. NaN stands for none."""

    #: The rule's name, e.g. "late".
    rule: str
    #: Which method, e.g. "latest_departure".
    callback: str
    #: One English sentence without the numbers.
    text: str
    status: Status
    asked: float
    answered: float
    other: float
    seen: float
    expected: float


@dataclass(frozen=True)
class Findings:
    """What an oracle was seen to do. True where nothing is wrong."""

    found: tuple[Finding, ...]
    #: Rules that came up, and how often each was seen broken.
    looked_at: tuple[str, ...]
    times: dict[str, int]
    calls: int
    #: The last departure that was seen to have a way; negative when none has.
    last_departure: float
    #: Seconds of the slowest call.
    slowest: float
    #: False when `calls` ended it.
    complete: bool

    def __bool__(self) -> bool:
        return not self.times


def rule_name(rule: int) -> str:
    """A rule's name.

    >>> rule_name(OracleRule.PATH_JOINS)
    'path_joins'
    """
    name: bytes = lib.tdsp_oracle_rule_name(rule)
    return name.decode()


def callback_name(callback: int) -> str:
    """The name of a method of an oracle.

    >>> callback_name(OracleCallback.EARLIEST_ARRIVAL)
    'earliest_arrival'
    """
    name: bytes = lib.tdsp_oracle_callback_name(callback)
    return name.decode()


def check_oracle(oracle: Oracle, *, horizon: float = math.inf, departures: int = 100, calls: int = 100_000, seed: int = 1,
                 seconds: float = math.inf) -> Findings:
    """Ask an oracle a thousand questions or so and hold its answers against each other and its promises.

    :param horizon: departures are looked at up to this; a time
    :param departures: how many are spread over them, 2 to 1,000,000
    :param calls: at most so many questions
    :param seed: of the choice of departures
    :param seconds: how long a call may take

    What the oracle raises, other than NoWay, comes out of here.

    >>> class Impatient(Oracle):
    ...     def earliest_arrival(self, departure):
    ...         return 30.0 - departure if departure < 10 else departure + 1.0
    >>> check_oracle(Impatient()).found[0].rule
    'order'
    """
    caught = Caught()
    struct, options, out = Struct(oracle, caught), _abi.tdsp_oracle_check_options(), _abi.tdsp_oracle_findings()
    lib.tdsp_oracle_check_options_init(ctypes.byref(options))
    options.horizon, options.departures, options.calls, options.seed, options.seconds = horizon, departures, calls, seed, seconds
    options.clock = member_type(_abi.tdsp_oracle_check_options, "clock")(lambda _: time.perf_counter())
    with caught.interruptible():
        status = lib.tdsp_oracle_check(ctypes.byref(struct.value), ctypes.byref(options), None, ctypes.byref(out))
    caught.raise_first()
    if status != Status.BAD_ORACLE:
        check(status)
    return _findings(out)


def _findings(out: _abi.tdsp_oracle_findings) -> Findings:
    found = tuple(_finding(out.found[i]) for i in range(out.count))
    looked_at = tuple(rule_name(rule) for rule in OracleRule if out.looked_at >> rule & 1)
    times = {rule_name(rule): int(out.times[rule]) for rule in OracleRule if out.broken >> rule & 1}
    return Findings(found, looked_at, times, int(out.calls), out.last_departure, out.slowest, bool(out.complete))


def _finding(finding: _abi.tdsp_oracle_finding) -> Finding:
    text: bytes = lib.tdsp_oracle_finding_text(ctypes.byref(finding))
    return Finding(rule_name(finding.rule), callback_name(finding.callback), text.decode(), Status(finding.status), finding.asked, finding.answered,
                   finding.other, finding.seen, finding.expected)
