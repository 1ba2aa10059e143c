// SPDX-License-Identifier: MIT
// The whole state as a link, in the part after #, which no server ever sees. What can be said by name is: a scene of the gallery, and of an edited one only
// what differs. What cannot is JSON, deflated where the browser can, in the letters of base64url.
import { EPSILON, isEdited } from "tdsp/state.js";

/** A link longer than this is cut by some programs that pass it on. */
export const LONGEST = 32000;
const LARGEST = 1 << 25;
const DIGITS = 9; // of what is looked at: a pixel is more

/** A link that cannot be followed; its message is a sentence. */
export class LinkError extends Error {}

// ------------------------------------------------------------------------------------------------------------ bytes

/** @param {Uint8Array} bytes */
export function toBase64url(bytes) {
    let binary = "";
    for (let i = 0; i < bytes.length; i += 8192) binary += String.fromCharCode(...bytes.subarray(i, i + 8192));
    return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** @param {string} text @returns {Uint8Array} */
export function fromBase64url(text) {
    const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
    return Uint8Array.from(binary, (c) => c.charCodeAt(0));
}

async function through(bytes, stream) {
    const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
    const parts = [];
    let size = 0;
    for (;;) {
        const { done, value } = await reader.read();
        if (done) return new Uint8Array(await new Blob(parts).arrayBuffer());
        size += value.length;
        if (size > LARGEST) throw new LinkError("The link holds more than the page can show.");
        parts.push(value);
    }
}

/** "z" and deflated bytes, or "r" and raw ones where the browser cannot deflate. @param {Uint8Array} bytes */
async function pack(bytes) {
    if (typeof CompressionStream !== "function") return "r" + toBase64url(bytes);
    return "z" + toBase64url(await through(bytes, new CompressionStream("deflate")));
}

async function unpack(text) {
    if (text[0] !== "z" && text[0] !== "r") throw new LinkError("The link was written by another version of this page.");
    try {
        const bytes = fromBase64url(text.slice(1));
        if (text[0] === "r") return bytes;
        if (typeof DecompressionStream !== "function") throw new LinkError("This browser cannot unpack the link: it is too old.");
        return await through(bytes, new DecompressionStream("deflate"));
    } catch (error) {
        throw error instanceof LinkError ? error : new LinkError("The link is damaged: a part of it is missing or was changed on the way.");
    }
}

const packJson = (value) => pack(new TextEncoder().encode(JSON.stringify(value)));

async function unpackJson(text) {
    const bytes = await unpack(text);
    try {
        return JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
    } catch {
        throw new LinkError("The link is damaged: a part of it is missing or was changed on the way.");
    }
}

// ------------------------------------------------------------------------------------------------------------ edits

const same = (a, b) => a === b || JSON.stringify(a) === JSON.stringify(b);

/** What `scene` has that `base` has not: {source, destination, robot, discs: {index: disc}, count}. */
export function differences(base, scene) {
    const out = {};
    for (const key of ["source", "destination", "robot"]) if (!same(base[key], scene[key])) out[key] = scene[key];
    const discs = {};
    scene.discs.forEach((disc, i) => { if (!same(disc, base.discs[i])) discs[i] = disc; });
    if (Object.keys(discs).length > 0) out.discs = discs;
    if (scene.discs.length !== base.discs.length) out.count = scene.discs.length;
    return out;
}

/** The scene that differs from `base` by `changes`. Throws LinkError. */
export function changed(base, changes) {
    const scene = { ...base };
    for (const key of ["source", "destination", "robot"]) if (key in changes) scene[key] = changes[key];
    const count = changes.count ?? base.discs.length;
    scene.discs = base.discs.slice(0, count);
    for (const [i, disc] of Object.entries(changes.discs ?? {})) scene.discs[Number(i)] = disc;
    if (scene.discs.length !== count || scene.discs.includes(undefined)) throw new LinkError("The link is damaged: it changes discs that are not there.");
    return scene;
}

// ------------------------------------------------------------------------------------------------------- the whole link

/** @typedef {{view: import("tdsp/gallery.js").View|null, time: number|null}} Looked where the scene is looked at, null: all of it; and at what time, null: in the middle of the way */

/** The part of a link after #. @param {import("tdsp/state.js").State} state @param {Looked} [looked] @returns {Promise<string>} */
export async function writeLink(state, { view, time } = { view: null, time: null }) {
    const words = new URLSearchParams();
    if (state.from) words.set("scene", state.from);
    else words.set("name", state.name);
    if (state.bytes) words.set("table", await pack(state.bytes));
    else if (!state.from) words.set("whole", await packJson(state.original.scene));
    if (isEdited(state)) words.set("edit", await packJson({ ...differences(state.original.scene, state.edit.scene), factor: state.edit.factor }));
    if (state.departure > 0) words.set("leave", String(state.departure));
    if (state.deadline !== null) words.set("deadline", String(state.deadline));
    if (state.mode !== "travel") words.set("show", state.mode);
    if (state.epsilon !== EPSILON.first) words.set("epsilon", String(state.epsilon));
    if (state.selected) words.set("selected", state.selected.what + (state.selected.what === "disc" ? state.selected.index : ""));
    if (view) words.set("view", [view.x, view.y, view.width].map((value) => Number(value.toPrecision(DIGITS))).join(","));
    if (time !== null) words.set("time", String(Number(time.toPrecision(DIGITS))));
    return words.toString();
}

const TIMES = { leave: "time to leave", deadline: "time to arrive by", time: "time to look at" };

function timeOf(words, key) {
    const text = words.get(key);
    if (text === null) return null;
    const value = Number(text);
    if (text.trim() === "" || !Number.isFinite(value) || value < 0) throw new LinkError(`The link is damaged: "${text}" is no ${TIMES[key]}.`);
    return value;
}

function viewOf(words) {
    const text = words.get("view");
    if (text === null) return null;
    const [x, y, width, ...more] = text.split(",").map(Number);
    if (![x, y, width].every(Number.isFinite) || !(width > 0) || more.length > 0) throw new LinkError(`The link is damaged: "${text}" is no place to look at.`);
    return { x, y, width };
}

function epsilon(words) {
    const value = Number(words.get("epsilon") ?? EPSILON.first);
    if (!(value >= EPSILON.least && value <= EPSILON.most)) throw new LinkError(`The link is damaged: its epsilon is not from ${EPSILON.least} to ${EPSILON.most}.`);
    return value;
}

function selection(words) {
    const found = /^(source|destination|disc(\d+))$/.exec(words.get("selected") ?? "");
    if (!found) return null;
    return found[2] === undefined ? { what: found[1], index: -1 } : { what: "disc", index: Number(found[2]) };
}

async function sceneOf(words, gallery) {
    const from = words.get("scene");
    if (from === null) return unpackJson(words.get("whole"));
    const scene = gallery(from);
    if (!scene) throw new LinkError(`The link asks for a scene called "${from.slice(0, 80)}", which this gallery has not.`);
    return scene;
}

function plausible(scene) {
    if (scene === null || typeof scene !== "object" || !Array.isArray(scene.discs)) throw new LinkError("The link is damaged: what it holds is no scene.");
    return scene;
}

/**
 * The action "open" that a link asks for; null for a link that asks for nothing. Throws LinkError.
 * @param {string} fragment without the # @param {(name: string) => any} gallery the scene of that name, or undefined
 */
export async function readLink(fragment, gallery) {
    const words = new URLSearchParams(fragment);
    const chosen = { type: "open", departure: timeOf(words, "leave") ?? 0, deadline: timeOf(words, "deadline"), time: timeOf(words, "time"), view: viewOf(words), epsilon: epsilon(words), selected: selection(words),
        mode: words.get("show") === "arrival" ? "arrival" : "travel", name: words.get("name") ?? words.get("scene") ?? "", from: words.get("scene") };
    if (words.has("table")) return { ...chosen, bytes: await unpack(words.get("table")) };
    if (!words.has("scene") && !words.has("whole")) return null;
    const scene = plausible(await sceneOf(words, gallery));
    if (!words.has("edit")) return { ...chosen, scene };
    const { factor, ...changes } = await unpackJson(words.get("edit"));
    if (typeof factor !== "number" || !(factor >= 0)) throw new LinkError("The link is damaged: its growth multiplier is no number.");
    return { ...chosen, scene, edit: { scene: changed(scene, changes), factor } };
}
