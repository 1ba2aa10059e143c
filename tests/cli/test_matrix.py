#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Matrices, and other ends than a scene's own."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "independent"))

from harness import GAP_CLOSES, done, expect, expect_equal, expect_near, fails, main, paired, scene, test, write  # noqa: E402
from read_matrix import Matrix  # noqa: E402

FROM = "-10,0,gate\n# a comment\n-10 5 north pier\n\n0,3 # covered\n"
TO = "10,0,A\n 0 9 , high up\n-10\t0\n"


def matrix(*options):
    write("from.csv", FROM)
    write("to.csv", TO)
    return done("matrix", scene(), "--sources", "from.csv", "--destinations", "to.csv", "-o", "m.tdspm", "--horizon", 30, "--json", *options).json


@test
def a_matrix_answers_like_the_exact_solver_between_its_places():
    report = matrix()
    expect_equal([report[key] for key in ("sources", "destinations", "tables", "matrix")], [3, 3, 6, "m.tdspm"])
    expect_equal(pathlib.Path("m.tdspm").stat().st_size, report["bytes"])
    for i, start in enumerate(("-10,0", "-10,5")):
        for j, end in enumerate(("10,0", "0,9", "-10,0")):
            exact = done("arrive", "scene.json", 0, 5, 9, f"--from={start}", f"--to={end}", "--json").json["results"]
            given = done("query", "m.tdspm", 0, 5, 9, "--from", i, "--to", j, "--json").json["results"]
            for one, other in paired(exact, given):
                expect(other["lower"] <= one["arrival"] <= other["upper"], f"{one} is outside {other}")


@test
def pairs_go_by_number_or_name_and_say_why_there_is_no_way():
    matrix()
    by_name = done("query", "m.tdspm", 5, "--from", "north pier", "--to", "high up").out
    expect_equal(by_name, done("query", "m.tdspm", 5, "--from", 1, "--to", 1).out)
    latest = done("query", "m.tdspm", "--from", "gate", "--to", "A", "--arrive-by", 30.35, "--json").json["results"][0]
    expect_near(latest["departure"], GAP_CLOSES, 1e-6)
    covered = done("query", "m.tdspm", 0, 1, "--from", 2, "--to", "A", "--json", status=1).json["results"]
    expect_equal([answer["status"] for answer in covered], ["source_covered"] * 2)


@test
def the_number_of_threads_does_not_change_a_byte():
    matrix("--threads", 1)
    alone = pathlib.Path("m.tdspm").read_bytes()
    matrix("--threads", 3)
    expect_equal(pathlib.Path("m.tdspm").read_bytes(), alone)


@test
def a_table_in_a_matrix_is_that_of_build_between_the_places_up_to_rounding():
    matrix()
    done("build", "scene.json", "--from=-10,5", "--to", "0,9", "--horizon", 30, "-o", "t.tdsp")
    one = done("query", "t.tdsp", 0, 10, 20, "--json").json["results"]
    other = done("query", "m.tdspm", 0, 10, 20, "--from", 1, "--to", 1, "--json").json["results"]
    for a, b in paired(one, other):
        expect_near(a["upper"], b["upper"], 0.02 * a["upper"])


@test
def info_verify_and_an_independent_reader_agree():
    matrix()
    facts = done("info", "m.tdspm", "--json").json
    expect_equal([place["name"] for place in facts["sources"]], ["gate", "north pier", None])
    read = Matrix(pathlib.Path("m.tdspm").read_bytes())
    expect_equal([name or None for _, name in read.sources], ["gate", "north pier", None])
    expect_equal([list(place) for place, _ in read.destinations], [place["place"] for place in facts["destinations"]])
    for pair in facts["pairs"]:
        table = read.table(pair["from"], pair["to"])
        expect_equal(len(table) if table else 0, pair["bytes"])
    expect(done("verify", "scene.json", "m.tdspm", "--json").json["ok"], "verify")
    expect("6 " not in done("info", "m.tdspm").out.splitlines()[0], "the heading counts places")
    write("other.json", pathlib.Path("scene.json").read_text().replace("0.1", "0.11"))
    done("verify", "other.json", "m.tdspm", status=1)


@test
def a_damaged_matrix_is_refused():
    matrix()
    data = bytearray(pathlib.Path("m.tdspm").read_bytes())
    data[300] ^= 1
    pathlib.Path("bad.tdspm").write_bytes(data)
    fails(3, [], "info", "bad.tdspm")
    pathlib.Path("short.tdspm").write_bytes(data[:100])
    fails(3, [], "query", "short.tdspm", 0, "--from", 0, "--to", 0)


@test
def lists_that_are_wrong_are_refused_with_file_line_and_reason():
    write("to.csv", TO)
    for text, line in (("1,2\n3\n", 2), ("1,nan\n", 1), ("# x\n1,2,\xff\n", None), ("1,2\nx,3\n", 2), ("1e999,0\n", 1), ("1,2e100\n", 1), ("", None)):
        pathlib.Path("from.csv").write_bytes(text.encode("latin-1"))
        result = fails(3, [], "matrix", scene(), "--sources", "from.csv", "--destinations", "to.csv", "-o", "m.tdspm", "--horizon", 30)
        expect("from.csv" in result.err and (line is None or f"from.csv:{line}:" in result.err), result.err)
        expect(not pathlib.Path("m.tdspm").exists(), "no file is left")


@test
def what_cannot_be_asked_of_a_matrix_is_refused():
    matrix()
    fails(2, [], "query", "m.tdspm", 0)
    fails(2, [], "query", "m.tdspm", 0, "--from", 0)
    fails(2, [], "query", "m.tdspm", 0, "--from", 3, "--to", 0)
    fails(2, [], "query", "m.tdspm", 0, "--from", "nowhere", "--to", 0)
    fails(3, [], "path", "m.tdspm", 0)
    done("build", "scene.json", "-o", "t.tdsp")
    fails(2, [], "query", "t.tdsp", 0, "--from", 0, "--to", 0)
    fails(2, [], "path", "t.tdsp", 0, "--from", "1,2")
    fails(2, [], "matrix", "scene.json", "--sources", "from.csv", "-o", "m.tdspm")
    fails(2, [], "matrix", "scene.json", "--sources", "from.csv", "--destinations", "to.csv")
    fails(4, [], "matrix", "scene.json", "--sources", "none.csv", "--destinations", "to.csv", "-o", "m.tdspm")


@test
def a_matrix_without_any_way_is_not_built():
    write("from.csv", "0,3\n")
    write("to.csv", TO)
    result = done("matrix", scene(), "--sources", "from.csv", "--destinations", "to.csv", "-o", "m.tdspm", "--json", status=1)
    expect(not pathlib.Path("m.tdspm").exists(), "no file is left")
    expect_equal(result.json["matrix"], None)


@test
def other_ends_are_those_of_a_scene_with_them():
    text = pathlib.Path(scene()).read_text()
    expect("[-10, 0]" in text, "the scene's source")
    write("other.json", text.replace("[-10, 0]", "[-9, 2]").replace("[10, 0]", "[4, -6]"))
    ends = ["--from=-9,2", "--to", "4,-6"]

    def told(result):
        return [{key: value for key, value in answer.items() if key != "seconds"} for answer in result.json["results"]]

    for command in ("arrive", "depart"):
        expect_equal(told(done(command, "scene.json", 20, *ends, "--json")), told(done(command, "other.json", 20, "--json")))
    expect_equal(done("path", "scene.json", 3, *ends).out, done("path", "other.json", 3).out)
    done("build", "scene.json", "-o", "a.tdsp", *ends)
    done("build", "other.json", "-o", "b.tdsp")
    expect_equal(pathlib.Path("a.tdsp").read_bytes(), pathlib.Path("b.tdsp").read_bytes())
    done("verify", "scene.json", "a.tdsp", *ends)
    done("verify", "scene.json", "a.tdsp", status=1)
    done("plot", "scene.json", "-o", "a.svg", *ends)
    done("plot", "other.json", "-o", "b.svg")
    for wrong in ("1", "1,2,3", "1,x", "", "1,1e200"):
        fails(2, [], "arrive", "scene.json", 0, f"--from={wrong}")


    


@test
def a_pair_without_a_table_answers_arrivals_too_and_an_empty_name_is_none():
    matrix()
    answers = done("query", "m.tdspm", "--from", 2, "--to", 0, "--arrive-by", 20, 30, "--json", status=1).json["results"]
    expect_equal([answer["status"] for answer in answers], ["source_covered"] * 2)
    fails(2, ['--from ""', "no name"], "query", "m.tdspm", 5, "--from", "", "--to", 0)


@test
def a_pair_whose_source_is_covered_elsewhere_is_a_problem():
    write("from.csv", "-10,0\n")
    write("to.csv", "10,0\n0,3\n")
    done("matrix", scene(), "--sources", "from.csv", "--destinations", "to.csv", "-o", "m.tdspm", "--horizon", 3)
    other = scene("other.json", discs=[{"center": [-10, 0], "radius": 1, "growth": 0}])
    report = done("verify", other, "m.tdspm", status=1).out
    expect("but the source is covered" in report, report)


if __name__ == "__main__":
    main()
