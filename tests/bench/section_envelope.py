# SPDX-License-Identifier: MIT
"""Pieces of the arrival: the construction of N^2 pieces, and the layout that comes to mind first, which has few."""
import time

from common import note

GAPS = range(2, 13)
# Gaps, options of `tdsp envelope`: columns have no end of their own near the last gap.
KINDS = (("nsquared", 1, ()), ("columns", 3, ("--horizon", 1000, "--resolution", 1)))
HEADERS = {"envelope": ["kind", "gaps", "discs", "pieces", "forms", "jumps", "narrowest", "seconds"]}


def measure_one(run, kind, gaps, size, options):
    scene = run.generate(kind, size)
    begun = time.perf_counter()
    found = run.json([run.tdsp, "envelope", "--json", scene, *options])
    seconds = time.perf_counter() - begun
    pieces = found["pieces"]
    discs = run.json([run.tdsp, "generate", kind, "-n", size, "-o", run.work / "envelope.json", "--json"])["discs"]
    return {"kind": kind, "gaps": gaps, "discs": discs, "pieces": found["F"], "forms": found["forms"],
            "jumps": sum(piece["change"] == "jump" for piece in pieces), "seconds": f"{seconds:.3g}",
            "narrowest": f"{min(piece['until'] - piece['from'] for piece in pieces):.3g}"}


def measure(run):
    rows = []
    for kind, discs_a_gap, options in KINDS:
        for gaps in GAPS[:3] if run.short else GAPS:
            note(f"pieces of {kind}, {gaps} gaps")
            rows.append(measure_one(run, kind, gaps, gaps * discs_a_gap, options))
    return {"envelope": rows}
