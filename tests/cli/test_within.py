#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Answers within a share of the best: `tdsp arrive --within` and `tdsp path --within`."""
import json

from harness import SCENES, built, done, expect, expect_equal, expect_near, fails, main, paired, scene, test, write

REAL = ["fire-oregon-c.json", "fire-greece.json", "ships-long-beach.json", "ships-galveston-anchorage.json", "two-discs.json"]
ERROR = 1e-9  # of the solver and of printing, relative to the travel time


def results(*arguments, **more):
    return done("arrive", *arguments, "--json", **more).json["results"]


def crowd(n, seed=1):
    return write(f"crowd{n}.json", done("generate", "crowd", "--n", n, "--seed", seed).out)


def check_promise(file, times, delta):
    for one, best in paired(results(file, *times, "--within", delta), results(file, *times)):
        expect_equal(one["status"], best["status"], file)
        if best["arrival"] is None:
            expect_equal([one["arrival"], one["lower"]], [None, None])
            continue
        slack = ERROR * best["travel_time"]
        expect(one["lower"] <= best["arrival"] + slack and best["arrival"] <= one["arrival"] + slack, f"{file}: {one} {best}")
        expect(one["travel_time"] <= (1 + delta) * (one["lower"] - one["departure"]) + slack, f"{file}: {one}")
        expect(one["arrival"] <= (1 + delta) * one["lower"] + slack, f"{file}: {one}")


@test
def the_interval_holds_the_exact_arrival_and_keeps_its_promise():
    for name in REAL:
        for delta in [1e-6, 0.01, 1]:
            check_promise(SCENES / name, [0, 5, 50, 1e4], delta)
    check_promise(crowd(700), [0, 1, 2], 0.05)


@test
def json_has_the_share_and_a_lower_bound_beside_the_promised_keys():
    answer = done("arrive", scene(), 0, 1000, "--within", 0.25, "--json").json
    expect_equal(sorted(answer), ["method", "prepare_seconds", "results", "within"])
    expect_equal(answer["within"], 0.25)
    for one in answer["results"]:
        expect_equal(sorted(one), ["arrival", "departure", "lower", "seconds", "status", "travel_time"])
    expect_equal([answer["results"][1][key] for key in ("arrival", "lower", "status")], [None, None, "source_covered"])


@test
def text_has_the_lower_bound_as_its_last_column():
    result = done("arrive", scene(), 0, 1000, "--within", 0.25)
    expect_equal(result.out.splitlines()[0].split(), ["#", "departure", "arrival", "travel_time", "status", "seconds", "lower"])
    rows = result.rows()
    expect_equal(rows[0][:4] + rows[0][5:], ["0", "20", "20", "ok", "20"])
    expect_equal(rows[1][:4] + rows[1][5:], ["1000", "inf", "inf", "source_covered", "inf"])


@test
def without_the_option_everything_is_exact():
    expect_equal(sorted(done("arrive", scene(), 0, "--json").json), ["method", "prepare_seconds", "results"])
    expect("lower" not in done("path", scene(), 12, "--json").json, "a lower bound in an exact path")
    expect("lower" not in done("path", scene(), 12).out, "a lower bound in an exact path")


@test
def where_no_time_has_a_path_the_exit_status_is_1():
    done("arrive", scene(), 1000, "--within", 0.01, status=1)
    done("path", scene(), 1000, "--within", 0.01, status=1)


@test
def a_path_within_a_share_arrives_when_arrive_says_and_is_verified():
    for file in [scene(), SCENES / "fire-oregon-c.json", crowd(500, 2)]:
        for departure in [0, 9.85]:
            for delta in [0.02, 0.5]:
                one = results(file, departure, "--within", delta)[0]
                path = done("path", file, departure, "--within", delta, "--json").json
                expect_equal([path[key] for key in ("arrival", "lower", "status")], [one[key] for key in ("arrival", "lower", "status")])
                expect_equal([path["within"], path["legs"][-1]["end_time"]], [delta, one["arrival"]])
                verdict = done("verify", file, write("path.json", json.dumps(path)), "--deep", 1, "--json").json
                expect(verdict["ok"], verdict)


@test
def a_path_within_a_share_says_so_in_text_and_can_be_asked_for_a_position():
    result = done("path", scene(), 0, "--within", 0.5)
    expect_equal(result.out.splitlines()[:2], ["# departure 0  arrival 20  ok", "# lower 20  within 0.5"])
    x, y = map(float, done("path", scene(), 0, "--within", 0.5, "--at", 10).rows()[0])
    expect_near(x, 0, 1e-9)
    expect_near(y, 0, 1e-9)


@test
def a_share_that_is_none_is_a_usage_error():
    for command in "arrive", "path":
        for text in ["0", "-0", "1.0001", "2", "1e-400", "--within=-0.5"]:
            given = [text] if text.startswith("--") else ["--within", text]
            fails(2, ["--within", text.removeprefix("--within="), "greater than 0 and at most 1"], command, scene(), 0, *given)
        for text in ["nan", "inf", "1%", "0,01", "0x1p-3", "a", ""]:
            fails(2, ["--within", text, "decimal number"], command, scene(), 0, "--within", text)
        fails(2, ["--within"], command, scene(), 0, "--within")
    fails(2, ["--within"], "depart", scene(), 30, "--within", "0.1")
    done("arrive", scene(), 0, "--within", "1")


@test
def a_table_has_no_paths_within_a_share():
    fails(2, ["--within", "scene"], "path", built(), 0, "--within", "0.1")


main()
