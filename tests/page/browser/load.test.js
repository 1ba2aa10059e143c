// SPDX-License-Identifier: MIT
// Opening: from a file, from a server, each scene of the gallery, in any colours and widths.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { ask, bundled, choose, openPage, quietly, root, served, settled } from "./harness.js";

const entries = JSON.parse(readFileSync(join(root, "tools/page/gallery/gallery.json"), "utf8"));
const FIRST = /^Leaving at 9\.8 s you arrive at 29\.8 s, 20 s later\. 0\.0496 s later the gap between discs 0 and 1 closes and the way takes 3\.72 s longer\./;
const words = async (page) => (await page.textContent("#words")).replaceAll("\u00a0", " ");

test("one file opened from the disk shows the first scene, computed", quietly(async () => {
    const page = await openPage();
    assert.ok(bundled.startsWith("file://"));
    await settled(page);
    assert.match(await words(page), FIRST);
    assert.match(await page.textContent("#version"), /^\d+\.\d+\.\d+/);
}));

test("a web server gives the same, from the modules as they are and as one file", quietly(async () => {
    for (const url of [await served(), await served("build/page/index.html")]) {
        const page = await openPage({ url });
        await settled(page);
        assert.match(await words(page), FIRST);
    }
}));

test("workers answer also from a file", quietly(async () => {
    const page = await openPage();
    await settled(page);
    assert.ok(page.workers().length > 0);
    for (const worker of page.workers()) assert.match(worker.url(), /^blob:/);
}));

test("without workers the page answers the same, on its own thread", quietly(async () => {
    const page = await openPage({ before: () => { delete globalThis.Worker; } });
    await choose(page, "Ships off Galveston");
    assert.equal(page.workers().length, 0);
    assert.equal(await ask(page, (p) => p.answers.found.jumps.length), 6);
}));

for (const entry of entries) {
    test(`gallery: ${entry.title}`, quietly(async () => {
        const page = await openPage();
        await choose(page, entry.title);
        const { status, legs, jumps, rows, reason } = await ask(page, ({ answers: { found } }) => ({ status: found.path.status, legs: found.path.legs.length, jumps: found.jumps.length, rows: found.built?.report.rows, reason: found.last.reason }));
        assert.equal(status, "ok");
        assert.ok(legs >= 1 && rows >= 1 && jumps >= 0, `${legs} legs, ${jumps} jumps, ${rows} rows, ${reason}`);
        assert.equal(await page.textContent("#scene-title"), entry.title);
        assert.equal(await page.textContent("#scene-words"), entry.words.join(" "));
        assert.equal(entry.words.length, 2);
        assert.equal(await page.locator('#gallery [aria-current="true"]').textContent(), entry.title);
        assert.equal(await page.locator("#credit").isVisible(), entry.credit !== undefined);
        assert.ok(await page.locator("#problem").isHidden());
    }));
}

test("a phone's width needs no scrolling sideways, in any state", quietly(async () => {
    for (const viewport of [{ width: 390, height: 844 }, { width: 375, height: 667 }, { width: 320, height: 568 }]) {
        const page = await openPage({ options: { viewport } });
        for (const title of ["The gap that closes", "Ships off Galveston"]) {
            await choose(page, title);
            await page.locator("#numbers summary").click();
            await page.keyboard.press("n");
            assert.ok(await page.evaluate((width) => document.documentElement.scrollWidth <= width, viewport.width), `${title}, ${viewport.width}`);
        }
    }
}));

test("dark follows the system, the switch decides, and the choice stays", quietly(async () => {
    const page = await openPage({ options: { colorScheme: "dark" } });
    const paper = () => page.evaluate(() => getComputedStyle(document.body.parentElement).backgroundColor);
    const drawn = () => ask(page, (p) => [p.scene.state.palette.name, p.curve.state.palette.name]);
    assert.equal(await paper(), "rgb(18, 22, 28)");
    assert.deepEqual(await drawn(), ["dark", "dark"]);
    await page.getByRole("button", { name: "Dark colours" }).click();
    assert.equal(await paper(), "rgb(255, 255, 255)");
    assert.deepEqual(await drawn(), ["light", "light"]);
    await page.reload();
    await page.waitForFunction(() => globalThis.tdspPage);
    assert.equal(await paper(), "rgb(255, 255, 255)");
}));

test("it plays by itself once, both sides of the jump, and stops when touched", quietly(async () => {
    const page = await openPage({ options: { reducedMotion: "no-preference" } });
    assert.equal(await ask(page, (p) => p.playback.playing), true);
    await page.waitForFunction(() => globalThis.tdspPage.store.state.departure > 9.85, null, { timeout: 30000 });
    assert.match(await words(page), /earlier you would have slipped through the gap between discs 0 and 1/);
    await page.locator("#pace").selectOption("4");
    await page.waitForFunction(() => !globalThis.tdspPage.playback.playing, null, { timeout: 30000 });
    const arrived = await ask(page, (p) => [p.playback.time, p.playback.span.arrival]);
    assert.equal(arrived[0], arrived[1]);
}));

test("who touches anything stops the story", quietly(async () => {
    const page = await openPage({ options: { reducedMotion: "no-preference" } });
    await page.mouse.click(5, 400);
    await page.evaluate(() => { globalThis.tdspPage.playback.pace = 8; });
    await page.waitForFunction(() => !globalThis.tdspPage.playback.playing, null, { timeout: 30000 });
    await page.waitForTimeout(1500);
    assert.equal(await ask(page, (p) => p.store.state.departure), 9.8);
}));

test("nothing moves by itself for people who asked for less motion", quietly(async () => {
    const page = await openPage();
    await choose(page, "Fires in Oregon");
    const time = await ask(page, (p) => p.playback.time);
    await page.waitForTimeout(400);
    assert.equal(await ask(page, (p) => p.playback.time), time);
    assert.equal(await ask(page, (p) => p.playback.playing), false);
}));
