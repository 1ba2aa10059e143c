#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The library's interface for ctypes, written from its headers: constants, enumerations, structs, callbacks and functions.

    abi.py            write src/tdsp/_abi.py anew
    abi.py --check    is it what the headers say? (part of checklist.py)

The headers are read by clang-19, so that what is understood is what a compiler understands; the numbers of macros come from its preprocessor.
"""
from __future__ import annotations

import json
import keyword
import pathlib
import re
import subprocess
import sys
from typing import Any

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TARGET = HERE / "src" / "tdsp" / "_abi.py"
CLANG = ["clang-19", "-std=c99", "-Iinclude", "-x", "c", "include/tdsp/tdsp.h"]

PLAIN = {"double": "ctypes.c_double", "float": "ctypes.c_float", "int": "ctypes.c_int", "int32_t": "ctypes.c_int32", "uint16_t": "ctypes.c_uint16",
         "uint32_t": "ctypes.c_uint32", "uint64_t": "ctypes.c_uint64", "size_t": "ctypes.c_size_t", "char": "ctypes.c_char",
         "unsigned char": "ctypes.c_ubyte", "void": "None", "const char *": "ctypes.c_char_p"}
ANNOTATIONS = {"ctypes.c_double": "float", "ctypes.c_float": "float", "ctypes.c_void_p": "Optional[int]"}

HEAD = '''# SPDX-License-Identifier: MIT
# Written by abi.py from include/tdsp/*.h. Do not edit: `make python-abi` writes it anew.
"""The C interface as ctypes sees it. Private: the package's other modules are what users see.

Pointers to data are `c_void_p`, so that addresses of NumPy arrays, `byref()` and None are all welcome. An enumeration's values travel as `c_uint`.
"""
from __future__ import annotations

import ctypes
from enum import IntEnum
from typing import Any, Optional
'''


class Interface:
    """What the headers declare, in their order."""

    def __init__(self) -> None:
        dump = subprocess.run([*CLANG, "-fsyntax-only", "-Xclang", "-ast-dump=json"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
        nodes = [node for node in json.loads(dump)["inner"] if node.get("name", "").startswith("tdsp_")]
        self.enums = {n["name"]: enum_values(n) for n in nodes if n["kind"] == "EnumDecl"}
        self.records = {n["name"]: fields(n) for n in nodes if n["kind"] == "RecordDecl" and n.get("completeDefinition")}
        self.callbacks = {n["name"]: n["type"]["qualType"] for n in nodes if n["kind"] == "TypedefDecl" and "(*)" in n["type"]["qualType"]}
        self.functions = {n["name"]: signature(n["type"]["qualType"]) for n in nodes if n["kind"] == "FunctionDecl"}
        self.order = [n["name"] for n in nodes if n["name"] in (self.callbacks if n["kind"] == "TypedefDecl" else self.records)]
        self.constants = constants()

    def ctype(self, c: str) -> str:
        """The ctypes expression for a type of C."""
        c = c.strip()
        array = re.fullmatch(r"(.*?)\s*\[(\d+)\]", c)
        if array:
            return f"{self.ctype(array[1])} * {array[2]}"
        if c in PLAIN:
            return PLAIN[c]
        if c in self.callbacks:
            return c
        if "(*)" in c:
            return self.function_type(c)
        if c.endswith("*"):
            return "ctypes.c_void_p"
        bare = re.sub(r"^(const|enum|struct) ", "", c)
        if bare in self.enums:
            return "ctypes.c_uint"
        if bare in self.records:
            return bare
        raise SystemExit(f"abi.py: no rule for the type {c!r}")

    def function_type(self, c: str) -> str:
        result, arguments = signature(c)
        return f"ctypes.CFUNCTYPE({', '.join([self.ctype(result), *map(self.ctype, arguments)])})"


def enum_values(node: dict[str, Any]) -> dict[str, int]:
    values, following = {}, 0
    for item in node["inner"]:
        if item["kind"] == "EnumConstantDecl":
            value = next((int(inner["value"]) for inner in item.get("inner", []) if "value" in inner), following)
            values[item["name"]] = value
            following = value + 1
    return values


def fields(node: dict[str, Any]) -> dict[str, str]:
    return {item["name"]: item["type"]["qualType"] for item in node.get("inner", []) if item["kind"] == "FieldDecl"}


def signature(c: str) -> tuple[str, list[str]]:
    """Result and parameters of "R (A, B)" and of "R (*)(A, B)"."""
    parts = re.fullmatch(r"(.*?)\s*(?:\(\*\))?\(([^()]*)\)", c)
    if parts is None:
        raise SystemExit(f"abi.py: cannot read the type {c!r}")
    arguments = [a.strip() for a in parts[2].split(",")]
    return parts[1], [] if arguments == ["void"] else arguments


def constants() -> dict[str, str]:
    """Macros that are numbers, as Python writes them."""
    text = subprocess.run([*CLANG, "-E", "-dM"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    found = {}
    for name, value in re.findall(r"^#define (TDSP_\w+) (.+)$", text, re.M):
        number = re.sub(r"(?<=[0-9a-f])u\b", "", value)
        if re.fullmatch(r"[-+*/(). 0-9a-fxe]+", number):
            found[name] = number
    return dict(sorted(found.items()))


def common_prefix(names: list[str]) -> str:
    """The longest prefix of all names that ends with an underscore."""
    first, last = min(names), max(names)
    same = next((i for i, pair in enumerate(zip(first, last)) if pair[0] != pair[1]), len(first))
    return first[:first.rfind("_", 0, same) + 1]


def camel(name: str) -> str:
    return "".join(part.capitalize() for part in name.removeprefix("tdsp_").split("_"))


def enum_class(name: str, values: dict[str, int]) -> list[str]:
    prefix = common_prefix(list(values))
    return ["", "", f"class {camel(name)}(IntEnum):", f'    """Values of {name}."""', "",
            *(f"    {item.removeprefix(prefix)} = {value}" for item, value in values.items())]


def record_class(interface: Interface, name: str) -> list[str]:
    # A string of a struct may end without a zero byte, so it is an address here.
    members = {field: interface.ctype(c.replace("const char *", "const void *")) for field, c in interface.records[name].items()}
    lines = ["", "", f"class {name}(ctypes.Structure):", "    _fields_ = ["]
    lines += [f'        ("{field}", {c}),' for field, c in members.items()] + ["    ]"]
    for field, c in members.items():
        if not keyword.iskeyword(field):
            lines.append(f"    {field}: {annotation(interface, c)}")
    return lines


def annotation(interface: Interface, c: str) -> str:
    if c in interface.records:
        return c
    if "CFUNCTYPE" in c or c in interface.callbacks or " * " in c:
        return "Any"
    return ANNOTATIONS.get(c, "int")


def text(interface: Interface) -> str:
    lines = [HEAD]
    lines += [f"{name.removeprefix('TDSP_')} = {value}" for name, value in interface.constants.items()]
    for name, values in interface.enums.items():
        lines += enum_class(name, values)
    for name in interface.order:
        if name in interface.callbacks:
            lines += ["", "", f"{name} = {interface.function_type(interface.callbacks[name])}"]
        else:
            lines += record_class(interface, name)
    lines += ["", "", "# Result and parameters of each function.", "FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {"]
    for name, (result, arguments) in sorted(interface.functions.items()):
        lines.append(f'    "{name}": ({interface.ctype(result)}, [{", ".join(map(interface.ctype, arguments))}]),')
    return "\n".join(lines + ["}", ""])


def main() -> int:
    wanted = text(Interface())
    if sys.argv[1:] == ["--check"]:
        return int(TARGET.read_text(encoding="utf-8") != wanted)
    TARGET.write_text(wanted, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
