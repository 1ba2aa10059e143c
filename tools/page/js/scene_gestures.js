// SPDX-License-Identifier: MIT
/**
 * Mouse, pen and fingers on a scene, as intentions: hover, select, drag a thing, pan, zoom, fit. One machine for all of them by Pointer
 * Events; the pointer is captured, so that a drag goes on outside of the canvas. A finger first selects a disc and drags it then, for
 * it would move discs of a crowded scene where it meant to pan; a mouse drags at once.
 *
 * @typedef {import("tdsp/scene_hit.js").Target} Target
 * @typedef {object} Intentions
 * @property {(x: number, y: number, touch: boolean) => Target|null} hit
 * @property {(target: Target) => boolean} isSelected
 * @property {(target: Target) => [number, number]} anchor pixels of what the drag moves
 * @property {(target: Target|null) => void} hover
 * @property {(target: Target|null) => void} select
 * @property {(target: Target, x: number, y: number) => void} drag to these pixels
 * @property {(target: Target) => void} dragEnd
 * @property {(dx: number, dy: number) => void} pan
 * @property {(x: number, y: number, factor: number) => void} zoom
 * @property {() => void} fit
 */
import { placeWithin } from "tdsp/pointer.js";

const STILL = 4; // pixels that a press may tremble
const STILL_TOUCH = 8;
const TWICE = 320; // ms between the taps of a double tap
const TWICE_REACH = 30;
const WHEEL = 0.0016; // of the logarithm of the scale, for a pixel

export class SceneGestures {
    /** @param {HTMLElement} element @param {Intentions} intentions */
    constructor(element, intentions) {
        this.element = element;
        this.to = intentions;
        /** Pressed pointers. @type {Map<number, {x: number, y: number}>} */
        this.pointers = new Map();
        /** @type {Target|null} */
        this.target = null;
        /** @type {"none"|"pressed"|"dragging"|"panning"|"pinching"} */
        this.mode = "none";
        this.lastTap = { time: -Infinity, x: 0, y: 0 };
        for (const kind of ["down", "move", "up", "cancel", "leave"]) element.addEventListener(`pointer${kind}`, (event) => this[kind](event));
        element.addEventListener("lostpointercapture", (event) => this.cancel(event));
        element.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
        element.style.touchAction = "none";
    }

    /** @param {PointerEvent} event */
    down(event) {
        if (event.button !== 0 && event.pointerType === "mouse") return;
        const [x, y] = placeWithin(this.element, event);
        this.element.setPointerCapture(event.pointerId);
        this.pointers.set(event.pointerId, { x, y });
        if (this.pointers.size === 2) {
            this.endDrag();
            this.mode = "pinching";
            return;
        }
        this.touch = event.pointerType !== "mouse";
        this.start = { x, y };
        this.target = this.to.hit(x, y, this.touch);
        this.mode = "pressed";
    }

    /** @param {PointerEvent} event */
    move(event) {
        const [x, y] = placeWithin(this.element, event), pointer = this.pointers.get(event.pointerId);
        if (!pointer) {
            if (event.pointerType === "mouse") this.to.hover(this.to.hit(x, y, false));
            return;
        }
        const dx = x - pointer.x, dy = y - pointer.y;
        if (this.mode === "pinching") this.pinch(pointer, x, y);
        else Object.assign(pointer, { x, y });
        if (this.mode === "pressed") this.leaveRest(x, y);
        else if (this.mode === "panning") this.to.pan(dx, dy);
        if (this.mode === "dragging") this.to.drag(this.target, x + this.offset[0], y + this.offset[1]);
    }

    /** From a press to a drag or a pan. */
    leaveRest(x, y) {
        const dx = x - this.start.x, dy = y - this.start.y;
        if (Math.hypot(dx, dy) < (this.touch ? STILL_TOUCH : STILL)) return;
        const disc = this.target && this.target.index >= 0;
        if (!this.target || (disc && this.touch && !this.to.isSelected(this.target))) {
            this.mode = "panning";
            this.to.pan(dx, dy);
            return;
        }
        const [anchorX, anchorY] = this.to.anchor(this.target);
        this.offset = this.target.what === "rim" ? [0, 0] : [anchorX - this.start.x, anchorY - this.start.y];
        this.mode = "dragging";
        this.element.style.cursor = "grabbing";
    }

    /** Two fingers: what is between them stays between them. */
    pinch(pointer, x, y) {
        const other = [...this.pointers.values()].find((one) => one !== pointer);
        if (!other) return;
        const before = Math.hypot(pointer.x - other.x, pointer.y - other.y), after = Math.hypot(x - other.x, y - other.y);
        const middle = [(x + other.x) / 2, (y + other.y) / 2];
        this.to.pan((x - pointer.x) / 2, (y - pointer.y) / 2);
        if (before > 0) this.to.zoom(middle[0], middle[1], after / before);
        Object.assign(pointer, { x, y });
    }

    /** @param {PointerEvent} event */
    up(event) {
        if (!this.pointers.delete(event.pointerId)) return;
        if (this.mode === "pressed") this.tap(event);
        this.endDrag();
        this.mode = this.pointers.size === 1 ? "panning" : "none";
    }

    /** @param {PointerEvent} event */
    tap(event) {
        const [x, y] = placeWithin(this.element, event), last = this.lastTap;
        const twice = event.timeStamp - last.time < TWICE && Math.hypot(x - last.x, y - last.y) < TWICE_REACH;
        this.lastTap = { time: twice ? -Infinity : event.timeStamp, x, y };
        if (twice) this.to.fit();
        else this.to.select(this.target);
    }

    /** @param {PointerEvent} event */
    cancel(event) {
        if (!this.pointers.delete(event.pointerId)) return;
        this.endDrag();
        this.mode = "none";
    }

    leave() {
        if (this.pointers.size === 0) this.to.hover(null);
    }

    endDrag() {
        if (this.mode === "dragging") this.to.dragEnd(this.target);
        if (this.mode === "dragging") this.element.style.cursor = "";
    }

    /** @param {WheelEvent} event */
    wheel(event) {
        event.preventDefault();
        const [x, y] = placeWithin(this.element, event);
        const pixels = event.deltaMode === 1 ? event.deltaY * 16 : event.deltaMode === 2 ? event.deltaY * 400 : event.deltaY;
        this.to.zoom(x, y, Math.exp(-pixels * (event.ctrlKey ? 6 : 1) * WHEEL));
    }
}
