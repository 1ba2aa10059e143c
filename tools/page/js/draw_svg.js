// SPDX-License-Identifier: MIT
/**
 * Pictures as SVG: the pen that writes what CanvasPen paints, for files that stand alone. Parts become groups; lengths are rounded to
 * hundredths of a pixel; an outline is written once, with fill and stroke on one element where it can be.
 */
import { FONT, HALO, baseOf, guessedWidth } from "tdsp/draw_text.js";

/** @typedef {import("tdsp/draw_text.js").TextStyle} TextStyle */
/** @typedef {import("tdsp/draw_canvas.js").Pen} Pen */

const ENTITIES = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };

/** @param {string} text */
function escaped(text) {
    return text.replace(/[&<>"]/g, (letter) => ENTITIES[letter]);
}

/** @param {number} value */
function short(value) {
    return String(Math.round(value * 100) / 100 || 0);
}

/** @implements {Pen} */
export class SvgPen {
    /** @param {(text: string, style: TextStyle) => number} [measure] how wide texts are; a guess where nothing measures */
    constructor(measure = guessedWidth) {
        this.width = measure;
        /** @type {string[]} */
        this.elements = [];
        this.outline = "";
        this.clips = 0;
        this.group = false;
    }

    part(name) {
        this.endPart();
        this.elements.push(`<g class="${escaped(name)}">`);
        this.group = true;
    }

    endPart() {
        if (this.group) this.elements.push("</g>");
        this.group = false;
    }

    begin() { this.outline = ""; }
    move(x, y) { this.outline += `M${short(x)} ${short(y)}`; }
    line(x, y) { this.outline += `L${short(x)} ${short(y)}`; }
    close() { this.outline += "Z"; }
    rect(x, y, width, height) { this.outline += `M${short(x)} ${short(y)}h${short(width)}v${short(height)}h${short(-width)}Z`; }

    disc(x, y, radius) {
        const r = short(radius), across = short(2 * radius), back = short(-2 * radius);
        this.outline += `M${short(x - radius)} ${short(y)}a${r} ${r} 0 1 1 ${across} 0a${r} ${r} 0 1 1 ${back} 0Z`;
    }

    /** @param {string} attributes */
    path(attributes) {
        if (this.outline) this.elements.push(`<path d="${this.outline}" ${attributes}/>`);
    }

    fill(colour) {
        this.path(`fill="${colour}"`);
    }

    stroke(colour, width, dashes = []) {
        const dashed = dashes.length > 0 ? ` stroke-dasharray="${dashes.join(" ")}"` : ' stroke-linecap="round"';
        this.path(`fill="none" stroke="${colour}" stroke-width="${short(width)}" stroke-linejoin="round"${dashed}`);
    }

    union(colour, edge, width) {
        this.path(`fill="${colour}" stroke="${edge}" stroke-width="${short(width)}" paint-order="stroke"`);
    }

    unionOf(outline, colour, edge, width) {
        this.begin();
        outline(0);
        if (edge) this.union(colour, edge, width);
        else this.fill(colour);
    }

    /** @param {TextStyle} style */
    words(style) {
        const anchor = style.across === 0.5 ? ' text-anchor="middle"' : style.across === 1 ? ' text-anchor="end"' : "";
        const weight = style.bold ? ' font-weight="600"' : "";
        const halo = style.halo ? ` stroke="${style.halo}" stroke-width="${HALO}" stroke-linejoin="round" paint-order="stroke"` : "";
        return `font-size="${short(style.size)}" fill="${style.colour}"${weight}${anchor}${halo}`;
    }

    text(x, y, text, style) {
        this.elements.push(`<text x="${short(x)}" y="${short(baseOf(style, y))}" ${this.words(style)}>${escaped(text)}</text>`);
    }

    textUpwards(x, y, text, style) {
        const turned = `transform="translate(${short(x)} ${short(y)}) rotate(-90)" y="${short(baseOf(style, 0))}"`;
        this.elements.push(`<text ${turned} ${this.words(style)}>${escaped(text)}</text>`);
    }

    clip(x, y, width, height) {
        this.endPart();
        const id = `clip${++this.clips}`;
        const shape = `<rect x="${short(x)}" y="${short(y)}" width="${short(width)}" height="${short(height)}"/>`;
        this.elements.push(`<clipPath id="${id}">${shape}</clipPath>`, `<g clip-path="url(#${id})">`);
    }

    unclip() {
        this.endPart();
        this.elements.push("</g>");
    }

    /**
     * The whole file.
     * @param {{width: number, height: number, title: string, description: string, paper: string}} page
     */
    document({ width, height, title, description, paper }) {
        this.endPart();
        const size = `width="${short(width)}" height="${short(height)}" viewBox="0 0 ${short(width)} ${short(height)}"`;
        return [
            `<svg xmlns="http://www.w3.org/2000/svg" ${size} role="img" aria-labelledby="title desc" font-family="${escaped(FONT)}">`,
            `<title id="title">${escaped(title)}</title>`,
            `<desc id="desc">${escaped(description)}</desc>`,
            `<rect width="100%" height="100%" fill="${paper}"/>`,
            ...this.elements,
            "</svg>",
            "",
        ].join("\n");
    }
}
