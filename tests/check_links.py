#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Check the links of every Markdown file: a relative link names a file of the checkout, and an anchor a heading in it.

Links to the outside are not followed; the checks run without a network.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)[^)]*\)|<img[^>]*\bsrc=\"([^\"]+)\"")
FENCE = re.compile(r"^(```|~~~).*?^\1", re.M | re.S)


def prose(path):
    text = FENCE.sub("", path.read_text(encoding="utf-8"))
    return re.sub(r"`[^`\n]*`", "", text)


def anchors(path):
    """The anchors that GitHub and its like make from headings."""
    text = FENCE.sub("", path.read_text(encoding="utf-8"))
    seen, names = {}, set()
    for heading in re.findall(r"^#{1,6}\s+(.*?)\s*#*$", text, re.M):
        name = re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")
        count = seen.get(name, 0)
        seen[name] = count + 1
        names.add(f"{name}-{count}" if count else name)
    return names


def problem(path, link):
    if re.match(r"[a-z]+:", link):
        return None
    target, _, anchor = link.partition("#")
    file = (path.parent / target).resolve() if target else path
    if not file.exists() or not file.is_relative_to(ROOT):
        return f"{link} is not there"
    if anchor and file.suffix == ".md" and anchor not in anchors(file):
        return f"{link} names no heading"
    return None


def main():
    failed = False
    pages = [p for p in sorted(ROOT.rglob("*.md")) if not {"build", ".git"} & set(p.relative_to(ROOT).parts)]
    for path in pages:
        wrong = [w for w in (problem(path, a or b) for a, b in LINK.findall(prose(path))) if w]
        failed = failed or bool(wrong)
        name = path.relative_to(ROOT)
        print(f"not ok links {name}: {'; '.join(wrong)}" if wrong else f"ok links {name}")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
