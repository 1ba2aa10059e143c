// SPDX-License-Identifier: MIT
// Scenes and tables from files and back to files. Which of the two a file is, its first bytes say, as on the command line. What is wrong with one becomes a
// sentence that names the file, the place and the reason.
import { parseJson } from "tdsp/core_json.js";
import { locate } from "tdsp/locate.js";

const MAGIC = [0x89, 0x54, 0x44, 0x53, 0x50, 0x0d, 0x0a, 0x1a];
/** Larger files are not scenes that a page can show. */
export const LARGEST_FILE = 64 << 20;

/** A file that cannot be opened; its message is a sentence. */
export class FileError extends Error {}

const isTable = (bytes) => MAGIC.every((byte, i) => bytes[i] === byte);
/** A file's name without its folder and its ending. */
export const stem = (name) => name.replace(/^.*[/\\]/, "").replace(/\.(json|tdsp)$/i, "");

/** @returns {any} */
function sceneOf(name, bytes) {
    try {
        return parseJson(bytes);
    } catch (error) {
        if (!error.status) throw error;
        throw new FileError(`${name}${error.where ? ", " : ": "}${error.message}.`);
    }
}

/** What is in `bytes`: {name, bytes} for a table, {name, scene, text} for a scene. Throws FileError. @param {string} name @param {Uint8Array} bytes */
export function openBytes(name, bytes) {
    if (bytes.length === 0) throw new FileError(`${name} is empty.`);
    if (isTable(bytes)) return { name: stem(name), bytes };
    return { name: stem(name), scene: sceneOf(name, bytes), text: new TextDecoder().decode(bytes) };
}

/** @param {File} file */
export async function openFile(file) {
    if (file.size > LARGEST_FILE) throw new FileError(`${file.name} has ${Math.round(file.size / (1 << 20))} MB: this page opens files up to ${LARGEST_FILE >> 20} MB.`);
    let bytes;
    try {
        bytes = new Uint8Array(await file.arrayBuffer());
    } catch (error) {
        throw new FileError(`${file.name} cannot be read: ${error.message}.`);
    }
    return openBytes(file.name, bytes);
}

/** What the core says of a scene, with the line of the file that it means. @param {string} name @param {{message: string, where?: string}} error @param {string} [text] */
export function refusal(name, error, text) {
    const reason = error.message.replace(/[.\s]*$/, ".");
    if (!error.where) return `${name}: ${reason}`;
    const said = reason.startsWith(error.where) ? reason.slice(error.where.length).replace(/^[:\s]+/, "") : reason;
    if (!text) return `${name}, ${error.where}: ${said}`;
    const { line, column } = locate(text, error.where);
    return `${name}, line ${line}, column ${column} (${error.where}): ${said}`;
}

/** A scene as a file that people can read: a line a disc. @param {import("tdsp/state.js").Scene} scene */
export function sceneText(scene) {
    const { discs, ...rest } = scene;
    const head = Object.entries(rest).map(([key, value]) => ` ${JSON.stringify(key)}: ${JSON.stringify(value)}`);
    const lines = discs.map((disc) => `  ${JSON.stringify(disc)}`).join(",\n");
    return `{\n${[...head, ` "discs": [\n${lines}]`].join(",\n")}}\n`;
}

/** Have the browser save `content` as a file. @param {string} name @param {string|Uint8Array|Blob} content @param {string} type */
export function save(name, content, type) {
    const blob = content instanceof Blob ? content : new Blob([/** @type {BlobPart} */ (content)], { type });
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** Call `open(files)` for what is dropped anywhere on the page, and mark the page while something hangs over it. @param {(file: File) => void} open */
export function acceptDrops(open) {
    const root = document.documentElement;
    const holdsFiles = (event) => [...(event.dataTransfer?.types ?? [])].includes("Files");
    addEventListener("dragover", (event) => {
        if (!holdsFiles(event)) return;
        event.preventDefault();
        root.classList.add("dropping");
    });
    addEventListener("dragleave", (event) => { if (!event.relatedTarget) root.classList.remove("dropping"); });
    addEventListener("drop", (event) => {
        root.classList.remove("dropping");
        if (!holdsFiles(event)) return;
        event.preventDefault();
        open(event.dataTransfer.files[0]);
    });
}
