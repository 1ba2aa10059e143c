// SPDX-License-Identifier: MIT
// What keys do. Those that move things do so in the scene only, where the scene has the focus; the others everywhere but in a field that is typed in.
import { byId } from "tdsp/dom.js";
import { newGesture } from "tdsp/controls.js";

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const STEP = 10; // pixels that an arrow moves a thing
const FINE = 1;
const PAUSE = 700; // milliseconds after which another press of an arrow is another gesture

/** Does this key belong to what has the focus? */
function typing(event) {
    const { target } = event;
    if (target.matches("input[type=number], input[type=text], select, textarea")) return true;
    if (event.key === " " && target.matches("button, summary, input, a")) return true;
    return target.matches("input[type=range], input[type=radio]") && event.key.startsWith("Arrow");
}

/**
 * @typedef {object} Acts
 * @property {() => void} play
 * @property {(direction: number, fine: boolean) => void} leave
 * @property {() => void} jump
 * @property {(thing: any) => void} select
 * @property {(by: number) => void} selectNext
 * @property {(dx: number, dy: number, gesture: number) => boolean} move by pixels; false: nothing is selected
 * @property {(dx: number, dy: number) => void} pan
 * @property {(factor: number) => void} zoom
 * @property {() => void} fit
 * @property {() => void} undo
 * @property {() => void} redo
 */

export class Keys {
    #gesture = newGesture();
    #lastMove = 0;

    /** @param {Acts} acts */
    constructor(acts) {
        this.acts = acts;
        this.plain = {
            " ": () => acts.play(), "[": (fine) => acts.leave(-1, fine), "]": (fine) => acts.leave(1, fine), "{": () => acts.leave(-1, true), "}": () => acts.leave(1, true), j: () => acts.jump(),
            s: () => acts.select({ what: "source", index: -1 }), d: () => acts.select({ what: "destination", index: -1 }), n: () => acts.selectNext(1), p: () => acts.selectNext(-1),
            "+": () => acts.zoom(1.25), "=": () => acts.zoom(1.25), "-": () => acts.zoom(0.8), "−": () => acts.zoom(0.8), "0": () => acts.fit(), "?": () => byId("keys").showModal(),
        };
        addEventListener("keydown", (event) => this.#press(event));
        byId("help").addEventListener("click", () => byId("keys").showModal());
    }

    #press(event) {
        if (event.defaultPrevented || byId("keys").open) return;
        if (event.key === "Escape") return this.#escape();
        if (typing(event) || event.altKey) return;
        if (event.ctrlKey || event.metaKey) return this.#control(event);
        if (event.key in ARROWS && byId("scene-box").contains(event.target)) return this.#arrow(event);
        const act = this.plain[event.key.length === 1 ? event.key.toLowerCase() : event.key];
        if (!act) return;
        event.preventDefault();
        act(event.shiftKey);
    }

    #escape() {
        byId("save-menu").open = false;
        this.acts.select(null);
    }

    #control(event) {
        const key = event.key.toLowerCase();
        if (key !== "z" && key !== "y") return;
        event.preventDefault();
        if (key === "y" || event.shiftKey) this.acts.redo();
        else this.acts.undo();
    }

    #arrow(event) {
        event.preventDefault();
        const [x, y] = ARROWS[event.key];
        const step = event.shiftKey ? FINE : STEP;
        if (event.timeStamp - this.#lastMove > PAUSE) this.#gesture = newGesture();
        this.#lastMove = event.timeStamp;
        if (!this.acts.move(x * step, y * step, this.#gesture)) this.acts.pan(-x * 4 * step, y * 4 * step);
    }
}
