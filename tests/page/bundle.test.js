// SPDX-License-Identifier: MIT
/** One file holds the page; the long questions are asked on workers made from what it carries. In browsers that is tried by tests/page/browser. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { Worker } from "node:worker_threads";
import { gunzipSync } from "node:zlib";
import { remoteCore } from "../../tools/page/js/remote.js";
import { newCore, read, root, scratchDirectory, wasm, wasmFile } from "./support.js";

const directory = scratchDirectory();
const twoDiscs = read("examples/scenes/two-discs.json");
const START = '<script type="module" src="js/app.js"></script>';
const PAGE = `<!doctype html><link rel="stylesheet" href="page.css"><script type="importmap">{"imports": {"tdsp/": "./js/"}}</script>${START}`;

/** Make a page of these files and bundle it. @param {string} name @param {Record<string, string>} files */
function bundle(name, files) {
    const page = join(directory, name);
    mkdirSync(join(page, "gallery"), { recursive: true });
    cpSync(join(root, "tools/page/js"), join(page, "js"), { recursive: true });
    const own = { "index.html": PAGE, "page.css": "p { color: red }\n", "gallery/gallery.json": '[{"id": "a", "scene": "examples/scenes/two-discs.json"}]', "js/app.js": 'import { remoteCore } from "tdsp/remote.js";\n' };
    for (const [file, text] of Object.entries({ ...own, ...files })) writeFileSync(join(page, file), text);
    const { status, stderr } = spawnSync("python3", [join(root, "tools/page/inline.py"), page, wasmFile, join(page, "out.html")], { encoding: "utf8" });
    return { status, stderr, html: status === 0 ? readFileSync(join(page, "out.html"), "utf8") : "" };
}

/** @param {string} html @param {string} id */
const element = (html, id) => new RegExp(`<script type="[^"]*" id="${id}">([^]*?)</script>`).exec(html)[1];

const { html, stderr } = bundle("page", {});
assert.ok(html, stderr);

test("a page holds its modules, styles, the module of WebAssembly and the gallery", () => {
    const { imports } = JSON.parse(/<script type="importmap">([^]*?)<\/script>/.exec(html)[1]);
    assert.ok(imports["tdsp/remote.js"].startsWith("data:text/javascript;base64,"));
    const text = (name) => Buffer.from(imports[`tdsp/${name}`].split(",")[1], "base64").toString();
    assert.match(text("remote.js"), /from "tdsp\/core.js"/);
    assert.match(text("inlined.js"), /inlined-wasm/); // the version that reads the page
    assert.ok(!("tdsp/worker.js" in imports), "only what the page reaches");
    assert.match(html, /<style>\np \{ color: red \}/);
    assert.deepEqual(gunzipSync(Buffer.from(element(html, "inlined-wasm"), "base64")), wasm);
    assert.deepEqual(JSON.parse(element(html, "inlined-gallery")), [{ id: "a", scene: twoDiscs }]);
});

test("what cannot be taken inside is refused by its name", () => {
    const cases = {
        "a module that is not there": [{ "js/app.js": 'import "tdsp/nowhere.js";\n' }, /app.js imports nowhere.js/],
        "a picture from elsewhere": [{ "index.html": `${PAGE}<img alt="" src="a.png">` }, /<img alt="" src="a.png"> is not inside/],
        "a page without its script": [{ "index.html": PAGE.replace(START, "") }, /0 of module script/],
        "a gallery whose scene is not there": [{ "gallery/gallery.json": '[{"scene": "examples/nothing.json"}]' }, /nothing.json/],
        "a worker with two things of one name": [{ "js/job.js": "export const LEG_NUMBERS = 1;\nexport function runJob() {}\n" }, /LEG_NUMBERS/],
    };
    for (const [name, [files, reason]] of Object.entries(cases)) {
        const { status, stderr } = bundle(name, files);
        assert.notEqual(status, 0, name);
        assert.match(stderr, reason, name);
    }
});

/** A browser's worker from text, on one of node's. */
class TextWorker {
    static started = 0;
    onmessage = (_event) => {};
    onerror = (_event) => {};
    #worker;

    constructor() {
        TextWorker.started++;
        const head = 'const { parentPort } = require("node:worker_threads"); const postMessage = (m) => parentPort.postMessage(m);\n'
            + 'const addEventListener = (_, take) => parentPort.on("message", (data) => take({ data }));\n';
        this.#worker = new Worker(head + element(html, "inlined-worker"), { eval: true });
        this.#worker.on("message", (data) => this.onmessage({ data }));
        this.#worker.on("error", (error) => this.onerror({ message: error.message }));
    }

    postMessage(message) {
        this.#worker.postMessage(message);
    }

    terminate() {
        this.#worker.terminate();
    }
}

const bytes = new Uint8Array(wasm).buffer;
const remote = await remoteCore({ wasm: bytes, start: () => new TextWorker() });
const core = await newCore(), scene = core.scene(twoDiscs);

test("the long questions have the same answers on a worker", async () => {
    const told = [];
    const [table, jumps, curve, last] = await Promise.all([
        remote.build(twoDiscs, { epsilon: 0.02, progress: (settled, all) => void told.push([settled, all]) }),
        remote.jumps(twoDiscs, { until: 50 }),
        remote.curve(twoDiscs),
        remote.last(twoDiscs),
    ]);
    assert.deepEqual(table, scene.build({ epsilon: 0.02 }));
    assert.deepEqual(jumps, scene.jumps({ until: 50 }));
    const { evaluate, ...wanted } = scene.curve();
    assert.deepEqual(curve, wanted);
    assert.deepEqual(last, scene.last());
    assert.ok(told.length > 0);
    assert.ok(TextWorker.started <= 2);
});

test("what is wrong comes back as it was thrown", async () => {
    await assert.rejects(remote.build({ ...twoDiscs, robot: { speed: -1 } }), { name: "CoreError", status: "bad_scene", where: "robot.speed", message: "robot.speed: must be greater than zero" });
    await assert.rejects(remote.build(twoDiscs, { epsilon: 7 }), { status: "invalid_argument", where: "epsilon" });
});

const slow = { epsilon: 1e-7 };

test("a signal or progress calls the work off, and the next is done all the same", async () => {
    for (const way of ["signal", "progress"]) {
        const control = new AbortController(), begin = performance.now();
        if (way === "signal") setTimeout(() => control.abort(), 50);
        await assert.rejects(remote.build(twoDiscs, { ...slow, signal: control.signal, progress: () => way === "progress" }), { status: "cancelled" });
        assert.ok(performance.now() - begin < 5000);
    }
    await assert.rejects(remote.build(twoDiscs, { signal: AbortSignal.abort() }), { status: "cancelled" });
    assert.equal((await remote.last(twoDiscs)).reason, "destination_covered");
});

test("work that waits can be called off before it begins", async () => {
    const controls = [1, 2, 3, 4].map(() => new AbortController());
    const works = controls.map(({ signal }) => remote.build(twoDiscs, { ...slow, signal }));
    const outcomes = Promise.allSettled(works);
    for (const control of controls.reverse()) control.abort();
    assert.deepEqual((await outcomes).map(({ reason }) => reason.status), ["cancelled", "cancelled", "cancelled", "cancelled"]);
    assert.equal((await remote.jumps(twoDiscs)).length, 1);
});

test("without workers the work is done where the page is", async () => {
    const here = await remoteCore({ wasm: bytes, start: () => { throw new Error("no workers"); } });
    assert.deepEqual(await here.build(twoDiscs), scene.build());
    await assert.rejects(here.build({}), { status: "bad_scene" });
    const dying = await remoteCore({ wasm: bytes, start: () => { const worker = { onerror: (_) => {}, postMessage: (m) => void (m.id && setTimeout(() => worker.onerror({}), 1)), terminate() {}, onmessage: null }; return worker; } });
    assert.deepEqual(await dying.last(twoDiscs), scene.last());
});

test("closing calls off all work and ends the workers", async () => {
    const works = [1, 2, 3].map(() => remote.build(twoDiscs, slow));
    const outcomes = Promise.allSettled(works);
    remote.close(); // a worker left over would keep this program from ending
    assert.deepEqual((await outcomes).map(({ reason }) => reason.status), ["cancelled", "cancelled", "cancelled"]);
});
