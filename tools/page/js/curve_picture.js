// SPDX-License-Identifier: MIT
/**
 * The curve as a picture, for any pen. In two parts: the ground (grid, band, curve, jumps, last departure, deadline, axes) changes with
 * the scene and the table only; the departure and what is pointed at move.
 */
import { drawAxes, drawGrid, frameX, frameY } from "tdsp/axes.js";
import { valueOf } from "tdsp/curve_data.js";
import { MARKED, jumpText, placeOf } from "tdsp/curve_layout.js";
import { areApart } from "tdsp/draw_labels.js";
import { drawLegend } from "tdsp/draw_legend.js";
import { TEXT } from "tdsp/draw_text.js";
import { withUnit } from "tdsp/numbers.js";

/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */
/** @typedef {import("tdsp/curve_layout.js").CurveArrangement} CurveArrangement */
/** @typedef {import("tdsp/curve_layout.js").CurveLayout} CurveLayout */

/**
 * All that a picture of a curve shows.
 * @typedef {object} CurveState
 * @property {import("tdsp/curve_data.js").Curve} curve
 * @property {boolean} stored the curve is that of the table's paths: no exact one is known
 * @property {boolean} sampled the jumps are not known yet: between samples the curve is straight
 * @property {import("tdsp/curve_data.js").Rows|null} rows
 * @property {import("tdsp/curve_data.js").Jump[]} jumps
 * @property {import("tdsp/curve_data.js").Bend[]} bends
 * @property {import("tdsp/curve_data.js").Last|null} last
 * @property {(departure: number) => number} travel the travel time of a departure, NaN where there is none
 * @property {number|null} departure
 * @property {number|null} hover
 * @property {number|null} deadline an arrival
 * @property {number|null} leaveBy the latest departure that makes it
 * @property {"travel"|"arrival"} mode
 * @property {{time: string}} units
 * @property {ReturnType<typeof import("tdsp/curve_data.js").curveWindow>} window
 * @property {import("tdsp/palette.js").Palette} palette
 * @property {string} message where there is no curve: why
 * @property {number} head pixels kept free above, for a title
 * @property {boolean} still a picture without a slider
 * @property {boolean} grabbed the slider is held
 */

const FINE = 0.2; // pixels that need not be told apart
const LAST = Object.freeze([5, 4]);
const DEADLINE = Object.freeze([9, 3, 2, 3]);
const HOVER = Object.freeze([7, 5]);
const LAST_TEXT = 15; // pixels from the line of the last departure to the base line of what is written along it
const KNOB = 8.5;
const SAMPLE = 24; // pixels of a line in the legend
const ARROW = 6;
const MOMENT_RINGS = 5;
const BEND = 2.2;

/** Lines between points that can be told apart. */
class Stairs {
    /** @param {Pen} pen begun */
    constructor(pen) {
        this.pen = pen;
        this.down = false;
        this.x = this.y = 0;
    }

    to(x, y) {
        if (this.down && Math.abs(x - this.x) < FINE && Math.abs(y - this.y) < FINE) return;
        if (this.down) this.pen.line(x, y);
        else this.pen.move(x, y);
        this.down = true;
        [this.x, this.y] = [x, y];
    }

    lift() {
        this.down = false;
    }
}

/** A step of the staircase: in T it is level, in A it rises with the departure. @param {CurveState} state @param {Stairs} stairs */
function step(state, frame, stairs, from, until, travel) {
    stairs.to(frameX(frame, from), frameY(frame, valueOf(state.mode, from, travel)));
    stairs.to(frameX(frame, until), frameY(frame, valueOf(state.mode, until, travel)));
}

/** @param {CurveState} state @param {Stairs} stairs */
function traceUpper(state, frame, stairs) {
    const { departures, left } = state.rows;
    for (let i = 0; i < departures.length; i++) step(state, frame, stairs, i > 0 ? departures[i - 1] : departures[0], departures[i], left[i]);
}

/** From the last departure back to the first. @param {CurveState} state @param {Stairs} stairs */
function traceLower(state, frame, stairs) {
    const { departures, right, left } = state.rows;
    for (let i = departures.length - 1; i > 0; i--) step(state, frame, stairs, departures[i], departures[i - 1], Math.min(right[i - 1], left[i]));
}

/** What the table certifies. @param {Pen} pen @param {CurveState} state */
function drawBand(pen, state, frame) {
    if (!state.rows || state.rows.departures.length === 0) return;
    pen.part("certified");
    pen.begin();
    const stairs = new Stairs(pen);
    traceUpper(state, frame, stairs);
    traceLower(state, frame, stairs);
    pen.close();
    pen.fill(state.palette.tint);
    pen.begin();
    stairs.lift();
    traceUpper(state, frame, stairs);
    pen.stroke(state.palette.ahead, state.curve.count > 0 ? 1.2 : 1.8);
}

/** @param {Pen} pen @param {CurveState} state */
function drawCurve(pen, state, frame) {
    const { curve } = state, stairs = new Stairs(pen);
    if (curve.count === 0) return;
    pen.part("curve");
    pen.begin();
    for (let i = 0; i < curve.count; i++) {
        if (curve.starts[i]) stairs.lift();
        const at = placeOf(state, frame, curve.departure[i], curve.travel[i]);
        stairs.to(at.x, at.y);
    }
    pen.stroke(state.palette.path, 2.4);
}

/** @param {Pen} pen */
function drawBend(pen, palette, x, y) {
    pen.begin();
    pen.disc(x, y, BEND);
    pen.fill(palette.paper);
    pen.stroke(palette.path, 1.3);
}

/** @param {Pen} pen @param {CurveState} state */
function drawBends(pen, state, frame) {
    if (state.bends.length === 0) return;
    pen.part("bends");
    for (const { departure, travel } of state.bends) {
        const at = placeOf(state, frame, departure, travel);
        drawBend(pen, state.palette, at.x, at.y);
    }
}

/** @param {Pen} pen */
function drawJumpEnd(pen, palette, at, filled) {
    pen.begin();
    pen.disc(at.x, at.y, 3.8);
    pen.fill(filled ? palette.alarm : palette.paper);
    pen.stroke(palette.alarm, 1.6);
}

/** T is continuous from the left: the lower end belongs to the curve, the upper one does not. @param {Pen} pen @param {CurveState} state */
function drawJumps(pen, state, frame) {
    if (state.jumps.length === 0) return;
    const ends = state.jumps.map((jump) => [jump.travelBefore, jump.travelAfter].map((travel) => placeOf(state, frame, jump.departure, travel)));
    pen.part("jumps");
    pen.begin();
    for (const [low, high] of ends) {
        pen.move(low.x, low.y);
        pen.line(high.x, high.y);
    }
    pen.stroke(state.palette.alarm, 1.6);
    for (const [low, high] of ends) {
        if (low.y - high.y < MARKED * frame.height) continue;
        drawJumpEnd(pen, state.palette, low, true);
        if (high.y >= frame.top) drawJumpEnd(pen, state.palette, high, false);
        else if (low.y >= frame.top) drawArrow(pen, state.palette, low.x, frame.top);
    }
}

/** A jump goes on above the window. @param {Pen} pen */
function drawArrow(pen, palette, x, top) {
    pen.begin();
    pen.move(x, top + 1);
    pen.line(x - ARROW, top + 2 * ARROW);
    pen.line(x + ARROW, top + 2 * ARROW);
    pen.close();
    pen.union(palette.alarm, palette.paper, 3);
}

/** @param {Pen} pen @param {CurveState} state @param {CurveLayout["frame"]} frame @param {CurveLayout} layout */
function drawLast(pen, state, frame, { last }) {
    if (!last) return;
    pen.part("last-departure");
    pen.begin();
    pen.move(last.x, frame.top);
    pen.line(last.x, frame.top + frame.height);
    pen.stroke(state.palette.alarm, 1.4, LAST);
    if (last.text) pen.textUpwards(last.x + LAST_TEXT, last.y, last.text, { size: TEXT, colour: state.palette.alarmText, halo: state.palette.paper });
}

/** @param {Pen} pen @param {CurveState} state @param {CurveLayout} layout */
function drawDeadline(pen, state, { deadline }) {
    if (!deadline) return;
    const { palette } = state, { from, to, leave } = deadline;
    pen.part("deadline");
    pen.begin();
    pen.move(from.x, from.y);
    pen.line(to.x, to.y);
    pen.stroke(palette.paper, 4);
    pen.stroke(palette.ink, 1.6, DEADLINE);
    if (!leave) return;
    pen.begin();
    pen.move(leave.x, leave.y - 7);
    pen.line(leave.x + 7, leave.y);
    pen.line(leave.x, leave.y + 7);
    pen.line(leave.x - 7, leave.y);
    pen.close();
    pen.union(palette.ink, palette.paper, 4);
}

/** A short line of the legend. @param {Pen} pen */
function drawDash(pen, x, y, colour, width) {
    pen.begin();
    pen.move(x, y);
    pen.line(x + SAMPLE, y);
    pen.stroke(colour, width);
}

/** What each entry of the legend looks like. @type {Record<string, (pen: Pen, palette: import("tdsp/palette.js").Palette, x: number, y: number) => void>} */
const SAMPLES = {
    curve: (pen, palette, x, y) => drawDash(pen, x, y, palette.path, 2.4),
    band(pen, palette, x, y) {
        pen.begin();
        pen.rect(x, y - 6, SAMPLE, 12);
        pen.fill(palette.tint);
        drawDash(pen, x, y - 6, palette.ahead, 1.6);
    },
    bend: (pen, palette, x, y) => drawBend(pen, palette, x + 4, y),
    jump(pen, palette, x, y) {
        pen.begin();
        pen.move(x + 5, y + 6);
        pen.line(x + 5, y - 6);
        pen.stroke(palette.alarm, 1.6);
        drawJumpEnd(pen, palette, { x: x + 5, y: y + 6 }, true);
        drawJumpEnd(pen, palette, { x: x + 5, y: y - 6 }, false);
    },
};

/** @param {Pen} pen @param {CurveState} state @param {CurveArrangement} arrangement @param {CurveLayout} layout */
export function drawCurveGround(pen, state, arrangement, layout) {
    const { frame, ticks, axes, titled } = arrangement, { palette } = state;
    drawGrid(pen, frame, ticks, palette);
    pen.clip(frame.left, frame.top, frame.width, frame.height);
    drawBand(pen, state, frame);
    drawLast(pen, state, frame, layout);
    drawDeadline(pen, state, { ...layout, deadline: layout.deadline && { ...layout.deadline, leave: null } });
    drawCurve(pen, state, frame);
    drawBends(pen, state, frame);
    drawJumps(pen, state, frame);
    drawDeadline(pen, state, layout);
    drawMessage(pen, state, frame);
    pen.unclip();
    drawAxes(pen, frame, ticks, { x: axes.x, y: titled ? axes.y : null }, palette);
    drawLegend(pen, arrangement.legend, palette.ink, frame.left, arrangement.legendTop, (kind, x, y) => SAMPLES[kind](pen, palette, x, y));
}

/** @param {Pen} pen @param {CurveState} state */
function drawMessage(pen, state, frame) {
    if (!state.message || state.curve.count > 0) return;
    const style = { size: TEXT, colour: state.palette.ink, across: 0.5, up: 0.5, halo: state.palette.paper };
    pen.text(frame.left + frame.width / 2, frame.top + frame.height / 2, state.message, style);
}

/** "leave at 52.5 s: takes 4498 s", or when it arrives. @param {CurveState} state @param {number} departure */
export function momentText(state, departure) {
    const unit = state.units.time, leave = withUnit(departure, unit, 6), travel = state.travel(departure);
    if (Number.isNaN(travel)) return `leave at ${leave}: no way`;
    if (state.mode === "arrival") return `leave at ${leave}, arrive at ${withUnit(departure + travel, unit, 6)}`;
    return `leave at ${leave}: takes ${withUnit(travel, unit, 6)}`;
}

/** The same of a departure that is pointed at: at a jump, what it does, which not every jump has room to say always. @param {CurveState} state @param {number} departure */
export function hoverText(state, departure) {
    const jump = state.jumps.find((one) => one.departure === departure);
    if (!jump) return momentText(state, departure);
    const [before, after] = [jump.travelBefore, jump.travelAfter].map((travel) => withUnit(valueOf(state.mode, departure, travel), state.units.time, 6));
    return `${jumpText(jump, state.units.time)}, ${before} becomes ${after}`;
}

/** A place on the curve. @param {Pen} pen @param {CurveState} state @param {import("tdsp/draw_labels.js").Labels} labels */
function drawPlace(pen, state, at, radius, colour, labels) {
    if (Number.isNaN(at.y)) return;
    pen.begin();
    pen.disc(at.x, at.y, radius);
    pen.union(colour, state.palette.paper, 4);
    labels.addMark(at.x, at.y, 6);
}

/** The chosen departure: a line, and its place on the curve. @param {Pen} pen @param {CurveState} state */
function drawDepartureLine(pen, state, frame, labels) {
    const { departure, palette } = state;
    if (departure === null) return;
    const at = placeOf(state, frame, departure, state.travel(departure));
    pen.part("departure");
    pen.begin();
    pen.move(at.x, frame.top + frame.height);
    pen.line(at.x, Number.isNaN(at.y) ? frame.top : Math.max(at.y, frame.top));
    pen.stroke(palette.paper, 4);
    pen.stroke(palette.path, 1.6);
    labels.addPassing(at.x, frame.top + frame.height, at.x, Number.isNaN(at.y) ? frame.top : at.y);
    drawPlace(pen, state, at, 5.5, palette.path, labels);
}

/** What is pointed at: a dashed crosshair, as its path in the scene is dashed. @param {Pen} pen @param {CurveState} state */
function drawHoverLines(pen, state, frame, labels) {
    const { hover, palette } = state;
    if (hover === null) return;
    const at = placeOf(state, frame, hover, state.travel(hover));
    pen.part("pointed-at");
    pen.begin();
    pen.move(at.x, frame.top);
    pen.line(at.x, frame.top + frame.height);
    if (!Number.isNaN(at.y)) {
        pen.move(frame.left, at.y);
        pen.line(at.x, at.y);
        labels.addPassing(frame.left, at.y, at.x, at.y);
    }
    labels.addPassing(at.x, frame.top, at.x, frame.top + frame.height);
    pen.stroke(palette.other, 1.2, HOVER);
    drawPlace(pen, state, at, 4.5, palette.other, labels);
}

/** What a departure means, beside its place. @param {CurveState} state @param {import("tdsp/draw_labels.js").Labels} labels */
function placeMoment(state, frame, labels, text, departure, style) {
    const { x, y } = placeOf(state, frame, departure, state.travel(departure));
    return labels.place(x, y >= frame.top ? y : frame.top + 30, 11, -Math.PI / 2, text, style, MOMENT_RINGS);
}

/** Labels of both moments, and those that always stand there, as far as they are not in the way. @param {Pen} pen @param {CurveState} state @param {CurveLayout} layout @param {import("tdsp/draw_labels.js").Labels} labels */
function drawLabels(pen, state, frame, layout, labels) {
    const { palette, departure, hover } = state;
    const chosen = { size: TEXT, bold: true, colour: palette.pathText, halo: palette.paper }, pointed = { size: TEXT, colour: palette.otherText, halo: palette.paper };
    if (departure !== null) placeMoment(state, frame, labels, momentText(state, departure), departure, chosen);
    if (hover !== null) placeMoment(state, frame, labels, hoverText(state, hover), hover, pointed);
    const others = layout.placed.filter((one) => labels.placed.every((moment) => areApart(one, moment)));
    pen.part("labels");
    for (const label of [...others, ...labels.placed]) pen.text(label.x, label.y, label.text, label.style);
}

/** The knob that the slider is held by, on the axis. @param {Pen} pen @param {CurveState} state */
function drawKnob(pen, state, frame) {
    if (state.departure === null || state.curve.count === 0) return;
    const { palette } = state, x = Math.min(frame.left + frame.width, frameX(frame, state.departure)), y = frame.top + frame.height;
    pen.part("slider");
    pen.begin();
    pen.disc(x, y, KNOB + (state.grabbed ? 1.5 : 0));
    pen.union(palette.path, palette.paper, 5);
    pen.begin();
    for (const dx of [-3, 0, 3]) {
        pen.move(x + dx, y - 3.5);
        pen.line(x + dx, y + 3.5);
    }
    pen.stroke(palette.paper, 1.2);
}

/** What moves. @param {Pen} pen @param {CurveState} state @param {CurveArrangement} arrangement @param {CurveLayout} layout */
export function drawCurveLive(pen, state, { frame }, layout) {
    if (state.curve.count === 0) return;
    const labels = layout.labels.copy();
    pen.clip(frame.left, frame.top, frame.width, frame.height);
    drawHoverLines(pen, state, frame, labels);
    drawDepartureLine(pen, state, frame, labels);
    drawLabels(pen, state, frame, layout, labels);
    pen.unclip();
    if (!state.still) drawKnob(pen, state, frame);
}
