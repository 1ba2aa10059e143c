#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The reader in one file, beside libtdsp-query.a.

    check.py BUILD

It compiles alone and without a warning, by two compilers, for machines with doubles and for such without; its header compiles as C and as C++; it has
the public functions of libtdsp-query.a and no other symbol; and it says of golden files, sound ones and broken ones, what was recorded.
"""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "portable"))
import reader  # noqa: E402

WARNINGS = "-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wundef -Wmissing-prototypes -Werror".split()
VARIANTS = {"gcc": ["gcc", "-O2"], "gcc for size": ["gcc", "-Os"], "clang": ["clang-19", "-O2"],
            "gcc, doubles in software": ["gcc", "-O2", "-DTDSP_SOFT_DOUBLE=1"], "clang, doubles in software": ["clang-19", "-O2", "-DTDSP_SOFT_DOUBLE=1"]}
HEADERS = {"C99": ["gcc", "-std=c99", "-x", "c"], "C99 by clang": ["clang-19", "-std=c99", "-x", "c"],
           "C++98": ["g++", "-std=c++98", "-Wno-long-long", "-Wno-c++11-long-long", "-x", "c++"], "C++17": ["g++", "-std=c++17", "-Wold-style-cast", "-x", "c++"],
           "C++17 by clang": ["clang++-19", "-std=c++17", "-x", "c++"]}


def run(*command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)


def report(name, problem):
    print(f"not ok {name}: {problem}" if problem else f"ok {name}")
    return bool(problem)


def symbols(path, *options):
    done = run("nm", "-g", "-P", *options, path)
    return {line.split()[0] for line in done.stdout.splitlines() if len(line.split()) > 1}


def header_compiles(folder, name, command):
    warnings = [w for w in WARNINGS if w != "-Wmissing-prototypes"]
    done = run(*command[:-2], *warnings, "-fsyntax-only", "-I", folder, *command[-2:], "-",
               input='#include "tdsp_query.h"\n#include "tdsp_query.h"\nint main(void) { tdsp_table t; return tdsp_table_open(&t, 0, 0) == TDSP_OK; }\n')
    return report(f"the header of the amalgamation compiles as {name}", done.stderr)


def shims(folder):
    """The public headers by their names, each of which is the one header."""
    (folder / "shims" / "tdsp").mkdir(parents=True, exist_ok=True)
    for name in ("table", "matrix", "path"):
        (folder / "shims" / "tdsp" / f"{name}.h").write_text('#include "tdsp_query.h"\n')
    return folder / "shims"


def answers(folder, program):
    refused = sorted((reader.GOLDEN / "refused.txt").read_text().splitlines())
    sound = (reader.GOLDEN / "answers.txt").read_text().splitlines()
    pairs = ((reader.ask("", program, reader.files(reader.GOLDEN / "refused")), refused), (reader.ask("", program, reader.sound()), sound))
    return [line for found, recorded in pairs for line in difference(found, recorded)]


def difference(found, recorded):
    wrong = [f"{a!r}, not {b!r}" for a, b in zip(found, recorded) if a != b]
    return wrong + ([f"{len(found)} lines, not {len(recorded)}"] if len(found) != len(recorded) else [])


def variant(folder, name, compiler, public):
    target = folder / (name.replace(" ", "-").replace(",", "") + ".o")
    flags = [*compiler[1:], "-std=c99", "-ffp-contract=off"]
    done = run(compiler[0], *flags, *WARNINGS, "-c", folder / "tdsp_query.c", "-o", target)
    if report(f"the amalgamation compiles by {name}", done.stderr):
        return True
    there = symbols(target, "--defined-only")
    bad = report(f"the amalgamation by {name} has the reader's public functions and no others", " ".join(sorted(there ^ public)))
    program = target.with_suffix("")
    done = run(compiler[0], *flags, "-I", shims(folder), "-I", folder, ROOT / "tests/portable/answers.c", target, "-lm", "-o", program)
    if done.returncode:
        return report(f"a program links with the amalgamation by {name}", done.stderr)
    wrong = answers(folder, program)
    return report(f"the amalgamation by {name} answers as recorded", wrong[0] if wrong else "") or bad


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    folder = build / "amalgamation"
    public = {name for name in symbols(build / "libtdsp-query.a", "--defined-only") if name.startswith("tdsp_")}
    bad = [header_compiles(folder, name, command) for name, command in HEADERS.items()]
    bad += [variant(folder, name, command, public) for name, command in VARIANTS.items()]
    return int(any(bad))


if __name__ == "__main__":
    sys.exit(main())
