#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The reader in one file: write tdsp_query.c and tdsp_query.h, which need nothing else of libtdsp.

    amalgamate.py VERSION OUTPUT_DIRECTORY

The header is the reader's public headers, one after the other. The source is what their functions need of layers 0 to 2, each file after
those it includes. Functions and tables that no public function reaches are left out, and those that are not public become static: so a
program's own names cannot meet them, and a compiler's -Wunused has nothing to say.

It rests on how the sources are laid out (.clang-format): what starts in column 0 is at file scope, and only that. What does not look so is an error here, and tests/amalgamation compares the result with libtdsp-query.a.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HEADERS = ["export.h", "status.h", "types.h", "path.h", "table.h", "matrix.h"]
LAYERS = ["base", "geom", "table", "query"]
OWN_INCLUDE = re.compile(r'#include "([^"]+)"')
SYSTEM_INCLUDE = re.compile(r"#include <[^>]+>")
FUNCTION = re.compile(r"^(?:APART )?[a-z].*?\b(\w+)\([^;]*$")
PROTOTYPE = re.compile(r"^[a-z](?!ypedef).*?\b(\w+)\(.*\);", re.S)
ARRAY = re.compile(r"^static const .*?\b(\w+)\[[^=]*\] = \{", re.S)
LICENCE = "/* SPDX-License-Identifier: MIT */\n"


class Piece:
    """Something at file scope with the comment above it; `name` is that of the function or array that it defines, `declares` of a prototype."""

    def __init__(self, lines):
        self.text = "".join(lines)
        self.code = re.sub(r"/\*.*?\*/", " ", self.text, flags=re.S).strip("\n ")
        first = self.code.split("\n{")[0].replace("\n", " ")
        defined = FUNCTION.match(first) if "\n{" in self.code else ARRAY.match(self.code)
        declared = None if defined else PROTOTYPE.match(self.code)
        self.name = defined.group(1) if defined else None
        self.declares = declared.group(1) if declared else None
        self.words = set(re.findall(r"\w+", self.code))


def ends(line, code):
    """Is a piece at file scope over with this line?"""
    if code.startswith("#"):
        return not line.endswith("\\\n")
    return code.count("{") == code.count("}") and line.rstrip().endswith((";", "}"))


def pieces(path):
    """The pieces of a file without its guard and its own includes, as (piece or included name)."""
    text = path.read_text()
    text = text.removeprefix(LICENCE)
    guard = re.search(r"#ifndef (\w+_H)\n#define \1\n", text)
    if guard:
        text = text[:guard.start()] + text[guard.end():].rstrip().removesuffix("#endif")
    found, lines, code, comment = [], [], "", False
    for line in text.splitlines(keepends=True):
        if not code and (comment or line.startswith("/*") or not line.strip()):
            comment = (comment or line.startswith("/*")) and "*/" not in line
            # A comment that stands by itself is a piece: an empty line follows.
            if not line.strip() and not comment and lines:
                found.append(Piece(lines))
                lines = []
            elif line.strip():
                lines.append(line)
            continue
        if not code and not re.match(r"[#a-z}]|APART ", line):
            sys.exit(f"{path}: what is this at file scope? {line.strip()}")
        lines.append(line)
        code += line
        if ends(line, code):
            found.append(Piece(lines))
            lines, code = [], ""
    if lines:
        found.append(Piece(lines))
    return found


def include(name, done, order, system):
    """Append the pieces of src/NAME to `order` after those of what it includes."""
    if name in done:
        return
    done.add(name)
    own = []
    for piece in pieces(ROOT / "src" / name):
        ours, other = OWN_INCLUDE.match(piece.code), SYSTEM_INCLUDE.match(piece.code)
        if other:
            system.add(other.group(0))
        elif not ours:
            own.append((name, piece))
        elif not ours.group(1).startswith("tdsp/"):
            include(ours.group(1), done, order, system)
    order.extend(own)


def reached(order, public):
    """The names of functions and arrays that public functions need."""
    needs = {piece.name: piece.words for _, piece in order if piece.name}
    # What a macro or a type mentions counts as needed.
    todo = {word for _, piece in order if not piece.name and not piece.declares for word in piece.words} | public
    found = set()
    while todo:
        name = todo.pop()
        if name in needs and name not in found:
            found.add(name)
            todo |= needs[name]
    missing = public - found
    if missing:
        sys.exit(f"amalgamate: nothing in layers 0 to 2 defines {', '.join(sorted(missing))}")
    return found


def private(piece, name):
    """The text of a piece with a function that is not public made static."""
    if name.startswith("tdsp_") or piece.code.startswith("static"):
        return piece.text
    head = piece.code.split("\n")[0]
    return piece.text.replace(head, "static " + head, 1)


def sources(public):
    """The pieces of what public functions need, in order, with the names reached, and the C library's headers."""
    names = [f"{layer}/{path.name}" for layer in LAYERS for path in sorted((ROOT / "src" / layer).glob("*.c"))]
    while True:
        done, order, system = set(), [], set()
        for name in names:
            include(name, done, order, system)
        keep = reached(order, public)
        needed = {name for name, piece in order if piece.name in keep}
        fewer = [name for name in names if name in needed]
        if fewer == names:
            return order, keep, system
        names = fewer


def header(version):
    text = []
    for name in HEADERS:
        body = (ROOT / "include" / "tdsp" / name).read_text().removeprefix(LICENCE)
        body = re.sub(r"#ifndef (TDSP_\w+_H)\n#define \1\n", "", body).rstrip().removesuffix("#endif")
        body = re.sub(r'#include "tdsp/[^"]+"\n', "", body)
        text.append(re.sub(r"\n{3,}", "\n\n", body).strip("\n"))
    return (f"{LICENCE}/*\n * libtdsp {version}, the reader of tables in one header and one source, tdsp_query.c. Made by `make amalgamation`; do not change it.\n */\n"
            "#ifndef TDSP_QUERY_H\n#define TDSP_QUERY_H\n\n" + "\n\n".join(text) + "\n\n#endif\n")


def source(version, public):
    order, keep, system = sources(public)
    out = [f"{LICENCE}/*\n * libtdsp {version}, the reader of tables in one file. Made by `make amalgamation`; do not change it.\n"
           " * It needs a C99 compiler, the C library's memory functions and mathematics, and tdsp_query.h.\n */\n"
           '#include "tdsp_query.h"\n\n' + "\n".join(sorted(system)) + "\n"]
    last = None
    for name, piece in order:
        own = piece.name or piece.declares
        if own and own not in keep:
            continue
        if name != last:
            out.append(f"/* {'-' * (112 - len(name))} src/{name} */\n")
            last = name
        out.append(private(piece, own) if own else piece.text)
    return re.sub(r"\n{3,}", "\n\n", "\n".join(out))


def main():
    version, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    public_text = header(version)
    public = set(re.findall(r"TDSP_API\b[^;(]*?\b(tdsp_\w+)\s*\(", re.sub(r"/\*.*?\*/", " ", public_text, flags=re.S)))
    for name, text in (("tdsp_query.h", public_text), ("tdsp_query.c", source(version, public))):
        part = folder / (name + ".part")
        part.write_text(text)
        part.rename(folder / name)


if __name__ == "__main__":
    main()
