# SPDX-License-Identifier: MIT
"""Callbacks in Python, called by the library.

An exception may not cross C. The first one is kept here, the library is told that the callback failed, and when the library has returned, the exception
goes on from the place that called it, with its own traceback.

Ctrl-C is kept in the same way: raised by the interpreter at the first instruction of a callback, before anything there could catch it, it would be lost.
"""
from __future__ import annotations

import signal
import threading
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional, TypeVar

from ._abi import Status
from .errors import NoWay, check

T = TypeVar("T")


def member_type(struct: Any, name: str) -> Any:
    """The type of a struct's member: for a callback, what makes one of a function."""
    return next(entry[1] for entry in struct._fields_ if entry[0] == name)


class Caught:
    """What the callbacks of one call of the library raised."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._first: Optional[BaseException] = None

    def keep(self, error: BaseException) -> None:
        with self._lock:
            if self._first is None:
                self._first = error

    @property
    def any(self) -> bool:
        return self._first is not None

    def guard(self, failed: T, body: Callable[..., T]) -> Callable[..., T]:
        """`body`, answering `failed` when it raises, and without being called when something was raised before."""

        def guarded(*arguments: Any) -> T:
            if self._first is not None:
                return failed
            try:
                return body(*arguments)
            except BaseException as error:  # also KeyboardInterrupt: it must not be lost in C
                self.keep(error)
                return failed

        return guarded

    def status(self, body: Callable[..., None]) -> Callable[..., int]:
        """`body` as a callback that returns a status: OK, the answer of a NoWay that it raises, or FAILED."""

        def answer(*arguments: Any) -> int:
            try:
                body(*arguments)
            except NoWay as no:
                return int(no.status)
            return int(Status.OK)

        return self.guard(int(Status.FAILED), answer)

    def raise_first(self) -> None:
        """Let the exception go on, if there was one."""
        if self._first is not None:
            error, self._first = self._first, None
            raise error

    def check(self, status: int, about: str = "") -> None:
        """What a callback raised, else what the library says."""
        self.raise_first()
        check(status, about)

    @contextmanager
    def interruptible(self) -> Iterator[None]:
        """Meanwhile Ctrl-C is kept here as an exception: callbacks, which see `any`, stop the library, and `check` raises it."""
        default = threading.current_thread() is threading.main_thread() and signal.getsignal(signal.SIGINT) is signal.default_int_handler
        if not default:
            yield
            return
        signal.signal(signal.SIGINT, lambda *_: self.keep(KeyboardInterrupt()))
        try:
            yield
        finally:
            signal.signal(signal.SIGINT, signal.default_int_handler)
