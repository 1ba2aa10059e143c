#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Exact answers: arrivals, departures and paths, as text and as JSON."""
import json
import math
import os
import pathlib

from harness import GAP_CLOSES, LAST, ROOT, SCENES, TWO_DISCS, all_files, built, done, expect, expect_equal, expect_near, fails, main, paired, scene, tdsp, test, write

STATUSES = {"ok", "source_covered", "destination_covered", "cut_off", "arrival_too_early", "horizon", "outside_table", "unreachable"}


def disc(x, y, radius, growth=0):
    return {"center": [x, y], "radius": radius, "growth": growth}


@test
def arrive_gives_exact_arrivals_as_text():
    result = done("arrive", scene(), 0, 5, 9.8496, 9.8497)
    expect_equal(result.out.splitlines()[0].split(), ["#", "departure", "arrival", "travel_time", "status", "seconds"])
    rows = result.rows()
    expect_equal(rows[0][:4], ["0", "20", "20", "ok"])
    expect_near(float(rows[2][1]), 29.8496, 1e-9)
    expect_near(float(rows[3][1]), 33.5676, 1e-4)
    expect(result.err == "", result.err)


@test
def arrive_gives_the_promised_keys_in_json():
    answer = done("arrive", scene(), 0, 9.85, "--json").json
    expect_equal(sorted(answer), ["method", "prepare_seconds", "results"])
    for one in answer["results"]:
        expect_equal(sorted(one), ["arrival", "departure", "seconds", "status", "travel_time"])
        expect_equal(one["travel_time"], one["arrival"] - one["departure"])
        expect(one["seconds"] >= 0, one)


@test
def the_method_is_named_and_can_be_chosen_where_it_applies():
    mixed = scene("mixed.json", discs=[disc(0, 3, 1, 0.1), disc(0, -3, 1, 0.2)])
    changing = scene("changing.json", discs=[disc(0, 3, 1, [0.1, 0.01])])
    for one, name in (scene(), "same_speed"), (mixed, "different_speeds"), (changing, "general"):
        expect_equal(done("arrive", one, 0, "--json").json["method"], name)
    for command, time in ("arrive", 9.85), ("depart", 33):
        answers = [done(command, scene(), time, "--json", "--method", word).json for word in ("auto", "same-speed", "different-speeds", "general")]
        expect_equal([answer["method"] for answer in answers], ["same_speed", "same_speed", "different_speeds", "general"])
        for answer in answers:
            for key in "departure", "arrival":
                expect_near(answer["results"][0][key], answers[0]["results"][0][key], 1e-9)
    fails(2, ["--method same-speed: does not apply"], "arrive", mixed, 0, "--method", "same-speed")
    fails(2, ["--method different-speeds: does not apply"], "depart", changing, 9, "--method", "different-speeds")
    fails(2, ["must be one of auto, same-speed"], "arrive", scene(), 0, "--method", "quick")


@test
def depart_is_exact_inside_a_jump():
    for row in done("depart", scene(), 30.35, 33).rows():
        expect_near(float(row[1]), GAP_CLOSES, 1e-7)
        expect_near(float(row[2]), 20 + GAP_CLOSES, 1e-7)
        expect_equal(row[3], "ok")


@test
def depart_gives_the_promised_keys_in_json():
    answer = done("depart", scene(), 25, 1, "--json").json
    expect_equal(sorted(answer), ["method", "prepare_seconds", "results"])
    good, bad = answer["results"]
    for one in good, bad:
        expect_equal(sorted(one), ["arrival", "arrives", "departure", "disc", "limit", "other", "place", "seconds", "status", "time"])
    expect_near(good["departure"], 5, 1e-9)
    expect_near(good["arrives"], 25, 1e-9)
    expect_equal([bad["departure"], bad["arrives"], bad["status"]], [None, None, "arrival_too_early"])


@test
def an_arrival_after_the_last_possible_one_answers_the_last_departure():
    row = done("depart", scene(), 1e6).rows()[0]
    expect_near(float(row[1]), LAST, 1e-4)
    expect_equal(row[3], "ok")


@test
def what_has_no_answer_is_inf_in_text_null_in_json_and_exit_status_1():
    result = done("arrive", scene(), 1000, status=1)
    expect_equal(result.rows()[0][:4], ["1000", "inf", "inf", "source_covered"])
    one = done("arrive", scene(), 1000, "--json", status=1).json["results"][0]
    expect_equal([one["arrival"], one["travel_time"], one["status"]], [None, None, "source_covered"])
    expect_equal(done("depart", scene(), 3, status=1).rows()[0][:4], ["3", "inf", "inf", "arrival_too_early"])


@test
def one_answer_among_many_is_enough_for_exit_status_0():
    rows = done("arrive", scene(), 1000, 0, 2000).rows()
    expect_equal([row[3] for row in rows], ["source_covered", "ok", "source_covered"])


@test
def the_status_says_why_there_is_no_path():
    def status(departure=0, **changes):
        return done("arrive", scene(**changes), departure, status=1).rows()[0][3]
    ring = [disc(3 * math.cos(i), 3 * math.sin(i), 2.2) for i in range(7)]
    expect_equal(status(discs=[disc(-10, 1, 2)]), "source_covered")
    expect_equal(status(discs=[disc(10, 5, 1, 0.9)]), "destination_covered")
    expect_equal(status(discs=ring, source=[0, 0], destination=[20, 0]), "cut_off")
    expect_equal(status(discs=[disc(-10, 1, 2), *ring], destination=[0, 0]), "source_covered")


@test
def source_and_destination_in_one_place_take_no_time():
    file = scene(destination=[-10, 0])
    expect_equal(done("arrive", file, 3).rows()[0][:4], ["3", "3", "0", "ok"])
    path = done("path", file, 3, "--json").json
    expect_equal([path["arrival"], path["status"], path["legs"]], [3, "ok", []])


@test
def numbers_read_back_as_the_same_double_in_text_and_json():
    departures = [1 / 3, 2 / 7, 9.849623163, 12.3456789012345678, 1e-300, 55.5]
    arguments = [repr(one) for one in departures]
    in_text = [[float(cell) for cell in row[:3]] for row in done("arrive", scene(), *arguments).rows()]
    in_json = [[one["departure"], one["arrival"], one["travel_time"]]
               for one in done("arrive", scene(), *arguments, "--json").json["results"]]
    expect_equal(in_text, in_json)
    expect_equal([row[0] for row in in_text], departures)


@test
def numbers_are_written_as_shortly_as_they_can_be():
    rows = done("arrive", scene(), "0.1", "1e22", "1234567", "0.30000000000000004").rows()
    expect_equal([row[0] for row in rows], ["0.1", "1e+22", "1234567", "0.30000000000000004"])


@test
def path_prints_legs_that_join_from_the_source_to_the_destination():
    path = done("path", scene(), 12, "--json").json
    expect_equal(sorted(path), ["arrival", "departure", "legs", "status"])
    legs = path["legs"]
    expect_equal([legs[0]["start_time"], legs[0]["from"]], [12, [-10, 0]])
    expect_equal(legs[-1]["end_time"], path["arrival"])
    expect_near(math.dist(legs[-1]["to"], [10, 0]), 0, 1e-9)
    for one, next_one in zip(legs, legs[1:]):
        expect_near(one["end_time"], next_one["start_time"], 1e-9)
        expect_near(math.dist(one["to"], next_one["from"]), 0, 1e-9)
    expect_equal(path["arrival"], done("arrive", scene(), 12, "--json").json["results"][0]["arrival"])


@test
def legs_have_the_promised_keys():
    legs = done("path", scene(), 12, "--json").json["legs"]
    line = ["end_time", "from", "start_time", "to", "type"]
    for leg in legs:
        expect_equal(sorted(leg), sorted([*line, "disc", "center", "turn", "radii"]) if leg["type"] == "arc" else line)
    arc = next(leg for leg in legs if leg["type"] == "arc")
    expect(arc["turn"] in ("ccw", "cw"), arc)
    grown = TWO_DISCS["discs"][arc["disc"]]
    expect_equal(arc["center"], grown["center"])
    for radius, time in zip(arc["radii"], (arc["start_time"], arc["end_time"])):
        expect_near(radius, grown["radius"] + grown["growth"] * time, 1e-9)


@test
def path_as_text_has_one_line_a_leg():
    legs = done("path", scene(), 12, "--json").json["legs"]
    rows = done("path", scene(), 12).rows()
    for row, leg in paired(rows, legs):
        expect_equal([float(cell) for cell in row[:2] + row[3:7]], [leg["start_time"], leg["end_time"], *leg["from"], *leg["to"]])


@test
def path_at_a_time_prints_the_position_then():
    expect_equal(done("path", scene(), 5, "--at", 12.5).out, "-2.5 0\n")
    expect_equal(done("path", scene(), 5, "--at", 0).out, "-10 0\n")
    expect_equal(done("path", scene(), 5, "--at", 100).out, "10 0\n")
    path = done("path", scene(), 5, "--at", 12.5, "--json").json
    expect_equal([path["time"], path["position"]], [12.5, [-2.5, 0]])


@test
def a_departure_without_a_path_prints_none_and_exits_1():
    path = done("path", scene(), 1000, "--json", status=1).json
    expect_equal(path, {"departure": 1000, "arrival": None, "status": "source_covered", "legs": []})
    result = done("path", scene(), 1000, status=1)
    expect("source_covered" in result.out and result.rows() == [], result)


@test
def shipped_scenes_answer_with_known_statuses():
    for file in all_files(SCENES, "*.json"):
        for one in done("arrive", file, 0, 10, "--json").json["results"]:
            expect(one["status"] in STATUSES, one)
            expect((one["arrival"] is None) == (one["status"] != "ok"), one)


@test
def real_scenes_arrive_when_an_independent_solver_says():
    data = pathlib.Path(ROOT, os.environ.get("TDSP_DATA") or "../shared/data")
    if not (data / "expected.json").exists():
        print(f"# {data} is absent: only the scenes in examples/scenes are compared")
        known = {"two-discs": {"arrivals": [[0, 20]], "departures": [[30.35, GAP_CLOSES]]}}
        folder = SCENES
    else:
        known = json.loads((data / "expected.json").read_text())
        folder = data / "scenes"
    names = [name for name in sorted(known) if len((folder / f"{name}.json").read_bytes()) < 20000]
    for name in names:
        file = folder / f"{name}.json"
        for one, (_, wanted) in paired(ask("arrive", file, known[name]["arrivals"]), known[name]["arrivals"]):
            expect((one["arrival"] is None) == (wanted is None), f"{name}: {one}, not {wanted}")
            if wanted is not None:
                expect_near(one["arrival"], wanted, 1e-8 * wanted, f"{name} at {one['departure']}")
        for one, (_, wanted) in paired(ask("depart", file, known[name]["departures"]), known[name]["departures"]):
            expect((one["departure"] is None) == (wanted is None), f"{name}: {one}, not {wanted}")
            if wanted is not None:
                expect_near(one["departure"], wanted, 1e-7 * one["arrival"], f"{name} by {one['arrival']}")


def ask(command, file, pairs):
    """The answers to the first members of the pairs; "no" to all of them is exit status 1."""
    if not pairs:
        return []
    result = tdsp(command, file, *[repr(time) for time, _ in pairs], "--json")
    expect(result.status in (0, 1), f"{file}: {result}")
    return result.json["results"]


@test
def the_locale_changes_no_number():
    before = os.environ.get("LC_ALL")
    wanted = done("arrive", scene(), 9.85, "--json").json["results"][0]["arrival"]
    os.environ["LC_ALL"] = "de_DE.UTF-8"
    try:
        expect_equal(done("arrive", scene(), 9.85, "--json").json["results"][0]["arrival"], wanted)
        fails(2, ["1,5"], "arrive", scene(), "1,5")
    finally:
        os.environ.pop("LC_ALL")
        if before is not None:
            os.environ["LC_ALL"] = before



@test
def a_path_of_a_scene_that_is_none_is_refused_and_a_departure_of_a_table_without_one_says_so():
    fails(3, ["scene.json", "source"], "path", write("scene.json", '{"robot": {"speed": 1}}'), 5)
    text = done("path", built(), 1000, status=1).out
    expect(text.startswith("# departure 1000  arrival inf  "), text)
    expect_equal(text.count("# row"), 0)


main()
