// SPDX-License-Identifier: MIT
/**
 * A scene as a picture, for any pen. In two parts: the ground (paper, grid, what discs cover at arrival, axes, legend) changes with the
 * view and the scene only and is kept by the view; the rest changes with time.
 */
import { axesRoom, drawAxes, drawGrid, frameTicks, lengthAxis } from "tdsp/axes.js";
import { outlineDisc, outlineDiscs } from "tdsp/scene_discs.js";
import { beginsRide, positionAt } from "tdsp/scene_legs.js";
import { drawLegend, placeLegend } from "tdsp/draw_legend.js";
import { RIGHT, ROOMY } from "tdsp/scene_layout.js";
import { drawSample, legendOf } from "tdsp/scene_legend.js";
import { drawEnd, drawEndRing, drawGap, drawHandles, drawRobot, drawScaleBar, outlineTick } from "tdsp/scene_marks.js";
import { Tracer, traceLegs } from "tdsp/scene_trace.js";

/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */
/** @typedef {import("tdsp/scene_hit.js").Target} Target */

/**
 * Of a scene file, what its picture needs.
 * @typedef {object} Description
 * @property {string} [name]
 * @property {{speed: number, radius?: number}} robot
 * @property {[number, number]} source
 * @property {[number, number]} destination
 * @property {{center: [number, number], radius: number}[]} discs
 */

/**
 * All that a picture of a scene shows.
 * @typedef {object} SceneState
 * @property {Description} description
 * @property {number} count of discs
 * @property {import("tdsp/scene_discs.js").Centers} centers
 * @property {Float64Array} now radii at `time`, the robot's included
 * @property {Float64Array|null} later radii at arrival; null where there is none
 * @property {import("tdsp/scene_legs.js").Leg[]} legs of the path
 * @property {import("tdsp/scene_legs.js").Leg[]} ghost of another departure's
 * @property {{size?: number, gap: {first: number, second: number, time: number, place: [number, number]}|null}[]} jumps
 * @property {number} time
 * @property {{length: string, time: string}} units
 * @property {Target|null} selected
 * @property {Target|null} hover
 * @property {import("tdsp/palette.js").Palette} palette
 * @property {import("tdsp/scene_projection.js").Projection} projection
 * @property {import("tdsp/scene_layout.js").Layout} layout
 * @property {boolean} still a picture of one moment, not a moving one
 * @property {number} head pixels kept free above, for a title
 * @property {{width: number, height: number}|null} corner of the canvas, its top right one, that no label goes into: something else lies there
 */

const GHOST = Object.freeze([7, 5]);
const RIDDEN = Object.freeze([3, 3]);
const RING = Object.freeze([5, 3]);
const WIDE = 560;

/**
 * Where the window is on a canvas of this size, and the legend below it.
 * @param {SceneState} state
 * @param {number} width
 * @param {number} height
 * @param {Pen["width"]} measure
 */
export function arrangeScene(state, width, height, measure) {
    const { projection } = state, titled = width >= WIDE, top = 10 + state.head, right = RIGHT;
    const unit = state.units.length, range = projection.width / projection.scale;
    const axes = { x: lengthAxis("x", unit, range), y: lengthAxis("y", unit, range) };
    const room = axesRoom(frameTicks(projection.frame(), axes.x, axes.y, measure), titled);
    const items = legendOf(state, state.layout?.every ?? 0, width < ROOMY);
    const legend = placeLegend(items, width - room.left - right, measure);
    const below = room.bottom + (legend.height > 0 ? legend.height + 6 : 0);
    projection.place(room.left, top, width - room.left - right, height - top - below - 4);
    return { axes, titled, legend: legend.items, legendTop: height - legend.height - 4 };
}

/** @typedef {ReturnType<typeof arrangeScene>} Arrangement */

/** @param {Pen} pen @param {SceneState} state */
function clipWindow(pen, { projection }) {
    pen.clip(projection.left, projection.top, projection.width, projection.height);
}

/** @param {Pen} pen @param {SceneState} state @param {Arrangement} arrangement */
export function drawGround(pen, state, arrangement) {
    const { palette, projection } = state, frame = projection.frame();
    const ticks = frameTicks(frame, arrangement.axes.x, arrangement.axes.y, pen.width.bind(pen));
    drawGrid(pen, frame, ticks, palette);
    if (state.later) {
        clipWindow(pen, state);
        pen.part("discs-at-arrival");
        pen.unionOf((wider) => outlineDiscs(pen, projection, state.centers, state.later, wider), palette.later, palette.laterEdge, 2);
        pen.unclip();
    }
    const titles = arrangement.titled ? arrangement.axes : { x: null, y: null };
    drawAxes(pen, frame, ticks, titles, palette);
    drawLegend(pen, arrangement.legend, palette.ink, projection.left, arrangement.legendTop, (kind, x, y) => drawSample(pen, palette, kind, x, y));
}

const tracer = new Tracer();
const place = new Float64Array(2);

/** @param {Pen} pen @param {SceneState} state */
function drawDiscs(pen, state) {
    const { palette, projection } = state;
    pen.part("discs");
    const edge = state.layout.crowded ? null : palette.discEdge;
    pen.unionOf((wider) => outlineDiscs(pen, projection, state.centers, state.now, wider), palette.disc, edge, 1.6);
}

/** @param {Pen} pen @param {SceneState} state */
function drawRidden(pen, state) {
    const { palette, projection, legs } = state;
    pen.part("ridden-discs");
    pen.begin();
    for (let i = 0; i < legs.length; i++) {
        if (!beginsRide(legs, i)) continue;
        outlineDisc(pen, projection, projection.x(legs[i].centerX), projection.y(legs[i].centerY), legs[i].radiusFrom * projection.scale);
    }
    pen.stroke(palette.path, 1, RIDDEN);
}

/** @param {Pen} pen @param {SceneState} state */
function drawGhost(pen, state) {
    if (state.ghost.length === 0) return;
    pen.part("other-departure");
    pen.begin();
    tracer.begin(pen, state.projection);
    traceLegs(tracer, state.ghost, -Infinity, Infinity);
    pen.stroke(state.palette.paper, 5);
    pen.stroke(state.palette.other, 2, GHOST);
}

/** @param {Pen} pen @param {SceneState} state */
function tracePath(pen, state, from, until) {
    pen.begin();
    tracer.begin(pen, state.projection);
    traceLegs(tracer, state.legs, from, until);
}

/** Solid behind the robot, lighter and thinner ahead. @param {Pen} pen @param {SceneState} state */
function drawPath(pen, state) {
    const { palette, legs, layout } = state;
    if (legs.length === 0) return;
    pen.part("path");
    tracePath(pen, state, -Infinity, Infinity);
    pen.stroke(palette.paper, 6);
    pen.stroke(palette.ahead, 2);
    if (state.time > legs[0].start) {
        tracePath(pen, state, -Infinity, state.time);
        pen.stroke(palette.path, 3.2);
    }
    pen.begin();
    for (const tick of layout.ticks) outlineTick(pen, tick.x, tick.y, tick.ux, tick.uy);
    pen.stroke(palette.ink, 1.6);
}

/** @param {Pen} pen @param {SceneState} state */
function drawSelection(pen, state) {
    const { palette, projection, hover, selected } = state;
    for (const target of [hover, selected]) {
        if (!target || target.index < 0 || target.index >= state.count) continue;
        const x = projection.x(state.centers.x[target.index]), y = projection.y(state.centers.y[target.index]);
        const radius = state.now[target.index] * projection.scale;
        pen.begin();
        outlineDisc(pen, projection, x, y, Math.max(radius, 3));
        pen.stroke(palette.paper, 4.5);
        pen.stroke(palette.focus, 2, target === selected ? RING : undefined);
        if (target === selected) drawHandles(pen, palette, x, y, radius);
    }
}

/** @param {Pen} pen @param {SceneState} state */
function drawEnds(pen, state) {
    const { palette, projection, description } = state;
    pen.part("ends");
    for (const what of ["source", "destination"]) {
        const x = projection.x(description[what][0]), y = projection.y(description[what][1]);
        if (state.selected?.what === what || state.hover?.what === what) drawEndRing(pen, palette, x, y, state.selected?.what === what);
        drawEnd(pen, palette, x, y, what === "source");
    }
}

/** @param {Pen} pen @param {SceneState} state */
function drawGaps(pen, state) {
    pen.part("gaps");
    for (const gap of state.layout.gaps) drawGap(pen, state.palette, gap.x, gap.y, gap.direction, state.time >= gap.time);
}

/** @param {Pen} pen @param {SceneState} state */
function drawLabels(pen, state) {
    pen.part("labels");
    for (const label of state.layout.labels) {
        const past = state.time >= label.until;
        pen.text(label.x, label.y, past ? label.after : label.text, past ? label.afterStyle : label.style);
    }
}

/** @param {Pen} pen @param {SceneState} state */
function drawRobotNow(pen, state) {
    const { legs, projection, palette, time } = state;
    if (legs.length === 0) return;
    const start = legs[0].start, end = legs[legs.length - 1].end, around = (end - start) * 1e-4;
    positionAt(legs, time - around, place);
    const x0 = projection.x(place[0]), y0 = projection.y(place[1]);
    positionAt(legs, time + around, place);
    const dx = projection.x(place[0]) - x0, dy = projection.y(place[1]) - y0;
    positionAt(legs, time, place);
    const moving = time >= start && time < end && (dx !== 0 || dy !== 0);
    pen.part("robot");
    const radius = (state.description.robot.radius ?? 0) * projection.scale;
    drawRobot(pen, palette, projection.x(place[0]), projection.y(place[1]), moving ? Math.atan2(dy, dx) : NaN, radius);
}

/** What moves. @param {Pen} pen @param {SceneState} state */
export function drawLive(pen, state) {
    const { palette, projection } = state;
    clipWindow(pen, state);
    drawDiscs(pen, state);
    drawRidden(pen, state);
    drawGhost(pen, state);
    drawPath(pen, state);
    drawSelection(pen, state);
    drawGaps(pen, state);
    drawEnds(pen, state);
    drawLabels(pen, state);
    drawRobotNow(pen, state);
    pen.part("scale");
    drawScaleBar(pen, palette, state.layout.bar, projection.left + projection.width - 14, projection.top + projection.height - 12);
    pen.unclip();
}
