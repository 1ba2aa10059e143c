#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Check that the layers of docs/README.md hold: a file of the library includes its own folder and lower layers only.

Folders on one layer never include each other; a public header includes public headers only. The C library's headers are held
to the layer too: below the freestanding line (layers 0 to 2) only those that a microcontroller has. An include that no rule
speaks of is a failure: a new folder gets its layer here first. And the sampler says no word about discs.
"""
import pathlib
import re
import sys

LAYERS = {"base": 0, "geom": 1, "table": 1, "query": 2, "scene": 3, "growth": 4, "search": 5, "build": 6, "oracle": 6, "shape": 6, "verify": 6, "margin": 6}
LINE = 2
FREESTANDING = {"float.h", "limits.h", "math.h", "stddef.h", "stdint.h", "string.h"}
HOSTED = FREESTANDING | {"assert.h", "stdlib.h"}
# What code below the line may know of the public interface.
PUBLIC_BELOW = {"export.h", "matrix.h", "path.h", "status.h", "table.h", "types.h"}
# The verifier is the second opinion on the engine: it shares none of its geometry, though the layers would allow it. The sampler
# and the conformance kit know an oracle and nothing of discs (docs/decisions/0001). Margins ask the public solver, so that they hold for whatever engine it has.
FORBIDDEN = {("verify", "geom"), ("verify", "growth"), ("verify", "search"), ("build", "geom"), ("build", "growth"), ("build", "search"),
             ("margin", "geom"), ("margin", "growth"), ("margin", "search"),
             ("oracle", "geom"), ("oracle", "growth"), ("oracle", "search")}

# The sampler's own words say so too, comments and all: of discs only what writes legs into a table may speak.
DISC_WORDS = re.compile(r"(?<![A-Za-z])(discs?|circles?|tangents?|spirals?|radius|radii)(?![a-z])", re.I)
SPEAKS_OF_DISCS = {"leg.c", "leg.h"}

INCLUDE = re.compile(r'^\s*#\s*include\b\s*(.*?)\s*$', re.M)


def system_edge(folder, target):
    allowed = FREESTANDING if LAYERS[folder] <= LINE else HOSTED
    return None if target in allowed else f"<{target}> is not for layer {LAYERS[folder]}"


def own_edge(folder, target):
    head, _, rest = target.partition("/")
    if head == "tdsp":
        below = LAYERS[folder] > LINE or rest in PUBLIC_BELOW
        return None if below else f"{target} lies above the freestanding line"
    if head not in LAYERS:
        return f"{target}: no rule says which layer that is"
    lower = head == folder or LAYERS[head] < LAYERS[folder]
    if (folder, head) in FORBIDDEN or not lower:
        return f"{folder} (layer {LAYERS[folder]}) may not include {head} (layer {LAYERS[head]})"
    return None


def source_edge(folder, include):
    """What is wrong with an include in a file of `folder`; None when nothing is."""
    target = include[1:-1]
    if folder not in LAYERS:
        return f"folder {folder}: no rule says which layer that is"
    if include[:1] == "<" and include[-1:] == ">":
        return system_edge(folder, target)
    if include[:1] == '"' and include[-1:] == '"':
        return own_edge(folder, target)
    return f"cannot read #include {include}"


def public_edge(_, include):
    fine = include in ("<stddef.h>", "<stdint.h>") or include.startswith('"tdsp/')
    return None if fine else f"{include} in a public header"


def problems(path, folder, judge):
    includes = INCLUDE.findall(re.sub(r"/\*.*?\*/", " ", path.read_text(encoding="utf-8"), flags=re.S))
    return [problem for problem in (judge(folder, include) for include in includes) if problem]


def words(path):
    """The lines of a file of the sampler that speak of discs."""
    if path.parent.name != "build" or path.name in SPEAKS_OF_DISCS:
        return []
    lines = path.read_text(encoding="utf-8").split("\n")
    found = ((number, DISC_WORDS.search(line)) for number, line in enumerate(lines, 1))
    return [f"line {number}: the sampler knows nothing of a {match[0]}" for number, match in found if match]


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    found = {}
    for path in sorted(p for p in (root / "src").rglob("*") if p.suffix in (".c", ".h")):
        found[path] = problems(path, path.relative_to(root / "src").parts[0], source_edge) + words(path)
    for path in sorted((root / "include" / "tdsp").glob("*.h")):
        found[path] = problems(path, "include", public_edge)
    for path, wrong in found.items():
        print(f"not ok layers {path.relative_to(root)}: {'; '.join(wrong)}" if wrong else f"ok layers {path.relative_to(root)}")
    return int(any(found.values()))


if __name__ == "__main__":
    sys.exit(main())
