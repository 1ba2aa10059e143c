# SPDX-License-Identifier: MIT
"""What the sections of the bench share: programs and their limits, CSV files, the machine."""
import csv
import json
import os
import pathlib
import platform
import subprocess
import sys
import time

# The columns that build/tests/bench/solve prints.
SOLVE_HEADER = ["world", "wanted", "span", "seed", "discs", "operation", "runs", "ms", "ms_low", "ms_high", "answer", "status",
                "bytes", "peak_bytes", "rounds", "labels", "legs_tested"]
MACHINE_HEADER = ["section", "machine", "date"]


class Failed(Exception):
    """A program that did not finish in its time, or not well; says so in a cell."""


class Run:
    """Where things are, and how much is wanted."""

    def __init__(self, options):
        self.build = pathlib.Path(options.build)
        self.scenes = pathlib.Path(options.scenes)
        self.peers = pathlib.Path(options.peers)
        self.limit = options.limit
        self.short = options.short
        self.work = self.build / "bench"
        self.work.mkdir(parents=True, exist_ok=True)
        self.tdsp = str(self.build / "tdsp")

    def program(self, name):
        return str(self.build / "tests" / "bench" / name)

    def output(self, line, limit=None):
        """What a command prints. Exit status 1 is an answer of `tdsp`; anything else but 0 is a failure."""
        limit = limit or self.limit
        try:
            done = subprocess.run([str(part) for part in line], capture_output=True, text=True, timeout=limit)
        except subprocess.TimeoutExpired:
            raise Failed(f"over {limit:g} s") from None
        answers = (0, 1) if str(line[0]) == self.tdsp else (0,)
        if done.returncode not in answers:
            raise Failed(f"exit status {done.returncode}: {' '.join(done.stderr.strip().splitlines()[-1:])}")
        return done.stdout

    def json(self, line, limit=None):
        text = self.output(line, limit)
        return json.loads(text) if text.strip() else None

    def solve(self, share, operations, *world, limit=None):
        """Rows of the driver, as dictionaries."""
        text = self.output([self.program("solve"), share, operations, *world], limit)
        return [dict(zip(SOLVE_HEADER, row)) for row in csv.reader(text.splitlines())]

    def generate(self, kind, discs, seed=1):
        """A scene file of `tdsp generate`."""
        path = self.work / f"{kind}-{discs}-{seed}.json"
        self.output([self.tdsp, "generate", kind, "-n", discs, "--seed", seed, "-o", path])
        return path


def note(text):
    print(f"bench: {text}", file=sys.stderr, flush=True)


def machine():
    name = "unknown processor"
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                name = line.partition(":")[2].strip()
                break
    except OSError:
        pass
    return f"{name}, {os.cpu_count()} cores, {platform.system()} {platform.machine()}"


def today():
    return time.strftime("%Y-%m-%d", time.gmtime())


def write_csv(path, header, rows):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, header, lineterminator="\n", extrasaction="ignore")
        writer.writeheader()
        writer.writerows(rows)


def read_csv(path):
    """Rows as dictionaries; none where there is no such file."""
    if not path.exists():
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))
