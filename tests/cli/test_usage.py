#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the command says of itself, and what it says when it is called wrongly."""
import re

from harness import ROOT, add, done, expect, expect_equal, fails, main, scene, tdsp, test

COMMANDS = ["arrive", "depart", "path", "build", "query", "info", "verify", "plot", "view", "embed", "generate"]


@test
def without_a_command_the_commands_are_listed_and_it_is_a_usage_error():
    result = fails(2, COMMANDS)
    expect("usage:" in result.err, result)


@test
def help_lists_every_command():
    result = done("--help")
    for command in COMMANDS:
        expect(re.search(rf"^  {command} ", result.out, re.M), f"{command} is not listed")
    expect_equal(done("-h").out, result.out)
    expect_equal(done("help").out, result.out)


@test
def version_is_the_library_s_version():
    header = (ROOT / "include/tdsp/export.h").read_text()
    version = re.search(r'VERSION_STRING "(.*)"', header)[1]
    expect_equal(done("--version").out, f"tdsp {version}\n")


@test
def a_mistyped_command_suggests_the_nearest():
    for typed, meant in [("biuld", "build"), ("qurey", "query"), ("arive", "arrive"), ("plto", "plot"), ("departs", "depart")]:
        fails(2, [typed, f'did you mean "{meant}"?'], typed)


@test
def a_foreign_word_suggests_nothing():
    result = fails(2, ['no command "frobnicate"', "--help"], "frobnicate")
    expect("did you mean" not in result.err, result)


def help_of(command):
    def check():
        result = done(command, "--help")
        expect(re.search(rf"Examples?:\n  tdsp {command} ", result.out), "no example")
        expect("--json" in result.out, "no --json")
        expect(f"tdsp {command} " in result.out, "no usage")
        expect_equal(done("help", command).out, result.out)
    return check


def usage_of(command):
    def check():
        fails(2, ["Unknown option", "--frobnicate", f"tdsp {command} --help"], command, "--frobnicate")
        fails(2, [f"tdsp {command}"], command)
    return check


for name in COMMANDS:
    add(f"{name} explains itself with an example", help_of(name))
    add(f"{name} refuses unknown options and missing arguments", usage_of(name))


@test
def help_of_an_unknown_command_is_a_usage_error():
    fails(2, ['no command "biuld"'], "help", "biuld")


@test
def times_must_be_plain_finite_numbers_that_are_not_negative():
    file = scene()
    for text in ["nan", "inf", "infinity", "0x10", "1e999", "", "1,5", "12abc", "1e", ".", "--", " 1"]:
        result = tdsp("arrive", file, "--", text)
        expect(result.status == 2 and result.out == "", f"departure {text!r}: {result}")
    fails(2, ["departure", "-5", "negative"], "arrive", file, "--", "-5")
    fails(2, ["-5"], "arrive", file, "-5")
    fails(2, ["arrival", "negative"], "depart", file, "--", "-1e-300")
    fails(2, ["departure"], "path", file, "x")
    fails(2, ["--at"], "path", file, "0", "--at", "never")
    fails(2, ["--depart"], "plot", file, "-o", "a.svg", "--depart", "x")


@test
def times_may_be_written_in_every_decimal_way():
    file = scene()
    for text in ["1", "+1", "1.", "1.0", "01", "10e-1", ".1E1"]:
        expect_equal(done("arrive", file, text).rows()[0][:2], ["1", "21"], text)
    expect_equal(done("arrive", file, "--", "-0").rows()[0][0], "0")


@test
def too_many_arguments_are_a_usage_error():
    file = scene()
    for arguments in [("path", file, 1, 2), ("build", file, file, "-o", "t"), ("info", file, file), ("verify", file, file, file),
                      ("plot", file, file, "-o", "a.svg"), ("embed", file, file, "-o", "a.c"), ("generate", "crowd", "wall")]:
        fails(2, ["too many arguments"], *arguments)


@test
def help_tells_programs_all_commands_or_one():
    told = done("help", "--json").json
    expect(set(COMMANDS) <= {command["name"] for command in told["commands"]}, told)
    expect_equal([command["name"] for command in done("help", "query", "--json").json["commands"]], ["query"])
    expect_equal(done("help", "--json", "query").out, done("help", "query", "--json").out)


@test
def help_tells_words_and_endings_for_the_names_of_arguments():
    arguments = done("help", "--json").json["arguments"]
    expect_equal(arguments["GUARANTEE"], {"words": ["travel", "arrival", "absolute"]})
    expect_equal(arguments["SCENE"], {"file": "json"})
    for kind in arguments["KIND"]["words"]:
        done("generate", kind)


@test
def help_of_two_commands_or_of_none_that_is_known_is_a_usage_error():
    fails(2, ["too many arguments"], "help", "query", "info")
    fails(2, ['did you mean "query"?'], "help", "qurey", "--json")


@test
def outputs_must_be_named():
    file = scene()
    fails(2, ["-o"], "build", file)
    fails(2, ["-o"], "plot", file)
    fails(2, ["-o"], "embed", file)
    fails(2, ["-o"], "build", file, "-o", "-")
    fails(2, ["-o"], "build", file, "-o", "")


@test
def errors_begin_with_the_command_they_are_of():
    expect(done("build", "x", status=2).err.startswith("tdsp build: "), "no name")
    expect(done("info", "missing", status=4).err.startswith("tdsp info: "), "no name")


main()
