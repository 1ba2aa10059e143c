# SPDX-License-Identifier: MIT
"""Rows and oracle calls over epsilon, and what a second thread is worth."""
import math
import os
import pathlib
import statistics

from common import Failed, note
from section_real import build_table

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "scenes"
EPSILONS = (0.3, 0.1, 0.03, 0.01, 0.003, 0.001, 0.0003, 0.0001)
METHODS = (("travel", "adaptive"), ("arrival", "adaptive"), ("arrival", "geometric"))
HEADERS = {"epsilon": ["scene", "epsilon", "guarantee", "sampling", "rows", "forward_calls", "reverse_calls", "bytes", "seconds", "paper_calls",
                       "failed"],
           "threads": ["scene", "sampling", "threads", "runs", "seconds", "seconds_low", "seconds_high", "rows"]}


def scenes(run):
    return {"crowd of 100": run.generate("crowd", 100), "fire-oregon-c": EXAMPLES / "fire-oregon-c.json"}


def paper_calls(run, scene, report, epsilon):
    """The paper's bound on calls, (2 / epsilon) ln(a_last / a_0)."""
    first, last = (run.json([run.tdsp, "arrive", "--json", scene, repr(t)])["results"][0]["arrival"] for t in (0.0, report["last_departure"]))
    return 2 / epsilon * math.log(last / first)


def measure_epsilons(run, name, scene):
    rows = []
    for guarantee, sampling in METHODS:
        for epsilon in EPSILONS[:2] if run.short else EPSILONS:
            note(f"{name}: {sampling}, {guarantee} {epsilon:g}")
            row = {"scene": name, "epsilon": epsilon, "guarantee": guarantee, "sampling": sampling}
            try:
                report = build_table(run, scene, run.work / "epsilon.tdsp", guarantee, sampling, 0, epsilon)
                row.update(report, paper_calls=f"{paper_calls(run, scene, report, epsilon):.6g}")
            except Failed as why:
                row["failed"] = str(why)
            rows.append(row)
            if "failed" in row:
                break
    return rows


def measure_threads(run, name, scene):
    rows = []
    for sampling in ("adaptive", "geometric"):
        for threads in (1, os.cpu_count() or 1):
            reports = [build_table(run, scene, run.work / "threads.tdsp", "arrival", sampling, threads, 0.1 if run.short else 0.003)
                       for _ in range(1 if run.short else 5)]
            seconds = sorted(report["seconds"] for report in reports)
            rows.append({"scene": name, "sampling": sampling, "threads": threads, "runs": len(seconds), "rows": reports[0]["rows"],
                         "seconds": statistics.median(seconds), "seconds_low": seconds[0], "seconds_high": seconds[-1]})
    return rows


def measure(run):
    found = {"epsilon": [], "threads": []}
    for name, scene in scenes(run).items():
        found["epsilon"] += measure_epsilons(run, name, scene)
        found["threads"] += measure_threads(run, name, scene)
    return found
