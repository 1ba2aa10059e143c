// SPDX-License-Identifier: MIT
/** A curve as an SVG file: the same picture as on the screen, with a title and without what a person points at. */
import { curveOf, curveWindow } from "tdsp/curve_data.js";
import { arrangeCurve, layoutCurve } from "tdsp/curve_layout.js";
import { drawCurveGround, drawCurveLive } from "tdsp/curve_picture.js";
import { SvgPen } from "tdsp/draw_svg.js";
import { guessedWidth } from "tdsp/draw_text.js";

/** @typedef {import("tdsp/curve_picture.js").CurveState} CurveState */
/** @typedef {import("tdsp/palette.js").Palette} Palette */

/** A picture of nothing. @param {Palette} palette @returns {CurveState} */
export function blankCurve(palette) {
    const curve = curveOf(null, [], null);
    return {
        curve, stored: false, sampled: false, rows: null, jumps: [], bends: [], last: null, travel: () => NaN, departure: null, hover: null, deadline: null, leaveBy: null, mode: "travel", units: { time: "" },
        window: curveWindow(curve, null, "travel", null), palette, message: "", head: 0, still: false, grabbed: false,
    };
}

/**
 * A curve as an SVG file, without a browser where `measure` is left out.
 * @param {CurveState} state
 * @param {{width: number, height: number, title?: string, description?: string, palette?: Palette}} page
 * @param {import("tdsp/draw_canvas.js").Pen["width"]} [measure]
 */
export function curveSvg(state, page, measure = guessedWidth) {
    const pen = new SvgPen(measure), title = page.title ?? (state.mode === "arrival" ? "Earliest arrival" : "Travel time");
    /** @type {CurveState} */
    const still = { ...state, palette: page.palette ?? state.palette, hover: null, still: true, head: 58 };
    const arrangement = arrangeCurve(still, page.width, page.height, measure), layout = layoutCurve(still, arrangement, measure);
    pen.part("title");
    pen.text(arrangement.frame.left, 30, title, { size: 18, bold: true, colour: still.palette.ink });
    pen.text(arrangement.frame.left, 50, page.description ?? "", { size: 13, colour: still.palette.grey });
    drawCurveGround(pen, still, arrangement, layout);
    drawCurveLive(pen, still, arrangement, layout);
    return pen.document({ width: page.width, height: page.height, title, description: page.description ?? title, paper: still.palette.paper });
}
