// SPDX-License-Identifier: MIT
/** A scene as an SVG file: the same picture as on the screen, of one moment, with a title and without what a person points at. */
import { SvgPen } from "tdsp/draw_svg.js";
import { guessedWidth } from "tdsp/draw_text.js";
import { centersOf } from "tdsp/scene_discs.js";
import { layoutScene } from "tdsp/scene_layout.js";
import { arrangeScene, drawGround, drawLive } from "tdsp/scene_picture.js";
import { Projection } from "tdsp/scene_projection.js";

/** @typedef {import("tdsp/scene_picture.js").SceneState} SceneState */
/** @typedef {import("tdsp/palette.js").Palette} Palette */

/** A description of nothing. @type {any} */
export const BLANK = Object.freeze({ robot: { speed: 1 }, source: [0, 0], destination: [1, 0], discs: [] });

/** A picture of nothing. @param {Palette} palette @returns {SceneState} */
export function blankScene(palette) {
    return {
        description: BLANK, count: 0, centers: centersOf([]), now: new Float64Array(0), later: null, legs: [], ghost: [], jumps: [], time: 0,
        units: { length: "", time: "" }, selected: null, hover: null, palette, projection: new Projection(), layout: null, still: false, head: 0, corner: null,
    };
}

/**
 * A scene as an SVG file, without a browser where `measure` is left out.
 * @param {SceneState} state
 * @param {{width: number, height: number, title?: string, description?: string, palette?: Palette}} page
 * @param {import("tdsp/draw_canvas.js").Pen["width"]} [measure]
 */
export function sceneSvg(state, page, measure = guessedWidth) {
    const pen = new SvgPen(measure), title = page.title ?? state.description.name ?? "Scene";
    const projection = Object.assign(new Projection(), state.projection), middle = { width: projection.width, height: projection.height };
    /** @type {SceneState} */
    const still = { ...state, projection, palette: page.palette ?? state.palette, still: true, ghost: [], hover: null, selected: null, head: 58, corner: null };
    arrangeScene(still, page.width, page.height, measure);
    projection.scale *= Math.min(projection.width / middle.width, projection.height / middle.height);
    still.layout = layoutScene(still, measure);
    const arrangement = arrangeScene(still, page.width, page.height, measure);
    const { palette } = still;
    pen.part("title");
    pen.text(projection.left, 30, title, { size: 18, bold: true, colour: palette.ink });
    pen.text(projection.left, 50, page.description ?? "", { size: 13, colour: palette.grey });
    drawGround(pen, still, arrangement);
    drawLive(pen, still);
    return pen.document({ width: page.width, height: page.height, title, description: page.description ?? title, paper: palette.paper });
}
