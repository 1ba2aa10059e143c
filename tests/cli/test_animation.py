#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pictures that move: what an animation shows at a moment is what the command tells of that moment."""
import bisect
import json
import math
import os
import re
import xml.etree.ElementTree as xml

from harness import SCENES, TWO_DISCS, done, expect, expect_equal, expect_near, fails, main, scene, test

SVG = "{http://www.w3.org/2000/svg}"
POINT = 0.012  # of the picture: coordinates have two digits, and a path is drawn to 0.01
REST = 1.15  # a round is so many times as long as the journeys take
NUMBER = re.compile(r"-?[\d.]+(?:e-?\d+)?")
MOMENTS = (0, 0.1, 0.37, 0.5, 0.82, 0.999, 1)  # shares of the journey


def bezier(a, b, c, d, steps=48):
    for i in range(1, steps + 1):
        x = i / steps
        weights = ((1 - x)**3, 3 * (1 - x)**2 * x, 3 * (1 - x) * x * x, x**3)
        yield tuple(sum(w * p[k] for w, p in zip(weights, (a, b, c, d))) for k in (0, 1))


class Way:
    """A path's points with the length up to each: where something is that goes along it evenly, as a renderer has it."""

    def __init__(self, data):
        self.points = []
        for command, numbers in re.findall(r"([MLC])([^MLC]*)", data):
            values = [float(x) for x in NUMBER.findall(numbers)]
            places = list(zip(values[::2], values[1::2]))
            self.points += bezier(self.points[-1], *places) if command == "C" else places
        self.lengths = [0]
        for one, other in zip(self.points, self.points[1:]):
            self.lengths.append(self.lengths[-1] + math.dist(one, other))

    def at(self, share):
        wanted = share * self.lengths[-1]
        i = min(max(bisect.bisect_left(self.lengths, wanted), 1), len(self.points) - 1)
        step = self.lengths[i] - self.lengths[i - 1]
        x = (wanted - self.lengths[i - 1]) / step if step else 0
        return tuple(p + x * (q - p) for p, q in zip(self.points[i - 1], self.points[i]))


def keyed(animation, values="values"):
    return [float(x) for x in animation.get("keyTimes").split(";")], animation.get(values).split(";")


def value_at(animation, share, values="values"):
    times, found = keyed(animation, values)
    i = min(max(bisect.bisect_left(times, share), 1), len(times) - 1)
    low, high = float(found[i - 1]), float(found[i])
    return low + (high - low) * (share - times[i - 1]) / (times[i] - times[i - 1])


def shown_at(animation, share):
    times, values = keyed(animation)
    return values[bisect.bisect_right(times, share + 1e-9) - 1] == "visible"


class Moving:
    """An animated picture of a scene, with the way from the scene's places to the picture's."""

    def __init__(self, name, source, destination):
        self.root = xml.parse(name).getroot()
        parents = {child: parent for parent in self.root.iter() for child in parent}
        ends = [c for c in self.root.iter(SVG + "circle") if c.get("r") == "6.5"][:2]
        (x0, y0), (x1, y1) = [(float(c.get("cx")), float(c.get("cy"))) for c in ends]
        self.scale = math.dist((x0, y0), (x1, y1)) / math.dist(source, destination)
        self.source, self.origin = source, (x0, y0)
        self.animations = list(self.root.iter(SVG + "animate"))
        self.motions = list(self.root.iter(SVG + "animateMotion"))
        self.durations = {element.get("dur") for element in self.animations + self.motions}
        self.growing = [(parents[a], a) for a in self.animations if a.get("attributeName") == "stroke-width"]
        self.texts = [(t.text or "".join(t.itertext()), t.find(SVG + "animate")) for t in self.root.iter(SVG + "text") if t.find(SVG + "animate") is not None]
        self.groups = [g for g in self.root.iter(SVG + "g") if g.get("class") == "appearing"]

    def place(self, x, y):
        return self.origin[0] + (x - self.source[0]) * self.scale, self.origin[1] - (y - self.source[1]) * self.scale

    def robot(self, share, which=-1):
        """Where a robot is; the picture's own is drawn last."""
        motion = self.motions[which]
        return Way(motion.get("path")).at(value_at(motion, share, "keyPoints"))

    def radius(self, center, share):
        """The radius of the growing disc around a place of the scene, the edge left out."""
        wanted = self.place(*center)
        found = [value_at(a, share) / 2 for element, a in self.growing for x, y in re.findall(r"M([\d.-]+) ([\d.-]+)h0", element.get("d"))
                 if math.dist((float(x), float(y)), wanted) < POINT]
        expect(len(found) == 2, f"{len(found)} discs at {center}")
        return min(found)

    def clock(self, share):
        return [text for text, animation in self.texts if shown_at(animation, share)]


def animated(file, *options, name="a.svg"):
    report = done("plot", file, "-o", name, "--animate", "--json", *options).json
    ends = done("convert", file, "--format", "json")
    described = json.loads(ends.out)
    return Moving(name, described["source"], described["destination"]), report, described


def expect_robot_in_place(file, departure):
    moving, report, _ = animated(file, "--depart", departure)
    for share in MOMENTS:
        time = departure + share * (report["arrival"] - departure)
        x, y = done("path", file, departure, "--at", repr(time)).rows()[0]
        found = moving.robot(share / REST)
        expect(math.dist(found, moving.place(float(x), float(y))) < POINT, f"{file} at {time}: {found}, not {moving.place(float(x), float(y))}")


@test
def the_robot_is_where_the_command_says_at_every_moment():
    for file, departure in [(scene(), 5), (scene(), 12), (SCENES / "fire-oregon-c.json", 52), (SCENES / "fires-accelerating.json", 0),
                            (SCENES / "gaps" / "settled-too-soon.json", 0)]:
        expect_robot_in_place(file, departure)


@test
def a_spiral_that_widens_twentyfold_in_a_radian_is_drawn_as_closely():
    """One curve for each 0.6 radians is enough of a circle only."""
    expect_robot_in_place(scene(source=[1.02, 0], destination=[-26, 198], discs=[{"center": [0, 0], "radius": 1, "growth": 0.95}]), 0)


@test
def discs_are_as_large_as_their_laws_say_at_every_moment():
    laws = {"at one rate": (0.1, lambda t: 1 + 0.1 * t), "polynomial": ([0, 0.01], lambda t: 1 + 0.01 * t * t), "not at all": (0, lambda t: 1),
            "by rates": ({"times": [0, 2, 7], "rates": [0, 0.4, 0.05]}, lambda t: 1 + 0.4 * (min(max(t, 2), 7) - 2) + 0.05 * max(t - 7, 0))}
    for name, (growth, law) in laws.items():
        disc = {"center": [0, 4], "radius": 1, "growth": growth}
        moving, report, _ = animated(scene(discs=[disc], robot={"speed": 1, "radius": 0.25}), "--depart", 1)
        for share in MOMENTS:
            time = 1 + share * (report["arrival"] - 1)
            tolerance = 0.012 if name == "at one rate" else 0.11
            expect_near(moving.radius([0, 4], share / REST), (law(time) + 0.25) * moving.scale, tolerance, f"{name} at {time}")


@test
def discs_that_grow_at_one_rate_need_no_more_than_their_ends():
    moving, _, _ = animated(scene(), "--depart", 5)
    for _, animation in moving.growing:
        expect_equal(len(animation.get("values").split(";")), 3, "departure, arrival, rest")


@test
def a_point_that_grows_is_seen_from_the_beginning():
    """It is drawn with a least size until it has it."""
    disc = {"center": [0, 4], "radius": 0, "growth": 0.05}
    moving, report, _ = animated(scene(discs=[disc]))
    for share in MOMENTS:
        expect_near(moving.radius([0, 4], share / REST), max(1.2, 0.05 * share * report["arrival"] * moving.scale), 0.012, f"radius at {share}")
    moving, _, _ = animated(scene(discs=[{**disc, "growth": 1e-6}, {"center": [0, -4], "radius": 1, "growth": 0.1}]))
    for share in MOMENTS:
        expect_near(moving.radius([0, 4], share / REST), 1.2, 0.012, f"radius of what does not grow that far at {share}")


@test
def at_the_end_it_is_the_still_picture():
    moving, report, described = animated(scene(), "--depart", 5)
    for disc in described["discs"]:
        for share in (1 / REST, 0.95, 1):
            expect_near(moving.radius(disc["center"], share), (disc["radius"] + disc["growth"] * report["arrival"]) * moving.scale, 0.012, "radius")
    done("plot", "scene.json", "-o", "still.svg", "--depart", 5)
    still = xml.parse("still.svg").getroot()
    expect_equal((still.get("width"), still.get("viewBox")), (moving.root.get("width"), moving.root.get("viewBox")), "size")
    layers = [element.get("class") for element in moving.root.iter(SVG + "g")]
    expect("still" in layers and "moving" in layers, layers)
    expect("prefers-reduced-motion" in moving.root.find(SVG + "style").text, "no style")


@test
def the_clock_tells_one_time_at_a_time_and_the_right_one():
    moving, report, _ = animated(scene(), "--depart", 5, "--seconds", 4)
    for i in range(200):
        share = i / 199
        shown = moving.clock(share)
        expect_equal(len(shown), 1, f"readings at {share}: {shown}")
        time = 5 + min(share * REST, 1) * (report["arrival"] - 5)
        told = float(shown[0].split()[0])
        expect(told <= time + 1e-3 and time - told < 1, f"{told} at {time}")
    expect_equal(moving.clock(0), ["5 s"])
    expect_equal(moving.clock(1), ["25 s"])


@test
def gaps_are_marked_from_the_moment_at_which_they_close():
    closes = done("jumps", scene(), "--json").json["jumps"][0]["time"]
    moving, report, _ = animated("scene.json", "--depart", 5, "--jumps")
    expect_equal(len(moving.groups), 1, "gaps")
    seen = moving.groups[0].find(SVG + "animate")
    moment = (closes - 5) / (report["arrival"] - 5) / REST
    expect(not shown_at(seen, moment - 1e-3) and shown_at(seen, moment + 1e-3) and shown_at(seen, 1), seen.attrib)
    expect(any(text.text.startswith("closes at 20.15") for text in moving.groups[0].iter(SVG + "text")), "no label")
    early, _, _ = animated("scene.json", "--depart", 0, "--to=-9,0", "--jumps")
    for group in early.groups:
        expect(not shown_at(group.find(SVG + "animate"), 1), "a gap that closes after the arrival is marked")


@test
def a_second_journey_goes_beside_the_first():
    """The way that is open at 9.8 is closed at 9.9."""
    moving, report, _ = animated(scene(), "--depart", 9.8, "--beside", 9.9)
    expect_equal(len(moving.motions), 2, "robots")
    expect_equal(report["arrival"], 29.8)
    end = done("arrive", "scene.json", 9.9, "--json").json["results"][0]["arrival"]
    for time in (9.8, 9.85, 15, 29, 33):
        share = (time - 9.8) / (end - 9.8) / REST
        for which, departure in ((-1, 9.8), (0, 9.9)):
            x, y = done("path", "scene.json", departure, "--at", repr(time)).rows()[0]
            found = moving.robot(share, which)
            expect(math.dist(found, moving.place(float(x), float(y))) < POINT, f"robot of {departure} at {time}: {found}")
    done("plot", "scene.json", "-o", "b.png", "--depart", 9.8, "--beside", 9.9)
    done("plot", "scene.json", "-o", "b.svg", "--depart", 9.8, "--beside", 1000)
    fails(2, ["--beside", "before the departure"], "plot", "scene.json", "-o", "b.svg", "--depart", 9.8, "--beside", 9)
    fails(2, ["--beside \"x\""], "plot", "scene.json", "-o", "b.svg", "--beside", "x")


@test
def all_animations_have_one_duration():
    for seconds, duration in ((None, "9.2s"), (1, "1.15s"), (20.5, "23.575s")):
        moving, report, _ = animated(scene(), "--jumps", *([] if seconds is None else ["--seconds", seconds]))
        expect_equal(moving.durations, {duration})
        expect_equal(report["seconds"], seconds or 8)


@test
def two_thousand_discs_make_a_file_of_a_sensible_size():
    done("generate", "crowd", "--n", 2000, "--seed", 3, "-o", "crowd.json")
    done("plot", "crowd.json", "-o", "crowd.svg", "--animate")
    expect(os.path.getsize("crowd.svg") < 200000, f"equal discs: {os.path.getsize('crowd.svg')}")
    done("generate", "random", "--n", 2000, "--seed", 3, "-o", "random.json")
    done("plot", "random.json", "-o", "random.svg", "--animate")
    expect(os.path.getsize("random.svg") < 1000000, f"all different: {os.path.getsize('random.svg')}")
    xml.parse("random.svg")


@test
def what_does_not_move_is_drawn_and_stands_still():
    for changes, options, status in [({}, ["--depart", 1000], "source_covered"), ({"destination": [-10, 0], "discs": []}, [], "ok")]:
        result = done("plot", scene(**changes), "-o", "a.svg", "--animate", "--json", *options)
        expect_equal((result.json["status"], result.json["seconds"]), (status, None))
        expect("stands still" in result.err, result)
        expect(not list(xml.parse("a.svg").getroot().iter(SVG + "animate")), "something moves")


@test
def what_cannot_be_animated_is_a_usage_error():
    for name in ("a.png", "a.gif", "a.webp", "a"):
        fails(2, [name, ".svg"], "plot", scene(), "-o", name, "--animate")
    for seconds in ("0", "0.5", "601", "-1", "x", "", "nan", "inf"):
        fails(2, ["--seconds"], "plot", scene(), "-o", "a.svg", "--animate", f"--seconds={seconds}")
    fails(2, ["--seconds goes with --animate"], "plot", scene(), "-o", "a.svg", "--seconds", 5)
    done("build", scene(), "-o", "t.tdsp")
    fails(2, ["--animate goes with a scene"], "plot", "t.tdsp", "-o", "a.svg", "--animate")
    fails(2, ["--beside goes with a scene"], "plot", "t.tdsp", "-o", "a.svg", "--beside", 5)
    expect_equal(sorted(os.listdir()), ["scene.json", "t.tdsp"])


@test
def every_shipped_scene_moves_well_formed():
    for file in sorted(SCENES.glob("*.json")):
        done("plot", file, "-o", "a.svg", "--animate")
        xml.parse("a.svg")


main()
