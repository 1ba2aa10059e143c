# SPDX-License-Identifier: MIT
"""Scene files: JSON in and out. A mistake is answered with the file, the place and the reason, as the command does."""
from __future__ import annotations

import json
import math
import warnings
from dataclasses import dataclass, field
from typing import Any, Mapping, NoReturn, Optional

from .errors import BadScene
from .growth import Growth, growth_from, growth_to_json

EARTH = {"projection": "azimuthal equidistant", "ellipsoid": "WGS84"}  # the only ones there are
KNOWN = {"": {"name", "units", "robot", "source", "destination", "discs", "georeference"}, "georeference": {"origin", *EARTH}, "units": {"length", "time"}, "robot": {"speed", "radius"},
         "discs[]": {"center", "radius", "growth"}}


@dataclass
class SceneData:
    """What a scene file says."""

    speed: float
    robot_radius: float
    source: tuple[float, float]
    destination: tuple[float, float]
    centers: list[tuple[float, float]] = field(default_factory=list)
    radii: list[float] = field(default_factory=list)
    growths: list[Growth] = field(default_factory=list)
    name: str = ""
    length_unit: str = ""
    time_unit: str = ""
    origin: Optional[tuple[float, float]] = None


class Reader:
    """Reads one scene; `file` is what messages call it."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.unknown: list[str] = []

    def fail(self, place: str, reason: str) -> NoReturn:
        raise BadScene(": ".join(part for part in (self.file, place, reason) if part))

    def parse(self, text: str) -> Any:
        def pairs(items: list[tuple[str, Any]]) -> dict[str, Any]:
            found: dict[str, Any] = {}
            for key, value in items:
                if key in found:
                    self.fail("", f'the key "{key}" is there twice in one object')
                found[key] = value
            return found

        def constant(word: str) -> NoReturn:
            self.fail("", f"{word} is no number of JSON")

        def number(text: str) -> float:
            value = float(text)
            if math.isinf(value):
                self.fail("", f"the number {text[:40]} is too large")
            return value

        try:
            return json.loads(text, object_pairs_hook=pairs, parse_constant=constant, parse_float=number, parse_int=number)
        except json.JSONDecodeError as error:
            self.fail(f"line {error.lineno}, column {error.colno}", error.msg)
        except RecursionError:
            self.fail("", "nested too deeply")

    def member(self, object: Mapping[str, Any], place: str, name: str) -> Any:
        if name not in object:
            self.fail(f"{place}.{name}".lstrip("."), "missing")
        return object[name]

    def object(self, value: Any, place: str, kind: str) -> Mapping[str, Any]:
        if not isinstance(value, Mapping):
            self.fail(place, f"must be an object, not {type_name(value)}")
        for key in value:
            if key not in KNOWN[kind]:
                unknown = f"{kind}.{key}".lstrip(".")
                if unknown not in self.unknown:
                    self.unknown.append(unknown)
        return value

    def number(self, value: Any, place: str, least: float = -math.inf) -> float:
        if isinstance(value, (bool, str, bytes)) or not hasattr(value, "__float__"):
            self.fail(place, f"must be a number, not {type_name(value)}")
        number = float(value)
        if not math.isfinite(number):
            self.fail(place, "must be finite")
        if number < least:
            self.fail(place, "must not be negative")
        return number

    def point(self, value: Any, place: str) -> tuple[float, float]:
        if isinstance(value, (str, bytes, Mapping)) or not hasattr(value, "__len__"):
            self.fail(place, f"must be an array, not {type_name(value)}")
        if len(value) != 2:
            self.fail(place, f"a point has exactly two numbers, not {len(value)}")
        return self.number(value[0], f"{place}[0]"), self.number(value[1], f"{place}[1]")

    def text(self, object: Mapping[str, Any], place: str, name: str) -> str:
        value = object.get(name, "")
        if not isinstance(value, str):
            self.fail(f"{place}.{name}".lstrip("."), f"must be a string, not {type_name(value)}")
        return value

    def scene(self, root: Any) -> SceneData:
        root = self.object(root, "", "")
        robot = self.object(self.member(root, "", "robot"), "robot", "robot")
        units = self.object(root.get("units", {}), "units", "units")
        speed = self.number(self.member(robot, "robot", "speed"), "robot.speed")
        if speed <= 0:
            self.fail("robot.speed", "must be greater than zero")
        data = SceneData(speed, self.number(robot.get("radius", 0.0), "robot.radius", 0.0), self.point(self.member(root, "", "source"), "source"),
                         self.point(self.member(root, "", "destination"), "destination"), name=self.text(root, "", "name"),
                         length_unit=self.text(units, "units", "length"), time_unit=self.text(units, "units", "time"), origin=self.origin(root))
        discs = self.member(root, "", "discs")
        if not isinstance(discs, (list, tuple)):
            self.fail("discs", f"must be an array, not {type_name(discs)}")
        for i, disc in enumerate(discs):
            self.disc(disc, f"discs[{i}]", data)
        self.warn()
        return data

    def origin(self, root: Mapping[str, Any]) -> Optional[tuple[float, float]]:
        if "georeference" not in root:
            return None
        earth = self.object(root["georeference"], "georeference", "georeference")
        lon, lat = self.point(self.member(earth, "georeference", "origin"), "georeference.origin")
        if not (-180 <= lon <= 180 and -90 <= lat <= 90):
            self.fail("georeference.origin", "must be a longitude from -180 to 180 and a latitude from -90 to 90 degrees")
        for name, only in EARTH.items():
            if earth.get(name, only) != only:
                self.fail(f"georeference.{name}", f'must be "{only}"')
        return lon, lat

    def disc(self, value: Any, place: str, data: SceneData) -> None:
        disc = self.object(value, place, "discs[]")
        data.centers.append(self.point(self.member(disc, place, "center"), f"{place}.center"))
        data.radii.append(self.number(self.member(disc, place, "radius"), f"{place}.radius", 0.0))
        growth = self.member(disc, place, "growth")
        try:
            data.growths.append(growth_from(growth, f"{place}.growth"))
        except BadScene as error:
            self.fail("", str(error))

    def warn(self) -> None:
        for unknown in self.unknown[:20]:
            warnings.warn(f"{self.file}: {unknown}: unknown key ignored", stacklevel=5)


def type_name(value: Any) -> str:
    names = {dict: "an object", list: "an array", str: "a string", bool: "true or false", type(None): "null"}
    return names.get(type(value), "a number" if isinstance(value, (int, float)) else f"a {type(value).__name__}")


def read(text: str, file: str) -> SceneData:
    """Read the text of a scene file."""
    reader = Reader(file)
    return reader.scene(reader.parse(text))


def from_dict(value: Mapping[str, Any], file: str) -> SceneData:
    """Read a scene file's content."""
    return Reader(file).scene(value)


def to_dict(data: SceneData) -> dict[str, Any]:
    """A scene file's content, with the keys that docs/cli.md names."""
    root: dict[str, Any] = {}
    if data.name:
        root["name"] = data.name
    if data.length_unit or data.time_unit:
        root["units"] = {"length": data.length_unit, "time": data.time_unit}
    if data.origin is not None:
        root["georeference"] = {"origin": list(data.origin), **EARTH}
    root["robot"] = {"speed": data.speed, **({"radius": data.robot_radius} if data.robot_radius else {})}
    root["source"], root["destination"] = list(data.source), list(data.destination)
    root["discs"] = [{"center": list(center), "radius": radius, "growth": growth_to_json(growth, f"discs[{i}].growth")}
                     for i, (center, radius, growth) in enumerate(zip(data.centers, data.radii, data.growths))]
    return root
