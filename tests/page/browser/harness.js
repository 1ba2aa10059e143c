// SPDX-License-Identifier: MIT
// The page in Chromium, driven by playwright-core. Every page that a test opens is watched: a message on its console, an error, or a request that fails is a
// failure of the test, unless the test says that it expects it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { extname, join, normalize, resolve } from "node:path";
import { after, before as beforeAll } from "node:test";
import { pathToFileURL } from "node:url";

export const build = resolve(process.env.PAGE_BUILD ?? "build");
export const root = resolve(import.meta.dirname, "../../..");
/** What npm installed below the build directory. */
export const modules = createRequire(join(build, "page/browser/package.json"));
const { chromium } = modules("playwright-core");

const FLAGS = ["--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--font-render-hinting=none"];
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".json": "application/json", ".wasm": "application/wasm" };

/** @type {import("playwright-core").Browser} */
let browser;
let server;
let opened = [];
export const scratch = mkdtempSync(join(tmpdir(), "tdsp-page-"));

beforeAll(async () => {
    const flags = process.getuid?.() === 0 ? ["--no-sandbox", ...FLAGS] : FLAGS;
    browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: flags });
});

after(async () => {
    await browser?.close();
    server?.close();
    rmSync(scratch, { recursive: true });
});

/** The repository from a web server: where its page is. @returns {Promise<string>} */
export async function served(path = "tools/page/index.html") {
    server ??= await new Promise((done) => {
        const made = createServer((request, response) => {
            const file = join(root, normalize(decodeURIComponent(new URL(request.url, "http://x").pathname)));
            const there = file.startsWith(root) && existsSync(file) && extname(file) in TYPES;
            response.writeHead(there ? 200 : 404, { "content-type": TYPES[extname(file)] ?? "text/plain" });
            response.end(there ? readFileSync(file) : "");
        });
        made.listen(0, "127.0.0.1", () => done(made));
    });
    return `http://127.0.0.1:${server.address().port}/${path}`;
}

/** The page as one file. */
export const bundled = pathToFileURL(join(build, "page/index.html")).href;

/**
 * Open the page. It does not move by itself unless asked to.
 * @param {{hash?: string, url?: string, options?: any, before?: () => void}} [asked] before: runs in the page before its own scripts
 */
export async function openPage({ hash = "", url = bundled, options = {}, before } = {}) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, reducedMotion: "reduce", acceptDownloads: true, ...options });
    const page = await context.newPage();
    const problems = [];
    page.on("console", (message) => { if (["error", "warning", "assert"].includes(message.type())) problems.push(`console: ${message.text()}`); });
    page.on("pageerror", (error) => problems.push(`error: ${error.message}`));
    page.on("requestfailed", (request) => problems.push(`request: ${request.url()} ${request.failure()?.errorText}`));
    opened.push({ context, problems });
    if (before) await page.addInitScript(before);
    await page.goto(url + hash);
    await page.waitForFunction(() => globalThis.tdspPage !== undefined, null, { timeout: 30000 });
    return page;
}

/** A test whose pages must be quiet. @param {() => Promise<void>} body */
export const quietly = (body) => async () => {
    opened = [];
    try {
        await body();
        assert.deepEqual(opened.flatMap((one) => one.problems), []);
    } finally {
        for (const { context } of opened) await context.close();
    }
};

/** Wait until everything about the present scene is computed and drawn. */
export async function settled(page) {
    await page.waitForFunction(() => {
        const { found } = globalThis.tdspPage.answers;
        return found.path && !found.working && !found.stale;
    }, null, { timeout: 60000 });
    await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** Choose a scene of the gallery. */
export async function choose(page, title) {
    await page.getByRole("navigation", { name: "Gallery" }).getByRole("button", { name: title }).click();
    await settled(page);
}

/** What the page knows: plain data only. @param {(page: any) => any} read */
export const ask = (page, read) => page.evaluate(`(${read})(globalThis.tdspPage)`);

/** Where a place of the scene is on the screen. */
export async function onScreen(page, place) {
    const box = await page.locator("#scene").boundingBox();
    const [x, y] = await page.evaluate(([px, py]) => {
        const { projection } = globalThis.tdspPage.scene.state;
        return [projection.x(px), projection.y(py)];
    }, place);
    return [box.x + x, box.y + y];
}

/** Drag with the mouse from one place of the scene to another. */
export async function dragInScene(page, from, to, steps = 6) {
    await page.mouse.move(...(await onScreen(page, from)));
    await page.mouse.down();
    await page.mouse.move(...(await onScreen(page, to)), { steps });
    await page.mouse.up();
}

/** Click what saves, and the file's bytes. @param {() => Promise<void>} click */
export async function saved(page, click) {
    const [download] = await Promise.all([page.waitForEvent("download"), click()]);
    const path = join(scratch, download.suggestedFilename());
    await download.saveAs(path);
    return { name: download.suggestedFilename(), bytes: readFileSync(path), path };
}

/** Save by the menu. @param {string} kind as in data-save */
export async function saveByMenu(page, kind) {
    await page.locator("#save-menu summary").click();
    return saved(page, () => page.locator(`#save-menu [data-save="${kind}"]`).click());
}

/** The command, as it was built. @param {...string} words */
export const tdsp = (...words) => execFileSync(join(build, "tdsp"), words, { encoding: "utf8" });
