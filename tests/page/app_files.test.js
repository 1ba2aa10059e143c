// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";
import { answersJson, buildKeys, curveCsv, pathCsv, stackSvg } from "../../tools/page/js/export.js";
import { locate } from "../../tools/page/js/locate.js";
import { FileError, LARGEST_FILE, openBytes, openFile, refusal, sceneText, stem } from "../../tools/page/js/files.js";

const utf8 = (text) => new TextEncoder().encode(text);
const scene = { name: "two", units: { length: "m", time: "s" }, robot: { speed: 1 }, source: [-10, 0], destination: [10, 1 / 3],
    discs: [{ center: [0, 3], radius: 1, growth: 0.1 }, { center: [0, -3], radius: 1, growth: { times: [0, 1], rates: [1, 2] } }] };

test("a table is known by its first bytes, whatever it is called", () => {
    const bytes = Uint8Array.of(0x89, 0x54, 0x44, 0x53, 0x50, 0x0d, 0x0a, 0x1a, 1, 2);
    assert.deepEqual(openBytes("route.json", bytes), { name: "route", bytes });
});

test("a scene is read, and its text kept for messages", () => {
    const content = openBytes("dir/two.json", utf8(JSON.stringify(scene)));
    assert.equal(content.name, "two");
    assert.deepEqual(content.scene, scene);
});

test("what cannot be opened is named with the file, the place and the reason", () => {
    const cases = [["a.json", "", /^a\.json is empty\.$/], ["b.json", '{"robot": {"speed": 1},\n "discs": [}', /^b\.json, line 2, column 12: [^.]+\.$/],
        ["c.json", '{"robot": {"speed": 1},\n "robot": 1}', /^c\.json, line 2, column \d+: .*robot\.$/], ["d.tdsp", "hello", /^d\.tdsp: this is neither JSON nor a table\.$/]];
    for (const [name, text, sentence] of cases) assert.throws(() => openBytes(name, utf8(text)), (error) => error instanceof FileError && sentence.test(error.message), name);
    assert.throws(() => openBytes("e.json", Uint8Array.of(0x7b, 0xff, 0xfe)), /^FileError: e\.json|e\.json, line 1, column 2: not UTF-8\./);
});

test("a place in a scene is found again in its text", () => {
    const text = '{"robot": {"speed": 1},\n "a,]\\"": [],  "discs": [{"radius": 1},\n  {"radius": -2}]}';
    assert.deepEqual(locate(text, "discs[1].radius"), { line: 3, column: 14 });
    assert.deepEqual(locate(text, "robot.speed"), { line: 1, column: 21 });
    assert.deepEqual(locate(text, "discs[1].center"), { line: 3, column: 3 }, "what is missing is missing in what is around it");
    assert.deepEqual(locate(text, "source"), { line: 1, column: 1 });
});

test("a file that is too large is refused before it is read", async () => {
    const file = { name: "big.json", size: LARGEST_FILE + 1, arrayBuffer: () => assert.fail("read") };
    await assert.rejects(openFile(file), /^FileError|big\.json has 64 MB: this page opens files up to 64 MB\./);
});

test("what the core refuses is found in the file", () => {
    const text = '{"robot": {"speed": 1},\n "source": [0, 0], "destination": [1, 0],\n "discs": [{"center": [0, 3],\n  "radius": -1, "growth": 0.1}]}';
    const error = { message: "discs[0].radius: must not be negative", where: "discs[0].radius" };
    assert.equal(refusal("b.json", error, text), "b.json, line 4, column 13 (discs[0].radius): must not be negative.");
    assert.equal(refusal("b.json", error), "b.json, discs[0].radius: must not be negative.");
    assert.equal(refusal("t.tdsp", { message: "the checksum does not match" }), "t.tdsp: the checksum does not match.");
});

test("a saved scene reads back as the same numbers, a disc a line", () => {
    const text = sceneText(scene);
    assert.deepEqual(JSON.parse(text), scene);
    assert.equal(text.split("\n").filter((line) => line.includes("center")).length, 2);
    assert.deepEqual(JSON.parse(sceneText({ ...scene, discs: [] })).discs, []);
});

test("names lose their folder and their ending", () => {
    assert.deepEqual(["/a/b.json", "c.tdsp", "d.e", "x\\y.JSON"].map(stem), ["b", "c", "d.e", "y"]);
});

test("a path is CSV with the columns of the command, rides in small steps", () => {
    const legs = [{ type: "line", start_time: 0, end_time: 1, from: [0, 0], to: [1, 0] },
        { type: "arc", start_time: 1, end_time: 2, from: [1, 0], to: [2, 0], disc: 7, turn: "cw", angle: 3, sweep: -0.35 }, { type: "line", start_time: 2, end_time: 3, from: [2, 0], to: [3, 0] }];
    const lines = pathCsv(legs, (leg, time) => [time, leg.disc]).trim().split("\n");
    assert.equal(lines[0], "time,x,y,leg,type,disc");
    assert.deepEqual(lines.slice(1, 3), ["0,0,0,0,line,", "1,1,0,0,line,"]);
    assert.equal(lines.filter((line) => line.endsWith(",1,arc,7")).length, 4);
    assert.equal(lines.at(-1), "3,3,0,2,line,");
    const times = lines.slice(1).map((line) => Number(line.split(",")[0]));
    assert.deepEqual(times, [...new Set(times)].sort((a, b) => a - b));
});

test("the curve is CSV in order, with both sides of each jump", () => {
    const points = [0, 5, 10, 15].map((departure) => ({ departure, arrival: departure + 20 + (departure > 10 ? 4 : 0) }));
    const csv = curveCsv(points, [{ departure: 10, travelBefore: 20, travelAfter: 24, size: 4, gap: { first: 0, second: 1 } }]);
    assert.equal(csv, "departure,travel_time,arrival,first,second\n0,20,20,,\n5,20,25,,\n10,20,30,0,1\n10,24,34,0,1\n15,24,39,,\n");
});

test("answers have the command's keys", () => {
    const gap = { first: 0, second: 1, time: 20, place: [0, 0] };
    const report = { rows: 39, bytes: 8592, forwardCalls: 50, reverseCalls: 3, lastDeparture: 60.3, lastReason: "destination_covered", oracleDelta: 0.0075, roughCalls: 0 };
    const all = JSON.parse(answersJson({ name: "two", path: { departure: 5, arrival: 25, status: "ok", legs: [], travelTime: 20 }, last: { departure: 60.3 },
        jumps: [{ departure: 9.8, travelBefore: 20, travelAfter: 24, size: 4, gap }, { departure: 11, travelBefore: 24, travelAfter: 25, size: 1, gap: null }], build: buildKeys(report, { epsilon: 0.01, seconds: 0.1, file: "two.tdsp" }) }));
    assert.deepEqual(all.path, { departure: 5, arrival: 25, status: "ok", legs: [] });
    assert.deepEqual(all.jumps.jumps[0], { departure: 9.8, before: 20, after: 24, size: 4, ...gap });
    assert.equal(all.jumps.jumps[1].first, null);
    assert.equal(all.build.forward_calls, 50);
});

test("where there is no way at all, the jumps say why", () => {
    const all = JSON.parse(answersJson({ name: "x", path: { departure: 0, arrival: null, status: "cut_off", legs: [] }, jumps: [], last: { departure: -1, reason: "cut_off" } }));
    assert.equal(all.jumps.status, "cut_off");
});

test("two pictures are one, the second below the first", () => {
    const svg = stackSvg(['<?xml version="1.0"?>\n<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200"><g/></svg>', '<svg width="280" height="100"><g/></svg>']);
    assert.match(svg, /^<svg [^>]*width="300" height="300"/);
    assert.match(svg, /<svg x="0" y="200" width="280"/);
    assert.doesNotMatch(svg, /<\?xml/);
});
