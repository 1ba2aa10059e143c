#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Check that every public function is reached by a fuzz target: really run, by the inputs that are kept.

usage: check_reached.py BUILD

BUILD holds the programs of the build for libFuzzer. Each target's driver (driver.c) goes through the target's corpus and found cases, and says which functions were
entered. Prints a line for each public function with the targets that reach it, and a table of edges into BUILD/reached.csv.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DECLARED = re.compile(r"^TDSP_API\s[^;]*?\b(tdsp_\w+)\s*\(", re.M)


def public_functions():
    names = set()
    for header in sorted((ROOT / "include/tdsp").glob("*.h")):
        names |= set(DECLARED.findall(header.read_text(encoding="utf-8")))
    return names


def functions_by_address(program):
    """Name of the function at each address of the program's file."""
    listing = subprocess.run(["nm", "--defined-only", str(program)], check=True, capture_output=True, text=True).stdout
    entries = (line.split() for line in listing.splitlines())
    return {int(entry[0], 16): entry[2] for entry in entries if len(entry) == 3 and entry[1] in "tT"}


def run(program, name):
    """Run a target's driver over its inputs: (edges run through, edges, names of the functions entered)."""
    inputs = [str(ROOT / "tests/fuzz" / kind / f"fuzz_{name}") for kind in ("corpus", "found")]
    inputs = [path for path in inputs if os.path.isdir(path)]
    report = program.with_suffix(".reached")
    report.unlink(missing_ok=True)
    done = subprocess.run([str(program), "--reached", str(report), *inputs], cwd=ROOT, capture_output=True, text=True, errors="replace", check=False)
    if done.returncode or not report.exists():
        raise RuntimeError(f"{name}: exit status {done.returncode}\n" + "\n".join((done.stdout + done.stderr).splitlines()[-20:]))
    words = [line.split() for line in report.read_text(encoding="ascii").splitlines()]
    names = functions_by_address(program)
    moved = int(words[1][1], 16) - next(at for at, function in names.items() if function == "LLVMFuzzerTestOneInput")
    return int(words[0][1]), int(words[0][2]), {names.get(int(word[0], 16) - moved) for word in words[2:]}


def main():
    build = pathlib.Path(sys.argv[1])
    names = sorted(path.stem[len("fuzz_"):] for path in (ROOT / "tests/fuzz").glob("fuzz_*.c"))
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        futures = {name: pool.submit(run, build / f"tests/fuzz/rerun_{name}", name) for name in names}
    failed = False
    reached = {}
    with open(build / "reached.csv", "w", encoding="ascii") as table:
        table.write("target,edges,of\n")
        for name in names:
            try:
                edges, total, reached[name] = futures[name].result()
            except (RuntimeError, OSError, StopIteration) as error:
                print(f"not ok reached {error}")
                failed = True
                continue
            table.write(f"{name},{edges},{total}\n")
            print(f"# fuzz_{name}: {edges} of {total} edges")
    for function in sorted(public_functions()):
        by = [name for name in names if function in reached.get(name, ())]
        print(f"{'ok' if by else 'not ok'} reached {function}: {' '.join(by) if by else 'by no target'}")
        failed |= not by
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
