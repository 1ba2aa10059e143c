#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Prove by Frama-C's Eva that no input up to a length leads the readers of tables and matrices into undefined behaviour. Python's standard library only.

    prove.py OUT LENGTHS [--matrices] [--machine M]... [--jobs N]    LENGTHS: "0-400" or "96,400"; prints "ok ..." or "not ok ..." lines
    prove.py OUT --self-test                                         that each of BROKEN, a reader with one check less, raises an alarm

Each length is an analysis of opening a table, and another of opening it again and of all questions to it (tests/proof/table.c); or one of matrices
(tests/proof/matrix.c). One holds when Eva finished, raised no alarm and left no property unknown or invalid. Beside it stands how much was reached.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# Questions are put to what the last of each accepts. What tdsp_table_reopen() leaves unchecked is to be kept inside as it is read.
TABLES = ["tdsp_table_open", "tdsp_table_reopen"]
MATRICES = ["tdsp_matrix_open"]

# ---------------------------------------------------------------------------------------------------------------------------------------- tables
SOURCES = ["src/base/hash.c", "src/base/status.c", "src/base/text.c", "src/geom/path.c"]
# One case of the number of rows is followed at a time; statuses are kept apart from success, since only success has results.
SPLIT = ["tdsp_table_open", "tdsp_table_reopen", "table_open_into", "open_lengths", "open_checksums", "arrival_find_outside", "tdsp_table_find", "path_span_at", "tdsp_table_path"]
SPLIT_BOTH = ["open_section", "open_sections", "open_view_placed", "open_counts_are_good"]
STATES = {"all_tables": 300, "open_sections": 100, "open_counts_are_good": 40, "table_open_into": 40, "text_utf8_length": 40, "tdsp_table_open": 20,
          "tdsp_table_reopen": 20, "open_lengths": 20, "open_checksums": 20, "arrival_find_outside": 20, "open_section": 20, "text_is_utf8": 20, "check_unit": 20,
          "open_view_placed": 10, "open_and_ask": 10, "tdsp_table_find": 8, "path_span_at": 8, "arrival_search": 8, "tdsp_table_leg": 8,
          "tdsp_table_position": 4, "tdsp_table_path": 4}

# -------------------------------------------------------------------------------------------------------------------------------------- matrices
MATRIX = "src/table/matrix.c"
MATRIX_SOURCES = ["src/base/hash.c", "src/base/text.c"]
MATRIX_SPLIT = ["tdsp_matrix_open", "tdsp_matrix_source", "tdsp_matrix_destination", "matrix_lengths", "matrix_checksums"]
MATRIX_SPLIT_BOTH = ["matrix_pad", "matrix_section", "matrix_sections", "matrix_counts_are_good", "matrix_ends_are_good", "text_length_by_first:2:3"]
MATRIX_STATES = {"text_utf8_length": 40, "main": 20, "tdsp_matrix_open": 20, "matrix_lengths": 20, "matrix_checksums": 20, "matrix_sections": 20, "matrix_section": 20,
                 "matrix_pad": 20, "matrix_counts_are_good": 20, "matrix_ends_are_good": 20, "text_length_by_first": 20, "tdsp_matrix_source": 5,
                 "tdsp_matrix_destination": 5, "tdsp_matrix_table": 5, "matrix_end": 5, "matrix_pair_is_good": 5, "open_any": 5}
# What lies from one place to another is inside when both are, in this order; Eva sees that where it follows each first place by itself. It is told so in a
# copy of the reader, before these words; nothing is assumed there: what it is to assert it has to prove.
HINTS = [("if (offset != *cursor ||", "split *cursor;"), ("if (length > matrix->length", "split offset;"), ("if (next < at || next > matrix->", "split at;"),
         ("out.name = ", "assert at <= next <= matrix->length;")]


def options(split, split_both, states):
    return ["-eva", "-eva-precision", "0", "-eva-print-callstacks", "-eva-split-limit", "4096", "-eva-split-return-function",
            ",".join([name + ":0" for name in split] + [name + ":0:1" for name in split_both]),
            "-eva-slevel-function", ",".join(f"{name}:{count}" for name, count in states.items()),
            # Infinities and NaN are values like others; a pointer outside its object is an alarm even where nobody reads through it.
            "-warn-special-float", "none", "-warn-invalid-pointer"]


# Off by one, or left out: (what, file, what stands there, what stands there instead, a length that shows it, what opens).
BROKEN = [
    ("sections that are not held against the length", "src/table/open.c", "if (size > length || at > length - size) return 0;", "", 344, TABLES[0]),
    ("a row after the last", "src/query/row.c", "row >= table->rows", "row > table->rows", 344, TABLES[1]),
    ("a guide's entry that is not kept inside", "src/table/guide.h", "count >= table->length", "count > table->length", 344, TABLES[1]),
    ("a waypoint that is not kept inside", "src/table/read.h", "at <= table->length - size ? at : 0", "at <= table->length - size + 1 ? at : 0", 344, TABLES[0]),
    ("a time that has no cell", "src/table/guide.h", "place == place && ", "", 344, TABLES[1]),
    ("a row without its guard in a search", "src/query/arrival.c", "start >= table->rows || ", "", 344, TABLES[1]),
    ("a header that is read before its length is known", "src/table/open.c", "length < FORMAT_HEADER_LENGTH || ", "", 20, TABLES[0]),
    ("a table that is opened again without its places", "src/table/open.c",
     "if (!open_view_placed(&view, bytes, length, header)) return TDSP_BAD_TABLE;", "open_view_placed(&view, bytes, length, header);", 344, TABLES[1]),
    ("a matrix's header that is read before its length is known", MATRIX, "length < MATRIX_HEADER_LENGTH || ", "", 20, MATRICES[0]),
    ("a matrix's header that ends behind the bytes", MATRIX, " && *header <= length", "", 96, MATRICES[0]),
    ("sections that end behind a matrix", MATRIX, "if (next > view->length) return 0;", "", 200, MATRICES[0]),
    ("a place in a matrix that is not kept inside", MATRIX, "at <= matrix->length - size", "at <= matrix->length - size + 8", 200, MATRICES[0]),
    ("names that go on behind a matrix", MATRIX, "next < at || next > view->pairs", "next < at", 200, MATRICES[0]),
    ("a character that the end cuts off", "src/base/text.c", "at > end - length", "at > end - length + 1", 200, MATRICES[0]),
    ("a name handed out that goes on behind a matrix", MATRIX, "next > matrix->pairs) next = at", "next > matrix->length + 1) next = at", 200, MATRICES[0]),
    ("a table whose length goes round", MATRIX, "length > view->length - offset || ", "", 504, MATRICES[0]),
    ("a table that changed bytes place outside", MATRIX, "length > matrix->length - offset", "length > matrix->length", 504, MATRICES[0]),
]


# Of what is too short for a header the reader looks at fewer bytes: up to a next one of these, all lengths are proven at once, with the bytes of the shortest.
STEPS = [0, 8, 12]
HEADERS = {**dict.fromkeys(TABLES, 296), **dict.fromkeys(MATRICES, 88)}


def hinted(root, to):
    """Put the matrix reader with its HINTS into the folder `to`."""
    text = (root / MATRIX).read_text()
    for words, hint in HINTS:
        if text.count(words) != 1:
            raise ValueError(f"{MATRIX} has not once: {words}")
        text = text.replace(words, f"/*@ {hint} */ {words}")
    (to / "matrix.c").write_text(text)


def table_program(root):
    sources = [root / s for s in SOURCES] + sorted(p for p in [*root.glob("src/table/*.c"), *root.glob("src/query/*.c")] if p.name != "matrix.c")
    return [*options(SPLIT, SPLIT_BOTH, STATES), ROOT / "tests/proof/table.c", ROOT / "tests/proof/mathematics.c", *sources]


def matrix_program(root, out):
    sources = [root / s for s in MATRIX_SOURCES]
    return [*options(MATRIX_SPLIT, MATRIX_SPLIT_BOTH, MATRIX_STATES), ROOT / "tests/proof/matrix.c", out.resolve() / "matrix.c", *sources]


def analyse(root, out, lengths, machine, opened):
    """Eva's report on the reader in `root`, asked about what has any of these lengths, first and last, and the function `opened` accepts."""
    # Absolute paths: Frama-C takes relative ones from PWD, the preprocessor takes them from the working directory.
    root = root.resolve()
    program = matrix_program(root, out) if opened in MATRICES else table_program(root)
    include = f"-I{root}/include -I{root}/src -I{ROOT}/tests -DLENGTH={lengths[0]} -DLONGEST={lengths[1]} -DOPEN={opened} -DASK={int(opened == TABLES[1])} -DBATCH_MIN_ROWS=2u"
    line = ["frama-c", "-machdep", machine, "-cpp-extra-args=" + include, *map(str, program)]
    return subprocess.run(line, capture_output=True, text=True)


def problems(done):
    """What speaks against it; how many statements of the functions it entered were reached, and out of how many."""
    found = [line for line in done.stdout.splitlines() if re.search(r"eva:alarm|\[kernel\] .*error|User Error", line)]
    if done.returncode != 0:
        found.append(f"exit status {done.returncode}: {done.stdout[-500:]}{done.stderr[-500:]}")
    if "0 alarms generated by the analysis" not in done.stdout:
        found.append("not without alarms")
    for row in re.findall(r"^ +(?:Assertions|Preconditions) .*$", done.stdout, re.M):
        if not re.search(r" 0 unknown +0 invalid", row):
            found.append("not all proven:" + row)
    reached = re.search(r"(\d+) statements reached \(out of (\d+)\)", done.stdout)
    if not reached:
        found.append("no summary")
    return found, tuple(map(int, reached.groups())) if reached else (0, 0)


def named(lengths):
    return f"{lengths[0]}" if lengths[0] == lengths[1] else f"{lengths[0]} to {lengths[1]}"


def prove(out, lengths, machine, opened):
    begin = time.monotonic()
    done = analyse(ROOT, out, lengths, machine, opened)
    found, (reached, total) = problems(done)
    (out / f"{machine}-{opened}-{named(lengths).replace(' ', '-')}.log").write_text(done.stdout + done.stderr)
    return lengths, found, reached, total, time.monotonic() - begin


def lengths_of(text):
    first, _, last = text.partition("-")
    return list(range(int(first), int(last) + 1)) if last else [int(x) for x in text.split(",")]


def together(lengths, header):
    """The lengths as pairs of first and last: neighbours that no step parts, if they are too short for a header."""
    spans = []
    for n in sorted(lengths):
        if spans and n < header and n == spans[-1][1] + 1 and n not in STEPS:
            spans[-1] = (spans[-1][0], n)
        else:
            spans.append((n, n))
    return spans


def prove_all(out, lengths, machines, jobs, opening):
    failed = 0
    hinted(ROOT, out)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        work = [(m, o, pool.submit(prove, out, n, m, o)) for m in machines for n in reversed(together(lengths, HEADERS[opening[0]])) for o in opening]
        for machine, opened, future in work:
            span, found, reached, total, seconds = future.result()
            failed += bool(found)
            print(f"{'not ok' if found else 'ok'} {machine}: {named(span)} bytes by {opened}(), {reached} of {total} statements, {seconds:.0f} s", flush=True)
            for line in found[:5]:
                print("    " + line)
    return failed


def self_test(out):
    """Each broken reader must raise an alarm, and the right place must have been broken."""
    failed = 0
    for what, path, right, wrong, length, opened in BROKEN:
        root = out / "broken"
        shutil.rmtree(root, ignore_errors=True)
        for folder in ("src", "include"):
            shutil.copytree(ROOT / folder, root / folder)
        text = (root / path).read_text()
        (root / path).write_text(text.replace(right, wrong, 1))
        hinted(root, root)
        done = analyse(root, root, (length, length), "x86_64", opened) if right in text else None
        seen = bool(done) and "eva:alarm" in done.stdout
        failed += not seen
        print(f"{'ok' if seen else 'not ok'} the proof sees {what}", flush=True)
    return failed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("lengths", type=lengths_of, nargs="?")
    parser.add_argument("--matrices", action="store_true")
    parser.add_argument("--machine", action="append")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--self-test", action="store_true")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    if args.self_test:
        return self_test(args.out) != 0
    return prove_all(args.out, args.lengths, args.machine or ["x86_64"], args.jobs, MATRICES if args.matrices else TABLES) != 0


if __name__ == "__main__":
    sys.exit(main())
