#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every public function above the freestanding line is tried without memory, or is held to needing none (tests/unit/test_no_memory*.c).

    check_calls.py BUILD

The freestanding line has no heap at all: tests/check_objects.py sees to that.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def functions(library, *options):
    listed = subprocess.run(["nm", *options, "--defined-only", library], capture_output=True, text=True, check=True).stdout
    return set(re.findall(r" T (tdsp_\w+)(?:@.*)?$", listed, re.M))


def main():
    build = pathlib.Path(sys.argv[1])
    public = functions(build / "libtdsp.so", "-D") - functions(build / "libtdsp-query.a")
    text = "".join(file.read_text() for file in sorted((ROOT / "tests" / "unit").glob("test_no_memory*.c")))
    tried, needless = set(re.findall(r'^    \{"(tdsp_\w+)", call_', text, re.M)), set(re.findall(r"NEEDS_NONE\((tdsp_\w+)", text))
    wrong = [f"{name}: neither tried without memory nor held to needing none" for name in sorted(public - tried - needless)]
    wrong += [f"{name}: no public function" for name in sorted((tried | needless) - public)]
    wrong += [f"{name}: tried, and said to need none" for name in sorted(tried & needless)]
    for line in wrong:
        print("not ok", line)
    if not wrong:
        print(f"ok {len(public)} public functions: {len(tried)} tried without memory, {len(needless)} need none")
    sys.exit(1 if wrong or not public else 0)


main()
