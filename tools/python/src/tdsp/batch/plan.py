# SPDX-License-Identifier: MIT
"""What a batch is: items, questions, and how they are cut into parts. A plan is written down once and read by whoever goes on with it."""
from __future__ import annotations

import hashlib
import itertools
import json
import math
import pathlib
from dataclasses import asdict, dataclass, field
from typing import Any, Iterable, Iterator, NamedTuple, Optional, Sequence

from .._files import PathLike, write_atomically
from ..errors import DataError, InvalidArgument
from ..sampler import Options, check_options
from ..values import Ends, EndsLike, Point

VERSION = 1
FILE = "batch.json"


class BadInput(DataError):
    """A file of a batch is wrong; the message names the file, the place and the reason."""


@dataclass(frozen=True)
class Questions:
    """What is asked of each item: arrivals for departures, latest departures for arrivals (times), and a table."""

    departures: Sequence[float] = ()
    arrivals: Sequence[float] = ()
    tables: bool = False
    options: Options = field(default_factory=Options)

    def check(self) -> None:
        """Raise what is wrong, before anything is begun."""
        if not (self.departures or self.arrivals or self.tables):
            raise InvalidArgument("questions: departures, arrivals or tables must be asked for")
        for time in self.departures:
            if not (math.isfinite(time) and time >= 0):
                raise InvalidArgument(f"departures: {time} is not finite, or negative")
        for time in self.arrivals:
            if not time >= 0:
                raise InvalidArgument(f"arrivals: {time} is not a number, or negative")
        check_options(self.options)

    def to_dict(self) -> dict[str, Any]:
        """As JSON, where an infinite horizon is null."""
        out = asdict(self)
        out["departures"], out["arrivals"] = list(self.departures), [None if math.isinf(a) else a for a in self.arrivals]
        out["options"]["horizon"] = None if math.isinf(self.options.horizon) else self.options.horizon
        return out

    @classmethod
    def from_dict(cls, value: dict[str, Any]) -> Questions:
        options = {**value["options"], "horizon": math.inf if value["options"]["horizon"] is None else value["options"]["horizon"]}
        return cls(tuple(value["departures"]), tuple(math.inf if a is None else a for a in value["arrivals"]), value["tables"], Options(**options))


class Item(NamedTuple):
    """One of a batch. A scene: the file, where in it (of a .jsonl file), and how many bytes. A pair: the file of the scene, and the ends."""

    name: str
    path: str
    offset: int = 0
    length: Optional[int] = None
    ends: Optional[EndsLike] = None


@dataclass(frozen=True)
class Plan:
    """Items, questions, and how many items make a part. `digest` tells it from every other plan, by the content of the files too."""

    items: Sequence[Item]
    questions: Questions
    part_size: int
    digest: str

    @classmethod
    def make(cls, items: Sequence[Item], questions: Questions, part_size: int = 16) -> Plan:
        """Cut items into parts of `part_size`: so many that each takes some seconds, for each costs the scheduler some milliseconds (docs/python.md)."""
        questions.check()
        if not items:
            raise InvalidArgument("items: there are none")
        if part_size < 1:
            raise InvalidArgument(f"part_size: at least 1, not {part_size}")
        whole = hashlib.sha256(json.dumps([VERSION, questions.to_dict(), part_size]).encode())
        for path in dict.fromkeys(item.path for item in items):
            whole.update(_content(path))
        for item in items:
            whole.update(json.dumps([item.name, item.offset, item.length, item.ends]).encode())
        return cls(items, questions, part_size, whole.hexdigest())

    @property
    def parts(self) -> int:
        """How many parts there are."""
        return -(-len(self.items) // self.part_size)

    def part(self, number: int) -> list[tuple[int, Item]]:
        """The items of a part with their numbers."""
        start = number * self.part_size
        return list(enumerate(self.items[start:start + self.part_size], start))

    def save(self, folder: PathLike) -> None:
        """Write the plan down, as the first thing in a folder."""
        value = {"version": VERSION, "digest": self.digest, "part_size": self.part_size, "questions": self.questions.to_dict(),
                 "items": [list(item) for item in self.items]}
        write_atomically(pathlib.Path(folder) / FILE, (json.dumps(value, ensure_ascii=False) + "\n").encode())

    @classmethod
    def load(cls, folder: PathLike) -> Plan:
        """The plan of a folder. The files are taken to be as they were."""
        path = pathlib.Path(folder) / FILE
        try:
            value = json.loads(path.read_text(encoding="utf-8"))
            if value["version"] != VERSION:
                raise BadInput(f"{path}: a batch of version {value['version']}, where {VERSION} is known")
            items = [Item(name, file, offset, length, _ends(ends)) for name, file, offset, length, ends in value["items"]]
            return cls(items, Questions.from_dict(value["questions"]), value["part_size"], value["digest"])
        except (KeyError, TypeError, ValueError) as error:
            if isinstance(error, BadInput):
                raise
            raise BadInput(f"{path}: not the plan of a batch: {error!r}") from None


def _ends(value: Any) -> Optional[Ends]:
    return None if value is None else Ends(Point(*value[0]), Point(*value[1]))


def _content(path: str) -> bytes:
    """A digest of a file; of one that is not there its name, for it may be mended: it is an item's error, not the batch's."""
    try:
        with open(path, "rb") as file:
            digest = hashlib.sha256()
            while block := file.read(1 << 20):
                digest.update(block)
            return digest.digest()
    except OSError:
        return path.encode()


def read_scenes(paths: Iterable[PathLike]) -> list[Item]:
    """The scenes of files and folders: a .json file is a scene, each line of a .jsonl file is one, a folder is what is in it, by name.

    A file that cannot be read is an item too: its row will say so.
    """
    return [item for path in paths for item in _scenes(pathlib.Path(path).absolute())]


def _scenes(path: pathlib.Path) -> Iterator[Item]:
    if path.is_dir():
        found = sorted(entry for entry in path.iterdir() if entry.suffix in (".json", ".jsonl"))
        if not found:
            raise BadInput(f"{path}: no .json or .jsonl file in this folder")
        for entry in found:
            yield from _scenes(entry)
    elif path.suffix == ".jsonl" and path.exists():
        yield from _lines(path)
    else:
        yield Item(path.stem, str(path))


def _lines(path: pathlib.Path) -> Iterator[Item]:
    offset = 0
    with open(path, "rb") as file:
        for number, line in enumerate(file, 1):
            if line.strip():
                yield Item(f"{path.stem}-{number}", str(path), offset, len(line))
            offset += len(line)


class Place(NamedTuple):
    """A place of a list, and its name or ""."""

    place: Point
    name: str


def _fields(path: PathLike) -> Iterator[tuple[str, list[str]]]:
    """Where a line is, and its fields, separated by a comma or white space; # begins a comment."""
    try:
        text = pathlib.Path(path).read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise BadInput(f"{path}: not UTF-8: {error.reason} at byte {error.start}") from None
    for number, line in enumerate(text.splitlines(), 1):
        line = line.partition("#")[0].strip()
        if line:
            yield f"{path}: line {number}", line.replace(",", " ", 4 if "," in line else 0).split()


def _numbers(where: str, fields: list[str], count: int, what: str) -> list[float]:
    try:
        numbers = [float(field) for field in fields[:count]]
    except ValueError:
        numbers = []
    if len(numbers) != count or not all(math.isfinite(number) and abs(number) <= 1e100 for number in numbers):
        raise BadInput(f"{where}: {what}")
    return numbers


def read_places(path: PathLike) -> list[Place]:
    """A list of places, one a line, `x,y` or `x y`, with a name behind it where wanted; as `tdsp matrix` reads it."""
    places = []
    for where, fields in _fields(path):
        x, y = _numbers(where, fields, 2, "a place is two numbers, x and y")
        places.append(Place(Point(x, y), " ".join(fields[2:])))
    if not places:
        raise BadInput(f"{path}: no place")
    return places


def read_pairs(scene: PathLike, sources: Iterable[Place] = (), destinations: Iterable[Place] = (), pairs: Optional[PathLike] = None) -> list[Item]:
    """Pairs of places in one scene: all of two lists, or those of a file with a pair a line, `sx,sy,dx,dy` and a name."""
    file = str(pathlib.Path(scene).absolute())
    if pairs is not None:
        found: list[Item] = []
        for where, fields in _fields(pairs):
            sx, sy, dx, dy = _numbers(where, fields, 4, "a pair is four numbers, x and y of both ends")
            found.append(Item(" ".join(fields[4:]) or f"pair-{len(found)}", file, ends=Ends(Point(sx, sy), Point(dx, dy))))
        if not found:
            raise BadInput(f"{pairs}: no pair")
        return found
    numbered = itertools.product(enumerate(sources), enumerate(destinations))
    return [Item(f"{source.name or i}-{destination.name or j}", file, ends=Ends(source.place, destination.place))
            for (i, source), (j, destination) in numbered]
