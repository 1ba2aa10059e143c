# SPDX-License-Identifier: MIT
"""What a user would take instead, on the same worlds of 1,000 discs, in the same run."""
import json
import os
import statistics
import subprocess
import sys

from common import Failed, note

DISCS = 1000
# With the peers come their own scenes, else the like of them are generated here.
THEIRS = ("random", "mixed-growth")
OURS = ("random", "mixed")
GRIDS = (1024, 2048)
REPEATS = 5
SLOW = 2.0 # seconds: what takes longer is run once
HEADERS = {"peers": ["scene", "peer", "setting", "source", "runs", "seconds", "seconds_low", "seconds_high", "setup_seconds", "arrival",
                     "travel_error", "failed"]}


def repeated(run, once):
    """Median, lowest and highest of several runs of what returns seconds and more."""
    found = [once()]
    while len(found) < (1 if run.short or found[0]["seconds"] > SLOW else REPEATS):
        found.append(once())
    seconds = sorted(one["seconds"] for one in found)
    return dict(found[0], runs=len(found), seconds=statistics.median(seconds), seconds_low=seconds[0], seconds_high=seconds[-1])


def library(run, scene, operation):
    rows = {row["operation"]: row for row in run.solve(0.05 if run.short else 0.5, operation, "file", scene)}
    asked, prepared = rows[operation], rows["prepare"]
    return {"runs": asked["runs"], "seconds": float(asked["ms"]) / 1e3, "seconds_low": float(asked["ms_low"]) / 1e3,
            "seconds_high": float(asked["ms_high"]) / 1e3, "setup_seconds": float(prepared["ms"]) / 1e3, "arrival": float(asked["answer"])}


def baseline(run, scene, how):
    def once():
        arrival, seconds, _, _, _ = run.output([run.program("tangents"), how, scene, 0], limit=120).strip().split(",")
        return {"arrival": float(arrival), "seconds": float(seconds), "setup_seconds": 0.0}
    return repeated(run, once)


def peer(run, scene, script, *options):
    def once():
        line = [sys.executable, run.peers / script, scene, "--depart", 0, *options]
        found = json.loads(run.output(line, limit=120).strip().splitlines()[-1])
        return {name: found[name] for name in ("arrival", "seconds", "setup_seconds")}
    return repeated(run, once)


def anytime(run, scene):
    """OMPL improves its path as long as it is let: one row for each time that it was given."""
    report = json.loads(run.output([sys.executable, run.peers / "ompl_cpp.py", scene, "--depart", 0, "--planner", "informed"], limit=120))
    return [{"runs": 1, "seconds": one["budget"], "arrival": one["arrival"]} for one in report["params"]["runs"]
            if isinstance(one["arrival"], float)]


def has_ompl():
    try:
        return subprocess.run(["pkg-config", "--exists", "ompl"]).returncode == 0
    except OSError:
        return False


def worlds(run):
    discs = 100 if run.short else DISCS
    if not (run.peers / "gen_scene.py").exists():
        return {f"{kind} {discs}": run.generate(kind, discs) for kind in OURS}
    found = {}
    for kind in THEIRS:
        path = run.work / f"peers-{kind}-{discs}.json"
        run.output([sys.executable, run.peers / "gen_scene.py", kind, discs, "--seed", 1, "--out", path])
        found[f"{kind} {discs}"] = path
    return found


def jobs(run, scene):
    """(peer, setting, whose, function returning one measurement)"""
    yield "this library", "exact", "own", lambda: library(run, scene, "forward")
    yield "this library", "within 1 %", "own", lambda: library(run, scene, "within")
    yield "tangent graph, Dijkstra", "exact", "own", lambda: baseline(run, scene, "eager")
    yield "tangent graph, lazy, A*", "exact", "own", lambda: baseline(run, scene, "lazy")
    if not (run.peers / "naive_exact.py").exists():
        return
    yield "tangent graph, Dijkstra", "exact", "peers", lambda: peer(run, scene, "naive_exact.py")
    yield "tangent graph, lazy, A*", "exact", "peers", lambda: peer(run, scene, "naive_exact.py", "--lazy", "--astar")
    for grid in GRIDS[:1] if run.short else GRIDS:
        yield "fast marching", f"grid {grid}", "peers", lambda grid=grid: peer(run, scene, "fmm.py", "--grid", grid)
        yield "lazy Theta*", f"grid {grid}", "peers", lambda grid=grid: peer(run, scene, "grid_astar.py", "--mode", "lazy", "--grid", grid)


def measure_world(run, name, scene):
    rows = []
    for who, setting, source, once in jobs(run, scene):
        note(f"{name}: {who} {setting}")
        row = {"scene": name, "peer": who, "setting": setting, "source": source}
        try:
            row.update(once())
        except Failed as why:
            row["failed"] = str(why)
        rows.append(row)
    if not run.short and (run.peers / "ompl_cpp.py").exists() and has_ompl():
        note(f"{name}: OMPL")
        rows += [{"scene": name, "peer": "OMPL, informed RRT*", "setting": f"{one['seconds']:g} s given", "source": "peers", **one}
                 for one in anytime(run, scene)]
    exact = rows[0]["arrival"]
    for row in rows:
        row["travel_error"] = f"{row['arrival'] / exact - 1:.3g}" if row.get("arrival") else ""
    return rows


def measure(run):
    os.environ["PEERS_BUILD"] = str((run.work / "peers").resolve())
    return {"peers": [row for name, scene in worlds(run).items() for row in measure_world(run, name, scene)]}
