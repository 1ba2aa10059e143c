// SPDX-License-Identifier: MIT
/**
 * Pictures on a canvas. A picture is a function that draws with a pen; the CanvasPen here and the SvgPen of draw_svg.js understand the
 * same strokes, so that screen and export cannot diverge. Nothing is allocated here while drawing.
 */
import { HALO, baseOf, fontOf } from "tdsp/draw_text.js";

/** @typedef {import("tdsp/draw_text.js").TextStyle} TextStyle */

const SOLID = Object.freeze([]);
const ROUND = 2 * Math.PI;

/**
 * What every pen does. Lengths are CSS pixels, y downwards.
 * @typedef {object} Pen
 * @property {(name: string) => void} part what follows belongs to the part of this name, until the next (a group in SVG)
 * @property {() => void} begin an empty outline
 * @property {(x: number, y: number) => void} move
 * @property {(x: number, y: number) => void} line
 * @property {() => void} close
 * @property {(x: number, y: number, radius: number) => void} disc a whole circle
 * @property {(x: number, y: number, width: number, height: number) => void} rect
 * @property {(colour: string) => void} fill what the outlines hold, overlaps once
 * @property {(colour: string, width: number, dashes?: readonly number[]) => void} stroke
 * @property {(colour: string, edge: string, width: number) => void} union fill, and an edge of half that width around it
 * @property {(outline: (wider: number) => void, colour: string, edge: string|null, width: number) => void} unionOf the same of outlines that
 *     `outline` adds: circles larger by `wider`, and whatever else; each closed. For thousands of them
 * @property {(x: number, y: number, text: string, style: TextStyle) => void} text
 * @property {(x: number, y: number, text: string, style: TextStyle) => void} textUpwards turned to read upwards
 * @property {(text: string, style: TextStyle) => number} width of a text
 * @property {(x: number, y: number, width: number, height: number) => void} clip until unclip(), not nested
 * @property {() => void} unclip
 */

/** @implements {Pen} */
export class CanvasPen {
    /** @param {CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D} context scaled to CSS pixels */
    constructor(context) {
        this.context = context;
        /** @type {Map<number, string>} by size, negative where bold */
        this.fonts = new Map();
        /** Every outline is filled as it is closed. */
        this.singly = false;
    }

    part() {}
    begin() { this.context.beginPath(); }
    line(x, y) { this.context.lineTo(x, y); }

    move(x, y) {
        if (this.singly) this.context.beginPath();
        this.context.moveTo(x, y);
    }

    close() {
        this.context.closePath();
        if (this.singly) this.context.fill();
    }

    rect(x, y, width, height) {
        if (this.singly) this.context.fillRect(x, y, width, height);
        else this.context.rect(x, y, width, height);
    }

    disc(x, y, radius) {
        this.move(x + radius, y);
        this.context.arc(x, y, radius, 0, ROUND);
        if (this.singly) this.context.fill();
    }

    fill(colour) {
        this.context.fillStyle = colour;
        this.context.fill();
    }

    stroke(colour, width, dashes = SOLID) {
        const context = this.context;
        context.strokeStyle = colour;
        context.lineWidth = width;
        context.lineCap = dashes.length > 0 ? "butt" : "round";
        context.lineJoin = "round";
        context.setLineDash(/** @type {number[]} */ (dashes));
        context.stroke();
    }

    union(colour, edge, width) {
        this.stroke(edge, width);
        this.fill(colour);
    }

    /**
     * One outline after the other: the colours are opaque, so that overlaps do not show, and a single circle is filled several times as fast as one
     * among thousands in one outline, whose crossings are looked for.
     */
    unionOf(outline, colour, edge, width) {
        this.singly = true;
        if (edge) this.context.fillStyle = edge;
        if (edge) outline(width / 2);
        this.context.fillStyle = colour;
        outline(0);
        this.singly = false;
    }

    /** A font is a long word to parse: said only when it changes, from words made once. @param {TextStyle} style */
    choose(style) {
        const key = style.bold ? -style.size : style.size;
        let font = this.fonts.get(key);
        if (!font) this.fonts.set(key, (font = fontOf(style)));
        if (this.font !== font) this.context.font = this.font = font;
    }

    width(text, style) {
        this.choose(style);
        return this.context.measureText(text).width;
    }

    text(x, y, text, style) {
        const context = this.context;
        this.choose(style);
        context.textAlign = "left";
        const left = style.across ? x - style.across * context.measureText(text).width : x;
        const base = baseOf(style, y);
        if (style.halo) {
            context.strokeStyle = style.halo;
            context.lineWidth = HALO;
            context.lineJoin = "round";
            context.setLineDash(/** @type {number[]} */ (SOLID));
            context.strokeText(text, left, base);
        }
        context.fillStyle = style.colour;
        context.fillText(text, left, base);
    }

    textUpwards(x, y, text, style) {
        const context = this.context;
        context.save();
        context.translate(x, y);
        context.rotate(-Math.PI / 2);
        this.text(0, 0, text, style);
        context.restore();
        this.font = "";
    }

    clip(x, y, width, height) {
        this.context.save();
        this.context.beginPath();
        this.context.rect(x, y, width, height);
        this.context.clip();
    }

    unclip() {
        this.context.restore();
        this.font = "";
    }
}
