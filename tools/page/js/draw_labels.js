// SPDX-License-Identifier: MIT
/**
 * Placing labels, as `tdsp plot` does: twelve places around the point are tried, and twelve further away; of those free of other
 * labels and marks, the one that hides least of the lines wins, the wanted direction first. A label without a free place is left out.
 */

/** @typedef {import("tdsp/draw_text.js").TextStyle} TextStyle */
/** @typedef {{left: number, top: number, right: number, bottom: number}} Box */
/**
 * A label that has its place: its middle, and its box. From the moment `until` on it has other words.
 * @typedef {Box & {x: number, y: number, text: string, style: TextStyle, until?: number, after?: string, afterStyle?: TextStyle}} Label
 */

const PLACES = 12;
const RINGS = 2;
const FURTHER = 12; // pixels from one ring to the next
const CELL = 16;
const COLUMNS = 4096;

/** 0, 1, -1, 2, -2, ... twelfths of a turn. @param {number} angle @param {number} place */
function turned(angle, place) {
    const twelfths = place % 2 === 1 ? (place + 1) / 2 : -(place / 2);
    return angle + (2 * Math.PI * twelfths) / PLACES;
}

/** @param {Box} one @param {Box} other */
export function areApart(one, other) {
    return one.right < other.left || other.right < one.left || one.bottom < other.top || other.bottom < one.top;
}

export class Labels {
    /**
     * @param {Box} frame labels stay inside
     * @param {(text: string, style: TextStyle) => number} measure
     */
    constructor(frame, measure) {
        this.frame = frame;
        this.measure = measure;
        /** @type {Box[]} */
        this.boxes = [];
        /** Points of lines, by cells of the screen. @type {Map<number, number[]>} */
        this.cells = new Map();
        /** What has found a place. @type {Label[]} */
        this.placed = [];
    }

    /** For more labels beside these, which come and go: lines are shared, marks and places are not. */
    copy() {
        const copy = new Labels(this.frame, this.measure);
        copy.cells = this.cells;
        copy.boxes = [...this.boxes];
        return copy;
    }

    /** Nothing may be written over a mark. */
    addMark(x, y, radius) {
        this.boxes.push({ left: x - radius, top: y - radius, right: x + radius, bottom: y + radius });
    }

    /** @param {Box} box */
    addBox(box) {
        this.boxes.push(box);
    }

    /** A point of a line that labels had better not hide. */
    addObstacle(x, y) {
        const { left, top, right, bottom } = this.frame;
        if (x < left || x > right || y < top || y > bottom) return;
        const key = Math.floor(x / CELL) + COLUMNS * Math.floor(y / CELL);
        const points = this.cells.get(key);
        if (points) points.push(x, y);
        else this.cells.set(key, [x, y]);
    }

    /** Points every `every` pixels of a straight line. */
    addLine(x0, y0, x1, y1, every = 4) {
        const steps = Math.min(2000, Math.ceil(Math.hypot(x1 - x0, y1 - y0) / every));
        for (let i = 0; i <= steps; i++) this.addObstacle(x0 + ((x1 - x0) * i) / (steps || 1), y0 + ((y1 - y0) * i) / (steps || 1));
    }

    /** @param {Box} box */
    isFree(box) {
        const frame = this.frame;
        if (box.left < frame.left + 3 || box.right > frame.right - 3 || box.top < frame.top + 3 || box.bottom > frame.bottom - 3) return false;
        return this.boxes.every((other) => areApart(box, other));
    }

    /** How many points of lines lie under the box. @param {Box} box */
    hidden(box) {
        let count = 0;
        for (let row = Math.floor(box.top / CELL); row <= Math.floor(box.bottom / CELL); row++)
            for (let column = Math.floor(box.left / CELL); column <= Math.floor(box.right / CELL); column++)
                count += hiddenIn(this.cells.get(column + COLUMNS * row), box);
        return count;
    }

    /**
     * Place a label `distance` away from a point, best in direction `angle` (0: right, growing downwards).
     * @returns {Label|null} null where there is no room
     */
    place(x, y, distance, angle, text, style) {
        const width = this.measure(text, style) + 4, height = style.size + 2;
        let best = null, least = Infinity;
        for (let i = 0; i < RINGS * PLACES && least > 0; i++) {
            const box = boxAt(x, y, distance + Math.floor(i / PLACES) * FURTHER, turned(angle, i % PLACES), width, height);
            const cost = this.isFree(box) ? this.hidden(box) : Infinity;
            if (cost < least) [best, least] = [box, cost];
        }
        if (!best) return null;
        this.boxes.push(best);
        const label = { x: (best.left + best.right) / 2, y: (best.top + best.bottom) / 2, text, style: { ...style, across: 0.5, up: 0.5 }, ...best };
        this.placed.push(label);
        return label;
    }
}

/** @param {number[]|undefined} points @param {Box} box */
function hiddenIn(points, box) {
    if (!points) return 0;
    let count = 0;
    for (let i = 0; i < points.length; i += 2)
        if (points[i] > box.left && points[i] < box.right && points[i + 1] > box.top && points[i + 1] < box.bottom) count++;
    return count;
}

/** The box of a text whose nearest side is `distance` away. @returns {Box} */
function boxAt(x, y, distance, angle, width, height) {
    const middleX = x + Math.cos(angle) * (distance + width / 2), middleY = y + Math.sin(angle) * (distance + height / 2);
    return { left: middleX - width / 2, top: middleY - height / 2, right: middleX + width / 2, bottom: middleY + height / 2 };
}
