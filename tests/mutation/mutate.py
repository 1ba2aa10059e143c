#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Take each condition of the freestanding line always, and never, and see whether a unit test notices.

    mutate.py --build DIRECTORY [--jobs N] [--sample N] [--only PATTERN] PROGRAM...

Each conditional instruction of layers 0 to 2 makes two mutants. A mutant is killed when a test program that reaches the
condition fails, crashes or takes more than four times as long as it does. Those that no test can kill, because the change makes no
difference, are listed with the reason in equivalent.csv; any other survivor fails, and so does a row of the list that is
killed or no longer there. A condition is named by file, function, the text of its line and its number among the
conditions of that text there: not by its line. Results are kept: a mutant that died is
not run again while its file and the test that saw it are the same.

The numbers belong to a compiler, which the list names. With another one the same mutants are tried, and 9 in 10 must die.
"""
import argparse
import collections
import concurrent.futures
import csv
import functools
import hashlib
import json
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from program import ROOT, Program  # noqa: E402

LISTED = pathlib.Path(__file__).resolve().parent / "equivalent.csv"
ELSEWHERE = 0.9
PROGRAMS = {}

Mutant = collections.namedtuple("Mutant", "file function text condition taken")


def mutants(programs):
    """(file, function, number) and whether always, by mutant."""
    lines = {}
    for program in programs:
        for key, site in program.sites.items():
            if lines.setdefault(key, (site.line, site.mnemonic)) != (site.line, site.mnemonic):
                raise SystemExit(f"mutation: {key[1]}() of {key[0]} is not the same in all programs")
    texts = {file: (ROOT / file).read_text(encoding="utf-8").split("\n") for file in {key[0] for key in lines}}
    met, found = collections.Counter(), {}
    for key, (line, mnemonic) in sorted(lines.items()):
        text = " ".join(texts[key[0]][line - 1].split())
        met[key[:2], text] += 1
        for taken in ("always", "never"):
            found[Mutant(key[0], key[1], text, f"{met[key[:2], text]} {mnemonic}", taken)] = (key, taken == "always")
    return found


def start(paths, build):
    for path in paths:
        program = Program(path, build, pathlib.Path(build) / "hits")
        PROGRAMS[program.name] = program


def attempt(names, key, always):
    """(program, how) of the first that kills; (None, why not) otherwise."""
    for name in names:
        how = PROGRAMS[name].kills(key, always)
        if how:
            return name, how
    return None, "survives" if names else "no test gets there"


class Results:
    """
    What came out, one line of JSON each. A death counts as long as the mutant's file and the test that saw it are the same, a survival as long as
    all programs are.
    """

    def __init__(self, build):
        self.path = pathlib.Path(build) / "results.jsonl"
        rows = self.path.read_text().splitlines() if self.path.exists() else []
        self.known = {Mutant(*row["mutant"]): row for row in map(json.loads, rows)}

    def get(self, mutant, names):
        row = self.known.get(mutant)
        if not row:
            return None
        return (row["by"], row["how"]) if row["digest"] == basis(mutant, row["by"], names) else None

    def put(self, mutant, names, result):
        with self.path.open("a") as file:
            file.write(json.dumps({"mutant": mutant, "by": result[0], "how": result[1], "digest": basis(mutant, result[0], names)}) + "\n")


@functools.lru_cache(maxsize=None)
def text_of(path):
    return (ROOT / path).read_bytes()


def basis(mutant, by, names):
    """A digest of what a result rests on."""
    rests = text_of(mutant.file) + text_of(f"tests/unit/{by}.c") if by else " ".join(sorted(PROGRAMS[name].digest for name in names)).encode()
    return hashlib.sha256(rests).hexdigest()[:16]


def order(key, first):
    """The programs that reach a condition: the one that killed it before, then the cheapest."""
    reach = [name for name, program in PROGRAMS.items() if key in program.reached]
    return sorted(reach, key=lambda name: (name != first, PROGRAMS[name].seconds))


def run(chosen, paths, build, jobs):
    """(program, how) by mutant."""
    results = Results(build)
    done, waiting = {}, {}
    with concurrent.futures.ProcessPoolExecutor(jobs, initializer=start, initargs=(paths, build)) as pool:
        for mutant, (key, always) in chosen.items():
            row = results.known.get(mutant)
            names = order(key, row and row["by"])
            known = results.get(mutant, names)
            if known:
                done[mutant] = known
            else:
                waiting[pool.submit(attempt, names, key, always)] = mutant, names
        for future in concurrent.futures.as_completed(waiting):
            mutant, names = waiting[future]
            done[mutant] = future.result()
            results.put(mutant, names, done[mutant])
    return done


def listed():
    """The compiler that the list belongs to, and its rows."""
    with LISTED.open(encoding="utf-8", newline="") as file:
        compiler = file.readline().strip("# \n")
        return compiler, {Mutant(row["file"], row["function"], row["text"], row["condition"], row["taken"]): row["reason"] for row in csv.DictReader(file)}


def describe(mutant):
    return f"{mutant.file}: {mutant.function}: {mutant.text!r}, condition {mutant.condition}, {mutant.taken} taken"


def verdict(fine, text, problems=()):
    print(f"{'ok' if fine else 'not ok'} mutation {text}")
    for problem in problems:
        print(f"    {problem}")
    return fine


def judge(done, everything, equivalent, whole):
    survivors = [m for m, (by, _) in done.items() if not by]
    fine = verdict(not set(survivors) - set(equivalent), "each mutant is killed or listed as equivalent",
                   [f"{describe(m)}: {done[m][1]}" for m in survivors if m not in equivalent])
    if whole:
        stale = [m for m in equivalent if m not in everything or (m in done and done[m][0])]
        fine &= verdict(not stale, "what is listed as equivalent exists and survives", map(describe, stale))
    mute = [m for m, reason in equivalent.items() if not reason.strip()]
    return verdict(not mute, "each row of the list has a reason", map(describe, mute)) and fine


def judge_elsewhere(done, compiler):
    dead = sum(by is not None for by, _ in done.values())
    return verdict(dead >= ELSEWHERE * len(done), f"{dead} of {len(done)} die; which are equivalent is known for {compiler} only")


def sample(everything, equivalent, count):
    """Some that must die: always the same, and from everywhere."""
    mortal = [m for m in everything if m not in equivalent]
    mortal.sort(key=lambda m: hashlib.sha256("\t".join(m).encode()).digest())
    return {m: everything[m] for m in mortal[:count]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--build", required=True)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--sample", type=int, help="that many mutants that are not listed as equivalent")
    parser.add_argument("--only", help="mutants whose file and function match this")
    parser.add_argument("programs", nargs="+")
    asked = parser.parse_args()
    start(asked.programs, asked.build)
    compiler, equivalent = listed()
    everything = mutants(PROGRAMS.values())
    chosen = {m: at for m, at in everything.items() if re.search(asked.only or "", f"{m.file} {m.function}")}
    if asked.sample:
        chosen = sample(chosen, equivalent, asked.sample)
    done = run(chosen, asked.programs, asked.build, asked.jobs)
    how = collections.Counter(how for by, how in done.values() if by)
    print(f"# {len(done)} mutants: {sum(how.values())} killed ({', '.join(f'{n} {what}' for what, n in how.most_common())}), {len(done) - sum(how.values())} survive")
    here = subprocess.run(["gcc", "-dumpfullversion"], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
    if f"gcc {here}" != compiler:
        return 0 if judge_elsewhere(done, compiler) else 1
    return 0 if judge(done, everything, equivalent, not asked.sample and not asked.only) else 1


if __name__ == "__main__":
    sys.exit(main())
