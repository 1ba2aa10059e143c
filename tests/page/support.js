// SPDX-License-Identifier: MIT
/** What the tests share: the module, the command, scenes. */
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { loadCore } from "../../tools/page/js/core.js";

export const root = new URL("../../", import.meta.url).pathname;
const build = process.env.TDSP_BUILD ?? join(root, "build");
const command = process.env.TDSP ?? join(build, "tdsp");

export const wasmFile = join(build, "page", "tdsp.wasm");
export const wasm = readFileSync(wasmFile);
export const newCore = () => loadCore(wasm);

/** @param {string} name */
export const read = (name) => JSON.parse(readFileSync(join(root, name), "utf8"));

/** Run the command. @param {...string} args */
export function run(...args) {
    const { status, stdout, stderr } = spawnSync(command, args, { encoding: "utf8", maxBuffer: 1 << 28 });
    return { status, stdout, stderr };
}

/** What the command prints as JSON, whatever its exit status. @param {...string} args */
export const ask = (...args) => JSON.parse(run(...args, "--json").stdout);

/** A directory for the time of the tests. */
export function scratchDirectory() {
    const directory = mkdtempSync(join(tmpdir(), "tdsp-page-"));
    process.on("exit", () => rmSync(directory, { recursive: true, force: true }));
    return directory;
}

/** The scenes of the examples. @returns {string[]} paths */
export function exampleScenes() {
    const directory = join(root, "examples", "scenes");
    return readdirSync(directory).filter((name) => name.endsWith(".json")).sort().map((name) => join(directory, name));
}

/** Scenes of every kind that the command generates, written to a directory. @param {string} directory @returns {string[]} paths */
export function generatedScenes(directory) {
    const asked = [
        ...[1, 2, 3].map((seed) => ["random", "--n", "40", "--seed", String(seed)]),
        ...[4, 5, 6].map((seed) => ["crowd", "--n", "60", "--seed", String(seed)]),
        ...[7, 8].map((seed) => ["mixed", "--n", "30", "--seed", String(seed)]),
        ["wall", "--n", "20", "--seed", "9"],
        ["columns", "--n", "12", "--seed", "11"],
        ["nsquared", "--n", "12", "--seed", "10"],
    ];
    return asked.map((args) => {
        const path = join(directory, `${args[0]}-${args[4]}.json`);
        execFileSync(command, ["generate", ...args, "-o", path]);
        return path;
    });
}
