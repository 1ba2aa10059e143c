#!/usr/bin/env python3
"""Measure tables on the real scenes and write docs/results.md. Python's standard library only.

    results.py --command build/tdsp --scenes DIRECTORY [--limit SECONDS] [--only TEXT] -o docs/results.md

For each scene with a path at departure 0: one exact arrival, then the adaptive and the geometric table at 1 %. A scene that does not finish within the limit
says so in its row. Scenes are measured one after the other, each command on one thread, so that the times mean something.
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

Made by `make results`; do not edit. One departure is solved exactly for the column *arrive* (the search alone, the scene being
prepared). Both tables promise 1 %: the adaptive one in travel time ("travel") and in arrival time ("arrival"), the geometric one, which
is Algorithm 1 of the paper, in arrival time, the only promise that it can make. *Calls* are forward and reverse searches of the
sampler; *seconds* are those of `tdsp build` on one thread.

{machine}

| scene | discs | arrive [ms] | T(0) | last departure | adaptive, travel: rows | calls | bytes | seconds | adaptive, arrival: rows | calls | seconds | geometric, arrival: rows | calls | bytes | seconds |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
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


def arrive_cells(command, scene, limit):
    """Best of three departures at 0: milliseconds, T(0); None when there is no path."""
    answer = run([command, "arrive", "--json", scene, "0", "0", "0"], limit)
    results = answer["results"] if answer else []
    if not results or results[0]["arrival"] is None:
        return None
    return [f"{1000 * min(r['seconds'] for r in results):.2f}", f"{results[0]['travel_time']:.6g}"]


def build(command, scene, guarantee, sampling, limit):
    with tempfile.TemporaryDirectory() as folder:
        line = [command, "build", "--json", scene, "-o", os.path.join(folder, "t.tdsp"), "--guarantee", guarantee,
                "--sampling", sampling, "--epsilon", "0.01", "--threads", "1"]
        # A scene that nothing ever closes needs a horizon: ten times the travel time says enough.
        try:
            return run(line, limit)
        except Failed as why:
            if "exit status 2" not in str(why):
                raise
        travel = run([command, "arrive", "--json", scene, "0"], limit)["results"][0]["travel_time"]
        return dict(run(line + ["--horizon", repr(10 * travel)], limit), horizon=True)


def table_cells(report, guarantee, sampling):
    calls = f"{report['forward_calls']} + {report['reverse_calls']}"
    with_bytes = [str(report["bytes"])] if (guarantee, sampling) != ("arrival", "adaptive") else []
    return [str(report["rows"]), calls] + with_bytes + [f"{report['seconds']:.2f}"]


def last_cell(report):
    return f"{report['last_departure']:.6g} ({'horizon' if report.get('horizon') else report['last_reason']})"


def row(command, scene, limit):
    """The cells of one scene, or None when it has no path."""
    name = scene.stem
    discs = len(json.loads(scene.read_text())["discs"])
    cells = arrive_cells(command, str(scene), limit)
    if cells is None:
        return None
    last, tables = None, []
    for guarantee, sampling in TABLES:
        width = 3 if (guarantee, sampling) == ("arrival", "adaptive") else 4
        try:
            report = build(command, str(scene), guarantee, sampling, limit)
            last = last or last_cell(report)
            tables += table_cells(report, guarantee, sampling)
        except Failed as why:
            tables += [str(why)] + [""] * (width - 1)
    return [name, str(discs)] + cells + [last or ""] + tables


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", required=True)
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
    lines, without = [], []
    for scene in scenes:
        print(f"results: {scene.stem}", file=sys.stderr)
        try:
            cells = row(options.command, scene, options.limit)
        except Failed as why:
            cells = [scene.stem, "", str(why)]
        if cells is None:
            without.append(scene.stem)
        else:
            lines.append("| " + " | ".join(cells) + " |")
    text = HEADER.format(machine=machine()) + "\n".join(lines) + "\n"
    if without:
        text += "\nNo path at departure 0, so no table: " + ", ".join(without) + ".\n"
    options.output.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
