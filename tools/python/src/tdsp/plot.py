# SPDX-License-Identifier: MIT
"""Pictures by matplotlib: scenes, paths, and the arrival over the departure. Needs `pip install tdsp[plot]`.

Each function draws into `ax`, makes a figure where there is none, and returns the axes:

>>> import matplotlib
>>> matplotlib.use("Agg")
>>> import tdsp
>>> from tdsp import plot
>>> scene = tdsp.Scene(1.0, (-10, 0), (10, 0), [[0, 3], [0, -3]], radii=1.0, growth=0.1)
>>> ax = plot.scene(scene, at=12.0)
>>> ax = plot.path(scene.solver().path(12.0), ax=ax)
>>> ax.get_aspect()
1.0
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Optional

import numpy as np

from .errors import InvalidArgument
from .path import Path
from .scene import Scene
from .solver import INF, Solver
from .table import Table

try:
    from matplotlib import pyplot
    from matplotlib.collections import EllipseCollection
except ImportError as error:
    raise ImportError(f"tdsp.plot needs matplotlib ({error}): pip install tdsp[plot]") from error

if TYPE_CHECKING:
    from matplotlib.axes import Axes

DISC = "#d9754f"
PATH = "#1f5f99"


def _axes(ax: Optional[Axes]) -> Axes:
    return pyplot.subplots()[1] if ax is None else ax


def scene(scene: Scene, at: float = 0.0, ax: Optional[Axes] = None) -> Axes:
    """The discs at a time (their radii with the robot's), the source and the destination."""
    ax = _axes(ax)
    centers = scene.discs["center"]
    radii = np.array([scene.disc_at(i, at).radius for i in range(len(scene))]) + scene.robot_radius
    if len(radii):
        # Diameters in the units of the axes: one collection, however many discs there are.
        ax.add_collection(EllipseCollection(2 * radii, 2 * radii, np.zeros(len(radii)), units="xy", offsets=centers, transOffset=ax.transData,
                                            facecolors=DISC, edgecolors="none", alpha=0.5))
        ax.update_datalim(np.vstack([centers - radii[:, None], centers + radii[:, None]]))
    ax.plot(*scene.source, "o", color=PATH)
    ax.plot(*scene.destination, "*", color=PATH, markersize=12)
    _label(ax, scene)
    return ax


def _label(ax: Axes, scene: Scene) -> None:
    ax.set_aspect("equal")
    ax.autoscale_view()
    unit = f" ({scene.length_unit})" if scene.length_unit else ""
    ax.set_xlabel("x" + unit)
    ax.set_ylabel("y" + unit)
    if scene.name:
        ax.set_title(scene.name)


def path(path: Path, ax: Optional[Axes] = None, at: Optional[float] = None) -> Axes:
    """The way of a path; with `at`, where the robot is then."""
    ax = _axes(ax)
    ax.plot(*path.polyline().T, color=PATH, linewidth=2)
    if at is not None:
        ax.plot(*path.position(at), "o", color="black")
    ax.set_aspect("equal")
    return ax


def arrival(world: Table | Solver | Scene, until: float = INF, count: int = 400, ax: Optional[Axes] = None) -> Axes:
    """A(t) over the departure: of a table the certified interval, of a solver or scene `count` exact answers.

    :param until: the last departure shown; the last that there is, unless given
    """
    ax = _axes(ax)
    if isinstance(world, Table):
        times = _times(until, world.info.last_departure, count)
        intervals = world.arrivals(times)
        ax.fill_between(times, intervals.lower, intervals.upper, color=PATH, alpha=0.35, linewidth=0)
        ax.plot(times, intervals.upper, color=PATH, linewidth=1)
        unit = world.info.time_unit
    else:
        solver = world.solver() if isinstance(world, Scene) else world
        times = _times(until, solver.last_departure().departure, count)
        ax.plot(times, solver.arrivals(times).arrival, color=PATH, linewidth=1)
        unit = solver.scene.time_unit
    ax.set_xlabel("departure" + (f" ({unit})" if unit else ""))
    ax.set_ylabel("arrival" + (f" ({unit})" if unit else ""))
    return ax


def _times(until: float, last: float, count: int) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    end = min(until, last)
    if not np.isfinite(end):
        raise InvalidArgument("until: must be given where nothing ever ends the departures")
    return np.linspace(0.0, end, count)
