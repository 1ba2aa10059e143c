// SPDX-License-Identifier: MIT
// What a frame costs the page's main thread: the processor time of its script (planning, telling, drawing), style and layout. Processor time, for a clock on the
// wall measures how busy the machine is. Not in it is what the browser does with the drawing, which here it does without a graphics card, and what workers do.
import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { ask, openPage, quietly, scratch, settled, tdsp } from "./harness.js";

const BUDGET = 16; // milliseconds
const FRAMES = 110;
const WARM = 10; // frames before, in which the browser compiles

function report(what, times) {
    const sorted = times.slice(WARM).sort((a, b) => a - b);
    const [median, p95] = [sorted[sorted.length >> 1], sorted[Math.floor(sorted.length * 0.95)]];
    console.log(`measured ${what}: median ${median.toFixed(1)} ms, p95 ${p95.toFixed(1)} ms of processor time a frame, ${sorted.length} frames`);
    assert.ok(median <= BUDGET, `${what}: median ${median} ms`);
}

/** The cost of frames, in each of which `act(page, i)` is done. */
async function framesOf(page, act) {
    const session = await page.context().newCDPSession(page);
    await session.send("Performance.enable", { timeDomain: "threadTicks" });
    const parts = ["ScriptDuration", "LayoutDuration", "RecalcStyleDuration"];
    const cpu = async () => 1000 * (await session.send("Performance.getMetrics")).metrics.reduce((sum, { name, value }) => sum + (parts.includes(name) ? value : 0), 0);
    const run = await page.evaluateHandle((source) => {
        const body = new Function("p", "i", `(${source})(p, i)`);
        return async (i) => {
            body(globalThis.tdspPage, i);
            for (let k = 0; k < 2; k++) await new Promise((done) => requestAnimationFrame(done));
        };
    }, act.toString());
    const times = [];
    for (let i = 0; i < WARM + FRAMES; i++) {
        const before = await cpu();
        await run.evaluate((frame, index) => frame(index), i);
        times.push((await cpu()) - before);
    }
    return times;
}

async function crowd(n, first = () => {}) {
    const file = join(scratch, `crowd-${n}.json`);
    tdsp("generate", "crowd", "--n", String(n), "--seed", "4", "-o", file);
    const page = await openPage();
    await settled(page);
    await page.evaluate(first);
    await page.locator("#file").setInputFiles(file);
    await page.waitForFunction((count) => globalThis.tdspPage.answers.scene?.count === count, n);
    return page;
}

test("2,000 discs play at 60 frames a second", quietly(async () => {
    const page = await crowd(2000, () => {
        const never = () => new Promise(() => {});
        globalThis.tdspPage.answers.remote = { last: never, jumps: never, build: never }; // workers are other threads, and would take a minute
    });
    await page.waitForFunction(() => globalThis.tdspPage.answers.sampled, null, { timeout: 120000 });
    report("playing 2,000 discs", await framesOf(page, (p, i) => p.playback.seek((p.playback.span.arrival * i) / 120)));
}));

test("300 discs: the way is planned anew in every frame while an end is dragged", quietly(async () => {
    const page = await crowd(300);
    await settled(page);
    report("dragging the source among 300 discs", await framesOf(page, (p, i) => p.store.dispatch({ type: "place", thing: { what: "source", index: -1 }, place: [3.7 - 0.02 * i, 5.5 - 0.01 * i], gesture: 1 })));
    report("dragging the destination among 300 discs", await framesOf(page, (p, i) => p.store.dispatch({ type: "place", thing: { what: "destination", index: -1 }, place: [97.4 + 0.02 * i, 96], gesture: 2 })));
}));

test("300 discs: and while a disc is dragged, which prepares the scene anew", quietly(async () => {
    const page = await crowd(300);
    await settled(page);
    report("dragging one of 300 discs", await framesOf(page, (p, i) => p.store.dispatch({ type: "place", thing: { what: "disc", index: 9 }, place: [50 + 0.1 * i, 50], gesture: 3 })));
    await settled(page);
    assert.equal(await ask(page, (p) => p.answers.found.path.status), "ok");
}));
