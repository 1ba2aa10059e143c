#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Complete words in real shells: check_completions.py COMMAND COMPLETIONS SHELL...

A line is typed into an interactive shell on a terminal of its own, then a tab; what the shell made of it is what the line would run. fish is asked by
`complete -C`, which answers without a terminal. And every option of every command is completed, in bash.
"""
import os
import pathlib
import pty
import re
import select
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/install"))
import described  # noqa: E402

# What is typed, and what it becomes by one tab.
LINES = [
    ("tdsp env", ["tdsp", "envelope"]),
    ("tdsp help ver", ["tdsp", "help", "verify"]),
    ("tdsp build sc", ["tdsp", "build", "scene.json"]),
    ("tdsp build spa", ["tdsp", "build", "space in it.json"]),
    ("tdsp build oth", ["tdsp", "build", "other.txt"]),
    ("tdsp build --horizon 5 sc", ["tdsp", "build", "--horizon", "5", "scene.json"]),
    ("tdsp build scene.json --guar", ["tdsp", "build", "scene.json", "--guarantee"]),
    ("tdsp build scene.json --guarantee ab", ["tdsp", "build", "scene.json", "--guarantee", "absolute"]),
    ("tdsp build scene.json -o tab", ["tdsp", "build", "scene.json", "-o", "table.tdsp"]),
    ("tdsp build scene.json -o table.tdsp --sampling geo", ["tdsp", "build", "scene.json", "-o", "table.tdsp", "--sampling", "geometric"]),
    ("tdsp arrive scene.json 0 --method=gen", ["tdsp", "arrive", "scene.json", "0", "--method=general"]),
    ("tdsp generate cro", ["tdsp", "generate", "crowd"]),
    ("tdsp query tab", ["tdsp", "query", "table.tdsp"]),
    ("tdsp query mat", ["tdsp", "query", "matrix.tdspm"]),
    ("tdsp verify scene.json tab", ["tdsp", "verify", "scene.json", "table.tdsp"]),
    ("tdsp margin scene.json 0 --path table.t", ["tdsp", "margin", "scene.json", "0", "--path", "table.tdsp"]),
    ("tdsp embed table.tdsp -o ou", ["tdsp", "embed", "table.tdsp", "-o", "out.c"]),
    ("tdsp arrive sub", ["tdsp", "arrive", "sub/"]),
    ("tdsp arrive sub/in", ["tdsp", "arrive", "sub/inner.json"]),
]
FILES = ["scene.json", "scene.txt", "scene.tdsp", "other.txt", "space in it.json", "table.tdsp", "table.json.orig", "matrix.tdspm", "out.c", "out.o", "sub/inner.json"]

failed = 0


def check(sentence, problem):
    global failed
    print(f"{'not ok' if problem else 'ok'} completions: {sentence}")
    if problem:
        print(f"    {problem}")
        failed += 1


class Shell:
    """An interactive shell on a terminal."""

    def __init__(self, arguments, directory):
        child, self.terminal = pty.fork()
        if child == 0:
            os.chdir(directory)
            os.environ.update(PS1="", TERM="dumb", LC_ALL="C.UTF-8", INPUTRC="/dev/null", HISTFILE="/dev/null")
            os.execvp(arguments[0], arguments)
        self.child = child

    def read_to(self, pattern, seconds=20):
        """What is written until the pattern is there."""
        text, until = "", time.monotonic() + seconds
        while not re.search(pattern, text):
            ready, _, _ = select.select([self.terminal], [], [], max(0, until - time.monotonic()))
            if not ready:
                raise TimeoutError(f"the shell said {text!r}")
            text += os.read(self.terminal, 65536).decode(errors="replace")
        return text

    def run(self, line):
        """Run a line and wait for its end; the mark is not in the line as it is echoed."""
        os.write(self.terminal, f"{line}; printf 'E%sD\\n' N\n".encode())
        self.read_to(r"END\r?\n")

    def complete(self, typed):
        """The words that the line has after one tab: it becomes the arguments of printf."""
        os.write(self.terminal, typed.encode() + b"\t\x01printf '<%s>' \x05; printf 'E%sD\\n' N\n")
        text = self.read_to(r"END\r?\n")
        return [word for word in re.findall(r"<([^<>]*)>", text) if word != "%s"]

    def close(self):
        os.close(self.terminal)
        os.waitpid(self.child, 0)


def typed_into(shell, completions, directory):
    if shell == "bash":
        opened = Shell(["bash", "--norc", "--noprofile", "-i"], directory)
        opened.run(f"bind 'set enable-bracketed-paste off'; set +o history; source {completions}/tdsp")
    else:
        opened = Shell(["zsh", "-f", "-i"], directory)
        opened.run(f"unsetopt auto_remove_slash zle_bracketed_paste prompt_cr prompt_sp; bindkey -e; fpath=({completions} $fpath); autoload -Uz compinit; compinit -u -D")
    for typed, wanted in LINES:
        try:
            found = opened.complete(typed)
        except TimeoutError as late:
            found = str(late)
        check(f"{shell}: {typed}", None if found == wanted else f"{found}, not {wanted}")
    opened.close()


def asked_of_fish(completions, directory):
    for typed, wanted in LINES:
        done = subprocess.run(["fish", "--no-config", "-c", f"source {completions}/tdsp.fish; complete -C {typed!r}"], cwd=directory, capture_output=True,
                              text=True, env=dict(os.environ, HOME=str(directory), LC_ALL="C.UTF-8"), check=False)
        found = [line.split("\t")[0] for line in done.stdout.splitlines()]
        last = wanted[-1]
        check(f"fish: {typed}", None if last in found and len(found) <= 2 else f"{found}, not {[last]} {done.stderr}")


def all_options(program, completions):
    """`tdsp COMMAND --` offers every option of the command, as the program tells them."""
    _, commands = described.ask(program)
    for command in commands:
        line = f"source {completions}/tdsp; COMP_WORDS=(tdsp {command.name} -); COMP_CWORD=2; _tdsp; printf '%s\\n' \"${{COMPREPLY[@]}}\""
        found = set(subprocess.run(["bash", "-c", line], check=True, capture_output=True, text=True).stdout.split())
        wanted = {flag for option in command.options for flag in option.flags}
        check(f"bash: every option of {command.name}", None if found == wanted else f"{sorted(found ^ wanted)}")


def main(program, completions, *shells):
    completions = pathlib.Path(completions).resolve()
    with tempfile.TemporaryDirectory() as directory:
        for name in FILES:
            path = pathlib.Path(directory, name)
            path.parent.mkdir(exist_ok=True)
            path.touch()
        for shell in shells:
            asked_of_fish(completions, directory) if shell == "fish" else typed_into(shell, completions, directory)
    all_options(program, completions)
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
