#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The binding checklist: is the whole of include/tdsp/*.h in the Python package?

    checklist.py

Fails when src/tdsp/_abi.py is not what the headers declare, when a struct's layout is not the C compiler's, and when a public function is called nowhere
in the package without an excuse. (That the tests call each of them, tests/run.py sees to.)
"""
from __future__ import annotations

import ast
import ctypes
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE / "src" / "tdsp")]

import _abi  # noqa: E402  (alone, so that no library need be there)
import abi  # noqa: E402

# Functions that the package has no use for, each with the reason.
EXCUSED: dict[str, str] = {}


def called() -> set[str]:
    """Functions of the library that the package's modules name, as `lib.NAME`."""
    found = set()
    for path in (HERE / "src").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "lib":
                found.add(node.attr)
    return found


def report(name: str, problem: str) -> bool:
    print(f"not ok {name}: {problem}" if problem else f"ok {name}")
    return bool(problem)


def function_problem(name: str, used: set[str]) -> str:
    if name in used:
        return "is excused, and called all the same" if name in EXCUSED else ""
    return "" if name in EXCUSED else "is not in the Python package: bind it, or excuse it in checklist.py"


def check_functions(interface: abi.Interface) -> bool:
    used = called()
    wrong = [report(f"python {name}", function_problem(name, used)) for name in sorted(interface.functions)]
    for name in sorted(set(EXCUSED) - set(interface.functions)):
        wrong.append(report(f"python excuse {name}", "there is no such function"))
    return any(wrong)


def layouts_in_c(interface: abi.Interface) -> list[str]:
    """STRUCT.MEMBER OFFSET SIZE of every member, and STRUCT 0 SIZE, as a C compiler lays them out."""
    prints = []
    for record, fields in interface.records.items():
        prints.append(f'printf("{record} 0 %zu\\n", sizeof({record}));')
        prints += [f'printf("{record}.{field} %zu %zu\\n", offsetof({record}, {field}), sizeof((({record} *)0)->{field}));' for field in fields]
    source = "#include <stddef.h>\n#include <stdio.h>\n#include <tdsp/tdsp.h>\nint main(void)\n{\n" + "\n".join(prints) + "\nreturn 0;\n}\n"
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "layout"
        subprocess.run(["gcc", "-std=c99", f"-I{abi.ROOT / 'include'}", "-x", "c", "-", "-o", str(program)], input=source, text=True, check=True)
        return subprocess.run([str(program)], capture_output=True, text=True, check=True).stdout.splitlines()


def layouts_here(interface: abi.Interface) -> list[str]:
    lines = []
    for record, fields in interface.records.items():
        struct = getattr(_abi, record)
        lines.append(f"{record} 0 {ctypes.sizeof(struct)}")
        lines += [f"{record}.{field} {getattr(struct, field).offset} {getattr(struct, field).size}" for field in fields]
    return lines


def main() -> int:
    interface = abi.Interface()
    stale = abi.TARGET.read_text(encoding="utf-8") != abi.text(interface)
    wrong = report("python _abi.py is what the headers declare", "`make python-abi` writes it anew" if stale else "")
    if not stale:
        different = [line for line in zip(layouts_in_c(interface), layouts_here(interface)) if line[0] != line[1]]
        wrong |= report("python structs are laid out as in C", f"{different[0]}" if different else "")
    return int(check_functions(interface) or wrong)


if __name__ == "__main__":
    sys.exit(main())
