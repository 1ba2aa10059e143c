// SPDX-License-Identifier: MIT
// What the page does by itself, and what keys do to it in steps. The story: leave just in time and play; then leave a moment later and play again. It is told
// once, never to people who asked for less motion, and ends as soon as somebody touches anything.
import { placeOf } from "tdsp/state.js";
import { nextJump } from "tdsp/words.js";

const PAUSE = 900; // milliseconds between the two acts

export class Show {
    #telling = false;

    /** @param {import("tdsp/page.js").Page} page */
    constructor(page) {
        this.page = page;
        this.still = matchMedia("(prefers-reduced-motion: reduce)");
        for (const kind of ["pointerdown", "keydown", "wheel"]) addEventListener(kind, () => { this.#telling = false; }, { capture: true, passive: true });
    }

    /** Play the way once. */
    once() {
        this.#telling = false;
        if (!this.still.matches) this.page.playback.play({ from: this.#beginning });
    }

    stop() {
        this.#telling = false;
    }

    /** Both acts. */
    story() {
        if (this.still.matches) return;
        this.#telling = true;
        const { playback, store } = this.page;
        playback.play({ from: this.#beginning, ended: () => setTimeout(() => {
            if (!this.#telling) return;
            this.#telling = false;
            const jump = nextJump(this.page.answers.found.jumps ?? [], store.state.departure);
            if (!jump) return;
            store.dispatch({ type: "departure", departure: after(jump) });
            playback.play({ from: this.#beginning });
        }, PAUSE) });
    }

    /** Where playing begins: a little before the departure, so that one sees what waiting is. */
    get #beginning() {
        return this.page.store.state.departure * 0.5;
    }

    /** The last moment before the next jump; from there, just after it. */
    nextJump() {
        const { store, answers } = this.page;
        const jump = nextJump(answers.found.jumps ?? [], store.state.departure) ?? answers.found.jumps?.[0];
        if (!jump) return;
        store.dispatch({ type: "departure", departure: store.state.departure === jump.departure ? after(jump) : jump.departure });
    }

    /** @param {number} by 1 or -1 */
    selectNext(by) {
        const { state } = this.page.store;
        const count = state.edit?.scene.discs.length ?? 0;
        if (count === 0) return;
        const index = state.selected?.what === "disc" ? (state.selected.index + by + count) % count : by > 0 ? 0 : count - 1;
        this.page.store.dispatch({ type: "select", thing: { what: "disc", index } });
    }

    /** Move what is selected by pixels. @returns {boolean} false where nothing is */
    move(dx, dy, gesture) {
        const { store, scene } = this.page;
        const thing = store.state.selected;
        const place = thing && placeOf(store.state, thing);
        if (!place) return false;
        store.dispatch({ type: "place", thing, place: [place[0] + dx * scene.pixel, place[1] + dy * scene.pixel], gesture });
        return true;
    }
}

/** A departure just after a jump. */
const after = (jump) => jump.departure + jump.travelAfter * 0.004;
