// SPDX-License-Identifier: MIT
/**
 * Mouse, pen and fingers on the curve, as intentions: a press anywhere takes the slider there and holds it, one on the deadline holds
 * that. A finger that goes up or down scrolls the page.
 *
 * @typedef {object} CurveIntentions
 * @property {(x: number, y: number, touch: boolean) => "deadline"|"slider"|"plot"|null} hit
 * @property {(x: number) => void} slide
 * @property {(x: number, y: number) => void} moveDeadline
 * @property {(x: number|null) => void} hover
 * @property {(held: boolean) => void} hold
 */
import { placeWithin } from "tdsp/pointer.js";

const CURSORS = { deadline: "ns-resize", slider: "ew-resize", plot: "crosshair" };

export class CurveGestures {
    /** @param {HTMLElement} element @param {CurveIntentions} intentions */
    constructor(element, intentions) {
        this.element = element;
        this.to = intentions;
        this.held = null;
        this.pointer = -1;
        for (const kind of ["down", "move", "up", "cancel", "leave"]) element.addEventListener(`pointer${kind}`, (event) => this[kind](event));
        element.style.touchAction = "pan-y pinch-zoom";
    }

    /** @param {PointerEvent} event */
    down(event) {
        if (this.held || (event.button !== 0 && event.pointerType === "mouse")) return;
        const [x, y] = placeWithin(this.element, event);
        this.held = this.to.hit(x, y, event.pointerType !== "mouse");
        if (!this.held) return;
        this.pointer = event.pointerId;
        this.element.setPointerCapture(event.pointerId);
        this.to.hover(null);
        this.to.hold(true);
        this.drag(x, y);
    }

    drag(x, y) {
        if (this.held === "deadline") this.to.moveDeadline(x, y);
        else this.to.slide(x);
    }

    /** @param {PointerEvent} event */
    move(event) {
        const [x, y] = placeWithin(this.element, event);
        if (this.held) {
            if (event.pointerId === this.pointer) this.drag(x, y);
            return;
        }
        if (event.pointerType !== "mouse") return;
        const over = this.to.hit(x, y, false);
        this.element.style.cursor = over ? CURSORS[over] : "";
        this.to.hover(over ? x : null);
    }

    /** @param {PointerEvent} event */
    up(event) {
        if (event.pointerId !== this.pointer) return;
        this.held = null;
        this.pointer = -1;
        this.to.hold(false);
    }

    /** @param {PointerEvent} event */
    cancel(event) {
        this.up(event);
    }

    leave() {
        if (!this.held) this.to.hover(null);
    }
}
