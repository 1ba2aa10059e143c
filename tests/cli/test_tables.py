#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Building tables and asking them."""
import pathlib
import struct

from harness import GAP_CLOSES, LAST, ROOT, SCENES, all_files, built, done, expect, expect_equal, expect_near, fails, main, scene, test, write


def departures(count=60, last=LAST):
    return [repr(last * (i + 0.5) / count) for i in range(count)]


def compare(table, allowed):
    """Exact arrivals lie in the table's intervals, and those are as narrow as allowed(departure, lower) says."""
    asked = departures()
    exact = done("arrive", "scene.json", *asked, "--json").json["results"]
    given = done("query", table, *asked, "--json").json["results"]
    for one, other in zip(exact, given):
        expect(other["lower"] <= one["arrival"] <= other["upper"], f"{one} is outside {other}")
        expect(other["upper"] <= allowed(other["departure"], other["lower"]), f"{other} is too wide")


@test
def build_gives_the_promised_keys_and_a_file_of_the_promised_size():
    report = done("build", scene(), "-o", "t.tdsp", "--json").json
    expect_equal(sorted(report), sorted(["rows", "bytes", "forward_calls", "reverse_calls", "seconds", "last_departure", "last_reason",
                                         "guarantee", "epsilon", "delta", "sampling", "table", "oracle_delta", "rough_calls"]))
    expect_equal([report[key] for key in ("guarantee", "epsilon", "delta", "sampling", "table", "last_reason")],
                 ["travel", 0.01, None, "adaptive", "t.tdsp", "destination_covered"])
    expect_equal(pathlib.Path("t.tdsp").stat().st_size, report["bytes"])
    expect_near(report["last_departure"], LAST, 1e-4)


@test
def build_says_what_part_of_the_guarantee_was_left_to_the_oracle():
    report = done("build", scene(), "-o", "t.tdsp", "--epsilon", 0.02, "--json").json
    expect_equal([report["oracle_delta"], report["rough_calls"]], [0.015, 0])
    report = done("build", scene(), "-o", "u.tdsp", "--epsilon", 0.02, "--exact", "--json").json
    expect_equal([report["oracle_delta"], report["rough_calls"]], [0, 0])
    expect_equal(pathlib.Path("t.tdsp").read_bytes(), pathlib.Path("u.tdsp").read_bytes())


@test
def build_as_text_names_the_table_its_rows_and_its_end():
    result = done("build", scene(), "-o", "t.tdsp")
    for fragment in ["t.tdsp: ", " rows, ", "travel, epsilon 0.01, adaptive", "destination_covered"]:
        expect(fragment in result.out, result)
    expect_equal(result.err, "")


@test
def the_guarantee_travel_holds():
    compare(built("--epsilon", 0.02), lambda t, lower: t + 1.02 * (lower - t) * (1 + 1e-9))


@test
def the_guarantee_arrival_holds():
    compare(built("--epsilon", 0.05, "--guarantee", "arrival"), lambda t, lower: 1.05 * lower * (1 + 1e-9))


@test
def the_guarantee_absolute_holds():
    compare(built("--delta", 0.3, "--guarantee", "absolute"), lambda t, lower: lower + 0.3 + 1e-9)


@test
def geometric_sampling_holds_its_guarantee_with_no_fewer_rows_than_adaptive():
    compare(built("--guarantee", "arrival", "--sampling", "geometric", "--epsilon", 0.05), lambda t, lower: 1.05 * lower * (1 + 1e-9))
    rows = [done("build", scene(), "-o", "u.tdsp", "--guarantee", "arrival", "--epsilon", 0.05, "--sampling", sampling, "--json").json["rows"]
            for sampling in ("adaptive", "geometric")]
    expect(rows[0] <= rows[1], rows)


@test
def the_bytes_do_not_depend_on_the_number_of_threads():
    files = [scene(), SCENES / "fire-oregon-c.json"]
    for file in files:
        tables = []
        for threads in (1, 2, 7):
            done("build", file, "-o", "t.tdsp", "--threads", threads, "--epsilon", 0.05)
            tables.append(pathlib.Path("t.tdsp").read_bytes())
        expect(tables[0] == tables[1] == tables[2], f"{file}: tables differ")


@test
def bounds_out_of_range_are_usage_errors():
    file = scene()
    for options in [("--epsilon", "0"), ("--epsilon", "2"), ("--epsilon", "1e-10"), ("--epsilon", "x"), ("--epsilon", "-0.1"),
                    ("--delta", "1"), ("--guarantee", "absolute"), ("--guarantee", "absolute", "--epsilon", "0.1"),
                    ("--guarantee", "absolute", "--delta", "0"), ("--guarantee", "absolute", "--delta", "-1"),
                    ("--guarantee", "absolute", "--delta", "1", "--epsilon", "0.1"), ("--guarantee", "best"), ("--sampling", "random"),
                    ("--sampling", "geometric"), ("--sampling", "geometric", "--guarantee", "absolute", "--delta", "1"),
                    ("--threads", "0"), ("--threads", "1.5"), ("--threads", "9999"), ("--horizon", "-1"), ("--horizon", "inf")]:
        result = fails(2, [], "build", file, "-o", "t.tdsp", *options)
        expect(any(option in result.err for option in options[::2]), result)
        expect(not pathlib.Path("t.tdsp").exists(), options)


@test
def the_bounds_themselves_are_allowed():
    built("--epsilon", 1)
    built("--guarantee", "absolute", "--delta", 1e6)
    built("--horizon", 0, "--epsilon", "1e-9")


@test
def a_scene_that_never_ends_needs_a_horizon():
    file = scene(discs=[{"center": [0, 3], "radius": 1, "growth": 0}])
    fails(2, ["--horizon", "no disc ever ends"], "build", file, "-o", "t.tdsp")
    expect(not pathlib.Path("t.tdsp").exists(), "a table was left")
    report = done("build", file, "-o", "t.tdsp", "--horizon", 50, "--json").json
    expect_equal([report["last_departure"], report["last_reason"]], [50, "horizon"])
    row = done("query", "t.tdsp", 51, status=1).rows()[0]
    expect_equal(row[1:], ["inf", "inf", "horizon"])


@test
def a_horizon_cuts_a_scene_that_ends_later_and_not_one_that_ends_before():
    expect_equal(done("build", scene(), "-o", "t.tdsp", "--horizon", 20, "--json").json["last_departure"], 20)
    report = done("build", scene(), "-o", "t.tdsp", "--horizon", 2000, "--json").json
    expect_near(report["last_departure"], LAST, 1e-4)
    expect_equal(report["last_reason"], "destination_covered")


@test
def without_a_path_at_0_there_is_nothing_to_build():
    file = scene(discs=[{"center": [-10, 1], "radius": 2, "growth": 0}])
    result = done("build", file, "-o", "t.tdsp", status=1)
    expect("nothing to build" in result.err and result.out == "", result)
    expect(not pathlib.Path("t.tdsp").exists(), "a table was left")
    report = done("build", file, "-o", "t.tdsp", "--json", status=1).json
    expect_equal([report["rows"], report["last_departure"], report["last_reason"], report["table"]], [0, None, "source_covered", None])


@test
def query_gives_the_promised_keys():
    answer = done("query", built(), 1, 1000, "--json").json
    expect_equal(sorted(answer), ["results"])
    for one in answer["results"]:
        expect_equal(sorted(one), ["departure", "lower", "status", "upper"])
    expect_equal(answer["results"][1], {"departure": 1000, "lower": None, "upper": None, "status": "destination_covered"})


@test
def query_by_arrival_gives_the_promised_keys_and_is_certain():
    answer = done("query", built(), "--arrive-by", 33, 25, 1, "--json").json
    for one in answer["results"]:
        expect_equal(sorted(one), ["arrival", "departure", "departure_upper", "status"])
    jump, plain, early = answer["results"]
    expect_near(jump["departure"], GAP_CLOSES, 1e-6)
    expect_near(jump["departure_upper"], GAP_CLOSES, 1e-6)
    expect(plain["departure"] <= 5 + 1e-9 and plain["departure_upper"] >= 5 - 1e-9, plain)
    expect_equal([early["departure"], early["departure_upper"], early["status"]], [None, None, "arrival_too_early"])
    for one in (jump, plain):
        arrival = done("arrive", "scene.json", repr(one["departure"]), "--json").json["results"][0]["arrival"]
        expect(arrival <= one["arrival"] + 1e-9, f"{one} arrives at {arrival}")


@test
def arrivals_may_be_given_in_several_ways():
    table = built()
    wanted = done("query", table, "--arrive-by", 33, 25).out
    expect_equal(done("query", table, "--arrive-by=33", "--arrive-by", 25).out, wanted)
    expect_equal(done("query", table, "--arrive-by", "--times", write("a.txt", "33\n25\n")).out, wanted)
    expect_equal(done("query", "--arrive-by", 33, 25, "--", table, status=2).out, "")


@test
def departures_and_arrivals_in_one_call_are_a_usage_error():
    fails(2, ["departures and arrivals"], "query", built(), 5, "--arrive-by", 33)


@test
def query_without_times_is_a_usage_error():
    fails(2, ["no time"], "query", built())
    fails(2, ["no time"], "query", built(), "--arrive-by")


@test
def times_come_from_a_file_with_comments():
    text = "# departures\n1\n\n  2.5e0   # the second\n\t+3\r\n4"
    result = done("query", built(), "--times", write("times.txt", text))
    expect_equal([row[0] for row in result.rows()], ["1", "2.5", "3", "4"])
    expect_equal(done("query", "t.tdsp", "--times", "-", stdin=text).out, result.out)
    expect_equal([row[0] for row in done("query", "t.tdsp", 9, "--times", "times.txt").rows()], ["9", "1", "2.5", "3", "4"])


@test
def a_bad_line_in_a_file_of_times_is_named():
    table = built()
    for text, line in [("1\nx\n", 2), ("1\n\n# c\n-2\n", 4), ("1e999", 1), ("1 2", 1), ("nan", 1), ("1\n2,5", 2), ("0x1", 1)]:
        fails(3, [f"times.txt:{line}: "], "query", table, "--times", write("times.txt", text))
    fails(3, ["times.txt:1: a zero byte"], "query", table, "--times", write("times.txt", b"1\0002\n"))
    fails(3, ["times.txt", "no number"], "query", table, "--times", write("times.txt", "# nothing\n"))
    fails(3, ["standard input:2"], "query", table, "--times", "-", stdin="1\nx")
    fails(4, ["missing.txt"], "query", table, "--times", "missing.txt")


@test
def info_tells_the_facts_of_the_header_and_the_jumps():
    facts = done("info", built("--epsilon", 0.02), "--json").json
    expect_equal([facts[key] for key in ("table", "guarantee", "epsilon", "delta", "sampling", "speed", "source", "destination", "units")],
                 ["t.tdsp", "travel", 0.02, None, "adaptive", 1, [-10, 0], [10, 0], {"length": "m", "time": "s"}])
    expect_equal(facts["bytes"], pathlib.Path("t.tdsp").stat().st_size)
    expect_near(facts["bytes_per_row"], facts["bytes"] / facts["rows"], 1e-9)
    jump = facts["jumps"][0]
    expect_near(jump["departure"], GAP_CLOSES, 1e-6)
    expect_near(jump["before"], 20, 1e-6)
    expect_near(jump["after"], 23.7179, 1e-3)
    expect_equal([jump["first"], jump["second"]], [0, 1])
    expect_near(jump["time"], (3 / 0.99**0.5 - 1) / 0.1, 1e-7)
    expect_near(jump["place"][0], 0.3 / 0.99**0.5, 1e-7)
    expect_near(jump["size"], jump["after"] - jump["before"], 0)
    text = done("info", "t.tdsp").out
    for fragment in ["rows", "travel, epsilon 0.02", "jumps             1", "discs 0 and 1 close at 20.15", "1 m/s", "destination_covered"]:
        expect(fragment in text, f"no {fragment!r} in {text}")


@test
def an_absolute_table_tells_its_delta():
    facts = done("info", built("--guarantee", "absolute", "--delta", 0.5), "--json").json
    expect_equal([facts["guarantee"], facts["epsilon"], facts["delta"]], ["absolute", None, 0.5])
    report = done("build", scene(), "-o", "t.tdsp", "--guarantee", "absolute", "--delta", 0.5, "--json").json
    expect_equal([report["guarantee"], report["epsilon"], report["delta"]], ["absolute", None, 0.5])


@test
def the_path_of_a_table_is_its_row_s_moved_earlier():
    table = built("--epsilon", 0.2)
    path = done("path", table, 30, "--json").json
    expect_equal(sorted(path), ["arrival", "computed_for", "departure", "legs", "row", "status"])
    expect(path["computed_for"] > 30, path)
    exact = done("path", "scene.json", repr(path["computed_for"]), "--json").json
    earlier = path["computed_for"] - 30
    expect_near(path["arrival"], exact["arrival"] - earlier, 1e-6)
    for one, other in zip(path["legs"], exact["legs"]):
        expect_near(one["start_time"], other["start_time"] - earlier, 1e-6)
        expect_near(one["from"][0], other["from"][0], 1e-6)
        if one["type"] == "arc":  # as large as the disc will be when the row's robot is there
            expect_near(one["radii"][0], 1 + 0.1 * (one["start_time"] + earlier), 1e-6)
    expect(path["arrival"] <= done("query", table, 30, "--json").json["results"][0]["upper"], "arrives after the upper end")
    expect("computed for departure" in done("path", table, 30).out, "no row in text")


@test
def the_path_of_a_table_with_curves_says_how_they_bend():
    table = ROOT / "tests" / "independent" / "golden" / "swell.tdsp"
    legs = done("path", table, 0, "--json").json["legs"]
    expect_equal([leg["type"] for leg in legs], ["line", "arc", "arc", "arc", "line"])
    expect_equal([legs[2][key] for key in ("radii", "rates", "bends", "sweep", "speed")],
                 [[4.75, 5.5], [0.375, 0.5], [0.0625, 0], 0.75, 2])
    expect("rates" not in legs[3] and "sweep" not in legs[3], legs[3])
    x, y = map(float, done("path", table, 0, "--at", 3).out.split())
    expect_equal([x, y], legs[2]["from"])
    expect_equal(done("info", table, "--json").json["curves"], 3)
    expect("curves            3\n" in done("info", table).out, "no curves in text")


@test
def past_the_end_a_table_has_no_path():
    path = done("path", built(), 1000, "--json", status=1).json
    expect_equal(path, {"departure": 1000, "arrival": None, "status": "destination_covered", "row": None, "computed_for": None, "legs": []})


@test
def a_table_tells_the_position_at_a_time():
    expect_equal(done("path", built(), 5, "--at", 12.5).out, "-2.5 0\n")


@test
def a_changed_byte_anywhere_is_noticed():
    whole = pathlib.Path(built()).read_bytes()
    for at in [0, 5, 9, 20, 40, 64, 100, 200, 1000, len(whole) // 2, len(whole) - 1]:
        changed = bytearray(whole)
        changed[at] ^= 0x41
        for command in (["query", "bad.tdsp", 1], ["info", "bad.tdsp"], ["embed", "bad.tdsp", "-o", "b.c"], ["plot", "bad.tdsp", "-o", "b.svg"]):
            fails(3, ["bad.tdsp"], command[0], write("bad.tdsp", bytes(changed)), *command[2:])


@test
def a_cut_or_longer_table_is_noticed():
    whole = pathlib.Path(built()).read_bytes()
    for length in [1, 4, 8, 16, 63, 100, len(whole) - 8, len(whole) - 1]:
        fails(3, ["bad.tdsp"], "query", write("bad.tdsp", whole[:length]), 1)
    fails(3, ["bad.tdsp"], "query", write("bad.tdsp", whole + b"\0"), 1)


@test
def other_files_are_no_tables():
    fails(3, ["not a table"], "query", scene(), 1)
    fails(3, ["not a table"], "info", scene())
    fails(3, ["neither JSON nor a table"], "info", write("x", struct.pack("<QQ", 1, 2)))


@test
def every_shipped_scene_builds_a_table_that_verifies():
    for file in all_files(SCENES, "*.json"):
        done("build", file, "-o", "t.tdsp", "--epsilon", 0.05)
        expect(done("verify", file, "t.tdsp", "--deep", 3, "--json").json["ok"], file)


main()
