# SPDX-License-Identifier: MIT
"""Real scenes: what a question costs, and tables at 1 %."""
import json

from common import SOLVE_HEADER, Failed, note

# Guarantee, sampling, threads (0: all processors).
TABLES = (("travel", "adaptive", 1), ("travel", "adaptive", 0), ("arrival", "adaptive", 0), ("arrival", "geometric", 0))
TABLE_HEADER = ["scene", "guarantee", "sampling", "threads", "rows", "forward_calls", "reverse_calls", "bytes", "seconds", "last_departure",
                "last_reason", "horizon", "arrival_ns", "position_ns", "failed"]
HEADERS = {"scenes": SOLVE_HEADER + ["failed"], "tables": TABLE_HEADER}


def build_table(run, scene, table, guarantee, sampling, threads, epsilon=0.01):
    """The report of `tdsp build`. A scene that nothing ever closes gets a horizon: ten times its travel time says enough."""
    line = [run.tdsp, "build", "--json", scene, "-o", table, "--guarantee", guarantee, "--sampling", sampling, "--epsilon", epsilon]
    line += ["--threads", threads] if threads else []
    try:
        return dict(run.json(line), horizon="")
    except Failed as why:
        if "exit status 2" not in str(why):
            raise
    horizon = 10 * run.json([run.tdsp, "arrive", "--json", scene, 0])["results"][0]["travel_time"]
    return dict(run.json(line + ["--horizon", repr(horizon)]), horizon=horizon)


def look_up(run, table):
    found = json.loads(run.output([run.program("lookup"), table]))
    return {"arrival_ns": f"{found['arrival_ns']:.0f}", "position_ns": f"{found['position_ns']:.0f}"}


def measure_tables(run, scene):
    rows = []
    for guarantee, sampling, threads in TABLES:
        table = run.work / "real.tdsp"
        row = {"scene": scene.stem, "guarantee": guarantee, "sampling": sampling, "threads": threads or "all"}
        try:
            row.update(build_table(run, scene, table, guarantee, sampling, threads))
            if (guarantee, threads) == ("travel", 1):
                row.update(look_up(run, table))
        except Failed as why:
            row["failed"] = str(why)
        rows.append(row)
    return rows


def measure(run):
    found = {"scenes": [], "tables": []}
    paths = sorted(run.scenes.glob("*.json"), key=lambda path: (path.stat().st_size, path.name))
    if run.short:
        paths = paths[:2]
    if not paths:
        note(f"no real scenes in {run.scenes}; set TDSP_DATA")
        return {}
    for path in paths:
        note(path.stem)
        try:
            questions = run.solve(0.05 if run.short else 0.2, "all", "file", path)
        except Failed as why:
            questions = [{"world": path.stem, "failed": str(why)}]
        found["scenes"] += questions
        if any(row.get("operation") == "forward" and row["status"] == "ok" for row in questions):
            found["tables"] += measure_tables(run, path)
    return found
