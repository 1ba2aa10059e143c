# SPDX-License-Identifier: MIT
"""Finding and loading libtdsp, and owning what it allocates.

A call lets go of the interpreter's lock while the library works (ctypes.CDLL), so other threads of Python go on.
"""
from __future__ import annotations

import ctypes
import os
import pathlib
import weakref
from typing import Any, Callable, Optional

from . import _abi

SONAME = f"libtdsp.so.{_abi.VERSION_MAJOR}"


def _candidates() -> list[str]:
    """Where the library may be: named by the environment; inside the wheel; wherever the system has it."""
    named = os.environ.get("TDSP_LIBRARY")
    if named:
        return [named]
    inside = pathlib.Path(__file__).resolve().parent / "lib" / SONAME
    return [str(inside)] if inside.exists() else [SONAME]


def _load() -> ctypes.CDLL:
    [name] = _candidates()
    try:
        library = ctypes.CDLL(name)
    except OSError as error:
        raise ImportError(f"tdsp: cannot load {name}: {error}. Install the wheel, or name the library in TDSP_LIBRARY") from error
    for function, (result, arguments) in _abi.FUNCTIONS.items():
        try:
            symbol = getattr(library, function)
        except AttributeError as error:
            raise ImportError(f"tdsp: {name} has no {function}(): it is another version than this package") from error
        symbol.restype, symbol.argtypes = result, arguments
    return library


lib: Any = _load()


def version() -> str:
    """The version of the library that was loaded, "MAJOR.MINOR.PATCH".

    >>> version().count(".")
    2
    """
    text: bytes = lib.tdsp_version()
    return text.decode()


def _check_version() -> None:
    # Before 1.0 a new minor version may change the interface.
    wanted, found = (_abi.VERSION_MAJOR, _abi.VERSION_MINOR), tuple(map(int, version().split(".")[:2]))
    if found != wanted:
        raise ImportError(f"tdsp: this package is for libtdsp {wanted[0]}.{wanted[1]}, and the library loaded is {version()}")


_check_version()


class Handle:
    """A pointer that the library handed out, freed when nobody refers to it any more.

    `keep` are handles that must be freed later: a solver keeps its scene. The list of finalizers, not the handle, holds on to them: among things that refer
    to each other in a circle the collector finalizes in any order, but it sees that what is held from elsewhere is no garbage yet. At the interpreter's end
    nothing is freed, as threads may still be at work.
    """

    __slots__ = ("pointer", "__weakref__")

    def __init__(self, pointer: Optional[int], free: Callable[[int], Any], *keep: Handle) -> None:
        self.pointer: Any = pointer
        weakref.finalize(self, _free, free, pointer, keep).atexit = False


def _free(free: Callable[[int], Any], pointer: Any, keep: tuple[Handle, ...]) -> None:
    free(pointer)
    del keep


def owned(out: ctypes.c_void_p, free: Callable[[int], Any], *keep: Handle) -> Handle:
    """The handle of what the library put into `out`; before anything is raised, so that nothing is lost when it made it all the same."""
    return Handle(out.value, free if out.value else _nothing, *keep)


def _nothing(_: Optional[int]) -> None:
    """What there is to free where the library made nothing."""
