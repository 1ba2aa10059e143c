// SPDX-License-Identifier: MIT
/**
 * The marks of a scene: ends, robot, closing gaps, ticks along the path, handles, the scale bar. Each is told apart by its shape, not by
 * its colour alone: the source is full, the destination a ring; a gap that is open is two triangles facing each other, one that is
 * closed has them touch.
 */
import { number } from "tdsp/numbers.js";

/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */
/** @typedef {import("tdsp/palette.js").Palette} Palette */

export const END_RADIUS = 8;
export const GAP_REACH = 13;
const TICK_HALF = 5;
const RING = 15;
/** Its radius, where its own is smaller. */
export const ROBOT = 7;
const NOSE = 1.75; // of the robot's radius

/** @param {Pen} pen @param {Palette} palette @param {boolean} filled the source */
export function drawEnd(pen, palette, x, y, filled) {
    pen.begin();
    pen.disc(x, y, END_RADIUS);
    pen.fill(filled ? palette.path : palette.paper);
    pen.stroke(filled ? palette.paper : palette.path, filled ? 2 : 3.5);
}

const FOCUS_DASHES = [4, 3];

/** Around an end: hovered a ring, selected a dashed one. @param {Pen} pen @param {Palette} palette */
export function drawEndRing(pen, palette, x, y, selected) {
    pen.begin();
    pen.disc(x, y, RING);
    pen.stroke(palette.paper, 5);
    pen.stroke(palette.focus, 2, selected ? FOCUS_DASHES : undefined);
}

/**
 * The robot: a disc as large as it is, but never too small to be seen, with a nose where it is going.
 * @param {Pen} pen
 * @param {Palette} palette
 * @param {number} direction on the screen; NaN where it stands
 * @param {number} radius of the robot, pixels
 */
export function drawRobot(pen, palette, x, y, direction, radius) {
    const r = Math.max(ROBOT, radius);
    pen.begin();
    pen.disc(x, y, r);
    if (!Number.isNaN(direction)) outlineNose(pen, x, y, direction, r);
    pen.union(palette.path, palette.paper, 4);
    pen.begin();
    pen.disc(x, y, r * 0.36);
    pen.fill(palette.paper);
}

/** A triangle tangent to the robot's edge, turned as discs are, so that both are one. */
function outlineNose(pen, x, y, direction, r) {
    const wide = Math.acos(1 / NOSE);
    pen.move(x + r * NOSE * Math.cos(direction), y + r * NOSE * Math.sin(direction));
    pen.line(x + r * Math.cos(direction + wide), y + r * Math.sin(direction + wide));
    pen.line(x + r * Math.cos(direction - wide), y + r * Math.sin(direction - wide));
    pen.close();
}

/** A triangle whose tip is `from` away from the gap along a direction. */
function triangle(pen, x, y, ux, uy, from) {
    const back = from + 9;
    pen.move(x + ux * from, y + uy * from);
    pen.line(x + ux * back - uy * 5.5, y + uy * back + ux * 5.5);
    pen.line(x + ux * back + uy * 5.5, y + uy * back - ux * 5.5);
    pen.close();
}

/**
 * A gap between two discs, pinched along the line of their centres.
 * @param {Pen} pen
 * @param {Palette} palette
 * @param {number} direction of that line on the screen
 * @param {boolean} closed
 */
export function drawGap(pen, palette, x, y, direction, closed) {
    const ux = Math.cos(direction), uy = Math.sin(direction), from = closed ? 0 : 3.5;
    pen.begin();
    triangle(pen, x, y, ux, uy, from);
    triangle(pen, x, y, -ux, -uy, from);
    pen.union(closed ? palette.alarmFaint : palette.alarm, palette.paper, 4);
}

/** A tick across the path, which goes in direction (ux, uy). @param {Pen} pen begun */
export function outlineTick(pen, x, y, ux, uy) {
    pen.move(x - uy * TICK_HALF, y + ux * TICK_HALF);
    pen.line(x + uy * TICK_HALF, y - ux * TICK_HALF);
}

const HANDLE = 4;
const HELD = 14; // pixels of radius of a disc that has handles
const LONGER = 1.3; // times as long as asked for, at most

/** Something to hold a disc by, where it is not hidden by that: its centre, and four places of its rim. @param {Pen} pen @param {Palette} palette */
export function drawHandles(pen, palette, x, y, radius) {
    if (radius < HELD) return;
    pen.begin();
    pen.rect(x - HANDLE, y - HANDLE, 2 * HANDLE, 2 * HANDLE);
    for (let i = 0; i < 4; i++) {
        const px = x + radius * Math.cos((i * Math.PI) / 2), py = y + radius * Math.sin((i * Math.PI) / 2);
        pen.rect(px - HANDLE, py - HANDLE, 2 * HANDLE, 2 * HANDLE);
    }
    pen.fill(palette.paper);
    pen.stroke(palette.focus, 1.6);
}

/**
 * How long a scale bar is: 1, 2 or 5 of a power of ten.
 * @param {number} scale pixels for a unit of length
 * @param {import("tdsp/axes.js").Axis} axis
 * @param {number} pixels about as long as it may be
 */
export function scaleBar(scale, axis, pixels) {
    const most = (LONGER * pixels) / scale, power = 10 ** Math.floor(Math.log10(most));
    const step = power * ([5, 2].find((digit) => digit * power <= most) ?? 1);
    const shown = step / axis.divisor;
    return { pixels: step * scale, text: axis.unit ? `${number(shown)} ${axis.unit}` : number(shown) };
}

/** @param {Pen} pen @param {Palette} palette @param {{pixels: number, text: string}} bar @param {number} right @param {number} bottom */
export function drawScaleBar(pen, palette, bar, right, bottom) {
    const left = right - bar.pixels;
    pen.begin();
    pen.move(left, bottom - 5);
    pen.line(left, bottom);
    pen.line(right, bottom);
    pen.line(right, bottom - 5);
    pen.stroke(palette.paper, 5);
    pen.stroke(palette.ink, 1.6);
    pen.text((left + right) / 2, bottom - 6, bar.text, { size: 12, colour: palette.ink, across: 0.5, halo: palette.paper });
}
