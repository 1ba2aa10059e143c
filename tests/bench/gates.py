#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Instruction counts of the hot paths, compared with the record. Python's standard library only.

    gates.py check|record GATES RECORD SCENES

Runs GATES under callgrind. `check` prints one line a workload and fails for each that takes over 10 % more instructions than RECORD says, `record`
writes RECORD anew. Counts repeat exactly where the compiler and the C library are those of the record: instructions that only some processors
have are kept out of the library's choice. Elsewhere the same workloads are held to 40 %: clang 19 took
from 45 % less to 3 % more than gcc 12, while a lost index or a search among too many discs costs several times as much.
"""
import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SAME, OTHER = 0.10, 0.40
HINT = 0.20
HEADER = ["environment", "workload", "instructions"]
# The C library picks its functions by the processor; these would make the counts depend on it.
PLAIN_PROCESSOR = "glibc.cpu.hwcaps=" + ",".join(
    "-" + name for name in ("AVX", "AVX2", "AVX512F", "AVX512VL", "AVX512BW", "FMA", "FMA4", "BMI2", "ERMS", "FSRM", "MOVBE", "LZCNT", "RTM"))


def environment(program):
    return subprocess.run([program, "--environment"], check=True, capture_output=True, text=True).stdout.strip()


def counts(program, scenes):
    """Instructions of each workload, in their order."""
    with tempfile.TemporaryDirectory() as folder:
        line = ["valgrind", "--tool=callgrind", "--instr-atstart=no", f"--callgrind-out-file={folder}/out", program, scenes]
        done = subprocess.run(line, capture_output=True, text=True, env=dict(os.environ, GLIBC_TUNABLES=PLAIN_PROCESSOR))
        if done.returncode != 0:
            raise SystemExit(f"gates: {program} failed under callgrind:\n{done.stderr}")
        dumps = sorted(pathlib.Path(folder).glob("out.*"), key=lambda p: int(p.suffix[1:]))
        found = {}
        for dump in dumps:
            text = dump.read_text(encoding="utf-8")
            name = re.search(r"^desc: Trigger: Client Request: (\S+)", text, re.M)
            total = re.search(r"^(?:summary|totals): (\d+)", text, re.M)
            if name and total:
                found[name[1]] = int(total[1])
    if not found:
        raise SystemExit("gates: callgrind counted nothing")
    return found


def read_record(path):
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    return rows[0]["environment"], {row["workload"]: int(row["instructions"]) for row in rows}


def write_record(path, where, found):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        writer.writerows([where, name, count] for name, count in found.items())


def judge(name, count, recorded, limit):
    """The line to print, and whether all is well."""
    if recorded is None:
        return f"not ok gate {name}: {count} instructions, and no record; `make gates-record` makes one", False
    change = count / recorded - 1
    told = f"{count} instructions, recorded {recorded}, {100 * change:+.1f} %"
    if change > limit:
        return (f"not ok gate {name}: {told}: over the {100 * limit:.0f} % that are allowed. "
                "Make it faster, or, if the price is meant to be paid, record it by `make gates-record`"), False
    if change < -HINT:
        told += "; `make gates-record` holds on to that"
    return f"ok gate {name}: {told}", True


def check(found, where, record):
    recorded_where, recorded = read_record(record)
    limit = SAME if where == recorded_where else OTHER
    if limit == OTHER:
        print(f"# {where}, not {recorded_where} as recorded: counts may differ by {100 * OTHER:.0f} %")
    verdicts = [judge(name, count, recorded.get(name), limit) for name, count in found.items()]
    verdicts += [(f"not ok gate {name}: recorded, but not run", False) for name in recorded if name not in found]
    for line, _ in verdicts:
        print(line)
    return all(fine for _, fine in verdicts)


def main():
    what, program, record, scenes = sys.argv[1:]
    where, found = environment(program), counts(program, scenes)
    if what == "record":
        write_record(record, where, found)
        print(f"{record}: {len(found)} workloads, {sum(found.values())} instructions; {where}")
        return 0
    return 0 if check(found, where, record) else 1


if __name__ == "__main__":
    sys.exit(main())
