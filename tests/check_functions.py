#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Check the size of functions and files: no function over 60 lines without a reason, no file over 500.

A reason is a comment right above the function (or in it) that says "long:" and why, e.g. "long: one case for each status".
Prints the median and the 90th percentile of the library too, so that drift is seen before it hurts.
"""
import pathlib
import re
import sys

MAX_FUNCTION = 60
MAX_FILE = 500
ROOT = pathlib.Path(__file__).resolve().parent.parent

NOISE = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'", re.S)
NAME = re.compile(r"(\w+)\s*\($")


def blank(match):
    return re.sub(r"[^\n]", " ", match[0])


def header_of(code, brace):
    """Start and text of what stands before an opening brace at file level, back to the last ; or } or directive."""
    start = max(code.rfind(end, 0, brace) for end in ";}") + 1
    directives = [m.end() for m in re.finditer(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*\n", code[start:brace], re.M)]
    start += directives[-1] if directives else 0
    return start, code[start:brace]


def functions(text):
    """(name, first line, last line) of each function body at file level."""
    code = NOISE.sub(blank, text)
    depth, opened = 0, None
    for at, char in enumerate(code):
        if char == "{":
            if depth == 0:
                start, head = header_of(code, at)
                # A body follows a parameter list; an initialiser follows '=', a type follows its name.
                name = re.search(r"(\w+)\s*\(", head)
                opened = (name[1], start + len(head) - len(head.lstrip())) if name and head.rstrip().endswith(")") else None
            if not (depth == 0 and re.search(r'extern\s*"?\s*"?\s*$', code[:at])):
                depth += 1
        elif char == "}" and depth:
            depth -= 1
            if depth == 0 and opened:
                first = code.count("\n", 0, opened[1]) + 1
                yield opened[0], first, code.count("\n", 0, at) + 1
                opened = None


def excused(lines, first, last):
    above = first - 2
    while above >= 0 and re.match(r"\s*(/\*|\*|//)", lines[above]) or above >= 0 and lines[above].rstrip().endswith("*/"):
        above -= 1
    return re.search(r"\blong: \w", "\n".join(lines[above + 1:last])) is not None


def check(path):
    text = path.read_text(encoding="utf-8")
    lines = text.split("\n")
    sizes = [(name, last - first + 1, first, last) for name, first, last in functions(text)]
    wrong = [f"{name}() has {size} lines" for name, size, first, last in sizes
             if size > MAX_FUNCTION and not excused(lines, first, last)]
    if len(lines) - 1 > MAX_FILE:
        wrong.append(f"the file has {len(lines) - 1} lines")
    return [size for _, size, _, _ in sizes], wrong


def main():
    library, failed = [], False
    paths = [p for folder in ("src", "tools", "tests", "examples") for p in sorted((ROOT / folder).rglob("*.[ch]"))]
    for path in paths:
        sizes, wrong = check(path)
        if path.is_relative_to(ROOT / "src"):
            library += sizes
        failed = failed or bool(wrong)
        name = path.relative_to(ROOT)
        print(f"not ok size {name}: {'; '.join(wrong)}" if wrong else f"ok size {name}")
    if library:
        library.sort()
        print(f"# functions of the library: {len(library)}, median {library[len(library) // 2]} lines, "
              f"p90 {library[len(library) * 9 // 10]}, longest {library[-1]}")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
