#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run the package's tests and doctests, a line "ok NAME" or "not ok NAME" each; a skipped test has failed.

    run.py            what NumPy alone is enough for: test_*.py, and the doctests of all modules
    run.py --full     and full_*.py: matplotlib, Dask, the wheel
    run.py NAME...    these modules, e.g. test_table

TDSP_LIBRARY names the library; without it the package is the one that is installed. At the end each function of the library must have been called.
"""
from __future__ import annotations

import doctest
import importlib
import pathlib
import pkgutil
import sys
import unittest
from typing import Any, Callable

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import tdsp  # noqa: E402
from tdsp import _abi  # noqa: E402
from tdsp._library import lib  # noqa: E402

CALLED: set[str] = set()
# Modules that need more than NumPy: their doctests run with --full.
MORE = {"tdsp.plot", "tdsp.batch"}


class Lines(unittest.TestResult):
    """Says each result as a line."""

    def _say(self, word: str, test: unittest.TestCase, detail: str = "") -> None:
        name = test.shortDescription() or test.id()
        print(f"{word} python {name}" + "".join(f"\n    {line}" for line in detail.splitlines()), flush=True)

    def addSuccess(self, test: unittest.TestCase) -> None:
        self._say("ok", test)

    def addError(self, test: unittest.TestCase, err: Any) -> None:
        super().addError(test, err)
        self._say("not ok", test, self.errors[-1][1])

    def addFailure(self, test: unittest.TestCase, err: Any) -> None:
        super().addFailure(test, err)
        self._say("not ok", test, self.failures[-1][1])

    def addSubTest(self, test: unittest.TestCase, subtest: unittest.TestCase, err: Any) -> None:
        failed = len(self.failures) + len(self.errors)
        super().addSubTest(test, subtest, err)
        if len(self.failures) + len(self.errors) > failed:
            self._say("not ok", subtest, (self.failures if issubclass(err[0], test.failureException) else self.errors)[-1][1])

    def addSkip(self, test: unittest.TestCase, reason: str) -> None:
        self.failures.append((test, reason))
        self._say("not ok", test, f"skipped: {reason}")


def count_calls() -> None:
    """Note from now on which functions of the library are called."""

    def counted(name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any) -> Any:
            CALLED.add(name)
            return function(*arguments)

        return call

    for name in _abi.FUNCTIONS:
        setattr(lib, name, counted(name, getattr(lib, name)))


def modules() -> list[str]:
    return ["tdsp", *(module.name for module in pkgutil.walk_packages(tdsp.__path__, "tdsp.") if not module.name.endswith("__main__"))]


def wanted(arguments: list[str]) -> unittest.TestSuite:
    full = "--full" in arguments
    names = [name for name in arguments if name != "--full"]
    loader, suite = unittest.defaultTestLoader, unittest.TestSuite()
    for name in names or sorted(path.stem for pattern in ["test_*.py"] + ["full_*.py"] * full for path in HERE.glob(pattern)):
        suite.addTests(loader.loadTestsFromName(name))
    for name in [] if names else modules():
        if full or not any(name.startswith(more) for more in MORE):
            suite.addTests(doctest.DocTestSuite(importlib.import_module(name)))
    return suite


def main() -> int:
    count_calls()
    result = Lines()
    suite = wanted(sys.argv[1:])
    suite.run(result)
    failed = not result.wasSuccessful()
    if len(sys.argv) == 1 or sys.argv[1:] == ["--full"]:
        missing = sorted(set(_abi.FUNCTIONS) - CALLED)
        print("not ok python these functions are called by no test: " + ", ".join(missing) if missing else "ok python every function was called")
        failed = failed or bool(missing)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
