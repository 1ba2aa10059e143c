#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Faults planted on purpose (planted.c) are found, and what looks like one is not: by its name a test "finds" or "passes".

    check_planted.py PROGRAM

It is run whole, and once more in pieces: killed as soon as a test is over, and gone on with, until all is done.
"""
import os
import re
import subprocess
import sys
import tempfile


def tests_of(output):
    return {name: dict(zip(rest.split()[::2], map(int, rest.split()[1::2]))) for name, rest in re.findall(r"^test (\w+) (.*)$", output, re.M)}


def run(program, **more):
    ended = subprocess.run([program], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", timeout=300,
                           env={**os.environ, "FAULTS_CPU_LIMIT": "1", **more})
    return tests_of(ended.stdout)


def killed(program, tally):
    """The program's output until it was killed, a second after it began."""
    running = subprocess.Popen([program], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, "FAULTS_CPU_LIMIT": "1", "FAULTS_TALLY": tally})
    try:
        running.wait(1)
    except subprocess.TimeoutExpired:
        running.kill()
        running.wait()


def main():
    program = sys.argv[1]
    whole, wrong = run(program), []
    for name, sums in whole.items():
        verdict = "finds" if sums["findings"] else "passes"
        if not name.startswith(verdict):
            wrong.append(f"{name}: {sums}")
        if sums["failed"] != sums["allocations"] or not sums["allocations"]:
            wrong.append(f"{name}: not every allocation failed: {sums}")
    with tempfile.TemporaryDirectory() as folder:
        tally = os.path.join(folder, "tally")
        killed(program, tally)
        again = run(program, FAULTS_TALLY=tally)
    for name, sums in again.items():
        if any(sums[kind] != whole[name][kind] for kind in ("allocations", "failed")) or (sums["findings"] > 0) != (whole[name]["findings"] > 0):
            wrong.append(f"{name}: killed and gone on with: {sums}, not {whole[name]}")
    for line in wrong:
        print("not ok", line)
    if not wrong and whole:
        print(f"ok {len(whole)} planted tests: what is a fault is found, what is none is not; also when killed and gone on with")
    sys.exit(1 if wrong or not whole else 0)


main()
