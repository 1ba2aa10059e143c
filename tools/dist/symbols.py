#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Record the exported symbols for Debian: symbols.py VERSION

Each line of tools/debian/libtdsp0.symbols says since which version a symbol is there. A symbol that src/libtdsp.map lists anew is there since VERSION; one
that it lists no more is left out, which means another SONAME once there are users.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SYMBOLS = ROOT / "tools/debian/libtdsp0.symbols"
HEAD = "libtdsp.so.{so} libtdsp{so} #MINVER#\n* Build-Depends-Package: libtdsp-dev\n"


def exported():
    """(symbol, version node) of src/libtdsp.map, a node being a symbol as well."""
    nodes = re.findall(r"^(TDSP_[\d.]+) \{(.*?)^\}", (ROOT / "src/libtdsp.map").read_text(), re.M | re.S)
    return {(name, node) for node, body in nodes for name in re.findall(r"^\s+(tdsp_\w+);", body, re.M)} | {(node, node) for node, _ in nodes}


def recorded():
    """The same of the record, each with the version since which it is there."""
    return {(name, node): since for name, node, since in re.findall(r"^ (\w[\w.]*)@(\S+) (\S+)$", SYMBOLS.read_text(), re.M)}


def main(version):
    since = recorded()
    lines = [f" {name}@{node} {since.get((name, node), version)}\n" for name, node in sorted(exported())]
    SYMBOLS.write_text(HEAD.format(so=version.split(".", maxsplit=1)[0]) + "".join(lines))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
