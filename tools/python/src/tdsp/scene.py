# SPDX-License-Identifier: MIT
"""Scenes: a robot, a source, a destination, and discs that grow."""
from __future__ import annotations

import ctypes
import json
import pathlib
from typing import TYPE_CHECKING, Any, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _abi, _scene_json
from ._abi import Raise, Status
from ._arrays import DISC_DTYPE, Floats, PointLike, address, flat, lent, point, points
from ._callbacks import Caught
from ._files import PathLike, write_atomically
from ._library import Handle, lib, owned
from .errors import BadScene, InvalidArgument, check, error_for
from .growth import Growth, GrowthLike, Struct, growth_from
from .values import EndsLike, Margin, Point, disc_or_none, ends_struct, margin_from, point_from

if TYPE_CHECKING:
    from .path import Path
    from .solver import Solver
    from .table import Table


class FreeUntil(NamedTuple):
    """The last moment at which a place is not inside a disc: infinite when it never is covered, negative when it is at 0; and the disc that covers it
    first."""

    time: float
    disc: Optional[int]


class DiscAt(NamedTuple):
    """A disc at a time: its radius without the robot's, and its rate."""

    radius: float
    rate: float


class Scene:
    """A scene, prepared for questions. It never changes, and any number of threads may use it.

    Lengths, times and speeds are in units of your own that agree with each other.

    :param speed: the robot's top speed, over 0
    :param source: two lengths
    :param destination: two lengths; may equal the source
    :param centers: the discs' centres, lengths of the shape (n, 2)
    :param radii: their radii at time 0, not negative and without the robot's: n lengths, or one for all
    :param growth: how they grow: one growth for all, n rates, or a sequence of n growths (`tdsp.growth`)
    :param robot_radius: the robot's radius, not negative: every disc is inflated by it
    :param name: for people
    :param length_unit: for people, at most 15 bytes in tables
    :param time_unit: likewise
    :param origin: where the plane's (0, 0) lies on the earth, longitude and latitude in degrees: kept for `tdsp convert`, and changes no answer
    :raises BadScene: a number is out of its range; the message says which

    >>> scene = Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.1)
    >>> scene
    <tdsp.Scene: 2 discs, speed 1, (-10, 0) to (10, 0)>
    >>> scene.solver().arrival(0.0)
    20.0
    """

    def __init__(self, speed: float, source: PointLike, destination: PointLike, centers: npt.ArrayLike = (), radii: npt.ArrayLike = 0.0,
                 growth: Union[GrowthLike, npt.ArrayLike, Sequence[GrowthLike]] = 0.0, *, robot_radius: float = 0.0, name: str = "",
                 length_unit: str = "", time_unit: str = "", origin: Optional[tuple[float, float]] = None) -> None:
        places = points(centers, "centers")
        sizes = np.broadcast_to(_per_disc(radii, len(places), "radii"), len(places))
        growths = _growths(growth, len(places))
        journey = _abi.tdsp_journey(float(speed), float(robot_radius), point(source, "source"), point(destination, "destination"))
        self.name, self.length_unit, self.time_unit, self.origin = name, length_unit, time_unit, origin
        self._laws: Optional[list[Growth]] = None if isinstance(growths, np.ndarray) else growths
        self._handle = _create(journey, places, sizes, growths)

    @classmethod
    def _from_data(cls, data: _scene_json.SceneData, file: str) -> Scene:
        growths: Any = data.growths
        if all(isinstance(growth, float) for growth in growths):
            growths = np.array(growths, dtype=np.float64)
        try:
            return cls(data.speed, data.source, data.destination, data.centers, data.radii, growths, robot_radius=data.robot_radius, name=data.name,
                       length_unit=data.length_unit, time_unit=data.time_unit, origin=data.origin)
        except BadScene as error:
            raise BadScene(f"{file}: {error}") from None

    @classmethod
    def load(cls, path: PathLike) -> Scene:
        """Read a scene file (docs/cli.md says what is in it). Unknown keys are warned of.

        :raises BadScene: with the file, the place and the reason
        :raises OSError: the file cannot be read
        """
        try:
            text = pathlib.Path(path).read_text(encoding="utf-8")
        except UnicodeDecodeError as error:
            raise BadScene(f"{path}: not UTF-8: {error.reason} at byte {error.start}") from None
        return cls.loads(text, str(path))

    @classmethod
    def loads(cls, text: str, file: str = "<scene>") -> Scene:
        """Read the text of a scene file, which messages call `file`."""
        return cls._from_data(_scene_json.read(text, file), file)

    @classmethod
    def from_dict(cls, value: Mapping[str, Any], file: str = "<scene>") -> Scene:
        """Make a scene from what a scene file has, as a dict.

        >>> Scene.from_dict({"robot": {"speed": 1}, "source": [0, 0], "destination": [3, 4], "discs": []})
        <tdsp.Scene: 0 discs, speed 1, (0, 0) to (3, 4)>
        """
        return cls._from_data(_scene_json.from_dict(value, file), file)

    def _data(self) -> _scene_json.SceneData:
        discs = self.discs
        return _scene_json.SceneData(self.speed, self.robot_radius, self.source, self.destination, [(float(x), float(y)) for x, y in discs["center"]],
                                     [float(r) for r in discs["radius"]], self.growths, self.name, self.length_unit, self.time_unit, self.origin)

    def to_dict(self) -> dict[str, Any]:
        """What a scene file has. :raises NotSupported: a disc grows by a Law"""
        return _scene_json.to_dict(self._data())

    def save(self, path: PathLike) -> None:
        """Write a scene file; it appears whole or not at all."""
        write_atomically(path, (json.dumps(self.to_dict(), ensure_ascii=False) + "\n").encode())

    @property
    def speed(self) -> float:
        """The robot's top speed."""
        return self._journey.speed

    @property
    def robot_radius(self) -> float:
        """The robot's radius, a length."""
        return self._journey.radius

    @property
    def source(self) -> Point:
        """Where the journey begins."""
        return point_from(self._journey.source)

    @property
    def destination(self) -> Point:
        """Where the journey ends."""
        return point_from(self._journey.destination)

    @property
    def _journey(self) -> _abi.tdsp_journey:
        return _abi.tdsp_journey.from_address(lib.tdsp_scene_journey(self._handle.pointer))

    @property
    def discs(self) -> npt.NDArray[Any]:
        """The discs as the library holds them: n records `center` (2), `radius`, `growth` (where it is no rate, the rate at time 0). Read-only, not
        copied."""
        count = ctypes.c_size_t()
        pointer = lib.tdsp_scene_discs(self._handle.pointer, ctypes.byref(count))
        return lent(pointer, count.value, DISC_DTYPE, self._handle)

    @property
    def growths(self) -> list[Growth]:
        """How each disc grows, as it was given. :raises NotSupported: of a raised scene whose rates change, which only the library knows"""
        if self._laws is not None:
            return list(self._laws)
        if not self.has_rates_only:
            raise error_for(Status.NOT_SUPPORTED, "the growths of a raised scene")
        return [float(rate) for rate in self.discs["growth"]]

    def __len__(self) -> int:
        return len(self.discs)

    def __repr__(self) -> str:
        name = f" {self.name!r}" if self.name else ""
        return f"<tdsp.Scene{name}: {len(self)} discs, speed {self.speed:g}, {_place(self.source)} to {_place(self.destination)}>"

    def __reduce__(self) -> tuple[Any, ...]:
        data = self._data()
        growths = np.array(data.growths) if self._laws is None else data.growths
        return _unpickle, (data.speed, data.source, data.destination, np.array(data.centers), np.array(data.radii), growths, data.robot_radius,
                           data.name, data.length_unit, data.time_unit)

    def hash(self, ends: Optional[EndsLike] = None) -> int:
        """The 64-bit hash of the scene's numbers, which a table carries; with other ends, that of the same scene between them."""
        return _hash(self._handle.pointer, ends_struct(ends))

    @property
    def has_rates_only(self) -> bool:
        """Does every disc come down to one rate?"""
        return bool(lib.tdsp_scene_has_rates_only(self._handle.pointer))

    def disc_at(self, disc: int, time: float) -> DiscAt:
        """Radius and rate of a disc at a time."""
        radius, rate = ctypes.c_double(), ctypes.c_double()
        if not 0 <= disc < len(self):
            raise InvalidArgument(f"disc {disc}: the scene has {len(self)} discs")
        check(lib.tdsp_scene_disc_at(self._handle.pointer, disc, time, ctypes.byref(radius), ctypes.byref(rate)), f"disc {disc} at {time}")
        return DiscAt(radius.value, rate.value)

    def valid_until(self) -> FreeUntil:
        """The last moment up to which no radius shrinks, and the disc that shrinks first; infinite and None when none ever does."""
        disc = ctypes.c_uint32()
        return FreeUntil(lib.tdsp_scene_valid_until(self._handle.pointer, ctypes.byref(disc)), disc_or_none(disc.value))

    def source_free_until(self) -> FreeUntil:
        """The last moment at which the source is not inside a disc."""
        disc = ctypes.c_uint32()
        return FreeUntil(lib.tdsp_scene_source_free_until(self._handle.pointer, ctypes.byref(disc)), disc_or_none(disc.value))

    def destination_free_until(self) -> FreeUntil:
        """The last moment at which the destination is not inside a disc."""
        disc = ctypes.c_uint32()
        return FreeUntil(lib.tdsp_scene_destination_free_until(self._handle.pointer, ctypes.byref(disc)), disc_or_none(disc.value))

    def free_until(self, place: PointLike) -> FreeUntil:
        """The last moment at which a place is not inside a disc.

        >>> scene = Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.5)
        >>> scene.free_until((0, 6))
        FreeUntil(time=4.0, disc=0)
        """
        disc = ctypes.c_uint32()
        time = lib.tdsp_scene_free_until(self._handle.pointer, point(place, "place"), ctypes.byref(disc))
        return FreeUntil(time, disc_or_none(disc.value))

    def raised(self, amount: float, how: str = "factor") -> Scene:
        """The scene with all growth raised.

        :param how: "factor": rates times `amount`; "added": `amount` more, a length per time. docs/math/margins.md says what holds for growth that bends
        """
        out = ctypes.c_void_p()
        check(lib.tdsp_scene_raise(self._handle.pointer, raise_from(how), amount, ctypes.byref(out)), f"growth raised by {amount}")
        scene = Scene.__new__(Scene)
        scene.name, scene.length_unit, scene.time_unit = self.name, self.length_unit, self.time_unit
        scene._laws, scene._handle = None, owned(out, lib.tdsp_scene_free)
        return scene

    def departure_margin(self, departure: float, deadline: float = float("inf"), how: str = "factor") -> Margin:
        """How far may all growth rise so that a robot that leaves at `departure`, and plans anew, still arrives by the deadline? `how` as in `raised`."""
        out = _abi.tdsp_margin()
        check(lib.tdsp_departure_margin(self._handle.pointer, raise_from(how), departure, deadline, ctypes.byref(out)), f"departure {departure}")
        return margin_from(out)

    def path_margin(self, path: Path, how: str = "factor") -> Margin:
        """How far may all growth rise so that this very path, driven at its times, stays clear of every disc?"""
        out, legs = _abi.tdsp_margin(), path.legs
        check(lib.tdsp_path_margin(self._handle.pointer, raise_from(how), address(legs), len(legs), path.departure, ctypes.byref(out)), "path")
        return margin_from(out)

    def solver(self, method: str = "auto") -> Solver:
        """A solver for questions to this scene; one for each thread that asks at the same time."""
        from .solver import Solver
        return Solver(self, method)

    def build(self, **options: Any) -> Table:
        """Build a table of earliest arrivals: `tdsp.build(scene, ...)`, whose options it takes."""
        from .sampler import build
        return build(self, **options)


def _per_disc(values: npt.ArrayLike, count: int, what: str) -> Floats:
    array = np.asarray(values, dtype=np.float64)
    if array.ndim == 0:
        return array
    array = flat(array, what)
    if len(array) != count:
        raise InvalidArgument(f"{what}: {len(array)} for {count} discs")
    return array


def _growths(growth: Any, count: int) -> Union[Floats, list[Growth]]:
    """Rates as an array where all are rates, else a growth for each disc. One number or one growth is everybody's."""
    if isinstance(growth, (Mapping,)) or not hasattr(growth, "__iter__"):
        one = growth_from(growth)
        return np.full(count, one) if isinstance(one, float) else [one] * count
    if isinstance(growth, np.ndarray) or all(isinstance(item, (int, float, np.number)) for item in growth):
        array = np.asarray(growth, dtype=np.float64)
        if array.ndim == 1:
            return _per_disc(array, count, "growth")
        growth = array.tolist()
    growths = [growth_from(item, f"discs[{i}].growth") for i, item in enumerate(growth)]
    if len(growths) != count:
        raise InvalidArgument(f"growth: {len(growths)} for {count} discs")
    return growths


def _create(journey: _abi.tdsp_journey, places: Floats, sizes: Floats, growths: Union[Floats, list[Growth]]) -> Handle:
    out, caught = ctypes.c_void_p(), Caught()
    if isinstance(growths, np.ndarray):
        discs = np.empty(len(places), DISC_DTYPE)
        discs["center"], discs["radius"], discs["growth"] = places, sizes, growths
        status = lib.tdsp_scene_create(ctypes.byref(journey), address(discs), len(discs), None, ctypes.byref(out))
        wrong = (lib.tdsp_disc_check(address(discs) + i * DISC_DTYPE.itemsize) for i in range(len(discs)))
    else:
        structs = [Struct(growth, caught, f"discs[{i}].growth") for i, growth in enumerate(growths)]
        growing = (_abi.tdsp_growing_disc * len(structs))()
        for disc, place, size, struct in zip(growing, places, sizes, structs):
            disc.center, disc.radius, disc.growth = _abi.tdsp_point(*place), float(size), struct.value
        with caught.interruptible():
            status = lib.tdsp_scene_create_growing(ctypes.byref(journey), ctypes.byref(growing), len(growing), None, ctypes.byref(out))
        wrong = (lib.tdsp_growing_disc_check(ctypes.byref(disc)) for disc in growing)
    handle = owned(out, lib.tdsp_scene_free)
    caught.raise_first()
    if status == Status.BAD_SCENE:
        _name_culprit(journey, wrong)
    check(status)
    return handle


def _name_culprit(journey: _abi.tdsp_journey, wrong: Any) -> None:
    """Raise what is wrong with which part, in the library's words."""
    text = lib.tdsp_journey_check(ctypes.byref(journey))
    if text:
        raise BadScene(text.decode())
    for i, text in enumerate(wrong):
        if text:
            raise BadScene(f"discs[{i}]: {text.decode()}")


def _hash(pointer: int, ends: Optional[_abi.tdsp_ends]) -> int:
    if ends is None:
        return int(lib.tdsp_scene_hash(pointer))
    return int(lib.tdsp_scene_hash_for(pointer, ctypes.byref(ends)))


def raise_from(how: str) -> int:
    words = {"factor": Raise.FACTOR, "added": Raise.ADDED}
    if how not in words:
        raise InvalidArgument(f'how: "factor" or "added", not {how!r}')
    return words[how]


def _place(place: Point) -> str:
    return f"({place.x:g}, {place.y:g})"


def _unpickle(speed: float, source: Any, destination: Any, centers: Any, radii: Any, growths: Any, robot_radius: float, name: str, length_unit: str,
              time_unit: str) -> Scene:
    return Scene(speed, source, destination, centers, radii, growths, robot_radius=robot_radius, name=name, length_unit=length_unit,
                 time_unit=time_unit)
