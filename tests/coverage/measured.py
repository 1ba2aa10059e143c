# SPDX-License-Identifier: MIT
"""What clang's coverage says of the sources, with the instantiations of an inline function taken together.

An inline function of a header is compiled into each file that includes it, and each of these has counts of its own; it is
covered when all of them together cover it. Places are therefore keyed by file, line and column, and counts added up. The
conditions of a macro stand where the macro is defined, and count once for all its uses, for the same reason.
"""
import collections
import json
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
# What clang counts as a branch without anything to decide: labels of a switch are taken or not, constants are folded.
LABEL = re.compile(r"(case\b|default\b)")
# GLib's g_new() asks whether its number is known to the compiler.
CONSTANT = re.compile(r"\(*(0|1|true|false)\)*|g_new0?(\(.*\))?")

JOINED = 6  # clang's kind of region for a condition of a decision


class Branch:
    """A condition that decides, with the outcomes seen."""

    def __init__(self, function, text, joined):
        self.function, self.text, self.taken, self.refused = function, text, 0, 0
        self.label = LABEL.match(text) is not None
        self.joined = joined  # part of a decision

    def outcomes(self):
        """(outcome, how often) of each that there is."""
        return [("taken", self.taken)] if self.label else [("true", self.taken), ("false", self.refused)]


class Decision:
    """An expression of several conditions, with those that were shown to decide it by themselves."""

    def __init__(self, function, text, size):
        self.function, self.text, self.shown = function, text, [False] * size


class Source:
    """One file: how many lines run and how many can, its branches and its decisions by place."""

    def __init__(self, path):
        self.text = path.read_text(encoding="utf-8").split("\n")
        self.lines = {}
        self.branches, self.decisions = {}, {}

    def excerpt(self, first, column, last, end):
        """The source between two places, its white space made single; of a macro, for which clang gives no end, the word and its arguments."""
        if (first, column) == (last, end):
            return re.match(r"\w*(\([^()]*\))?", self.text[first - 1][column - 1:])[0]
        lines = self.text[first - 1:last]
        lines[-1] = lines[-1][:end - 1]
        lines[0] = lines[0][column - 1:]
        return " ".join(" ".join(lines).split())

    def unjudged(self, place):
        """Is this a condition beside && or || that clang gave up on? It does so where a decision stands inside another."""
        first, column, last, end = place
        before = (" ".join(self.text[max(first - 3, 0):first - 1]) + " " + self.text[first - 1][:column - 1]).rstrip(" \t(!")
        after = (self.text[last - 1][end - 1:] + " " + " ".join(self.text[last:last + 2])).lstrip(" \t)")
        return not self.branches[place].joined and (before.endswith(("&&", "||")) or after.startswith(("&&", "||")))

    def conditions(self, place):
        """The texts of the conditions of a decision, in their order. A decision inside one of them has none of its own to show."""
        first, end = place[:2], place[2:]
        inside = [at for at, branch in sorted(self.branches.items()) if first <= at[:2] and at[2:] <= end and branch.joined]
        return [self.branches[at].text for at in inside]


def merge(profiles, merged):
    """One profile of all those in a directory."""
    raw = sorted(pathlib.Path(profiles).glob("*.profraw"))
    if not raw:
        raise SystemExit(f"coverage: no profiles in {profiles}")
    subprocess.run(["llvm-profdata-19", "merge", "-sparse", *map(str, raw), "-o", str(merged)], check=True)


def export(profile, objects):
    """llvm-cov's account of everything in the objects."""
    command = ["llvm-cov-19", "export", f"-instr-profile={profile}", objects[0], *(f"-object={o}" for o in objects[1:])]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)["data"][0]


def relative(name):
    """The path inside the project of a file that the report is about; None for any other."""
    path = os.path.relpath(os.path.join(ROOT, name), ROOT)
    return path if path.startswith(("src/", "tools/")) else None


def add_lines(source, segments):
    """Lines that run: the highest count of the regions that begin in a line or are open at its begin."""
    inside, by_line = None, collections.defaultdict(list)
    for line, column, count, counted, begins, gap in segments:
        by_line[line].append((count if counted else None, begins and not gap))
    if not segments:
        return
    for line in range(segments[0][0], segments[-1][0] + 1):
        begun = [count for count, begins in by_line[line] if begins and count is not None]
        skipped = by_line[line] and by_line[line][0][1] and by_line[line][0][0] is None
        if not skipped and (begun or inside is not None):
            source.lines[line] = source.lines.get(line, 0) + max(begun + ([inside] if inside is not None else []))
        if by_line[line]:
            inside = by_line[line][-1][0]


def add_branches(function, name, sources):
    for first, column, last, end, taken, refused, file, _, kind in function["branches"]:
        source = sources.get(relative(function["filenames"][file]))
        if source is None:
            continue
        text = source.excerpt(first, column, last, end)
        if CONSTANT.fullmatch(text):
            continue
        branch = source.branches.setdefault((first, column, last, end), Branch(name, text, kind == JOINED))
        branch.taken += taken
        branch.refused += refused


def add_decisions(function, name, sources):
    for record in function.get("mcdc_records", []):
        first, column, last, end = record[:4]
        shown = record[-1]
        # A decision names no file of its own: it stands where its function does.
        source = sources.get(relative(function["filenames"][0]))
        if source is None:
            continue
        decision = source.decisions.setdefault((first, column, last, end), Decision(name, source.excerpt(first, column, last, end), len(shown)))
        decision.shown = [a or b for a, b in zip(decision.shown, shown)]


def measure(profile, objects):
    """Source by path inside the project."""
    data = export(profile, objects)
    sources = {}
    for file in data["files"]:
        path = relative(file["filename"])
        if path:
            sources[path] = Source(ROOT / path)
            add_lines(sources[path], file["segments"])
    for function in data["functions"]:
        name = re.split(r"[:;]", function["name"])[-1]
        add_branches(function, name, sources)
        add_decisions(function, name, sources)
    return sources
