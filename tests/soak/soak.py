#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Spread the soak over processes, in parts that are kept: a run that was stopped goes on where it stopped.

  soak.py --program build/tests/soak/soak --out build/soak --scenes 1000000 --seed 1 --jobs 2

Each part of a thousand scenes is one process, whose counts stay in OUT/SEED/; a part is done again when the program has changed. Minimal scenes of what
fails are OUT/NAME.json, each with OUT/NAME.txt, which says what is wrong and how to see it. Exit status 1 where anything failed.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import pathlib
import subprocess
import sys
import time

PART = 1000


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--scenes", type=int, default=1000000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--from", type=int, default=0, dest="first", help="the first scene")
    return parser.parse_args()


class Part:
    """Scenes from `first` on, their counts in `report` and what failed in `log`."""

    def __init__(self, args, state, first, last):
        self.args, self.first, self.count = args, first, min(PART, last - first)
        self.report, self.log = state / f"{first}-{self.count}.counts", state / f"{first}-{self.count}.log"

    def is_done(self):
        return self.report.exists()

    def run(self):
        command = [self.args.program, "--seed", str(self.args.seed), "--from", str(self.first), "--count", str(self.count),
                   "--quiet", "--found", str(self.args.out), "--report", str(self.report)]
        with open(self.log, "w", encoding="utf-8") as log:
            status = subprocess.run(command, stdout=log, stderr=subprocess.STDOUT, check=False).returncode
        return self, status

    def failures(self):
        return [line.rstrip() for line in self.log.read_text(encoding="utf-8").splitlines() if line.startswith(("not ok", "  smaller"))]


class Counts:
    """The sum of all parts."""

    def __init__(self):
        self.mixes, self.checks, self.seconds, self.failed = collections.Counter(), collections.Counter(), 0.0, []
        self.mix_failures, self.check_failures, self.touches = collections.Counter(), collections.Counter(), collections.Counter()

    def add(self, part):
        self.failed += part.failures()
        for line in part.report.read_text(encoding="utf-8").splitlines() if part.report.exists() else []:
            kind, *rest = line.split()
            if kind == "mix":
                self.mixes[rest[0]] += int(rest[1])
                self.mix_failures[rest[0]] += int(rest[2])
            elif kind == "check":
                self.checks[rest[0]] += int(rest[1])
                self.check_failures[rest[0]] += int(rest[2])
                self.touches[rest[0]] += int(rest[3])
            else:
                self.seconds += float(rest[0])

    def text(self):
        lines = [f"{sum(self.mixes.values())} scenes, {sum(self.checks.values())} checks, {sum(self.check_failures.values())} discrepancies, "
                 f"{self.seconds:.0f} s of one core ({self.seconds / 3600:.2f} h)", "", "scenes  failed  mix"]
        lines += [f"{n:6d}  {self.mix_failures[mix]:6d}  {mix}" for mix, n in self.mixes.items()]
        lines += ["", "   times  failed  told apart by a touch  check"]
        lines += [f"{n:8d}  {self.check_failures[check]:6d}  {self.touches[check]:21d}  {check}" for check, n in self.checks.items()]
        return "\n".join(lines) + "\n"


def state_of(args):
    """Where parts are kept: for each seed, and only while the program is the same."""
    digest = hashlib.sha256(pathlib.Path(args.program).read_bytes()).hexdigest()[:12]
    state = args.out / str(args.seed) / digest
    state.mkdir(parents=True, exist_ok=True)
    return state


def run_parts(args, parts, counts):
    """Run what is not done yet, saying now and then how far it is."""
    waiting = [part for part in parts if not part.is_done()]
    print(f"{len(parts) - len(waiting)} of {len(parts)} parts are done already", flush=True)
    crashes, told = 0, time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for number, (part, status) in enumerate(pool.map(Part.run, waiting), 1):
            if status not in (0, 1):
                crashes += 1
                counts.failed.append(f"not ok: exit status {status} in scenes from {part.first}")
            for line in part.failures():
                print(line, flush=True)
            if time.monotonic() - told > 60 or number == len(waiting):
                told = time.monotonic()
                print(f"{number} of {len(waiting)} parts", flush=True)
    return crashes


def main():
    args = arguments()
    state = state_of(args)
    last = args.first + args.scenes
    parts = [Part(args, state, first, last) for first in range(args.first, last, PART)]
    counts = Counts()
    crashes = run_parts(args, parts, counts)
    for part in parts:
        counts.add(part)
    text = counts.text()
    (args.out / f"report-{args.seed}.txt").write_text("\n".join([text, *counts.failed]) + "\n", encoding="utf-8")
    print(text, end="")
    return 1 if crashes or sum(counts.mix_failures.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
