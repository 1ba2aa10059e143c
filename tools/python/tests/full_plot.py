# SPDX-License-Identifier: MIT
"""Pictures: drawn, and showing what the library answers."""
from __future__ import annotations

import io
import unittest

import matplotlib

matplotlib.use("Agg")
import numpy as np  # noqa: E402
from matplotlib import pyplot  # noqa: E402
from support import SCENES, gate  # noqa: E402

import tdsp  # noqa: E402
from tdsp import plot  # noqa: E402


class PlotTest(unittest.TestCase):
    def tearDown(self) -> None:
        pyplot.close("all")

    def test_a_scene_is_drawn_with_all_its_discs_in_view(self) -> None:
        scene = tdsp.Scene.load(SCENES / "fire-oregon-c.json")
        ax = plot.scene(scene, at=100.0)
        low, high = ax.get_xlim()
        radii = np.array([scene.disc_at(i, 100.0).radius for i in range(len(scene))]) + scene.robot_radius
        self.assertLessEqual(low, (scene.discs["center"][:, 0] - radii).min())
        self.assertGreaterEqual(high, (scene.discs["center"][:, 0] + radii).max())
        self.assertEqual(ax.get_xlabel(), "x (m)")
        ax = plot.path(scene.solver().path(0.0), ax=ax, at=50.0)
        picture = io.BytesIO()
        ax.figure.savefig(picture)
        self.assertTrue(picture.getvalue().startswith(b"\x89PNG"))

    def test_a_disc_is_drawn_as_large_as_it_is(self) -> None:
        scene = tdsp.Scene(1.0, (-10, 0), (10, 0), [[0, 0]], radii=4.0, growth=0.0)
        ax = plot.scene(scene)
        ax.set_axis_off()
        ax.figure.canvas.draw()  # type: ignore[attr-defined]
        pixels = np.asarray(ax.figure.canvas.buffer_rgba())  # type: ignore[attr-defined]

        def colour(x: float, y: float) -> tuple[int, ...]:
            column, row = ax.transData.transform((x, y))
            return tuple(pixels[int(pixels.shape[0] - row), int(column), :3])

        self.assertNotEqual(colour(3.8, 0), (255, 255, 255))
        self.assertNotEqual(colour(0, 3.8), (255, 255, 255))
        self.assertEqual(colour(4.3, 0), (255, 255, 255))

    def test_the_arrival_of_a_table_and_of_a_solver(self) -> None:
        scene = gate()
        for world in (scene, scene.solver(), scene.build()):
            ax = plot.arrival(world, until=20.0, count=50)
            line = ax.get_lines()[0]
            np.testing.assert_allclose(line.get_ydata(), scene.solver().arrivals(line.get_xdata()).arrival, rtol=0.011)
            self.assertEqual(ax.get_ylabel(), "arrival (s)")
        with self.assertRaisesRegex(tdsp.InvalidArgument, "until"):
            plot.arrival(tdsp.Scene(1.0, (0, 0), (5, 0)))
        self.assertEqual(len(plot.arrival(tdsp.Scene(1.0, (0, 0), (5, 0)), until=3.0).get_lines()), 1)
