#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Check what the compiled library contains, where the source can hide it.

    check_objects.py BUILD

- the shared library exports exactly the functions that the public headers declare with TDSP_API;
- no object has writable data: no mutable globals;
- below the freestanding line nothing is called but memory, and of mathematics what is exact;
- above it, only the allocator asks the C library for memory, and nothing prints, reads files or exits;
- nowhere is a function of the mathematical library called whose last bit depends on the machine, nor imported by the shared library.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
MEMORY = {"memcmp", "memcpy", "memmove", "memset", "memchr", "strlen", "strcmp", "strncmp"}
# Of the C library's mathematics only what has one answer everywhere: the rest is the library's own (src/base/math.h).
EXACT = {"ceil", "copysign", "fabs", "floor", "frexp", "ldexp", "nextafter", "scalbn", "sqrt", "trunc"}
COMPILER = {"_GLOBAL_OFFSET_TABLE_", "__stack_chk_fail", "__assert_fail"}
HOSTED = {"qsort", "bsearch"}
ALLOCATION = {"malloc", "calloc", "realloc", "free"}
WRITABLE = re.compile(r"^\.(data|bss|tdata|tbss)(?!\.rel\.ro)")


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def symbols(archive):
    """{object: (defined names, undefined names)}"""
    found, current = {}, None
    for line in output("nm", archive).splitlines():
        if line.endswith(".o:"):
            current = found.setdefault(line[:-1], (set(), set()))
        elif line.strip():
            kind, name = line.split()[-2:]
            current[kind in "Uw"].add(name)
    return found


def outside(objects):
    """{object: what it wants that no object of the archive defines}"""
    defined = set().union(*(d for d, _ in objects.values()))
    return {name: wanted - defined for name, (_, wanted) in objects.items()}


def declared():
    text = "".join(p.read_text() for p in (ROOT / "include" / "tdsp").glob("*.h"))
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    return set(re.findall(r"TDSP_API\b[^;(]*?\b(tdsp_\w+)\s*\(", text))


def exported(library):
    lines = [line.split() for line in output("nm", "-D", "--defined-only", library).splitlines()]
    return {name.split("@")[0] for _, kind, name in lines if kind != "A"}  # A: the name of a version


def imported(library):
    """What a shared library wants of others, but what every one does for its loading (_ITM_..., __cxa_finalize)."""
    names = {line.split()[-1].split("@")[0] for line in output("nm", "-D", "--undefined-only", library).splitlines()}
    return {name for name in names if not name.startswith(("_ITM_", "__gmon", "__cxa_", "_fini", "_init"))}


def writable(archive):
    """Sections that hold state, as "object: section"."""
    found, current = [], ""
    for line in output("size", "-A", archive).splitlines():
        if line.rstrip().endswith(":") or "(ex " in line:
            current = line.split()[0]
        fields = line.split()
        if len(fields) == 3 and WRITABLE.match(fields[0]) and int(fields[1]) > 0:
            found.append(f"{current}: {fields[0]} has {fields[1]} bytes")
    return found


def report(name, problems):
    print(f"not ok objects {name}: {'; '.join(sorted(problems))}" if problems else f"ok objects {name}")
    return bool(problems)


def main():
    build = pathlib.Path(sys.argv[1])
    wanted, there = declared(), exported(build / "libtdsp.so")
    bad = report("exported symbols are the declared ones",
                 [f"{n} is declared, not exported" for n in wanted - there] +
                 [f"{n} is exported, not declared" for n in there - wanted])
    bad |= report("no mutable globals", writable(build / "libtdsp.a"))
    below = outside(symbols(build / "libtdsp-query.a"))
    bad |= report("the reader needs memory and exact mathematics only",
                  [f"{o} wants {n}" for o, names in below.items() for n in names - MEMORY - EXACT - COMPILER])
    above = outside(symbols(build / "libtdsp.a"))
    bad |= report("one place asks for memory, nothing prints",
                  [f"{o} wants {n}" for o, names in above.items()
                   for n in names - MEMORY - EXACT - COMPILER - HOSTED - (ALLOCATION if o == "allocator.o" else set())])
    bad |= report("the shared library imports only what is exact",
                  [f"{n} is imported" for n in imported(build / "libtdsp.so") - MEMORY - EXACT - COMPILER - HOSTED - ALLOCATION])
    return int(bad)


if __name__ == "__main__":
    sys.exit(main())
