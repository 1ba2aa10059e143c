# SPDX-License-Identifier: MIT
"""What tables and matrices have in common: bytes that the library opened in place."""
from __future__ import annotations

import ctypes
import mmap
from typing import Any, ClassVar, Generic, Optional, TypeVar

import numpy as np
import numpy.typing as npt

from ._files import PathLike, write_atomically

Struct = TypeVar("Struct", bound=ctypes.Structure)
Self = TypeVar("Self", bound="Opened[Any]")


class Opened(Generic[Struct]):
    """Bytes, and the library's struct that reads them. Whoever derives from it opens them in __init__(buffer, _about=what errors name)."""

    _kind: ClassVar[str]
    _bytes: npt.NDArray[np.uint8]
    _struct: Optional[Struct]

    @classmethod
    def open(cls: type[Self], path: PathLike) -> Self:
        """Map a file and open what is in it. The pages that questions touch are read, and shared by all processes that do.

        Use it in a `with`, or drop it: the file is unmapped when this and everything that shows its bytes are gone. A file that is changed in
        place meanwhile changes the answers; one that is replaced by renaming, as `save` does, does not.

        :raises DataError: with the file's name; see the class
        :raises OSError: the file cannot be read
        """
        with open(path, "rb") as file:
            # An empty file cannot be mapped; the library says what is wrong with it.
            empty = file.seek(0, 2) == 0
            mapped = b"" if empty else mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        return cls(mapped, _about=str(path))  # type: ignore[call-arg]

    def close(self) -> None:
        """Let go of the bytes. Questions raise ValueError from now on; tables that were taken from a matrix stay open."""
        self._struct, self._bytes = None, np.empty(0, np.uint8)

    def __enter__(self: Self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def _pointer(self) -> Any:
        if self._struct is None:
            raise ValueError(f"tdsp: this {self._kind} is closed")
        return ctypes.byref(self._struct)

    @property
    def buffer(self) -> memoryview:
        """The bytes, not copied, read-only."""
        assert self._pointer is not None
        return self._bytes.data.toreadonly()

    def __bytes__(self) -> bytes:
        return self.buffer.tobytes()

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (bytes(self),)

    def save(self, path: PathLike) -> None:
        """Write the bytes to a file, which appears whole or not at all."""
        write_atomically(path, self.buffer)
