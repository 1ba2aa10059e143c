// SPDX-License-Identifier: MIT
/**
 * Placing labels, as `tdsp plot` does: of the places that are tried around a point, or beside a line that stands upright, those free of
 * other labels and marks are left, and the one that hides least wins, the wanted direction first. A label without a free place is left out.
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
const BEYOND = 26; // pixels past the ends of an upright line
const SHIFT = 3; // pixels from one place beside it to the next
const APART = 1.5; // pixels above and below a label beside a line that stay free
const COVERED = 5; // points of lines that one label is worth which has to go for another
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
        /** Pixels around a label that lines had better keep away too. */
        this.clear = 0;
        /** What had better not be hidden either, and how many points of lines each is worth. @type {(Box & {worth: number})[]} */
        this.better = [];
    }

    /** For labels that come and go over these: they may take the place of one that always stands there, where that costs least. */
    copy() {
        const copy = new Labels(this.frame, this.measure);
        copy.cells = this.cells;
        copy.boxes = [...this.boxes];
        copy.better = this.placed.map(({ left, top, right, bottom }) => ({ left, top, right, bottom, worth: COVERED }));
        return copy;
    }

    /** A line along an axis that comes and goes. */
    addPassing(x0, y0, x1, y1) {
        this.better.push({ left: Math.min(x0, x1) - 1, top: Math.min(y0, y1) - 1, right: Math.max(x0, x1) + 1, bottom: Math.max(y0, y1) + 1, worth: 3 * COVERED });
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
        return this.boxes.every((other) => areApart(box, other)) && this.placed.every((other) => areApart(box, other));
    }

    /** How many points of lines lie under the box, and what is worth as much. @param {Box} box */
    hidden({ left, top, right, bottom }) {
        const box = { left: left - this.clear, top: top - this.clear, right: right + this.clear, bottom: bottom + this.clear };
        let count = 0;
        for (const other of this.better) if (!areApart(box, other)) count += other.worth;
        for (let row = Math.floor(box.top / CELL); row <= Math.floor(box.bottom / CELL); row++)
            for (let column = Math.floor(box.left / CELL); column <= Math.floor(box.right / CELL); column++)
                count += hiddenIn(this.cells.get(column + COLUMNS * row), box);
        return count;
    }

    /**
     * Place a label `distance` away from a point, best in direction `angle` (0: right, growing downwards); where that hides something, further and further away.
     * @returns {Label|null} null where there is no room
     */
    place(x, y, distance, angle, text, style, rings = RINGS) {
        const width = this.measure(text, style) + 4, height = style.size + 2, boxes = [];
        for (let i = 0; i < rings * PLACES; i++) boxes.push(boxAt(x, y, distance + Math.floor(i / PLACES) * FURTHER, turned(angle, i % PLACES), width, height));
        return this.take(boxes, text, style, Infinity);
    }

    /**
     * Place a label beside a line from (x, top) to (x, bottom), best right of its middle, where it hides nothing at all.
     * @returns {Label|null} null where there is no such place
     */
    placeBeside(x, top, bottom, distance, text, style) {
        const width = this.measure(text, style) + 4, half = style.size / 2 + 1 + APART, middle = (top + bottom) / 2, boxes = [];
        for (let off = 0; off <= (bottom - top) / 2 + BEYOND; off += SHIFT) {
            for (const y of off > 0 ? [middle - off, middle + off] : [middle]) {
                boxes.push({ left: x + distance, right: x + distance + width, top: y - half, bottom: y + half });
                boxes.push({ left: x - distance - width, right: x - distance, top: y - half, bottom: y + half });
            }
        }
        return this.take(boxes, text, style, 0);
    }

    /**
     * Take the first of the free boxes that hides least, if it hides no more than `most`.
     * @param {Box[]} boxes
     * @returns {Label|null}
     */
    take(boxes, text, style, most) {
        let best = null, least = Infinity;
        for (const box of boxes) {
            if (least === 0) break;
            const cost = this.isFree(box) ? this.hidden(box) : Infinity;
            if (cost < least && cost <= most) [best, least] = [box, cost];
        }
        if (!best) return null;
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
