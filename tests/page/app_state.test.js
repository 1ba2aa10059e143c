// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";
import { EPSILON, REMEMBERED, START, Store, effectiveScene, isEdited, placeOf, reduce, scaledGrowth } from "../../tools/page/js/state.js";

const scene = Object.freeze({ name: "two", robot: { speed: 1 }, source: [-10, 0], destination: [10, 0],
    discs: [{ center: [0, 3], radius: 1, growth: 0.1 }, { center: [0, -3], radius: 1, growth: [0.1, 0.2] }, { center: [5, 5], radius: 1, growth: { times: [0, 1], rates: [1, 2] } }] });
const opened = () => reduce(START, { type: "open", name: "two", scene });
const after = (state, ...actions) => actions.reduce(reduce, state);

test("an opened scene is not edited, and nothing can be undone", () => {
    const state = opened();
    assert.equal(isEdited(state), false);
    assert.equal(reduce(state, { type: "undo" }), state);
    assert.equal(reduce(state, { type: "redo" }), state);
});

test("the multiplier 1 leaves the scene the same object; others multiply every law of growth", () => {
    const state = opened();
    assert.equal(effectiveScene(state.edit), scene);
    assert.deepEqual(effectiveScene({ scene, factor: 2 }).discs.map((d) => d.growth), [0.2, [0.2, 0.4], { times: [0, 1], rates: [2, 4] }]);
    assert.deepEqual(scaledGrowth([1, 2], 0), [0, 0]);
});

test("an edit changes nothing of the state before it", () => {
    const before = opened(), copy = structuredClone(before);
    const next = reduce(before, { type: "place", thing: { what: "disc", index: 1 }, place: [7, 8] });
    assert.deepEqual(structuredClone(before), copy);
    assert.deepEqual(placeOf(next, { what: "disc", index: 1 }), [7, 8]);
    assert.equal(next.edit.scene.discs[0], scene.discs[0], "what did not change is shared");
});

test("undo goes back edit by edit, redo forward, a new edit forgets what was undone", () => {
    let state = after(opened(), { type: "speed", speed: 2 }, { type: "factor", factor: 3 }, { type: "place", thing: { what: "source", index: -1 }, place: [1, 1] });
    state = after(state, { type: "undo" }, { type: "undo" });
    assert.equal(state.edit.scene.robot.speed, 2);
    assert.equal(state.edit.factor, 1);
    assert.equal(after(state, { type: "redo" }).edit.factor, 3);
    assert.equal(after(state, { type: "speed", speed: 5 }).future.length, 0);
    assert.equal(isEdited(after(state, { type: "undo" })), false);
});

test("a drag is undone as one, two drags as two", () => {
    const move = (gesture, x) => ({ type: "place", thing: { what: "destination", index: -1 }, place: [x, 0], gesture });
    const state = after(opened(), move(1, 1), move(1, 2), move(1, 3), move(2, 4), move(2, 5));
    assert.equal(state.past.length, 2);
    assert.deepEqual(after(state, { type: "undo" }).edit.scene.destination, [3, 0]);
    assert.deepEqual(after(state, { type: "undo" }, { type: "undo" }).edit.scene.destination, [10, 0]);
});

test("so many edits are remembered and no more", () => {
    let state = opened();
    for (let i = 0; i < REMEMBERED + 10; i++) state = reduce(state, { type: "speed", speed: i + 1 });
    assert.equal(state.past.length, REMEMBERED);
});

test("discs are added and removed; the selection of one that is gone goes", () => {
    const added = after(opened(), { type: "add-disc", disc: { center: [1, 1], radius: 2, growth: 0 } }, { type: "select", thing: { what: "disc", index: 3 } });
    assert.equal(added.edit.scene.discs.length, 4);
    assert.equal(after(added, { type: "undo" }).selected, null);
    assert.equal(after(added, { type: "remove-disc", index: 0 }).selected, null);
});

test("reset goes back to what was opened, and can be undone", () => {
    const state = after(opened(), { type: "speed", speed: 9 }, { type: "reset" });
    assert.equal(isEdited(state), false);
    assert.equal(after(state, { type: "undo" }).edit.scene.robot.speed, 9);
    assert.equal(after(opened(), { type: "reset" }).past.length, 0);
});

test("opening forgets the edits before and keeps what was chosen to look at", () => {
    const state = after(opened(), { type: "mode", mode: "arrival" }, { type: "epsilon", epsilon: 0.1 }, { type: "speed", speed: 3 }, { type: "departure", departure: 5 });
    const next = reduce(state, { type: "open", name: "other", scene });
    assert.deepEqual([next.mode, next.epsilon, next.past.length, next.departure, next.name], ["arrival", 0.1, 0, 0, "other"]);
    assert.equal(START.epsilon, EPSILON.first);
});

test("an action that is none is an error of the program", () => {
    assert.throws(() => reduce(opened(), { type: "fly" }), /no such action: fly/);
});

test("the store tells its listeners what was before, and freezes what is", () => {
    const store = new Store(), seen = [];
    store.listen((state, before) => seen.push([before.departure, state.departure]));
    store.dispatch({ type: "open", name: "two", scene });
    store.dispatch({ type: "departure", departure: 4 });
    store.dispatch({ type: "departure", departure: -4 });
    assert.deepEqual(seen, [[0, 0], [0, 4], [4, 0]]);
    assert.ok(Object.isFrozen(store.state));
});
