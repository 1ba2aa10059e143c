#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run what the documentation shows, so that it stays true.

    check_snippets.py BUILD PAGE...

In a ```console block each line "$ COMMAND" is run by bash with BUILD in PATH, and the lines after it are what it
prints, apart from the width of columns; "..." stands for any text. In a ```sh block `make TARGET` must be
a target with a line of help and everything else is run and must succeed. A ```c block is compiled with warnings as errors: with a main() against
the library, and run; else as a file of its own. A block of any kind below a line <!-- FILE --> is a quotation: its lines stand in that file of the
checkout, one below the other, indented alike, and nothing else is done with it. A ```python block is run with the package of the checkout. What others run,
RUN_BY names; ```text is no code; a block that nobody would run is an error. A block of any kind whose fence names a file (```json gate.json) becomes that file. All of
it happens in a directory of its own per page, in which build/, examples/, docs/ and include/ are those of the checkout.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^(?:<!-- (\S+) -->\n)?```(\w+)(?: +(\S+))?[^\n]*\n(.*?)^```", re.M | re.S)
# Kinds of blocks of a page that other checks run.
RUN_BY = {("docs/python.md", "python"): "tools/python/tests", ("docs/packaging.md", "cmake"): "tests/install", ("docs/page.md", "js"): "tests/page"}
ELSEWHERE = re.compile(r"^(git clone|cd |sudo )")


def squeeze(text):
    """The text with every run of spaces as one, so that columns may be as wide as the numbers shown."""
    return re.sub(r" *\n *", "\n", re.sub(r"[ \t]+", " ", text)).strip()


def stands(quotation, text):
    """Do the quotation's lines stand in the text, one below the other, indented alike?"""
    lines, wanted = text.splitlines(), textwrap.dedent(quotation).splitlines()
    return any(textwrap.dedent("\n".join(lines[i:i + len(wanted)])).splitlines() == wanted for i in range(len(lines)))


def python_with_numpy():
    """The Python that has NumPy: Debian's belongs to Debian's Python, which need not be the first in PATH."""
    candidates = (sys.executable, "/usr/bin/python3")
    has = (p for p in candidates if subprocess.run([p, "-c", "import numpy"], stderr=subprocess.DEVNULL, check=False).returncode == 0)
    return next(has, sys.executable)


class Page:
    def __init__(self, path, build, scratch):
        self.path, self.build, self.scratch, self.failed = path, build, scratch, False

    def report(self, what, problem):
        self.failed = self.failed or bool(problem)
        what = f"{self.path.name}: {what}"
        print(f"not ok {what}\n{problem}" if problem else f"ok {what}")

    def run(self, command):
        """Exit status and output of a shell command."""
        env = dict(os.environ, PATH=f"{self.build}:{os.environ['PATH']}", LC_ALL="C.UTF-8")
        done = subprocess.run(["bash", "-c", command], cwd=self.scratch, env=env, text=True, timeout=300,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return done.returncode, done.stdout

    def console(self, text):
        for part in re.split(r"^\$ ", text, flags=re.M)[1:]:
            command, _, shown = part.partition("\n")
            while command.endswith("\\"):
                more, _, shown = shown.partition("\n")
                command = command[:-1] + re.sub(r"^> ", "", more)
            _, printed = self.run(command)
            pattern = re.escape(squeeze(shown)).replace(r"\.\.\.", ".*?")
            fine = re.fullmatch(pattern, squeeze(printed), re.S)
            self.report(f"$ {command}", None if fine else f"shown:\n{shown}printed:\n{printed}")

    def shell(self, text):
        for command in re.sub(r"\\\n\s*", "", text).splitlines():
            command = re.sub(r"\s+#.*", "", command).strip()
            if not command or command.startswith("#") or ELSEWHERE.match(command):
                continue
            target = re.match(r"make( [a-z-]+)?", command)
            if target:
                self.report(command, self.no_target((target[1] or " all").strip()))
            else:
                status, printed = self.run(command)
                self.report(command, f"exit status {status}\n{printed}" if status else None)

    def no_target(self, name):
        files = [ROOT / "Makefile", *ROOT.glob("tests/*/rules.mk"), *ROOT.glob("tools/*/rules.mk")]
        helped = [target for file in files for target in re.findall(r"^([a-z-]+):.*## ", file.read_text(), re.M)]
        return None if name in helped else f"make has no target {name} with a line of help"

    def code(self, text):
        program = "main(" in text
        (self.scratch / "snippet.c").write_text(text)
        rest = f"{self.build}/libtdsp.a -lm -o snippet && ./snippet" if program else "-c -o snippet.o"
        status, printed = self.run(f"gcc -std=c99 -Wall -Wextra -Wpedantic -Werror -I{ROOT}/include snippet.c {rest}")
        self.report(f"{'program' if program else 'code'} that begins {text.splitlines()[0]}", f"exit status {status}\n{printed}" if status else None)

    def python(self, text):
        (self.scratch / "snippet.py").write_text(text, encoding="utf-8")
        status, printed = self.run(f"TDSP_LIBRARY={self.build}/libtdsp.so PYTHONPATH={ROOT}/tools/python/src {python_with_numpy()} snippet.py")
        self.report(f"program that begins {text.splitlines()[0]}", f"exit status {status}\n{printed}" if status else None)

    def other(self, kind, text, file):
        """A block that is not run here."""
        by = RUN_BY.get((str(self.path.relative_to(ROOT)), kind))
        if by or not (file or kind == "text"):
            self.report(f"{kind} that begins {text.splitlines()[0]}" + (f" is run by {by}" if by else ""), None if by else "nobody runs it")

    def quotation(self, source, text):
        file = ROOT / source
        fine = file.is_file() and stands(text, file.read_text(encoding="utf-8"))
        self.report(f"quotation from {source} that begins {text.split(chr(10), 1)[0].strip()}", None if fine else f"{source} has no such lines:\n{text}")

    def check(self):
        kinds = {"console": self.console, "sh": self.shell, "c": self.code, "python": self.python}
        for source, kind, file, text in BLOCK.findall(self.path.read_text(encoding="utf-8")):
            if source:
                self.quotation(source, text)
                continue
            if file:
                (self.scratch / file).write_text(text, encoding="utf-8")
            if kind in kinds and (str(self.path.relative_to(ROOT)), kind) not in RUN_BY:
                kinds[kind](text)
            else:
                self.other(kind, text, file)
        return self.failed


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    failed = False
    for page in sys.argv[2:]:
        with tempfile.TemporaryDirectory() as name:
            scratch = pathlib.Path(name)
            # The checkout as seen from its top, where nothing that a page writes can stay behind.
            for entry in ("examples", "include", "docs"):
                if (ROOT / entry).exists():
                    (scratch / entry).symlink_to(ROOT / entry)
            (scratch / "build").mkdir()
            for entry in build.iterdir():
                if entry.is_file():
                    (scratch / "build" / entry.name).symlink_to(entry)
            failed |= Page(pathlib.Path(page).resolve(), build, scratch).check()
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
