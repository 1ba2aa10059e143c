#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What can be wrong with outputs and arguments of each command: a full disk, odd units, words that are none, and answers at the edges."""
import json
import os
import pathlib
import pty
import re
import subprocess

from harness import SCENES, TDSP, TWO_DISCS, built, done, expect, expect_equal, expect_near, fails, main, scene, test, write

# Two gates that close, one after the other.
GATES = [{"center": [x, y], "radius": r, "growth": 0.1} for x, r in ((-4, 1), (4, 0.5)) for y in (3, -3)]
ENDLESS = [{"center": [0, 50], "radius": 1, "growth": 1e-18}]  # which ends departures, but too far away to be computed with


def full(*arguments):
    with open("/dev/full", "w") as disk:
        return subprocess.run([TDSP, *map(str, arguments)], stdout=disk, stderr=subprocess.PIPE)


def matrix(*options):
    write("places.csv", "-10,0,gate\n10,0,A\n")
    return done("matrix", scene(), "--sources", "places.csv", "--destinations", "places.csv", "-o", "m.tdspm", "--horizon", 5, *options)


@test
def every_command_notices_a_full_standard_output_in_text_and_in_json():
    table = built()
    matrix()
    path = write("p.json", done("path", scene(), 5, "--json").out)
    for arguments in [("arrive", "scene.json", 0), ("depart", "scene.json", 30), ("path", "scene.json", 0), ("build", "scene.json", "-o", "b.tdsp"),
                      ("query", table, 1), ("info", table), ("info", "m.tdspm"), ("verify", "scene.json", path), ("verify", "scene.json", table),
                      ("plot", "scene.json", "-o", "a.svg"), ("embed", table, "-o", "a.c"), ("generate", "crowd", "--n", 3, "-o", "c.json"),
                      ("jumps", "scene.json"), ("envelope", "scene.json"), ("margin", "scene.json", 0),
                      ("matrix", "scene.json", "--sources", "places.csv", "--destinations", "places.csv", "-o", "m.tdspm", "--horizon", 5)]:
        for form in ([], ["--json"]):
            ended = full(*arguments, *form)
            said = b"cannot write standard output" in ended.stderr
            quiet = ended.returncode == 0 and not done(*arguments, *form).out  # nothing to say: nothing that fails
            expect(ended.returncode == 4 and said or quiet, (arguments, form, ended))


@test
def every_command_refuses_options_it_does_not_know_and_arguments_that_are_missing():
    for command in ("arrive", "depart", "path", "build", "query", "info", "verify", "plot", "embed", "generate", "jumps", "envelope", "margin", "matrix"):
        fails(2, ["--bogus"], command, "--bogus")
        fails(2, [f"tdsp {command} --help"], command)


@test
def words_and_numbers_that_are_none_are_usage_errors():
    scene()
    fails(2, ["--method", "sorcery"], "depart", "scene.json", 1, "--method", "sorcery")
    fails(2, ["departure", "soon"], "margin", "scene.json", "soon")
    fails(4, ["nowhere.json"], "margin", "nowhere.json", 1)
    fails(3, ["not.json"], "margin", "scene.json", "--path", write("not.json", "{"))
    fails(2, ["--delta", "much"], "build", "scene.json", "-o", "t", "--guarantee", "absolute", "--delta", "much")
    fails(2, ["--to", "there"], "arrive", "scene.json", 1, "--from", "0,0", "--to", "there")
    fails(2, ["--to go with", "is a table"], "path", built(), 1, "--to", "0,0")
    fails(2, ["--to go with a matrix"], "query", "t.tdsp", 1, "--to", "A")
    fails(2, ["at least", "thousand-millionth"][1:], "jumps", "scene.json", "--least", 1e-12)


@test
def a_journey_that_takes_no_time_has_no_geometric_table():
    fails(2, ["takes time"], "build", scene(source=[10, 0]), "-o", "t", "--guarantee", "arrival", "--sampling", "geometric")


@test
def units_that_no_table_holds_are_named():
    for unit in ("length", "time"):
        units = {"length": "m", "time": "s", unit: "sixteen letters!"}
        fails(3, ["units." + unit, "15 bytes"], "build", scene(units=units), "-o", "t")
    fails(3, ["units.time"], "arrive", scene(units={"length": "m", "time": 7}), 1)


@test
def departures_and_ends_too_far_away_are_told():
    file = scene(discs=ENDLESS, source=[0, 0])
    fails(2, ["not supported"], "arrive", file, 1e15)
    fails(2, ["--horizon"], "jumps", file)
    fails(2, ["--horizon"], "envelope", file)


@test
def growth_that_is_no_array_where_one_is_meant_is_refused():
    for growth, word in [({"times": 5, "rates": [1]}, "times"), ({"times": [0], "rates": 5}, "rates"), ({"times": [0], "rates": ["fast"]}, "rates"),
                         ({"rates": [1]}, "times"), ({"times": [0]}, "rates"), (["fast"], "growth")]:
        fails(3, [word], "arrive", scene(discs=[{"center": [0, 3], "radius": 1, "growth": growth}]), 1)


@test
def journeys_out_of_range_are_refused_with_their_place():
    fails(3, ["scene.json"], "arrive", scene(destination=[1e200, 0]), 1)
    fails(3, ["source"], "arrive", scene(source=["a", 0]), 1)
    fails(3, ["source"], "arrive", scene(source=[0, "b"]), 1)


@test
def places_of_a_matrix_are_read_with_care():
    scene()
    good = write("good.csv", "0,0\n")
    def refused(status, words, sources, destinations, *options):
        arguments = [*(["--sources", sources] if sources else []), *(["--destinations", destinations] if destinations else [])]
        fails(status, words, "matrix", "scene.json", *arguments, "-o", "m.tdspm", "--horizon", 5, *options)
        expect(not os.path.exists("m.tdspm"), "left behind")
    refused(2, ["--sources"], None, good)
    refused(2, ["--destinations"], good, None)
    refused(3, ["low.csv:1", "1e100"], write("low.csv", "0,-1e101\n"), good)
    refused(3, ["high.csv:2", "1e100"], good, write("high.csv", "0,0\n1e101,0\n"))
    refused(3, ["zero.csv", "zero byte"], good, write("zero.csv", b"0,0\n\0\n"))
    refused(4, ["nowhere.csv"], "nowhere.csv", good)
    refused(2, ["good.csv"], good, good, "-o", "good.csv")
    fails(4, ["nowhere.json"], "matrix", "nowhere.json", "--sources", good, "--destinations", good, "-o", "m.tdspm")
    fails(3, ["units.length"], "matrix", scene(units={"length": "sixteen letters!"}), "--sources", good, "--destinations", good, "-o", "m.tdspm")


@test
def a_matrix_without_any_way_is_not_written():
    write("in.csv", "0,3\n")
    write("out.csv", "10,0\n")
    arguments = ("matrix", scene(), "--sources", "in.csv", "--destinations", "out.csv", "-o", "m.tdspm", "--horizon", 5)
    fails(1, ["nothing to build"], *arguments)
    report = done(*arguments, "--json", status=1).json
    expect_equal([report["tables"], report["matrix"]], [0, None])
    expect(not os.path.exists("m.tdspm"), "left behind")


@test
def a_matrix_with_an_absolute_guarantee_names_its_delta():
    report = json.loads(matrix("--guarantee", "absolute", "--delta", 0.5, "--json").out)
    expect_equal([report["guarantee"], report["epsilon"], report["delta"]], ["absolute", None, 0.5])
    expect("tables" in matrix().out, "text")


@test
def a_matrix_that_cannot_be_built_or_written_says_for_which_pair():
    write("places.csv", "0,0\n0,1\n")
    fails(2, ["source 0 to destination 0", "--horizon"], "matrix", scene(discs=[]), "--sources", "places.csv", "--destinations", "places.csv", "-o", "m.tdspm")
    os.mkdir("folder")
    fails(4, ["folder"], "matrix", scene(), "--sources", "places.csv", "--destinations", "places.csv", "--horizon", 5, "-o", "folder")


@test
def a_name_that_two_places_share_needs_a_number():
    write("from.csv", "-10,0,gate\n-10,1,gate\n-10,2\n")
    write("to.csv", "10,0,A\n")
    done("matrix", scene(), "--sources", "from.csv", "--destinations", "to.csv", "-o", "m.tdspm", "--horizon", 5)
    fails(2, ["more than one", "gate"], "query", "m.tdspm", 1, "--from", "gate", "--to", "A")
    fails(2, ["--to", "no name"], "query", "m.tdspm", 1, "--from", 1, "--to", "B")
    done("query", "m.tdspm", 1, "--from", 1, "--to", "A")
    fails(2, ["--deep"], "verify", "scene.json", "m.tdspm", "--deep", 3)


@test
def a_table_without_units_prints_none():
    plain = {key: value for key, value in TWO_DISCS.items() if key != "units"}
    for units in ({}, {"units": {"length": "m"}}, {"units": {"time": "s"}}):
        write("plain.json", json.dumps({**plain, **units}))
        done("build", "plain.json", "-o", "p.tdsp")
        text = done("info", "p.tdsp").out
        expect_equal("m/s" in text, False, text)
        lines = dict(re.split(r"  +", line, maxsplit=1) for line in text.splitlines() if re.match(r"\S+( \S+)*  +\S", line))
        expect_near(float(lines["speed"].split()[0]), 1, 0, text)
        expect(" s" in lines["last departure"] if "time" in units.get("units", {}) else " s" not in lines["last departure"], text)
        for what in ("plain.json", "p.tdsp"):
            done("plot", what, "-o", "a.svg")
            expect("nan" not in pathlib.Path("a.svg").read_text(), what)


@test
def info_tells_the_bound_of_an_absolute_guarantee():
    text = done("info", built("--guarantee", "absolute", "--delta", 0.25)).out
    expect(re.search(r"delta +0\.25", text), text)


@test
def an_empty_file_is_neither_scene_nor_table():
    for command in ("info", "query"):
        fails(3, ["empty"], command, write("empty", ""), *(["1"] if command == "query" else []))


@test
def pieces_with_several_rides_list_them():
    file = scene(discs=GATES)
    pieces = done("envelope", file, "--json").json["pieces"]
    most = max(len(piece["rides"]) for piece in pieces)
    expect(most > 1, pieces)
    text = done("envelope", file).out
    for piece in pieces:
        expect(", ".join(f"{ride['disc']} {ride['turn']}" for ride in piece["rides"]) in text, (piece, text))


@test
def a_robot_that_is_there_has_no_leg_to_be_on():
    file = scene(source=[10, 0])
    expect_equal(done("path", file, 1, "--json").json["legs"], [])
    fails(1, ["no leg"], "path", file, 1, "--at", 1)
    done("build", file, "-o", "s.tdsp")
    expect_equal(done("path", "s.tdsp", 1, "--json").json["legs"], [])
    for what in (file, "s.tdsp"):
        done("plot", what, "-o", "a.svg")
    done("verify", file, "s.tdsp", "--deep", 3)


@test
def verify_deep_finds_what_is_better_than_the_best():
    write("p.json", done("path", scene(), 12, "--json").out)
    expect("1 times the least" in done("verify", "scene.json", "p.json", "--deep", 1).out, "deep")
    slower = scene("slower.json", discs=[{**disc, "radius": 1.5} for disc in TWO_DISCS["discs"]])
    result = done("verify", slower, "p.json", "--deep", 1, "--json", status=1).json
    expect(any("before the earliest arrival" in problem for problem in result["problems"]), result)
    closed = scene("closed.json", discs=[{"center": [10, 0], "radius": 1, "growth": 0.1}])
    result = done("verify", closed, "p.json", "--deep", 1, "--json", status=1).json
    expect(any("finds no path" in problem for problem in result["problems"]), result)


@test
def verify_deep_finds_tables_of_another_world():
    table = built()
    for name, change, words in [("larger.json", {"radius": 1.5}, "is outside"), ("smaller.json", {"radius": 0.5}, "is outside"),
                                ("covered.json", {"center": [10, 0]}, "the solver has none")]:
        other = scene(name, discs=[{**disc, **change} for disc in TWO_DISCS["discs"]])
        result = done("verify", other, table, "--deep", 5, "--json", status=1).json
        expect(any(words in problem for problem in result["problems"]), (name, result))


@test
def names_that_json_must_escape_read_back():
    odd = 'a "b" \\ c\t.tdsp'
    expect_equal(done("build", scene(), "-o", odd, "--json").json["table"], odd)


@test
def a_deadline_before_any_arrival_has_no_latest_departure():
    one = done("margin", scene(), 1, "--deadline", 5, "--json", status=1).json["results"][0]
    expect_equal([one["latest"][key] for key in ("departure", "arrives", "status", "limit", "disc")], [None, None, "arrival_too_early", "none", None])


@test
def pictures_of_many_jumps_name_the_largest_and_info_counts_the_rest():
    places = [1.5]
    while len(places) < 14:
        places.append(places[-1] + 3 + 0.3 * len(places))  # a wall whose gaps close one after the other, from the middle outwards
    gates = [{"center": [0, side * y], "radius": 1, "growth": 0.01} for y in places for side in (1, -1)]
    for units in (TWO_DISCS["units"], {"length": "", "time": ""}):
        file = scene(discs=gates, units=units, name="a name so long that no title holds it " * 10)
        done("build", file, "-o", "t.tdsp", "--epsilon", 0.02)
        jumps = done("info", "t.tdsp", "--json").json["jumps"]
        expect(len(jumps) > 10, jumps)
        expect(f"and {len(jumps) - 10} more" in done("info", "t.tdsp").out, "info")
        for what in (file, "t.tdsp"):
            done("plot", what, "-o", "a.svg", "--depart", 1)
            picture = pathlib.Path("a.svg").read_text()
            expect(picture.startswith("<?xml") and "nan" not in picture, what)


@test
def a_matrix_is_verified_pair_by_pair():
    write("from.csv", "-10,0,gate\n0,3,covered\n")
    write("to.csv", "10,0,A\n")
    done("matrix", scene(), "--sources", "from.csv", "--destinations", "to.csv", "-o", "m.tdspm", "--horizon", 5)
    far = [{"center": [0, 50], "radius": 1, "growth": 0.1}]
    result = done("verify", scene("free.json", discs=far), "m.tdspm", "--json", status=1).json
    expect(any("but the source is free" in problem for problem in result["problems"]), result)
    on_gate = [{"center": [-10, 0], "radius": 1, "growth": 0.1}]
    result = done("verify", scene("gate.json", discs=on_gate), "m.tdspm", "--json", status=1).json
    expect(any("another scene" in problem for problem in result["problems"]), result)
    done("matrix", scene("alone.json", discs=[]), "--sources", "from.csv", "--destinations", "to.csv", "-o", "n.tdspm", "--horizon", 5)
    expect(done("verify", "alone.json", "n.tdspm", "--json").json["ok"], "no disc at all")


@test
def scenes_without_size_or_discs_are_drawn():
    for discs in ([], [{"center": [0, 0], "radius": 0, "growth": 0}]):
        file = scene(discs=discs)
        done("plot", file, "-o", "a.svg")
        done("plot", file, "-o", "a.png", "--depart", 3)
        expect(pathlib.Path("a.png").read_bytes().startswith(b"\x89PNG"), "png")
    fails(2, ["--from and --to go with"], "plot", built(), "-o", "a.svg", "--from", "0,0")


@test
def links_to_outputs_are_followed_also_by_their_whole_names():
    done("build", scene(), "-o", "there.tdsp")
    os.symlink(os.path.abspath("there.tdsp"), "link.tdsp")
    before = pathlib.Path("there.tdsp").read_bytes()
    done("build", "scene.json", "-o", "link.tdsp", "--epsilon", 0.5)
    expect(os.path.islink("link.tdsp") and pathlib.Path("there.tdsp").read_bytes() != before, "the link was replaced")


@test
def help_for_what_is_no_command_suggests_one():
    fails(2, ["arrive"], "arive")


def with_terminal(*arguments):
    """Run with standard error on a terminal; the exit status and what came there."""
    master, slave = pty.openpty()
    running = subprocess.Popen([TDSP, *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=slave)
    os.close(slave)
    seen = b""
    while True:
        try:
            part = os.read(master, 65536)
        except OSError:
            break
        if not part:
            break
        seen += part
    os.close(master)
    return running.wait(60), seen


@test
def on_a_terminal_the_bar_grows_and_is_gone_when_the_work_is_done():
    done("generate", "crowd", "--n", 250, "--seed", 3, "--growth", 0.05, "-o", "crowd.json")
    status, seen = with_terminal("build", "crowd.json", "-o", "t.tdsp", "--epsilon", 1e-4, "--threads", 1)
    expect_equal(status, 0)
    shares = [int(share) for share in re.findall(rb"\] +(\d+) %", seen)]
    expect(shares and shares == sorted(shares), seen[-300:])
    expect(b"build [" in seen and b" left" in seen, seen[-300:])
    expect(seen.endswith(b"\r\x1b[K"), seen[-100:])
    status, seen = with_terminal("build", scene(), "-o", "t.tdsp", "--epsilon", 0.1)
    expect_equal((status, seen), (0, b""))  # done before there is anything to show


main()
