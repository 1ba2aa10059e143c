// SPDX-License-Identifier: MIT
// Files in and out: tables byte for byte those of the command, scenes that come back as they were, and a sentence for everything that is broken.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { test } from "node:test";
import { ask, choose, dragInScene, openPage, quietly, root, saveByMenu, saved, scratch, settled, tdsp } from "./harness.js";

/** The table that the command makes of a scene file. */
function commandTable(scene, ...options) {
    const file = join(scratch, "command.tdsp");
    tdsp("build", scene, "-o", file, ...options);
    return readFileSync(file);
}

/** Choose a file as a person does. */
async function openWith(page, path) {
    await page.locator("#file").setInputFiles(path);
}

const scenes = [["The gap that closes", "examples/scenes/two-discs.json"], ["Fires in Oregon", "examples/scenes/fire-oregon-c.json"], ["Fires that speed up", "examples/scenes/fires-accelerating.json"],
    ["Under a wind forecast", "examples/scenes/fires-forecast.json"], ["Ships off Galveston", "examples/scenes/ships-galveston-anchorage.json"], ["The closing ring", "tools/page/gallery/ring.json"]];

for (const [title, path] of scenes) {
    test(`the table of "${title}" has the bytes that the command writes`, quietly(async () => {
        const page = await openPage();
        await choose(page, title);
        const { name, bytes } = await saved(page, () => page.getByRole("button", { name: "Save table" }).click());
        assert.match(name, /\.tdsp$/);
        assert.deepEqual(bytes, commandTable(join(root, path)));
    }));
}

test("another epsilon, slid to with the keyboard, has the command's bytes too, and the panel says its size", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await page.locator("#epsilon").focus();
    for (let i = 0; i < 50; i++) await page.keyboard.press("ArrowRight");
    await settled(page);
    const epsilon = await ask(page, (p) => p.store.state.epsilon);
    assert.ok(epsilon > 0.02);
    const { bytes } = await saveByMenu(page, "table");
    assert.deepEqual(bytes, commandTable(join(root, "examples/scenes/two-discs.json"), "--epsilon", String(epsilon)));
    const facts = await page.textContent("#table-facts");
    assert.match(facts, new RegExp(`^\\d+ rows?, ${bytes.length.toLocaleString("en")} bytes from \\d+ searches in `));
}));

test("the command that is copied makes the same bytes, also where departures need a horizon", quietly(async () => {
    const page = await openPage();
    await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await choose(page, "Nothing grows");
    await page.getByRole("button", { name: "Copy command" }).click();
    await page.waitForFunction(() => document.getElementById("copy-command").textContent === "Copied");
    const words = (await page.evaluate(() => navigator.clipboard.readText())).split(" ");
    assert.deepEqual(words.slice(0, 2), ["tdsp", "build"]);
    assert.ok(words.includes("--horizon"));
    const scene = await saveByMenu(page, "scene");
    assert.equal(scene.name, words[2]);
    const table = await saveByMenu(page, "table");
    assert.equal(table.name, words[4]);
    assert.deepEqual(table.bytes, commandTable(scene.path, ...words.slice(5)));
}));

test("a scene that was edited, saved and built by the command gives the page's table", quietly(async () => {
    const page = await openPage();
    await settled(page);
    await dragInScene(page, [-10, 0], [-9, -1]);
    await dragInScene(page, [0, 3], [0.5, 3.4]);
    await page.getByLabel("Growth multiplier").fill("0.7");
    await page.keyboard.press("Tab");
    await settled(page);
    const scene = await saveByMenu(page, "scene");
    const table = await saveByMenu(page, "table");
    assert.deepEqual(table.bytes, commandTable(scene.path));
    assert.match(tdsp("verify", scene.path, table.path), /ok/);
}));

test("a saved table opens again: its curve, its jumps, its ways, and why there are no discs", quietly(async () => {
    const page = await openPage();
    await choose(page, "Fires in Oregon");
    const { path, bytes } = await saveByMenu(page, "table");
    await openWith(page, path);
    await page.waitForFunction(() => globalThis.tdspPage.store.state.bytes !== null);
    await page.getByLabel("Departure", { exact: true }).fill("2200");
    await page.keyboard.press("Tab");
    await page.waitForFunction(() => document.getElementById("words").textContent.includes("2200"));
    const said = (await page.textContent("#words")).replaceAll("\u00a0", " ");
    const [row] = JSON.parse(tdsp("query", path, "2200", "--json")).results;
    assert.match(said, /^Leaving at 2200 s you arrive by [\d.]+ s along the stored path; nothing arrives before [\d.]+ s\./);
    const shown = said.match(/by ([\d.]+) s.*before ([\d.]+) s/).slice(1).map(Number);
    assert.ok(Math.abs(shown[0] - row.upper) < 0.1 && Math.abs(shown[1] - row.lower) < 0.1, String(shown));
    assert.equal(await page.textContent("#scene-words"), "A table holds the ways, not the discs: open its scene (.json) to see them.");
    assert.match(await page.textContent("#table-facts"), /^19 rows, 15\.8 kB, as opened: travel times within 1 %\.$/);
    assert.equal(await page.textContent("#epsilon-value"), "", "the slider's epsilon is not the table's");
    assert.equal(await ask(page, (p) => p.curve.state.jumps.length), 3);
    assert.ok(await page.getByLabel("Growth multiplier").isDisabled());
    assert.deepEqual((await saveByMenu(page, "table")).bytes, bytes);
}));

test("a scene that is dropped on the page is opened", quietly(async () => {
    const page = await openPage();
    await settled(page);
    const text = readFileSync(join(root, "examples/scenes/fires-forecast.json"), "utf8");
    await page.evaluate((content) => {
        const data = new DataTransfer();
        data.items.add(new File([content], "dropped.json"));
        const event = (kind) => new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true });
        document.body.dispatchEvent(event("dragover"));
        if (!document.documentElement.classList.contains("dropping")) throw new Error("nothing shows that it can be dropped");
        document.body.dispatchEvent(event("drop"));
    }, text);
    await page.waitForFunction(() => document.getElementById("scene-title").textContent === "Fires under a wind forecast");
    await settled(page);
    assert.equal(await ask(page, (p) => p.store.state.name), "dropped");
}));

const table = () => commandTable(join(root, "examples/scenes/two-discs.json"));
const disc = '{"center": [0, 3], "radius": 1, "growth": 0.1}';
const head = '{"robot": {"speed": 1},\n "source": [0, 0], "destination": [9, 0],\n';
const broken = {
    "empty.json": ["", "empty.json is empty."],
    "comma.json": [`${head} "discs": [${disc} ${disc}]}`, "comma.json, line 3, column 59: expected a comma or ]."],
    "twice.json": ['{"robot": {"speed": 1, "speed": 2}}', "twice.json, line 1, column 24: duplicate key: speed."],
    "radius.json": [`${head} "discs": [{"center": [0, 3],\n  "radius": -1, "growth": 0.1}]}`, "radius.json, line 4, column 13 (discs[0].radius): must not be negative."],
    "speed.json": [`{"robot": {"speed": 0}, "source": [0, 0], "destination": [1, 0], "discs": []}`, /^speed\.json, line 1, column 21 \(robot\.speed\): /],
    "missing.json": ['{"robot": {"speed": 1}, "source": [0, 0], "discs": []}', "missing.json, line 1, column 1 (destination): missing."],
    "shrinks.json": [`${head} "discs": [{"center": [0, 3], "radius": 1, "growth": -0.1}]}`, /^shrinks\.json, line 3, column \d+ \(discs\[0\]\.growth\): /],
    "huge.json": [`${head} "discs": [{"center": [0, 1e999], "radius": 1, "growth": 0}]}`, /^huge\.json, line 3, column 27: /],
    "text.tdsp": ["hello", "text.tdsp: this is neither JSON nor a table."],
    "cut.tdsp": [() => table().subarray(0, 500), "cut.tdsp: the table is shorter or longer than it says."],
    "flipped.tdsp": [() => table().fill(0x55, 2000, 2008), "flipped.tdsp: the table's bytes were changed."],
};
test("what is broken is a sentence beside it, and what was shown stays", quietly(async () => {
    const page = await openPage();
    await settled(page);
    for (const [name, [content, sentence]] of Object.entries(broken)) {
        writeFileSync(join(scratch, name), typeof content === "function" ? content() : content);
        await openWith(page, join(scratch, name));
        await page.waitForFunction((file) => document.querySelector("#problem p").textContent.startsWith(file), name);
        const said = await page.textContent("#problem p");
        if (typeof sentence === "string") assert.equal(said, sentence);
        else assert.match(said, sentence);
        assert.equal(await page.locator("#problem").getAttribute("role"), "alert");
        assert.equal(await page.textContent("#scene-title"), "The gap that closes", basename(name));
    }
    await page.locator("#problem button").click();
    assert.ok(await page.locator("#problem").isHidden());
}));

/** Do the answers have the shape that docs/schema says? By Python's jsonschema, which is what holds the command to it too. */
function checkSchemas(answers) {
    const program = `import json, pathlib, sys
import jsonschema
folder = pathlib.Path(sys.argv[1])
def load(name):
    return json.loads((folder / name).read_text())
for kind, answer in json.load(sys.stdin).items():
    resolver = jsonschema.RefResolver("", {}, store={"common.json": load("common.json")})
    jsonschema.Draft202012Validator(load(kind + ".json"), resolver=resolver).validate(answer)
`;
    const { scene, ...kinds } = answers;
    assert.equal(typeof scene, "string");
    const python = ["python3", "/usr/bin/python3"].find((name) => spawnSync(name, ["-c", "import jsonschema"]).status === 0);
    assert.ok(python, "no Python with jsonschema");
    const checked = spawnSync(python, ["-W", "ignore", "-c", program, join(root, "docs/schema")], { input: JSON.stringify(kinds), encoding: "utf8" });
    assert.equal(checked.status, 0, checked.stderr);
}

test("exports parse: SVG, PNG, JSON by its schemas, CSV by its rows", quietly(async () => {
    const page = await openPage();
    await choose(page, "Fires in Oregon");
    await page.getByLabel("Departure", { exact: true }).fill("52");
    await page.keyboard.press("Tab");
    const svg = await saveByMenu(page, "svg");
    const parsed = await page.evaluate((text) => {
        const made = new DOMParser().parseFromString(text, "image/svg+xml");
        return { error: made.querySelector("parsererror")?.textContent ?? null, root: made.documentElement.tagName, drawn: made.querySelectorAll("path, circle, text").length, pictures: made.querySelectorAll("svg > svg").length };
    }, svg.bytes.toString());
    assert.deepEqual([parsed.error, parsed.root, parsed.pictures], [null, "svg", 2]);
    assert.ok(parsed.drawn > 20);
    const png = await saveByMenu(page, "png");
    assert.deepEqual([...png.bytes.subarray(0, 8)], [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
    assert.ok(png.bytes.readUInt32BE(16) >= 600 && png.bytes.readUInt32BE(20) >= 700);
    const answers = JSON.parse((await saveByMenu(page, "json")).bytes);
    assert.deepEqual(Object.keys(answers), ["scene", "path", "jumps", "build"]);
    const scene = join(root, "examples/scenes/fire-oregon-c.json");
    assert.deepEqual(answers.jumps, JSON.parse(tdsp("jumps", scene, "--json")));
    const path = JSON.parse(tdsp("path", scene, "52", "--json"));
    assert.deepEqual(answers.path, path);
    assert.equal(answers.build.rows, 19);
    checkSchemas(answers);
    const lines = (file) => file.bytes.toString().trim().split("\n").map((line) => line.split(","));
    const curve = lines(await saveByMenu(page, "curve"));
    assert.deepEqual(curve[0], ["departure", "travel_time", "arrival", "first", "second"]);
    assert.ok(curve.length > 100 && curve.slice(1).every((row, i, all) => row.length === 5 && (i === 0 || Number(row[2]) >= Number(all[i - 1][2]))));
    const way = lines(await saveByMenu(page, "path"));
    assert.deepEqual(way[0], ["time", "x", "y", "leg", "type", "disc"]);
    assert.deepEqual(way.at(-1).slice(0, 3).map(Number), [path.arrival, ...path.legs.at(-1).to]);
}));
