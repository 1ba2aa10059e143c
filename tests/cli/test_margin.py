#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tdsp margin, and what tdsp depart says of limits."""
import json
import math

from harness import GAP_CLOSES, TWO_DISCS, built, done, expect, expect_equal, expect_near, fails, main, scene, test, write

LIMIT = ["disc", "limit", "other", "place", "time"]


def gap_rate(departure):
    """The rate at which the gap of the two discs is passed for the last time: 3 sqrt(1 - V^2) = 1 + V (t + 10)."""
    b = departure + 10
    return ((b * b + 8 * (b * b + 9)) ** 0.5 - b) / (b * b + 9)


@test
def margin_has_one_line_a_departure():
    result = done("margin", scene(), 0, 5, 9.8, "--deadline", 30)
    expect_equal(result.out.splitlines()[0].split(),
                 ["#", "departure", "arrival", "status", "early", "later", "factor", "added", "path_factor", "path_added", "limit"])
    rows = result.rows()
    expect_equal([row[0] for row in rows], ["0", "5", "9.8"])
    expect_equal([row[3] for row in rows[:2]], ["10", "5"])
    for row in rows:
        expect_near(float(row[4]), GAP_CLOSES - float(row[0]), 1e-8)
        expect_near(float(row[7]), gap_rate(float(row[0])) / 0.1, 1e-9)
        expect_near(float(row[8]), gap_rate(float(row[0])) - 0.1, 1e-10)
    expect_equal(rows[2][9:12], ["gap", "0", "1"])


@test
def margin_gives_the_promised_keys_in_json():
    answer = done("margin", scene(), 9.8, "--deadline", 30, "--json").json
    expect_equal(sorted(answer), ["deadline", "prepare_seconds", "results"])
    expect_equal(answer["deadline"], 30)
    one = answer["results"][0]
    expect_equal(sorted(one), ["added", "arrival", "departure", "early", "factor", "later", "latest", "path_added", "path_factor", "seconds",
                               "status"])
    expect_equal(sorted(one["latest"]), sorted(["departure", "arrives", "status", *LIMIT]))
    for key in "factor", "added", "path_factor", "path_added":
        expect_equal(sorted(one[key]), sorted(["most", "status", "arrival", *LIMIT]))
    expect_equal([one["factor"][key] for key in ("status", "limit", "disc", "other")], ["ok", "gap", 0, 1])
    expect_near(one["factor"]["time"], 19.8 + one["factor"]["place"][0], 1e-8)
    expect_equal([one["path_factor"][key] for key in ("status", "limit", "other")], ["ok", "touch", None])
    expect_near(one["latest"]["departure"], GAP_CLOSES, 1e-8)


@test
def without_a_deadline_arriving_at_all_is_enough():
    answer = done("margin", scene(), 12, "--json").json
    one = answer["results"][0]
    expect_equal([answer["deadline"], one["early"], one["path_factor"]["most"], one["path_added"]["most"]], [None, None, 1, 0])
    expect(one["factor"]["most"] > 2 and one["factor"]["limit"] == "destination_covered", one)


@test
def what_nothing_can_do_harm_to_is_unlimited():
    far = [{"center": [0, 500], "radius": 1, "growth": 0.1}]
    one = done("margin", scene(discs=far), 1, "--json").json["results"][0]
    for key in "factor", "added", "path_factor", "path_added":
        expect_equal([one[key][name] for name in ("most", "status", "limit", "place")], [None, "unlimited", "none", None])
    expect_equal(done("margin", scene(discs=far), 1).rows()[0][5:10], ["inf", "inf", "inf", "inf", "none"])


@test
def a_departure_that_is_too_late_is_the_answer_no():
    row = done("margin", scene(), 12, "--deadline", 30, status=1).rows()[0]
    expect(float(row[3]) < 0 and float(row[4]) < 0, row)
    expect_equal(row[5:7], ["-inf", "-inf"])
    one = done("margin", scene(), 62, "--json", status=1).json["results"][0]
    expect_equal([one["status"], one["arrival"], one["early"], one["path_factor"]], ["destination_covered", None, None, None])
    expect(0.9 < one["factor"]["most"] < 1 and one["added"]["most"] < 0, one)
    one = done("margin", scene(), 12, "--deadline", 30, "--json", status=1).json["results"][0]
    expect_equal([one["factor"]["most"], one["factor"]["status"]], [None, "arrival_too_early"])
    done("margin", scene(), 12, 0, "--deadline", 30)


@test
def a_path_of_a_table_moved_earlier_has_something_to_spare():
    one = done("margin", scene(), 12, "--path", built(), "--json").json["results"][0]
    expect(one["path_factor"]["most"] > 1 and one["path_added"]["most"] > 0, one)
    expect(one["path_factor"]["most"] < one["factor"]["most"], one)


@test
def a_path_from_a_file_is_looked_at_for_its_own_departure_or_moved():
    file = write("p.json", done("path", scene(), 12, "--json").out)
    own = done("margin", scene(), "--path", file, "--json").json["results"][0]
    expect_equal([own["departure"], own["path_factor"]["most"]], [12, 1])
    earlier, later = done("margin", scene(), 10, 13, "--path", file, "--json").json["results"]
    expect(earlier["path_factor"]["most"] > 1 > later["path_factor"]["most"], (earlier, later))


@test
def a_raised_scene_is_kept_at_the_margin_and_lost_above_it():
    most = done("margin", scene(), 9, "--deadline", 29.5, "--json").json["results"][0]["factor"]["most"]

    def arrival(factor):
        raised = [{**disc, "growth": disc["growth"] * factor} for disc in TWO_DISCS["discs"]]
        return done("arrive", scene("raised.json", discs=raised), 9, "--json").json["results"][0]["arrival"]
    expect(arrival(most) <= 29.5 < arrival(most * (1 + 1e-9)), most)


@test
def growth_that_changes_has_margins_too():
    file = scene(discs=[{"center": [-10, 4], "radius": 1, "growth": [0.1, 0.01]}])
    one = done("margin", file, 10, "--json").json["results"][0]
    expect_near(one["factor"]["most"], 1.5, 1e-10)
    expect_near(one["added"]["most"], 0.1, 1e-10)
    expect_equal(one["factor"]["limit"], "source_covered")
    ways = [(10 + k / 1000, math.hypot(4, k / 1000) - 1) for k in range(20001)]  # when, and the room beside the path
    expect_near(one["path_factor"]["most"], min(room / (0.1 * t + 0.01 * t * t) for t, room in ways), 1e-6)
    expect_near(one["path_added"]["most"], min((room - 0.1 * t - 0.01 * t * t) / t for t, room in ways), 1e-6)
    touching = scene("touching.json", discs=[{"center": [0, 0.5], "radius": 1, "growth": [0.01, 0.001]}])
    one = done("margin", touching, 3, "--json").json["results"][0]
    expect_equal([one["path_factor"]["most"], one["path_added"]["most"], one["path_factor"]["disc"]], [1, 0, 0])
    expect_equal(done("margin", file, 20, status=1).rows()[0][6:9], ["-inf", "-", "-"])
    one = done("margin", file, 20, "--json", status=1).json["results"][0]
    expect(0 < one["factor"]["most"] < 1, one)
    expect_equal([one["added"]["most"], one["added"]["status"]], [None, "not_supported"])


@test
def depart_names_the_limit_in_json():
    results = done("depart", scene(), 25, 33, 1e6, 1, "--json").json["results"]
    expect_equal([one["limit"] for one in results], ["deadline", "gap", "destination_covered", "none"])
    gap = results[1]
    expect_equal([gap["disc"], gap["other"]], [0, 1])
    expect_near(gap["time"], 30 / math.sqrt(0.99) - 10, 1e-8)
    expect_near(gap["place"][0], 0.3 / math.sqrt(0.99), 1e-8)


@test
def mistakes_are_usage_errors():
    fails(2, ["too few arguments"], "margin", scene())
    fails(2, ["--deadline", "-1"], "margin", scene(), 1, "--deadline=-1")
    fails(2, ["too few arguments"], "margin", scene(), "--path", built())
    fails(4, ["nowhere.json"], "margin", scene(), "--path", "nowhere.json")
    none = write("none.json", done("path", scene(), 1000, "--json", status=1).out)
    fails(3, ["none.json", "source_covered"], "margin", scene(), "--path", none)


@test
def a_path_that_fails_as_it_is_has_no_added_rate_where_growth_changes():
    """How far a factor has to fall is found; a rate that would have to be taken away is not looked for where rates change."""
    changing = scene(discs=[{"center": [0, 0], "radius": 1, "growth": {"times": [0, 5], "rates": [0.1, 0.12]}}])
    write("through.json", json.dumps({"departure": 0, "arrival": 20, "status": "ok",
                                      "legs": [{"type": "line", "start_time": 0, "end_time": 20, "from": [-10, 0], "to": [10, 0]}]}))
    result = done("margin", changing, 0, "--path", "through.json", "--json").json["results"][0]
    expect_equal((result["status"], result["path_added"]), ("ok", None))


main()
