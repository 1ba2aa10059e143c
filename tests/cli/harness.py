# SPDX-License-Identifier: MIT
"""Run the command `tdsp` and say what it did. Each test has a directory of its own and is a function whose name says what it proves.

The command is $TDSP, or build/tdsp. Prints one PASS or FAIL a test and a last line "N passed, N failed".
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import traceback

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TDSP = os.environ.get("TDSP") or str(ROOT / "build" / "tdsp")
SCENES = ROOT / "examples" / "scenes"

TWO_DISCS = {"name": "two discs", "units": {"length": "m", "time": "s"}, "robot": {"speed": 1},
             "source": [-10, 0], "destination": [10, 0],
             "discs": [{"center": [0, 3], "radius": 1, "growth": 0.1}, {"center": [0, -3], "radius": 1, "growth": 0.1}]}
GAP_CLOSES = 30 * 0.99**0.5 - 20  # the last departure through the gap, by symmetry in closed form
LAST = 60.308508  # the last departure of all

_tests = []


def test(function):
    """Mark a test: it runs in an empty directory."""
    _tests.append((function.__name__.replace("_", " "), function))
    return function


def add(name, function):
    _tests.append((name, function))


class Result:
    def __init__(self, done):
        self.status = done.returncode
        self.out = done.stdout.decode()
        self.err = done.stderr.decode()

    def __str__(self):
        return f"exit {self.status}\n  out: {self.out[:1500]!r}\n  err: {self.err[:1500]!r}"

    @property
    def json(self):
        return json.loads(self.out)

    def rows(self):
        """The lines of a text table, without the headings."""
        return [line.split() for line in self.out.splitlines() if not line.startswith("#")]


def tdsp(*arguments, stdin=b"", timeout=300):
    if isinstance(stdin, str):
        stdin = stdin.encode()
    return Result(subprocess.run([TDSP, *map(str, arguments)], input=stdin, capture_output=True, timeout=timeout))


def expect(condition, what):
    if not condition:
        raise AssertionError(what)


def all_files(folder, pattern):
    """At least one: a test that goes through them must not pass where there are none."""
    found = sorted(pathlib.Path(folder).glob(pattern))
    expect(found, f"no {pattern} in {folder}")
    return found


def paired(found, wanted):
    """The pairs of two lists, which are to be of the same length."""
    expect(len(found) == len(wanted), f"{len(found)}, not {len(wanted)}: {found}")
    return zip(found, wanted)


def expect_equal(found, wanted, what="value"):
    if found != wanted:
        raise AssertionError(f"{what}: {found!r}, not {wanted!r}")


def expect_near(found, wanted, tolerance, what="value"):
    if not abs(found - wanted) <= tolerance:
        raise AssertionError(f"{what}: {found!r} is not within {tolerance} of {wanted!r}")


def done(*arguments, status=0, **more):
    """Run; the exit status must be `status`."""
    result = tdsp(*arguments, **more)
    expect(result.status == status, f"{' '.join(map(str, arguments))}: {result}")
    return result


def fails(status, fragments, *arguments, **more):
    """Run; it must exit with `status`, say each of the fragments on standard error and nothing on standard output."""
    result = done(*arguments, status=status, **more)
    for fragment in fragments:
        expect(fragment in result.err, f"no {fragment!r} in: {result}")
    expect(result.out == "", f"output in spite of failure: {result}")
    return result


def scene(file="scene.json", /, **changes):
    """Write the two discs with members replaced; returns the file's name."""
    pathlib.Path(file).write_text(json.dumps({**TWO_DISCS, **changes}))
    return file


def write(name, text):
    pathlib.Path(name).write_bytes(text if isinstance(text, bytes) else text.encode())
    return name


def built(*options, table="t.tdsp"):
    """Build a table of the two discs; returns its name."""
    done("build", scene(), "-o", table, *options)
    return table


def main():
    passed = failed = 0
    for name, function in _tests:
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                function()
                passed += 1
                print("PASS", name)
            except Exception as error:  # one failing test must not hide the others
                failed += 1
                where = traceback.extract_tb(error.__traceback__)
                line = next((frame.lineno for frame in where if not frame.filename.endswith("harness.py")), 0)
                print(f"FAIL {name} (line {line}): {error}")
            os.chdir("/")
    print(f"{passed} passed, {failed} failed")
    sys.exit(1 if failed or not passed else 0)
