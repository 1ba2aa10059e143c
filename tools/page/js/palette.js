// SPDX-License-Identifier: MIT
/**
 * The colours of all pictures, in light and in dark. They are those of `tdsp plot`, after Okabe and Ito, whom people of every colour
 * vision tell apart; where a colour of the plot is too pale for WCAG (4.5 : 1 for text, 3 : 1 for marks) the page has a darker one
 * of the same hue. tests/page/views_palette.test.js computes every contrast. No colour carries a meaning alone.
 *
 * @typedef {object} Palette
 * @property {"light"|"dark"} name
 * @property {string} paper behind everything
 * @property {string} ink text and ticks
 * @property {string} grey numbers on the axes, the frame
 * @property {string} grid
 * @property {string} disc what a disc covers now
 * @property {string} discEdge its edge
 * @property {string} later what discs cover at arrival
 * @property {string} laterEdge its edge
 * @property {string} path the path behind the robot, the robot, the curve
 * @property {string} ahead the path still to go
 * @property {string} pathText words about them
 * @property {string} tint the certified band
 * @property {string} other another departure: its path, its place on the curve
 * @property {string} otherText
 * @property {string} alarm jumps, closing gaps, the end
 * @property {string} alarmFaint a gap that is closed already
 * @property {string} alarmText
 * @property {string} focus the ring around what has the keyboard
 */

/** @type {Readonly<Palette>} */
export const light = Object.freeze({
    name: "light",
    paper: "#ffffff",
    ink: "#222222",
    grey: "#6b6b6b",
    grid: "#e9e9e9",
    disc: "#e69f00",
    discEdge: "#a87200",
    later: "#fbecc9",
    laterEdge: "#b07800",
    path: "#0072b2",
    ahead: "#4486b5",
    pathText: "#0069a5",
    tint: "#9fcbe6",
    other: "#9a4f80",
    otherText: "#8d4374",
    alarm: "#d55e00",
    alarmFaint: "#c97f4a",
    alarmText: "#b24a00",
    focus: "#222222",
});

/** @type {Readonly<Palette>} */
export const dark = Object.freeze({
    name: "dark",
    paper: "#12161c",
    ink: "#e8eaed",
    grey: "#a2abb5",
    grid: "#242b34",
    disc: "#c48600",
    discEdge: "#ffc14d",
    later: "#3b2e10",
    laterEdge: "#b58a2a",
    path: "#56b4e9",
    ahead: "#4289b5",
    pathText: "#6fc1f0",
    tint: "#1f4f6d",
    other: "#dd9cc4",
    otherText: "#e6aed0",
    alarm: "#ff8548",
    alarmFaint: "#b0653f",
    alarmText: "#ff9a66",
    focus: "#ffffff",
});

/** @param {"light"|"dark"|string} name */
export function paletteOf(name) {
    return name === "dark" ? dark : light;
}

/** @param {number} part of a colour, 0 to 255 */
function linear(part) {
    const share = part / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}

/** Relative luminance by WCAG 2. @param {string} colour "#rrggbb" */
function luminance(colour) {
    const value = parseInt(colour.slice(1), 16);
    return 0.2126 * linear(value >> 16) + 0.7152 * linear((value >> 8) & 255) + 0.0722 * linear(value & 255);
}

/**
 * Contrast by WCAG 2, from 1 to 21.
 * @param {string} one
 * @param {string} other
 */
export function contrast(one, other) {
    const a = luminance(one), b = luminance(other);
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
}
