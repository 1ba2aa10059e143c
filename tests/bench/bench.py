#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measure the library and write docs/results.md, its CSV files and its pictures. Python's standard library, and gnuplot for the pictures.

    bench.py --build build [--only SECTION ...] [--short] [--render] [--scenes DIRECTORY] [--peers DIRECTORY] [--docs docs]

Sections are measured one after the other, each program alone, so that the times mean something. What a section found goes to
DOCS/results/*.csv; the page and the pictures are made from all the CSV files there, also those of earlier runs: each section names the machine
and the day that it was measured on. --short is for trying the bench itself: small worlds, few repeats. --render measures nothing.
"""
import argparse
import importlib
import pathlib
import sys

import report
from common import MACHINE_HEADER, Run, machine, note, read_csv, today, write_csv

SECTIONS = ("peers", "scaling", "epsilon", "envelope", "lookup", "real")


def measure_section(run, name, folder):
    section = importlib.import_module("section_" + name)
    found = section.measure(run)
    for table, rows in found.items():
        write_csv(folder / f"{table}.csv", section.HEADERS[table], rows)
    return bool(found)


def record_machine(folder, names):
    path = folder / "machine.csv"
    rows = [row for row in read_csv(path) if row["section"] not in names]
    rows += [{"section": name, "machine": machine(), "date": today()} for name in names]
    write_csv(path, MACHINE_HEADER, sorted(rows, key=lambda row: SECTIONS.index(row["section"])))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", required=True)
    parser.add_argument("--only", nargs="*", choices=SECTIONS, default=SECTIONS)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--render", action="store_true")
    parser.add_argument("--scenes", default="../shared/data/scenes")
    parser.add_argument("--peers", default="../shared/peers")
    parser.add_argument("--limit", type=float, default=30, help="seconds a command may take")
    parser.add_argument("--docs", type=pathlib.Path, default=pathlib.Path("docs"))
    options = parser.parse_args()
    folder = options.docs / "results"
    folder.mkdir(parents=True, exist_ok=True)
    if not options.render:
        run = Run(options)
        for name in SECTIONS:
            if name in options.only and measure_section(run, name, folder):
                record_machine(folder, [name])
    report.write(options.docs)
    note(f"wrote {options.docs / 'results.md'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
