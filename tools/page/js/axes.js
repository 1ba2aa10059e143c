// SPDX-License-Identifier: MIT
/**
 * Ticks, grids and axes, by the rules of `tdsp plot`: steps of 1, 2 and 5, about 95 pixels apart, closer where the window is small;
 * metres become kilometres where there are many.
 */
import { TEXT } from "tdsp/draw_text.js";
import { digitsFor, number } from "tdsp/numbers.js";

/** @typedef {import("tdsp/palette.js").Palette} Palette */
/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */

/**
 * A window of the plane on the screen. y grows upwards in the plane and downwards on the screen.
 * @typedef {object} Frame
 * @property {number} left of the window, CSS pixels
 * @property {number} top
 * @property {number} width
 * @property {number} height
 * @property {number} xLow what it shows
 * @property {number} xHigh
 * @property {number} yLow
 * @property {number} yHigh
 */

/** @typedef {{name: string, unit: string, divisor: number}} Axis shown is value / divisor, in `unit` */
/** @typedef {{value: number, text: string}} Tick */

const SPACING = 95;
const LENGTH = 5;
const MOST_TICKS = 1000;
const KILOMETRES_FROM = 5000;

/**
 * A step of 1, 2 or 5 times a power of ten that cuts `range` into about so many pieces.
 * @param {number} range over 0
 * @param {number} pieces
 */
export function niceStep(range, pieces) {
    const rough = range / pieces, power = 10 ** Math.floor(Math.log10(rough));
    const share = rough / power;
    return power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
}

/**
 * The ticks of a range.
 * @param {number} low
 * @param {number} high over low
 * @param {number} pixels how long the axis is
 * @param {Axis} axis
 * @param {number} [spacing] pixels between ticks, about
 * @returns {Tick[]}
 */
export function ticksOf(low, high, pixels, axis, spacing = SPACING) {
    if (!(high > low) || !(pixels > 0)) return [];
    const step = niceStep(high - low, Math.max(2, pixels / spacing));
    // Counted: adding 1 to a multiple that is large enough changes nothing.
    const ticks = [], first = Math.ceil(low / step - 1e-9), count = Math.min(MOST_TICKS, Math.floor(high / step + 1e-9) - first + 1);
    for (let i = 0; i < count; i++) {
        const value = (first + i) * step, shown = value / axis.divisor;
        ticks.push({ value, text: number(shown === 0 ? 0 : shown, digitsFor(shown, step / axis.divisor, 10)) });
    }
    return ticks;
}

/** @param {string} name @param {string} unit @param {number} range what the window shows @returns {Axis} */
export function lengthAxis(name, unit, range) {
    const kilometres = unit === "m" && range >= KILOMETRES_FROM;
    return { name, unit: kilometres ? "km" : unit, divisor: kilometres ? 1000 : 1 };
}

/** @param {Axis} axis */
function axisTitle(axis) {
    return axis.unit ? `${axis.name} (${axis.unit})` : axis.name;
}

/** @param {Frame} frame @param {number} x */
export function frameX(frame, x) {
    return frame.left + ((x - frame.xLow) / (frame.xHigh - frame.xLow)) * frame.width;
}

/** @param {Frame} frame @param {number} y */
export function frameY(frame, y) {
    return frame.top + ((frame.yHigh - y) / (frame.yHigh - frame.yLow)) * frame.height;
}

/**
 * Ticks of both axes. Those of x keep their numbers apart.
 * @param {Frame} frame
 * @param {Axis} x
 * @param {Axis} y
 * @param {Pen["width"]} measure
 */
export function frameTicks(frame, x, y, measure) {
    const style = { size: TEXT, colour: "" };
    const widest = (ticks) => ticks.reduce((most, tick) => Math.max(most, measure(tick.text, style)), 0);
    let spacing = frame.width < 480 ? 70 : SPACING;
    let across = ticksOf(frame.xLow, frame.xHigh, frame.width, x, spacing);
    while (across.length > 1 && widest(across) + 8 > frame.width / ((frame.xHigh - frame.xLow) / (across[1].value - across[0].value))) {
        across = ticksOf(frame.xLow, frame.xHigh, frame.width, x, (spacing *= 1.5));
        if (spacing > 2000) break;
    }
    const upwards = ticksOf(frame.yLow, frame.yHigh, frame.height, y, frame.height < 300 ? 55 : SPACING);
    return { x: across, y: upwards, widest: widest(upwards) };
}

/** @typedef {ReturnType<typeof frameTicks>} FrameTicks */

/** @param {Pen} pen @param {Frame} frame @param {FrameTicks} ticks @param {Palette} palette */
export function drawGrid(pen, frame, ticks, palette) {
    const right = frame.left + frame.width, bottom = frame.top + frame.height;
    pen.part("grid");
    pen.begin();
    for (const tick of ticks.x) {
        pen.move(frameX(frame, tick.value), frame.top);
        pen.line(frameX(frame, tick.value), bottom);
    }
    for (const tick of ticks.y) {
        pen.move(frame.left, frameY(frame, tick.value));
        pen.line(right, frameY(frame, tick.value));
    }
    pen.stroke(palette.grid, 1);
}

/** @param {Pen} pen @param {Frame} frame @param {FrameTicks} ticks @param {Palette} palette */
function drawTicks(pen, frame, ticks, palette) {
    const bottom = frame.top + frame.height;
    const across = { size: TEXT, colour: palette.grey, across: 0.5, up: 1 }, upwards = { size: TEXT, colour: palette.grey, across: 1, up: 0.5 };
    pen.begin();
    for (const tick of ticks.x) {
        pen.move(frameX(frame, tick.value), bottom);
        pen.line(frameX(frame, tick.value), bottom + LENGTH);
    }
    for (const tick of ticks.y) {
        pen.move(frame.left - LENGTH, frameY(frame, tick.value));
        pen.line(frame.left, frameY(frame, tick.value));
    }
    pen.rect(frame.left, frame.top, frame.width, frame.height);
    pen.stroke(palette.grey, 1);
    for (const tick of ticks.x) pen.text(frameX(frame, tick.value), bottom + LENGTH + 5, tick.text, across);
    for (const tick of ticks.y) pen.text(frame.left - LENGTH - 4, frameY(frame, tick.value), tick.text, upwards);
}

/**
 * The frame, ticks, numbers and titles; a title whose axis has no name is left out.
 * @param {Pen} pen
 * @param {Frame} frame
 * @param {FrameTicks} ticks
 * @param {{x: Axis|null, y: Axis|null}} axes
 * @param {Palette} palette
 */
export function drawAxes(pen, frame, ticks, axes, palette) {
    pen.part("axes");
    drawTicks(pen, frame, ticks, palette);
    const middleX = frame.left + frame.width / 2, middleY = frame.top + frame.height / 2;
    if (axes.x) pen.text(middleX, frame.top + frame.height + 28, axisTitle(axes.x), { size: TEXT, colour: palette.ink, across: 0.5, up: 1 });
    if (axes.y) pen.textUpwards(frame.left - LENGTH - 14 - ticks.widest, middleY, axisTitle(axes.y), { size: TEXT, colour: palette.ink, across: 0.5 });
}

/** The room that axes need left of a frame and below it. @param {FrameTicks|null} ticks @param {boolean} titled */
export function axesRoom(ticks, titled) {
    const numbers = LENGTH + 8 + (ticks ? ticks.widest : 34);
    return { left: Math.ceil(numbers + (titled ? 22 : 0)), bottom: LENGTH + 5 + 14 + (titled ? 22 : 0) };
}
