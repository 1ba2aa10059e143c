// SPDX-License-Identifier: MIT
/**
 * What the page carries inside. This is the unbundled version, for a web server at the root of the repository; inline.py puts inlined_page.js in its place, which reads
 * the same from the page itself.
 */

/** @param {string} path */
async function load(path) {
    const url = new URL(path, import.meta.url);
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url.pathname}: ${response.status} ${response.statusText}`);
    return response;
}

/** The module, of `make page-wasm`. @returns {Promise<ArrayBuffer>} */
export async function wasmBytes() {
    return (await load("../../../build/page/tdsp.wasm")).arrayBuffer();
}

/** A worker's script as one text, or null where it is loaded from worker.js. @type {string | null} */
export const workerSource = null;

/** gallery/gallery.json with each scene in the place of its name. @type {any[]} */
export const gallery = typeof document === "undefined" ? [] : await loadGallery();

async function loadGallery() {
    const entries = /** @type {any[]} */ (await (await load("../gallery/gallery.json")).json());
    return Promise.all(entries.map(async (entry) => ({ ...entry, scene: await (await load(`../../../${entry.scene}`)).json() })));
}
