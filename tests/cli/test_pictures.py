#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pictures: whole SVG and PNG files of scenes and tables."""
import os
import pathlib
import struct
import xml.etree.ElementTree as xml
import zlib

from harness import ROOT, SCENES, TWO_DISCS, all_files, built, done, expect, expect_equal, fails, main, scene, test, write


def png_size(name):
    """Width and height of a PNG whose every chunk has the right checksum and whose pixels unpack to the right length."""
    data = pathlib.Path(name).read_bytes()
    expect(data.startswith(b"\x89PNG\r\n\x1a\n"), "no PNG")
    at, pixels, kinds = 8, b"", []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        expect_equal(struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0], zlib.crc32(kind + body), "checksum")
        kinds.append(kind)
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            pixels += body
        at += 12 + length
    expect_equal(kinds[-1], b"IEND")
    expect_equal(len(zlib.decompress(pixels)), height * (1 + width * {2: 3, 6: 4}[colour] * depth // 8))
    return width, height


def svg_counts(name):
    """How many elements of each kind a well-formed SVG has."""
    root = xml.parse(name).getroot()
    expect(root.tag.endswith("}svg") and root.get("width") and root.get("viewBox"), root.attrib)
    counts = {}
    for element in root.iter():
        kind = element.tag.split("}")[1]
        counts[kind] = counts.get(kind, 0) + 1
    return counts


def expect_drawn(name):
    counts = svg_counts(name)
    expect(counts.get("path", 0) > 5 and counts.get("text", 0) > 10, f"hardly anything was drawn: {counts}")


@test
def a_scene_becomes_an_svg():
    done("plot", scene(), "-o", "a.svg")
    expect_drawn("a.svg")


@test
def a_scene_becomes_a_png():
    done("plot", scene(), "-o", "a.PNG")
    width, height = png_size("a.PNG")
    expect(width > 1000 and height > 800, (width, height))


@test
def a_table_becomes_an_svg_and_a_png():
    table = built()
    done("plot", table, "-o", "t.svg")
    done("plot", table, "-o", "t.png", "--depart", 5)
    expect_drawn("t.svg")
    expect_equal(png_size("t.png"), (1680, 1080))


@test
def the_same_picture_is_drawn_twice():
    for name in ("a.svg", "b.svg", "a.png", "b.png"):
        done("plot", scene(), "-o", name, "--depart", 12)
    for ending in (".svg", ".png"):
        expect(pathlib.Path("a" + ending).read_bytes() == pathlib.Path("b" + ending).read_bytes(), ending)


@test
def the_departure_changes_the_picture():
    done("plot", scene(), "-o", "a.svg")
    done("plot", scene(), "-o", "b.svg", "--depart", 12)
    expect(pathlib.Path("a.svg").read_bytes() != pathlib.Path("b.svg").read_bytes(), "they are the same")


@test
def the_gaps_behind_jumps_are_marked_in_a_scene_on_request():
    done("plot", scene(), "-o", "a.svg")
    done("plot", scene(), "-o", "b.svg", "--jumps")
    expect(svg_counts("b.svg")["path"] > svg_counts("a.svg")["path"], "no mark")
    open_scene = scene("open.json", discs=[{"center": [0, 50], "radius": 1, "growth": 0}])
    fails(2, ["--horizon"], "plot", open_scene, "-o", "c.svg", "--jumps")
    done("plot", open_scene, "-o", "c.svg", "--jumps", "--horizon", 10)
    fails(2, ["--horizon"], "plot", scene(), "-o", "c.svg", "--jumps", "--horizon", "x")
    done("plot", scene(discs=[{"center": [-10, 0], "radius": 1, "growth": 0}]), "-o", "c.svg", "--jumps")


@test
def any_other_ending_is_a_usage_error():
    for name in ("a.pdf", "a", "svg", "a.svg.gz"):
        fails(2, [name, ".svg or .png"], "plot", scene(), "-o", name)
    expect_equal(os.listdir(), ["scene.json"])


@test
def a_scene_without_a_path_is_drawn_with_a_warning():
    result = done("plot", scene(), "-o", "a.svg", "--depart", 1000)
    expect("no path" in result.err, result)
    svg_counts("a.svg")
    report = done("plot", scene(), "-o", "a.svg", "--depart", 1000, "--json").json
    expect_equal(report, {"file": "a.svg", "of": "scene", "departure": 1000, "arrival": None, "status": "source_covered", "seconds": None})


@test
def json_tells_what_was_drawn():
    report = done("plot", scene(), "-o", "a.svg", "--depart", 5, "--json").json
    expect_equal(report, {"file": "a.svg", "of": "scene", "departure": 5, "arrival": 25, "status": "ok", "seconds": None})
    report = done("plot", built(), "-o", "a.svg", "--json").json
    expect_equal(report, {"file": "a.svg", "of": "table", "departure": None, "arrival": None, "status": "ok", "seconds": None})


@test
def scenes_of_every_shape_are_drawn():
    far = {"center": [1e9, 1e9], "radius": 1e8, "growth": 0}
    point = {"center": [9, 9], "radius": 0, "growth": 0}
    shapes = {"one place": {"destination": [-10, 0]}, "one empty place": {"destination": [-10, 0], "discs": []},
              "one place and a point": {"destination": [-10, 0], "discs": [point]}, "no discs": {"discs": []}, "one far disc": {"discs": [far]},
              "points": {"discs": [{"center": [0, 0], "radius": 0, "growth": 0}]},
              "inside": {"discs": [{"center": [0, 0], "radius": 1e6, "growth": 0}]},
              "upright": {"source": [0, 0], "destination": [0, 1000], "discs": []},
              "tiny": {"source": [0, 0], "destination": [1e-6, 1e-7], "discs": []},
              "huge": {"source": [0, 0], "destination": [1e12, 1e7], "discs": []}, "no units": {"units": {}, "name": ""}}
    for name, changes in shapes.items():
        done("plot", scene(**changes), "-o", "a.svg")
        svg_counts("a.svg")
        done("plot", "scene.json", "-o", "a.png")
        width, height = png_size("a.png")
        expect(1000 < width < 3000 and 1000 < height < 3000, f"{name}: {width} by {height}")


@test
def discs_that_are_the_same_are_drawn_once():
    disc, small = {"center": [1, 4], "radius": 1, "growth": 0.1}, {"center": [1, 4], "radius": 0.5, "growth": 0.1}
    dots = []
    for discs in ([disc, small], [disc, small, disc, disc]):
        done("plot", scene(discs=discs), "-o", "a.svg")
        dots.append(pathlib.Path("a.svg").read_text().count("h0"))
    expect_equal(dots[0], dots[1], "dots")


@test
def ticks_where_adding_one_changes_nothing_come_to_an_end():
    """A departure of 1e17 takes steps of 16: counting ticks by adding 1 to 5e16 never ended. So did axes far from the origin."""
    nothing = scene(discs=[])
    done("plot", nothing, "-o", "a.svg", "--depart", 1e17, timeout=20)
    done("plot", nothing, "-o", "a.svg", "--depart", 1e17, "--animate", timeout=20)
    done("plot", scene(source=[1e18, 0], destination=[1e18 + 256, 0], discs=[]), "-o", "a.svg", timeout=20)
    svg_counts("a.svg")


@test
def names_that_are_no_text_are_drawn_none_the_less():
    scene(name="<a> & \"b\" \u0001\uffff\u202e c")
    for name in ("a.svg", "a.png"):
        done("plot", "scene.json", "-o", name)
    expect("<a> & \"b\"" in [text.text[:9] for text in xml.parse("a.svg").getroot().iter() if text.tag.endswith("}text")], "no name")
    os.rename(built(), b"\xff&.tdsp")
    done("plot", b"\xff&.tdsp".decode(errors="surrogateescape"), "-o", "a.svg")
    svg_counts("a.svg")


@test
def every_shipped_scene_is_drawn():
    for file in all_files(SCENES, "*.json"):
        done("plot", file, "-o", "a.svg")
        svg_counts("a.svg")


@test
def tables_of_every_shape_are_drawn():
    for changes, options in [({"destination": [-10, 0], "discs": []}, ["--horizon", 0]), ({"discs": []}, ["--horizon", 1e6]),
                             ({}, ["--epsilon", 1]), ({}, ["--epsilon", 1e-4]), ({}, ["--guarantee", "absolute", "--delta", 1])]:
        done("build", scene(**changes), "-o", "t.tdsp", *options)
        done("plot", "t.tdsp", "-o", "a.svg", "--depart", 0)
        svg_counts("a.svg")
    expect(pathlib.Path("a.svg").stat().st_size < 500000, "the picture of a large table is large")


@test
def a_file_that_is_nothing_is_refused():
    fails(3, ["neither JSON nor a table"], "plot", write("x", "hello"), "-o", "a.svg")


@test
def tables_of_every_make_are_drawn_and_told():
    """With jumps at the last row, without known gaps, with and without units, of one row, of bytes for paths."""
    for folder in ("independent/golden", "golden/answered"):
        for table in all_files(ROOT / "tests" / folder, "*.tdsp"):
            report = done("info", table, "--json").json
            text = done("info", table).out
            done("plot", table, "-o", "a.svg")
            expect_drawn("a.svg")
            known = [jump for jump in report["jumps"] if jump["first"] is not None]
            expect_equal(text.count(" close at "), len(known), f"{table}: {text}")


FOUR = [*TWO_DISCS["discs"], {"center": [0, 9], "radius": 1, "growth": 0.05}, {"center": [0, -14], "radius": 1, "growth": 0.12}]


@test
def jumps_of_several_sizes_are_labelled_in_tables_and_scenes():
    for units in ({"time": "s"}, {}):
        scene(discs=FOUR, units=units)
        expect_equal(len(done("jumps", "scene.json").rows()), 2, "jumps")
        done("plot", "scene.json", "-o", "a.svg", "--jumps")
        done("build", "scene.json", "-o", "t.tdsp")
        done("plot", "t.tdsp", "-o", "b.svg")
        for name in ("a.svg", "b.svg"):
            svg_counts(name)


@test
def a_legend_wider_than_the_picture_goes_on_in_a_second_line():
    turned = [{**disc, "center": disc["center"][::-1]} for disc in TWO_DISCS["discs"]]
    upright = scene(source=[0, -10], destination=[0, 10], discs=turned, units={"length": "cubits of Nippur", "time": "watches of the night"})
    done("plot", upright, "-o", "a.svg", "--jumps", "--depart", 12)
    svg_counts("a.svg")


@test
def a_path_that_begins_with_a_ride_or_just_before_a_tick_is_drawn():
    edge = scene(source=[-3, 0], discs=[{"center": [0, 0], "radius": 3, "growth": 0}])
    expect_equal(done("path", edge, 0, "--json").json["legs"][0]["type"], "arc")
    done("plot", edge, "-o", "a.svg")
    done("plot", scene(), "-o", "b.svg", "--depart", 1.9)
    for name in ("a.svg", "b.svg"):
        svg_counts(name)


@test
def who_asks_for_a_gif_is_told_how_to_get_what_moves():
    fails(2, ["a.gif: a moving picture is an SVG: -o FILE.svg --animate"], "plot", scene(), "-o", "a.gif")
    expect(not os.path.exists("a.gif"), "a file is there")


@test
def a_jump_that_only_the_very_last_departures_are_after_leaves_the_picture():
    done("build", ROOT / "tools/page/gallery/nsquared.json", "-o", "n.tdsp", "--epsilon", "1e-4")
    done("plot", "n.tdsp", "-o", "a.svg")
    texts = [element.text for element in xml.parse("a.svg").getroot().iter() if element.tag.endswith("}text")]
    expect("356038: discs 4 and 9 close, to 550.748" in texts, texts)
    expect("248781: discs 3 and 9 close" in texts, "the others are pressed flat")
    expect("540" not in texts, "the axis goes on past the jump")


@test
def json_tells_the_departure_marked_in_a_table():
    report = done("plot", built(), "-o", "a.svg", "--depart", 5, "--json").json
    expect_equal((report["of"], report["departure"], report["status"]), ("table", 5, "ok"))
    expect(25 <= report["arrival"] <= 25.3, report)


main()
