#!/usr/bin/env python3
"""Measure tables on the real scenes and write docs/results.md. Python's standard library only.

    results.py --command build/tdsp --lookup build/tests/bench/lookup --scenes DIRECTORY [--limit SECONDS] [--only TEXT] -o docs/results.md

For each scene with a path at departure 0: one exact arrival, then adaptive and geometric tables at 1 %. What does not finish within the
limit says so in its row. Scenes are measured one after the other, each command on one thread, so that the times mean something.
"""
import argparse
import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile
import time

HEADER = """# Results on real scenes

Made by `make results`; do not edit. {machine} Times are in seconds of one thread, unless they say otherwise, and in the scene's own unit where they are
departures or travel times.

## Scenes

*arrive* is what one exact earliest arrival takes at departure 0, the best of three, the scene being prepared once before.

| scene | discs | prepare [ms] | arrive [ms] | T(0) | last departure | and then |
|---|--:|--:|--:|--:|--:|---|
{scenes}

## Tables at 1 %

The adaptive tables promise travel time or arrival time, the geometric one, which is Algorithm 1 of the paper, arrival time, the only promise
that it can make. *calls* are the sampler's forward and reverse searches; *seconds* are those of `tdsp build`. The last columns belong to
the first table: nanoseconds for one arrival, and for one position on the way, at departures in no order.

| scene | adaptive, travel: rows | calls | bytes | seconds | adaptive, arrival: rows | calls | bytes | seconds | geometric, arrival: rows | calls | bytes | seconds | arrival [ns] | position [ns] |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
{tables}

{closing}
"""
TABLES = (("travel", "adaptive"), ("arrival", "adaptive"), ("arrival", "geometric"))


class Failed(Exception):
    pass


def run(command, limit):
    """The JSON that a command prints, or None when its answer is no (exit status 1)."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        raise Failed(f"over {limit:g} s") from None
    if done.returncode not in (0, 1):
        raise Failed(f"exit status {done.returncode}: {done.stderr.strip().splitlines()[-1:]}")
    return json.loads(done.stdout) if done.stdout.strip() else None


def machine():
    name = "unknown processor"
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                name = line.partition(":")[2].strip()
                break
    except OSError:
        pass
    return (f"Machine: {name}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}; "
            f"{time.strftime('%Y-%m-%d', time.gmtime())}.")


def significant(value):
    return f"{value:.3g}"


def arrive_cells(command, scene, limit):
    """Milliseconds to prepare and to solve, and T(0); None when there is no path."""
    answer = run([command, "arrive", "--json", scene, "0", "0", "0"], limit)
    results = answer["results"] if answer else []
    if not results or results[0]["arrival"] is None:
        return None
    return [significant(1000 * answer["prepare_seconds"]), significant(1000 * min(r["seconds"] for r in results)),
            f"{results[0]['travel_time']:.6g}"]


def build(options, scene, table, guarantee, sampling):
    line = [options.command, "build", "--json", scene, "-o", table, "--guarantee", guarantee, "--sampling", sampling,
            "--epsilon", "0.01", "--threads", "1"]
    # A scene that nothing ever closes needs a horizon: ten times the travel time says enough.
    try:
        return run(line, options.limit)
    except Failed as why:
        if "exit status 2" not in str(why):
            raise
    travel = run([options.command, "arrive", "--json", scene, "0"], options.limit)["results"][0]["travel_time"]
    return dict(run(line + ["--horizon", repr(10 * travel)], options.limit), horizon=True)


def lookup_cells(options, table):
    measured = run([options.lookup, table], options.limit)
    return [f"{measured['arrival_ns']:.0f}", f"{measured['position_ns']:.0f}"]


def table_cells(report):
    return [str(report["rows"]), f"{report['forward_calls']} + {report['reverse_calls']}", str(report["bytes"]),
            significant(report["seconds"])]


def last_cells(report):
    return [f"{report['last_departure']:.6g}", ("horizon given: " if report.get("horizon") else "") + report["last_reason"]]


def table_row(options, scene, folder):
    """The last departure's cells, and those of the tables."""
    last, tables, lookup = ["", ""], [], ["", ""]
    for guarantee, sampling in TABLES:
        table = os.path.join(folder, f"{guarantee}-{sampling}.tdsp")
        try:
            report = build(options, scene, table, guarantee, sampling)
            last = last_cells(report)
            tables += table_cells(report)
            if guarantee == "travel":
                lookup = lookup_cells(options, table)
        except Failed as why:
            tables += [str(why), "", "", ""]
    return last, tables + lookup


def measure(options, scene):
    """The cells of both tables for one scene, or None when it has no path."""
    discs = len(json.loads(scene.read_text(encoding="utf-8"))["discs"])
    cells = arrive_cells(options.command, str(scene), options.limit)
    if cells is None:
        return None
    with tempfile.TemporaryDirectory() as folder:
        last, tables = table_row(options, str(scene), folder)
    return [scene.stem, str(discs)] + cells + last, [scene.stem] + tables


def lines(rows):
    return "\n".join("| " + " | ".join(cells) + " |" for cells in rows)


def measure_all(options, scenes):
    first, second, without = [], [], []
    for scene in scenes:
        print(f"results: {scene.stem}", file=sys.stderr)
        try:
            measured = measure(options, scene)
        except Failed as why:
            measured = [scene.stem, "", str(why)] + [""] * 4, [scene.stem] + [""] * 14
        if measured:
            first.append(measured[0])
            second.append(measured[1])
        else:
            without.append(scene.stem)
    closing = f"No path at departure 0, so no table: {', '.join(without)}." if without else "Every scene has a path."
    return HEADER.format(machine=machine(), scenes=lines(first), tables=lines(second), closing=closing)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", required=True)
    parser.add_argument("--lookup", required=True)
    parser.add_argument("--scenes", required=True, type=pathlib.Path)
    parser.add_argument("--limit", type=float, default=300)
    parser.add_argument("--only", default="")
    parser.add_argument("-o", "--output", required=True, type=pathlib.Path)
    options = parser.parse_args()
    scenes = sorted(options.scenes.glob("*.json"), key=lambda p: p.stat().st_size)
    scenes = [s for s in scenes if options.only in s.stem]
    if not scenes:
        print(f"results: no scenes in {options.scenes}; set TDSP_DATA", file=sys.stderr)
        return 1
    options.output.write_text(measure_all(options, scenes), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
