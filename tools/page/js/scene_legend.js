// SPDX-License-Identifier: MIT
/** The legend of a scene's picture. */
import { withUnit } from "tdsp/numbers.js";
import { drawGap } from "tdsp/scene_marks.js";

/** @typedef {import("tdsp/scene_picture.js").SceneState} SceneState */
/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */
/** @typedef {import("tdsp/draw_legend.js").LegendItem} LegendItem */

const RIDDEN = Object.freeze([3, 3]);

/**
 * What a picture that moves may show is always named, lest the window change its size while things come and go; in a still one only what it shows.
 * @param {SceneState} state
 * @param {number} every time between ticks of the path, 0 without
 * @param {boolean} short in few words, where there is little room; ticks then carry their unit
 * @returns {LegendItem[]}
 */
export function legendOf(state, every, short) {
    const items = [], { count, legs, units, still } = state;
    if (count > 0) items.push({ kind: "now", wide: 14, text: still ? `discs at ${withUnit(state.time, units.time, 5)}` : "discs now" });
    if (count > 0 && (!still || state.later)) items.push({ kind: "later", wide: 14, text: "at arrival" });
    if (!still || legs.length > 0) items.push(short ? { kind: "path", wide: 24, text: "path" } : pathItem(every, units.time));
    if (legs.some((leg) => leg.ride) || (!still && count > 0)) items.push({ kind: "ridden", wide: 24, text: short ? "ridden disc" : "ridden disc, as the ride begins" });
    if (still ? state.jumps.length > 0 : count > 0) items.push({ kind: "gap", wide: 22, text: short ? "closing gap" : "gap that closes" });
    return items;
}

/** @param {number} every @param {string} unit @returns {LegendItem} */
function pathItem(every, unit) {
    return { kind: "path", wide: 24, text: every > 0 ? `path, a tick every ${withUnit(every, unit)}` : "path", room: `path, a tick every ${withUnit(5000, unit)}` };
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
}
