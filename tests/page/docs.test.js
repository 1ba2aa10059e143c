// SPDX-License-Identifier: MIT
/** The programs in docs/page.md run as they stand and print what stands below them. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { root, scratchDirectory, wasmFile } from "./support.js";

const directory = scratchDirectory();
const core = join(root, "tools/page/js/core.js");
const blocks = [...readFileSync(join(root, "docs/page.md"), "utf8").matchAll(/^```js\n([^]*?)^```\n[^`]*^```text\n([^]*?)^```/gm)];
// A browser would fetch what lies beside the page.
const FETCH = 'import { readFile as readBeside } from "node:fs/promises";\nconst fetch = async (name) => ({ arrayBuffer: () => readBeside(name) });\n';

for (const [index, name, where] of [[0, "a page", "page"], [1, "Node.js", "root"]])
    test(`the program for ${name} prints what is shown`, () => {
        const [, code, shown] = blocks[index];
        const file = join(directory, `${where}.mjs`);
        writeFileSync(file, FETCH + code.replace(/"\.[\w/]*\/core\.js"/, JSON.stringify(core)));
        const cwd = where === "root" ? root : join(wasmFile, "..");
        const { status, stdout, stderr } = spawnSync(process.execPath, [file], { cwd, encoding: "utf8" });
        assert.equal(status, 0, stderr);
        assert.equal(stdout, shown);
    });

test("every program of the page is run", () => {
    assert.equal(blocks.length, 2);
    assert.equal(readFileSync(join(root, "docs/page.md"), "utf8").match(/^```js/gm).length, blocks.length);
});
