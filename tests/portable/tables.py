#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tables built by the command on one machine have the bytes of those built on the others, and every machine finds them sound.

    tables.py BUILD COMMAND...      COMMAND: the command of another machine, emulated
"""
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def scenes():
    return sorted([*(ROOT / "examples" / "scenes").glob("*.json"), *(ROOT / "examples" / "scenes" / "gaps").glob("*.json")])


def run(command, *words):
    return subprocess.run([str(word) for word in [command, *words]], capture_output=True, text=True, timeout=1800)


def build(command, scene, table):
    """The table's bytes, or None and a message."""
    done = run(command, "build", scene, "-o", table, "--epsilon", "0.05", "--horizon", "10", "--threads", "1")
    return (table.read_bytes(), "") if done.returncode == 0 else (None, done.stderr)


def report(name, problems):
    print(f"not ok {name}: {'; '.join(problems)}" if problems else f"ok {name}")
    return bool(problems)


def verified(command, scene, table):
    done = run(command, "verify", scene, table)
    return [] if done.returncode == 0 else [f"{command} says: {(done.stdout + done.stderr).strip()[:300]}"]


def check(scene, commands, folder):
    bad, first = False, None
    for place, command in enumerate(commands):
        table, machine = folder / f"{scene.stem}-{place}.tdsp", pathlib.Path(command).parent.name
        data, errors = build(command, scene, table)
        first = first or data
        problems = [errors] if data is None else ["its bytes are not those of this machine's"] if data != first else verified(command, scene, table)
        bad |= report(f"{scene.stem} is built on {machine} to the same bytes, and is sound to it", problems)
    return bad


def main():
    commands = [str(pathlib.Path(sys.argv[1]) / "tdsp"), *sys.argv[2:]]
    with tempfile.TemporaryDirectory() as name:
        return int(any([check(scene, commands, pathlib.Path(name)) for scene in scenes()]))


if __name__ == "__main__":
    sys.exit(main())
