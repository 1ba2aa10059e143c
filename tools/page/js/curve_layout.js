// SPDX-License-Identifier: MIT
/**
 * Where the curve's picture has its window, and where its labels find room: those of jumps, of the last departure and of the deadline
 * stay where they are while the departure moves.
 */
import { axesRoom, frameTicks, frameX, frameY } from "tdsp/axes.js";
import { Labels } from "tdsp/draw_labels.js";
import { TEXT } from "tdsp/draw_text.js";
import { withUnit } from "tdsp/numbers.js";
import { valueOf } from "tdsp/curve_data.js";
import { placeLegend } from "tdsp/draw_legend.js";

/** @typedef {import("tdsp/curve_picture.js").CurveState} CurveState */
/** @typedef {import("tdsp/draw_labels.js").Label} Label */
/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */

const WIDE = 560;
/** Of the window's height: smaller jumps get no ends ... */
export const MARKED = 0.012;
const LABELLED = 0.02; // ... and no label
const MOST_LABELS = 12;
const MOST_STEPS = 2000; // of a table; in more there is no room between them
const LAST_ROOM = 20; // pixels right of the last departure

/** @param {CurveState} state */
export function legendOf(state) {
    const items = [];
    if (state.curve.count > 0) items.push({ kind: "curve", wide: 24, text: curveName(state) });
    if (state.rows) items.push({ kind: "band", wide: 24, text: "certified by the table" });
    if (state.bends.length > 0) items.push({ kind: "bend", wide: 8, text: `bend${state.bends.length === 1 ? "" : "s"} (${state.bends.length})` });
    if (state.jumps.length > 0) items.push({ kind: "jump", wide: 10, text: `jump${state.jumps.length === 1 ? "" : "s"} (${state.jumps.length})` });
    return items;
}

/** @param {CurveState} state */
function axesOf(state) {
    const unit = state.units.time;
    return { x: { name: "departure", unit, divisor: 1 }, y: { name: state.mode === "arrival" ? "arrival" : "travel time", unit, divisor: 1 } };
}

/** The frame, as wide that words have room along the line of the last departure, where no curve comes by. @param {CurveState} state @param {import("tdsp/axes.js").Frame} frame */
function withRoom({ curve, last }, frame) {
    if (!last || !Number.isFinite(last.departure) || curve.count === 0) return frame;
    const reach = frame.xLow + ((last.departure - frame.xLow) * frame.width) / Math.max(1, frame.width - LAST_ROOM);
    return { ...frame, xHigh: Math.max(frame.xHigh, reach) };
}

/**
 * The frame, axes and legend on a canvas of this size.
 * @param {CurveState} state
 * @param {number} width
 * @param {number} height
 * @param {Pen["width"]} measure
 */
export function arrangeCurve(state, width, height, measure) {
    const titled = width >= WIDE, top = 14 + state.head, right = 14, axes = axesOf(state);
    const draft = { ...state.window, left: 50, top, width: width - 64, height: Math.max(40, height - 80) };
    const room = axesRoom(frameTicks(draft, axes.x, axes.y, measure), true);
    const left = titled ? room.left : room.left - 20;
    const legend = placeLegend(legendOf(state), width - left - right, measure);
    const below = room.bottom + (legend.height > 0 ? legend.height + 6 : 0);
    const frame = withRoom(state, { ...state.window, left, top, width: Math.max(20, width - left - right), height: Math.max(20, height - top - below - 4) });
    // A window of nothing has no numbers.
    const ticks = state.curve.count > 0 ? frameTicks(frame, axes.x, axes.y, measure) : { x: [], y: [], widest: 0 };
    return { frame, axes, titled, ticks, legend: legend.items, legendTop: height - legend.height - 4 };
}

/** @typedef {ReturnType<typeof arrangeCurve>} CurveArrangement */

/** Where a departure and its travel time are. @param {CurveState} state */
export function placeOf(state, frame, departure, travel) {
    return { x: frameX(frame, departure), y: frameY(frame, valueOf(state.mode, departure, travel)) };
}

/** @param {CurveState} state */
function curveName({ mode, stored, sampled }) {
    if (stored) return mode === "arrival" ? "arrival by the stored path" : "travel time of the stored path";
    const known = sampled ? "sampled" : "exact";
    return mode === "arrival" ? `earliest arrival, ${known}` : `travel time, ${known}`;
}

/** The curve, and the upper edge of what the table certifies, as what labels had better not hide. @param {CurveState} state @param {Labels} labels */
function addCurve(state, frame, labels) {
    const { curve } = state;
    let from = null;
    for (let i = 0; i < curve.count; i++) {
        const to = placeOf(state, frame, curve.departure[i], curve.travel[i]);
        if (from) labels.addLine(from.x, from.y, to.x, to.y);
        from = to;
    }
    for (let i = 1; state.rows && i < Math.min(state.rows.departures.length, MOST_STEPS); i++) {
        const { departures, left } = state.rows, begin = placeOf(state, frame, departures[i - 1], left[i]), end = placeOf(state, frame, departures[i], left[i]);
        labels.addLine(begin.x, begin.y, end.x, end.y);
    }
}

/** @param {import("tdsp/curve_data.js").Jump} jump @param {string} unit */
export function jumpText(jump, unit) {
    const moment = withUnit(jump.departure, unit, 6), gap = jump.gap;
    return gap && gap.first >= 0 ? `${moment}: discs ${gap.first} and ${gap.second} close` : moment;
}

/** @param {CurveState} state @param {Labels} labels */
function placeJumps(state, frame, labels) {
    const style = { size: TEXT - 1, colour: state.palette.alarmText, halo: state.palette.paper };
    const ends = (jump) => [placeOf(state, frame, jump.departure, jump.travelBefore), placeOf(state, frame, jump.departure, jump.travelAfter)];
    const longer = (share) => (jump) => ends(jump)[0].y - ends(jump)[1].y >= share * frame.height;
    for (const jump of state.jumps.filter(longer(MARKED)).slice(0, 200)) for (const end of ends(jump)) labels.addMark(end.x, end.y, 5);
    const large = state.jumps.filter(longer(LABELLED)).sort((one, other) => other.travelAfter - other.travelBefore - (one.travelAfter - one.travelBefore));
    for (const jump of large.slice(0, MOST_LABELS)) {
        const [low, high] = ends(jump), top = Math.max(high.y, frame.top), unit = state.units.time;
        const reached = high.y < frame.top ? `, to ${withUnit(valueOf(state.mode, jump.departure, jump.travelAfter), unit, 6)}` : "";
        const texts = [jumpText(jump, unit), withUnit(jump.departure, unit, 6)];
        texts.some((text) => labels.placeBeside(low.x, top, low.y, 9, text + reached, style));
    }
}

/** What may be written along the line of the last departure, the longest first. @param {CurveState} state @returns {string[]} */
function lastTexts({ last, units }) {
    if (last.reason === "horizon") return ["horizon"];
    return [`last departure ${withUnit(last.departure, units.time, 6)}`, "last departure"];
}

/** The line of the last departure, and the longest words that fit along it, right of it, where there is no curve. @param {CurveState} state @param {Labels} labels @param {Pen["width"]} measure */
function placeLast(state, frame, labels, measure) {
    const { last, curve } = state;
    if (!last || !Number.isFinite(last.departure) || curve.count === 0) return null;
    const x = frameX(frame, last.departure), y = frame.top + frame.height - 10;
    const text = lastTexts(state).find((words) => measure(words, { size: TEXT, colour: "" }) < frame.height - 20) ?? "";
    labels.addBox({ left: x + 2, right: x + LAST_ROOM, top: frame.top, bottom: frame.top + frame.height });
    labels.addLine(x, frame.top, x, frame.top + frame.height);
    return { x, text, y };
}

/**
 * The deadline as a line in the window: all that arrives at it.
 * @param {CurveState} state
 * @param {import("tdsp/axes.js").Frame} frame
 */
export function deadlineLine(state, frame) {
    const a = state.deadline;
    if (a === null || !Number.isFinite(a)) return null;
    const at = (departure) => placeOf(state, frame, departure, a - departure);
    if (state.mode === "arrival") return a < frame.yLow || a > frame.yHigh ? null : { from: at(frame.xLow), to: at(frame.xHigh) };
    const low = Math.max(frame.xLow, a - frame.yHigh), high = Math.min(frame.xHigh, a - frame.yLow);
    return low < high ? { from: at(low), to: at(high) } : null;
}

/** @param {CurveState} state @param {Labels} labels */
function placeDeadline(state, frame, labels) {
    const line = deadlineLine(state, frame), style = { size: TEXT, bold: true, colour: state.palette.ink, halo: state.palette.paper };
    if (!line) return null;
    labels.addLine(line.from.x, line.from.y, line.to.x, line.to.y);
    const leave = state.leaveBy === null ? null : placeOf(state, frame, state.leaveBy, state.travel(state.leaveBy));
    if (leave) labels.addMark(leave.x, leave.y, 8);
    if (leave) labels.place(leave.x, leave.y, 11, -Math.PI / 6, `leave by ${withUnit(state.leaveBy, state.units.time, 6)}`, style);
    const words = leave ? "arrive by" : "too early: arrive by";
    labels.place(line.from.x + 6, line.from.y + 14, 8, 0, `${words} ${withUnit(state.deadline, state.units.time, 6)}`, { ...style, bold: false });
    return { ...line, leave };
}

/**
 * @param {CurveState} state
 * @param {CurveArrangement} arrangement
 * @param {Pen["width"]} measure
 */
export function layoutCurve(state, { frame }, measure) {
    const labels = new Labels({ left: frame.left, top: frame.top, right: frame.left + frame.width, bottom: frame.top + frame.height }, measure);
    addCurve(state, frame, labels);
    const last = placeLast(state, frame, labels, measure);
    const deadline = placeDeadline(state, frame, labels);
    placeJumps(state, frame, labels);
    return { labels, placed: [...labels.placed], last, deadline };
}

/** @typedef {ReturnType<typeof layoutCurve>} CurveLayout */
