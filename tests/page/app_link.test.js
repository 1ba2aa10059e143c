// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";
import { LinkError, changed, differences, fromBase64url, readLink, toBase64url, writeLink } from "../../tools/page/js/link.js";
import { START, reduce } from "../../tools/page/js/state.js";

const scene = { name: "two", units: { length: "m", time: "s" }, robot: { speed: 1 }, source: [-10, 0], destination: [10, 0],
    discs: [{ center: [0, 3], radius: 1, growth: 0.1 }, { center: [0, -3], radius: 1, growth: [0.1, 0.2] }] };
const gallery = (name) => (name === "two-discs" ? scene : undefined);
const after = (state, ...actions) => actions.reduce(reduce, state);
const inGallery = () => reduce(START, { type: "open", name: "two-discs", from: "two-discs", scene });

/** The state that a link leads to. */
async function followed(link) {
    return reduce(START, await readLink(link, gallery));
}

test("a scene of the gallery is a link by its name", async () => {
    const link = await writeLink(inGallery());
    assert.equal(link, "scene=two-discs");
    assert.deepEqual((await followed(link)).edit, { scene, factor: 1 });
});

test("the whole state comes back: edits, departure, deadline, epsilon, curve and selection", async () => {
    const state = after(inGallery(), { type: "place", thing: { what: "disc", index: 1 }, place: [0.1, 1 / 3] }, { type: "place", thing: { what: "source", index: -1 }, place: [-9, 1] },
        { type: "speed", speed: 1.25 }, { type: "factor", factor: 0.3 }, { type: "departure", departure: 9.849623113198598 }, { type: "deadline", deadline: 30.5 },
        { type: "mode", mode: "arrival" }, { type: "epsilon", epsilon: 0.001 }, { type: "select", thing: { what: "disc", index: 1 } });
    const back = await followed(await writeLink(state));
    for (const key of ["name", "from", "edit", "departure", "deadline", "mode", "epsilon", "selected"]) assert.deepEqual(back[key], state[key], key);
    assert.deepEqual(back.original.scene, scene);
});

test("what is looked at, and when, comes back too", async () => {
    const link = await writeLink(inGallery(), { view: { x: 1 / 3, y: -2, width: 1234.5678 }, time: 17.25 });
    const { view, time } = await readLink(link, gallery);
    assert.deepEqual([view, time], [{ x: 0.333333333, y: -2, width: 1234.5678 }, 17.25]);
    const plain = await readLink(await writeLink(inGallery(), { view: null, time: null }), gallery);
    assert.deepEqual([plain.view, plain.time], [null, null]);
});

test("a link cannot select a disc that is not there", async () => {
    assert.equal((await followed("scene=two-discs&selected=disc99")).selected, null);
    assert.deepEqual((await followed("scene=two-discs&selected=disc1")).selected, { what: "disc", index: 1 });
});

test("a scene of one's own is in the link, edits beside it", async () => {
    const own = reduce(START, { type: "open", name: "Größer & größer", scene });
    const back = await followed(await writeLink(after(own, { type: "remove-disc", index: 0 })));
    assert.equal(back.name, "Größer & größer");
    assert.deepEqual(back.original.scene, scene);
    assert.deepEqual(back.edit.scene.discs, [scene.discs[1]]);
});

test("a table is in the link", async () => {
    const bytes = Uint8Array.from({ length: 5000 }, (_, i) => (i * 7) % 256);
    const back = await followed(await writeLink(reduce(START, { type: "open", name: "t", bytes })));
    assert.deepEqual(back.bytes, bytes);
});

test("where the browser cannot deflate, the link is longer and still whole", async () => {
    const kept = globalThis.CompressionStream;
    delete globalThis.CompressionStream;
    try {
        const link = await writeLink(reduce(START, { type: "open", name: "own", scene }));
        assert.match(link, /whole=r/);
        assert.deepEqual((await followed(link)).edit.scene, scene);
    } finally {
        globalThis.CompressionStream = kept;
    }
});

test("differences hold only what differs, and make the scene again", () => {
    const next = { ...scene, discs: [scene.discs[0], { ...scene.discs[1], radius: 2 }, { center: [1, 1], radius: 1, growth: 0 }] };
    const changes = differences(scene, next);
    assert.deepEqual(Object.keys(changes).sort(), ["count", "discs"]);
    assert.deepEqual(Object.keys(changes.discs), ["1", "2"]);
    assert.deepEqual(changed(scene, changes), next);
});

test("bytes survive base64url, and it needs no escapes", () => {
    const bytes = Uint8Array.from({ length: 20001 }, (_, i) => (i * 37) % 256);
    assert.deepEqual(fromBase64url(toBase64url(bytes)), bytes);
    assert.match(toBase64url(bytes), /^[A-Za-z0-9_-]+$/);
});

test("no link asks for nothing", async () => {
    assert.equal(await readLink("", gallery), null);
    assert.equal(await readLink("main", gallery), null);
});

test("a broken link is answered with a sentence", async () => {
    const whole = await writeLink(reduce(START, { type: "open", name: "own", scene }));
    const broken = {
        "scene=atlantis": /asks for a scene called "atlantis"/,
        "scene=two-discs&leave=soon": /"soon" is no time to leave/,
        "scene=two-discs&leave=-1": /is no time to leave/,
        "scene=two-discs&deadline=": /is no time to arrive by/,
        "scene=two-discs&time=never": /"never" is no time to look at/,
        "scene=two-discs&view=1,2": /"1,2" is no place to look at/,
        "scene=two-discs&view=1,2,-3": /is no place to look at/,
        "scene=two-discs&view=1,2,3,4": /is no place to look at/,
        "scene=two-discs&epsilon=7": /its epsilon is not from/,
        "scene=two-discs&edit=zAAAA": /damaged/,
        "scene=two-discs&edit=q": /another version/,
        "scene=two-discs&edit=rW10": /multiplier is no number/,
        "whole=z!!": /damaged/,
        "whole=rbnVsbA": /is no scene/,
        [whole.slice(0, -20)]: /damaged/,
        [`scene=two-discs&edit=r${btoa('{"factor":1,"discs":{"9":{}}}')}`]: /discs that are not there/,
    };
    for (const [link, sentence] of Object.entries(broken)) {
        await assert.rejects(followed(link), (error) => error instanceof LinkError && sentence.test(error.message), link);
    }
});

test("a link that unpacks to more than the page can hold is refused while it unpacks", async () => {
    const bomb = new Response(new Blob([new Uint8Array(1 << 26)]).stream().pipeThrough(new CompressionStream("deflate")));
    const link = `table=z${toBase64url(new Uint8Array(await bomb.arrayBuffer()))}`;
    await assert.rejects(readLink(link, gallery), /holds more than the page can show/);
});
