#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Check the freestanding line (layers 0 to 2) by the compiler's own call graph: no recursion, no unbounded stack, little of it.

Prints the deepest stack that each public function can need besides the C library's own.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("base", "geom", "table", "query")
LIMIT = 1024  # bytes, for anything here; look-ups need far less
NODE = re.compile(r'^node: \{ title: "([^"]+)" label: "[^"]*?(\d+) bytes \((static|dynamic[^)]*)\)', re.M)
EDGE = re.compile(r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"', re.M)


def graph():
    """Stack of each function, its kind, and whom it calls."""
    frames, calls = {}, {}
    with tempfile.TemporaryDirectory() as scratch:
        for folder in FOLDERS:
            for source in sorted((ROOT / "src" / folder).glob("*.c")):
                target = pathlib.Path(scratch) / f"{folder}-{source.stem}.o"
                subprocess.run(["gcc", "-std=c99", "-O2", "-Iinclude", "-Isrc", "-ffp-contract=off", "-fno-math-errno",
                                "-fcallgraph-info=su", "-c", str(source.relative_to(ROOT)), "-o", target], cwd=ROOT, check=True)
                text = target.with_suffix(".ci").read_text()
                frames.update({name: (int(size), kind) for name, size, kind in NODE.findall(text)})
                for caller, callee in EDGE.findall(text):
                    calls.setdefault(caller, set()).add(callee)
    return frames, calls


def deepest(name, frames, calls, known, above):
    """The stack below and with `name`; ValueError where a function reaches itself."""
    if name in above:
        raise ValueError(" -> ".join(above[above.index(name):] + [name]))
    if name not in known:
        inner = [deepest(callee, frames, calls, known, above + [name]) for callee in sorted(calls.get(name, ()))]
        known[name] = frames.get(name, (0, ""))[0] + max(inner, default=0)
    return known[name]


def main():
    frames, calls = graph()
    failed, known = False, {}
    for name in sorted(n for n in frames if n.startswith("tdsp_")):
        try:
            depth = deepest(name, frames, calls, known, [])
            wrong = f"{depth} bytes, over {LIMIT}" if depth > LIMIT else None
            wrong = "calls through a pointer" if "__indirect_call" in calls.get(name, ()) else wrong
        except ValueError as cycle:
            depth, wrong = 0, f"recursion: {cycle}"
        failed = failed or bool(wrong)
        print(f"not ok stack {name}: {wrong}" if wrong else f"ok stack {name}: {depth} bytes")
    for name, (_, kind) in frames.items():
        if kind.startswith("dynamic") and "bounded" not in kind:
            failed = True
            print(f"not ok stack {name}: unbounded")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
