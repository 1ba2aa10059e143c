// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";
import { Sampler, SAMPLES, refinedOrder } from "../../tools/page/js/sampler.js";
import { Playback, WAIT_SECONDS, WAY_SECONDS, advanced, rate } from "../../tools/page/js/playback.js";
import { roundUp } from "../../tools/page/js/answers.js";

test("the way takes as long on the wall whatever the scene", () => {
    for (const arrival of [1, 30, 4497]) assert.ok(Math.abs(rate(0, { departure: 0, arrival }) * WAY_SECONDS - arrival) < 1e-9 * arrival);
});

test("waiting is shown quicker, never slower, than the way", () => {
    const span = { departure: 5000, arrival: 6000 };
    assert.equal(rate(0, span), 5000 / WAIT_SECONDS);
    assert.equal(rate(0, { departure: 0.1, arrival: 600.1 }), 600 / WAY_SECONDS);
});

test("a step over the departure goes on at the pace of the way", () => {
    const span = { departure: 16, arrival: 76 };
    assert.ok(Math.abs(advanced(15, 1, span) - (16 + 0.9 * 10)) < 1e-9);
    assert.equal(advanced(75.9, 5, span), 76);
});

test("a frame that began before playing did moves no time backwards", () => {
    assert.equal(advanced(0, -0.004, { departure: 0, arrival: 60 }), 0);
    assert.equal(advanced(7, -0.004, { departure: 10, arrival: 60 }), 7);
});

test("another departure leaves the robot at the same share of its way", () => {
    const playback = new Playback(() => {});
    playback.span = { departure: 10, arrival: 30 };
    playback.time = 15;
    playback.setSpan({ departure: 20, arrival: 60 });
    assert.equal(playback.time, 30);
    playback.time = 10;
    playback.setSpan({ departure: 40, arrival: 60 });
    assert.equal(playback.time, 20, "and at the same share of its waiting");
});

test("samples come from coarse to fine, each once", () => {
    const order = refinedOrder(33, 8);
    assert.deepEqual(order.slice(0, 5), [0, 8, 16, 24, 32]);
    assert.deepEqual([...order].sort((a, b) => a - b), Array.from({ length: 33 }, (_, i) => i));
});

test("a sampler that has no time still takes one sample a turn, and ends with all in order", () => {
    let calls = 0;
    const sampler = new Sampler({ samples: (times) => { calls++; return times.map((t) => t + 20); } }, 64);
    sampler.run(0);
    assert.ok(calls >= 1 && !sampler.finished);
    while (!sampler.finished) sampler.run(0);
    const { times, arrivals } = sampler.samples;
    assert.equal(times.length, SAMPLES);
    assert.equal(times.at(-1), 64);
    assert.ok(times.every((t, i) => arrivals[i] === t + 20 && (i === 0 || t > times[i - 1])));
});

test("a horizon is a round number that is not below what is asked", () => {
    for (const x of [0.37, 1, 7, 99.5, 101, 27.4857]) {
        const up = roundUp(x);
        assert.ok(up >= x && up <= 1.51 * x, `${x}: ${up}`);
        assert.ok(String(Number(up.toPrecision(2))) === String(up), String(up));
    }
    assert.equal(roundUp(0), 1);
});

test("a frame that began before the button was pressed does not run time back, before the beginning", () => {
    const asked = [];
    globalThis.requestAnimationFrame = (act) => asked.push(act);
    try {
        const playback = new Playback(() => {});
        playback.span = { departure: 10, arrival: 30 };
        playback.play({ from: 0 });
        asked[0](performance.now() - 50);
        assert.equal(playback.time, 0);
    } finally {
        delete globalThis.requestAnimationFrame;
    }
});
