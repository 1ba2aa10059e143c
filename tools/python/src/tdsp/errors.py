# SPDX-License-Identifier: MIT
"""What goes wrong, one class for each status of the library, with the library's words.

| base | what it stands for | also a |
|---|---|---|
| `NoWay` | the question was understood, and the answer is no: this is why there is no number | |
| `UsageError` | a mistake of the caller | `ValueError` |
| `DataError` | bad scenes, tables, paths, oracles | `ValueError` |
| `SystemFailure` | memory, a callback that stopped the work | |

All are `TdspError`s, whose `status` is the library's. Questions on arrays raise no `NoWay`: they answer an infinite number, and a status beside it.
"""
from __future__ import annotations

from typing import Optional

from ._abi import Status
from ._library import lib


def status_text(status: int) -> str:
    """One English sentence for a status, without a full stop.

    >>> status_text(Status.CUT_OFF)
    'Growing discs close every way to the destination'
    """
    text: bytes = lib.tdsp_status_text(status)
    return text.decode()


def status_name(status: int) -> str:
    """A status's stable name, as the command prints it.

    >>> status_name(Status.CUT_OFF)
    'cut_off'
    """
    text: bytes = lib.tdsp_status_name(status)
    return text.decode()


def is_answer(status: int) -> bool:
    """Is this an answer, yes or no, rather than an error?

    >>> is_answer(Status.CUT_OFF), is_answer(Status.BAD_SCENE)
    (True, False)
    """
    return bool(lib.tdsp_status_is_answer(status))


class TdspError(Exception):
    """Anything that libtdsp reports. `status` says what; the text is the library's sentence, with the place where there is one."""

    status = Status.FAILED

    def __init__(self, message: Optional[str] = None) -> None:
        super().__init__(status_text(self.status) if message is None else message)


class NoWay(TdspError):
    """The question was understood, and this is why there is no number."""

    status = Status.UNREACHABLE


class SourceCovered(NoWay):
    """The source lies inside a disc at the departure."""

    status = Status.SOURCE_COVERED


class DestinationCovered(NoWay):
    """The way is open, but longer than the destination stays free."""

    status = Status.DESTINATION_COVERED


class CutOff(NoWay):
    """Growing discs close every way to the destination."""

    status = Status.CUT_OFF


class ArrivalTooEarly(NoWay):
    """The arrival asked for is before A(0)."""

    status = Status.ARRIVAL_TOO_EARLY


class AfterHorizon(NoWay):
    """The departure is after the horizon that ended the table."""

    status = Status.HORIZON


class OutsideTable(NoWay):
    """The table says nothing about this departure."""

    status = Status.OUTSIDE_TABLE


class Unreachable(NoWay):
    """An oracle found no way."""

    status = Status.UNREACHABLE


class UsageError(TdspError, ValueError):
    """A mistake of the caller."""

    status = Status.INVALID_ARGUMENT


class InvalidArgument(UsageError):
    """NaN, infinity or a value out of its stated range."""

    status = Status.INVALID_ARGUMENT


class BufferTooSmall(UsageError):
    """A buffer is too small. The package makes its own, so that this is seen only by those who call the C interface."""

    status = Status.BUFFER_TOO_SMALL


class NoAnswer(UsageError):
    """There is no last answer with a path, no jump, no leg of that number."""

    status = Status.NO_ANSWER


class NotSupported(UsageError):
    """This oracle, guarantee or table cannot do that, or a time or a disc is too far away."""

    status = Status.NOT_SUPPORTED


class NeedsHorizon(UsageError):
    """No disc ever ends the departures, and no horizon was given."""

    status = Status.NEEDS_HORIZON


class TooManyRows(UsageError):
    """The guarantee needs more rows than allowed."""

    status = Status.TOO_MANY_ROWS


class DataError(TdspError, ValueError):
    """Bad data: scenes, tables, paths, oracles."""

    status = Status.BAD_SCENE


class BadScene(DataError):
    """Something of the scene is missing, of a wrong type, or out of its range."""

    status = Status.BAD_SCENE


class BadMagic(DataError):
    """These bytes are not a table."""

    status = Status.BAD_MAGIC


class BadVersion(DataError):
    """A table of a newer major format version."""

    status = Status.BAD_VERSION


class BadLength(DataError):
    """A table shorter or longer than its header says."""

    status = Status.BAD_LENGTH


class BadChecksum(DataError):
    """The bytes of a table were changed."""

    status = Status.BAD_CHECKSUM


class BadTable(DataError):
    """Offsets, order, ranges or finiteness of a table are wrong."""

    status = Status.BAD_TABLE


class BadPath(DataError):
    """Legs that do not join, or run backwards in time."""

    status = Status.BAD_PATH


class StaleTable(DataError):
    """The table was built for another scene."""

    status = Status.STALE_TABLE


class BadOracle(DataError):
    """An oracle broke what it declared."""

    status = Status.BAD_ORACLE


class Shrinks(DataError):
    """The question reaches to a time at which a disc's radius shrinks."""

    status = Status.SHRINKS


class SystemFailure(TdspError):
    """Memory, or a callback that stopped the work."""

    status = Status.FAILED


class NoMemory(SystemFailure, MemoryError):
    """There is not enough memory."""

    status = Status.NO_MEMORY


class Cancelled(SystemFailure):
    """A progress callback asked to stop."""

    status = Status.CANCELLED


class Failed(SystemFailure):
    """A callback failed without saying more."""

    status = Status.FAILED


_GROUPS = (NoWay, UsageError, DataError, SystemFailure)
_CLASSES: dict[int, type[TdspError]] = {kind.status: kind for group in _GROUPS for kind in group.__subclasses__()}


def error_for(status: int, about: str = "") -> TdspError:
    """The exception for a status, with what it is about in front of the library's sentence.

    >>> error_for(Status.BAD_MAGIC, "fire.json")
    BadMagic('fire.json: These bytes are not a table')
    """
    kind = _CLASSES.get(status, TdspError)
    text = status_text(status)
    return kind(f"{about}: {text}" if about else text)


def check(status: int, about: str = "") -> None:
    """Raise the exception for a status that is not OK."""
    if status != Status.OK:
        raise error_for(status, about)


def check_answer(status: int, about: str = "") -> None:
    """Raise the exception for a status that is no answer; one that says why there is no number passes."""
    if not lib.tdsp_status_is_answer(status):
        raise error_for(status, about)
