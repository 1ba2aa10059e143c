// SPDX-License-Identifier: MIT
/**
 * Thousands of discs as one outline: what is outside of the window is left out, a disc under half a pixel is a pixel, and of a disc much
 * larger than the window only the part of its edge that can be seen is made, because a canvas counts in single precision.
 */

/** @typedef {import("tdsp/scene_projection.js").Projection} Projection */
/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */

const DOT = 0.5; // pixels of radius: no disc is smaller
const SQUARE = 1.2; // and smaller ones are squares
const HUGE = 3; // sides of the window
const EXACT = 0.2; // pixels between a huge disc's edge and its chords

/**
 * Centres in two arrays, so that no disc is an object to be looked up while drawing.
 * @param {{center: [number, number]}[]} discs
 */
export function centersOf(discs) {
    const x = new Float64Array(discs.length), y = new Float64Array(discs.length);
    for (let i = 0; i < discs.length; i++) [x[i], y[i]] = discs[i].center;
    return { x, y };
}

/** @typedef {ReturnType<typeof centersOf>} Centers */

/** Can a disc of this place and radius on the screen be seen? @param {Projection} projection */
function isSeen({ left, top, width, height }, x, y, radius) {
    return x + radius >= left - 1 && x - radius <= left + width + 1 && y + radius >= top - 1 && y - radius <= top + height + 1;
}

/**
 * How many discs can be seen.
 * @param {Projection} projection
 * @param {Centers} centers
 * @param {Float64Array} radii in the scene's unit, the robot's radius included
 */
export function countSeen(projection, centers, radii) {
    let seen = 0;
    for (let i = 0; i < radii.length; i++)
        if (isSeen(projection, projection.x(centers.x[i]), projection.y(centers.y[i]), radii[i] * projection.scale)) seen++;
    return seen;
}

/**
 * Add the outlines of all discs that can be seen to the pen's.
 * @param {Pen} pen begun
 * @param {Projection} projection
 * @param {Centers} centers
 * @param {Float64Array} radii in the scene's unit, the robot's radius included
 * @param {number} [wider] pixels that are added to each
 */
export function outlineDiscs(pen, projection, centers, radii, wider = 0) {
    for (let i = 0; i < radii.length; i++) {
        const x = projection.x(centers.x[i]), y = projection.y(centers.y[i]), radius = radii[i] * projection.scale + wider;
        if (isSeen(projection, x, y, radius)) outlineDisc(pen, projection, x, y, radius);
    }
}

/** One disc, in pixels. @param {Pen} pen begun @param {Projection} projection */
export function outlineDisc(pen, projection, x, y, radius) {
    const half = Math.max(DOT, radius);
    if (radius < SQUARE) pen.rect(x - half, y - half, 2 * half, 2 * half);
    else if (radius < HUGE * (projection.width + projection.height)) pen.disc(x, y, radius);
    else outlineHuge(pen, projection, x, y, radius);
}

/**
 * The part of a huge disc in and around the window: its edge seen from its centre within twice the angle of the window, closed far
 * behind the edge; the whole window where no edge is near.
 */
function outlineHuge(pen, projection, x, y, radius) {
    const { left, top, width, height } = projection;
    const reach = Math.hypot(width, height) / 2 + 2;
    const dx = left + width / 2 - x, dy = top + height / 2 - y, distance = Math.hypot(dx, dy);
    if (distance - reach > radius) return;
    if (distance + reach < radius) {
        pen.rect(left - 4, top - 4, width + 8, height + 8);
        return;
    }
    const toward = Math.atan2(dy, dx), half = 2 * Math.asin(Math.min(1, reach / distance));
    const steps = Math.ceil((2 * half) / Math.sqrt((8 * EXACT) / radius));
    for (let i = 0; i <= steps; i++) {
        const angle = toward - half + (2 * half * i) / steps;
        const px = x + radius * Math.cos(angle), py = y + radius * Math.sin(angle);
        if (i === 0) pen.move(px, py);
        else pen.line(px, py);
    }
    const behind = radius - 4 * reach;
    pen.line(x + behind * Math.cos(toward + half), y + behind * Math.sin(toward + half));
    pen.line(x + behind * Math.cos(toward - half), y + behind * Math.sin(toward - half));
    pen.close();
}
