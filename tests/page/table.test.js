// SPDX-License-Identifier: MIT
/** Tables from bytes that anybody may have made: opened or refused with a sentence, never a trap; and what the module does when its memory is used up. */
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Core, CoreError } from "../../tools/page/js/core.js";
import { Wasm } from "../../tools/page/js/core_wasm.js";
import { newCore, read, root, wasm } from "./support.js";

const core = await newCore();
const twoDiscs = read("examples/scenes/two-discs.json");

/** Open bytes and use what opens. @param {Uint8Array} bytes @returns {string} the status that they were refused with, or "ok" */
function use(bytes) {
    let table;
    try {
        table = core.table(bytes);
    } catch (error) {
        assert.ok(error instanceof CoreError, `${error.stack}`);
        assert.match(error.status, /^bad_(magic|version|length|checksum|table)$/);
        assert.ok(error.message.length > 10);
        return error.status;
    }
    table.rows();
    table.jumps();
    for (const time of [0, 1, 50, 1e6]) {
        table.arrival(time);
        table.departure(time);
        for (const leg of table.path(time).legs) core.position(leg, time);
    }
    table.free();
    return "ok";
}

/** Numbers below `below`, the same ones each time. @param {number} seed */
function random(seed) {
    return (/** @type {number} */ below) => {
        seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
        return Math.floor((seed / 2 ** 32) * below);
    };
}

test("a bit turned anywhere in a table is noticed", () => {
    const scene = core.scene(twoDiscs), { bytes } = scene.build({ epsilon: 0.05 }), below = random(7);
    scene.free();
    assert.equal(use(bytes), "ok");
    for (let i = 0; i < 2000; i++) {
        const changed = bytes.slice();
        changed[below(bytes.length)] ^= 1 << below(8);
        assert.notEqual(use(changed), "ok");
    }
});

test("a table cut off anywhere is refused", () => {
    const scene = core.scene(twoDiscs), { bytes } = scene.build({ epsilon: 0.05 });
    scene.free();
    for (let length = 0; length < bytes.length; length += 13) assert.notEqual(use(bytes.subarray(0, length)), "ok");
});

test("golden tables are opened, and refused for what is wrong with them", () => {
    const golden = (/** @type {string} */ name) => readFileSync(join(root, "tests/golden", name));
    const answered = readdirSync(join(root, "tests/golden/answered")).filter((name) => name.endsWith(".tdsp"));
    for (const name of answered) assert.equal(use(golden(`answered/${name}`)), "ok", name);
    const refused = golden("refused.txt").toString().trim().split("\n").filter((line) => line.includes(".tdsp "));
    for (const [name, status] of refused.map((line) => line.split(" "))) assert.equal(use(golden(`refused/${name}`)), status, name);
    assert.ok(answered.length > 3 && refused.length > 30);
});

test("a table keeps the bytes that it was opened from, whatever becomes of them", () => {
    const scene = core.scene(twoDiscs), { bytes } = scene.build(), copy = bytes.slice();
    scene.free();
    const table = core.table(bytes);
    bytes.fill(0);
    assert.deepEqual(table.bytes, copy);
    assert.equal(table.arrival(3).status, "ok");
    table.free();
    assert.throws(() => table.arrival(3), /was freed/);
});

test("views go on where the memory has grown meanwhile", () => {
    const scene = core.scene(twoDiscs), before = core.memoryBytes;
    const discs = Array.from({ length: 20000 }, (_, i) => ({ center: [i % 200, 50 + Math.floor(i / 200)], radius: 0.1, growth: 0.01 }));
    const large = core.scene({ ...twoDiscs, discs });
    assert.ok(core.memoryBytes > before);
    assert.equal(scene.arrival(0).arrival, 20);
    assert.equal(large.radii(10)[19999], 0.2);
    assert.equal(large.samples(new Float64Array(100000)).length, 100000);
    for (const made of [scene, large]) made.free();
});

test("memory that is used up is an error with a sentence, and everything works on once there is some again", async () => {
    const module = await Wasm.load(wasm), own = new Core(module), scene = own.scene(twoDiscs);
    own.table(scene.build().bytes).free(); // the solver keeps its workspace
    const held = own.blocksHeld;
    const hoard = [];
    for (let size = 1 << 28; size >= 16; size >>= 1) {
        for (let at = 1; at; ) if ((at = module.call("allocate", size))) hoard.push(at);
    }
    for (const question of [() => own.scene(twoDiscs), () => scene.build(), () => scene.samples(new Float64Array(9)), () => own.table(new Uint8Array(9))])
        assert.throws(question, { name: "CoreError", status: "no_memory", message: /memory/ });
    const others = own.blocksHeld - hoard.length;
    for (let done = 0; done < 12; ) { // a little more each time: every allocation fails in turn
        module.release(hoard.pop());
        try {
            own.table(scene.build().bytes).free();
            done++;
        } catch (error) {
            assert.equal(error.status, "no_memory", `${error.stack}`);
        }
    }
    assert.equal(own.blocksHeld, others + hoard.length);
    for (const at of hoard) module.release(at);
    assert.equal(own.blocksHeld, held);
    assert.equal(scene.arrival(0).arrival, 20);
    own.table(scene.build().bytes).free();
    scene.free();
});
