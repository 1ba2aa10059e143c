# SPDX-License-Identifier: MIT
"""How a disc grows: at one rate, as a polynomial, at rates that change, or by any function of time.

Wherever a growth is asked for, a number is a rate; a list of numbers and a dict are what they are in a scene file.
"""
from __future__ import annotations

import ctypes
import math
from dataclasses import dataclass
from typing import Any, Callable, Mapping, Optional, Sequence, Union

from . import _abi
from ._arrays import Floats, address, flat
from ._callbacks import Caught
from .errors import BadScene, NotSupported

Json = Union[float, list[float], dict[str, list[float]]]


@dataclass(frozen=True)
class Polynomial:
    """R(t) = radius + c1 t + c2 t^2 + ...: one to eight coefficients, in lengths per time, per time squared, ...

    >>> Polynomial([0.1, 0.002])
    Polynomial(coefficients=[0.1, 0.002])
    """

    coefficients: Sequence[float]


@dataclass(frozen=True)
class Rates:
    """The rate is `rates[k]` from `times[k]` on, the last for ever; `times[0]` is 0."""

    times: Sequence[float]
    rates: Sequence[float]


@dataclass(frozen=True)
class Law:
    """Growth by any function of time: `function(t)` answers the radius and the rate at `t`, without the robot's radius.

    The radius never falls, the rate is its derivative, and the same time always has the same answer. The function is called while the scene is made, some
    thousand times, for times from 0 to `until`, in the thread that makes the scene, and not afterwards: the scene keeps pieces of polynomials that
    follow it. `kinks` are the times at which it is not smooth; from `until` on the disc keeps the rate that it has there. An exception that
    the function raises comes out of `Scene(...)`.
    """

    function: Callable[[float], tuple[float, float]]
    until: float
    kinks: Sequence[float] = ()


Growth = Union[float, Polynomial, Rates, Law]
GrowthLike = Union[Growth, Sequence[float], Mapping[str, Sequence[float]]]


def growth_from(value: Any, what: str = "growth") -> Growth:
    """A growth from what a scene file has: a number, a list of coefficients, or `{"times": [...], "rates": [...]}`.

    >>> growth_from([0.1, 0.002])
    Polynomial(coefficients=[0.1, 0.002])
    """
    if isinstance(value, (Polynomial, Rates, Law)):
        return value
    if isinstance(value, Mapping):
        missing = {"times", "rates"} - set(value)
        if missing:
            raise BadScene(f"{what}.{sorted(missing)[-1]}: missing")
        return Rates(_numbers(value["times"], f"{what}.times"), _numbers(value["rates"], f"{what}.rates"))
    if isinstance(value, (str, bytes)) or isinstance(value, bool):
        raise BadScene(f"{what}: must be a number, an array or an object")
    try:
        return float(value)
    except (TypeError, ValueError):
        return Polynomial(_numbers(value, what))


def _numbers(value: Any, what: str) -> list[float]:
    if isinstance(value, (str, bytes, Mapping)) or not hasattr(value, "__iter__"):
        raise BadScene(f"{what}: must be an array")
    for i, number in enumerate(value):
        if isinstance(number, (str, bytes, bool)) or not hasattr(number, "__float__"):
            raise BadScene(f"{what}[{i}]: must be a number")
    return [float(number) for number in value]


def growth_to_json(growth: Growth, what: str = "growth") -> Json:
    """What a scene file has for a growth. A Law has nothing: it is a function."""
    if isinstance(growth, Polynomial):
        return [float(c) for c in growth.coefficients]
    if isinstance(growth, Rates):
        return {"times": [float(t) for t in growth.times], "rates": [float(r) for r in growth.rates]}
    if isinstance(growth, Law):
        raise NotSupported(f"{what}: a law is a function, and a scene file cannot hold it")
    return float(growth)


class Struct:
    """A growth as the library takes it, with what must stay alive meanwhile."""

    def __init__(self, growth: Growth, caught: Caught, what: str) -> None:
        self.value = _abi.tdsp_growth()
        self._kept: list[Any] = []
        if isinstance(growth, Polynomial):
            self._polynomial(growth, what)
        elif isinstance(growth, Rates):
            self._rates(growth, what)
        elif isinstance(growth, Law):
            self._law(growth, caught, what)
        else:
            self.value.kind, self.value.rate = _abi.GrowthKind.RATE, growth

    def _array(self, values: Sequence[float], what: str) -> Floats:
        array = flat(values, what)
        self._kept.append(array)
        return array

    def _polynomial(self, growth: Polynomial, what: str) -> None:
        coefficients = self._array(growth.coefficients, what)
        self.value.kind, self.value.count = _abi.GrowthKind.POLYNOMIAL, len(coefficients)
        self.value.values = address(coefficients)

    def _rates(self, growth: Rates, what: str) -> None:
        times, rates = self._array(growth.times, f"{what}.times"), self._array(growth.rates, f"{what}.rates")
        if len(times) != len(rates):
            raise BadScene(f"{what}.rates: {len(rates)} rates for {len(times)} times")
        self.value.kind, self.value.count = _abi.GrowthKind.RATES, len(rates)
        self.value.times, self.value.values = address(times), address(rates)

    def _law(self, growth: Law, caught: Caught, what: str) -> None:
        kinks = self._array(growth.kinks, f"{what}.kinks")
        callback = _abi.tdsp_growth_law(_law_callback(growth, caught))
        self._kept.append(callback)
        self.value.kind, self.value.count, self.value.times = _abi.GrowthKind.LAW, len(kinks), address(kinks) if len(kinks) else None
        self.value.law, self.value.until = callback, growth.until


def _law_callback(law: Law, caught: Caught) -> Callable[[Optional[int], float, int, int], None]:
    def ask(time: float) -> tuple[float, float]:
        radius, rate = law.function(time)
        return float(radius), float(rate)

    # A radius that is no number makes the library give up.
    guarded = caught.guard((math.nan, math.nan), ask)

    def callback(_: Optional[int], time: float, radius: int, rate: int) -> None:
        numbers = guarded(time)
        ctypes.c_double.from_address(radius).value, ctypes.c_double.from_address(rate).value = numbers

    return callback
