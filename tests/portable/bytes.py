#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The same bytes everywhere: tables of the example scenes, and the library's own mathematics, on this machine, on others (each emulated) and in WebAssembly.

    bytes.py check BUILD [MACHINE...]           hold them to tests/golden/tables.txt and mathematics.txt
    bytes.py mathematics BUILD [MACHINE...]     the second only, which takes seconds
    bytes.py record BUILD                       write both anew, from this machine

MACHINE: a name in MACHINES. One that cannot be compiled for here is a failure.
"""
import json
import pathlib
import struct
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
GOLDEN = ROOT / "tests" / "golden"
FLAGS = "-std=c99 -O2 -ffp-contract=off -fno-math-errno -Iinclude -Isrc -Itests".split()


def cross(name, emulator, *flags):
    return [f"{name}-gcc", "-static", *flags], [f"qemu-{emulator}-static"]


# How to compile for a machine and how to run what comes out.
MACHINES = {"here": (["gcc"], []), "here by clang": (["clang-19"], []), "aarch64": cross("aarch64-linux-gnu", "aarch64"), "s390x": cross("s390x-linux-gnu", "s390x"),
            "armhf": cross("arm-linux-gnueabihf", "arm"), "riscv64": cross("riscv64-linux-gnu", "riscv64"),
            "i386": cross("i686-linux-gnu", "i386", "-msse2", "-mfpmath=sse"),
            "wasm32": (["clang-14", "--target=wasm32-wasi", "--sysroot=/usr"], ["node", "--no-warnings", "tests/portable/wasi.mjs"])}
# Too large for an emulator's patience.
MOST_DISCS = 150


def bits(x):
    return struct.pack(">d", x).hex()


def growth(law):
    """A disc's growth as table_of.c reads it."""
    kind, values, times = (0, [law], []) if isinstance(law, (int, float)) else (1, law, []) if isinstance(law, list) else (2, law["rates"], law["times"])
    return " ".join([str(kind), str(len(values)), *map(bits, values), str(len(times)), *map(bits, times)])


def scene_text(path):
    scene = json.loads(path.read_text())
    numbers = [scene["robot"]["speed"], scene["robot"].get("radius", 0), *scene["source"], *scene["destination"]]
    lines = [" ".join(["scene", path.stem, *map(bits, numbers), str(len(scene["discs"]))])]
    lines += [" ".join(["disc", *map(bits, [*disc["center"], disc["radius"]]), growth(disc["growth"])]) for disc in scene["discs"]]
    return len(scene["discs"]), "\n".join(lines) + "\n"


def scenes():
    folder = ROOT / "examples" / "scenes"
    texts = [scene_text(path) for path in sorted([*folder.glob("*.json"), *(folder / "gaps").glob("*.json")])]
    return "".join(text for discs, text in texts if discs <= MOST_DISCS)


# What is recorded: its file, what it is, and the sources of the program that says it, all of the library for tables.
MATHEMATICS = ("mathematics.txt", "sine, logarithm, ... have the recorded bits", ["tests/portable/mathematics.c", "tests/support/functions.c", "src/base/math_*.c"])
TABLES = ("tables.txt", "tables of the example scenes have the recorded bytes", ["tests/portable/table_of.c", "src/*/*.c"])


def compiled(machine, folder, patterns):
    """The program for a machine, or None and a message."""
    folder.mkdir(parents=True, exist_ok=True)
    program = folder / pathlib.Path(patterns[0]).stem
    sources = sorted(path for pattern in patterns for path in ROOT.glob(pattern))
    try:
        done = subprocess.run([*MACHINES[machine][0], *FLAGS, *sources, "-o", program, "-lm"], cwd=ROOT, capture_output=True, text=True)
    except FileNotFoundError as missing:
        return None, str(missing)
    return (program if done.returncode == 0 else None), done.stderr


def ask(machine, program, text):
    """The program's lines, or what went wrong."""
    done = subprocess.run([*MACHINES[machine][1], program], input=text, capture_output=True, text=True, timeout=3600, cwd=ROOT)
    return done.stdout.splitlines() if done.returncode == 0 else [f"exit status {done.returncode}: {done.stderr}"]


def problem(found, recorded):
    wrong = next((f"{a!r}, not {b!r}" for a, b in zip(found, recorded) if a != b), "")
    return wrong or ("" if len(found) == len(recorded) else f"{len(found)} lines, not {len(recorded)}")


def lines_of(machine, folder, patterns):
    program, errors = compiled(machine, folder / machine.replace(" ", "-"), patterns)
    return ask(machine, program, scenes()) if program else [f"does not compile: {errors.strip()[:300]}"]


def check(folder, machine, kind):
    name, what, patterns = kind
    recorded = (GOLDEN / name).read_text().splitlines()
    wrong = problem(lines_of(machine, folder, patterns), recorded)
    print(f"not ok {machine}: {what}: {wrong}" if wrong else f"ok {machine}: {what}: {len(recorded)} lines", flush=True)
    return bool(wrong)


def main():
    job, folder, machines = sys.argv[1], pathlib.Path(sys.argv[2]).resolve() / "portable" / "bytes", sys.argv[3:]
    kinds = [MATHEMATICS] if job == "mathematics" else [MATHEMATICS, TABLES]
    if job != "record":
        return int(any([check(folder, machine, kind) for machine in machines for kind in kinds]))
    for name, _, patterns in kinds:
        (GOLDEN / name).write_text("\n".join(lines_of("here", folder, patterns)) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
