# SPDX-License-Identifier: MIT
"""What the tests share."""
from __future__ import annotations

import os
import pathlib
import random

import tdsp

ROOT = next(folder for folder in pathlib.Path(__file__).resolve().parents if (folder / "tests" / "golden").is_dir())
GOLDEN = ROOT / "tests" / "golden"
INDEPENDENT = ROOT / "tests" / "independent" / "golden"
SCENES = ROOT / "examples" / "scenes"


def command_environment() -> dict[str, str]:
    """For the command, which brings a sanitizer of its own where the library has one."""
    return {name: value for name, value in os.environ.items() if name != "LD_PRELOAD"}


def gate(**options: object) -> tdsp.Scene:
    """Two discs and a gap between them that closes for departures after 9.8496231130."""
    arguments: dict[str, object] = dict(centers=[[0, 3], [0, -3]], radii=1.0, growth=0.1, length_unit="m", time_unit="s")
    return tdsp.Scene(1.0, (-10, 0), (10, 0), **{**arguments, **options})  # type: ignore[arg-type]


def crowd(seed: int, count: int = 12) -> tdsp.Scene:
    """Discs in the way, from a seed."""
    chance = random.Random(seed)
    centers = [(chance.uniform(-8, 8), chance.uniform(-6, 6)) for _ in range(count)]
    return tdsp.Scene(1.0, (-10, 0), (10, 0), centers, [chance.uniform(0.1, 1.0) for _ in centers], [chance.uniform(0, 0.3) for _ in centers])
