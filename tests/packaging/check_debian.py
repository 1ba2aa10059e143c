#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What of tools/debian would drift without anybody building packages: check_debian.py VERSION

The version of its changelog, and the symbols of the shared library, which dpkg-gensymbols holds to the library when a package is built and this holds to the
list that the library is linked by.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEBIAN = ROOT / "tools/debian"
sys.path.insert(0, str(ROOT / "tools/dist"))
import symbols  # noqa: E402


def check(sentence, problem):
    print(f"{'not ok' if problem else 'ok'} debian: {sentence}")
    if problem:
        print(f"    {problem}")
    return bool(problem)


def main(version):
    entry = re.match(r"libtdsp \((\S+)-\d+\) ", (DEBIAN / "changelog").read_text())
    failed = check("the changelog is about this version", None if entry and entry[1] == version else f"{entry and entry[1]}, not {version}")
    differing = sorted(name for name, _ in symbols.exported() ^ symbols.recorded().keys())
    failed += check("libtdsp0.symbols has what src/libtdsp.map exports", differing and f"`make abi-record` records {', '.join(differing)}")
    soname = re.match(r"libtdsp\.so\.(\d+) libtdsp(\d+) ", (DEBIAN / "libtdsp0.symbols").read_text())
    failed += check("the package is named by the SONAME", None if soname and soname[1] == soname[2] == version.split(".", maxsplit=1)[0] else str(soname))
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
