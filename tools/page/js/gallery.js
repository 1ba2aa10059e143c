// SPDX-License-Identifier: MIT
// The scenes that the page brings along, as a strip of small pictures. Each is drawn by asking the core, a little at a time, once the page stands.
import { byId, element } from "tdsp/dom.js";
import { drawThumbnail } from "tdsp/thumbnail.js";

/**
 * @typedef {{x: number, y: number, width: number}} View  the middle of what is shown and its width, where the scene as a whole is much larger than what is to be seen
 * @typedef {{id: string, title: string, scene: import("tdsp/state.js").Scene, departure: number, words: [string, string], credit?: string, view?: View}} Entry
 */

export class Gallery {
    /** @param {Entry[]} entries @param {any} core @param {(entry: Entry) => void} open */
    constructor(entries, core, open) {
        this.entries = entries;
        this.core = core;
        /** @type {any[]} canvases */
        this.pictures = entries.map(() => element("canvas", { width: 240, height: 120, "aria-hidden": "true" }));
        this.buttons = entries.map((entry, i) => element("button", { type: "button", onclick: () => open(entry) }, [this.pictures[i], element("span", { textContent: entry.title })]));
        byId("gallery").replaceChildren(...this.buttons.map((button) => element("li", {}, [button])));
    }

    /** @param {string} id @returns {Entry|undefined} */
    find(id) {
        return this.entries.find((entry) => entry.id === id);
    }

    /** Mark the scene that is shown. @param {string|null} id */
    mark(id) {
        this.entries.forEach((entry, i) => {
            if (entry.id === id) this.buttons[i].setAttribute("aria-current", "true");
            else this.buttons[i].removeAttribute("aria-current");
        });
    }

    /** Draw all pictures, one a turn, so that nobody waits for them. @param {any} palette */
    async paint(palette) {
        const turn = (this.turn = Symbol());
        for (const [i, entry] of this.entries.entries()) {
            await new Promise((resolve) => setTimeout(resolve, 0));
            if (this.turn !== turn) return;
            drawThumbnail(this.pictures[i], this.core, entry, palette);
        }
    }
}
