#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Faults planted on purpose (planted.c) are found, and what looks like one is not: by its name a test "finds" or "passes".

    check_planted.py PROGRAM

It is run with forks, by rewinding (rewind.h), and once more in pieces: killed in its midst and gone on with.
"""
import os
import re
import subprocess
import sys
import tempfile

FORKS = {"FAULTS_CPU_LIMIT": "1", "FAULTS_REWIND": "0"}
REWINDS = {"FAULTS_CPU_LIMIT": "1", "FAULTS_EACH_PATH": "0", "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":detect_stack_use_after_return=0"}


def tests_of(output):
    return {name: dict(zip(rest.split()[::2], map(int, rest.split()[1::2]))) for name, rest in re.findall(r"^test (\w+) (.*)$", output, re.M)}


def run(program, how, **more):
    ended = subprocess.run([program], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", timeout=300,
                           env={**os.environ, **how, **more})
    return tests_of(ended.stdout)


def kill_early(program, how, tally):
    running = subprocess.Popen([program], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={**os.environ, **how, "FAULTS_TALLY": tally})
    try:
        running.wait(1)
    except subprocess.TimeoutExpired:
        running.kill()
        running.wait()


def wrong_in(tests, rewound):
    for name, sums in tests.items():
        if not name.startswith("finds" if sums["findings"] else "passes"):
            yield f"{name}: {sums}"
        if sums["failed"] != sums["allocations"] or not sums["allocations"]:
            yield f"{name}: not every allocation failed: {sums}"
        if not sums["findings"] and sums["rewound"] != (sums["victims"] if rewound else 0):
            yield f"{name}: {'not ' if rewound else ''}rewound: {sums}"


def main():
    program = sys.argv[1]
    forked, rewound = run(program, FORKS), run(program, REWINDS)
    wrong = [*wrong_in(forked, False), *wrong_in(rewound, True)]
    with tempfile.TemporaryDirectory() as folder:
        tally = os.path.join(folder, "tally")
        kill_early(program, REWINDS, tally)
        wrong += wrong_in(run(program, REWINDS, FAULTS_TALLY=tally), True)
    for line in wrong:
        print("not ok", line)
    if not wrong and forked:
        print(f"ok {len(forked)} planted tests, with forks, rewound, and killed and gone on with: what is a fault is found, what is none is not")
    sys.exit(1 if wrong or not forked else 0)


main()
