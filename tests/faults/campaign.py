#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run test programs whose allocations fail (tests/faults/inject.h) and add up what came of it: one "ok", "unfinished" or "not ok" a program, and the sums.

    campaign.py [--jobs N] [--report FILE] [--keep DIR] [--seconds S] PROGRAM...

FAULTS_ALL, FAULTS_EACH_PATH and so on (tests/faults/run_tests.c) say how many fail. A finding prints what the victim said.

With --keep, each program's tallies are kept while it runs, in DIR/NAME-HASH.tally, where the hash is of the program and of these settings: whatever
ends a run, the next goes on where it was. With --seconds, no more is begun after that, and what was not reached is told as unfinished. The tests of
programs take turns, of growing length, so that the short ones come first.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import os
import pathlib
import subprocess
import sys
import time

TURNS = (1, 20, 0)  # seconds of the processor that a test goes on before others have theirs; 0: to its end


def identity(program):
    settings = sorted((name, value) for name, value in os.environ.items() if name.startswith("FAULTS_") or name == "TDSP_DATA")
    return hashlib.sha256(pathlib.Path(program).read_bytes() + repr(settings).encode()).hexdigest()[:16]


class Program:
    """What is known of a program so far, from its last turn."""

    def __init__(self, path, keep):
        self.path = path
        self.name = "/".join(path.split(os.sep)[-2:])
        self.sums = collections.Counter(tests=0, unfinished=1)
        self.status = 0
        self.said = ""
        self.environment = dict(os.environ)
        if keep:
            stem = self.name.replace("/", "-")
            tally = keep / f"{stem}-{identity(path)}.tally"
            for old in keep.glob(f"{stem}-*"):
                if old.stem != tally.stem:
                    old.unlink()
            self.environment["FAULTS_TALLY"] = str(tally)
            self.findings = tally.with_suffix(".findings")
        else:
            self.findings = None

    def run(self, until, turn):
        self.environment |= {"FAULTS_UNTIL": str(int(until or 0)), "FAULTS_TURN": str(turn)}
        ended = subprocess.run([self.path], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, errors="replace",
                               env=self.environment)
        self.sums, self.status = collections.Counter(), ended.returncode
        others = []
        for line in ended.stdout.splitlines():
            words = line.split()
            if words[:1] != ["test"] or len(words) < 4:
                others.append(line)
                continue
            self.sums["tests"] += 1
            for name, number in zip(words[2::2], words[3::2]):
                self.sums[name] += int(number)
        self.remember("\n".join(others))
        return self

    def remember(self, said):
        """What a finding said is kept as long as its tally."""
        if self.findings and self.sums["findings"]:
            with open(self.findings, "a") as file:
                file.write(said + "\n")
            said = self.findings.read_text()
        self.said = said

    def verdict(self):
        if self.status or self.sums["findings"] or not self.sums["tests"] and not self.sums["unfinished"]:
            return "not ok"
        return "unfinished" if self.sums["unfinished"] else "ok"

    def lines(self):
        lines = [f"{self.verdict()} {self.name}: {self.sums['tests']} tests, {shown(self.sums)}"]
        if self.sums["threaded"]:
            lines.append(f"   {self.sums['threaded']} more were made while several threads ran, and none of them failed")
        if self.verdict() == "not ok":
            lines += [f"   exit status {self.status}", self.said[-20000:]]
        return lines


def shown(sums):
    text = (f"{sums['failed']} of {sums['allocations']} allocations failed, by {sums['paths']} ways, in {sums['victims']} victims:"
            f" {sums['refused']} refused, {sums['endured']} endured, {sums['cut']} cut short, {sums['findings']} findings")
    return text + (f"; {sums['unfinished']} tests unfinished" if sums["unfinished"] else "")


def run_all(programs, jobs, end, turns):
    """Programs as they are finished, and last those that are not."""
    waiting = list(programs)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for turn in turns:
            if not waiting or end and time.time() >= end:
                break

            def go_on(program, turn=turn):
                return program if end and time.time() >= end else program.run(end, turn)

            unfinished = []
            for program in pool.map(go_on, waiting):
                if program.sums["unfinished"]:
                    unfinished.append(program)
                else:
                    yield program
            waiting = unfinished
    yield from waiting


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--report")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--seconds", type=float)
    parser.add_argument("programs", nargs="+")
    asked = parser.parse_args()
    begin = time.time()
    if asked.keep:
        asked.keep.mkdir(parents=True, exist_ok=True)
    total, bad, whole, report = collections.Counter(), 0, 0, []
    programs = [Program(path, asked.keep) for path in asked.programs]
    end = begin + asked.seconds if asked.seconds else None
    for program in run_all(programs, asked.jobs, end, TURNS if asked.keep else (0,)):
        print("\n".join(program.lines()), flush=True)
        report += program.lines()
        bad += program.verdict() == "not ok"
        whole += not program.sums["unfinished"]
        total += program.sums
    report.append(f"{whole} of {len(programs)} programs whole, {total['tests']} tests, {total['stopped']} of them cut short: {shown(total)};"
                  f" {time.time() - begin:.0f} s")
    print(report[-1])
    if asked.report:
        os.makedirs(os.path.dirname(asked.report), exist_ok=True)
        with open(asked.report, "w") as file:
            file.write("\n".join(report) + "\n")
    sys.exit(1 if bad else 0)


main()
