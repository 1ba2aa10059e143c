// SPDX-License-Identifier: MIT
/**
 * The curve on a canvas: T(t) or A(t) over all departures with the table's certified band, the jumps and what closes there, the slider
 * of the departure, a deadline and the departure that makes it. As with the scene, what it shows is told to it, and what a person does
 * to it is told by the callbacks; only what the mouse points at is the view's own too.
 */
import { frameX } from "tdsp/axes.js";
import { curveOf, curveWindow, lastShown, latestDeparture, stairsOf, travelAt, withBends } from "tdsp/curve_data.js";
import { CurveGestures } from "tdsp/curve_gestures.js";
import { arrangeCurve, deadlineLine, layoutCurve } from "tdsp/curve_layout.js";
import { drawCurveGround, drawCurveLive } from "tdsp/curve_picture.js";
import { blankCurve, curveSvg } from "tdsp/curve_svg.js";
import { Layers } from "tdsp/draw_layers.js";
import { light } from "tdsp/palette.js";

/** @typedef {import("tdsp/curve_picture.js").CurveState} CurveState */
/** @typedef {import("tdsp/palette.js").Palette} Palette */

/**
 * @typedef {object} CurveShown each left out stays as it was; null is nothing
 * @property {import("tdsp/curve_data.js").Samples|null} samples of the earliest arrival, in order of time
 * @property {{rows: () => import("tdsp/curve_data.js").Rows}|import("tdsp/curve_data.js").Rows|null} table the core's Table, or its rows()
 * @property {import("tdsp/curve_data.js").Jump[]|null} jumps
 * @property {import("tdsp/curve_data.js").Bend[]|null} bends
 * @property {import("tdsp/curve_data.js").Last|null} last
 * @property {((departure: number) => number)|null} evaluate the exact travel time of a departure, NaN where there is none; without it values between samples are on their chord
 * @property {number|null} departure that is chosen
 * @property {number|null} hover departure that is pointed at (elsewhere)
 * @property {number|null} deadline an arrival
 * @property {number|null} leaveBy the exact latest departure that makes the deadline, where it is known
 * @property {"travel"|"arrival"} mode
 * @property {{time?: string}} units
 * @property {string} message what to say where there is no curve
 * @property {Palette} palette
 */

/**
 * @typedef {object} CurveOptions
 * @property {Palette} [palette]
 * @property {(departure: number) => void} [onDeparture] the slider is moved there
 * @property {(departure: number|null) => void} [onHover]
 * @property {(arrival: number|null) => void} [onDeadline] the deadline is moved there
 */

const REACH = 8; // pixels around the deadline
const REACH_TOUCH = 22;
const BELOW = 24; // pixels under the window where the slider's knob can be held
const SNAP = 4; // pixels from a jump that mean its departure, the last one that gets through
const LIVE = ["departure", "hover"];

/** The view of a curve: {@link CurveShown}, {@link CurveOptions}. */
export class CurveView {
    /** @param {HTMLCanvasElement} canvas sized by CSS @param {CurveOptions} [options] */
    constructor(canvas, options = {}) {
        this.options = options;
        this.canvas = canvas;
        this.given = { samples: null, evaluate: null, leaveBy: null };
        this.state = blankCurve(options.palette ?? light);
        this.dirty = { ground: true, live: true };
        this.layers = new Layers(canvas, () => this.draw());
        this.measure = this.layers.pen.width.bind(this.layers.pen);
        new CurveGestures(canvas, this.intentions());
    }

    /**
     * Show these; what is left out stays. Draws with the next frame; draw() draws at once.
     * @param {Partial<CurveShown>} shown
     */
    show(shown) {
        const { state, given } = this;
        for (const key of ["samples", "evaluate", "leaveBy"]) if (shown[key] !== undefined) given[key] = shown[key];
        for (const key of ["departure", "hover", "deadline", "last", "message", "palette", "mode"]) if (shown[key] !== undefined) state[key] = shown[key];
        if (shown.jumps !== undefined) {
            state.jumps = shown.jumps ?? [];
            state.sampled = shown.jumps === null;
        }
        if (shown.bends !== undefined) state.bends = shown.bends ?? [];
        if (shown.units !== undefined) state.units = { time: shown.units?.time ?? "" };
        if (shown.table !== undefined) state.rows = rowsOf(shown.table);
        if (shown.deadline !== undefined && shown.leaveBy === undefined) given.leaveBy = null;
        if (Object.keys(shown).some((key) => !LIVE.includes(key))) this.takeCurve();
        this.change();
    }

    takeCurve() {
        const { state, given } = this;
        state.stored = given.samples === null && state.rows !== null;
        state.curve = state.stored ? stairsOf(state.rows) : curveOf(withBends(given.samples, state.bends), state.jumps, state.last);
        state.window = curveWindow(state.curve, state.last, state.mode, state.rows);
        state.travel = given.evaluate ?? ((departure) => travelAt(state.curve, departure));
        state.leaveBy = state.deadline === null ? null : given.leaveBy ?? latestDeparture(state.curve, state.deadline);
        this.dirty.ground = true;
    }

    change() {
        this.dirty.live = true;
        this.layers.ask();
    }

    /** Draw now, if anything has changed since the last time. */
    draw() {
        const { layers, state, dirty } = this;
        if (layers.fitSize()) dirty.ground = true;
        if (layers.width === 0 || !(dirty.ground || dirty.live)) return;
        if (dirty.ground) {
            this.arrangement = arrangeCurve(state, layers.width, layers.height, this.measure);
            this.layout = layoutCurve(state, this.arrangement, this.measure);
            drawCurveGround(layers.blankKept(state.palette.paper), state, this.arrangement, this.layout);
        }
        drawCurveLive(layers.copyKept(), state, this.arrangement, this.layout);
        dirty.ground = dirty.live = false;
    }

    /** The last departure that is shown: where the slider ends. */
    get until() {
        return lastShown(this.state.curve, this.state.last);
    }

    /**
     * What is seen, as an SVG file.
     * @param {{width?: number, height?: number, title?: string, description?: string, palette?: Palette}} [page]
     */
    toSVG(page = {}) {
        return curveSvg(this.state, { ...page, width: page.width ?? this.layers.width, height: page.height ?? this.layers.height }, this.measure);
    }

    /** @returns {import("tdsp/curve_gestures.js").CurveIntentions} */
    intentions() {
        return {
            hit: (x, y, touch) => this.partAt(x, y, touch),
            slide: (x) => this.options.onDeparture?.(this.departureAt(x)),
            moveDeadline: (x, y) => this.options.onDeadline?.(this.arrivalAt(x, y)),
            hover: (x) => this.hover(x === null ? null : this.departureAt(x)),
            hold: (held) => {
                this.state.grabbed = held;
                this.change();
            },
        };
    }

    /** @returns {"deadline"|"slider"|"plot"|null} what is under a pixel */
    partAt(x, y, touch = false) {
        const { frame } = this.arrangement ?? {}, { state } = this, reach = touch ? REACH_TOUCH : REACH;
        if (!frame || state.curve.count === 0) return null;
        if (x < frame.left - reach || x > frame.left + frame.width + reach || y < frame.top || y > frame.top + frame.height + BELOW) return null;
        const slider = state.departure === null ? NaN : Math.abs(frameX(frame, state.departure) - x);
        if (slider <= reach && y > frame.top + frame.height - 14) return "slider";
        const line = deadlineLine(state, frame);
        if (line && distance(line, x, y) <= Math.min(reach, 14)) return "deadline";
        return slider <= reach ? "slider" : "plot";
    }

    /** The departure at a pixel; near a jump its own. */
    departureAt(x) {
        const { frame } = this.arrangement, { jumps } = this.state;
        const away = (jump) => Math.abs(frameX(frame, jump.departure) - x);
        if (jumps.length > 0 && jumps.length < 200) {
            const nearest = jumps.reduce((best, jump) => (away(jump) < away(best) ? jump : best));
            if (away(nearest) < SNAP) return nearest.departure;
        }
        const departure = frame.xLow + ((x - frame.left) / frame.width) * (frame.xHigh - frame.xLow);
        return Math.min(this.until, Math.max(0, departure));
    }

    /** The arrival at a pixel. */
    arrivalAt(x, y) {
        const { frame } = this.arrangement;
        const departure = frame.xLow + ((x - frame.left) / frame.width) * (frame.xHigh - frame.xLow);
        const value = frame.yHigh - ((y - frame.top) / frame.height) * (frame.yHigh - frame.yLow);
        return Math.max(0, this.state.mode === "arrival" ? value : departure + value);
    }

    /** @param {number|null} departure */
    hover(departure) {
        if (departure === this.state.hover) return;
        this.state.hover = departure;
        this.change();
        this.options.onHover?.(departure);
    }
}

/** @param {CurveShown["table"]} table @returns {import("tdsp/curve_data.js").Rows|null} */
function rowsOf(table) {
    if (!table) return null;
    return "rows" in table ? table.rows() : table;
}

/** How far a pixel is from a line on the screen. */
function distance({ from, to }, x, y) {
    const dx = to.x - from.x, dy = to.y - from.y, length = Math.hypot(dx, dy) || 1;
    return Math.abs(dx * (y - from.y) - dy * (x - from.x)) / length;
}
