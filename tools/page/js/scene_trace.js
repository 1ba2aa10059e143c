// SPDX-License-Identifier: MIT
/**
 * Paths on the screen. Rides are cut in halves until each chord is within 0.3 pixels of the curve, and not at all where they are not
 * seen; what leaves the window is cut off there, because a canvas counts in single precision and would move lines whose far ends are
 * millions of pixels away.
 */
import { positionAtShare, shareAt, turnedAt } from "tdsp/scene_legs.js";

/** @typedef {import("tdsp/scene_legs.js").Leg} Leg */
/** @typedef {import("tdsp/scene_projection.js").Projection} Projection */
/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */

const EXACT = 0.3; // pixels
const BEYOND = 64; // pixels that lines go on outside of the window
const DEEPEST = 22;
const WIDEST_TURN = 1; // radians of a piece that the middle alone can judge

/** Draws lines as far as they are seen. */
export class Tracer {
    constructor() {
        this.out = new Float64Array(2);
        this.ends = new Float64Array(4);
    }

    /** @param {Pen} pen @param {Projection} projection */
    begin(pen, projection) {
        this.pen = pen;
        this.projection = projection;
        this.xLow = projection.left - BEYOND;
        this.xHigh = projection.left + projection.width + BEYOND;
        this.yLow = projection.top - BEYOND;
        this.yHigh = projection.top + projection.height + BEYOND;
        this.drawnX = this.drawnY = NaN;
    }

    /** The pen's place without drawing. */
    moveTo(x, y) {
        this.x = x;
        this.y = y;
    }

    lineTo(x, y) {
        if (this.clip(this.x, this.y, x, y)) {
            const [x0, y0, x1, y1] = this.ends;
            if (x0 !== this.drawnX || y0 !== this.drawnY) this.pen.move(x0, y0);
            this.pen.line(x1, y1);
            this.drawnX = x1;
            this.drawnY = y1;
        }
        this.x = x;
        this.y = y;
    }

    /** Liang and Barsky: the part of a line inside the window, into `ends`; false where there is none. */
    clip(x0, y0, x1, y1) {
        const dx = x1 - x0, dy = y1 - y0;
        let from = 0, to = 1;
        for (let side = 0; side < 4; side++) {
            const step = side === 0 ? -dx : side === 1 ? dx : side === 2 ? -dy : dy;
            const room = side === 0 ? x0 - this.xLow : side === 1 ? this.xHigh - x0 : side === 2 ? y0 - this.yLow : this.yHigh - y0;
            if (step === 0 && room < 0) return false;
            if (step < 0) from = Math.max(from, room / step);
            if (step > 0) to = Math.min(to, room / step);
        }
        if (!(from <= to)) return false;
        this.ends[0] = from > 0 ? x0 + dx * from : x0;
        this.ends[1] = from > 0 ? y0 + dy * from : y0;
        this.ends[2] = to < 1 ? x0 + dx * to : x1;
        this.ends[3] = to < 1 ? y0 + dy * to : y1;
        return true;
    }

    /** Where a leg is on the screen at a share of its duration, into `out`. @param {Leg} leg */
    at(leg, share) {
        positionAtShare(leg, share, this.out);
        this.out[0] = this.projection.x(this.out[0]);
        this.out[1] = this.projection.y(this.out[1]);
    }

    /** A leg from one share of its duration to another. @param {Leg} leg */
    leg(leg, from, to) {
        this.at(leg, from);
        this.moveTo(this.out[0], this.out[1]);
        this.at(leg, to);
        if (leg.ride) this.piece(leg, from, this.x, this.y, to, this.out[0], this.out[1], 0);
        else this.lineTo(this.out[0], this.out[1]);
    }

    /** @param {Leg} leg */
    piece(leg, from, x0, y0, to, x1, y1, depth) {
        const middle = (from + to) / 2;
        const turned = turnedAt(leg, to) - turnedAt(leg, from);
        this.at(leg, middle);
        const xm = this.out[0], ym = this.out[1];
        if (depth >= DEEPEST || (turned < WIDEST_TURN && (offChord(x0, y0, x1, y1, xm, ym) < EXACT || this.unseen(leg, turned, x0, y0, x1, y1)))) {
            this.lineTo(x1, y1);
            return;
        }
        this.piece(leg, from, x0, y0, middle, xm, ym, depth + 1);
        this.piece(leg, middle, xm, ym, to, x1, y1, depth + 1);
    }

    /** No point of a piece can be in the window: it stays within r turned^2 / 8 of its chord, and some. @param {Leg} leg */
    unseen(leg, turned, x0, y0, x1, y1) {
        const radius = Math.max(leg.radiusFrom, leg.radiusTo) * this.projection.scale;
        const around = radius * turned * turned * 0.15 + Math.hypot(x1 - x0, y1 - y0) * 0.25;
        const beside = Math.max(x0, x1) + around < this.xLow || Math.min(x0, x1) - around > this.xHigh;
        return beside || Math.max(y0, y1) + around < this.yLow || Math.min(y0, y1) - around > this.yHigh;
    }
}

/** How far a point is from the middle of a chord, across it and along it. */
function offChord(x0, y0, x1, y1, x, y) {
    return Math.hypot((x0 + x1) / 2 - x, (y0 + y1) / 2 - y);
}

/**
 * The part of a path between two times.
 * @param {Tracer} tracer begun
 * @param {Leg[]} legs
 * @param {number} from time
 * @param {number} until time
 */
export function traceLegs(tracer, legs, from, until) {
    for (let i = 0; i < legs.length; i++) {
        const leg = legs[i];
        if (leg.end < from || leg.start > until) continue;
        tracer.leg(leg, shareAt(leg, from), shareAt(leg, until));
    }
}
