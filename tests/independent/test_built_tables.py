#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tables that the command builds, read by the second reader: both must say the same of every row, answer and path.

The command is the one named by TDSP, else build/tdsp.
"""
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
from read_table import Table  # noqa: E402

COMMAND = os.environ.get("TDSP", str(ROOT / "build" / "tdsp"))
BUILDS = {"travel": ["--epsilon", "0.05"], "arrival": ["--guarantee", "arrival", "--epsilon", "0.1"],
          "absolute": ["--guarantee", "absolute", "--delta", "20"],
          "geometric": ["--guarantee", "arrival", "--sampling", "geometric", "--epsilon", "0.2"]}
GROWING = {"robot": {"speed": 1}, "source": [-10, 0], "destination": [10, 0],
           "discs": [{"center": [0, 3], "radius": 1, "growth": 0.1}, {"center": [-3, -1], "radius": 1, "growth": [0.1, 0.004]},
                     {"center": [5, 1.5], "radius": 0.2, "growth": {"times": [0, 5, 12], "rates": [0.1, 0.3, 0.02]}}]}


def gap_of(table, row):
    """What the file says closes after a row."""
    first, second, time, x, y = table.gaps.get(row, [None] * 5)
    return {"first": first, "second": second, "time": time, "place": None if first is None else [x, y]}


def tdsp(*words):
    done = subprocess.run([COMMAND, *map(str, words), "--json"], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1):
        raise AssertionError("tdsp %s: %s" % (words[0], done.stderr.strip()))
    return json.loads(done.stdout)


def finite(x):
    return x if x is not None and math.isfinite(x) else None


def same(what, found, expected):
    if found != expected:
        raise AssertionError("%s: the command says %r, the second reader %r" % (what, found, expected))


def departures(table, chance):
    rows = chance.sample(table.departures, min(6, table.rows))
    spread = [chance.uniform(0, table.departures[-1] * 1.05) for _ in range(20)]
    return rows + [math.nextafter(b, math.inf) for b in rows] + spread


def check_info(table, file):
    info = tdsp("info", file)
    header = {"bytes": len(table.data), "rows": table.rows, "legs": table.legs, "curves": len(table.curves),
              "guarantee": table.guarantee,
              "sampling": table.sampling, "monotone": table.monotone, "error": table.error, "speed": table.speed,
              "scene_hash": "%016x" % table.scene_hash, "source": list(table.source), "destination": list(table.destination),
              "first_departure": table.first_departure, "last_departure": table.last_departure, "last_reason": table.last_reason,
              "units": {"length": table.length_unit, "time": table.time_unit},
              "jumps": [{"row": i, "departure": table.departures[i], "before": table.left[i], "after": table.right[i],
                         "size": table.right[i] - table.left[i], **gap_of(table, i)}
                        for i in range(table.rows) if table.jump(i)]}
    for key, expected in header.items():
        same(key, info[key], expected)


def check_arrivals(table, file, times):
    answers = tdsp("query", file, *map(repr, times))["results"]
    same("departures answered", [answer["departure"] for answer in answers], times)
    for answer in answers:
        expected = table.arrive(answer["departure"])
        row = {"lower": expected[1], "upper": expected[2], "status": "ok"} if expected else {
            "lower": None, "upper": None, "status": table.last_reason}
        same("query %r" % answer["departure"], {key: answer[key] for key in row}, row)


def check_departures(table, file, chance):
    arrivals = [chance.uniform(0, table.departures[-1] + 1.1 * table.left[-1]) for _ in range(20)]
    arrivals += [table.departures[i] + table.left[i] for i in chance.sample(range(table.rows), min(5, table.rows))]
    answers = tdsp("query", file, "--arrive-by", *map(repr, arrivals))["results"]
    same("arrivals answered", [answer["arrival"] for answer in answers], arrivals)
    for answer in answers:
        expected = table.depart(answer["arrival"]) or (None, None)
        same("arrive by %r" % answer["arrival"], [answer["departure"], answer["departure_upper"]], [finite(x) for x in expected])


def check_path(table, file, t):
    answer = tdsp("path", file, repr(t))
    found = table.arrive(t)
    if found is None:
        same("path %r" % t, answer["status"], table.last_reason)
        return
    row, _, upper = found
    b = table.departures[row]
    same("row of %r" % t, [answer["row"], answer["computed_for"]], [row, b])
    legs = []
    for leg in table.paths[row]:
        left_out = ("angle_from",) if "rates" in leg else ("angle_from", "sweep")
        leg = {key: value for key, value in leg.items() if key not in left_out}
        if t != b:
            leg["start_time"] = min(t + (leg["start_time"] - b), upper)
            leg["end_time"] = min(t + (leg["end_time"] - b), upper)
        legs.append(leg)
    same("path %r" % t, [{key: leg[key] for key in mine} for leg, mine in zip(answer["legs"], legs)], legs)
    same("legs of %r" % t, len(answer["legs"]), len(legs))


def check_build(scene, words, directory):
    file = os.path.join(directory, "table.tdsp")
    if tdsp("build", scene, "-o", file, *words).get("rows") is None:
        raise AssertionError("nothing was built")
    chance = random.Random(1)
    table = Table(pathlib.Path(file).read_bytes())
    times = departures(table, chance)
    check_info(table, file)
    check_arrivals(table, file, times)
    check_departures(table, file, chance)
    for t in chance.sample(times, 6):
        check_path(table, file, t)


def main():
    failed = 0
    scenes = [ROOT / "examples" / "scenes" / name for name in ("two-discs.json", "fire-oregon-c.json")]
    with tempfile.TemporaryDirectory() as directory:
        growing = pathlib.Path(directory) / "growing.json"
        growing.write_text(json.dumps(GROWING), encoding="utf-8")
        for scene in scenes + [growing]:
            for name, words in BUILDS.items():
                text = "%s, %s: the command and the second reader agree" % (scene.stem, name)
                try:
                    check_build(scene, words, directory)
                    print("ok " + text)
                except AssertionError as why:
                    failed += 1
                    print("not ok " + text)
                    print("    %s" % why, file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
