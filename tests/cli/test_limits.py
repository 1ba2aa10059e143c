#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the command makes of input that is too large, too deep, too far or meant to harm: the right status and message, in little time and memory."""
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import time

sys.dont_write_bytecode = True
from harness import TDSP, built, done, expect, expect_equal, expect_near, fails, main, scene, tdsp, test, write  # noqa: E402

# With strict_string_checks a sanitizer reads the whole text for each number in it, so that its time grows with the square of the size; and it takes much address space.
SANITIZED = "sanitize" in os.environ.get("TDSP", "")

ONE = '{"robot": {"speed": 1}, "source": [-10, 0], "destination": [10, 0], "discs": [{"center": [0, 0], "radius": %s, "growth": %s}]}'


def one_disc(radius="1", growth="0.1", file="one.json"):
    return write(file, ONE % (radius, growth))


def many_discs(count):
    """Discs on a spiral around the origin, none in another's way."""
    discs = ({"center": [round(3 * (i + 9)**0.5 * ((i * 7919 % 1000) / 500 - 1), 3), round(1.7 * (i + 9)**0.5, 3)], "radius": 0.001,
              "growth": 0.000001} for i in range(count))
    return '{"robot": {"speed": 1}, "source": [0, 0], "destination": [1, 0], "discs": [%s]}' % ",".join(map(json.dumps, discs))


def within(seconds, function, *arguments, **more):
    """In this time on an idle machine; what takes six times as long hangs or has become slow, whatever else the machine does."""
    seconds *= 6
    begin = time.monotonic()
    result = function(*arguments, **more)
    expect(time.monotonic() - begin < seconds, f"took {time.monotonic() - begin:.1f} s, not under {seconds}")
    return result


@test
def nesting_is_refused_by_its_depth_not_by_a_crash():
    for depth in 33, 1000, 200000:
        for begin, end in ("[", "]"), ('{"a":', "}"):
            within(10, fails, 3, ["nested too deeply"], "arrive", write("deep.json", begin * depth + "1" + end * depth), 0)
            within(10, fails, 3, ["nested too deeply"], "arrive", write("deep.json", begin * depth), 0)


@test
def files_of_nothing_in_particular_are_no_scene():
    for name, content in ("empty", b""), ("zeros", bytes(5000000)), ("spaces", b" " * 5000000), ("digits", b"7" * 5000000), ("magic", b"\x89TDSP\r\n\x1a"):
        for command in ("arrive", name, "0"), ("query", name, "0"), ("info", name), ("path", name, "0"), ("embed", name, "-o", "t.c"):
            write(name, content)
            within(20, fails, 3, [name], *command)


@test
def input_without_end_is_given_up_at_a_gibibyte():
    expect(os.path.exists("/dev/zero"), "no /dev/zero")
    for command in ("arrive", "/dev/zero", "0"), ("query", "/dev/zero", "0"):
        within(60, fails, 3, ["/dev/zero: longer than 1 GiB"], *command)


@test
def a_table_that_claims_more_than_there_is_memory_for_ends_with_a_message():
    data = pathlib.Path(built()).read_bytes()
    endless = f"(head -c 16 t.tdsp; printf '\\377\\377\\377\\377\\377\\377\\377\\377'; yes) | {TDSP} info -"
    if not SANITIZED:
        ended = subprocess.run(["bash", "-c", f"ulimit -v 1000000; {endless}"], capture_output=True, timeout=600)
        expect_equal(ended.returncode, 4, ended.stderr)
        expect(b"memory" in ended.stderr, ended.stderr)
    fails(3, ["longer than it says"], "info", write("more.tdsp", data + bytes(100000)))
    fails(3, ["longer than it says"], "info", "-", stdin=data + bytes(100000))


@test
def numbers_that_no_double_holds_are_refused_and_the_smallest_are_taken():
    for text in "NaN", "Infinity", "-Infinity", "1e999", "-1e999", "1e309", "0x10", "1e99999999999999999999", "1" + "0" * 400, "-1", "1e101":
        for file in one_disc(radius=text), one_disc(growth=text, file="two.json"):
            within(5, fails, 3, [file], "arrive", file, 0)
    for text in "1e-320", "1e-999", "-0", "-0.0", "1e-99999999999999999999", "0." + "0" * 1000000 + "1":
        answer = within(20, done, "arrive", one_disc(radius=text, growth="0"), 0, "--json").json["results"][0]
        expect_near(answer["arrival"], 20, 1e-9)
    expect_near(done("arrive", one_disc(radius="0." + "3" * 1000000, growth="0"), 0, "--json").json["results"][0]["arrival"], 20.0111121, 1e-6)


@test
def twice_the_same_key_is_an_error_however_many_keys_there_are():
    keys = ",".join(f'"k{i}": 1' for i in range(1000 if SANITIZED else 100000))
    text = (ONE % ("1", "0"))[:-1]
    result = within(60, done, "arrive", write("keys.json", f"{text}, {keys}}}"), 0)
    expect(result.err.count("\n") == 21 and "more unknown keys ignored" in result.err, f"{result.err.count(chr(10))} warnings")
    within(60, fails, 3, ["duplicate key: k0"], "arrive", write("keys.json", f'{text}, {keys}, "k0": 2}}'), 0)


@test
def names_cannot_command_a_terminal():
    evil = "\x1b[2J\x07\u009b31m\x7f"
    file = scene(units={"length": "m\x1b[2J\u009b", "time": "s\x07"}, name=evil, **{evil: 1})
    done("build", file, "-o", "t.tdsp")
    for command in (["arrive", file, 0], ["info", "t.tdsp"], ["build", file, "-o", "t.tdsp"], ["verify", file, "t.tdsp"], ["jumps", file], ["path", file, 0],
                    ["arrive", file, 0, "--json"], ["info", "t.tdsp", "--json"], ["plot", file, "-o", "p.svg"], ["arrive", "no\x1b[2Jfile", 0]):
        result = tdsp(*command)
        for text in result.out, result.err:
            expect(not any(c != "\n" and (ord(c) < 32 or 127 <= ord(c) < 160) for c in text), f"{command}: {text!r}")
    expect("m\\x1b[2J\\xc2\\x9b" in done("info", "t.tdsp").out, "the name is told, made plain")


@test
def an_embedded_table_is_code_whatever_its_names_are():
    done("build", scene(units={"length": "*/ #error /*", "time": "\\\n"}, name="*/ int x; /*"), "-o", "t.tdsp")
    done("embed", "t.tdsp", "-o", "t.c")
    text = pathlib.Path("t.c").read_text()
    expect("#error" not in text.replace("*/ #error /*", "") and "\\\n" not in text, text[:500])
    compiled = subprocess.run(["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "t.c"], capture_output=True)
    expect(compiled.returncode == 0, compiled.stderr.decode()[:500])


@test
def bounds_out_of_range_are_refused_at_once():
    file = scene()
    for options in (["--epsilon", "1e-300"], ["--epsilon", "0"], ["--epsilon", "nan"], ["--epsilon", "inf"], ["--epsilon", "1e300"],
                    ["--guarantee", "absolute", "--delta", "0"], ["--guarantee", "absolute", "--delta", "nan"], ["--horizon", "1e999"], ["--horizon", "-1"],
                    ["--threads", "1000000"], ["--threads", "0"], ["--max-rows", "0"], ["--max-rows", "16777217"], ["--max-rows", "1e3"]):
        within(5, fails, 2, [options[-2]], "build", file, "-o", "t.tdsp", *options)
        expect(not os.path.exists("t.tdsp"), "a file is left")


@test
def a_horizon_or_a_departure_at_the_end_of_the_doubles_is_answered_or_refused():
    file = scene()
    expect_equal(within(20, done, "build", file, "-o", "t.tdsp", "--horizon", "1e308", "--json").json["last_reason"], "destination_covered")
    answer = within(20, done, "arrive", file, "1e300", status=1).rows()[0]
    expect_equal(answer[-2], "source_covered")
    expect_equal(within(20, done, "depart", file, "1e308", "--json").json["results"][0]["status"], "ok")
    slow = one_disc(growth="1e-300")
    within(20, fails, 2, ["time"], "arrive", slow, "1e300")
    within(20, fails, 2, ["too many journeys away"], "build", slow, "-o", "t.tdsp")
    within(20, fails, 2, ["too many journeys away"], "build", slow, "-o", "t.tdsp", "--horizon", "1e300")
    within(20, done, "build", slow, "-o", "t.tdsp", "--horizon", "1e12")


@test
def the_largest_and_the_smallest_scene_are_built_and_verified():
    for a in "1e100", "1e99", "1e-100", "1e-200", "1e-300":
        gate = {"robot": {"speed": 1}, "source": [-float(a), 0], "destination": [float(a), 0],
                "discs": [{"center": [0, side * 0.3 * float(a)], "radius": 0.1 * float(a), "growth": 0.1} for side in (1, -1)]}
        write("gate.json", json.dumps(gate))
        within(20, done, "build", "gate.json", "-o", "gate.tdsp", "--epsilon", 0.1)
        within(20, done, "verify", "gate.json", "gate.tdsp")


@test
def rows_end_where_they_may_not_be_more():
    file = scene()
    for guarantee in (["--epsilon", "1e-9"], ["--guarantee", "absolute", "--delta", "1e-9"]):
        within(30, fails, 2, ["more than 1000 rows"], "build", file, "-o", "t.tdsp", "--max-rows", "1000", *guarantee)
        expect(not os.path.exists("t.tdsp"), "a file is left")
    done("build", file, "-o", "t.tdsp", "--max-rows", "100")


@test
def a_build_that_takes_too_long_can_be_ended_and_leaves_the_old_table():
    before = pathlib.Path(built()).read_bytes()
    for number in signal.SIGTERM, signal.SIGINT:
        running = subprocess.Popen([TDSP, "build", "scene.json", "-o", "t.tdsp", "--epsilon", "1e-9"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(0.5)
        running.send_signal(number)
        running.communicate(timeout=120)
        expect(running.returncode != 0, "ended by itself")
        expect_equal(pathlib.Path("t.tdsp").read_bytes() == before, True, "the old table")
        expect_equal(sorted(os.listdir(".")), ["scene.json", "t.tdsp"], "files")


@test
def a_hundred_thousand_discs_are_read_and_answered_in_bounded_time_and_memory():
    """The million of docs/testing.md in small, as memory and time go with the number of discs."""
    write("many.json", many_discs(1000 if SANITIZED else 100000))
    within(60, done, "arrive", "many.json", 0)
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    expect(SANITIZED or peak < 1500000, f"{peak} KB")


if __name__ == "__main__":
    main()
