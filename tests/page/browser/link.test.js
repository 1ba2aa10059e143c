// SPDX-License-Identifier: MIT
// A link is the whole state: whoever opens it sees the same.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { ask, choose, dragInScene, openPage, quietly, root, scratch, settled, tdsp } from "./harness.js";

const KEPT = ["name", "from", "edit", "departure", "deadline", "mode", "epsilon", "selected"];
/** All of the state that a link carries. */
const state = (page) => page.evaluate((keys) => Object.fromEntries(keys.map((key) => [key, globalThis.tdspPage.store.state[key]])), KEPT);

async function share(page) {
    await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await page.getByRole("button", { name: "Share" }).click();
    await page.waitForFunction(() => document.getElementById("share").textContent === "Copied");
    const copied = await page.evaluate(() => navigator.clipboard.readText());
    assert.equal(copied, page.url());
    return new URL(copied).hash;
}

test("a scene of the gallery as it is: a short link by its name", quietly(async () => {
    const page = await openPage();
    await choose(page, "The closing ring");
    const hash = await share(page);
    assert.equal(hash, "#scene=ring&leave=2");
    const other = await openPage({ hash });
    await settled(other);
    assert.deepEqual(await state(other), await state(page));
    assert.equal(await other.textContent("#scene-title"), "The closing ring");
}));

test("edits, departure, deadline, epsilon, curve and selection come back in another window", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await dragInScene(page, [10, 0], [9, 2]);
    await dragInScene(page, [0, -3], [1, -2.6]);
    await page.getByLabel("Robot's speed").fill("1.3");
    await page.getByLabel("Growth multiplier").fill("0.6");
    await page.getByLabel("Departure", { exact: true }).fill("12.25");
    await page.getByLabel("Arrive by").check();
    await page.getByLabel("Arrival", { exact: true }).check();
    await page.locator("#epsilon").focus();
    await page.keyboard.press("ArrowRight");
    await settled(page);
    const other = await openPage({ hash: await share(page) });
    await settled(other);
    assert.deepEqual(await state(other), await state(page));
    assert.equal(await other.textContent("#words"), await page.textContent("#words"));
}));

test("where and when somebody looks is in the link, on a window of another size too", quietly(async () => {
    const page = await openPage();
    await choose(page, "Fires in Oregon");
    const box = await page.locator("#scene").boundingBox();
    await page.mouse.move(box.x + box.width / 3, box.y + box.height / 2);
    for (let i = 0; i < 4; i++) await page.mouse.wheel(0, -300);
    await page.evaluate(() => globalThis.tdspPage.playback.seek(3000));
    const looked = (p) => p.scene.window;
    await page.waitForFunction(() => globalThis.tdspPage.scene.window !== null);
    const seen = await ask(page, looked);
    const other = await openPage({ hash: await share(page), options: { viewport: { width: 700, height: 900 } } });
    await settled(other);
    assert.equal(await ask(other, (p) => p.playback.time), 3000);
    const back = await ask(other, looked);
    for (const key of ["x", "y", "width"]) assert.ok(Math.abs(back[key] - seen[key]) < 1e-6 * seen.width, `${key}: ${back[key]}, not ${seen[key]}`);
}));

test("a scene and a table of one's own are in the link", quietly(async () => {
    const file = join(scratch, "own.json");
    tdsp("generate", "crowd", "--n", "60", "--seed", "3", "-o", file);
    const table = join(scratch, "own.tdsp");
    tdsp("build", join(root, "examples/scenes/two-discs.json"), "-o", table);
    for (const path of [file, table]) {
        const page = await openPage();
        await page.locator("#file").setInputFiles(path);
        await page.waitForFunction(() => globalThis.tdspPage.store.state.name === "own");
        const other = await openPage({ hash: await share(page) });
        assert.deepEqual(await state(other), await state(page));
        if (path === table) assert.deepEqual(Buffer.from(await ask(other, (p) => [...p.store.state.bytes])), readFileSync(table));
    }
}));

test("a link that is pasted into an open page is followed", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.evaluate(() => { location.hash = "#scene=faster&leave=3"; });
    await page.waitForFunction(() => document.getElementById("scene-title").textContent === "Faster than you");
    assert.equal(await ask(page, (p) => p.store.state.departure), 3);
}));

test("a link from someone else that is broken gives a sentence, and the page is there", quietly(async () => {
    const broken = { "#scene=atlantis": /^The link asks for a scene called "atlantis", which this gallery has not\./, "#scene=two-discs&leave=soon": /^The link is damaged: "soon" is no time to leave\./,
        "#name=x&whole=zAAAA": /^The link is damaged: a part of it is missing/, "#name=x&table=rAAAA": /^The link is damaged/,
        [`#name=x&whole=r${Buffer.from('{"robot":{"speed":-1},"source":[0,0],"destination":[1,0],"discs":[]}').toString("base64url")}`]: /^The link is damaged: robot\.speed: / };
    for (const [hash, sentence] of Object.entries(broken)) {
        const page = await openPage({ hash });
        await settled(page);
        assert.match(await page.textContent("#problem p"), sentence);
        assert.ok(await page.locator("#problem").isVisible(), hash);
        assert.equal(await page.textContent("#scene-title"), "The gap that closes");
    }
}));

test("what the command puts inside is what the page opens", quietly(async () => {
    const scene = JSON.parse(readFileSync(join(root, "examples/scenes/fires-forecast.json"), "utf8"));
    const table = join(scratch, "given.tdsp");
    tdsp("build", join(root, "examples/scenes/two-discs.json"), "-o", table);
    for (const given of [{ name: "dir/mine.json", scene }, { name: "given.tdsp", table: readFileSync(table).toString("base64") }]) {
        const before = `document.addEventListener("DOMContentLoaded", () => { document.getElementById("given").textContent = ${JSON.stringify(JSON.stringify(given))}; })`;
        const page = await openPage({ before });
        assert.equal(await ask(page, (p) => p.store.state.name), given.scene ? "mine" : "given");
        assert.equal(await page.textContent("#scene-title"), given.scene ? "Fires under a wind forecast" : "given");
    }
}));
