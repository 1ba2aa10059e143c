// SPDX-License-Identifier: MIT
/** What the page carries inside, read from the elements that inline.py wrote; takes the place of inlined.js there. */

/** @param {string} id */
function text(id) {
    return /** @type {HTMLElement} */ (document.getElementById(id)).textContent ?? "";
}

/** The module: base64 of gzip. @returns {Promise<ArrayBuffer>} */
export async function wasmBytes() {
    const packed = Uint8Array.from(atob(text("inlined-wasm")), (character) => character.charCodeAt(0));
    return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

/** A worker's script as one text. @type {string | null} */
export const workerSource = text("inlined-worker");

/** gallery/gallery.json with each scene in the place of its name. @type {any[]} */
export const gallery = JSON.parse(text("inlined-gallery"));
