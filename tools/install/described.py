# SPDX-License-Identifier: MIT
"""What `tdsp help --json` tells of the command: the one source of manual pages and completions."""
import dataclasses
import json
import re
import subprocess


@dataclasses.dataclass(frozen=True)
class Value:
    """What may stand for an argument: words to choose from, a file (with the ending that is its custom, or ""), or neither."""
    name: str
    words: tuple = ()
    ending: str | None = None

    @property
    def is_file(self):
        return self.ending is not None


@dataclasses.dataclass(frozen=True)
class Option:
    long: str
    short: str | None
    values: tuple  # of Value: the alternatives of "SCENE|TABLE"; empty when it takes none
    name: str | None  # of what it takes, as shown
    may_lack: bool
    takes_file: bool
    text: str

    @property
    def flags(self):
        return ([f"-{self.short}"] if self.short else []) + [f"--{self.long}"]


@dataclasses.dataclass(frozen=True)
class Positional:
    name: str
    values: tuple
    many: bool


@dataclasses.dataclass(frozen=True)
class Command:
    name: str
    arguments: str
    summary: str
    help: str
    options: tuple
    positionals: tuple


def _values(name, known):
    values = []
    for part in name.removesuffix("...").split("|"):
        of = known.get(part, {})
        values.append(Value(part, tuple(of.get("words", ())), of.get("file")))
    return tuple(values)


def _option(of, known):
    values = _values(of["value"], known) if of["takes"] else ()
    return Option(of["long"], of["short"], values, of["value"] if of["takes"] else None, of["value_may_lack"],
                  of["takes"] == "file", of["text"])


def _positionals(arguments, known):
    """The arguments that are no options: "SCENE -o TABLE" has one."""
    without_options = re.sub(r"--?[a-z][a-z-]* \S+|[][]", "", arguments)
    return tuple(Positional(word.removesuffix("..."), _values(word, known), word.endswith("...")) for word in without_options.split())


def parse(text):
    """The version and the commands, from the output of `tdsp help --json`."""
    told = json.loads(text)
    known = told["arguments"]
    commands = tuple(
        Command(of["name"], of["arguments"], of["summary"], of["help"], tuple(_option(option, known) for option in of["options"]),
                _positionals(of["arguments"], known))
        for of in told["commands"])
    return told["version"], commands


def ask(program):
    return parse(subprocess.run([program, "help", "--json"], check=True, capture_output=True, text=True, encoding="utf-8").stdout)
