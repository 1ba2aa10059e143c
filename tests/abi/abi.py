#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The binary interface, held to its record.

    abi.py check BUILD CC FLAG...      compare
    abi.py record BUILD CC FLAG...     write libtdsp.abi and the list of symbols anew

The interface is what the public headers say: each function's stub is compiled from its declaration, with the flags of the library, so that the record holds
public types only and nothing of what opaque ones hide. (Comparing the library's own debugging information does not do: libabigail knows private types by
the base names of headers, of which we have some twice, and then a changed public struct passes.) That the library has these functions and no
others, under their version, is read from the library itself.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
RECORD = ROOT / "tests" / "abi" / "libtdsp.abi"
SCRIPT = ROOT / "src" / "libtdsp.map"
DESCRIBE = ["abidw", "--no-comp-dir-path", "--no-corpus-path", "--no-show-locs", "--no-elf-needed", "--type-id-style", "hash"]

# What must not pass unnoticed: header, what stands there, what takes its place.
CHANGES = [
    ("a struct that grew", "types.h", "double growth; ", "double growth; double more; "),
    ("a struct that lost a member", "types.h", "uint32_t reserved; ", ""),
    ("members that changed places", "types.h", "double radius_to; ", "double swapped; "),
    ("a member of another type", "types.h", "int32_t turn; ", "int64_t turn; "),
    ("an enumerator of another value", "status.h", "TDSP_CUT_OFF = 3", "TDSP_CUT_OFF = 9"),
    ("a status that went", "status.h", "TDSP_SHRINKS = 41,", ""),
    ("a parameter more", "table.h", "tdsp_table_find(const tdsp_table *table, ", "tdsp_table_find(const tdsp_table *table, int more, "),
    ("a result of another type", "scene.h", "uint64_t tdsp_scene_hash(", "uint32_t tdsp_scene_hash("),
    ("a callback with another parameter", "build.h", "(*tdsp_progress)(void *ctx, double settled, ", "(*tdsp_progress)(void *ctx, float settled, "),
]


def run(command, **options):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, **options)


def must(command):
    done = run(command)
    if done.returncode:
        sys.exit(f"not ok abi: {' '.join(map(str, command))}\n{done.stderr}")
    return done.stdout


def code_of(header):
    """A header's text without comments, one space between words."""
    return re.sub(r"[ \t\n]+", " ", re.sub(r"/\*.*?\*/", " ", header.read_text(), flags=re.S))


def declarations(include):
    """Each public function as it is declared, without TDSP_API: {name: declaration}."""
    found = {}
    for header in sorted(include.glob("tdsp/*.h")):
        for text in re.findall(r"\bTDSP_API ([^;]*?);", code_of(header)):
            found[re.search(r"\b(tdsp_\w+) ?\(", text).group(1)] = text
    return found


def surface(include, folder, compiler):
    """A shared library of stubs, one for each function of the headers; its path, or what the compiler or linker says against it."""
    source, library = folder / "surface.c", folder / "libtdsp.so"
    includes = "".join(f"#include <tdsp/{p.name}>\n" for p in sorted(include.glob("tdsp/*.h")))
    stubs = "".join(f"{text} {{ __builtin_trap(); }}\n" for text in declarations(include).values())
    source.write_text(includes + stubs)
    done = run([*compiler, f"-I{include}", "-g", "-O0", "-fPIC", "-fvisibility=hidden", "-Wno-unused-parameter", "-shared", "-Wl,-soname,libtdsp.so.0",
                f"-Wl,--version-script={SCRIPT}", "-Wl,--no-undefined-version", "surface.c", "-o", library], cwd=folder)
    return (library, "") if done.returncode == 0 else (None, done.stderr)


def exported(library):
    """{name: version} of the functions that a shared library exports."""
    lines = [line.split() for line in must(["nm", "-D", "--defined-only", library]).splitlines()]
    return dict(name.split("@@") if "@@" in name else (name, "no version") for _, kind, name in lines if kind != "A")


def listed():
    """{name: version} of the version script, the list of exported symbols."""
    names = {}
    for version, body in re.findall(r"([\w.]+) \{ global:([^{}]*?)(?:local: \*;)?\s*\}", re.sub(r"\s+", " ", re.sub(r"/\*.*?\*/", "", SCRIPT.read_text(), flags=re.S))):
        names.update({name: version for name in re.findall(r"tdsp_\w+", body)})
    return names


def report(name, problems):
    print(f"not ok abi {name}: {'; '.join(problems)}" if problems else f"ok abi {name}")
    return bool(problems)


def differences(what, there, other, wanted):
    """The first few entries that one of two lists has and the other has not."""
    return ([f"{name} ({version}) is in {what} only" for name, version in sorted(there.items()) if wanted.get(name) != version] + \
           [f"{name} ({version}) is in {other} only" for name, version in sorted(wanted.items()) if there.get(name) != version])[:6]


def check_symbols(build):
    names = listed()
    library = exported(build / "libtdsp.so")
    bad = report("the library exports what the version script lists", differences("the library", library, "the script", names))
    headers = declarations(ROOT / "include")
    return report("the version script lists what the headers declare",
                  [f"{n} is declared, not listed in src/libtdsp.map" for n in sorted(headers.keys() - names)] +
                  [f"{n} is listed, not declared" for n in sorted(names.keys() - headers.keys())]) or bad


def compare(library):
    """What abidiff says against the record; nothing when all is as it was."""
    done = run(["abidiff", "--no-architecture", RECORD, library])
    return "" if done.returncode == 0 else done.stdout + done.stderr


def check_record(folder, compiler):
    library, errors = surface(ROOT / "include", folder, compiler)
    said = compare(library) if library else errors
    if said:
        print(said, file=sys.stderr)
    return report("is as recorded", ["it changed (above); make abi-record, when that is meant"] if said else [])


def check_noticed(folder, compiler):
    """That the comparison sees each kind of change."""
    bad = False
    for name, header, old, new in CHANGES:
        include = folder / "include"
        shutil.rmtree(include, ignore_errors=True)
        shutil.copytree(ROOT / "include", include)
        place = include / "tdsp" / header
        text = code_of_lines(place)
        changed = text.replace(old, new, 1) if "swapped" not in new else swapped(text)
        place.write_text(changed)
        library, errors = surface(include, folder, compiler)
        problems = [] if library and compare(library) else [errors.strip() or "nothing was reported"]
        bad |= report(f"notices {name}", problems if changed != text else ["the header has no such line any more"])
    return bad


def code_of_lines(header):
    """As code_of(), but with its preprocessor lines whole."""
    text = re.sub(r"/\*.*?\*/", " ", header.read_text(), flags=re.S)
    return "\n".join(re.sub(r"[ \t]+", " ", line) + " " for line in text.splitlines())


def swapped(text):
    """tdsp_leg's two radii in the other order: same size, same types."""
    return text.replace("double radius_from; ", "double radius_x; ", 1).replace("double radius_to; ", "double radius_from; ", 1).replace(
        "double radius_x; ", "double radius_to; ", 1)


def add_symbols():
    """List new functions in the newest version, and take those from the list that are gone."""
    headers, text = declarations(ROOT / "include"), SCRIPT.read_text()
    for name in listed().keys() - headers.keys():
        text = text.replace(f"    {name};\n", "")
    for name in sorted(headers.keys() - listed().keys()):
        text = text.replace("local:\n", f"local:\n@{name}", 1)
    fresh = re.findall(r"@(tdsp_\w+)", text)
    text = re.sub(r"@tdsp_\w+", "", text)
    head, body, tail = re.fullmatch(r"(.*global:\n)(.*?)(local:\n.*)", text, flags=re.S).groups()
    names = sorted(re.findall(r"tdsp_\w+", body) + fresh)
    SCRIPT.write_text(head + "".join(f"    {name};\n" for name in names) + tail)


def record(folder, compiler):
    add_symbols()
    library, errors = surface(ROOT / "include", folder, compiler)
    if not library:
        sys.exit(errors)
    RECORD.write_text(must([*DESCRIBE, "--no-architecture", library]))
    return 0


def main():
    job, build, compiler = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if job == "record":
            return record(folder, compiler)
        return int(bool(check_symbols(build)) | bool(check_record(folder, compiler)) | bool(check_noticed(folder, compiler)))


if __name__ == "__main__":
    sys.exit(main())
