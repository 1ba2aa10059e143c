#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Made-up scenes: valid, as large as asked for, the same for the same seed, and of their kind."""
import itertools
import json
import math
import pathlib

from harness import add, done, expect, expect_equal, fails, main, test, write

KINDS = ["random", "crowd", "wall", "mixed", "columns", "nsquared"]
CONSTRUCTIONS = ("columns", "nsquared")


def generated(kind, *options):
    return done("generate", kind, *options).json


def kind_is_valid(kind):
    def check():
        for n in (6, 60):
            text = done("generate", kind, "--n", n).out
            discs = len(json.loads(text)["discs"])
            expect(2 * n + 3 <= discs <= 2 * n + 40 if kind == "nsquared" else discs == n, discs)
            result = done("arrive", write("scene.json", text), 0)
            expect_equal([result.err, result.rows()[0][3]], ["", "ok"])
    return check


def kind_repeats(kind):
    def check():
        expect_equal(done("generate", kind, "--n", 30, "--seed", 5).out, done("generate", kind, "--n", 30, "--seed", 5).out)
        if kind not in CONSTRUCTIONS:
            expect(generated(kind, "--seed", 5)["discs"] != generated(kind, "--seed", 6)["discs"], "the seed changes nothing")
    return check


for name in KINDS:
    add(f"{name} makes scenes that are read without a warning and have a path", kind_is_valid(name))
    add(f"{name} makes the same scene for the same seed", kind_repeats(name))


def gaps(discs):
    for one, other in itertools.combinations(discs, 2):
        yield math.dist(one["center"], other["center"]) - one["radius"] - other["radius"]


@test
def random_and_mixed_discs_keep_apart_and_crowds_are_of_one_size():
    for kind in ("random", "mixed", "crowd"):
        expect(min(gaps(generated(kind, "--n", 200)["discs"])) > 0, kind)
    expect_equal(len({disc["radius"] for disc in generated("crowd")["discs"]}), 1)
    expect(len({disc["radius"] for disc in generated("random")["discs"]}) > 50, "random discs are alike")


@test
def mixed_has_three_rates_and_the_others_one():
    rates = sorted({disc["growth"] for disc in generated("mixed", "--n", 60)["discs"]})
    expect_equal(len(rates), 3)
    expect_equal(rates[0], 0)
    for kind in ("random", "crowd", "wall", "columns", "nsquared"):
        expect_equal(len({disc["growth"] for disc in generated(kind, "--n", 60)["discs"]}), 1, kind)


@test
def walls_are_columns_of_touching_discs_with_gaps():
    discs = generated("wall", "--n", 100)["discs"]
    near = sorted(gaps(discs))
    expect(sum(gap <= 0 for gap in near) > 80, "the discs do not touch")
    columns = {round(disc["center"][0] / 5) for disc in discs}
    expect(len(columns) >= 3, columns)


@test
def growth_can_be_chosen():
    expect(all(disc["growth"] == 0 for disc in generated("random", "--growth", 0)["discs"]), "something grows")
    slow, fast = (generated("crowd", "--growth", growth)["discs"][0]["growth"] for growth in (0.1, 0.2))
    expect(abs(fast / slow - 2) < 1e-3, (slow, fast))
    fails(2, ["--growth"], "generate", "crowd", "--growth", "-1")
    for kind in CONSTRUCTIONS:
        fails(2, ["--growth", kind], "generate", kind, "--growth", "1")


@test
def nsquared_has_more_pieces_than_the_square_of_its_gaps_and_columns_two_a_gap():
    for n in (2, 5):
        done("generate", "nsquared", "--n", n, "-o", "n.json")
        done("generate", "columns", "--n", 3 * n, "-o", "c.json")
        expect(n * n <= done("envelope", "n.json", "--json").json["F"] <= n * n + 2 * n, n)
        expect_equal(done("envelope", "c.json", "--json", "--horizon", 300).json["F"], 2 * n)


@test
def wrong_kinds_and_numbers_are_usage_errors():
    fails(2, ['no kind "maze"', "random, crowd, wall, mixed, columns, nsquared"], "generate", "maze")
    for number in ["0", "-1", "1e3", "x", "99999999999"]:
        fails(2, ["--n"], "generate", "random", "--n", number)
    fails(2, ["--n", "6"], "generate", "columns", "--n", "5")
    fails(2, ["--n", "2", "1000"], "generate", "nsquared", "--n", "1")
    fails(2, ["--n", "2", "1000"], "generate", "nsquared", "--n", "1001")
    fails(2, ["--seed"], "generate", "random", "--seed", "-1")


@test
def a_scene_may_be_written_to_a_file():
    text = done("generate", "crowd", "--n", 9).out
    result = done("generate", "crowd", "--n", 9, "-o", "c.json")
    expect_equal([result.out, pathlib.Path("c.json").read_text()], ["", text])
    report = done("generate", "crowd", "--n", 9, "-o", "c.json", "--json").json
    expect_equal(report, {"file": "c.json", "kind": "crowd", "discs": 9, "seed": 1})


@test
def many_discs_are_placed():
    expect_equal(len(generated("random", "--n", 20000)["discs"]), 20000)


main()
