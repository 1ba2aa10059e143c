// SPDX-License-Identifier: MIT
/**
 * Text in pictures: its font, and where its base line is. Both back ends (draw_canvas.js, draw_svg.js) go by it, so a label stands in
 * the exported SVG where it stands on the screen.
 *
 * @typedef {object} TextStyle
 * @property {number} size
 * @property {string} colour
 * @property {boolean} [bold]
 * @property {number} [across] 0 (default): the point is at the text's left end, 0.5: at its middle, 1: at its right end
 * @property {number} [up] 0 (default): at the base line, 0.5: at the middle of a digit, 1: at its top
 * @property {string} [halo] the colour around it, that lets it stand out from what is below
 */

export const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", "DejaVu Sans", Arial, sans-serif';
/** Size of ordinary text, in CSS pixels. */
export const TEXT = 13;
export const HALO = 5;
const DIGIT_HEIGHT = 0.73;

/** @param {TextStyle} style as the canvas wants it */
export function fontOf(style) {
    return `${style.bold ? "600 " : ""}${style.size}px ${FONT}`;
}

/**
 * The base line of text at y.
 * @param {TextStyle} style
 * @param {number} y
 */
export function baseOf(style, y) {
    return y + (style.up ?? 0) * DIGIT_HEIGHT * style.size;
}

/**
 * Where nothing measures text: the widths of the usual sans-serif, within some percent.
 * @param {string} text
 * @param {TextStyle} style
 */
export function guessedWidth(text, style) {
    let width = 0;
    for (const letter of text) width += /[ .,:;il|'()]/.test(letter) ? 0.34 : /[mwMW]/.test(letter) ? 0.88 : 0.6;
    return width * style.size * (style.bold ? 1.06 : 1);
}
