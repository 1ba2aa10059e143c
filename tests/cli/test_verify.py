#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Verification: good tables and paths pass, and every kind of damage is found."""
import json
import pathlib

from harness import SCENES, all_files, built, done, expect, expect_equal, fails, main, scene, test, tdsp, write

KEYS = ["checked", "disc", "min_clearance", "ok", "problems", "time"]


def path_file(departure=12, name="p.json", of="scene.json"):
    return write(name, done("path", of, departure, "--json").out)


def damaged(change, departure=12):
    """The path of a departure after `change` has had its way with it; returns the verdict, which must be bad."""
    path = json.loads(pathlib.Path(path_file(departure)).read_text())
    change(path)
    verdict = done("verify", "scene.json", write("bad.json", json.dumps(path)), "--json", status=1).json
    expect(not verdict["ok"] and verdict["problems"], verdict)
    return " ".join(verdict["problems"])


@test
def a_good_table_passes_with_the_promised_keys():
    verdict = done("verify", scene(), built(), "--json").json
    expect_equal(sorted(verdict), KEYS)
    expect_equal([verdict["ok"], verdict["problems"]], [True, []])
    expect(verdict["min_clearance"] > -1e-6 and verdict["disc"] in (0, 1) and verdict["checked"], verdict)


@test
def a_good_path_passes():
    scene()
    verdict = done("verify", "scene.json", path_file(), "--json").json
    expect_equal(sorted(verdict), KEYS)
    expect_equal([verdict["ok"], verdict["problems"]], [True, []])
    text = done("verify", "scene.json", "p.json").out
    expect(text.startswith("ok\n") and "least clearance" in text and "checked: " in text, text)


@test
def the_path_of_a_table_passes_though_it_is_not_the_fastest():
    table = built("--epsilon", 0.2)
    verdict = done("verify", "scene.json", path_file(30, of=table), "--deep", 1, "--json").json
    expect(verdict["ok"] and verdict["min_clearance"] > 0.01, verdict)


@test
def paths_of_every_shipped_scene_pass():
    for file in all_files(SCENES, "*.json"):
        expect(done("verify", file, path_file(0, of=file), "--deep", 1, "--json").json["ok"], file)


@test
def without_discs_there_is_no_clearance():
    scene(discs=[])
    verdict = done("verify", "scene.json", path_file(), "--json").json
    expect_equal([verdict["ok"], verdict["min_clearance"], verdict["disc"], verdict["time"]], [True, None, None, None])


@test
def deep_says_that_it_solved_again():
    verdict = done("verify", scene(), built(), "--deep", 7, "--json").json
    expect(verdict["ok"] and any("solved 7 departures again" in one for one in verdict["checked"]), verdict)
    verdict = done("verify", scene(), path_file(), "--deep", 1, "--json").json
    expect(any("solved 1 departure again" in one for one in verdict["checked"]), verdict)
    plain = done("verify", scene(), built(), "--deep", 0, "--json").json
    expect(not any("deep" in one for one in plain["checked"]), plain)


@test
def deep_wants_a_number():
    built()
    for number in ["-1", "x", "1.5", "1e9"]:
        fails(2, ["--deep"], "verify", "scene.json", "t.tdsp", "--deep", number)


@test
def a_table_for_another_scene_is_stale():
    table = built()
    other = scene("other.json", destination=[10, 0.5])
    result = done("verify", other, table, status=1)
    expect("NOT OK" in result.out and "built for another scene" in result.out, result)


@test
def a_path_through_a_disc_is_found():
    scene()
    path = {"departure": 20, "arrival": 40, "status": "ok",
            "legs": [{"type": "line", "start_time": 20, "end_time": 40, "from": [-10, 0], "to": [10, 0]}]}
    verdict = done("verify", "scene.json", write("bad.json", json.dumps(path)), "--json", status=1).json
    expect("enters a disc" in " ".join(verdict["problems"]), verdict)
    expect(verdict["min_clearance"] < -0.9, verdict)


@test
def a_wrong_start_or_end_is_found():
    scene()
    expect("start" in damaged(lambda path: path["legs"][0].update({"from": [-10, 1]})), "start")
    expect("end at the destination" in damaged(lambda path: path.update(arrival=path["arrival"] - 1)), "arrival")
    expect("start" in damaged(lambda path: path.update(departure=11)), "departure")


@test
def too_fast_a_leg_is_found():
    scene()

    def hurry(path):
        path["legs"][-1]["end_time"] -= 1
        path["arrival"] -= 1
    expect("faster" in damaged(hurry), "speed")


@test
def a_missing_leg_is_found():
    scene()
    expect("join" in damaged(lambda path: path["legs"].pop(1)), "join")


@test
def an_arc_on_the_wrong_circle_is_found():
    scene()

    def move(path):
        next(leg for leg in path["legs"] if leg["type"] == "arc")["center"] = [0.5, 3]
    damaged(move)


@test
def an_arc_turned_the_wrong_way_is_found():
    scene()

    def turn(path):
        arc = next(leg for leg in path["legs"] if leg["type"] == "arc")
        arc["turn"] = "cw" if arc["turn"] == "ccw" else "ccw"
    damaged(turn)


@test
def a_file_without_a_path_cannot_be_right():
    scene()
    path = tdsp("path", "scene.json", 1000, "--json").out
    verdict = done("verify", "scene.json", write("none.json", path), "--json", status=1).json
    expect_equal(verdict["problems"], ["the file holds no path: its status is source_covered"])


@test
def broken_path_files_are_refused_with_the_place():
    scene()
    good = json.loads(pathlib.Path(path_file()).read_text())

    def refused(fragment, change):
        path = json.loads(json.dumps(good))
        change(path)
        fails(3, ["bad.json: " + fragment], "verify", "scene.json", write("bad.json", json.dumps(path)))
    arc = next(i for i, leg in enumerate(good["legs"]) if leg["type"] == "arc")
    refused("departure: missing", lambda path: path.pop("departure"))
    refused("status: missing", lambda path: path.pop("status"))
    refused("legs: must be an array", lambda path: path.update(legs=1))
    refused("legs[0].type: must be", lambda path: path["legs"][0].update(type="curve"))
    refused("legs[0].from: a point has exactly two numbers", lambda path: path["legs"][0].update({"from": [1]}))
    refused(f"legs[{arc}].disc: not the index of a disc", lambda path: path["legs"][arc].update(disc=1.5))
    refused(f"legs[{arc}].turn: must be", lambda path: path["legs"][arc].update(turn="left"))
    refused(f"legs[{arc}].radii: a point has", lambda path: path["legs"][arc].update(radii=1) or path["legs"][arc].update(radii=[1]))
    fails(3, ["bad.json:1:"], "verify", "scene.json", write("bad.json", "{"))


GROWING = [{"center": [0, 3], "radius": 1, "growth": 0.1}, {"center": [-3, -1], "radius": 1, "growth": [0.1, 0.004]},
           {"center": [5, 1.5], "radius": 0.2, "growth": {"times": [0, 5, 12], "rates": [0.1, 0.3, 0.02]}}]


@test
def paths_and_tables_among_discs_whose_rates_change_pass():
    scene(discs=GROWING)
    legs = json.loads(pathlib.Path(path_file(4)).read_text())["legs"]
    expect(any("rates" in leg for leg in legs), "no curve in the path")
    expect(done("verify", "scene.json", "p.json", "--deep", 1, "--json").json["ok"], "a good path was refused")
    done("build", "scene.json", "-o", "t.tdsp", "--horizon", 5)
    verdict = done("verify", "scene.json", "t.tdsp", "--deep", 3, "--json").json
    expect(verdict["ok"] and -1e-8 < verdict["min_clearance"] < 1e-6, verdict)
    expect(done("verify", "scene.json", path_file(3.9, of="t.tdsp"), "--json").json["ok"], "the path of a table was refused")


@test
def a_curve_with_a_wrong_number_is_found():
    scene(discs=GROWING)

    def spoil(key, change):
        def spoilt(path):
            curve = next(leg for leg in path["legs"] if "rates" in leg)
            curve[key] = curve[key] + change if key in ("sweep", "speed") else [curve[key][0] + change, curve[key][1]]
        return damaged(spoilt, departure=4)
    for key in ("radii", "rates", "bends", "sweep", "speed", "center"):
        for change in (-1e-3, 1e-3):
            spoil(key, change)
    expect("faster" in spoil("sweep", 0.05) or "well formed" in spoil("sweep", 0.05), "sweep")


@test
def a_path_into_a_disc_that_has_grown_faster_is_found():
    scene(discs=GROWING)
    path_file(4)
    faster = [dict(GROWING[1], growth=[0.1, 0.00401])]
    verdict = done("verify", scene("faster.json", discs=GROWING[:1] + faster + GROWING[2:]), "p.json", "--json", status=1).json
    expect("enters a disc" in " ".join(verdict["problems"]) and verdict["disc"] == 1, verdict)


@test
def a_full_lap_and_more_is_read_back():
    """Around a static disc from inside a ring: the number of laps is not in the file, the times tell it."""
    path = {"departure": 0, "arrival": 0, "status": "ok", "legs": []}
    disc = {"center": [0, 0], "radius": 1, "growth": 0}
    scene(source=[1, 0], destination=[1, 0], discs=[disc])
    lap = 2 * 3.141592653589793
    path["legs"] = [{"type": "arc", "start_time": 0, "end_time": lap, "from": [1, 0], "to": [1, 0], "disc": 0, "center": [0, 0],
                     "turn": "ccw", "radii": [1, 1]}]
    path["arrival"] = lap
    expect(done("verify", "scene.json", write("lap.json", json.dumps(path)), "--json").json["ok"], "a lap was refused")
    path["legs"][0]["end_time"] = path["arrival"] = lap * 0.75
    done("verify", "scene.json", write("lap.json", json.dumps(path)), status=1)


@test
def a_path_is_solved_again_also_where_there_is_none_or_it_takes_no_time():
    write("none.json", done("path", scene(), 1000, "--json", status=1).out)
    result = done("verify", "scene.json", "none.json", "--deep", 1, status=1)
    expect_equal(result.out.count("problem:"), 1, result)
    one = scene("one.json", destination=[-10, 0])
    write("still.json", done("path", one, 3, "--json").out)
    expect("the path takes 1 times the least travel time" in done("verify", one, "still.json", "--deep", 1).out, "still")


@test
def one_bad_row_is_told_as_one_and_many_as_many():
    done("build", scene(), "-o", "one.tdsp", "--horizon", 0)
    done("build", "scene.json", "-o", "many.tdsp")
    scene(discs=[{"center": [0, 0], "radius": 2, "growth": 0.1}])
    expect("1 row with a path that was rejected" in done("verify", "scene.json", "one.tdsp", status=1).out, "one")
    expect("rows with a path that was rejected" in done("verify", "scene.json", "many.tdsp", status=1).out, "many")


@test
def without_discs_the_text_names_none():
    done("build", scene(discs=[]), "-o", "t.tdsp", "--horizon", 5)
    expect("clearance:" not in done("verify", "scene.json", "t.tdsp").out, "text")


main()
