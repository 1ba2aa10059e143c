// SPDX-License-Identifier: MIT
/**
 * What of a scene's picture depends on view, path and gaps but not on the time that plays: where gaps and ticks are on the screen, and
 * where labels find room. Made when one of these changes, so that playing moves no label.
 */
import { lengthAxis, niceStep } from "tdsp/axes.js";
import { Labels } from "tdsp/draw_labels.js";
import { TEXT } from "tdsp/draw_text.js";
import { withUnit } from "tdsp/numbers.js";
import { countSeen } from "tdsp/scene_discs.js";
import { positionAt } from "tdsp/scene_legs.js";
import { END_RADIUS, GAP_REACH, ROBOT, scaleBar } from "tdsp/scene_marks.js";
import { Tracer, traceLegs } from "tdsp/scene_trace.js";

/** @typedef {import("tdsp/scene_picture.js").SceneState} SceneState */
/** @typedef {import("tdsp/draw_labels.js").Label} Label */
/** @typedef {{x: number, y: number, ux: number, uy: number, time: number}} PathTick */
/** @typedef {{x: number, y: number, direction: number, time: number, size: number}} GapMark */

const TICKS = 9; // about so many along a path of ordinary length
const TICK_PIXELS = 70; // and one in so many pixels
const GAP_LABELS = 12;
/** Pixels of a canvas that has room for a legend in many words. */
export const ROOMY = 800;
/** Pixels between the window and the canvas's right edge. */
export const RIGHT = 12;
const CROWD = 600; // discs in the window; more go without an edge, which would take as long as the discs themselves

/**
 * @typedef {object} Layout
 * @property {GapMark[]} gaps in the window
 * @property {PathTick[]} ticks in the window
 * @property {number} every time between ticks; 0 without
 * @property {Label[]} labels
 * @property {{pixels: number, text: string}} bar
 * @property {boolean} crowded too many discs for edges
 */

/** Is there room for a legend in many words? @param {SceneState} state */
function isRoomy(state) {
    return state.projection.left + state.projection.width + RIGHT >= ROOMY;
}

/** @param {SceneState} state @returns {GapMark[]} larger jumps first */
function gapMarks(state) {
    const { projection, centers } = state, marks = [];
    for (const jump of state.jumps) {
        const gap = jump.gap;
        if (!gap || !(gap.first >= 0) || gap.second >= state.count) continue;
        const x = projection.x(gap.place[0]), y = projection.y(gap.place[1]);
        if (!projection.holds(x, y)) continue;
        const direction = Math.atan2(centers.y[gap.first] - centers.y[gap.second], centers.x[gap.second] - centers.x[gap.first]);
        marks.push({ x, y, direction, time: gap.time, size: jump.size ?? 0 });
    }
    return marks.sort((one, other) => other.size - one.size);
}

/** Rooms of four numbers that the search for ticks works in. */
const near = { before: [0, 0], at: [0, 0], after: [0, 0] };

/** @param {SceneState} state @param {number} time @param {number} around @returns {PathTick} */
function tickAt(state, time, around) {
    const { projection, legs } = state;
    positionAt(legs, time - around, near.before);
    positionAt(legs, time, near.at);
    positionAt(legs, time + around, near.after);
    const dx = (near.after[0] - near.before[0]), dy = near.before[1] - near.after[1], length = Math.hypot(dx, dy) || 1;
    return { x: projection.x(near.at[0]), y: projection.y(near.at[1]), ux: dx / length, uy: dy / length, time };
}

/** The time between ticks: nine or so in all, more where the view is near. @param {SceneState} state */
function tickStep(state) {
    const { legs, projection, description } = state;
    const duration = legs[legs.length - 1].end - legs[0].start;
    if (!(duration > 0)) return 0;
    const pixels = duration * description.robot.speed * projection.scale;
    return niceStep(duration, Math.max(Math.min(TICKS, Math.max(1, pixels / TICK_PIXELS)), pixels / (4 * TICK_PIXELS)));
}

/** @param {SceneState} state @returns {{ticks: PathTick[], every: number}} */
function pathTicks(state) {
    const { legs, projection } = state;
    const every = legs.length > 0 ? tickStep(state) : 0, ticks = [];
    if (!(every > 0)) return { ticks, every: 0 };
    const start = legs[0].start, end = legs[legs.length - 1].end, last = (end - start) * (1 - 1e-6) + start;
    const ends = [state.description.source, state.description.destination];
    for (let i = Math.floor(start / every) + 1, left = 5000; i * every < last && left > 0; i++, left--) {
        const tick = tickAt(state, i * every, Math.min(every, end - start) * 1e-4);
        const hides = ends.some((place) => Math.hypot(projection.x(place[0]) - tick.x, projection.y(place[1]) - tick.y) < END_RADIUS + 8);
        if (!hides && projection.holds(tick.x, tick.y)) ticks.push(tick);
    }
    return { ticks, every };
}

/** Across the path, and of the two sides the right one, or the upper one of a level path. @param {PathTick} tick */
function beside({ ux, uy }) {
    const side = Math.abs(uy) > 0.2 ? uy : -ux;
    return side > 0 ? Math.atan2(-ux, uy) : Math.atan2(ux, -uy);
}

/** The path as what labels had better not hide. @param {SceneState} state @param {Labels} labels */
function addPath(state, labels) {
    let x = 0, y = 0;
    const pen = {
        move: (x1, y1) => { [x, y] = [x1, y1]; },
        line: (x1, y1) => { labels.addLine(x, y, x1, y1); [x, y] = [x1, y1]; },
    };
    const tracer = new Tracer();
    tracer.begin(/** @type {any} */ (pen), state.projection);
    traceLegs(tracer, state.legs, -Infinity, Infinity);
}

/** @param {SceneState} state @param {Labels} labels */
function placeEnds(state, labels) {
    const { projection, palette, description } = state;
    const style = { size: TEXT, bold: true, colour: palette.pathText, halo: palette.paper };
    /** @type {[string, [number, number]][]} */
    const places = [["source", description.source], ["destination", description.destination]];
    for (const [, place] of places) labels.addMark(projection.x(place[0]), projection.y(place[1]), END_RADIUS + 2);
    for (const [word, place] of places) {
        const x = projection.x(place[0]), y = projection.y(place[1]);
        if (projection.holds(x, y)) labels.place(x, y, END_RADIUS + 5, 0, word, style);
    }
}

/** @param {SceneState} state @param {Labels} labels @param {GapMark[]} gaps */
function placeGaps(state, labels, gaps) {
    const style = { size: TEXT - 1, bold: true, colour: state.palette.alarmText, halo: state.palette.paper };
    for (const gap of gaps) labels.addMark(gap.x, gap.y, GAP_REACH - 3);
    labels.clear = ROBOT; // the robot comes along the path just when a gap matters
    for (const gap of gaps.slice(0, GAP_LABELS)) {
        const moment = withUnit(gap.time, state.units.time, 5);
        const label = labels.place(gap.x, gap.y, GAP_REACH + 2, gap.direction + Math.PI / 2, `closes at ${moment}`, style);
        if (label) Object.assign(label, { until: gap.time, after: `closed at ${moment}`, afterStyle: { ...label.style, bold: false } });
    }
    labels.clear = 0;
}

/**
 * @param {SceneState} state
 * @param {import("tdsp/draw_canvas.js").Pen["width"]} measure
 * @returns {Layout}
 */
export function layoutScene(state, measure) {
    const { projection, palette } = state;
    const right = projection.left + projection.width, bottom = projection.top + projection.height;
    const labels = new Labels({ left: projection.left, top: projection.top, right, bottom }, measure);
    const axis = lengthAxis("x", state.units.length, projection.width / projection.scale);
    const bar = scaleBar(projection.scale, axis, Math.min(110, projection.width / 4));
    labels.addBox({ left: right - bar.pixels - 24, top: bottom - 38, right, bottom });
    if (state.corner) labels.addBox({ left: right + RIGHT - state.corner.width, top: projection.top, right, bottom: state.corner.height });
    if (state.legs.length > 0) addPath(state, labels);
    const gaps = gapMarks(state), { ticks, every } = pathTicks(state);
    placeEnds(state, labels);
    placeGaps(state, labels, gaps);
    const style = { size: 11, colour: palette.ink, halo: palette.paper };
    const unit = isRoomy(state) ? "" : state.units.time;
    for (const tick of ticks) labels.place(tick.x, tick.y, 7, beside(tick), withUnit(tick.time, unit, 10), style);
    const crowded = countSeen(projection, state.centers, state.later ?? state.now) > CROWD;
    return { gaps, ticks, every, labels: labels.placed, bar, crowded };
}
