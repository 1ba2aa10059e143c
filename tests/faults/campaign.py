#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run test programs whose allocations fail (tests/faults/inject.h) and add up what came of it: one "ok" or "not ok" a program, and the sums.

    campaign.py [--jobs N] [--report FILE] PROGRAM...

FAULTS_ALL, FAULTS_EACH_PATH and so on (tests/faults/run_tests.c) say how many fail. A finding prints what the victim said.
"""
import argparse
import collections
import concurrent.futures
import os
import subprocess
import sys


def run(program):
    """The program's output, its status, and the sums of its tests."""
    done = subprocess.run([program], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, errors="replace")
    sums = collections.Counter()
    for line in done.stdout.splitlines():
        words = line.split()
        if words[:1] != ["test"] or len(words) < 4:
            continue
        sums["tests"] += 1
        for name, number in zip(words[2::2], words[3::2]):
            sums[name] += int(number)
    return program, done, sums


def shown(sums):
    return (f"{sums['failed']} of {sums['allocations']} allocations failed, by {sums['paths']} ways, in {sums['victims']} victims:"
            f" {sums['refused']} refused, {sums['endured']} endured, {sums['findings']} findings")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--report")
    parser.add_argument("programs", nargs="+")
    asked = parser.parse_args()
    total, bad, report = collections.Counter(), 0, []
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        for program, done, sums in pool.map(run, asked.programs):
            name = "/".join(program.split(os.sep)[-2:])
            sound = done.returncode == 0 and sums["findings"] == 0 and sums["tests"] > 0
            lines = [f"{'ok' if sound else 'not ok'} {name}: {sums['tests']} tests, {shown(sums)}"]
            if sums["threaded"]:
                lines.append(f"   {sums['threaded']} more were made while several threads ran, and none of them failed")
            if not sound:
                lines += [f"   exit status {done.returncode}", done.stdout[-20000:]]
            print("\n".join(lines), flush=True)
            report += lines
            bad += not sound
            total += sums
    report.append(f"{len(asked.programs)} programs, {total['tests']} tests, {total['stopped']} of them cut short: {shown(total)}")
    print(report[-1])
    if asked.report:
        os.makedirs(os.path.dirname(asked.report), exist_ok=True)
        with open(asked.report, "w") as file:
            file.write("\n".join(report) + "\n")
    sys.exit(1 if bad else 0)


main()
