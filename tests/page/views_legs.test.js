// SPDX-License-Identifier: MIT
/** The robot is where the command says, on legs of every kind, and the path on the screen goes through there. */
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { beginsRide, legAt, positionAt, prepareLegs } from "../../tools/page/js/scene_legs.js";
import { Projection } from "../../tools/page/js/scene_projection.js";
import { Tracer, traceLegs } from "../../tools/page/js/scene_trace.js";
import { ask, newCore, root, scratchDirectory } from "./support.js";

const core = await newCore();
const scratch = scratchDirectory();
const SHARES = [0, 0.013, 0.25, 0.5, 0.71, 0.99, 1];

/** A disc whose rate changes all the time is ridden along curves. */
const polynomial = {
    robot: { speed: 6 }, source: [-3000, 40], destination: [3000, 0],
    discs: [{ center: [-900, 30], radius: 300, growth: [0.4, 0.0011] }, { center: [900, -500], radius: 200, growth: [0.2, 0.0009, 1e-7] }],
};

/** @param {string} name @param {object} description */
function written(name, description) {
    const path = join(scratch, name);
    writeFileSync(path, JSON.stringify(description));
    return path;
}

const scenes = [
    ["two-discs", join(root, "examples/scenes/two-discs.json"), 12],
    ["fires-forecast", join(root, "examples/scenes/fires-forecast.json"), 0],
    ["fire-greece", join(root, "examples/scenes/fire-greece.json"), 0],
    ["polynomial", written("polynomial.json", polynomial), 10],
];

for (const [name, path, departure] of scenes) {
    const description = JSON.parse(readFileSync(path, "utf8"));
    const answer = ask("path", path, String(departure));
    const fromCommand = prepareLegs(answer.legs, description.robot.speed);
    const fromCore = prepareLegs(core.scene(description).path(departure).legs, description.robot.speed);

    test(`${name}: the robot is where \`tdsp path --at\` says`, () => {
        const at = [0, 0];
        for (const share of SHARES) {
            const time = departure + share * (answer.arrival - departure);
            const { position } = ask("path", path, String(departure), `--at=${time}`);
            for (const legs of [fromCommand, fromCore]) {
                positionAt(legs, time, at);
                const size = Math.hypot(...position) + description.robot.speed * time;
                assert.ok(Math.hypot(at[0] - position[0], at[1] - position[1]) <= 1e-9 * size, `${share}: ${at} is not ${position}`);
            }
        }
    });
}

test("the scenes of these tests have legs of every kind", () => {
    const legs = scenes.flatMap(([, path, departure]) => prepareLegs(ask("path", path, String(departure)).legs, 6));
    assert.ok(legs.some((leg) => !leg.ride) && legs.some((leg) => leg.ride && !leg.turned) && legs.some((leg) => leg.turned));
});

test("a ride of many curves begins once", () => {
    const legs = prepareLegs(ask("path", join(scratch, "polynomial.json"), "10").legs, 6);
    assert.ok(legs.filter((leg) => leg.ride).length > legs.filter((_, i) => beginsRide(legs, i)).length);
});

test("before it leaves the robot is at the source, after it arrives at the destination", () => {
    const { legs } = ask("path", scenes[0][1], "12"), ready = prepareLegs(legs, 1), at = [0, 0];
    positionAt(ready, -5, at);
    assert.deepEqual(at, [-10, 0]);
    positionAt(ready, 1e9, at);
    assert.ok(Math.hypot(at[0] - 10, at[1]) < 1e-12);
    assert.equal(legAt(ready, 23), 1);
});

/** A pen that keeps the points of lines. */
class Points {
    constructor() {
        this.lines = [];
    }
    move(x, y) { this.lines.push([[x, y]]); }
    line(x, y) { this.lines.at(-1).push([x, y]); }
}

/** @param {Projection} projection @param {import("../../tools/page/js/scene_legs.js").Leg[]} legs */
function traced(projection, legs, from = -Infinity, until = Infinity) {
    const pen = new Points(), tracer = new Tracer();
    tracer.begin(pen, projection);
    traceLegs(tracer, legs, from, until);
    return pen.lines;
}

/** How far a point is from the nearest line. */
function distance(lines, x, y) {
    let least = Infinity;
    for (const line of lines)
        for (let i = 1; i < line.length; i++) {
            const [x0, y0] = line[i - 1], dx = line[i][0] - x0, dy = line[i][1] - y0, square = dx * dx + dy * dy || 1;
            const share = Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / square));
            least = Math.min(least, Math.hypot(x0 + share * dx - x, y0 + share * dy - y));
        }
    return least;
}

for (const scale of [0.05, 3, 400])
    test(`the path on the screen is within 0.3 pixels of the true one at ${scale} pixels for a metre`, () => {
        const description = polynomial, legs = prepareLegs(core.scene(description).path(10).legs, 6), at = [0, 0];
        const ride = legs.find((leg) => leg.ride), middle = (ride.start + ride.end) / 2;
        positionAt(legs, middle, at);
        const projection = Object.assign(new Projection(), { left: 0, top: 0, width: 1200, height: 800, centerX: at[0], centerY: at[1], scale });
        const lines = traced(projection, legs);
        for (let i = -200; i <= 200; i++) {
            positionAt(legs, middle + (i * 600) / (200 * scale * 6), at);
            const x = projection.x(at[0]), y = projection.y(at[1]);
            if (x < 0 || y < 0 || x > 1200 || y > 800) continue;
            assert.ok(distance(lines, x, y) <= 0.3, `${distance(lines, x, y)}`);
        }
    });

test("a path seen from near is cut off around the window, and takes few lines", () => {
    const legs = prepareLegs(core.scene(polynomial).path(10).legs, 6), at = [0, 0];
    const ride = legs.find((leg) => leg.ride);
    positionAt(legs, (ride.start + ride.end) / 2, at);
    const projection = Object.assign(new Projection(), { left: 0, top: 0, width: 1200, height: 800, centerX: at[0], centerY: at[1], scale: 1e7 });
    const points = traced(projection, legs).flat();
    assert.ok(points.length >= 2 && points.length < 200, `${points.length}`);
    for (const [x, y] of points) assert.ok(x >= -65 && x <= 1265 && y >= -65 && y <= 865, `${x} ${y}`);
});

test("of a path the part behind the robot ends where the robot is", () => {
    const legs = prepareLegs(ask("path", scenes[0][1], "12").legs, 1), at = [0, 0];
    const projection = Object.assign(new Projection(), { width: 1200, height: 800, scale: 40 });
    positionAt(legs, 25, at);
    const [x, y] = traced(projection, legs, -Infinity, 25).at(-1).at(-1);
    assert.ok(Math.hypot(x - projection.x(at[0]), y - projection.y(at[1])) < 1e-6);
});
