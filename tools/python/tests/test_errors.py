# SPDX-License-Identifier: MIT
"""Errors: one class for each status, the library's words, and libraries that do not fit."""
from __future__ import annotations

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import tdsp
from tdsp import errors


class ErrorTest(unittest.TestCase):
    def test_each_status_has_one_class_in_the_family_of_its_number(self) -> None:
        for status in tdsp.Status:
            if status == tdsp.Status.OK:
                continue
            error = errors.error_for(status)
            family = tdsp.NoWay if status < 16 else tdsp.UsageError if status < 32 else tdsp.DataError if status < 64 else tdsp.SystemFailure
            self.assertEqual(error.status, status)
            self.assertIsInstance(error, family)
            self.assertEqual(str(error), tdsp.status_text(status))
            self.assertIs(getattr(tdsp, type(error).__name__), type(error))
        classes = [kind for group in (tdsp.NoWay, tdsp.UsageError, tdsp.DataError, tdsp.SystemFailure) for kind in group.__subclasses__()]
        self.assertEqual(len({kind.status for kind in classes}), len(tdsp.Status) - 1)

    def test_names_are_the_enumeration_s(self) -> None:
        for status in tdsp.Status:
            self.assertEqual(tdsp.status_name(status), status.name.lower())
            self.assertEqual(tdsp.is_answer(status), status < 16)
        for limit in tdsp.Limit:
            self.assertEqual(tdsp.limit_name(limit), limit.name.lower())
        self.assertEqual(tdsp.status_name(12345), "unknown")

    def test_errors_are_what_python_expects_of_them(self) -> None:
        self.assertTrue(issubclass(tdsp.BadScene, ValueError) and issubclass(tdsp.InvalidArgument, ValueError) and issubclass(tdsp.NoMemory, MemoryError))
        self.assertFalse(issubclass(tdsp.NoWay, ValueError))

    def run_with(self, library: pathlib.Path) -> str:
        environment = {**os.environ, "TDSP_LIBRARY": str(library), "PYTHONPATH": str(pathlib.Path(tdsp.__file__).parent.parent)}
        done = subprocess.run([sys.executable, "-c", "import tdsp"], env=environment, capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        return done.stderr.splitlines()[-1]

    def test_a_library_that_is_not_there_or_another_is_an_import_error(self) -> None:
        self.assertRegex(self.run_with(pathlib.Path("/nowhere/libtdsp.so")), "ImportError: tdsp: cannot load /nowhere/libtdsp.so")
        with tempfile.TemporaryDirectory() as folder:
            other = pathlib.Path(folder) / "libtdsp.so"
            subprocess.run(["gcc", "-shared", "-x", "c", "-", "-o", other], input='const char *tdsp_version(void) { return "9.9.9"; }', text=True, check=True)
            self.assertRegex(self.run_with(other), r"ImportError: tdsp: .*libtdsp.so has no tdsp_\w+\(\): it is another version than this package")
