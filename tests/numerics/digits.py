#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The arithmetic of paths, done again with a hundred digits.

    digits.py BUILD [--scenes DIR] [--departures N]

A path of `tdsp path` names the discs it rides and their sides. From these alone, and the scene's numbers as they are in double, its arrival and all its contact points are solved
again: each ride is left where its own heading is that of the tangent from the rider's place to the next disc (or to the destination). This asks for the tangent from a point only,
which the library never uses between discs, and is independent of how large the scene is: it tells rounding from the path, not whether the path is the best.

Prints, for each scene, the worst error of an arrival in roundings, 2^-52 (t + A), and, what is more than one rounding, as a share of travel time plus |sd| / v; the worst error of a
contact point as a share of |sd|; and how deep a line is in any disc at most (of up to 400). Exit status 1 when a bound of docs/numerics.md does not hold.

Left out, and counted as touches: paths that change over from one ride to the next where discs touch, or that begin with a ride.
"""
import argparse
import json
import math
import pathlib
import subprocess
import sys
from decimal import Decimal as D, getcontext

DIGITS = 100
getcontext().prec = DIGITS + 20
ROUNDING = D(2) ** -52
BOUND_ERROR, BOUND_DEPTH = D("1e-11"), D("1e-11")
ZERO, ONE, TWO = D(0), D(1), D(2)


def small_atan(x):
    """atan of a small x, by its series."""
    term, total, n, square = x, x, 1, x * x
    while abs(term) > D(10) ** -(DIGITS + 15):
        term *= -square
        n += 2
        total += term / n
    return total


PI = 4 * (4 * small_atan(ONE / 5) - small_atan(ONE / 239))


def atan(x):
    halvings = 0
    while abs(x) > D("0.02"):
        x = x / (1 + (1 + x * x).sqrt())
        halvings += 1
    return small_atan(x) * 2**halvings


def atan2(y, x):
    if x > 0:
        return atan(y / x)
    if x < 0:
        return atan(y / x) + (PI if y >= 0 else -PI)
    return PI / 2 if y > 0 else -PI / 2


def sin_cos(angle):
    """Of an angle reduced to [-pi, pi] and halved until the series is short."""
    angle = wrap(angle) / 64
    term, sine, n = angle, angle, 1
    while abs(term) > D(10) ** -(DIGITS + 18):
        term *= -angle * angle / ((n + 1) * (n + 2))
        n += 2
        sine += term
    cosine = (1 - sine * sine).sqrt()
    for _ in range(6):
        sine, cosine = 2 * sine * cosine, 1 - 2 * sine * sine
    return sine, cosine


def wrap(angle):
    return angle - 2 * PI * (angle / (2 * PI)).to_integral_value()


class Disc:
    def __init__(self, given, speed, inflate):
        self.x, self.y = D(given["center"][0]), D(given["center"][1])
        self.radius = D(given["radius"]) + inflate
        self.growth = D(given["growth"])
        self.speed = speed
        self.cosine = self.growth / speed
        self.sine = (1 - self.cosine * self.cosine).sqrt() if self.growth < speed else ZERO
        self.theta = atan2(self.sine, self.cosine)

    def at(self, time):
        return self.radius + self.growth * time

    def clearance(self, x, y, time):
        return ((x - self.x) ** 2 + (y - self.y) ** 2).sqrt() - self.at(time)


class NoTangent(Exception):
    pass


class Ride:
    """A ride that began at a time, at an angle; `turned` counts in its own sense."""

    def __init__(self, disc, side, angle, time):
        self.disc, self.side, self.angle, self.time = disc, side, angle, time
        self.start = disc.at(time)

    def moment(self, turned):
        d = self.disc
        if d.growth == 0:
            elapsed = self.start * turned / d.speed
        else:
            elapsed = self.start * ((turned * d.cosine / d.sine).exp() - 1) / d.growth
        angle = self.angle + self.side * turned
        sine, cosine = sin_cos(angle)
        radius = self.start + d.growth * elapsed
        return d.x + radius * cosine, d.y + radius * sine, self.time + elapsed, angle + self.side * d.theta


def tangent(disc, side, x, y, time):
    """Heading and length of the tangent from a place: L = sqrt(|D|^2 - R^2) / sin(theta)."""
    dx, dy, radius = disc.x - x, disc.y - y, disc.at(time)
    squared = dx * dx + dy * dy - radius * radius
    if squared < 0:
        raise NoTangent
    length = squared.sqrt() / disc.sine
    reached = radius + disc.cosine * length
    return atan2(dy, dx) - side * atan2(disc.sine * reached, length - disc.cosine * reached), length


def secant(miss, near, step):
    """The zero of a function near a place known to some fifteen digits."""
    a, b = near, near + step
    fa, fb = miss(a), miss(b)
    for _ in range(60):
        if fb == fa or abs(b - a) < D(10) ** -(DIGITS - 20):
            return b
        c = b - fb * (b - a) / (fb - fa)
        a, fa, b = b, fb, c
        fb = miss(b)
    raise NoTangent


class Replay:
    """A path's legs once more: contact points and arrival."""

    def __init__(self, scene, discs, path):
        self.scene, self.discs, self.path = scene, discs, path
        self.speed = D(scene["robot"]["speed"])
        self.to = [D(v) for v in scene["destination"]]
        self.lines = []  # (x, y, heading, time, length)

    def hops(self):
        """The rides in order; whether a line follows each. Where two rides follow each other without a line the path changes over at a touch."""
        legs, rides = self.path["legs"], []
        for i, leg in enumerate(legs):
            if leg["type"] == "arc":
                rides.append((leg, i + 1 < len(legs) and legs[i + 1]["type"] == "line"))
                if i > 0 and legs[i - 1]["type"] == "arc":
                    raise NoTangent
        if legs and legs[0]["type"] == "arc":
            raise NoTangent
        return rides

    def leave(self, at, heading, length):
        self.lines.append((at[0], at[1], heading, at[2], length))
        sine, cosine = sin_cos(heading)
        return at[0] + length * cosine, at[1] + length * sine, at[2] + length / self.speed

    def straight(self, at):
        dx, dy = self.to[0] - at[0], self.to[1] - at[1]
        return atan2(dy, dx), (dx * dx + dy * dy).sqrt()

    def solve_leave(self, ride, guess, towards):
        """Where the ride's heading is the one `towards` a place or disc."""
        def miss(turned):
            at = ride.moment(turned)
            return wrap(at[3] - towards(at)[0])
        return secant(miss, guess, max(abs(guess), D("1e-6")) * D("1e-12"))

    def run(self):
        """Yields (engine's point, exact point, exact time) for each contact and the end."""
        rides = self.hops()
        at = tuple(D(v) for v in self.scene["source"]) + (D(self.path["departure"]),)
        ride = turned = None
        for n, (leg, leaves) in enumerate(rides):
            disc, side = self.discs[leg["disc"]], 1 if leg["turn"] == "ccw" else -1
            towards = lambda p, disc=disc, side=side: tangent(disc, side, p[0], p[1], p[2])
            if ride is not None:
                at = ride.moment(self.solve_leave(ride, turned, towards))
                yield rides[n - 1][0]["to"], at
            heading, length = towards(at)
            at = self.leave(at, heading, length)
            yield leg["from"], at
            ride = Ride(disc, side, heading - side * disc.theta, at[2])
            turned = self.engine_turn(leg, disc)
            if not leaves:  # the destination is on the boundary
                angle = atan2(self.to[1] - disc.y, self.to[0] - disc.x)
                around = side * (angle - ride.angle)
                end = ride.moment(around - 2 * PI * (around / (2 * PI)).to_integral_value(rounding="ROUND_FLOOR"))
                yield self.path["legs"][-1]["to"], end
                return
        if ride is not None:
            at = ride.moment(self.solve_leave(ride, turned, self.straight))
            yield rides[-1][0]["to"], at
        heading, length = self.straight(at)
        yield self.path["legs"][-1]["to"], self.leave(at, heading, length)

    def engine_turn(self, leg, disc):
        (fx, fy), (tx, ty) = leg["from"], leg["to"]
        one, two = atan2(D(fy) - disc.y, D(fx) - disc.x), atan2(D(ty) - disc.y, D(tx) - disc.x)
        turned = (two - one) * (1 if leg["turn"] == "ccw" else -1)
        duration = D(leg["end_time"]) - D(leg["start_time"])
        turned = turned - 2 * PI * (turned / (2 * PI)).to_integral_value(rounding="ROUND_FLOOR")
        # A ride of next to no angle may seem to turn by a little less than nothing.
        return turned - 2 * PI if turned > 6 and duration * disc.speed < disc.at(D(leg["start_time"])) else turned


class Worst:
    def __init__(self):
        self.paths = self.legs = self.other = 0
        self.roundings = self.error = self.place = self.depth = ZERO

    def row(self, name):
        return (f"| {name} | {self.paths} | {self.legs} | {self.other} | {self.roundings:.1f} | {self.error:.1e} | {self.place:.1e} | {self.depth:.1e} |")

    def holds(self):
        return self.error <= BOUND_ERROR and self.depth <= BOUND_DEPTH


def line_depth(discs, line, speed, size):
    """How deep the line is in any disc, as a share of |sd| plus its radius; the clearance is least where it grows as fast as the distance."""
    x, y, heading, time, length = line
    sine, cosine = sin_cos(heading)
    deepest = ZERO
    for disc in discs:
        dx, dy = disc.x - x, disc.y - y
        foot, aside = dx * cosine + dy * sine, abs(dx * sine - dy * cosine)
        least = foot + aside * disc.cosine / disc.sine if disc.sine > 0 else length
        for along in (ZERO, min(max(least, ZERO), length), length):
            clear = disc.clearance(x + along * cosine, y + along * sine, time + along / speed)
            if clear < 0:
                deepest = max(deepest, -clear / (size + disc.at(time)))
    return deepest


def measure_path(scene, discs, path, worst):
    departure, arrival = D(path["departure"]), D(path["arrival"])
    replay = Replay(scene, discs, path)
    source, to = [[D(v) for v in scene[end]] for end in ("source", "destination")]
    size = ((to[0] - source[0]) ** 2 + (to[1] - source[1]) ** 2).sqrt()
    largest = max(abs(v) for v in source + to)
    try:
        contacts = list(replay.run())
    except NoTangent:
        worst.other += 1
        return
    exact = contacts[-1][1][2]
    rounding = ROUNDING * (departure + exact)
    worst.paths += 1
    worst.legs += len(path["legs"])
    worst.roundings = max(worst.roundings, abs(arrival - exact) / rounding)
    worst.error = max(worst.error, (abs(arrival - exact) - rounding) / (exact - departure + size / replay.speed))
    for seen, at in contacts:
        off = ((D(seen[0]) - at[0]) ** 2 + (D(seen[1]) - at[1]) ** 2).sqrt() - 2 * ROUNDING * (largest + size + replay.speed * exact)
        worst.place = max(worst.place, off / size)
    if len(discs) <= 400:
        worst.depth = max([worst.depth] + [line_depth(discs, line, replay.speed, size) for line in replay.lines])


def run_json(command):
    out = subprocess.run(command, capture_output=True, text=True)
    return json.loads(out.stdout, parse_float=float) if out.returncode == 0 else None


def departures_of(tdsp, file, scene, count):
    """Spread over the departures that have a way, and the last one itself; over a thousand journeys where nothing ends them."""
    journey = math.dist(scene["source"], scene["destination"]) / scene["robot"]["speed"]
    last = run_json([tdsp, "depart", str(file), "1e300", "--json"])
    end = last["results"][0]["departure"] if last and last["results"] else None
    if end is None:
        return [0.0]
    return [min(end, 1e3 * journey) * i / count for i in range(count + 1)]


def is_constant(scene):
    return all(isinstance(d["growth"], (int, float)) for d in scene["discs"])


def measure_scene(tdsp, file, count):
    scene = json.loads(pathlib.Path(file).read_text())
    worst = Worst()
    if not is_constant(scene):
        return worst
    speed = D(scene["robot"]["speed"])
    inflate = D(scene["robot"].get("radius", 0))
    discs = [Disc(d, speed, inflate) for d in scene["discs"]]
    for departure in departures_of(tdsp, file, scene, count):
        path = run_json([tdsp, "path", str(file), repr(departure), "--json"])
        if path and path["arrival"] is not None and path["legs"]:
            measure_path(scene, discs, path, worst)
    return worst


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--scenes", type=pathlib.Path, nargs="+", default=[pathlib.Path("examples/scenes")])
    parser.add_argument("--departures", type=int, default=8)
    parser.add_argument("--table", action="store_true", help="print a table in Markdown in place of lines ok and not ok")
    args = parser.parse_args()
    failed = 0
    if args.table:
        print("| scene | paths | legs | touches | roundings | error of A | places | depth of lines |\n|---|---|---|---|---|---|---|---|")
    for folder in args.scenes:
        for file in sorted(folder.rglob("*.json")):
            worst = measure_scene(str(args.build / "tdsp"), file, args.departures)
            if worst.paths + worst.other == 0:
                continue
            failed += not worst.holds()
            name = str(file.relative_to(folder))
            print(worst.row(name) if args.table else f"{'ok' if worst.holds() else 'not ok'} {name} to a hundred digits: {worst.row('')}", flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
