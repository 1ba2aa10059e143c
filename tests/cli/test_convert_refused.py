#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files that cannot be converted, each with what is said of it; and corners of those that can."""
import json
import pathlib

from harness import done, expect, expect_equal, fails, main, scene, test, write

CSV = "role,x,y,radius,growth,speed\nsource,0,0,,,1\ndestination,9,0,,,\ndisc,5,3,1,0.1,\n"


def geojson(features=(), **more):
    ends = [feature([7, 46], role="source", speed=1), feature([7.1, 46], role="destination")]
    return json.dumps({"type": "FeatureCollection", "features": [*ends, *features], **more})


def feature(place, **properties):
    return {"type": "Feature", "geometry": {"type": "Point", "coordinates": place}, "properties": properties}


def refused(name, cases, *options, status=3):
    for text, words in cases:
        fails(status, [words], "convert", write(name, text), *options, "--format", "json")


@test
def a_header_that_names_columns_twice_or_not_at_all_is_refused():
    refused("a.csv", [(f"{header}\n", "two columns named") for header in
                      ("x,x,y", "x,y,y", "lon,lon,lat", "lon,lat,LAT", "x,y,role,role", "x,y,radius,Radius", "x,y,growth,growth", "x,y,speed,speed")])
    refused("a.csv", [("x,z\n1,2\n", "among them x and y, or lon and lat"), ("lon,y\n1,2\n", "among them x and y"), ('"x,y\n1,2\n', "never ends")])


@test
def a_number_that_is_none_is_refused_in_every_column():
    for column in range(1, 6):
        line = ["disc", "5", "3", "1", "0.1", ""]
        line[column] = "five"
        refused("a.csv", [(CSV + ",".join(line) + "\n", f'a.csv:5: {"role,x,y,radius,growth,speed".split(",")[column]}: "five"')])
    refused("a.csv", [(CSV + ",,1,1,0\n", "a.csv:5: 5 fields"), (CSV + "disc,,1,1,0,\n", "x: missing"), (CSV + 'disc,"1,1,1,0,\n', "never ends"),
                      (CSV + 'disc,"1"2,1,1,0,\n', "something follows"), (CSV + "disc,1,1,1,0,3\n", "speed is the robot's")])


@test
def separators_and_quotes_and_line_ends_are_read_as_they_come():
    wanted = done("convert", write("a.csv", CSV), "--format", "json").out
    odd = CSV.replace("role", '"role"', 1).replace("\n", "\r\n").replace("disc,5", '\r\n \t\r\n# a comment\r\n"disc","5"')
    for text in (odd, CSV.replace(",", ";"), CSV.replace(",", "\t"), CSV.rstrip("\n"), "\n\n# first\n" + CSV + "\n  \n \t", "\ufeff" + CSV + "#"):
        expect_equal(done("convert", write("a.csv", text), "--format", "json").out, wanted)
    one = done("convert", write("b.csv", '"x"\n1\n'), "--format", "json", status=3)
    expect("among them x and y" in one.err, one)
    fails(3, ["among them"], "convert", write("b.csv", "xy"), "--format", "json")
    fails(3, ["a.csv:4: x"], "convert", write("a.csv", CSV.replace("disc,5", "disc,5\r7")), "--format", "json")


@test
def fields_of_csv_are_chosen_by_name_each_by_itself():
    named = CSV.replace("role,x,y", "role,east,north")
    wanted = done("convert", write("a.csv", CSV), "--format", "json").out
    expect_equal(done("convert", write("a.csv", named), "--x-field", "east", "--y-field", "north", "--format", "json").out, wanted)
    half = CSV.replace("role,x,y", "role,x,north")
    expect_equal(done("convert", write("a.csv", half), "--y-field", "north", "--format", "json").out, wanted)
    earth = CSV.replace("role,x,y", "role,lon,breadth").replace("9,0", "9,1")
    done("convert", write("a.csv", earth), "--lat-field", "breadth", "--format", "json", "--origin", "4,1")
    small = earth.replace("9,1", "0.9,0.1").replace("5,3", "0.5,0.3")
    expect_equal(json.loads(done("convert", write("a.csv", small), "--lat-field", "breadth", "--format", "json").out)["units"], {"length": "m", "time": "s"})
    for option in ("--x-field", "--y-field", "--lon-field", "--lat-field"):
        fails(3, ['no column "none"'], "convert", write("a.csv", CSV), option, "none", "--format", "json")
    fails(2, ["--x-field"], "convert", write("a.csv", CSV), "--x-field", "x", "--lon-field", "y", "--format", "json")
    both = "x,lon,lat\n1,2,3\n"
    fails(3, ["among them"], "convert", write("a.csv", both), "--x-field", "x", "--format", "json")


@test
def features_that_are_none_are_refused_with_their_place():
    point = {"type": "Point", "coordinates": [7, 46]}
    refused("a.geojson", [(geojson([item]), words) for item, words in (
        (3, "features[2]"), ({}, "features[2]"), ({"type": 3}, "features[2].type"), ({"type": "Point"}, "must be \"Feature\""), ({"type": "Feature"}, "geometry"),
        ({"type": "Feature", "geometry": None}, "features[2].geometry"), ({"type": "Feature", "geometry": {"type": "Polygon"}}, "a Polygon"),
        ({"type": "Feature", "geometry": {"type": "Point"}}, "coordinates"), ({"type": "Feature", "geometry": point, "properties": 3}, "properties"),
        (feature(3), "coordinates"), (feature([7]), "a longitude and a latitude"), (feature(["7", 46]), "coordinates[0]"), (feature([7, "46"]), "coordinates[1]"),
        (feature([7, 91]), "features[2]"), (feature([7, 46], role=3), "role"), (feature([7, 46], radius="wide"), "radius"),
        (feature([7, 46], radius=1, growth=0, speed="fast"), "speed"), (feature([7, 46], radius=1, growth="fast"), "growth"), (feature([7, 46], role="king"), "the role"),
        ({"type": "Feature", "geometry": {"type": "MultiPoint", "coordinates": 3}}, "coordinates"),
        ({"type": "Feature", "geometry": {"type": "MultiPoint", "coordinates": [3]}}, "coordinates[0]"),
        ({"type": "Feature", "geometry": point, "properties": None}, "no radius"), ({"type": "Feature", "geometry": point}, "no radius"))])


@test
def collections_that_are_none_are_refused_with_their_place():
    named = lambda name: {"type": "name", "properties": {"name": name}}  # noqa: E731
    refused("a.geojson", [(text, words) for text, words in (
        ('{"type": "Feature"}', "FeatureCollection"), ('{"type": 3}', "type"), ('{"type": "FeatureCollection"}', "features"),
        ('{"type": "FeatureCollection", "features": 3}', "features"), (geojson(crs=3), "crs"), (geojson(crs={}), "crs"), (geojson(crs={"properties": 3}), "crs.properties"),
        (geojson(crs={"properties": {}}), "name"), (geojson(crs={"properties": {"name": 3}}), "crs.properties.name"), (geojson(crs=named("EPSG:3857")), "EPSG:3857"),
        (geojson(units=3), "units"), (geojson() + "]", "a.geojson"), ("[]", "a.geojson"), ("[1", "a.geojson"))])
    for crs in (None, named("EPSG:4326")):
        done("convert", write("a.geojson", geojson(crs=crs)), "--format", "json")
    twice = [feature([7, 46], radius=1, growth=0, colour="red"), feature([7, 46.01], radius=1, growth=0, colour="red")]
    report = done("convert", write("a.geojson", geojson(twice)), "-o", "b.json", "--json").json
    expect_equal(report["ignored"], ["colour"])


@test
def ends_that_say_what_they_cannot_are_refused():
    for line, words in (("source,1,1,,,\n", "a second source"), ("destination,1,1,,,\n", "a second destination"), ("disc,1,1,-1,0,\n", "the radius"),
                        ("disc,1,1,,0,\n", "no radius"), ("disc,1,1,1,,\n", "no growth")):
        refused("a.csv", [(CSV + line, f"a.csv:5: {words}")])
    head = "role,x,y,radius,growth,speed\n"
    for line, words in (("source,0,0,,1,1\n", "a source does not grow"), ("source,0,0,,,0\n", "the robot's speed must be greater than zero"), ("source,0,0,-1,,1\n", "the robot's radius must not be negative"),
                        ("destination,0,0,1,,\n", "a destination is a point"), ("destination,0,0,,2,\n", "a destination is a point"),
                        ("destination,0,0,,,2\n", "a destination is a point")):
        refused("a.csv", [(head + line, f"a.csv:2: {words}")])
    law = feature([7, 46.1], role="destination", growth={"times": [0, 1], "rates": [0, 1]})
    refused("a.geojson", [(json.dumps({"type": "FeatureCollection", "features": [law]}), "a destination is a point")])
    done("convert", write("a.csv", CSV.replace("destination,9,0,,,", "destination,9,0,0,0,")), "--format", "json")


@test
def what_is_asked_for_and_what_is_there_must_not_contradict_each_other():
    other = scene("other.json", units={"length": "km", "time": "h"}, georeference={"origin": [7, 46]})
    both = scene("both.json", units={"length": "m", "time": "s"}, georeference={"origin": [7, 46]})
    write("a.csv", CSV)
    write("a.geojson", geojson())
    far = write("far.geojson", geojson([feature([90, 46], radius=1, growth=0)]))
    for status, words, arguments in (
            (2, "nothing is converted", (both, "--units", "km,s")), (2, "nothing is converted", (both, "--units", "m,h")), (2, "nothing is converted", (both, "--scene", other)),
            (2, "two units", ("a.csv", "--units", "m")), (2, "two units", ("a.csv", "--units", ",s")), (2, "two units", ("a.csv", "--units", "m,")),
            (2, "contradict", ("a.csv", "--scene", both, "--origin", "8,46")), (2, "contradict", ("a.csv", "--scene", both, "--origin", "7,47")),
            (2, "another origin", (both, "--origin", "8,46")), (2, "another origin", (both, "--origin", "7,47")), (2, "--origin", ("a.csv", "--origin", "x")),
            (2, "--speed", ("a.csv", "--speed", "x")), (2, "--robot-radius", ("a.csv", "--robot-radius", "x")), (2, "greater than zero", ("a.csv", "--speed", "0")),
            (2, "--from", ("a.csv", "--from", "1")), (2, "--from", ("a.geojson", "--from", "1")), (2, "--to", ("a.csv", "--to", "1,x")),
            (2, "--to", ("a.geojson", "--to", "1,99")), (2, "from the origin", ("a.geojson", "--from", "100,0", "--origin", "7,46")),
            (2, "from the origin", ("a.geojson", "--to", "100,0", "--origin", "7,46")), (3, "features[2]", (far, "--origin", "7,46")),
            (3, "features[0]", ("a.geojson", "--origin", "100,0")), (3, "", ("a.geojson", "--units", "furlong,s"))):
        fails(status, [words], "convert", *arguments, "--format", "json")
    for arguments in ((both, "--units", "m,s"), ("a.csv", "--scene", both, "--origin", "7,46"), (both, "--origin", "7,46"), (both, "--robot-radius", "2")):
        done("convert", *arguments, "--format", "json")


@test
def a_scene_of_half_its_words_takes_the_rest_from_another():
    like = scene("like.json", robot={"speed": 2, "radius": 0.5}, units={"length": "m", "time": "s"}, georeference={"origin": [7, 46]})
    bare = "x,y,radius,growth\n1,2,1,0\n"
    made = json.loads(done("convert", write("a.csv", bare), "--scene", like, "--format", "json").out)
    expect_equal((made["source"], made["destination"], made["robot"]), ([-10, 0], [10, 0], {"speed": 2, "radius": 0.5}))
    earth = "role,lon,lat,radius,growth\n,7,46,1,0\n"
    plain = scene("plain.json")
    fails(2, ["--origin"], "convert", write("b.csv", earth), "--scene", plain, "--format", "json")
    fails(2, ["--origin"], "convert", write("b.csv", earth + "source,7,46,,\n"), "--scene", plain, "--format", "json")
    for more in ("", "source,7,46,,\n", "destination,7,46.1,,\n"):
        done("convert", write("b.csv", earth + more), "--scene", like, "--format", "json")
    for ends in (("--from", "7,46"), ("--to", "7,46"), ()):
        fails(2, ["has no"], "convert", write("c.csv", bare), *ends, "--speed", 1, "--format", "json")


@test
def units_are_written_each_by_itself():
    for units in ({"length": "m"}, {"time": "s"}, {"length": "m", "time": "s"}, {}):
        made = json.loads(done("convert", scene(units=units), "--format", "json").out)
        expect_equal(made.get("units", {}), units)
        text = done("convert", "scene.json", "--format", "csv")
        expect_equal("its units" in text.err, bool(units), text.err)


@test
def paths_that_cannot_be_converted_are_refused():
    still = {"departure": 0, "arrival": 0, "status": "ok", "legs": []}
    line = {"type": "line", "start_time": 0, "end_time": 20, "from": [-10, 0], "to": [10, 0]}
    path = {"departure": 0, "arrival": 20, "status": "ok", "legs": [line]}
    write("p.json", json.dumps(path))
    for status, words, text, options in (
            (1, "no legs", still, ()), (1, "no path", {**still, "arrival": None, "status": "cut_off"}, ()), (2, "--speed", path, ("--speed", "x")),
            (2, "--units", path, ("--units", "m")), (3, "p.json", {**path, "legs": 3}, ()),
            (2, "how fast", {**still, "legs": [{**line, "end_time": 0, "to": [-10, 0]}]}, ()),
            (2, "--tolerance", path, ("--tolerance", "x")), (2, "--epoch", path, ("--epoch", "x", "--units", "m,s")),
            (2, "9999", {**path, "arrival": 1e12, "legs": [{**line, "end_time": 1e12}]}, ("--epoch", "2026-06-01T12:00:00Z", "--units", "m,s")),
            (2, "9999", {**path, "departure": 1e12, "arrival": 1e12 + 20, "legs": [{**line, "start_time": 1e12, "end_time": 1e12 + 20}]},
             ("--epoch", "2026-06-01T12:00:00Z", "--units", "m,s"))):
        fails(status, [words], "convert", write("p.json", json.dumps(text)), *options, "--format", "csv")
    write("p.json", json.dumps(path))
    fails(2, ["--origin"], "convert", "p.json", "--format", "geojson")
    fails(2, ["--epoch"], "convert", "p.json", "--format", "gpx", "--origin", "7,46", "--units", "m,s")
    expect(done("convert", "p.json", "--format", "csv").out.startswith("time,x,y,leg,type,disc\n"), "csv")


@test
def paths_on_the_earth_are_written_with_and_without_a_name():
    done("path", scene("s.json", georeference={"origin": [0, 0]}), 5, "--json")
    pathlib.Path("p.json").write_text(done("path", "s.json", 5, "--json").out)
    for name in ("s.json", scene("t.json", name="", georeference={"origin": [0, 0]})):
        for form in ("gpx", "geojson", "csv"):
            text = done("convert", "p.json", "--scene", name, "--format", form, "--epoch", "2026-06-01T12:00:00Z").out
            expect(len(text) > 100 and '"-0"' not in text, text)


@test
def the_corners_of_the_earth_and_of_time_are_written():
    line = {"type": "line", "start_time": 0, "end_time": 20, "from": [-1e-6, 0], "to": [20, 0]}
    path = {"departure": 0, "arrival": 20, "status": "ok", "legs": [line]}
    write("p.json", json.dumps(path))
    earth = ("--origin", "0,0", "--units", "m,s", "--epoch", "1960-06-01T12:00:00.25Z")
    text = done("convert", "p.json", "--format", "gpx", *earth).out
    expect('lon="0"' in text and "1960-06-01T12:00:00.25Z" in text and "1960-06-01T12:00:20.25Z" in text, text)
    moment = {"departure": 3, "arrival": 3, "status": "ok", "legs": [{**line, "start_time": 3, "end_time": 3, "to": [-1e-6, 0]}]}
    text = done("convert", write("m.json", json.dumps(moment)), "--format", "geojson", "--speed", 1, *earth).out
    lines = [feature["geometry"] for feature in json.loads(text)["features"] if feature["geometry"]["type"] == "LineString"]
    expect(lines and len(lines[0]["coordinates"]) == 2 and lines[0]["coordinates"][0] == lines[0]["coordinates"][1], text)


@test
def places_opposite_the_origin_and_origins_that_are_none_are_refused():
    opposite = "role,lon,lat,radius,growth,speed\nsource,0,0,,,1\ndestination,1,0,,,\n,179.7,0.3,1,0,\n"
    fails(3, ["a.csv:4"], "convert", write("a.csv", opposite), "--origin", "0,0", "--format", "json")
    for origin in (3, [1], ["a", 2], [1, 91]):
        fails(3, ["georeference"], "convert", scene(georeference={"origin": origin}), "--format", "csv")
    for one, other in (("--y-field", "--lat-field"), ("--x-field", "--lat-field"), ("--y-field", "--lon-field")):
        fails(2, ["not both"], "convert", write("a.csv", CSV), one, "y", other, "x", "--format", "json")
    fails(3, ["s.json"], "convert", write("s.json", '{"robot": 3}'), "--format", "csv")


@test
def a_file_that_is_not_there_or_cannot_be_written_is_the_system_s_failure():
    fails(4, ["absent.csv"], "convert", "absent.csv", "--format", "json")
    write("a.csv", CSV)
    fails(4, ["/dev/full"], "convert", "a.csv", "-o", "/dev/full", "--format", "json")
    fails(2, ["--role-field"], "convert", scene(), "--role-field", "r", "--format", "csv")


main()
