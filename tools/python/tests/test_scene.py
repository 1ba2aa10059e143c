# SPDX-License-Identifier: MIT
"""Scenes: from arrays, files and dicts, and what is wrong with them."""
from __future__ import annotations

import json
import math
import pathlib
import pickle
import signal
import tempfile
import unittest
import warnings

import numpy as np
from support import SCENES, gate

import tdsp
from tdsp import Law, Polynomial, Rates


class SceneTest(unittest.TestCase):
    def test_a_scene_gives_back_what_it_was_made_of(self) -> None:
        scene = gate(name="gate", robot_radius=0.25)
        self.assertEqual((scene.speed, scene.robot_radius, scene.source, scene.destination), (1.0, 0.25, (-10, 0), (10, 0)))
        self.assertEqual(scene.discs["center"].tolist(), [[0, 3], [0, -3]])
        self.assertEqual(scene.growths, [0.1, 0.1])
        self.assertTrue(scene.has_rates_only)
        self.assertEqual(len(scene), 2)

    def test_the_discs_are_the_library_s_memory_and_cannot_be_written(self) -> None:
        discs = gate().discs
        with self.assertRaises(ValueError):
            discs["radius"] = 5.0

    def test_every_example_file_is_read_and_written_as_it_was(self) -> None:
        for path in sorted(SCENES.glob("*.json")):
            with self.subTest(path.name), tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
                warnings.simplefilter("ignore")
                scene = tdsp.Scene.load(path)
                copy = pathlib.Path(folder) / "copy.json"
                scene.save(copy)
                self.assertEqual(tdsp.Scene.load(copy).hash(), scene.hash())
                self.assertEqual(json.loads(copy.read_text())["discs"], [
                    {k: disc[k] for k in ("center", "radius", "growth")} for disc in json.loads(path.read_text())["discs"]])
                self.assertEqual([p.name for p in pathlib.Path(folder).iterdir()], ["copy.json"])

    def test_growth_may_be_anything_that_grows(self) -> None:
        growth = [0.1, Polynomial([0.1, 0.002]), Rates([0, 60], [0.1, 0.3]), [0.1, 0.001], {"times": [0, 5], "rates": [0, 1]}]
        scene = tdsp.Scene(2.0, (0, 0), (100, 0), [(10 * i, 20) for i in range(5)], 1.0, growth)
        self.assertFalse(scene.has_rates_only)
        self.assertEqual(scene.growths[3], Polynomial([0.1, 0.001]))
        self.assertAlmostEqual(scene.disc_at(1, 10.0).radius, 1 + 1 + 0.2)
        self.assertAlmostEqual(scene.disc_at(2, 70.0).radius, 1 + 6 + 3)
        self.assertEqual(scene.disc_at(4, 6.0), (2.0, 1.0))
        self.assertEqual(scene.valid_until(), (math.inf, None))
        self.assertEqual(pickle.loads(pickle.dumps(scene)).hash(), scene.hash())

    def test_a_law_is_followed(self) -> None:
        law = Law(lambda t: (1 + math.log1p(t), 1 / (1 + t)), until=100.0)
        scene = tdsp.Scene(1.0, (0, 0), (50, 0), [(20, 5)], 1.0, law)
        for time in (0.0, 1.0, 33.3, 99.0):
            self.assertAlmostEqual(scene.disc_at(0, time).radius, 1 + math.log1p(time), places=11)
        with self.assertRaisesRegex(tdsp.NotSupported, r"discs\[0\].growth: a law is a function"):
            scene.to_dict()

    def test_what_a_law_raises_comes_out_of_the_scene(self) -> None:
        calls = []

        def broken(time: float) -> tuple[float, float]:
            calls.append(time)
            raise KeyError("no such time")

        with self.assertRaisesRegex(KeyError, "no such time"):
            tdsp.Scene(1.0, (0, 0), (50, 0), [(20, 5)], 1.0, Law(broken, until=100.0))
        self.assertEqual(len(calls), 1)
        with self.assertRaisesRegex(tdsp.BadScene, r"discs\[0\]: "):
            tdsp.Scene(1.0, (0, 0), (50, 0), [(20, 5)], 1.0, Law(lambda t: (1 - t, -1.0), until=10.0))

    def test_ctrl_c_inside_a_law_stops_the_scene(self) -> None:
        def interrupted(time: float) -> tuple[float, float]:
            signal.raise_signal(signal.SIGINT)
            return 1.0 + time, 1.0

        with self.assertRaises(KeyboardInterrupt):
            tdsp.Scene(1.0, (0, 0), (50, 0), [(20, 5)], 1.0, Law(interrupted, until=100.0))

    def test_mistakes_name_the_place(self) -> None:
        whole = {"robot": {"speed": 1}, "source": [0, 0], "destination": [1, 1], "discs": [{"center": [5, 5], "radius": 1, "growth": 0}]}
        disc = whole["discs"][0]  # type: ignore[index]
        for change, message in [
                ({"robot": {}}, "f.json: robot.speed: missing"), ({"robot": {"speed": 0}}, "f.json: robot.speed: must be greater than zero"),
                ({"robot": {"speed": True}}, "robot.speed: must be a number, not true or false"), ({"source": [1]}, "source: a point has exactly two numbers, not 1"),
                ({"source": "ab"}, "source: must be an array, not a string"), ({"discs": {}}, "discs: must be an array, not an object"),
                ({"discs": [disc, 7]}, "discs[1]: must be an object, not a number"), ({"discs": [{**disc, "radius": -1}]}, "discs[0].radius: must not be negative"),
                ({"discs": [{**disc, "growth": None}]}, "discs[0].growth: must be an array"), ({"discs": [{**disc, "growth": -1}]}, "f.json: discs[0]: "),
                ({"discs": [{**disc, "growth": {"times": [0]}}]}, "discs[0].growth.rates: missing"),
                ({"discs": [{**disc, "growth": [1, "x"]}]}, "discs[0].growth[1]: must be a number"), ({"name": 5}, "name: must be a string, not a number"),
                ({"units": {"length": 1}}, "units.length: must be a string, not a number"), ({"georeference": {}}, "georeference.origin: missing"),
                ({"georeference": {"origin": [0, 91]}}, "georeference.origin: must be a longitude"),
                ({"georeference": {"origin": [0, 0], "ellipsoid": "Airy"}}, 'georeference.ellipsoid: must be "WGS84"')]:
            with self.subTest(message), self.assertRaises(tdsp.BadScene) as caught:
                tdsp.Scene.from_dict({**whole, **change}, "f.json")
            self.assertIn(message, str(caught.exception))

    def test_json_that_is_none_is_refused(self) -> None:
        for text, message in [("", "line 1, column 1"), ("{", "line 1, column 2"), ('{"a": 1, "a": 2}', 'the key "a" is there twice'), ("[NaN]", "NaN is no number"),
                              ("[1e999]", "the number 1e999 is too large"), ("[" * 100000, "nested too deeply"), ("[" + "9" * 400 + "]", "too large"),
                              ("[]", "must be an object, not an array")]:
            with self.subTest(text[:20]), self.assertRaises(tdsp.BadScene) as caught:
                tdsp.Scene.loads(text, "f.json")
            self.assertTrue(str(caught.exception).startswith("f.json: ") and message in str(caught.exception), caught.exception)

    def test_where_the_plane_lies_on_the_earth_is_kept(self) -> None:
        earth = {"origin": [-119.5, 44.25], "projection": "azimuthal equidistant", "ellipsoid": "WGS84"}
        scene = tdsp.Scene.from_dict({"robot": {"speed": 1}, "source": [0, 0], "destination": [1, 1], "discs": [], "georeference": earth})
        self.assertEqual(scene.origin, (-119.5, 44.25))
        self.assertEqual(scene.to_dict()["georeference"], earth)

    def test_an_unknown_key_is_warned_of(self) -> None:
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            tdsp.Scene.from_dict({"robot": {"speed": 1}, "source": [0, 0], "destination": [1, 1], "discs": [], "colour": 1}, "f.json")
        self.assertEqual([str(warning.message) for warning in caught], ["f.json: colour: unknown key ignored"])

    def test_arrays_of_a_wrong_shape_or_range_are_refused(self) -> None:
        for options, message in [({"centers": [[1, 2, 3]]}, "centers: must have the shape (n, 2), not (1, 3)"), ({"radii": [1, 2, 3]}, "radii: 3 for 2 discs"),
                                 ({"growth": [1, 2, 3]}, "growth: 3 for 2 discs"), ({"growth": [0.1, -0.1]}, "discs[1]: "), ({"radii": math.nan}, "discs[0]: "),
                                 ({"centers": [["a", "b"]]}, "centers: must be numbers"), ({"robot_radius": -1.0}, "radius")]:
            with self.subTest(message), self.assertRaises(ValueError) as caught:
                gate(**options)
            self.assertIn(message, str(caught.exception))

    def test_places_are_free_until_a_disc_reaches_them(self) -> None:
        scene = gate(growth=0.5)
        self.assertEqual(scene.free_until((0, 6)), (4.0, 0))
        self.assertEqual(scene.free_until((0, 3)), scene.free_until((0, 3)))
        self.assertLess(scene.free_until((0, 3)).time, 0)
        self.assertEqual(scene.source_free_until().disc, scene.destination_free_until().disc)
        self.assertEqual(gate(growth=0.0).free_until((0, 50)), (math.inf, None))

    def test_hashes_tell_scenes_and_ends_apart(self) -> None:
        scene = gate()
        self.assertEqual(scene.hash(), gate().hash())
        self.assertNotEqual(scene.hash(), gate(radii=1.5).hash())
        ends = ((-10, 1), (10, 0))
        self.assertEqual(scene.hash(ends), tdsp.Scene(1.0, *ends, [[0, 3], [0, -3]], 1.0, 0.1).hash())

    def test_a_raised_scene_grows_faster(self) -> None:
        scene = gate()
        self.assertEqual(scene.raised(2.0).growths, [0.2, 0.2])
        np.testing.assert_allclose(scene.raised(0.05, "added").growths, [0.15, 0.15])
        with self.assertRaisesRegex(tdsp.InvalidArgument, "factor"):
            scene.raised(2.0, "squared")
        bent = gate(growth=[[0.1, 0.001], [0.1]])
        self.assertAlmostEqual(bent.raised(2.0).disc_at(0, 10.0).radius, 1 + 2 * 1.1)
        with self.assertRaisesRegex(tdsp.NotSupported, "raised"):
            bent.raised(2.0).growths

    def test_margins_say_how_much_faster_all_may_grow(self) -> None:
        scene = gate()
        margin = scene.departure_margin(9.8, 30.0)
        self.assertAlmostEqual(margin.most, 1.0024686, places=6)
        self.assertEqual((margin.witness.limit, margin.witness.disc, margin.witness.other), (tdsp.Limit.GAP, 0, 1))
        path = scene.solver().path(9.8)
        self.assertAlmostEqual(scene.path_margin(path).most, margin.most, places=3)
        self.assertAlmostEqual(scene.path_margin(path, "added").most, 0.000246, places=5)
