# SPDX-License-Identifier: MIT
"""Paths: places, shifts, the JSON of the command, and what a verifier says."""
from __future__ import annotations

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np
from support import SCENES, command_environment, gate

import tdsp
from tdsp import _abi


class PathTest(unittest.TestCase):
    def test_dtypes_are_the_library_s_structs(self) -> None:
        for dtype, struct in [(tdsp.LEG_DTYPE, _abi.tdsp_leg), (tdsp.DISC_DTYPE, _abi.tdsp_disc), (tdsp.ROW_DTYPE, _abi.tdsp_row)]:
            offsets = {name: dtype.fields[name][1] for name in dtype.names}
            self.assertEqual(offsets, {name: getattr(struct, name).offset for name, _ in struct._fields_})

    def test_a_ride_stays_on_its_disc(self) -> None:
        scene = gate()
        path = scene.solver().path(12.0)
        rides = path.legs[path.legs["kind"] == tdsp.LEG_ARC]
        self.assertEqual(len(rides), 1)
        times = np.linspace(rides["start_time"][0], rides["end_time"][0], 7)
        for time, place in zip(times, path.positions(times)):
            self.assertAlmostEqual(np.hypot(*(place - rides["center"][0])), scene.disc_at(int(rides["disc"][0]), time).radius)

    def test_places_and_their_shapes(self) -> None:
        path = gate().solver().path(12.0)
        self.assertEqual(path.position(0.0), (-10, 0))
        np.testing.assert_allclose(path.position(99.0), (10, 0), atol=1e-9)
        self.assertEqual(path.positions([[12, 13, 14], [15, 16, 17]]).shape, (2, 3, 2))
        self.assertEqual(path.polyline(9).shape[1], 2)
        with self.assertRaises(tdsp.InvalidArgument):
            path.position_on(99, 0.0)
        with self.assertRaises(tdsp.InvalidArgument):
            path.position(float("nan"))

    def test_a_path_of_no_length_stays_where_it_is(self) -> None:
        scene = tdsp.Scene(1.0, (2, 3), (2, 3))
        path = scene.solver().path(4.0)
        self.assertEqual((len(path), path.departure, path.arrival, path.position(9.0)), (0, 4.0, 4.0, (2, 3)))
        self.assertTrue(path.verify(scene))
        self.assertEqual(path.polyline().tolist(), [[2, 3]])
        self.assertEqual(scene.build(guarantee="absolute", delta=1.0, horizon=10.0).path(4.0).position(5.0), (2, 3))

    def test_legs_cannot_be_written(self) -> None:
        path = gate().solver().path(0.0)
        with self.assertRaises(ValueError):
            path.legs["end_time"] = 0.0
        with self.assertRaisesRegex(tdsp.InvalidArgument, "LEG_DTYPE"):
            tdsp.Path(np.zeros(3), 0.0, 1.0)

    def test_an_earlier_path_stays_clear_and_a_later_one_is_caught(self) -> None:
        scene = gate()
        path = scene.solver().path(9.0)
        self.assertTrue(path.shifted(-5.0).verify(scene))
        verdict = path.shifted(5.0).verify(scene)
        self.assertEqual(verdict.problems, ("enters a disc",))
        self.assertIn(verdict.disc, (0, 1))
        self.assertLess(verdict.min_clearance, -verdict.tolerance)

    def test_a_path_that_jumps_is_caught(self) -> None:
        legs = gate().solver().path(12.0).legs.copy()
        legs["from"][1] += 0.5
        self.assertIn("legs do not join in place or time", tdsp.Path(legs, 12.0, float(legs["end_time"][-1])).verify(gate()).problems)

    def test_the_command_verifies_what_to_dict_says(self) -> None:
        command = os.environ.get("TDSP")
        if command is None:
            self.skipTest("TDSP does not name the command")
        for name, departure in [("two-discs.json", 12.0), ("fires-accelerating.json", 0.0)]:
            path = tdsp.Scene.load(SCENES / name).solver().path(departure)
            with tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder) / "path.json"
                file.write_text(json.dumps(path.to_dict()))
                done = subprocess.run([command, "verify", SCENES / name, file, "--json"], capture_output=True, text=True,
                                      env=command_environment())
            self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
            self.assertTrue(json.loads(done.stdout)["ok"])
