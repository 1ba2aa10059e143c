# SPDX-License-Identifier: MIT
"""The example programs print what is kept beside them, and docs/python.md and the package's README show what happens."""
from __future__ import annotations

import doctest
import io
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from support import ROOT

import tdsp

EXAMPLES = ROOT / "examples" / "python"


class ExampleTest(unittest.TestCase):
    def test_examples_print_what_is_expected(self) -> None:
        programs = sorted(EXAMPLES.glob("*.py"))
        self.assertEqual([path.stem for path in programs], sorted(path.stem for path in (EXAMPLES / "expected").glob("*.txt")))
        environment = {**os.environ, "PYTHONPATH": str(pathlib.Path(tdsp.__file__).parent.parent)}
        for path in programs:
            with self.subTest(path.name):
                done = subprocess.run([sys.executable, path], capture_output=True, text=True, timeout=120, env=environment)
                self.assertEqual((done.stderr, done.returncode), ("", 0))
                self.assertEqual(done.stdout, (EXAMPLES / "expected" / f"{path.stem}.txt").read_text())

    def test_the_page_shows_what_happens(self) -> None:
        # A fence ends what is expected.
        text = re.sub(r"^```.*$", "", (ROOT / "docs" / "python.md").read_text(encoding="utf-8"), flags=re.M)
        page = doctest.DocTestParser().get_doctest(text, {}, "python.md", "docs/python.md", 0)
        said, before = io.StringIO(), os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                result = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(page, out=said.write)
            finally:
                os.chdir(before)
        self.assertEqual(result.failed, 0, said.getvalue())
        self.assertGreater(result.attempted, 20)

    def test_the_readme_s_program_runs(self) -> None:
        [program] = re.findall(r"^```python\n(.*?)^```", (ROOT / "tools" / "python" / "README.md").read_text(encoding="utf-8"), re.M | re.S)
        environment = {**os.environ, "PYTHONPATH": str(pathlib.Path(tdsp.__file__).parent.parent)}
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, env=environment, cwd=folder)
        self.assertEqual((done.stderr, done.returncode), ("", 0))
        self.assertEqual(done.stdout.split()[0], "20.0")
