#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Coverage by layer, and its judgement.

    report.py --profiles DIRECTORY [--strict-only] [--list] OBJECT...

The freestanding line (layers 0 to 2) must be whole: every outcome of every branch, and every condition shown to decide by
itself. Elsewhere at least 95 % of each folder's outcomes must be seen, and each one that is not is listed with its reason
in uncovered.csv. The list names file, function, condition and outcome, not lines; a row of it that is covered, or that no
longer exists, fails too, so that the list stays true. Prints "ok" and "not ok" lines after the table.
"""
import argparse
import collections
import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import measured  # noqa: E402

LISTED = pathlib.Path(__file__).resolve().parent / "uncovered.csv"
# In the order of the layers. The first four are the freestanding line.
STRICT = ["src/base", "src/geom", "src/table", "src/query"]
LAYERS = STRICT + ["src/scene", "src/growth", "src/search", "src/build", "src/oracle", "src/shape", "src/verify", "src/margin", "tools/tdsp"]
LEAST = 0.95


class Folder:
    def __init__(self):
        self.lines, self.outcomes, self.conditions = [0, 0], [0, 0], [0, 0]
        self.missed = []  # (file, function, condition, outcome)
        self.undecided = []  # (file, function, decision, condition)
        self.unjudged = []  # (file, function, condition)


def folders(sources):
    found = {name: Folder() for name in LAYERS}
    for path, source in sorted(sources.items()):
        folder = found[path.rpartition("/")[0]]
        folder.lines[0] += sum(count > 0 for count in source.lines.values())
        folder.lines[1] += len(source.lines)
        for place, branch in sorted(source.branches.items()):
            if source.unjudged(place):
                folder.unjudged.append((path, branch.function, branch.text))
            for outcome, count in branch.outcomes():
                folder.outcomes[0] += count > 0
                folder.outcomes[1] += 1
                if not count:
                    folder.missed.append((path, branch.function, branch.text, outcome))
        for place, decision in sorted(source.decisions.items()):
            folder.conditions[0] += sum(decision.shown)
            folder.conditions[1] += len(decision.shown)
            texts = source.conditions(place)
            folder.undecided += [(path, decision.function, decision.text, text) for text, shown in zip(texts, decision.shown) if not shown]
    return found


def share(pair):
    return f"{pair[0]:6d} /{pair[1]:6d} {100 * pair[0] / pair[1] if pair[1] else 100:7.2f} %"


def table(found):
    print(f"{'':12s} {'lines':>24s} {'branches':>24s} {'MC/DC':>24s}")
    for name, folder in found.items():
        print(f"{name:12s} {share(folder.lines):>24s} {share(folder.outcomes):>24s} {share(folder.conditions):>24s}")


def listed():
    with LISTED.open(encoding="utf-8", newline="") as file:
        return [(row["file"], row["function"], row["condition"], row["outcome"], row["reason"]) for row in csv.DictReader(file)]


def verdict(fine, text, problems=()):
    print(f"{'ok' if fine else 'not ok'} coverage {text}")
    for problem in problems:
        print(f"    {problem}")
    return fine


def judge_strict(name, folder):
    problems = [f"{file}: {function}: {condition!r} is never {outcome}" for file, function, condition, outcome in folder.missed]
    seen = {(file, function, condition) for file, function, condition, _ in folder.missed}
    problems += [f"{file}: {function}: {condition!r} never decides {decision!r} by itself"
                 for file, function, decision, condition in folder.undecided if (file, function, condition) not in seen]
    problems += [f"{file}: {function}: {condition!r} stands in a decision inside another, which clang cannot judge" for file, function, condition in folder.unjudged]
    return verdict(not problems, f"{name}: every branch and every condition", problems)


def judge_share(name, folder):
    reached = folder.outcomes[0] >= LEAST * folder.outcomes[1]
    return verdict(reached, f"{name}: at least {LEAST:.0%} of the branches")


def judge_list(found):
    """The list and what was missed are the same, as often as each occurs."""
    missed = collections.Counter(row for name, folder in found.items() if name not in STRICT for row in folder.missed)
    rows = listed()
    known = collections.Counter(row[:4] for row in rows)
    describe = "{0}: {1}: {2!r} is never {3}".format
    unlisted = [describe(*row) for row in (missed - known).elements()]
    stale = [describe(*row) for row in (known - missed).elements()]
    mute = [describe(*row) for row in rows if not row[4].strip()]
    fine = verdict(not unlisted, "what is not covered is listed with its reason", unlisted)
    fine &= verdict(not stale, "what is listed exists and is not covered", stale)
    return verdict(not mute, "each row of the list has a reason", mute) and fine


def write_list(found):
    """What was missed, as rows for the list, with the reason still to be given."""
    rows = csv.writer(sys.stdout, lineterminator="\n")
    rows.writerow(["file", "function", "condition", "outcome", "reason"])
    reasons = {row[:4]: row[4] for row in listed()}
    for name, folder in found.items():
        if name not in STRICT:
            rows.writerows((*row, reasons.get(row, "")) for row in folder.missed)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--profiles", required=True)
    parser.add_argument("--strict-only", action="store_true", help="judge the freestanding line only")
    parser.add_argument("--list", action="store_true", help="print what is not covered as rows for uncovered.csv, and judge nothing")
    parser.add_argument("objects", nargs="+")
    asked = parser.parse_args()
    profile = pathlib.Path(asked.profiles) / "all.profdata"
    measured.merge(asked.profiles, profile)
    found = folders(measured.measure(profile, asked.objects))
    if asked.list:
        write_list(found)
        return 0
    if asked.strict_only:
        found = {name: found[name] for name in STRICT}
    table(found)
    fine = all([judge_strict(name, found[name]) if name in STRICT else judge_share(name, found[name]) for name in found])
    if not asked.strict_only:
        fine &= judge_list(found)
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
