// SPDX-License-Identifier: MIT
/** What the command refuses the core refuses, at the same place and in the same words; what it takes, it takes, with the same warnings. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { CoreError } from "../../tools/page/js/core.js";
import { newCore, root, run, scratchDirectory } from "./support.js";

const core = await newCore();
const directory = scratchDirectory();
const file = join(directory, "scene.json");

/** What the core says of a file's bytes: its warnings, or its refusal. @param {Uint8Array} bytes */
function judge(bytes) {
    try {
        const scene = core.scene(core.parse(bytes));
        const { warnings } = scene;
        scene.free();
        return { refused: null, warnings };
    } catch (error) {
        assert.ok(error instanceof CoreError, `${error.stack}`);
        assert.equal(error.status, "bad_scene");
        return { refused: error.message, warnings: [] };
    }
}

/** What the command says of it, without its own name and the file's. @param {Uint8Array} bytes */
function commanded(bytes) {
    writeFileSync(file, bytes);
    const { status, stderr } = run("arrive", file, "0");
    const lines = stderr.split("\n").filter((line) => line).map((line) => line.replace(`${file}:`, "").replace(/^tdsp[^:]*: /, "").trim());
    if (status !== 3) return { refused: null, warnings: lines.filter((line) => line.startsWith("warning: ")).map((line) => line.slice("warning: ".length).trim()) };
    return { refused: lines.at(-1).replace(/^(\d+):(\d+): /, "line $1, column $2: "), warnings: [] };
}

/** @type {[string, string][]} */
const cases = JSON.parse(execFileSync("python3", [join(root, "tests/page/refused.py")], { encoding: "utf8", maxBuffer: 1 << 26 }));

for (const [name, content] of cases)
    test(`${name} is refused in the command's words`, () => {
        const bytes = Buffer.from(content, "base64"), own = judge(bytes), wanted = commanded(bytes);
        assert.notEqual(own.refused, null);
        assert.equal(own.refused.replace("this is neither", "neither"), wanted.refused);
    });

const scene = (changes) => Buffer.from(JSON.stringify({ robot: { speed: 1 }, source: [-10, 0], destination: [10, 0], discs: [{ center: [0, 3], radius: 1, growth: 0.1 }], ...changes }));
const many = Object.fromEntries(Array.from({ length: 30 }, (_, i) => [`key${i}`, i]));
const taken = {
    "a scene": scene({}),
    "unknown keys": scene({ note: 1, units: { mass: "kg" }, robot: { speed: 1, colour: "red" }, discs: [{ center: [0, 3], radius: 1, growth: { times: [0], rates: [1], unit: "m" }, id: 3 }] }),
    "a byte order mark and line feeds": Buffer.concat([Buffer.from("\ufeff\r\n\t"), scene({ name: "ä" })]),
    "escapes": Buffer.from(scene({ name: "X" }).toString().replace("X", '\\u00e4\\ud83d\\udd25\\"\\/')),
    "whole numbers of any size": Buffer.from(scene({}).toString().replace("[10,0]", "[99999999999999999999,18446744073709551617]")),
    "a georeference": scene({ georeference: { origin: [10, 50], projection: "azimuthal equidistant", ellipsoid: "WGS84", height: 1 } }),
    "a key called __proto__": Buffer.from(scene({}).toString().replace("{", '{"__proto__": 1, ')),
};
for (const [name, bytes] of Object.entries(taken))
    test(`${name}: taken, with the command's warnings`, () => assert.deepEqual(judge(bytes), commanded(bytes)));

test("as many unknown keys are named as the command names", () => {
    const bytes = scene({ discs: [{ center: [0, 3], radius: 1, growth: 0.1, ...many }] });
    const [own, wanted] = [judge(bytes).warnings, commanded(bytes).warnings]; // which of them depends on the order of its table
    assert.equal(own.length, wanted.length);
    assert.equal(own.at(-1), wanted.at(-1));
});

test("a wrong georeference is refused in the command's words", () => {
    for (const georeference of [1, {}, { origin: [10, 91] }, { origin: [181, 0] }, { origin: [0, 0], projection: "Mercator" }, { origin: [0, 0], ellipsoid: 7 }]) {
        const bytes = scene({ georeference });
        assert.deepEqual(judge(bytes), commanded(bytes));
        assert.notEqual(judge(bytes).refused, null);
    }
});

test("numbers that JSON cannot write are refused in a description", () => {
    for (const [value, reason] of [[NaN, "not a number as JSON writes them"], [Infinity, "a number too large for a double"], [undefined, "missing"]])
        assert.throws(() => core.scene({ robot: { speed: 1 }, source: [0, 0], destination: [1, 0], discs: [{ center: [0, 3], radius: value, growth: 1 }] }), {
            message: `discs[0].radius: ${reason}`,
            where: "discs[0].radius",
            status: "bad_scene",
        });
});

test("texts with mistakes anywhere are judged as the command judges them", () => {
    const text = '{"name": "é", "units": {"length": "m"}, "robot": {"speed": 1, "radius": 0.25}, "source": [-10, 0], "destination": [10, 0],\n'
        + ' "georeference": {"origin": [10, 50]}, "discs": [{"center": [0, 3], "radius": 1, "growth": 0.1},\n {"center": [0, -3], "radius": 1, "growth": [0.1, 0.02]},'
        + ' {"center": [0, -30], "radius": 1, "growth": {"times": [0, 5], "rates": [0.1, 0.2]}}]}';
    const pieces = [..."-019eE.+,:[]{}\"\\u x\n\u0000é\ud83d\udd25", "null", "1e999", "-1", "1e101", "1e-400", "00", '"a":1,', "\\ud83d\\udd25", "\\u0000"];
    let seed = 20;
    const below = (limit) => Math.floor(((seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32) * limit);
    for (let i = 0; i < 150; i++) {
        const at = below(text.length), cut = at + below(3);
        const bytes = Buffer.from(text.slice(0, at) + (below(3) > 0 ? pieces[below(pieces.length)] : "") + text.slice(cut));
        if (below(8) === 0) bytes[below(bytes.length)] |= 128;
        const own = judge(bytes), wanted = commanded(bytes);
        assert.equal(own.refused?.replace("this is neither", "neither") ?? null, wanted.refused, bytes.toString());
        assert.equal(own.warnings.length, wanted.warnings.length, bytes.toString());
    }
});

test("of bytes that are no UTF-8 and a zero byte the first is named", () => {
    for (const text of ["{\0\xff", "{\xff\0", "x\xff", "{1e1010.5\xff"]) {
        const bytes = Buffer.from(text, "latin1");
        assert.equal(judge(bytes).refused.replace("this is neither", "neither"), commanded(bytes).refused);
    }
});
