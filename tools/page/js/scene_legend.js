// SPDX-License-Identifier: MIT
/** The legend of a scene's picture. */
import { withUnit } from "tdsp/numbers.js";
import { drawGap } from "tdsp/scene_marks.js";

/** @typedef {import("tdsp/scene_picture.js").SceneState} SceneState */
/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */
/** @typedef {import("tdsp/draw_legend.js").LegendItem} LegendItem */

const RIDDEN = Object.freeze([3, 3]);
const OTHER = Object.freeze([7, 5]);

/**
 * @param {SceneState} state
 * @param {number} every time between ticks of the path, 0 without
 * @param {boolean} short in few words, where there is little room
 * @returns {LegendItem[]}
 */
export function legendOf(state, every, short) {
    const items = [], { count, legs, units } = state;
    if (count > 0) items.push({ kind: "now", wide: 14, text: state.still ? `discs at ${withUnit(state.time, units.time, 5)}` : "discs now" });
    if (count > 0 && state.later) items.push({ kind: "later", wide: 14, text: "at arrival" });
    if (legs.length > 0) items.push({ kind: "path", wide: 24, text: every > 0 && !short ? `path, a tick every ${withUnit(every, units.time)}` : "path" });
    if (legs.some((leg) => leg.ride)) items.push({ kind: "ridden", wide: 24, text: short ? "ridden disc" : "ridden disc, as the ride begins" });
    if (state.jumps.length > 0) items.push({ kind: "gap", wide: 22, text: "gap that closes" });
    if (state.ghost.length > 0) items.push({ kind: "other", wide: 24, text: short ? "pointed at" : "path of the departure pointed at" });
    return items;
}

/** All that the legend of a scene can ever hold. @param {SceneState} state @param {number} every @param {boolean} short @returns {LegendItem[]} */
export function fullLegend(state, every, short) {
    const something = /** @type {any} */ ([{ ride: true }]);
    return legendOf({ ...state, later: state.now, legs: something, jumps: something, ghost: something }, every, short);
}

/** @param {Pen} pen @param {import("tdsp/palette.js").Palette} palette @param {string} kind */
export function drawSample(pen, palette, kind, x, y) {
    if (kind === "gap") {
        drawGap(pen, palette, x + 11, y, 0, false);
        return;
    }
    pen.begin();
    if (kind === "now" || kind === "later") {
        pen.disc(x + 7, y, 6);
        pen.fill(kind === "now" ? palette.disc : palette.later);
        pen.stroke(kind === "now" ? palette.discEdge : palette.laterEdge, 1);
        return;
    }
    pen.move(x, y);
    pen.line(x + 24, y);
    if (kind === "path") pen.stroke(palette.path, 3);
    if (kind === "ridden") pen.stroke(palette.path, 1, RIDDEN);
    if (kind === "other") pen.stroke(palette.other, 2, OTHER);
}
