// SPDX-License-Identifier: MIT
// Both pictures in seven states, held against those recorded in pictures/. Machines have other fonts, so only what is coarser than text counts: both are made so
// small that a cell is CELL pixels wide, and so many cells at most may be of another colour. RECORD=1 records them anew; look at them then.
import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { choose, openPage, quietly, settled, tdsp, root, scratch } from "./harness.js";

const pictures = join(import.meta.dirname, "pictures");
const CELL = 8;
const APART = 40; // of 255 in any colour: a cell of another colour
const SHARE = 0.02; // of the cells that may be

/** A picture of the scene and the curve on one sheet, a pixel a cell, as a data URL. */
const small = (page) => page.evaluate((cell) => {
    const canvases = ["scene", "curve"].map((id) => document.getElementById(id));
    globalThis.tdspPage.scene.draw();
    globalThis.tdspPage.curve.draw();
    const [width, heights] = [88, [64, 34]]; // the same on every machine, whatever the fonts leave for the pictures
    const sheet = Object.assign(document.createElement("canvas"), { width, height: heights[0] + heights[1] });
    const context = sheet.getContext("2d");
    canvases.forEach((canvas, i) => {
        const step = Object.assign(document.createElement("canvas"), { width: width * cell, height: heights[i] * cell });
        step.getContext("2d").drawImage(canvas, 0, 0, step.width, step.height);
        const pixels = step.getContext("2d").getImageData(0, 0, step.width, step.height).data;
        for (let y = 0; y < heights[i]; y++) for (let x = 0; x < width; x++) {
            const sum = [0, 0, 0];
            for (let v = 0; v < cell; v++) for (let u = 0; u < cell; u++) for (let c = 0; c < 3; c++) sum[c] += pixels[4 * ((y * cell + v) * step.width + x * cell + u) + c];
            context.fillStyle = `rgb(${sum.map((value) => Math.round(value / cell ** 2)).join(" ")})`;
            context.fillRect(x, y + (i === 0 ? 0 : heights[0]), 1, 1);
        }
    });
    return sheet.toDataURL("image/png");
}, CELL);

/** The share of cells in which two pictures differ. */
const difference = (page, one, other, apart) => page.evaluate(async ([a, b, least]) => {
    const pixels = async (url) => {
        const image = new Image();
        image.src = url;
        await image.decode();
        const canvas = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height });
        canvas.getContext("2d").drawImage(image, 0, 0);
        return canvas.getContext("2d").getImageData(0, 0, image.width, image.height).data;
    };
    const [left, right] = [await pixels(a), await pixels(b)];
    if (left.length !== right.length) return 1;
    let count = 0;
    for (let i = 0; i < left.length; i += 4) if ([0, 1, 2].some((c) => Math.abs(left[i + c] - right[i + c]) > least)) count++;
    return count / (left.length / 4);
}, [one, other, apart]);

const states = {
    "first": async () => openPage(),
    "fire-dark": async () => {
        const page = await openPage({ options: { colorScheme: "dark" } });
        await choose(page, "Fires in Oregon");
        return page;
    },
    "deadline": async () => {
        const page = await openPage({ hash: "#scene=two-discs&leave=30&deadline=50&show=arrival&selected=disc0" });
        return page;
    },
    "crowd": async () => {
        const page = await openPage();
        await choose(page, "A crowd of 300");
        return page;
    },
    "table": async () => {
        const page = await openPage();
        const file = join(scratch, "fire.tdsp");
        tdsp("build", join(root, "examples/scenes/fire-oregon-c.json"), "-o", file);
        await page.locator("#file").setInputFiles(file);
        await page.waitForFunction(() => globalThis.tdspPage.store.state.bytes !== null);
        return page;
    },
    "many-bends": async () => {
        const page = await openPage();
        await choose(page, "Many bends");
        await page.waitForFunction(() => globalThis.tdspPage.curve.state.bends.length > 0);
        return page;
    },
    "no-way": async () => openPage({ hash: "#scene=faster&leave=14" }),
};

for (const [name, reach] of Object.entries(states)) {
    test(`the pictures of "${name}" are those recorded`, quietly(async () => {
        const page = await reach();
        await settled(page);
        const picture = await small(page);
        const file = join(pictures, `${name}.png`);
        if (process.env.RECORD) {
            mkdirSync(pictures, { recursive: true });
            writeFileSync(file, Buffer.from(picture.split(",")[1], "base64"));
        }
        assert.ok(existsSync(file), `${file} is not recorded`);
        const share = await difference(page, picture, `data:image/png;base64,${readFileSync(file).toString("base64")}`, APART);
        if (share > SHARE) writeFileSync(join(scratch, `../tdsp-page-${name}.png`), Buffer.from(picture.split(",")[1], "base64"));
        assert.ok(share <= SHARE, `${(100 * share).toFixed(1)} % of the cells differ`);
    }));
}

/** A PNG as a data URL. @param {Buffer} bytes */
const asUrl = (bytes) => `data:image/png;base64,${bytes.toString("base64")}`;

/** A picture made so small that a pixel is a cell. */
const shrunk = (page, picture) => page.evaluate(async ([url, cell]) => {
    const image = new Image();
    image.src = url;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), { width: Math.floor(image.width / cell), height: Math.floor(image.height / cell) });
    const context = canvas.getContext("2d");
    context.imageSmoothingQuality = "high";
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    return canvas.toDataURL("image/png");
}, [picture, CELL]);

const SCREEN_SHARE = 0.04; // of the cells of a whole screen, where times that were measured are, and words in other fonts
const shown = { "page": { scene: "fire-oregon-c", leave: 52, colorScheme: "light" }, "page-phone": { scene: "two-discs", leave: 9.8, colorScheme: "dark" } };
for (const [name, { scene, leave, colorScheme }] of Object.entries(shown)) {
    test(`docs/pictures/${name}.png is what the page looks like: else, make pictures`, quietly(async () => {
        const file = readFileSync(join(root, `docs/pictures/${name}.png`));
        const viewport = { width: file.readUInt32BE(16), height: file.readUInt32BE(20) };
        const page = await openPage({ hash: `#scene=${scene}&leave=${leave}`, options: { viewport, colorScheme } });
        await settled(page);
        await page.waitForTimeout(1000); // thumbnails
        const [now, then] = [await shrunk(page, asUrl(await page.screenshot())), await shrunk(page, asUrl(file))];
        const share = await difference(page, now, then, APART);
        assert.ok(share <= SCREEN_SHARE, `${(100 * share).toFixed(1)} % of the cells differ`);
    }));
}
