// SPDX-License-Identifier: MIT
/** The core by itself: it loads with nothing, answers, refuses with sentences, and gives all memory back. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { CoreError } from "../../tools/page/js/core.js";
import { newCore, read, wasm } from "./support.js";

const core = await newCore();
const twoDiscs = read("examples/scenes/two-discs.json");

/** What a question is refused with. @param {() => unknown} question @returns {CoreError} */
function refusal(question) {
    try {
        question();
    } catch (error) {
        assert.ok(error instanceof CoreError, `${error}`);
        return error;
    }
    return assert.fail("it was not refused");
}

test("the module asks for progress and for nothing else", () => {
    const imports = WebAssembly.Module.imports(new WebAssembly.Module(wasm));
    assert.deepEqual(imports, [{ module: "tdsp", name: "progress", kind: "function" }]);
});

test("the example of the introduction jumps where the gap closes", () => {
    const scene = core.scene(twoDiscs);
    assert.equal(scene.arrival(0).arrival, 20);
    const [jump, ...others] = scene.jumps();
    assert.deepEqual(others, []);
    assert.ok(Math.abs(jump.departure - 9.849623113) < 1e-8);
    assert.deepEqual([jump.gap.first, jump.gap.second], [0, 1]);
    assert.equal(scene.departure(33).departure, jump.departure);
    assert.deepEqual(scene.gap(jump.departure), jump.gap);
    assert.equal(scene.gap(0), null);
    assert.equal(scene.last().reason, "destination_covered");
    assert.equal(scene.arrival(70).status, "destination_covered");
    scene.free();
});

test("moving the ends answers as a scene with these ends does", () => {
    const [source, destination] = [[-9, 1], [12, -2]];
    const scene = core.scene(twoDiscs), other = core.scene({ ...twoDiscs, source, destination });
    scene.setEnds(source, destination);
    assert.equal(scene.hash, other.hash);
    assert.ok(Math.abs(scene.arrival(3).arrival - other.arrival(3).arrival) < 1e-9);
    assert.deepEqual(scene.build().bytes, other.build().bytes);
    assert.deepEqual(scene.description, other.description);
    for (const made of [scene, other]) made.free();
});

test("ends that were dragged far away and back are answered as exactly as before", () => {
    const scene = core.scene({ ...twoDiscs, discs: twoDiscs.discs.map((disc) => ({ ...disc, growth: 0 })) });
    scene.setEnds([-1e9, 0], [10, 0]);
    assert.ok(Math.abs(scene.arrival(0).arrival - (1e9 + 10)) < 1e-5);
    scene.setEnds([-10, 0], [10, 0]);
    assert.equal(scene.arrival(0).arrival, 20);
    scene.free();
});

test("positions along a path begin at the source, end at the destination and join", () => {
    const scene = core.scene(twoDiscs), { legs } = scene.path(12);
    assert.deepEqual(core.position(legs[0], 0), [-10, 0]);
    assert.deepEqual(core.position(legs.at(-1), 1e9), legs.at(-1).to);
    for (const leg of legs) {
        const [x, y] = core.position(leg, leg.end_time);
        assert.ok(Math.hypot(x - leg.to[0], y - leg.to[1]) < 1e-9);
    }
    scene.free();
});

test("the verifier takes a path and says what is wrong with a changed one", () => {
    const scene = core.scene(twoDiscs), { legs } = scene.path(12);
    assert.deepEqual(scene.verify(legs).problems, []);
    const [first, ...rest] = legs;
    const verdict = scene.verify([{ ...first, from: [-10, 0.5] }, ...rest]);
    assert.equal(verdict.ok, false);
    assert.match(verdict.problems[0], /does not start at the source/);
    scene.free();
});

test("radii follow the law of every disc", () => {
    const discs = [
        { center: [0, 50], radius: 1, growth: 0.5 },
        { center: [0, 90], radius: 2, growth: [0, 0.25] },
        { center: [0, -50], radius: 3, growth: { times: [0, 2], rates: [1, 0] } },
    ];
    const scene = core.scene({ robot: { speed: 1, radius: 7 }, source: [-10, 0], destination: [10, 0], discs });
    assert.deepEqual([...scene.radii(4)], [3, 6, 5]);
    assert.equal(scene.discRadius(1, 2), 3);
    scene.free();
});

test("the envelope's pieces join, and T is what the arrival says", () => {
    const scene = core.scene(twoDiscs), { pieces, evaluate, status } = scene.curve();
    assert.equal(status, "ok");
    assert.deepEqual(pieces.map((piece) => piece.change), ["jump", "end"]);
    assert.equal(pieces[0].until, pieces[1].from);
    assert.equal(evaluate(3), scene.arrival(3).travelTime);
    assert.ok(Number.isNaN(evaluate(1e3)));
    scene.free();
});

test("samples are the arrivals, and not a number where there is no way", () => {
    const scene = core.scene(twoDiscs);
    assert.deepEqual([...scene.samples(Float64Array.of(0, 12, 1000))], [20, scene.arrival(12).arrival, NaN]);
    scene.free();
});

test("progress is told, can call off, and may throw", () => {
    const scene = core.scene(twoDiscs);
    const told = [];
    scene.build({ progress: (settled, all) => void told.push([settled, all]) });
    assert.ok(told.length > 5);
    assert.equal(refusal(() => scene.build({ progress: () => true })).status, "cancelled");
    assert.throws(() => scene.curve({ progress: () => { throw new RangeError("mine"); } }), RangeError);
    assert.match(refusal(() => scene.jumps({ progress: () => { scene.arrival(0); } })).message, /busy/);
    assert.equal(scene.arrival(0).arrival, 20);
    scene.free();
});

test("a sealed-in source is a scene without a way", () => {
    const scene = core.scene({ ...twoDiscs, discs: [{ center: [-10, 0], radius: 1, growth: 0 }] });
    assert.deepEqual(scene.path(1), { status: "source_covered", departure: 1, arrival: null, travelTime: null, legs: [] });
    assert.deepEqual(scene.jumps(), []);
    assert.equal(scene.curve().status, "source_covered");
    assert.deepEqual([scene.last().departure, scene.last().reason], [-Infinity, "source_covered"]);
    const { message, status } = refusal(() => scene.build());
    assert.equal(message, "nothing to build: no path at departure 0: the source lies inside a disc at the departure");
    assert.equal(status, "source_covered");
    scene.free();
});

test("what is asked wrongly is refused with a sentence", () => {
    const scene = core.scene({ ...twoDiscs, discs: [] });
    assert.equal(refusal(() => scene.arrival(-1)).message, "the departure must be a number, finite and not negative");
    assert.equal(refusal(() => scene.arrival(NaN)).where, "departure");
    assert.equal(refusal(() => scene.departure("5")).status, "invalid_argument");
    assert.match(refusal(() => scene.build()).message, /no disc ever ends the departures of this scene: say how far/);
    assert.match(refusal(() => scene.jumps()).message, /say how far/);
    assert.equal(refusal(() => scene.build({ guarantee: "best" })).where, "guarantee");
    assert.equal(refusal(() => scene.build({ guarantee: "absolute" })).where, "delta");
    assert.equal(refusal(() => scene.build({ epsilon: 2 })).where, "epsilon");
    assert.equal(refusal(() => scene.build({ sampling: "geometric" })).where, "sampling");
    assert.equal(refusal(() => scene.setEnds([0, Infinity], [0, 0])).status, "bad_scene");
    assert.equal(refusal(() => scene.discRadius(0, 0)).where, "disc");
    scene.free();
    assert.match(refusal(() => scene.arrival(0)).message, /was freed/);
    assert.equal(refusal(() => core.statusText("unknown")).status, "invalid_argument");
    assert.equal(core.statusText("cut_off"), "Growing discs close every way to the destination");
});

test("a radius that shrinks is answered until then, and refused beyond with its place", () => {
    const scene = core.scene({ ...twoDiscs, discs: [{ center: [0, 30], radius: 1, growth: [1, -0.02] }] });
    assert.equal(scene.arrival(0).status, "ok");
    const { message, where, status } = refusal(() => scene.arrival(24));
    assert.equal(message, "discs[0].growth: the radius shrinks after t = 25, and this question reaches beyond");
    assert.deepEqual([where, status], ["discs[0].growth", "shrinks"]);
    scene.free();
});

test("everything that is freed is given back, and the memory stays flat", async () => {
    const own = await newCore(), before = own.blocksHeld;
    const use = () => {
        const scene = own.scene(twoDiscs);
        scene.setEnds([-9, 0], [9, 0]);
        scene.path(3);
        scene.last();
        scene.jumps();
        scene.curve();
        scene.radii(1);
        assert.throws(() => scene.build({ progress: () => true }));
        const table = own.table(scene.build().bytes);
        table.path(3);
        table.free();
        assert.throws(() => own.table(new Uint8Array(100)));
        assert.throws(() => own.scene({ ...twoDiscs, discs: [{}] }));
        scene.free();
        scene.free();
    };
    use();
    const size = own.memoryBytes;
    for (let i = 0; i < 40; i++) use();
    assert.equal(own.blocksHeld, before);
    assert.equal(own.memoryBytes, size);
});
