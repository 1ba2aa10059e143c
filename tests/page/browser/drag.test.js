// SPDX-License-Identifier: MIT
// Hands on the scene and the curve: what is dragged is where it was dragged to, and everything shown is about it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { ask, choose, dragInScene, onScreen, openPage, quietly, settled } from "./harness.js";

const close = (a, b, by, what) => assert.ok(Math.abs(a - b) <= by, `${what}: ${a}, not ${b}`);
/** Does what is shown agree with a core that is asked anew? The last departure may be computed later, the way may not. */
async function agrees(page, what = "all") {
    const [arrival, last] = await ask(page, (p) => {
        const scene = p.core.scene(p.answers.scene.description);
        // A scene whose ends moved is measured from where it was prepared: its last bits are others.
        const near = (a, b) => Math.abs(a - b) <= 1e-9 * Math.abs(a);
        const same = [near(scene.path(p.store.state.departure).arrival, p.answers.found.path.arrival), near(scene.last().departure, p.answers.found.last.departure)];
        scene.free();
        return same;
    });
    return arrival && (what === "arrival" || last);
}

test("an end that is dragged is where it was dropped, with the way there", quietly(async () => {
    const page = await openPage();
    await settled(page);
    for (const [what, from, to] of [["source", [-10, 0], [-8, -2]], ["destination", [10, 0], [9, 3]]]) {
        await dragInScene(page, from, to);
        await settled(page);
        const place = await page.evaluate((name) => globalThis.tdspPage.store.state.edit.scene[name], what);
        close(place[0], to[0], 0.05, what);
        close(place[1], to[1], 0.05, what);
        assert.equal((await ask(page, (p) => p.store.state.selected)).what, what);
    }
    assert.ok(await agrees(page));
    assert.equal(await ask(page, (p) => p.store.state.past.length), 2, "a drag is undone as one");
}));

test("a disc that is dragged moves, and so does its jump", quietly(async () => {
    const page = await openPage();
    await settled(page);
    const before = await ask(page, (p) => p.answers.found.jumps[0].departure);
    await dragInScene(page, [0, 3], [0, 4]);
    await settled(page);
    assert.ok((await ask(page, (p) => p.answers.found.jumps[0].departure)) > before + 3);
    assert.ok(await agrees(page));
    await page.keyboard.press("Control+z");
    await settled(page);
    assert.equal(await ask(page, (p) => p.answers.found.jumps[0].departure), before);
}));

test("a disc's rim that is dragged changes its radius", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.mouse.click(...(await onScreen(page, [0, 3])));
    const { time } = await ask(page, (p) => ({ time: p.playback.time }));
    const radius = 1 + 0.1 * time;
    await dragInScene(page, [0, 3 + radius], [0, 3 + radius - 0.5]);
    close(await ask(page, (p) => p.store.state.edit.scene.discs[0].radius), 0.5, 0.08, "radius");
}));

test("while a disc is dragged the way follows in every frame", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.mouse.move(...(await onScreen(page, [0, 3])));
    await page.mouse.down();
    const seen = new Set();
    for (const y of [2.6, 2.2, 1.8, 1.4, 1]) {
        await page.mouse.move(...(await onScreen(page, [0, y])));
        seen.add(await ask(page, (p) => p.answers.found.path.arrival));
        assert.ok(await agrees(page, "arrival"), String(y));
    }
    await page.mouse.up();
    assert.ok(seen.size >= 3, String([...seen]));
}));

test("a scene that replaces one whose curve is still being sampled ends that", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.evaluate(async () => {
        const { tdspPage: p } = globalThis;
        p.answers.remote = { last: () => new Promise(() => {}), jumps: () => new Promise(() => {}), build: () => new Promise(() => {}) };
        p.core.scene = ((make) => (description) => {
            const scene = make.call(p.core, description);
            const slowly = (name) => { const quick = scene[name].bind(scene); scene[name] = (...given) => { const end = performance.now() + 10; while (performance.now() < end); return quick(...given); }; };
            slowly("last");
            slowly("samples");
            return scene;
        })(p.core.scene);
        for (let i = 0; i < 6; i++) {
            p.store.dispatch({ type: "disc", index: 0, change: { radius: 1 - 0.01 * i } });
            for (let k = 0; k < 3; k++) await new Promise((done) => requestAnimationFrame(done));
        }
    });
}));

test("the slider of the curve moves the departure, and snaps to the last moment", quietly(async () => {
    const page = await openPage();
    await settled(page);
    const box = await page.locator("#curve").boundingBox();
    const x = (t) => page.evaluate((time) => { const { frame } = globalThis.tdspPage.curve.arrangement; return frame.left + ((time - frame.xLow) / (frame.xHigh - frame.xLow)) * frame.width; }, t);
    const y = await ask(page, (p) => p.curve.arrangement.frame.top + 60);
    await page.mouse.move(box.x + (await x(9.8)), box.y + y);
    await page.mouse.down();
    await page.mouse.move(box.x + (await x(40)), box.y + y, { steps: 5 });
    close(await ask(page, (p) => p.store.state.departure), 40, 0.3, "departure");
    await page.mouse.move(box.x + (await x(9.9)), box.y + y, { steps: 5 });
    await page.mouse.up();
    assert.equal(await ask(page, (p) => p.store.state.departure === p.answers.found.jumps[0].departure), true);
}));

test("pointing at an instant shows the way of that departure, as a ghost", quietly(async () => {
    const page = await openPage();
    await settled(page);
    const box = await page.locator("#curve").boundingBox();
    await page.mouse.move(box.x + box.width * 0.6, box.y + 80);
    await page.waitForFunction(() => globalThis.tdspPage.scene.state.ghost.length > 0);
    await page.mouse.move(box.x + box.width / 2, box.y - 40);
    await page.waitForFunction(() => globalThis.tdspPage.scene.state.ghost.length === 0);
}));

test("of two jumps that are near each other the pointer takes the nearer one", quietly(async () => {
    const page = await openPage();
    await choose(page, "A crowd of 300");
    const box = await page.locator("#curve").boundingBox();
    const [x, y] = await ask(page, (p) => {
        const { frame } = p.curve.arrangement, jump = p.answers.found.jumps.at(-1);
        return [frame.left + ((jump.departure - frame.xLow) / (frame.xHigh - frame.xLow)) * frame.width, frame.top + 30];
    });
    await page.mouse.move(box.x + x + 1, box.y + y);
    await page.waitForFunction(() => globalThis.tdspPage.curve.state.hover !== null);
    assert.equal(await ask(page, (p) => p.curve.state.hover), await ask(page, (p) => p.answers.found.jumps.at(-1).departure));
    assert.ok(await ask(page, (p) => Math.abs(p.answers.found.jumps.at(-2).departure - p.curve.state.hover)) < 2);
}));

test("bends are marked where they can be found, and go with the scene that had them", quietly(async () => {
    const page = await openPage();
    await choose(page, "Many bends");
    await page.waitForFunction(() => globalThis.tdspPage.curve.state.bends.length > 0);
    assert.deepEqual(await ask(page, (p) => [p.answers.found.bends.length, p.answers.found.jumps.length]), [13, 4]);
    assert.ok(await ask(page, (p) => p.curve.state.window.yHigh < 489), "the last jump presses the others flat");
    await choose(page, "A crowd of 300");
    assert.deepEqual(await ask(page, (p) => [p.answers.found.bends.length, p.curve.state.bends.length]), [0, 0]);
}));

test("where jumps cannot be found that is said beside the curve, which is then not called exact", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.evaluate(() => {
        const { answers, store } = globalThis.tdspPage;
        globalThis.kept = { jumps: answers.remote.jumps, curve: answers.remote.curve };
        answers.remote.curve = () => new Promise(() => {}); // its pieces would tell them all the same
        answers.remote.jumps = () => Promise.reject(Object.assign(new Error("there is no memory left"), { status: "no_memory" }));
        store.dispatch({ type: "disc", index: 0, change: { radius: 0.9 } });
    });
    await settled(page);
    assert.equal(await page.textContent("#curve-problem"), "Where the curve jumps could not be found: there is no memory left.");
    assert.ok(await page.locator("#curve-problem").isVisible());
    assert.equal(await ask(page, (p) => p.curve.state.sampled), true);
    await page.evaluate(() => {
        const { answers, store } = globalThis.tdspPage;
        Object.assign(answers.remote, globalThis.kept);
        store.dispatch({ type: "undo" });
    });
    await settled(page);
    assert.ok(await page.locator("#curve-problem").isHidden());
    assert.equal(await ask(page, (p) => p.answers.found.jumps.length), 1);
}));

test("a deadline gives the latest departure", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.getByLabel("Arrive by").check();
    await page.getByLabel("Deadline, in numbers").fill("31");
    await page.keyboard.press("Tab");
    const latest = await ask(page, (p) => p.answers.found.latest.departure);
    assert.equal(latest, await ask(page, (p) => p.answers.found.jumps[0].departure));
    assert.equal(await ask(page, (p) => p.answers.found.latestPath.departure), latest);
    await page.waitForFunction(() => globalThis.tdspPage.scene.state.ghost.length === 1);
    assert.match((await page.textContent("#words")).replaceAll("\u00a0", " "), /To arrive by 31 s, leave at 9\.8496 s at the latest\./);
}));

test("the robot's speed and the growth of all discs change the scene, and reset brings it back", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.getByLabel("Robot's speed").fill("2");
    await page.keyboard.press("Tab");
    await page.getByLabel("Growth multiplier").fill("0");
    await page.keyboard.press("Tab");
    await settled(page);
    assert.equal(await ask(page, (p) => p.answers.found.path.arrival - p.store.state.departure), 10);
    assert.match((await page.textContent("#words")), /Nothing ever closes the way/);
    await page.getByRole("button", { name: "Reset" }).click();
    await settled(page);
    assert.equal(await ask(page, (p) => p.answers.found.jumps.length), 1);
}));

test("a disc is added, given numbers, and removed", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.getByRole("button", { name: "Add a disc" }).click();
    for (const [label, value] of [["x", "-4"], ["y", "0"], ["Radius", "1.5"], ["Growth", "[0.1, 0.001]"]]) {
        await page.locator("#selected-panel").getByLabel(label, { exact: true }).fill(value);
        await page.keyboard.press("Tab");
    }
    await settled(page);
    assert.deepEqual(await ask(page, (p) => p.store.state.edit.scene.discs[2]), { center: [-4, 0], radius: 1.5, growth: [0.1, 0.001] });
    assert.ok(await agrees(page));
    await page.getByRole("button", { name: "Remove" }).click();
    assert.equal(await ask(page, (p) => p.store.state.edit.scene.discs.length), 2);
}));

test("a number that is none is said beside the field, and nothing changes", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.locator("#thing").selectOption("disc 0");
    await page.locator("#thing-radius").fill("-1");
    await page.keyboard.press("Tab");
    assert.equal(await page.textContent("#thing-problem"), "discs[0].radius: must not be negative.");
    await page.locator("#thing-growth").fill("fast");
    await page.keyboard.press("Tab");
    assert.match(await page.textContent("#thing-problem"), /^A growth is a rate such as 0\.3/);
    assert.equal(await page.locator("#thing-problem").getAttribute("role"), "alert");
    assert.equal(await ask(page, (p) => p.store.state.past.length), 0);
}));

test("the wheel zooms, dragging the ground pans, the button shows all again", quietly(async () => {
    const page = await openPage();
    await choose(page, "Fires in Oregon");
    const scale = () => ask(page, (p) => p.scene.state.projection.scale);
    const first = await scale();
    const box = await page.locator("#scene").boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + 60);
    await page.mouse.wheel(0, -300);
    await page.waitForFunction((before) => globalThis.tdspPage.scene.state.projection.scale > before, first);
    await page.getByRole("button", { name: "Show all" }).click();
    await page.waitForFunction((before) => Math.abs(globalThis.tdspPage.scene.state.projection.scale / before - 1) < 1e-6, first);
}));

/** Fingers as the system sends them. */
async function fingersOn(page) {
    const session = await page.context().newCDPSession(page);
    return (type, ...points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
}

const phone = { hasTouch: true, isMobile: true, viewport: { width: 375, height: 667 } };

test("a finger drags an end on a touch screen", quietly(async () => {
    const page = await openPage({ options: phone });
    await settled(page);
    await page.locator("#scene").scrollIntoViewIfNeeded();
    const touch = await fingersOn(page), [x, y] = await onScreen(page, [-10, 0]);
    await touch("touchStart", [x, y]);
    for (let i = 1; i <= 5; i++) await touch("touchMove", [x + 6 * i, y - 6 * i]);
    await touch("touchEnd");
    const source = await ask(page, (p) => p.store.state.edit.scene.source);
    assert.ok(source[0] > -10 && source[1] > 0, String(source));
}));

test("two fingers zoom in on what is between them, and the page stays where it is", quietly(async () => {
    const page = await openPage({ options: phone });
    await settled(page);
    await page.locator("#scene").scrollIntoViewIfNeeded();
    const touch = await fingersOn(page), [x, y] = await onScreen(page, [0, 3]), scrolled = await page.evaluate(() => scrollY);
    const scale = await ask(page, (p) => p.scene.state.projection.scale);
    await touch("touchStart", [x - 20, y], [x + 20, y]);
    for (let i = 1; i <= 8; i++) await touch("touchMove", [x - 20 - 5 * i, y], [x + 20 + 5 * i, y]);
    await touch("touchEnd");
    const now = await ask(page, (p) => p.scene.state.projection.scale);
    assert.ok(Math.abs(now / scale - 3) < 0.2, `${now / scale} times`);
    const [nowX, nowY] = await onScreen(page, [0, 3]);
    assert.ok(Math.hypot(nowX - x, nowY - y) < 3, `${nowX - x}, ${nowY - y}`);
    assert.equal(await page.evaluate(() => scrollY), scrolled);
    assert.equal(await ask(page, (p) => p.store.state.past.length), 0, "nothing was moved");
}));

test("a finger on the curve takes the slider along, one that goes up scrolls the page", quietly(async () => {
    const page = await openPage({ options: phone });
    await settled(page);
    await page.locator("#curve").scrollIntoViewIfNeeded();
    const touch = await fingersOn(page), box = await page.locator("#curve").boundingBox(), y = box.y + 60;
    await touch("touchStart", [box.x + 150, y]);
    for (let i = 1; i <= 6; i++) await touch("touchMove", [box.x + 150 + 15 * i, y]);
    await touch("touchEnd");
    assert.ok((await ask(page, (p) => p.store.state.departure)) > 35);
    const scrolled = await page.evaluate(() => scrollY);
    await touch("touchStart", [box.x + 150, y + 60]);
    for (let i = 1; i <= 8; i++) await touch("touchMove", [box.x + 150, y + 60 - 12 * i]);
    await touch("touchEnd");
    await page.waitForFunction((before) => scrollY > before + 20, scrolled);
}));
