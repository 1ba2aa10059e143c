#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The reader on other machines: what it says of golden files, sound ones and broken ones, is what was recorded, to the bit.

    reader.py check BUILD [MACHINE...]      on this machine and others, each emulated
    reader.py record BUILD                  write tests/golden/answers.txt anew, from this machine

The files are tests/golden (refused: one for each rule of docs/format.md; answered: built from scenes) and tests/independent/golden (made by hand).
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
GOLDEN = ROOT / "tests" / "golden"
EMULATORS = {"aarch64-linux-gnu": "qemu-aarch64-static", "s390x-linux-gnu": "qemu-s390x-static", "arm-linux-gnueabihf": "qemu-arm-static"}
FLAGS = "-std=c99 -O2 -static -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -ffp-contract=off".split()
LAYERS = "base geom table query".split()


def files(*folders):
    return sorted((path for folder in folders for path in folder.glob("*.tdsp*")), key=lambda path: path.name)


def build(machine, folder):
    """The program of the freestanding line for a machine ("" is this one), linked statically; None and a message when it does not compile."""
    folder.mkdir(parents=True, exist_ok=True)
    program = folder / "answers"
    sources = [path for layer in LAYERS for path in sorted((ROOT / "src" / layer).glob("*.c"))]
    compiler = machine + "-gcc" if machine else "gcc"
    done = subprocess.run([compiler, *FLAGS, "-Iinclude", "-Isrc", "tests/portable/answers.c", *sources, "-o", program, "-lm"], cwd=ROOT,
                          capture_output=True, text=True)
    return (program if done.returncode == 0 else None), done.stderr


def ask(machine, program, paths):
    """The program's lines, or what went wrong."""
    emulator = [EMULATORS[machine]] if machine else []
    done = subprocess.run([*emulator, program, *paths], capture_output=True, text=True, timeout=300)
    return done.stdout.splitlines() if done.returncode == 0 else [f"exit status {done.returncode}: {done.stderr}"]


def report(name, found, recorded):
    wrong = [f"{a!r}, not {b!r}" for a, b in zip(found, recorded) if a != b]
    if len(found) != len(recorded):
        wrong.append(f"{len(found)} lines, not {len(recorded)}")
    print(f"not ok {name}: {wrong[0]} ({len(wrong)} differences)" if wrong else f"ok {name}: {len(recorded)} lines")
    return bool(wrong)


def check(folder, machine):
    name = machine or "this machine"
    program, errors = build(machine, folder / (machine or "here"))
    if not program:
        print(errors, file=sys.stderr)
        print(f"not ok the reader compiles for {name}")
        return True
    refused = sorted((GOLDEN / "refused.txt").read_text().splitlines())
    bad = report(f"broken files are refused on {name}", ask(machine, program, files(GOLDEN / "refused")), refused)
    answers = (GOLDEN / "answers.txt").read_text().splitlines()
    return report(f"golden files are answered on {name}", ask(machine, program, sound()), answers) or bad


def sound():
    return files(GOLDEN / "answered", ROOT / "tests" / "independent" / "golden")


def main():
    job, folder, machines = sys.argv[1], pathlib.Path(sys.argv[2]).resolve() / "portable", sys.argv[3:]
    if job == "record":
        program, errors = build("", folder / "here")
        if not program:
            sys.exit(errors)
        (GOLDEN / "answers.txt").write_text("\n".join(ask("", program, sound())) + "\n")
        return 0
    return int(any([check(folder, machine) for machine in ["", *machines]]))


if __name__ == "__main__":
    sys.exit(main())
