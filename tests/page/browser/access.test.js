// SPDX-License-Identifier: MIT
// The page without a mouse, without eyes, and with both.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { ask, choose, modules, openPage, quietly, settled } from "./harness.js";

const axe = readFileSync(modules.resolve("axe-core/axe.min.js"), "utf8");

/** What axe-core finds wrong, in short. */
async function wrongs(page) {
    await page.evaluate(axe);
    const found = await page.evaluate(() => globalThis.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"] }));
    return found.violations.map((one) => `${one.id}: ${one.nodes.map((node) => node.target.join(" ")).join(", ")}`);
}

for (const colorScheme of ["light", "dark"]) {
    test(`axe-core finds nothing wrong, ${colorScheme}`, quietly(async () => {
        const page = await openPage({ options: { colorScheme } });
        await settled(page);
        assert.deepEqual(await wrongs(page), []);
        await page.locator("#numbers summary").click();
        await page.locator("#save-menu summary").click();
        await page.locator("#thing").selectOption("disc 1");
        await page.getByLabel("Arrive by").check();
        await page.evaluate(() => globalThis.tdspPage.problem("A sentence."));
        await settled(page);
        assert.deepEqual(await wrongs(page), []);
        await page.keyboard.press("Escape");
        await page.getByRole("button", { name: "Keys" }).click();
        assert.deepEqual(await wrongs(page), []);
    }));
}

test("every control has a name, and no two visible ones the same", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.locator("#thing").selectOption("disc 0");
    const roles = ["button", "slider", "spinbutton", "checkbox", "radio", "combobox", "textbox", "application", "image", "DisclosureTriangle"];
    const { nodes } = await (await page.context().newCDPSession(page)).send("Accessibility.getFullAXTree");
    const names = nodes.filter((node) => !node.ignored && roles.includes(node.role.value)).map((node) => `${node.role.value} ${node.name?.value ?? ""}`);
    assert.deepEqual(names.filter((name) => name.endsWith(" ")), []);
    assert.deepEqual(names.filter((name, i) => names.indexOf(name) !== i), []);
    assert.ok(names.length > 30, String(names.length));
}));

/** Press Tab until this has the focus. */
async function tabTo(page, id) {
    for (let i = 0; i < 80; i++) {
        await page.keyboard.press("Tab");
        if (await page.evaluate((wanted) => document.activeElement.id === wanted, id)) return;
    }
    assert.fail(`Tab does not reach #${id}`);
}

test("a journey with the keyboard only: choose, select, move, leave, play, undo, save", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.textContent), "Skip to the scene");
    for (let i = 0; i < 9; i++) await page.keyboard.press("Tab");
    while ((await page.evaluate(() => document.activeElement.textContent)) !== "Faster than you") await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    await settled(page);
    await tabTo(page, "scene-box");
    await page.keyboard.press("d");
    await page.keyboard.press("n");
    assert.deepEqual(await ask(page, (p) => p.store.state.selected), { what: "disc", index: 0 });
    const before = await ask(page, (p) => p.store.state.edit.scene.discs[0].center[1]);
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Shift+ArrowUp");
    const [after, pixel] = await ask(page, (p) => [p.store.state.edit.scene.discs[0].center[1], p.scene.pixel]);
    assert.ok(Math.abs((after - before) / pixel - 11) < 1e-6, `${(after - before) / pixel} pixels`);
    await settled(page);
    await page.keyboard.press("j");
    assert.equal(await ask(page, (p) => p.store.state.departure === p.answers.found.jumps[0].departure), true);
    await page.keyboard.press("j");
    assert.equal(await ask(page, (p) => p.store.state.departure > p.answers.found.jumps[0].departure), true);
    await page.keyboard.press("[");
    await page.keyboard.press("Space");
    assert.equal(await ask(page, (p) => p.playback.playing), true);
    await page.keyboard.press("Space");
    assert.equal(await ask(page, (p) => p.playback.playing), false);
    const scale = await ask(page, (p) => p.scene.state.projection.scale);
    await page.keyboard.press("+");
    await page.waitForFunction((old) => globalThis.tdspPage.scene.state.projection.scale > old, scale);
    await page.keyboard.press("0");
    await page.keyboard.press("Control+z");
    assert.equal(await ask(page, (p) => p.store.state.edit.scene.discs[0].center[1]), before);
    await page.keyboard.press("Control+Shift+z");
    assert.equal(await ask(page, (p) => p.store.state.edit.scene.discs[0].center[1]), after);
    await page.keyboard.press("?");
    assert.ok(await page.getByRole("dialog").isVisible());
    await page.keyboard.press("Escape");
    assert.ok(await page.getByRole("dialog").isHidden());
    await settled(page);
    await page.locator("#save-menu summary").focus();
    await page.keyboard.press("Enter");
    await page.keyboard.press("Tab");
    const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Enter")]);
    assert.equal(download.suggestedFilename(), "faster.json");
}));

test("keys that are typed into a field are not taken from it", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.locator("#thing").selectOption("disc 0");
    await page.locator("#thing-growth").fill("");
    await page.locator("#thing-growth").pressSequentially("[0.1, 0]");
    assert.equal(await page.locator("#thing-growth").inputValue(), "[0.1, 0]");
    assert.equal(await ask(page, (p) => p.store.state.departure), 9.8);
}));

test("what is focused is seen", quietly(async () => {
    const page = await openPage();
    for (let i = 0; i < 30; i++) {
        await page.keyboard.press("Tab");
        const [seen, what] = await page.evaluate(() => {
            const at = document.activeElement;
            const ring = (node) => getComputedStyle(node).outlineStyle !== "none" && parseFloat(getComputedStyle(node).outlineWidth) >= 2;
            return [ring(at) || (at.nextElementSibling !== null && ring(at.nextElementSibling)), at.outerHTML.slice(0, 90)];
        });
        assert.ok(seen, what);
    }
}));

test("after a change the picture is said in words, once all is quiet", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.getByLabel("Departure", { exact: true }).fill("5");
    await page.keyboard.press("Tab");
    await page.waitForFunction(() => document.getElementById("live").textContent.includes("Leaving at\u00a05") || document.getElementById("live").textContent.startsWith("Leaving at 5"), null, { timeout: 5000 });
    assert.equal(await page.locator("#live").getAttribute("aria-live"), "polite");
    assert.match(await page.locator("#scene").getAttribute("aria-label"), /^The gap that closes at .*: 2 discs, a path of 1 leg, straight\.$/);
    assert.match(await page.locator("#curve").getAttribute("aria-label"), /^Travel time over departure, until .*: 1 jump, the largest by/);
}));

test("the same in numbers: legs, jumps and rows as tables", quietly(async () => {
    const page = await openPage();
    await choose(page, "Fires in Oregon");
    await page.locator("#numbers summary").click();
    await page.waitForFunction(() => document.querySelectorAll("#numbers table").length === 3);
    const rows = async (name) => page.getByRole("table", { name }).locator("tbody tr").count();
    assert.deepEqual([await rows(/^Jumps/), await rows(/^Rows of the table/)], [3, 19]);
    assert.equal(await rows(/^The way/), await ask(page, (p) => p.answers.found.path.legs.length));
}));
