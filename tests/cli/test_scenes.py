#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The reader of scene files: everything wrong is answered with the file, the place and the reason, and everything right is read rightly."""
import json
import pathlib

from harness import TWO_DISCS, add, done, expect, expect_equal, expect_near, fails, main, scene, test, write


def text_with(old, new):
    """The two discs as text with one replacement."""
    text = json.dumps(TWO_DISCS)
    expect(old in text, f"{old} is not in the scene")
    return text.replace(old, new, 1)


def refused(content, *fragments):
    def check():
        fails(3, ["scene.json", *fragments], "arrive", write("scene.json", content), "0")
    return check


def with_member(**changes):
    return json.dumps({**TWO_DISCS, **changes})


def without(*path):
    content = json.loads(json.dumps(TWO_DISCS))
    inside = content
    for step in path[:-1]:
        inside = inside[step]
    del inside[path[-1]]
    return json.dumps(content)


def with_disc(**changes):
    return with_member(discs=[TWO_DISCS["discs"][0], {**TWO_DISCS["discs"][1], **changes}])


SYNTAX = {
    "an empty file": ("", "neither JSON nor a table"),
    "a file that is no JSON": ("hello", "neither JSON nor a table"),
    "NaN": (text_with('"speed": 1', '"speed": NaN'), ":1:", "not a JSON value", "NaN"),
    "Infinity": (text_with('"speed": 1', '"speed": -Infinity'), ":1:"),
    "a number beyond the doubles": (text_with('"speed": 1', '"speed": 1e999'), "too large"),
    "a whole number beyond the doubles": (text_with('"speed": 1', '"speed": 1' + "0" * 400), "too large"),
    "a trailing comma": (text_with("[10, 0]", "[10, 0,]"), "expected a value"),
    "a comment": ("// scene\n" + json.dumps(TWO_DISCS), "neither JSON nor a table"),
    "a comment inside": ("{\n /* no */ " + json.dumps(TWO_DISCS)[1:], ":2:2:", "expected a key"),
    "a duplicate key": ('{"name": "a", "name": "b"}', ":1:15:", "duplicate key: name"),
    "a duplicate key in disguise": ('{"name": "a",\n "n\\u0061me": "b"}', ":2:2:", "duplicate key: name"),
    "a duplicate key of a disc": (text_with('"radius": 1', '"radius": 1, "radius": 2'), "duplicate key: radius"),
    "a duplicate unknown key": ('{"a": 1, "b": {"c": 1, "c": 1}}', "duplicate key: c"),
    "absurd nesting": ("[" * 200000 + "]" * 200000, "nested too deeply"),
    "absurd nesting of objects": ('{"a":' * 100000, "nested too deeply"),
    "something behind the end": (json.dumps(TWO_DISCS) + "\n{}", ":2:1:", "follows the end"),
    "a text that ends too early": (json.dumps(TWO_DISCS)[:-1], "ends too early"),
    "a string that never ends": ('{"name": "a', ":1:10:", "never ends"),
    "single quotes": ("{'name': 1}", "expected a key in double quotes"),
    "a key without a colon": ('{"name" 1}', "colon"),
    "a hexadecimal number": (text_with('"speed": 1', '"speed": 0x10'), "not a number"),
    "a leading zero": (text_with('"speed": 1', '"speed": 01'), "not a number"),
    "a leading plus": (text_with('"speed": 1', '"speed": +1'), ":1:"),
    "a number without digits before the point": (text_with('"speed": 1', '"speed": .5'), ":1:"),
    "a number without digits behind the point": (text_with('"speed": 1', '"speed": 5.'), "not a number"),
    "a number without an exponent": (text_with('"speed": 1', '"speed": 5e'), "not a number"),
    "a lone minus": (text_with('"speed": 1', '"speed": -'), "not a number"),
    "bytes that are no UTF-8": (json.dumps(TWO_DISCS).encode().replace(b"two", b"tw\xff"), ":1:13:", "not UTF-8"),
    "a zero byte": (json.dumps(TWO_DISCS).encode().replace(b"two discs", b"two\0discs"), "zero byte"),
    "an escaped zero": ('{"name": "a\\u0000b"}', "zero character"),
    "half of a surrogate pair": ('{"name": "\\ud800"}', "surrogate"),
    "an unknown escape": ('{"name": "\\x41"}', "unknown escape"),
    "a line feed in a string": ('{"name": "a\nb"}', "control character"),
    "a mistake on a later line": ('{"robot":\n {"speed":\n   1 2}}', ":3:6:", "expected a comma or }"),
    "a place after letters of two bytes": ('{"näme": tru}', ":1:10:", "not a JSON value: tru"),
}
for name, (content, *fragments) in SYNTAX.items():
    add(f"{name} is refused with its place", refused(content, *fragments))

MEANING = {
    "no object": ("[1, 2]", "must be an object, not an array"),
    "no robot": (without("robot"), "robot: missing"),
    "no speed": (without("robot", "speed"), "robot.speed: missing"),
    "no source": (without("source"), "source: missing"),
    "no destination": (without("destination"), "destination: missing"),
    "no discs": (without("discs"), "discs: missing"),
    "a disc without a centre": (without("discs", 1, "center"), "discs[1].center: missing"),
    "a disc without a radius": (without("discs", 1, "radius"), "discs[1].radius: missing"),
    "a disc without growth": (without("discs", 0, "growth"), "discs[0].growth: missing"),
    "a robot that is no object": (with_member(robot=1), "robot: must be an object, not a number"),
    "a speed that is a string": (with_member(robot={"speed": "1"}), "robot.speed: must be a number, not a string"),
    "a speed that is null": (with_member(robot={"speed": None}), "robot.speed: must be a number, not null"),
    "a speed of zero": (with_member(robot={"speed": 0}), "robot.speed: must be greater than zero"),
    "a negative speed": (with_member(robot={"speed": -1.5}), "robot.speed: must be greater than zero"),
    "a negative robot": (with_member(robot={"speed": 1, "radius": -1}), "robot.radius: must not be negative"),
    "a robot's radius that is an array": (with_member(robot={"speed": 1, "radius": []}), "robot.radius: must be a number"),
    "a name that is a number": (with_member(name=7), "name: must be a string"),
    "units that are a string": (with_member(units="m"), "units: must be an object"),
    "a unit that is a number": (with_member(units={"length": 1}), "units.length: must be a string"),
    "a point with one number": (with_member(source=[1]), "source: a point has exactly two numbers, not 1"),
    "a point with three numbers": (with_member(destination=[1, 2, 3]), "destination: a point has exactly two numbers, not 3"),
    "a point with a string": (with_member(source=[1, "2"]), "source[1]: must be a number, not a string"),
    "a point that is an object": (with_member(source={"x": 1, "y": 2}), "source: must be an array, not an object"),
    "discs that are an object": (with_member(discs={}), "discs: must be an array"),
    "a disc that is a number": (with_member(discs=[1]), "discs[0]: must be an object"),
    "a centre with a boolean": (with_disc(center=[0, True]), "discs[1].center[1]: must be a number, not true or false"),
    "a negative radius": (with_disc(radius=-1), "discs[1].radius: must not be negative"),
    "a negative growth": (with_disc(growth=-0.1), "discs[1].growth: must not be negative"),
    "a growth that is a string": (with_disc(growth="fast"), "discs[1].growth: must be a number"),
    "an empty polynomial": (with_disc(growth=[]), "discs[1].growth: has no coefficient"),
    "a polynomial that shrinks": (with_disc(growth=[-1]), "discs[1].growth: the radius shrinks from t = 0"),
    "a polynomial that shrinks later than it begins": (with_disc(growth=[0, 0, -1e-9, 3]), "discs[1].growth: the radius shrinks from t = 0"),
    "a polynomial of degree 9": (with_disc(growth=[0.1] * 9), "discs[1].growth: 9 coefficients, where at most 8 are supported"),
    "a coefficient beyond the library's numbers": (with_disc(growth=[0.1, -1e101]), "discs[1].growth[1]: is beyond 1e100"),
    "a rate beyond the library's numbers": (with_disc(growth=1e101), "discs[1].growth: the growth is not between 0 and 1e100"),
    "a polynomial with a string": (with_disc(growth=[0.1, "0"]), "discs[1].growth[1]: must be a number"),
    "a negative rate in pieces": (with_disc(growth={"times": [0, 5], "rates": [0.1, -0.2]}), "discs[1].growth.rates[1]: must not be negative"),
    "a rate in pieces that is a string": (with_disc(growth={"times": [0, 5], "rates": [0.1, "x"]}), "discs[1].growth.rates[1]: must be a number"),
    "a time in pieces that is null": (with_disc(growth={"times": [0, None], "rates": [0.1, 0.2]}), "discs[1].growth.times[1]: must be a number"),
    "no pieces": (with_disc(growth={"times": [], "rates": []}), "discs[1].growth.times: is empty"),
    "pieces without rates": (with_disc(growth={"times": [0]}), "discs[1].growth.rates: missing"),
    "pieces without times": (with_disc(growth={"rates": [0]}), "discs[1].growth.times: missing"),
    "pieces that begin late": (with_disc(growth={"times": [1], "rates": [0.1]}), "discs[1].growth.times[0]: the first time must be 0"),
    "pieces out of order": (with_disc(growth={"times": [0, 0], "rates": [1, 1]}), "discs[1].growth.times[1]: times must increase"),
    "pieces of unequal number": (with_disc(growth={"times": [0], "rates": [1, 1]}), "discs[1].growth.rates: 2 rates for 1 times"),
}
for name, (content, *fragments) in MEANING.items():
    add(f"{name} is refused with its member path", refused(content, *fragments))


def arrival(content):
    return done("arrive", write("scene.json", content), "12", "--json").json["results"][0]["arrival"]



@test
def constant_growth_may_be_written_in_four_ways():
    wanted = arrival(json.dumps(TWO_DISCS))
    for growth in [0.1, [0.1], [0.1, 0, 0.0], {"times": [0], "rates": [0.1]}, {"times": [0, 5, 9], "rates": [0.1, 0.1, 0.1]}]:
        content = with_member(discs=[{**disc, "growth": growth} for disc in TWO_DISCS["discs"]])
        expect_equal(arrival(content), wanted, str(growth))


@test
def growth_that_changes_with_time_is_solved():
    slow, fast = (arrival(with_member(discs=[{**disc, "growth": rate} for disc in TWO_DISCS["discs"]])) for rate in (0.1, 0.15))
    for growth in [[0.1, 0.001], [0.11, -1e-6], {"times": [0, 5, 20], "rates": [0.1, 0.11, 0.12]}]:
        content = with_member(discs=[{**disc, "growth": growth} for disc in TWO_DISCS["discs"]])
        expect(slow < arrival(content) < fast, f"{growth}: {arrival(content)} is not between {slow} and {fast}")


@test
def a_rate_that_changes_after_the_arrival_changes_nothing():
    wanted = arrival(json.dumps(TWO_DISCS))
    content = with_member(discs=[{**disc, "growth": {"times": [0, 1000], "rates": [0.1, 0.2]}} for disc in TWO_DISCS["discs"]])
    expect_near(arrival(content), wanted, 1e-10 * wanted)


@test
def a_question_that_needs_a_shrinking_radius_is_refused_with_disc_and_time():
    file = write("late.json", with_member(discs=[{"center": [0, -3], "radius": 1, "growth": [0.05, -0.0001]}]))
    reason = "late.json: discs[0].growth: the radius shrinks after t = 250, and this question reaches beyond"
    expect_equal(done("arrive", file, 0).rows()[0][3], "ok")
    fails(3, [reason], "arrive", file, 300)
    fails(3, [reason], "arrive", file, 0, 249)
    fails(3, [reason], "path", file, 300)
    fails(3, [reason], "plot", file, "--depart", 300, "-o", "late.svg")
    fails(3, [reason], "depart", file, 300)
    fails(3, [reason], "build", file, "--horizon", 300, "-o", "late.tdsp")
    expect_equal(sorted(path.name for path in pathlib.Path().iterdir()), ["late.json"])


@test
def unknown_keys_in_growth_are_warned_of():
    file = write("scene.json", with_disc(growth={"times": [0], "rates": [0.1], "unit": "m/s"}))
    expect("scene.json: discs[].growth.unit: unknown key ignored" in done("arrive", file, 0).err, "no warning")


@test
def the_robot_s_radius_is_added_to_every_disc():
    fat = with_member(robot={"speed": 1, "radius": 0.5})
    large = with_member(discs=[{**disc, "radius": disc["radius"] + 0.5} for disc in TWO_DISCS["discs"]])
    expect_equal(arrival(fat), arrival(large))


@test
def white_space_line_ends_and_a_byte_order_mark_do_not_matter():
    wanted = arrival(json.dumps(TWO_DISCS))
    text = json.dumps(TWO_DISCS, indent=3).replace("\n", "\r\n\t")
    expect_equal(arrival(b"\xef\xbb\xbf \n" + text.encode()), wanted)


@test
def whole_numbers_of_any_size_and_tiny_numbers_are_read_rightly():
    far = {"source": [-99999999999999999999, 0], "destination": [99999999999999999999, 18446744073709551617], "robot": {"speed": 18446744073709551617}}
    disc = {"center": [0, 3], "radius": 1, "growth": 0.1}
    content = with_member(**far, discs=[disc]).replace("[0, 3]", "[1e-400, 3e0]")
    same = with_member(source=[-1e20, 0.0], destination=[1e20, 2.0**64], robot={"speed": 2.0**64}, discs=[disc])
    expect_near(arrival(content), arrival(same), 1e-12)


@test
def unknown_keys_are_ignored_with_one_warning_for_each_kind():
    content = with_member(provenance="x", discs=[{**disc, "note": i} for i, disc in enumerate(TWO_DISCS["discs"])])
    result = done("arrive", write("scene.json", content), "0")
    expect_equal(result.err.count("warning"), 2, result.err)
    expect("scene.json: provenance: unknown key ignored" in result.err, result.err)
    expect("scene.json: discs[].note: unknown key ignored" in result.err, result.err)


@test
def a_scene_may_come_from_standard_input():
    result = done("arrive", "-", "5", stdin=json.dumps(TWO_DISCS))
    expect_equal(result.rows()[0][:2], ["5", "25"])
    fails(3, ["standard input"], "arrive", "-", "5", stdin="{")


@test
def a_name_with_escapes_is_read():
    done("plot", scene(name='\u00e4 \U0001f525 "<&>" \\ \n'), "-o", "a.svg")


@test
def a_disc_too_far_out_is_refused_by_its_index():
    fails(3, ["scene.json: discs[1]: "], "arrive", write("scene.json", with_disc(center=[1e200, 0])), "0")


@test
def units_too_long_for_a_table_stop_only_the_build():
    file = scene(units={"length": "astronomical units", "time": "s"})
    done("arrive", file, "0")
    fails(3, ["units.length", "15 bytes"], "build", file, "-o", "t.tdsp")


@test
def a_table_is_no_scene():
    done("build", scene(), "-o", "t.tdsp")
    fails(3, ["t.tdsp", "scene is needed"], "arrive", "t.tdsp", "0")
    fails(3, ["t.tdsp", "scene is needed"], "build", "t.tdsp", "-o", "u.tdsp")
    fails(3, ["t.tdsp", "scene is needed"], "verify", "t.tdsp", "t.tdsp")


if __name__ == "__main__":
    main()
