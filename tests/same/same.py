#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Results do not depend on the compiler and its optimisation: the same answers to the last bit.

    same.py short|full BUILD PKG-CONFIG FLAG...

The library and bits.c are built anew, each way, with FLAG...; the command's own parts, which only read scene files, are taken from BUILD. Each program's
output must be that of the first.
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# Compilers and flags, and scenes of each mix. The first is what the others are held to.
# For the processors that the Makefile builds for: with FMA at hand (-march=native) gcc 12 fuses pairs of products that it vectorises, vfmaddsub, in spite of
# -ffp-contract=off.
FULL = [f"{compiler} {level}" for compiler in ("gcc", "clang-19") for level in ("-O2", "-O0", "-O1", "-O3", "-Os")]
WAYS = {"short": (["gcc -O2", "gcc -O0", "clang-19 -O3"], 4), "full": (FULL, 30)}
GLUE = ["tests/same/bits.c", "tests/support/random_scene.c", "tests/support/random_growth.c"]


def scenes():
    folder = ROOT / "examples" / "scenes"
    return sorted([*folder.glob("*.json"), *(folder / "gaps").glob("*.json")])


def build(way, folder, build_folder, libraries, flags):
    folder.mkdir(parents=True, exist_ok=True)
    program = folder / ("bits-" + way.replace(" ", ""))
    sources = sorted(str(path.relative_to(ROOT)) for path in (ROOT / "src").glob("*/*.c"))
    done = subprocess.run([*way.split(), *flags, "-ffp-contract=off", "-fno-math-errno", *GLUE, *sources, build_folder / "libcommand.a", *libraries,
                           "-o", program], cwd=ROOT, capture_output=True, text=True)
    return (program if done.returncode == 0 else None), done.stderr


def output(program, count):
    done = subprocess.run([program, str(count), *scenes()], capture_output=True, text=True, timeout=3600)
    return done.stdout.splitlines() if done.returncode == 0 else [f"exit status {done.returncode}: {done.stderr}"]


def difference(found, wanted):
    """The first line that differs, under the scene that it is about."""
    scene = ""
    for a, b in zip(found, wanted):
        scene = b if not b.startswith(" ") else scene
        if a != b:
            return f"{scene}: {a.strip()}, not {b.strip()}"
    return "" if len(found) == len(wanted) else f"{len(found)} lines, not {len(wanted)}"


def main():
    kind, build_folder, package_config, flags = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), sys.argv[3], sys.argv[4:]
    ways, count = WAYS[kind]
    libraries = subprocess.run([package_config, "--libs", "gio-2.0", "json-glib-1.0"], check=True, capture_output=True, text=True).stdout.split() + ["-lm"]
    wanted, bad = None, False
    for way in ways:
        program, errors = build(way, build_folder / "same", build_folder, libraries, flags)
        found = output(program, count) if program else [errors]
        wanted = wanted or found
        wrong = difference(found, wanted) if program else errors
        print(f"not ok {way}: {wrong}" if wrong else f"ok {way}: {len(found)} lines", flush=True)
        bad |= bool(wrong)
    return int(bad)


if __name__ == "__main__":
    sys.exit(main())
