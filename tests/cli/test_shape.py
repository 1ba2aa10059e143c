#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The shape of the arrival: its jumps and its pieces."""
from harness import GAP_CLOSES, LAST, SCENES, done, expect, expect_equal, expect_near, fails, main, scene, test, write

RADIUS = 3 / 0.99**0.5  # of both discs when their corner is as slow as the robot


def is_the_gap(of):
    expect_equal([of["first"], of["second"]], [0, 1])
    expect_near(of["time"], (RADIUS - 1) / 0.1, 1e-7)
    expect_near(of["place"][0], 0.1 * RADIUS, 1e-7)
    expect_near(of["place"][1], 0, 1e-7)


@test
def the_jump_of_two_discs_is_found_with_its_gap():
    found = done("jumps", scene(), "--json").json
    expect_equal([found["status"], len(found["jumps"])], ["ok", 1])
    jump = found["jumps"][0]
    expect_near(jump["departure"], GAP_CLOSES, 1e-9)
    expect_near(jump["before"], 20, 1e-9)
    expect_near(jump["size"], jump["after"] - jump["before"], 0)
    is_the_gap(jump)


@test
def jumps_come_as_text_too():
    rows = done("jumps", scene()).rows()
    expect_equal(rows[0][4:7], ["0", "and", "1"])
    expect_near(float(rows[0][0]), GAP_CLOSES, 1e-9)


@test
def small_and_late_jumps_can_be_left_out():
    for options in (["--least", 4], ["--horizon", 9]):
        expect_equal(done("jumps", scene(), "--json", *options).json["jumps"], [])


@test
def the_pieces_of_two_discs_are_a_straight_line_and_a_ride():
    found = done("envelope", scene(), "--json").json
    expect_equal([found["status"], found["F"], found["forms"]], ["ok", 2, 2])
    straight, ride = found["pieces"]
    expect_equal([straight["from"], straight["rides"], straight["change"]], [0, [], "jump"])
    expect_near(straight["until"], GAP_CLOSES, 1e-9)
    is_the_gap(straight["jump"])
    expect_near(straight["jump"]["size"], ride["travel_from"] - straight["travel_until"], 0)
    expect_equal([len(ride["rides"]), ride["change"], ride["jump"]], [1, "end", None])
    expect_near(ride["until"], LAST, 1e-5)


@test
def pieces_come_as_text_too():
    result = done("envelope", scene())
    expect("# F = 2 pieces, 2 forms" in result.out, result)
    expect("straight" in result.out and "jump: 0 and 1 close" in result.out, result)


@test
def pieces_of_a_real_scene_follow_one_another():
    pieces = done("envelope", SCENES / "ships-galveston-anchorage.json", "--json").json["pieces"]
    expect(len(pieces) > 10, len(pieces))
    for before, after in zip(pieces, pieces[1:]):
        expect_equal(after["from"], before["until"])
        expect(after["travel_from"] >= before["travel_until"] - 1e-6, (before, after))
        expect(before["change"] != "end", before)
    jumps = done("jumps", SCENES / "ships-galveston-anchorage.json", "--json").json["jumps"]
    ends = [piece["until"] for piece in pieces if piece["change"] == "jump"]
    expect(jumps, "no jumps")
    for jump in jumps:
        expect(any(abs(jump["departure"] - end) < 1e-6 for end in ends), jump)


@test
def a_scene_that_nothing_ends_needs_a_horizon():
    open_scene = scene(discs=[{"center": [0, 50], "radius": 1, "growth": 0}])
    for command in ("jumps", "envelope"):
        fails(2, ["--horizon"], command, open_scene)
        done(command, open_scene, "--horizon", 10)


@test
def no_path_is_no():
    closed = scene(discs=[{"center": [-10, 0], "radius": 1, "growth": 0}])
    for command, key in (("jumps", "jumps"), ("envelope", "pieces")):
        result = done(command, closed, "--json", status=1)
        expect_equal([result.json["status"], result.json[key]], ["source_covered", []])
        expect("no path" in done(command, closed, status=1).err, command)


@test
def wrong_options_are_usage_errors():
    for value in ("0", "-1", "x", "1e999"):
        fails(2, ["--least"], "jumps", scene(), "--least", value)
        fails(2, ["--resolution"], "envelope", scene(), "--resolution", value)
    fails(2, ["--least"], "jumps", scene(), "--least", "1e-12")
    fails(2, ["--horizon"], "envelope", scene(), "--horizon", "-1")
    fails(2, [], "jumps")
    fails(3, ["bad.json"], "envelope", write("bad.json", "{"))
    fails(4, ["none.json"], "jumps", "none.json")


main()
