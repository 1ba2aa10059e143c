#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What docs/ffi.md tells is so: the layouts are the compiler's, all public structures are there, and each piece of code stands in an example that is run.

    check_ffi.py COMPILER docs/ffi.md     compare
    check_ffi.py COMPILER                 print the layouts as they should stand there
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
PRIVATE = {"tdsp_table", "tdsp_guide"}  # only their sizes are told


def structures():
    """Each public structure and its members, in the order of the headers."""
    found = {}
    for header in sorted((ROOT / "include/tdsp").glob("*.h")):
        text = re.sub(r"/\*.*?\*/|//[^\n]*", "", header.read_text(encoding="utf-8"), flags=re.S)
        for name, body in re.findall(r"typedef struct (\w+) \{(.*?)\} \1;", text, flags=re.S):
            found[name] = [member for declaration in body.split(";") if declaration.strip() for member in members(declaration)]
    return found


def members(declaration):
    callback = re.search(r"\(\*(\w+)\)", declaration)
    if callback:
        return [callback.group(1)]
    names = re.sub(r"\[.*?\]", "", declaration).split(",")
    return [re.search(r"(\w+)\s*$", name).group(1) for name in names]


def asks(name, names):
    shown = [] if name in PRIVATE else names
    offsets = "".join(f' printf("{", " if i else ""}{member} %lu", (unsigned long)offsetof({name}, {member}));' for i, member in enumerate(shown))
    return f'printf("| `{name}` | %lu | ", (unsigned long)sizeof({name}));{offsets or " printf(" + chr(34) + "private" + chr(34) + ");"} printf(" |\\n");'


def layouts(compiler):
    """The lines of the table, told by a program."""
    body = "\n".join(asks(name, names) for name, names in structures().items())
    source = f'#include <stddef.h>\n#include <stdio.h>\n#include "tdsp/tdsp.h"\nint main(void) {{\n{body}\nreturn 0;\n}}\n'
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "layouts"
        subprocess.run([compiler, "-std=c99", f"-I{ROOT / 'include'}", "-x", "c", "-", "-o", program], input=source, text=True, check=True)
        return subprocess.run([program], stdout=subprocess.PIPE, text=True, check=True).stdout.splitlines()


def snippets(text):
    """File and code of each block that says, in the line above it, where it is from."""
    return re.findall(r"^<!-- (\S+) -->\n```\w+\n(.*?)^```$", text, flags=re.S | re.M)


def stands(code, file):
    """Do the lines stand in the file, one below the other, indented alike?"""
    lines = textwrap.dedent((ROOT / file).read_text(encoding="utf-8")).splitlines()
    wanted = code.splitlines()
    return any(textwrap.dedent("\n".join(lines[i:i + len(wanted)])) == textwrap.dedent("\n".join(wanted)) for i in range(len(lines)))


def say(passed, name):
    print(f"{'ok' if passed else 'not ok'} ffi: {name}")
    return passed


def main(compiler, page=None):
    rows = layouts(compiler)
    if page is None:
        print("\n".join(rows))
        return 0
    text = pathlib.Path(page).read_text(encoding="utf-8")
    told = {line for line in text.splitlines() if re.match(r"\| `tdsp_\w+` \| \d", line)}
    wrong = [row for row in rows if row not in told] + [line for line in told if line not in rows]
    fine = say(rows and not wrong, f"{len(rows)} structures are laid out as the page tells")
    print("".join(f"    {line}\n" for line in wrong), end="")
    blocks = snippets(text)
    fine &= say(len(blocks) >= 6 and len(blocks) == len(re.findall(r"^```(?:c|cpp|rust|go|java|js|python)$", text, flags=re.M)), "each piece of code says where it is from")
    for file, code in blocks:
        fine &= say(stands(code, file), f"the code from {file} stands there")
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
