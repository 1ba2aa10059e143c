# SPDX-License-Identifier: MIT
"""What hatchling asks when it builds the wheel: the library goes into it, and its needs decide the tag.

The package is Python alone and finds the library by ctypes, so that one wheel serves every version of Python. The C library's newest symbol version that
the library needs is the oldest C library that the wheel runs on: manylinux_2_N.
"""
from __future__ import annotations

import os
import platform
import re
import subprocess
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

# What every Linux of the tag has (PEP 600); anything else would have to be in the wheel.
ALLOWED = {"libc.so.6", "libm.so.6"}
# The oldest that anybody names.
OLDEST = 17


def readelf(option: str, library: str) -> str:
    return subprocess.run(["readelf", "--wide", option, library], check=True, capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}).stdout


def tag(library: str) -> str:
    """The wheel's tag for a library."""
    needed = set(re.findall(r"\(NEEDED\).*\[(.+)\]", readelf("--dynamic", library)))
    if needed - ALLOWED:
        raise SystemExit(f"wheel: {library} needs {', '.join(sorted(needed - ALLOWED))}, which are not everywhere")
    versions = [int(minor) for minor in re.findall(r"Name: GLIBC_2\.(\d+)", readelf("--version-info", library))]
    return f"py3-none-manylinux_2_{max([OLDEST, *versions])}_{platform.machine()}"


class CustomBuildHook(BuildHookInterface):  # type: ignore[type-arg, misc]
    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        if version == "editable":
            return
        library = os.environ.get("TDSP_LIBRARY")
        if not library:
            raise SystemExit("wheel: TDSP_LIBRARY must name the library to put into the wheel; `make wheel` does that")
        soname = re.search(r"\(SONAME\).*\[(.+)\]", readelf("--dynamic", library))
        if soname is None:
            raise SystemExit(f"wheel: {library} has no soname")
        build_data["pure_python"] = False
        build_data["tag"] = tag(library)
        build_data["force_include"][os.path.realpath(library)] = f"tdsp/lib/{soname[1]}"
