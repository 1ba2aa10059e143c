#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write the manual pages as scdoc: man.py COMMAND OUTPUT

COMMAND is the program tdsp. A page of a command has its options from the program itself, its prose from docs/cli.md; those of the table and the scene
file are docs/format.md and a part of docs/cli.md; that of the library is its headers. So a page cannot say what they do not.

Every function of the library has a link to libtdsp(3) under its name.
"""
import functools
import pathlib
import re
import sys

import described
import headers
import markdown

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
EXIT_STATUSES = "The exit statuses are those of *tdsp*(1): 0 done, 1 the answer is no, 2 usage, 3 invalid input, 4 the system failed.\n"


def link(commands, target):
    """What stands for a link of the documentation: the manual page of the same subject."""
    file, _, anchor = target.partition("#")
    if file == "format.md":
        return "*tdsp-table*(5)"
    if not file and anchor == "the-scene-file":
        return "*tdsp-scene*(5)"
    if not file and anchor in {command.name for command in commands}:
        return f"*tdsp-{anchor}*(1)"
    return None


def sections(text):
    """The parts of a Markdown file by their heading; what stands before the first is under ""."""
    parts = re.split(r"^## (.*)$", text, flags=re.M)
    return {"": parts[0].partition("\n")[2]} | dict(zip(parts[1::2], parts[2::2]))


def header(name, section, version):
    return f'{name}({section}) "libtdsp {version}" "libtdsp"\n\n'


def argument_of(option):
    if not option.name:
        return ""
    return f"[={markdown.escape(option.name)}]" if option.may_lack else f" {markdown.escape(option.name)}"


def synopsis(command):
    """The arguments as the program's usage has them, then the options that these do not name."""
    named = re.findall(r"--?([a-z][a-z-]*)", command.arguments)
    rest = [f"[*{markdown.escape('--' + option.long)}*{argument_of(option)}]" for option in command.options
            if option.long not in named and option.short not in named]
    arguments = re.sub(r"(?<!\S)(--?[a-z][a-z-]*)", lambda found: f"*{found[1]}*", markdown.escape(command.arguments))
    return f"*tdsp {command.name}* {arguments} {' '.join(rest)}\n"


def option_rows(text):
    """From a section's table of options: name -> [(value or "", what it means)]."""
    rows = {}
    for kind, lines in markdown.blocks(text):
        if kind == "table" and markdown.cells(lines[0])[0] == "option":
            for name, meaning in map(markdown.cells, lines[2:]):
                option, _, value = name.strip("`").partition(" ")
                rows.setdefault(option.removeprefix("--"), []).append((value, meaning))
    return rows


def option_text(option, rows, linked):
    """The documentation's words where it has some, else the program's."""
    found = rows.get(option.long, [])
    if len(found) == 1 and not (found[0][0].islower()):
        return f"\t{markdown.inline(found[0][1], linked)}\n"
    values = "".join(f"\n\t*{markdown.escape(value)}*: {markdown.inline(meaning, linked)}\n" for value, meaning in found)
    return f"\t{markdown.escape(option.text)}\n{values}"


def options(command, rows, linked):
    written = []
    for option in command.options:
        flags = ", ".join(f"*{markdown.escape(flag)}*" for flag in option.flags)
        written.append(f"{flags}{argument_of(option)}\n{option_text(option, rows, linked)}\n")
    return "".join(written)


def description(text, linked):
    """A section of docs/cli.md without what OPTIONS says and without the usage it opens with."""
    written = []
    for number, (kind, lines) in enumerate(markdown.blocks(text)):
        is_usage = number == 0 and kind == "code"
        is_options = kind == "table" and markdown.cells(lines[0])[0] == "option"
        if not is_usage and not is_options:
            written.append(markdown.render(kind, lines, linked) + "\n")
    return "".join(written)


def examples(command):
    """The lines of the program's help behind "Examples:"."""
    lines = re.split(r"^Examples?:\n", command.help, flags=re.M)
    return "```\n" + "\n".join(line.removeprefix("  ") for line in lines[1].splitlines()) + "\n```\n" if len(lines) > 1 else ""


def command_page(command, version, text, linked):
    prose = description(text, linked) if text else markdown.escape(command.help.partition("\n\n")[0].replace("\n", " ")) + "\n\n"
    return (header(f"tdsp-{command.name}", 1, version) + f"# NAME\n\ntdsp-{command.name} - {markdown.escape(command.summary)}\n\n"
            f"# SYNOPSIS\n\n{synopsis(command)}\n# DESCRIPTION\n\n{prose}# OPTIONS\n\n{options(command, option_rows(text or ''), linked)}"
            f"# EXAMPLES\n\n{examples(command)}\n# EXIT STATUS\n\n{EXIT_STATUSES}\n"
            "# SEE ALSO\n\n*tdsp*(1), *tdsp-scene*(5), *tdsp-table*(5)\n")


def overview_page(commands, version, cli, linked):
    """tdsp(1): the commands, and what they share."""
    listed = "".join(f"*tdsp-{command.name}*(1) {markdown.escape(command.arguments)}\n\t{markdown.escape(command.summary)}\n\n" for command in commands)
    return (header("tdsp", 1, version) + "# NAME\n\ntdsp - earliest arrivals among growing discs, and tables of them\n\n"
            "# SYNOPSIS\n\n*tdsp* COMMAND ARGUMENTS [OPTIONS]\n\n*tdsp help* [COMMAND] [*--json*]\n\n*tdsp* *--help*\n\n*tdsp* *--version*\n\n"
            "# DESCRIPTION\n\nA robot with a known top speed travels from a source to a destination among discs that grow. *tdsp* finds when it arrives and when it "
            "must leave, exactly, and packs the answers to all departures into a table that any program looks up in nanoseconds.\n\n"
            f"# COMMANDS\n\n{listed}# WHAT ALL COMMANDS SHARE\n\n{markdown.convert(cli['What all commands share'], linked)}"
            "# SEE ALSO\n\n*tdsp-scene*(5), *tdsp-table*(5), *libtdsp*(3)\n")


def scene_page(version, cli, linked):
    return (header("tdsp-scene", 5, version) + "# NAME\n\ntdsp-scene - scenes of growing discs, as JSON\n\n# DESCRIPTION\n\n"
            + markdown.convert(cli["The scene file"], linked) + "# SEE ALSO\n\n*tdsp*(1), *tdsp-generate*(1)\n")


def table_page(version, linked):
    text = (DOCS / "format.md").read_text(encoding="utf-8")
    return (header("tdsp-table", 5, version) + "# NAME\n\ntdsp-table - the table file of tdsp, to the byte\n\n# DESCRIPTION\n\n"
            + markdown.convert(text.partition("\n")[2], linked) + "# SEE ALSO\n\n*tdsp*(1), *tdsp-build*(1), *tdsp-matrix*(1), *libtdsp*(3)\n")


def comment_text(comment):
    """A comment's paragraphs; a parameter or a result is a term of its own."""
    written = []
    for part in re.split(r"\n\s*\n|\n(?=@)", comment):
        tag = re.match(r"@(param \w+|return)\s+", part)
        if not tag:
            written.append(f"{markdown.inline(' '.join(part.split()))}\n")
            continue
        name = "Returns" if tag[1] == "return" else tag[1].removeprefix("param ")
        written.append(f"*{markdown.escape(name)}*\n\t{markdown.inline(' '.join(part[tag.end():].split()))}\n")
    return "\n".join(written)


def library_page(version, files):
    written = [header("libtdsp", 3, version), "# NAME\n\nlibtdsp - shortest paths among growing discs, at any time of departure\n\n",
               "# LIBRARY\n\n```\n#include <tdsp/tdsp.h>\n\ncc program.c $(pkg-config --cflags --libs tdsp)\n```\n\n",
               "Firmware that only reads tables links *libtdsp-query* (pkg-config *tdsp-query*): no heap, no stdio, no state.\n\n",
               "# DESCRIPTION\n\nEach header has a section below: what it is for, then each declaration with what it promises. ",
               "Functions that can fail return a *tdsp\\_status* and leave their results untouched on failure.\n\n"]
    for file in files:
        text = file.read_text(encoding="utf-8")
        found = headers.declarations(text)
        if not found or file.name == "export.h":
            continue
        written.append(f"# TDSP/{file.name.upper()}\n\n{comment_text(headers.purpose(text))}\n")
        written += [f"```\n{re.sub('^TDSP_API ', '', one.shown(), flags=re.M)}\n```\n\n{comment_text(one.comment)}\n" for one in found]
    return "".join(written + ["# SEE ALSO\n\n*tdsp*(1), *tdsp-table*(5)\n"])


def main(program, output):
    version, commands = described.ask(program)
    output = pathlib.Path(output)
    cli = sections((DOCS / "cli.md").read_text(encoding="utf-8"))
    linked = functools.partial(link, commands)
    files = sorted((ROOT / "include/tdsp").glob("*.h"))
    pages = {"tdsp.1": overview_page(commands, version, cli, linked), "tdsp-scene.5": scene_page(version, cli, linked),
             "tdsp-table.5": table_page(version, linked), "libtdsp.3": library_page(version, files)}
    for command in commands:
        pages[f"tdsp-{command.name}.1"] = command_page(command, version, cli.get(command.name), linked)
    output.mkdir(parents=True, exist_ok=True)
    for old in output.iterdir():
        old.unlink()
    for name, page in pages.items():
        (output / f"{name}.scd").write_text(re.sub(r"\n{3,}", "\n\n", page), encoding="utf-8")
    for file in files:
        for function in headers.functions(file.read_text(encoding="utf-8")):
            (output / f"{function}.3").symlink_to("libtdsp.3")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
