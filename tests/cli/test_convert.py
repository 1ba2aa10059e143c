#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tdsp convert: scenes come back as the same numbers, places on the earth within a stated error, paths within their tolerance; and what a format cannot hold is refused."""
import datetime
import json
import math
import pathlib
import random
import subprocess
import xml.etree.ElementTree

from harness import SCENES, TDSP, TWO_DISCS, done, expect, expect_equal, expect_near, fails, main, paired, scene, test, tdsp, write

GPX = "{http://www.topografix.com/GPX/1/1}"
EPOCH = ("--epoch", "2026-06-01T12:00:00Z")
ORIGIN = [-119.8, 44.45]
LAID = {"georeference": {"origin": ORIGIN}}


def converted(*arguments, **more):
    return json.loads(done("convert", *arguments, **more).out)


def point(lon, lat, **properties):
    return {"type": "Feature", "geometry": {"type": "Point", "coordinates": [lon, lat]}, "properties": properties}


def collection(*features, **members):
    return json.dumps({"type": "FeatureCollection", "features": list(features), **members})


FIRES = [point(-119.9, 44.4, radius=375, growth=0.3, brightness=301), point(-119.7, 44.5, radius=375, growth=0.3)]
ENDS = [point(-120, 44.3, role="source", speed=6), point(-119.6, 44.6, role="destination")]


# ------------------------------------------------------------------------------------------------------------------------ CSV

def random_scene(generator):
    def number(low=-1):
        return generator.choice([generator.uniform(low, 1), generator.uniform(low, 1) * 10.0 ** generator.randint(-30, 30), float(generator.randint(0, 9))])
    discs = [{"center": [number(), number()], "radius": abs(number(0)), "growth": abs(number(0))} for _ in range(generator.randint(0, 20))]
    return {"robot": {"speed": abs(number(0)) + 1e-9, "radius": abs(number(0))}, "source": [number(), number()], "destination": [number(), number()], "discs": discs}


@test
def a_scene_comes_back_from_csv_as_the_same_doubles():
    generator = random.Random(20261122)
    for _ in range(40):
        wanted = random_scene(generator)
        write("a.json", json.dumps(wanted))
        done("convert", "a.json", "-o", "a.csv")
        found = converted("a.csv")
        found["robot"].setdefault("radius", 0)
        expect_equal(found, wanted)


@test
def what_csv_leaves_out_is_told_and_brought_back_by_the_scene():
    for name in ("fire-oregon-c.json", "two-discs.json", "ships-long-beach.json"):
        wanted = json.loads((SCENES / name).read_text())
        told = done("convert", SCENES / name, "-o", "a.csv").err
        expect("CSV has no place for its name, its units; --scene brings them back" in told, told)
        expect_equal(converted("a.csv", "--scene", SCENES / name), wanted)
    told = done("convert", scene(**LAID), "-o", "b.csv").err
    expect("CSV has no place for its units;" in done("convert", scene("t.json", name="", units={"time": "s"}), "-o", "b.csv").err, "no warning")
    expect("its name, its units, its georeference" in told, told)
    expect_equal(done("convert", write("c.json", json.dumps({key: TWO_DISCS[key] for key in ("robot", "source", "destination", "discs")})), "-o", "c.csv").err, "")


@test
def columns_may_stand_in_any_order_and_spelling_under_any_separator():
    for separator in ",;\t":
        text = f'\ufeff"Growth",note,"Y", X ,RADIUS\r\n# a comment\r\n\r\n0.1,"a ""quoted"" , thing\nin two lines",3,0,1\r\n 0.1 ,,-3, 0 ,"1"'.replace(",", separator)
        found = converted(write("a.csv", text), "--speed", 1, "--from=-10,0", "--to", "10,0", "--units", "m,s", "--name", "two discs")
        expect_equal(found, TWO_DISCS)


@test
def columns_of_other_names_are_chosen_by_options():
    for options in (("--y-field", "lat"), ("--x-field", "lon")):
        found = converted(write("a.csv", "x,y,lon,lat,radius,growth\n1,2,3,4,1,1\n"), *ROBOT, *options)
        expect_equal(found["discs"][0]["center"], [1, 4] if options[0] == "--y-field" else [3, 2])
    for options in (("--lon-field", "y"), ("--lat-field", "x")):
        expect("georeference" in converted("a.csv", *ROBOT[:2], "--from", "1,2", "--to", "3,4", *options), "not projected")
    for option in ("--x-field", "--y-field", "--lon-field", "--lat-field"):
        fails(3, ['a.csv:1: no column "other"'], "convert", "a.csv", *ROBOT, option, "other")
    text = "px,py,size,spread,kind\n-10,0,,,source\n10,0,,,destination\n0,3,1,0.1,\n0,-3,1,0.1,disc\n"
    options = ("--x-field", "px", "--y-field", "py", "--radius-field", "size", "--growth-field", "spread", "--role-field", "kind", "--speed", 1)
    found = converted(write("a.csv", text), *options)
    expect_equal([found["source"], found["destination"], found["discs"]], [TWO_DISCS["source"], TWO_DISCS["destination"], TWO_DISCS["discs"]])


@test
def missing_radii_and_rates_have_stand_ins():
    found = converted(write("a.csv", "x,y,radius\n0,3,\n1,1,2\n  "), "--radius", 5, "--growth", 0.25, "--speed", 1, "--from", "0,0", "--to", "9,0")
    expect_equal(found["discs"], [{"center": [0, 3], "radius": 5, "growth": 0.25}, {"center": [1, 1], "radius": 2, "growth": 0.25}])


@test
def a_growth_that_is_a_rate_in_disguise_fits_csv_and_a_law_does_not():
    one = [{"center": [0, 3], "radius": 1, "growth": [0.1]}, {"center": [0, -3], "radius": 1, "growth": {"times": [0], "rates": [0.1]}}]
    done("convert", scene(discs=one), "-o", "a.csv")
    expect_equal([disc["growth"] for disc in converted("a.csv")["discs"]], [0.1, 0.1])
    law = [TWO_DISCS["discs"][0], {"center": [0, -3], "radius": 1, "growth": [0.1, 0.01]}]
    write("a.csv", "old")
    fails(3, ["scene.json: discs[1].growth: CSV holds one rate a disc"], "convert", scene(discs=law), "-o", "a.csv")
    expect_equal(pathlib.Path("a.csv").read_text(), "old")


ROBOT = ("--speed", "1", "--from", "0,0", "--to", "9,0")
WRONG_CSV = {
    "an empty file": ("", "a.csv: empty"),
    "white space": (" \n", "neither JSON nor CSV"),
    "no header": ("0,1,2,3\n", "a.csv:1: the first line must name the columns"),
    "only comments": ("# x,y\n", "the first line must name the columns"),
    "no latitude": ("lon,radius,growth\n0,1,1\n", "a.csv:1: the first line must name the columns"),
    "one column and nothing else": ("x", "a.csv:1: the first line must name the columns"),
    "one column": ("x\n1\n", "a.csv:1: the first line must name the columns"),
    "a header that never ends": ('"x,y', "a.csv:1: a quoted field that never ends"),
    "a line that is a quote that never ends": ('x,y,radius,growth\n"0', "a.csv:2: a quoted field that never ends"),
    "two roles": ("x,y,role,role\n", 'a.csv:1: two columns named "role"'),
    "two radii": ("x,y,radius,radius\n", 'two columns named "radius"'),
    "two growths": ("x,y,growth,growth\n", 'two columns named "growth"'),
    "two speeds": ("x,y,speed,speed\n", 'two columns named "speed"'),
    "a bad x": ("x,y,radius,growth\n-,1,2,3\n", 'a.csv:2: x: "-": not a finite'),
    "a bad speed": ("x,y,role,speed\n0,1,source,fast\n", 'a.csv:2: speed: "fast"'),
    "a line that begins with a space and a hash": ("x,y,radius,growth\n # 1,1,2,3\n", 'a.csv:2: x: "# 1"'),
    "a carriage return inside a line": ("x,y,radius,growth\n1\r2,1,2,3\n", "a.csv:2: x: "),
    "no y": ("x,radius,growth\n0,1,1\n", "a.csv:1: the first line must name the columns"),
    "a column twice": ("x,y,radius,X,growth\n", 'a.csv:1: two columns named "x"'),
    "two kinds of places, all by usual names": ("longitude,latitude,y,x\n", "columns x, y and longitude, latitude: say which"),
    "two kinds of places": ("x,y,lon,lat,radius,growth\n", "columns x, y and lon, lat: say which"),
    "a word": ("x,y,radius,growth\n0,1,2,3\n0,up,2,3\n", 'a.csv:3: y: "up": not a finite decimal number'),
    "NaN": ("x,y,radius,growth\n0,1,nan,3\n", 'a.csv:2: radius: "nan": not a finite'),
    "infinity": ("x,y,radius,growth\n0,1,2,inf\n", 'growth: "inf": not a finite'),
    "a number beyond the doubles": ("x,y,radius,growth\n0,1e999,2,3\n", "y: \"1e999\": too large"),
    "a number beyond scenes": ("x,y,radius,growth\n0,1e101,2,3\n", "a.csv:2: "),
    "a decimal comma": ("x;y;radius;growth\n0;1,5;2;3\n", 'a.csv:2: y: "1,5"'),
    "no coordinate": ("x,y,radius,growth\n0,,2,3\n", "a.csv:2: y: missing"),
    "no radius": ("x,y,radius,growth\n0,1,,3\n", "a.csv:2: no radius (--radius R stands in"),
    "no growth column": ("x,y,radius\n0,1,2\n", "a.csv:2: no growth (--growth G stands in"),
    "a negative radius": ("x,y,radius,growth\n0,1,-2,3\n", "a.csv:2: the radius"),
    "a negative growth": ("x,y,radius,growth\n0,1,2,-3\n", "a.csv:2: the growth"),
    "too few fields": ("x,y,radius,growth\n0,1,2\n", "a.csv:2: 3 fields, where the header has 4"),
    "too many fields": ("x,y,radius,growth\n0,1,2,3,4\n", "a.csv:2: 5 fields"),
    "a quote that never ends": ("x,y,radius,growth\n0,1,2,\"3\n\n", "a.csv:2: a quoted field that never ends"),
    "something behind a quote": ("x,y,radius,growth\n0,1,2,\"3\"4\n", "a.csv:2: something follows a quoted field"),
    "an unknown role": ("x,y,radius,growth,role\n0,1,2,3,start\n", "a.csv:2: the role is none of disc, source, destination"),
    "two sources": ("x,y,role\n0,1,source\n\n0,2,source\n", "a.csv:4: a second source"),
    "a destination that grows": ("x,y,role,growth\n0,1,destination,1\n", "a destination is a point"),
    "a destination with a speed": ("x,y,role,speed\n0,1,destination,1\n", "a destination is a point"),
    "two destinations": ("x,y,role\n0,1,destination\n0,2,destination\n", "a.csv:3: a second destination"),
    "a source that grows": ("x,y,role,growth\n0,1,source,1\n", "a source does not grow"),
    "a destination with a radius": ("x,y,role,radius\n0,1,destination,1\n", "a destination is a point"),
    "a disc with a speed": ("x,y,radius,growth,speed\n0,1,1,1,2\n", "speed is the robot's"),
    "a robot of no speed": ("x,y,role,speed\n0,1,source,0\n", "speed must be greater than zero"),
    "a robot of negative size": ("x,y,role,radius\n0,1,source,-1\n", "radius must not be negative"),
    "bytes that are no UTF-8": (b"x,y,radius,growth\n0,\xff,2,3\n", "a.csv:2: not UTF-8"),
    "a zero byte": (b"x,y,radius,growth\n0,1,2,3\n\n\0", "a.csv:4: a zero byte"),
    "a latitude beyond the pole": ("lon,lat,radius,growth\n0,91,2,3\n", "a.csv:2: a latitude is from -90 to 90"),
    "a longitude beyond the antimeridian": ("lon,lat,radius,growth\n181,1,2,3\n", "a.csv:2: a longitude is from -180 to 180"),
    "XML": ("<gpx/>", "XML, which is written and not read"),
    "a table": (b"\x89TDSP", "tdsp path TABLE T --json"),
}


@test
def bad_csv_is_refused_with_file_line_and_reason():
    for name, (content, fragment) in WRONG_CSV.items():
        try:
            fails(3, [fragment, "a.csv"], "convert", write("a.csv", content), *ROBOT)
        except AssertionError as error:
            raise AssertionError(f"{name}: {error}") from error


# --------------------------------------------------------------------------------------------------------------------- GeoJSON

def distance(a, b):
    """On a sphere of the ellipsoid's mean radius: within half a percent of the geodesic's length."""
    (lon1, lat1), (lon2, lat2) = [[math.radians(x) for x in place] for place in (a, b)]
    h = math.sin((lat2 - lat1) / 2) ** 2 + math.cos(lat1) * math.cos(lat2) * math.sin((lon2 - lon1) / 2) ** 2
    return 2 * 6371008.8 * math.asin(min(1, math.sqrt(h)))


@test
def points_are_laid_out_in_metres_about_the_middle():
    found = converted(write("fires.geojson", collection(*FIRES, *ENDS, name="fires")))
    expect_equal(found["units"], {"length": "m", "time": "s"})
    expect_equal(found["name"], "fires")
    expect_equal(found["robot"], {"speed": 6})
    expect_equal(found["georeference"], {"origin": [-119.8003, 44.4501], "projection": "azimuthal equidistant", "ellipsoid": "WGS84"})
    places = [found["source"], found["destination"], *[disc["center"] for disc in found["discs"]]]
    lonlat = [feature["geometry"]["coordinates"] for feature in [*ENDS, *FIRES]]
    for i, a in enumerate(places):
        for j in range(i):
            expect_near(math.dist(a, places[j]) / distance(lonlat[i], lonlat[j]), 1, 5e-3, "distance")
    expect_near(math.dist(places[0], places[1]), 46097.943575287, 46097.94 * 1e-6, "the geodesic between the ends (GeographicLib)")


@test
def places_come_back_from_the_plane_to_a_hundredth_of_a_micrometre():
    generator = random.Random(7)
    for origin in ([0, 0], [179.99, -17], [-71.5, 42], [25, 89.9], [10, -90], [-180, 60]):
        wanted = random_scene(generator) | {"units": {"length": "m", "time": "s"}}
        wanted["discs"] = [{"center": [generator.uniform(-1e6, 1e6), generator.uniform(-1e6, 1e6)], "radius": 1, "growth": 0.5} for _ in range(30)]
        wanted["source"], wanted["destination"] = [-2e5, 1e3], [3e5, 0.25]
        write("a.json", json.dumps(wanted))
        done("convert", "a.json", f"--origin={origin[0]},{origin[1]}", "-o", "a.geojson")
        found = converted("a.geojson")
        expect_equal(found["georeference"]["origin"], origin)
        for a, b in paired([found["source"], found["destination"], *[disc["center"] for disc in found["discs"]]],
                           [wanted["source"], wanted["destination"], *[disc["center"] for disc in wanted["discs"]]]):
            expect_near(math.dist(a, b), 0, 1e-8, f"about {origin}")


@test
def laws_of_growth_names_and_units_come_back_from_geojson():
    discs = [{"center": [1, 3], "radius": 1, "growth": [0.1, 0.01]}, {"center": [0, -3], "radius": 1.5, "growth": {"times": [0, 5], "rates": [0.1, 0.3]}}]
    for units in ({"length": "m"}, {"time": "min"}):
        expect_equal(converted(scene(units=units), "--format", "json")["units"], units)
    file = scene(discs=discs, units={"length": "km", "time": "min"}, robot={"speed": 1.5, "radius": 0.25}, **LAID)
    done("convert", file, "-o", "a.geojson")
    found = converted("a.geojson")
    for key in ("name", "units", "robot"):
        expect_equal(found[key], json.loads(pathlib.Path(file).read_text())[key])
    for disc, wanted in zip(found["discs"], discs):
        expect_equal([disc["radius"], disc["growth"]], [wanted["radius"], wanted["growth"]])
        expect_near(math.dist(disc["center"], wanted["center"]), 0, 1e-11)


@test
def a_scene_that_lies_on_the_earth_is_solved_as_before():
    plain = done("arrive", scene(), 5, 12, "--json").json["results"]
    laid = done("arrive", scene(**LAID), 5, 12, "--json")
    expect_equal(laid.err, "")
    expect_equal([row["arrival"] for row in laid.json["results"]], [row["arrival"] for row in plain])
    for bad, fragment in (({"origin": [0, 91]}, "georeference.origin: a latitude is from -90 to 90"), ({}, "georeference.origin: missing"), ([1], "georeference: must be an object"),
                          ({"origin": [0, 0], "projection": "mercator"}, 'georeference.projection: must be "azimuthal equidistant"'),
                          ({"origin": [0, 0], "ellipsoid": 7}, "georeference.ellipsoid: must be a string")):
        fails(3, [fragment], "arrive", scene(georeference=bad), 5)
    expect("georeference.datum: unknown key ignored" in done("arrive", scene(georeference={"origin": [0, 0], "datum": 1}), 5).err, "no warning")


@test
def multipoints_heights_and_old_members_are_read():
    many = {"type": "Feature", "geometry": {"type": "MultiPoint", "coordinates": [[0, 0, 12], [0.1, 0]]}, "properties": {"Size": 5, "growth": None}}
    bare = {"type": "Feature", "geometry": {"type": "Point", "coordinates": [0.2, 0]}}
    empty = bare | {"properties": None}
    lone = collection(bare, empty, point(0, 0, role="source", growth=0, speed=1, note=1), point(0.1, 0, role="destination", growth=[0], note=2), crs=None)
    expect_equal(len(converted(write("a.geojson", lone), "--radius", 7, "--growth", 0.5)["discs"]), 2)
    crs = {"type": "name", "properties": {"name": "urn:ogc:def:crs:OGC:1.3:CRS84"}}
    file = write("a.geojson", collection(many, bare, crs=crs))
    found = converted(file, "--radius-field", "Size", "--radius", 7, "--growth", 0.5, "--speed", 3, "--from", "0,0.1", "--to", "0.2,0.1", "--origin", "0,0")
    expect_equal([(disc["radius"], disc["growth"]) for disc in found["discs"]], [(5, 0.5), (5, 0.5), (7, 0.5)])
    expect_near(found["discs"][1]["center"][0], 11131.9490793274, 1e-6)
    expect_equal(found["georeference"]["origin"], [0, 0])


@test
def longitude_and_latitude_in_csv_are_projected_as_geojson_is():
    text = "latitude,longitude,bright_ti4,acq_date\n44.4,-119.9,301,2026-07-28\n44.5,-119.7,310,2026-07-28\n"
    options = ("--radius", 375, "--growth", 0.3, "--speed", 6, "--from=-120,44.3", "--to=-119.6,44.6", "--name", "fires")
    one = converted(write("fires.csv", text), *options)
    expect_equal(one, converted(write("fires.geojson", collection(*FIRES, *ENDS)), "--name", "fires"))
    text = text.replace("latitude,longitude", "y,x")
    expect_equal(one, converted(write("fires.csv", text), *options, "--lon-field", "x", "--lat-field", "y"))


@test
def the_antimeridian_and_the_poles_are_places_like_others():
    cases = ([(179.9, -16.5), (-179.8, -17.2), (179.5, -17)], [(0, 89.9), (180, 89.8), (90, 89.95)], [(-30, -89), (120, -88.5), (60, -90)])
    for places in cases:
        file = write("a.geojson", collection(*[point(*place, radius=10, growth=1) for place in places[:1]]))
        found = converted(file, "--speed", 9, f"--from={places[1][0]},{places[1][1]}", f"--to={places[2][0]},{places[2][1]}")
        laid = [found["discs"][0]["center"], found["source"], found["destination"]]
        for i in range(3):
            expect_near(math.dist(laid[i], laid[i - 1]) / distance(places[i], places[i - 1]), 1, 6e-3, f"{places}")


WRONG_GEOJSON = {
    "an array": ("[1]", "a.geojson: must be an object, not an array"),
    "features that are a number": ('{"type": "FeatureCollection", "features": 7}', "features: must be an array"),
    "a feature that says no place": (collection({"type": "Feature"}), "features[0].geometry: missing"),
    "a place without coordinates": (collection({"type": "Feature", "geometry": {"type": "Point"}}), "features[0].geometry.coordinates: missing"),
    "coordinates that are a number": (collection(point(0, 0, radius=1, growth=0) | {"geometry": {"type": "Point", "coordinates": 7}}), "coordinates: must be an array"),
    "a latitude that is a word": (collection(point(0, "north")), "features[0].geometry.coordinates[1]: must be a number"),
    "a speed that is a word": (collection(point(0, 0, speed="1")), "features[0].properties.speed: must be a number"),
    "a source that grows": (collection(point(0, 0, role="source", growth=[0, 1])), "features[0]: a source does not grow"),
    "a crs without properties": (collection(*FIRES, crs={}), "crs.properties: missing"),
    "a crs whose properties are a number": (collection(*FIRES, crs={"properties": 7}), "crs.properties: must be an object"),
    "a crs without a name": (collection(*FIRES, crs={"properties": {}}), "crs.properties.name: missing"),
    "a crs whose name is a number": (collection(*FIRES, crs={"properties": {"name": 7}}), "crs.properties.name: must be a string"),
    "a unit of length that nobody knows": (collection(*FIRES, units={"length": "furlong"}), 'needs a known unit of length, not "furlong"'),
    "a unit of time that is a number": (collection(*FIRES, units={"time": 7}), "units.time: must be a string"),
    "no collection": (json.dumps(FIRES[0]), 'type: must be "FeatureCollection", not "Feature"'),
    "a type that is a number": ('{"type": 7}', "type: must be a string"),
    "no features": ('{"type": "FeatureCollection"}', "features: missing"),
    "a feature that is none": (collection({"type": "Point"}), 'features[0].type: must be "Feature"'),
    "a feature without a type": (collection({}), "features[0].type: missing"),
    "a feature without a place": (collection({"type": "Feature", "geometry": None}), "features[0].geometry: must be an object, not null"),
    "a polygon": (collection(FIRES[0], {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": []}}), "features[1].geometry: a Polygon: a disc is a Point with a radius"),
    "a position of one number": (collection(point(1, 2) | {"geometry": {"type": "Point", "coordinates": [1]}}), "features[0].geometry.coordinates: a position has"),
    "a position that is a word": (collection(point("east", 2)), "features[0].geometry.coordinates[0]: must be a number"),
    "points that are no array": (collection(point(1, 2) | {"geometry": {"type": "MultiPoint", "coordinates": 1}}), "features[0].geometry.coordinates: must be an array"),
    "a bad position among good ones": (collection({"type": "Feature", "geometry": {"type": "MultiPoint", "coordinates": [[0, 0], [0, -90.5]]}, "properties": {"radius": 1, "growth": 0}}),
                                       "features[0].geometry.coordinates[1]: a latitude is from -90 to 90"),
    "a latitude beyond the pole": (collection(point(0, 90.01, radius=1, growth=0)), "coordinates: a latitude is from -90 to 90"),
    "a longitude beyond the antimeridian": (collection(point(190, 0, radius=1, growth=0)), "coordinates: a longitude is from -180 to 180"),
    "NaN": (collection(point(0, 0, radius=1, growth=0)).replace("[0, 0]", "[NaN, 0]"), ":1:"),
    "a radius that is a word": (collection(point(0, 0, radius="1", growth=0)), "features[0].properties.radius: must be a number, not a string"),
    "a growth that shrinks": (collection(point(0, 0, radius=1, growth=[-1])), "features[0].properties.growth: the radius shrinks"),
    "a role that is a number": (collection(point(0, 0, role=1)), "features[0].properties.role: must be a string"),
    "an unknown role": (collection(point(0, 0, role="fire")), "features[0]: the role is none of"),
    "properties that are a number": (collection(point(0, 0) | {"properties": 7}), "features[0].properties: must be an object"),
    "no radius": (collection(point(0, 0, growth=1)), "features[0]: no radius"),
    "another crs": (collection(*FIRES, crs={"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::3857"}}), "crs.properties.name: GeoJSON has WGS84"),
    "a crs that is a number": (collection(*FIRES, crs=3857), "crs: must be an object"),
    "a name that is a number": (collection(*FIRES, name=7), "name: must be a string"),
    "a point on the other side of the earth": (collection(*FIRES, point(60, -44, radius=1, growth=0), *ENDS, georeference={"origin": ORIGIN}), "features[2]: over 1500 km from the origin"),
    "points all around": (collection(point(0, 0, radius=1, growth=0), point(180, 0, radius=1, growth=0)), "the places have no middle to project about: --origin"),
}


@test
def bad_geojson_is_refused_with_file_place_and_reason():
    for name, (content, fragment) in WRONG_GEOJSON.items():
        ends = () if "role" in content and name.endswith("earth") else ("--speed", 1, "--from", "0,0", "--to", "180,0" if name.endswith("around") else "0,0.1")
        try:
            fails(3, [fragment, "a.geojson"], "convert", write("a.geojson", content), *ends)
        except AssertionError as error:
            raise AssertionError(f"{name}: {error}") from error


@test
def what_is_too_large_for_a_plane_is_warned_of_and_then_refused():
    def fire(lon):
        return write("a.geojson", collection(point(lon, 0, radius=1, growth=0)))
    options = ("--speed", 1, "--from", "0,0", "--to", "0,0.1", "--origin", "0,0", "--format", "json")
    expect_equal(done("convert", fire(4.4), *options).err, "")
    told = done("convert", fire(5), *options).err
    expect("a.geojson reaches 557 km from the origin: distances in the plane are too long by up to 0.13 %" in told, told)
    fails(3, ["a.geojson: features[0]: over 1500 km from the origin"], "convert", fire(14), *options)
    fails(2, ["--from, --to: over 1500 km"], "convert", fire(1), *options[:2], "--from", "0,0", "--to", "0,80", *options[6:])
    fails(2, ["--from, --to: over 1500 km"], "convert", fire(1), "--speed", 1, "--from", "0,80", "--to", "0,0.1", "--origin", "0,0")
    fails(3, ["a.csv:2: over 1500 km from the origin"], "convert", write("a.csv", "lon,lat,radius,growth\n14,0,1,1\n"), "--speed", 1, "--from", "0,0", "--to", "0,0.1", "--origin", "0,0")
    fails(3, ["p.json reaches 2000 km"], "convert", path_of(scene(destination=[2e6, 0], discs=[]), 0), "--scene", scene(**LAID), "--format", "geojson")
    fails(3, ["scene.json reaches 2000 km"], "convert", scene(destination=[2e6, 0], **LAID), "--format", "geojson")
    report = done("convert", fire(5), *options, "-o", "a.json", "--json").json
    expect_near(report["extent"], 556597.453966367, 1e-6)
    expect_near(report["distortion"], report["extent"] ** 2 / 6 / 6356752.314 ** 2, 2e-6)


@test
def what_contradicts_itself_is_refused():
    fires = write("fires.geojson", collection(*FIRES, *ENDS))
    laid = scene("laid.json", **LAID)
    plain = scene()
    agreeing = converted(fires, "--scene", laid, "--origin=-119.8,44.45", "--units", "m,s")
    expect_equal(agreeing["georeference"]["origin"], ORIGIN)
    expect_equal(converted(laid, "--origin=-119.8,44.45", "--format", "json")["discs"], TWO_DISCS["discs"])
    fails(2, ["--origin and --scene contradict"], "convert", fires, "--scene", laid, "--origin=-119.8,44")
    fails(2, ['the unit is "s", and "h" by --units'], "convert", plain, "--units", "m,h", "--format", "json")
    fails(2, ["--scene does not say where on the earth its ends are"], "convert", write("f.geojson", collection(*FIRES)), "--scene", plain, "--from=-119,44")
    fails(3, ["a.csv: "], "convert", write("a.csv", "x,y,radius,growth\n"), "--speed", 1, "--from", "1e101,0", "--to", "0,0")
    fails(3, ["huge.json: "], "arrive", scene("huge.json", source=[1e101, 0]), 0)
    fails(3, ["georeference.origin: must be an array"], "arrive", scene("odd.json", georeference={"origin": 7}), 0)
    fails(2, ["--origin and --scene contradict"], "convert", fires, "--scene", laid, "--origin", "0,0")
    fails(2, ["nothing is moved"], "convert", laid, "--origin", "0,0", "--format", "json")
    fails(2, ['the unit is "m", and "km" by --units'], "convert", plain, "--units", "km,s", "--format", "json")
    fails(2, ['the unit is "m", and "ft" by --scene'], "convert", plain, "--scene", scene("feet.json", units={"length": "ft", "time": "s"}), "--format", "json")
    fails(2, ["GeoJSON has longitudes and latitudes, and nothing says where scene.json is"], "convert", plain, "--format", "geojson")
    fails(2, ["--scene does not say where on the earth its ends are"], "convert", write("f.geojson", collection(*FIRES)), "--scene", plain)
    fails(3, ['needs a known unit of length, not "furlong"'], "convert", scene("odd.json", units={"length": "furlong"}, **LAID), "--format", "geojson")
    fails(2, ["mute.json needs the unit of length, which nothing says"], "convert", scene("mute.json", units={}, **LAID), "--format", "geojson")


@test
def a_scene_lends_its_plane_to_fires_seen_later():
    laid = scene("laid.json", **LAID)
    found = converted(write("fires.geojson", collection(*FIRES)), "--scene", laid)
    expect_equal([found["source"], found["robot"], found["name"], found["georeference"]["origin"]], [TWO_DISCS["source"], TWO_DISCS["robot"], "two discs", ORIGIN])
    robot = collection(*FIRES, point(-119.9, 44.4, role="source", radius=2))
    found = converted(write("robot.geojson", robot), "--scene", scene("other.json", robot={"speed": 3, "radius": 1}, **LAID))
    expect_equal(found["robot"], {"speed": 3, "radius": 2})
    found = converted("fires.geojson", "--scene", scene(), "--origin=-119.8,44.45")
    expect_equal([found["source"], found["georeference"]["origin"]], [TWO_DISCS["source"], ORIGIN])


# ----------------------------------------------------------------------------------------------------------------------- paths

def path_of(file, departure, name="p.json"):
    return write(name, done("path", file, departure, "--json").out)


def place_at(leg, time):
    """The robot on a leg of one rate, from the leg's members alone."""
    x = (time - leg["start_time"]) / (leg["end_time"] - leg["start_time"])
    if leg["type"] == "line":
        return [a + (b - a) * x for a, b in zip(leg["from"], leg["to"])]
    (r0, r1), center, sign = leg["radii"], leg["center"], 1 if leg["turn"] == "ccw" else -1
    angle = [math.atan2(leg[end][1] - center[1], leg[end][0] - center[0]) for end in ("from", "to")]
    sweep = sign * (angle[1] - angle[0]) % (2 * math.pi)
    r = r0 + (r1 - r0) * x
    share = math.log(r / r0) / math.log(r1 / r0) if abs(r1 / r0 - 1) > 1e-9 else x
    return [center[0] + r * math.cos(angle[0] + sign * sweep * share), center[1] + r * math.sin(angle[0] + sign * sweep * share)]


def off_the_path(path, times, places):
    """How far from the robot one gets at most who goes straight from place to place."""
    worst = 0
    for leg in path["legs"]:
        for i in range(1, 400):
            time = leg["start_time"] + (leg["end_time"] - leg["start_time"]) * i / 400
            after = next(k for k in range(1, len(times)) if times[k] >= time)
            x = (time - times[after - 1]) / (times[after] - times[after - 1])
            straight = [a + (b - a) * x for a, b in zip(places[after - 1], places[after])]
            worst = max(worst, math.dist(straight, place_at(leg, time)))
    return worst


@test
def a_path_in_csv_keeps_to_its_tolerance_and_has_every_end_of_a_leg():
    generated = done("generate", "crowd", "--n", 40, "--seed", 3).out
    for content, departure in ((json.dumps(TWO_DISCS), 12), (generated, 0), ((SCENES / "fire-oregon-c.json").read_text(), 60)):
        path = json.loads(pathlib.Path(path_of(write("a.json", content), departure)).read_text())
        length = sum(math.dist(leg["from"], leg["to"]) for leg in path["legs"])
        counts = []
        for tolerance in (length * 1e-2, length * 1e-4, length * 1e-6):
            rows = [row.split(",") for row in done("convert", "p.json", "--format", "csv", "--tolerance", repr(tolerance)).out.splitlines()]
            expect_equal(rows[0], ["time", "x", "y", "leg", "type", "disc"])
            times, places = [float(row[0]) for row in rows[1:]], [[float(x) for x in row[1:3]] for row in rows[1:]]
            expect(off_the_path(path, times, places) <= tolerance, f"{off_the_path(path, times, places)} > {tolerance}")
            expect_equal(times, sorted(times))
            for leg in path["legs"]:
                for time, place in ((leg["start_time"], leg["from"]), (leg["end_time"], leg["to"])):
                    expect(any(t == time and math.dist(p, place) <= 1e-9 * length for t, p in zip(times, places)), f"no point at {time}")
            counts.append(len(times))
        expect(counts[0] <= counts[1] < counts[2], f"{counts}")


def legs_of_rows(rows):
    return [(int(row["leg"]), row["type"], row["disc"]) for row in rows]


@test
def points_of_a_path_say_what_they_lie_on():
    path = json.loads(pathlib.Path(path_of(scene(**LAID), 12)).read_text())
    lines = done("convert", "p.json", "--scene", "scene.json", *EPOCH, "--format", "csv").out.splitlines()
    expect_equal(lines[0], "time,x,y,lon,lat,instant,leg,type,disc")
    rows = [dict(zip(lines[0].split(","), line.split(","))) for line in lines[1:]]
    expect_equal([entry for i, entry in enumerate(legs_of_rows(rows)) if entry != legs_of_rows(rows)[i - 1]],
                 [(i, leg["type"], str(leg.get("disc", ""))) for i, leg in enumerate(path["legs"])])
    expect_equal(rows[0]["instant"], "2026-06-01T12:00:12Z")


def instant_of(text):
    """Of an instant of UTC, with or without a fraction of a second."""
    whole, _, fraction = text.rstrip("Z").partition(".")
    return datetime.datetime.fromisoformat(whole) + datetime.timedelta(microseconds=int(fraction.ljust(6, "0")))


@test
def gpx_is_well_formed_and_has_the_schema_s_shape():
    path = json.loads(pathlib.Path(path_of(SCENES / "fire-oregon-c.json", 60)).read_text())
    options = ("--scene", SCENES / "fire-oregon-c.json", "--origin=-119.8,44.45")
    done("convert", "p.json", *options, "--epoch", "2026-06-01T14:00:00.25+02:00", "--name", "a <b> & \"c\" \x01\uffff", "-o", "p.gpx")
    root = xml.etree.ElementTree.parse("p.gpx").getroot()
    expect_equal(root.tag, GPX + "gpx")
    expect_equal(root.get("version"), "1.1")
    expect(root.get("creator").startswith("tdsp "), root.get("creator"))
    expect_equal([child.tag for child in root], [GPX + "trk"])
    expect_equal([child.tag for child in root[0]], [GPX + "name", GPX + "trkseg"])
    expect_equal(root[0][0].text, 'a <b> & "c" \\x01\ufffd')
    points = root[0][1]
    expect(all(child.tag == GPX + "trkpt" and set(child.attrib) == {"lat", "lon"} and [time.tag for time in child] == [GPX + "time"] for child in points), "a point")
    lines = done("convert", "p.json", *options, "--format", "csv").out.splitlines()[1:]
    expect_equal(len(points), len(lines))
    start = datetime.datetime(2026, 6, 1, 12, 0, 0, 250000)
    for child, line in zip(points, lines):
        time, _, _, lon, lat = map(float, line.split(",")[:5])
        expect_near((instant_of(child[0].text) - start).total_seconds(), time, 1e-6)
        expect_near(float(child.get("lon")), lon, 1e-10)
        expect_near(float(child.get("lat")), lat, 1e-10)
        expect("e" not in child.get("lon") + child.get("lat"), "an exponent")
    expect_equal(path["departure"], 60)


@test
def a_geojson_path_has_a_time_for_every_position():
    path_of(scene(**LAID), 12)
    found = converted("p.json", "--scene", "scene.json", *EPOCH, "--format", "geojson")
    expect_equal([found["name"], found["units"], found["georeference"]["origin"]], ["two discs", TWO_DISCS["units"], ORIGIN])
    feature, = found["features"]
    expect_equal(feature["geometry"]["type"], "LineString")
    properties = feature["properties"]
    expect_equal({len(feature["geometry"]["coordinates"]), len(properties["times"]), len(properties["coordTimes"])}, {len(properties["times"])})
    path = json.loads(pathlib.Path("p.json").read_text())
    expect_equal([properties[key] for key in ("role", "departure", "arrival")], ["path", 12, path["arrival"]])
    expect_equal([leg["type"] for leg in properties["legs"]], [leg["type"] for leg in path["legs"]])
    expect_equal(properties["legs"][1]["disc"], path["legs"][1]["disc"])
    expect("coordTimes" not in converted("p.json", "--scene", "scene.json", "--format", "geojson")["features"][0]["properties"], "instants that nobody asked for")


@test
def a_long_line_on_the_earth_is_bent_as_the_plane_bends_it():
    file = scene(source=[-4e5, 0], destination=[4e5, 0], robot={"speed": 100}, discs=[], georeference={"origin": [10, 60]})
    feature, = converted(path_of(file, 0), "--scene", file, "--tolerance", 50, "--format", "geojson")["features"]
    coordinates, times = feature["geometry"]["coordinates"], feature["properties"]["times"]
    expect(len(coordinates) > 10, f"{len(coordinates)} points")
    middles = [point((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, radius=1, growth=0) for a, b in zip(coordinates, coordinates[1:])]
    laid = converted(write("m.geojson", collection(*middles)), "--scene", file)["discs"]
    for disc, a, b in zip(laid, times, times[1:]):
        expect_near(math.dist(disc["center"], [-4e5 + 100 * (a + b) / 2, 0]), 0, 50)


@test
def a_path_across_the_antimeridian_is_cut_there():
    for ends in (([-1e4, 300], [1e4, -200]), ([1e4, 0], [-1e4, 0])):
        file = scene(source=ends[0], destination=ends[1], discs=[], georeference={"origin": [180, -17]})
        feature, = converted(path_of(file, 0), "--scene", file, *EPOCH, "--format", "geojson")["features"]
        expect_equal(feature["geometry"]["type"], "MultiLineString")
        west, east = feature["geometry"]["coordinates"]
        side = 180 if ends[0][0] < 0 else -180
        expect_equal([west[-1][0], east[0][0]], [side, -side])
        expect_equal(west[-1][1], east[0][1])
        expect(all(abs(a[0] - b[0]) < 1 for line in (west, east) for a, b in zip(line, line[1:])), "a jump")
        times = feature["properties"]["times"]
        expect_equal([len(line) for line in times], [len(west), len(east)])
        expect_near(times[0][-1], math.dist(*ends) / 2, 1)
        expect_equal(times[0][-1], times[1][0])
        tracks = xml.etree.ElementTree.fromstring(done("convert", "p.json", "--scene", file, *EPOCH, "--format", "gpx").out)
        expect(all(-180 <= float(p.get("lon")) < 180 for p in tracks.iter(GPX + "trkpt")), "a longitude that the schema does not have")


@test
def a_path_over_the_pole_keeps_to_its_tolerance():
    file = scene(source=[-2e4, 10], destination=[2e4, 10], discs=[], georeference={"origin": [0, 90]})
    feature, = converted(path_of(file, 0), "--scene", file, "--tolerance", 20, "--format", "geojson")["features"]
    lines = feature["geometry"]["coordinates"] if feature["geometry"]["type"] == "MultiLineString" else [feature["geometry"]["coordinates"]]
    middles = [point((a[0] + b[0]) / 2, (a[1] + b[1]) / 2, radius=1, growth=0) for line in lines for a, b in zip(line, line[1:])]
    for disc in converted(write("m.geojson", collection(*middles)), "--scene", file)["discs"]:
        expect_near(disc["center"][1], 10, 20)


@test
def a_path_without_lines_needs_to_know_the_robot():
    leg = {"type": "arc", "start_time": 0, "end_time": 20, "from": [1, 0], "to": [-1, 0], "disc": 0, "center": [0, 0], "turn": "ccw", "radii": [1, 1]}
    write("p.json", json.dumps({"departure": 0, "arrival": 20, "status": "ok", "legs": [leg]}))
    fails(2, ["--scene SCENE or --speed V"], "convert", "p.json", "--format", "csv")
    laps = [len(done("convert", "p.json", "--format", "csv", "--speed", math.pi * turns / 20, "--tolerance", 1e-3).out.splitlines()) for turns in (1, 3, 5)]
    expect(laps[0] * 2 < laps[1] < laps[2], f"{laps}")


@test
def a_path_that_stands_still_is_a_line_of_two_equal_positions():
    leg = {"type": "line", "start_time": 5, "end_time": 5, "from": [1, -1e-7], "to": [1, -1e-7]}
    write("p.json", json.dumps({"departure": 5, "arrival": 5, "status": "ok", "legs": [leg]}))
    laid = ("--units", "m,s", "--origin", "0,0", *EPOCH)
    coordinates = converted("p.json", "--speed", 1, *laid, "--format", "geojson")["features"][0]["geometry"]["coordinates"]
    expect_equal(coordinates[0], coordinates[1])
    expect_equal(len(coordinates), 2)
    fails(2, ["--scene SCENE or --speed V"], "convert", "p.json", *laid, "--format", "csv")
    gpx = done("convert", "p.json", "--speed", 1, *laid, "--format", "gpx").out
    expect('lat="0" lon="0.000008983' in gpx, gpx)
    expect("<name>" not in gpx, gpx)


def changed_leg(number, **changes):
    path = json.loads(pathlib.Path("p.json").read_text())
    path["legs"][number].update(changes)
    return write("q.json", json.dumps(path))


@test
def bad_paths_are_refused():
    path_of(scene(), 12)
    csv = ("--format", "csv")
    fails(3, ["q.json: legs[1]: ends before it starts"], "convert", changed_leg(1, end_time=1), *csv)
    fails(3, ["q.json: legs[1]: does not start when the one before ends"], "convert", changed_leg(1, start_time=13), *csv)
    fails(3, ["q.json: legs[2]: does not start where the one before ends"], "convert", changed_leg(2, **{"from": [7, 7]}), *csv)
    fails(3, ["q.json: legs[1]: radii must be over zero"], "convert", changed_leg(1, radii=[0, 1]), *csv)
    fails(3, ["q.json: legs[1]: radii must be over zero"], "convert", changed_leg(1, radii=[1, 0]), *csv)
    fails(3, ["legs[0]: takes no time to get elsewhere"], "convert", changed_leg(0, end_time=12), *csv, "--speed", 1)
    fails(3, ["q.json: legs: must be an array"], "convert", write("q.json", '{"departure": 0, "arrival": 1, "status": "ok", "legs": 1}'), *csv)
    fails(3, ["q.json: robot: must be an object"], "convert", write("q.json", '{"robot": 1}'), *csv)
    fails(3, ["q.json: a path without a finite length"], "convert", changed_leg(0, **{"from": [1.7e308, -1.7e308]}), *csv, "--speed", 1)
    fails(3, ["more than 1000000 points within the tolerance"], "convert", "p.json", *csv, "--tolerance", 1e-14)
    fails(1, ["p.json: no path to convert: source_covered"], "convert", write("p.json", tdsp("path", scene(), 200, "--json").out), *csv)
    fails(1, ["stays where it is"], "convert", path_of(scene(destination=[-10, 0]), 0), *csv)


# --------------------------------------------------------------------------------------------------------------- the command

@test
def options_that_do_not_fit_are_usage_errors():
    plain, csv, path = scene(), write("a.csv", "x,y,radius,growth\n"), path_of(scene(), 5)
    laid = ("--scene", scene("laid.json", **LAID))
    for call, fragment in (
            ((plain,), "into which format? scene.json is a scene: --format json, csv or geojson"),
            ((path, "-o", "out"), "into which format? p.json is a path: --format csv, geojson or gpx"),
            ((plain, "-o", "a.txt"), "into which format?"),
            ((csv, "-o", "scene"), "into which format?"),
            ((plain, "--format", "shp"), '--format "shp": must be one of json, csv, geojson, gpx'),
            ((path, "--format", "json"), "is a path in JSON"),
            ((plain, "--format", "gpx"), "GPX is for paths"),
            ((plain, "--format", "csv", "--json"), "--json reports about the file of -o"),
            ((plain, "--format", "csv", "--epoch", "2026-06-01T12:00:00Z"), "--epoch is not for a scene file"),
            ((plain, "--format", "csv", "--radius", 1), "--radius is not for a scene file"),
            ((path, "--format", "csv", "--from", "0,0"), "--from is not for a path"),
            ((csv, "--x-field", "a", "--lat-field", "b"), "not both"),
            ((csv, "--y-field", "a", "--lon-field", "b"), "not both"),
            ((csv, "--nonsense"), "Unknown option --nonsense"),
            ((path, "--format", "csv", "--units", "m"), "must be two units, LENGTH,TIME"),
            ((csv, *ROBOT, "--units", "m,"), "must be two units, LENGTH,TIME"),
            ((path, "--format", "gpx", *laid, "--epoch", "9999-12-31T23:59:50Z"), "beyond the year 9999"),
            ((csv, *ROBOT, "--radius", "-1"), '--radius "-1": negative'),
            ((csv, *ROBOT, "--growth", "fast"), '--growth "fast"'),
            ((csv, *ROBOT, "--units", "m"), "must be two units, LENGTH,TIME"),
            ((csv, *ROBOT, "--units", ",s"), "must be two units, LENGTH,TIME"),
            ((csv, *ROBOT, "--origin", "200,0"), '--origin "200,0": a longitude is from -180 to 180'),
            ((csv, *ROBOT, "--origin", "1"), "must be two numbers, LON,LAT"),
            ((csv, *ROBOT, "--origin", "a,0"), "not a finite decimal number"),
            ((csv, "--from", "0,0", "--to", "9,0"), "does not say how fast the robot is: --speed V"),
            ((csv, "--from", "0,0", "--to", "9,0", "--speed", 0), "--speed must be greater than zero"),
            ((csv, *ROBOT, "--speed", "-1"), '--speed "-1": negative'),
            ((csv, *ROBOT, "--robot-radius", "x"), '--robot-radius "x"'),
            ((csv, "--to", "9,0", "--speed", 1), "a.csv has no source: --from X,Y"),
            ((csv, "--from", "9,0", "--speed", 1), "a.csv has no destination: --to X,Y"),
            ((csv, "--from", "9", "--to", "1,1", "--speed", 1), '--from "9": must be two numbers, X,Y'),
            ((csv, "--from", "9,x", "--to", "1,1", "--speed", 1), '--from "9,x": not a finite'),
            ((csv, "--from", "9,1", "--to", "1,1,1", "--speed", 1), '--to "1,1,1"'),
            ((path, "--format", "csv", "--tolerance", 0), "--tolerance must be greater than zero"),
            ((path, "--format", "csv", "--tolerance", "x"), '--tolerance "x"'),
            ((path, "--format", "csv", "--speed", "x"), '--speed "x"'),
            ((path, "--format", "gpx", *EPOCH), "GPX has longitudes and latitudes"),
            ((path, "--format", "geojson"), "GeoJSON has longitudes and latitudes"),
            ((path, "--format", "gpx", *laid), "--epoch says which one"),
            ((path, "--format", "gpx", *laid, "--epoch", "2026-06-01T12:00:00"), "must be an instant with its zone"),
            ((path, "--format", "gpx", *laid, "--epoch", "9999-12-31T23:59:59Z"), "beyond the year 9999"),
            ((path, "--format", "csv", *EPOCH), "p.json needs the unit of time, which nothing says"),
            ((path, "--format", "csv", "--origin", "0,0"), "p.json needs the unit of length"),
            (("-", "--scene", "-"), "only one of FILE and --scene"),
            ((), "too few arguments")):
        fails(2, [fragment], "convert", *call)
    fails(2, ["--from LON,LAT"], "convert", write("a.geojson", collection(*FIRES)), "--speed", 1)
    fails(2, ["--to LON,LAT"], "convert", "a.geojson", "--speed", 1, "--from", "0,0")
    fails(2, ["must be two numbers, LON,LAT"], "convert", "a.geojson", "--speed", 1, "--from", "0")
    fails(2, ["a latitude is from -90 to 90"], "convert", "a.geojson", "--speed", 1, "--from", "0,99")
    fails(2, ["would replace the input"], "convert", plain, "--format", "json", "-o", plain)
    fails(3, ['no column "px"'], "convert", csv, *ROBOT, "--x-field", "px")
    fails(3, ['needs a known unit of time, not "fortnight"'], "convert", path, "--scene", scene("odd.json", units={"time": "fortnight"}), *EPOCH, "--format", "csv")
    fails(4, ["nowhere.csv"], "convert", "nowhere.csv", *ROBOT)
    fails(4, ["cannot write /dev/full"], "convert", csv, *ROBOT, "-o", "/dev/full", "--format", "json")
    fails(4, ["nowhere.json"], "convert", csv, *ROBOT, "--scene", "nowhere.json")
    fails(3, ["a.csv"], "convert", csv, *ROBOT, "--scene", csv)


@test
def the_report_says_what_was_converted():
    report = done("convert", write("f.geojson", collection(*FIRES, *ENDS)), "-o", "f.json", "--json").json
    expect_equal([report[key] for key in ("file", "from", "to", "discs", "units", "origin", "ignored")],
                 ["f.json", "geojson", "json", 2, {"length": "m", "time": "s"}, [-119.8003, 44.4501], ["brightness"]])
    expect_near(report["extent"], 23054.4, 1)
    expect_near(report["distortion"], 2.2e-6, 1e-7)
    report = done("convert", write("a.csv", "x,y,radius,growth,b,a\n"), *ROBOT, "-o", "a.json", "--json").json
    expect_equal([report[key] for key in ("from", "discs", "units", "origin", "extent", "distortion", "ignored")],
                 ["csv", 0, {"length": None, "time": None}, None, None, None, ["a", "b"]])
    report = done("convert", path_of(scene(), 5), "-o", "p.csv", "--json").json
    expect_equal([report[key] for key in ("from", "to", "legs", "points", "origin")], ["path", "csv", 1, 2, None])
    expect_near(report["tolerance"], 20e-5, 1e-12)


@test
def a_report_that_cannot_be_written_is_told():
    with open("/dev/full", "w") as full:
        ended = subprocess.run([TDSP, "convert", scene(), "-o", "a.csv", "--json"], stdout=full, stderr=subprocess.PIPE)
    expect_equal(ended.returncode, 4)
    expect(b"cannot write standard output" in ended.stderr, ended.stderr)


@test
def standard_input_and_output_serve():
    text = done("convert", scene(), "--format", "csv").out
    expect_equal(converted("-", "--scene", "scene.json", stdin=text), TWO_DISCS)
    expect_equal(converted("scene.json", "--format", "json", "--name", "other")["name"], "other")
    robot = converted("-", "--format", "json", "--speed", 2, "--robot-radius", 0.5, "--from", "1,1", stdin=pathlib.Path("scene.json").read_text())
    expect_equal([robot["robot"], robot["source"], robot["destination"]], [{"speed": 2, "radius": 0.5}, [1, 1], [10, 0]])


main()
