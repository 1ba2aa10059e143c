#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Print a public header as Doxygen wants it (its INPUT_FILTER).

    header.py HEADER

The headers are written for who reads them; their conventions are told to Doxygen here. The comment below the licence is about the file. A comment behind
a declaration, or alone above a value or member, is about it. A structure whose comment says that its members are private has none here. Declarations that follow each other without an empty line share the comment above the first.
Lines stay where they are, so that warnings name the right ones.
"""
import pathlib
import re
import sys

COMMENT = re.compile(r"/\*.*?\*/", re.S)
SHARED = re.compile(r"(?P<comment>/\*\*(?:(?!\*/).)*\*/)\n(?P<first>(?:TDSP_API|typedef)\b[^;{]*;)\n(?=(?P<rest>(?:(?:TDSP_API|typedef)\b[^;{]*;\n)+))", re.S)

PRIVATE = re.compile(r"(/\*\*(?:(?!\*/).)*\b[Pp]rivate\b(?:(?!\*/).)*\*/\ntypedef struct \w+ \{)([^}]*)\}", re.S)

# What follows a comment that is over several members: one with a comment of its own.
HEADING = re.compile(r"\n[ ]+[^/\n]*[;,] *(?://|/\*)")


def without_private(text):
    return PRIVATE.sub(lambda match: match[1] + re.sub(r"[^\n]", "", match[2]) + "}", text)


def documented(text):
    """Plain comments as Doxygen's: behind code `/**<`, alone on their lines `/**`."""
    def mark(match):
        comment, line = match[0], text[text.rfind("\n", 0, match.start()) + 1:match.start()]
        if comment.startswith("/**") or (not line.strip() and HEADING.match(text, match.end())):
            return comment
        return ("/**<" if line.strip() else "/**") + comment[2:]
    return COMMENT.sub(mark, text)


def shared(text):
    """The comment above the first of several declarations, repeated in front of each; without its line ends, which stay the same in number."""
    def repeat(match):
        again = re.sub(r"\n \*(?!/) ?", " ", match["comment"]).replace("\n", "")
        return f"{match['comment']}\n{match['first']} {again}\n"
    while True:
        done = SHARED.sub(repeat, text, count=1)
        if done == text:
            return text
        text = done


def main():
    path = pathlib.Path(sys.argv[1])
    text = path.read_text(encoding="utf-8")
    _, _, rest = text.partition("\n")
    opened = f"/** @file tdsp/{path.name}\n" + rest.replace("/*", " *", 1)
    print(shared(documented(without_private(opened))), end="")


if __name__ == "__main__":
    main()
