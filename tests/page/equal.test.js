// SPDX-License-Identifier: MIT
/**
 * The module says what the command says, to the bit: arrivals, departures, paths, jumps, and tables byte for byte; and tables that the command wrote answer alike.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { test } from "node:test";
import { ask, exampleScenes, generatedScenes, newCore, run, scratchDirectory } from "./support.js";

const core = await newCore();
const directory = scratchDirectory();
const SHARES = [0, 0.1, 0.35, 0.5, 0.77, 0.99, 1, 1.1];

const TABLES = [
    [{ epsilon: 0.05 }, "--epsilon", "0.05"],
    [{ guarantee: "arrival", sampling: "geometric", epsilon: 0.3 }, "--guarantee", "arrival", "--sampling", "geometric", "--epsilon", "0.3"],
];

/** Legs as the command prints them. @param {any[]} legs */
const printed = (legs) =>
    legs.map(({ type, angle, sweep, ...rest }) => ({ type: type === "line" ? "line" : "arc", ...rest, ...(type === "curve" ? { sweep } : {}) }));

/** @param {import("../../tools/page/js/core_legs.js").Gap | null} gap */
const flat = (gap) => gap ?? { first: null, second: null, time: null, place: null };

/** Minus zero is printed as zero. @param {any} value @returns {any} */
const plain = (value) => JSON.parse(JSON.stringify(value));

/** Times from 0 to beyond the last, whole numbers of microseconds so that both sides read the same. @param {number} last */
const times = (last) => SHARES.map((share) => Math.round(share * last * 1e6) / 1e6);

for (const path of [...exampleScenes(), ...generatedScenes(directory)]) {
    const name = basename(path);
    test(`${name}: answers are the command's to the bit`, () => {
        const scene = core.scene(core.parse(readFileSync(path)));
        const last = scene.last().departure;
        const departures = times(Number.isFinite(last) && last > 0 ? last : 10);
        const { results } = ask("arrive", path, ...departures.map(String));
        for (const { departure, arrival, travel_time, status } of results)
            assert.deepEqual(plain(scene.arrival(departure)), { status, departure, arrival, travelTime: travel_time });
        const arrivals = results.filter((result) => result.arrival !== null).map((result) => result.arrival);
        for (const { arrival, departure, arrives, status } of ask("depart", path, ...arrivals.map(String)).results)
            assert.deepEqual(plain(scene.departure(arrival)), { status, arrival, departure, arrives });
        for (const departure of departures.slice(0, 4)) {
            const { legs, ...rest } = ask("path", path, String(departure));
            const own = scene.path(departure);
            assert.deepEqual(plain({ departure, arrival: own.arrival, status: own.status }), rest);
            assert.deepEqual(plain(printed(own.legs)), legs);
        }
        scene.free();
    });

    test(`${name}: the table is the command's byte for byte, and answers alike`, () => {
        const scene = core.scene(core.parse(readFileSync(path)));
        const file = join(directory, `${name}.tdsp`);
        const endless = !Number.isFinite(scene.last().departure);
        for (const [asked, ...words] of TABLES) {
            const options = endless ? { ...asked, horizon: 5 } : asked, args = endless ? [...words, "--horizon", "5"] : words;
            const { status, stderr } = run("build", path, "-o", file, ...args);
            assert.equal(status, 0, stderr);
            const bytes = new Uint8Array(readFileSync(file));
            const { bytes: own, report } = scene.build(options);
            assert.equal(Buffer.compare(own, bytes), 0, `of ${bytes.length} bytes ${bytes.filter((byte, i) => byte !== own[i]).length} differ`);
            assert.equal(report.bytes, bytes.length);
            const table = core.table(bytes);
            const { table: _, ...info } = ask("info", file);
            const { time_scale, ...ours } = table.info;
            assert.deepEqual(plain(ours), info);
            assert.equal(table.hash, scene.hash);
            const departures = times(info.last_departure);
            for (const { departure, lower, upper, status } of ask("query", file, ...departures.map(String)).results)
                assert.deepEqual(plain(table.arrival(departure)), { status, departure, lower, upper });
            for (const departure of departures.slice(0, 3)) {
                const { legs, ...rest } = ask("path", file, String(departure));
                const { legs: ownLegs, ...own } = table.path(departure);
                assert.deepEqual(plain(own), rest);
                assert.deepEqual(plain(printed(ownLegs)), legs);
            }
            for (const { arrival, departure, departure_upper, status } of ask("query", file, "--arrive-by", ...departures.map((time) => String(time + info.last_travel_time))).results)
                assert.deepEqual(plain(table.departure(arrival)), { status, arrival, departure, departureUpper: departure_upper });
            table.free();
        }
        scene.free();
    });
}

for (const path of [exampleScenes()[0], ...exampleScenes().slice(-2)])
    test(`${basename(path)}: jumps and pieces are the command's to the bit`, () => {
        const scene = core.scene(core.parse(readFileSync(path)));
        const jumps = scene.jumps().map(({ departure, travelBefore, travelAfter, size, gap }) => ({ departure, before: travelBefore, after: travelAfter, size, ...flat(gap) }));
        assert.deepEqual(plain(jumps), ask("jumps", path).jumps);
        const { pieces, forms } = scene.curve(), wanted = ask("envelope", path);
        assert.deepEqual([pieces.length, forms], [wanted.F, wanted.forms]);
        assert.deepEqual(plain(pieces.map(({ from, until, rides }) => ({ from, until, rides }))), wanted.pieces.map(({ from, until, rides }) => ({ from, until, rides })));
        scene.free();
    });

test("a table for ends that were moved is the command's for these ends", () => {
    const [path] = exampleScenes().slice(-1), file = join(directory, "moved.tdsp");
    const scene = core.scene(core.parse(readFileSync(path)));
    scene.setEnds([-9, 1.25], [11, -0.5]);
    assert.equal(run("build", path, "--from", "-9,1.25", "--to", "11,-0.5", "-o", file).status, 0);
    assert.equal(Buffer.compare(scene.build().bytes, readFileSync(file)), 0);
    scene.free();
});
