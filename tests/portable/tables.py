#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tables built on one machine, read and verified on the others.

    tables.py BUILD COMMAND...      COMMAND: the command of another machine, emulated

Each example scene is built on each machine. Where the bytes differ from this machine's, the numbers of rows and of legs must be the same, every number the same up to
1e-4 of its size, and each machine must find every other's table sound. (The machines' sines and logarithms differ by the last bit; a row is placed where a search ends, and
where T hardly rises that may be far from where another ends, with the same guarantee.)
"""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "independent"))
sys.dont_write_bytecode = True
from read_table import Table  # noqa: E402

CLOSE = 1e-4


def scenes():
    return sorted([*(ROOT / "examples" / "scenes").glob("*.json"), *(ROOT / "examples" / "scenes" / "gaps").glob("*.json")])


def run(command, *words):
    return subprocess.run([str(word) for word in [command, *words]], capture_output=True, text=True, timeout=1800)


def build(command, scene, table):
    """The table's bytes, or None and a message."""
    done = run(command, "build", scene, "-o", table, "--epsilon", "0.05", "--horizon", "10", "--threads", "1")
    return (table.read_bytes(), "") if done.returncode == 0 else (None, done.stderr)


def numbers(data):
    """Everything that is computed: departures, travel times, places of the paths."""
    table = Table(data)
    found = table.departures + table.left + [x for x in table.right if x < float("inf")]
    for path in table.paths:
        for leg in path:
            found += [leg["start_time"], leg["end_time"], *leg["from"], *leg["to"]]
    return found


def difference(here, there):
    """The largest difference of two numbers in the same place, as a part of their size; None when there are not as many."""
    a, b = numbers(here), numbers(there)
    return max((abs(x - y) / max(1.0, abs(x)) for x, y in zip(a, b)), default=0.0) if len(a) == len(b) else None


def report(name, problems):
    print(f"not ok {name}: {'; '.join(problems)}" if problems else f"ok {name}")
    return bool(problems)


def verified(command, scene, table):
    done = run(command, "verify", scene, table)
    return [] if done.returncode == 0 else [f"{command} says: {(done.stdout + done.stderr).strip()[:300]}"]


def compare(name, here, there):
    """What is wrong with a table of another machine; prints how far it is from this machine's."""
    if here == there:
        print(f"# {name}: the same bytes")
        return []
    far = difference(here, there)
    print(f"# {name}: {'another number of rows or legs' if far is None else f'numbers differ by {far:.2g}'}")
    return [] if far is not None and far <= CLOSE else ["the tables differ"]


def check(scene, commands, folder):
    bad, tables = False, {}
    for place, command in enumerate(commands):
        table = folder / f"{scene.stem}-{place}.tdsp"
        data, errors = build(command, scene, table)
        machine = pathlib.Path(command).parent.name
        problems = [errors] if data is None else compare(f"{scene.stem} on {machine}", tables[0][1], data) if place else []
        bad |= report(f"{scene.stem} is built on {machine}", problems)
        tables[place] = (table, data)
    wrong = [said for table, data in tables.values() if data for command in commands for said in verified(command, scene, table)]
    return report(f"{scene.stem}: each machine's table is sound to all", wrong) or bad


def main():
    commands = [str(pathlib.Path(sys.argv[1]) / "tdsp"), *sys.argv[2:]]
    with tempfile.TemporaryDirectory() as name:
        return int(any([check(scene, commands, pathlib.Path(name)) for scene in scenes()]))


if __name__ == "__main__":
    sys.exit(main())
