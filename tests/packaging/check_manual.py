#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Hold the manual to the program: check_manual.py COMMAND MAN

COMMAND is the program tdsp, MAN the directory of its pages. The program's own --help, which GOption writes, is the measure: each option that it names
is in what `tdsp help --json` tells and in the OPTIONS of the page, and no other. Pages are linted by mandoc, and by man where that is installed.
"""
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/install"))
import described  # noqa: E402
import headers  # noqa: E402

failed = 0


def check(sentence, problems):
    global failed
    print(f"{'not ok' if problems else 'ok'} manual: {sentence}")
    for problem in problems:
        print(f"    {problem}")
    failed += bool(problems)


def output(*arguments):
    return subprocess.run(arguments, check=True, capture_output=True, text=True).stdout


def options_of_help(program, command):
    """Each line of an option: "-o, --output=TABLE" or "--json"."""
    found = set()
    for line in output(program, command, "--help").splitlines():
        match = re.match(r"  (?:(-\w), )?(--[a-z-]+)", line)
        if match:
            found |= {flag for flag in match.groups() if flag}
    return found


def options_of_page(page):
    """The terms of the section OPTIONS as mandoc shows them."""
    shown = output("mandoc", "-T", "ascii", str(page))
    shown = re.sub(r".\x08", "", shown)
    section = re.search(r"^OPTIONS\n(.*?)^\S", shown, re.M | re.S)[1]
    return {flag for line in section.splitlines() if (match := re.match(r"       ?(-\S.*)", line))
            for flag in re.findall(r"(?<!\S)--?[a-z][a-z-]*", match[1].split("  ")[0])}


def differences(found, wanted, where):
    return [f"{where}: {flag} is missing" for flag in sorted(wanted - found)] + [f"{where}: {flag} is no option" for flag in sorted(found - wanted)]


def lint(page):
    """mandoc's warnings, but for the empty paragraphs that scdoc writes after each heading and before each list."""
    done = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", str(page)], capture_output=True, text=True)
    return [line for line in done.stdout.splitlines() if "skipping paragraph macro" not in line]


def groff(page):
    """What man itself complains of."""
    done = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", str(page)], capture_output=True, text=True, env={
        "LC_ALL": "C.UTF-8", "MANWIDTH": "80", "PATH": "/usr/bin:/bin"})
    return [f"{page.name}: {line}" for line in done.stderr.splitlines()]


def documented_options(cli):
    """Every --option that docs/cli.md names."""
    return set(re.findall(r"--[a-z][a-z-]*", cli))


def main(program, man):
    man = pathlib.Path(man)
    _, commands = described.ask(program)
    cli = (ROOT / "docs/cli.md").read_text(encoding="utf-8")
    pages = sorted(page for page in man.glob("*.[135]") if not page.is_symlink())
    listed = re.findall(r"^  (?!tdsp )(\w+) +[A-Z]", output(program, "--help"), re.M)
    check("help --json tells every command that --help lists", differences({one.name for one in commands}, set(listed), "help --json"))
    helped = {command.name: options_of_help(program, command.name) for command in commands}
    check("help --json tells every option of --help and no other", [problem for command in commands for problem in differences(
        {flag for option in command.options for flag in option.flags}, helped[command.name], command.name)])
    check("each option is in the page of its command and no other", [problem for command in commands for problem in differences(
        options_of_page(man / f"tdsp-{command.name}.1"), helped[command.name], command.name)])
    check("an option that takes a file names an argument that is one", [
        f"{command.name} --{option.long} {option.name}" for command in commands for option in command.options
        if option.takes_file != any(value.is_file for value in option.values)])
    check("help COMMAND --json tells that command alone", [name for name in listed if [one.name for one in described.parse(
        output(program, "help", name, "--json"))[1]] != [name]])
    check("docs/cli.md has a section for each command", [name for name in listed if f"\n## {name}\n" not in cli])
    check("docs/cli.md names every option", [f"{command} {flag}" for command, flags in helped.items() for flag in sorted(flags)
                                             if flag.startswith("--") and flag not in documented_options(cli)])
    check("each function has a page", [name for file in sorted((ROOT / "include/tdsp").glob("*.h")) for name in headers.functions(file.read_text())
                                       if (man / f"{name}.3").resolve() != (man / "libtdsp.3").resolve()])
    check("libtdsp(3) has each function", [name for file in sorted((ROOT / "include/tdsp").glob("*.h")) for name in headers.functions(file.read_text())
                                           if name not in (man / "libtdsp.3").read_text().replace("\\_", "_")])
    check("mandoc has no complaint", [line for page in pages for line in lint(page)])
    if shutil.which("man"):
        check("man has no complaint", [line for page in pages for line in groff(page)])
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
