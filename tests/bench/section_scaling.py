# SPDX-License-Identifier: MIT
"""Generated worlds of more and more discs."""
from common import SOLVE_HEADER, Failed, note

SIZES = (100, 316, 1000, 3162, 10000, 31623, 100000, 316228, 1000000)
NEAR_LEAST = 1000
# Near worlds are quick to ask, and differ more from seed to seed.
SEEDS_UP_TO = {"far": ((100000, 3), (1000000, 1)), "near": ((100000, 5), (1000000, 2))}
FAR = ("random", "crowd", "mixed", "wall", "sealed", "fenced")
NEAR = ("random", "crowd", "mixed", "sealed")
# This one's index is measured at every size, whatever its questions take.
PREPARED_TO_THE_END = "random"
# A question that took longer than this is not put to a larger world.
BUDGET_MS = 1000
HEADERS = {"scaling": SOLVE_HEADER}


def seeds(run, size, span):
    count = 1 if run.short else next(count for most, count in SEEDS_UP_TO[span] if size <= most)
    return range(1, count + 1)


def too_long(rows):
    return {row["operation"] for row in rows if float(row["ms"]) > BUDGET_MS}


def measure_series(run, kind, span):
    """An operation ends with the first point at which it takes too long."""
    found, operations = [], ["forward", "within", "neighbour", "reverse"]
    sizes = SIZES[:3] if run.short else SIZES
    for size in sizes if span == "far" else [n for n in sizes if n >= NEAR_LEAST]:
        point = []
        for seed in seeds(run, size, span):
            note(f"{kind} {span} {size} seed {seed}")
            try:
                point += run.solve(0.02 if run.short else 0.1, ",".join(operations or ["prepare"]), "made", kind, size, span, seed)
            except Failed as why:
                note(f"{kind} {span} {size}: {why}")
                return found + point
        found += point
        slow = too_long(point)
        operations = [name for name in operations if name not in slow]
        if "forward" not in operations: # the neighbour and the arrival to ask backwards for come from it
            operations = [name for name in operations if name == "within"]
        if not operations and kind != PREPARED_TO_THE_END:
            break
    return found


def measure(run):
    rows = []
    for span, kinds in (("far", FAR), ("near", NEAR)):
        for kind in kinds:
            rows += measure_series(run, kind, span)
    return {"scaling": rows}
