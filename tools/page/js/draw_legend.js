// SPDX-License-Identifier: MIT
/**
 * What is what in a picture: a sample and some words each, from left to right, in as many lines as they need.
 */
import { TEXT } from "tdsp/draw_text.js";

/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */
/** @typedef {{kind: string, wide: number, text: string, room?: string}} LegendItem `wide`: of the sample; `room`: the longest text there may be */
/** @typedef {LegendItem & {x: number, line: number}} PlacedItem */

const LINE = 22;
const WORDS = 7;
const APART = 18;

/**
 * @param {LegendItem[]} items
 * @param {number} width
 * @param {Pen["width"]} measure
 * @returns {{items: PlacedItem[], height: number}}
 */
export function placeLegend(items, width, measure) {
    let x = 0, line = 0;
    const placed = items.map((item) => {
        const wide = item.wide + WORDS + measure(item.room ?? item.text, { size: TEXT, colour: "" });
        if (x > 0 && x + wide > width) [x, line] = [0, line + 1];
        const at = { ...item, x, line };
        x += wide + APART;
        return at;
    });
    return { items: placed, height: placed.length > 0 ? (line + 1) * LINE : 0 };
}

/**
 * @param {Pen} pen
 * @param {PlacedItem[]} items
 * @param {string} ink
 * @param {number} left
 * @param {number} top
 * @param {(kind: string, x: number, y: number) => void} sample draws it from x on, around y
 */
export function drawLegend(pen, items, ink, left, top, sample) {
    if (items.length === 0) return;
    pen.part("legend");
    for (const item of items) {
        const y = top + item.line * LINE + LINE / 2;
        sample(item.kind, left + item.x, y);
        pen.text(left + item.x + item.wide + WORDS, y, item.text, { size: TEXT, colour: ink, up: 0.5 });
    }
}
