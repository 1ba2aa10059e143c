# SPDX-License-Identifier: MIT
"""NumPy arrays as the library reads and writes them: its structs as dtypes, addresses, and memory of the library seen as arrays."""
from __future__ import annotations

import ctypes
from typing import Any, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _abi
from .errors import InvalidArgument

Floats = npt.NDArray[np.float64]
Statuses = npt.NDArray[np.uint32]
PointLike = Union[Sequence[float], Floats]

#: struct tdsp_disc: centre (2), radius, growth.
DISC_DTYPE = np.dtype([("center", np.float64, (2,)), ("radius", np.float64), ("growth", np.float64)])

#: struct tdsp_leg. A leg's kind is LEG_LINE, LEG_ARC or LEG_CURVE; `disc` is NO_DISC for a line.
LEG_DTYPE = np.dtype([
    ("kind", np.uint32), ("disc", np.uint32), ("turn", np.int32), ("reserved", np.uint32),
    ("start_time", np.float64), ("end_time", np.float64), ("from", np.float64, (2,)), ("to", np.float64, (2,)), ("center", np.float64, (2,)),
    ("radius_from", np.float64), ("radius_to", np.float64), ("angle_from", np.float64), ("sweep", np.float64),
    ("rate_from", np.float64), ("rate_to", np.float64), ("bend_from", np.float64), ("bend_to", np.float64), ("speed", np.float64)])

#: struct tdsp_row: departure, travel time left (rounded up) and right (rounded down) of it, legs of the row's path.
ROW_DTYPE = np.dtype([("departure", np.float64), ("left", np.float64), ("right", np.float64), ("legs", np.uint64)])


def floats(values: npt.ArrayLike, what: str) -> Floats:
    """An array of doubles, contiguous; the caller's own where it is one already."""
    try:
        return np.asarray(values, dtype=np.float64, order="C")
    except (TypeError, ValueError) as error:
        raise InvalidArgument(f"{what}: must be numbers: {error}") from None


def flat(values: npt.ArrayLike, what: str) -> Floats:
    """The same of one dimension."""
    array = floats(values, what)
    if array.ndim != 1:
        raise InvalidArgument(f"{what}: must have one dimension, not the shape {array.shape}")
    return array


def points(values: npt.ArrayLike, what: str) -> Floats:
    """An array of points: n times 2."""
    array = floats(values, what)
    if array.size == 0:
        return array.reshape(0, 2)
    if array.ndim != 2 or array.shape[1] != 2:
        raise InvalidArgument(f"{what}: must have the shape (n, 2), not {array.shape}")
    return array


def point(value: PointLike, what: str) -> _abi.tdsp_point:
    """A point of the library from two numbers."""
    array = floats(value, what)
    if array.shape != (2,):
        raise InvalidArgument(f"{what}: a point has exactly two numbers")
    return _abi.tdsp_point(float(array[0]), float(array[1]))


def address(array: npt.NDArray[Any]) -> int:
    return int(array.ctypes.data)


class _Lent:
    """Memory that belongs to `owner`, as NumPy takes it up: the arrays made of it keep the owner alive."""

    def __init__(self, pointer: int, shape: tuple[int, ...], dtype: np.dtype[Any], owner: object) -> None:
        self.owner = owner
        self.__array_interface__ = {"version": 3, "shape": shape, "typestr": dtype.str, "descr": dtype.descr, "data": (pointer, True)}


def lent(pointer: int, count: int, dtype: np.dtype[Any], owner: object) -> npt.NDArray[Any]:
    """`count` items in memory of `owner`: a read-only array, not copied, that keeps the owner alive."""
    if count == 0 or not pointer:
        return np.empty(0, dtype)
    return np.asarray(_Lent(pointer, (count,), dtype, owner))


def bytes_at(pointer: int, count: int, owner: object) -> npt.NDArray[np.uint8]:
    """The same for bytes."""
    return lent(pointer, count, np.dtype(np.uint8), owner)


def view(buffer: Any) -> npt.NDArray[np.uint8]:
    """The bytes of any buffer (bytes, mmap, memoryview, array), not copied."""
    whole = memoryview(buffer)
    if not whole.c_contiguous:
        raise InvalidArgument("the buffer must be contiguous")
    return np.frombuffer(whole, dtype=np.uint8) if whole.nbytes else np.empty(0, np.uint8)


def put(pointer: int, value: float) -> None:
    """Write a double where the library asked for one."""
    ctypes.c_double.from_address(pointer).value = value


def text_address(text: bytes) -> Optional[int]:
    """Where the bytes are; they must stay alive as long as the address is used. None where there are none."""
    return ctypes.cast(ctypes.c_char_p(text), ctypes.c_void_p).value if text else None
