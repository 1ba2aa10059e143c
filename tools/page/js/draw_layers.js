// SPDX-License-Identifier: MIT
/**
 * A canvas as large as it is shown, sharp on every screen, and a hidden second one that keeps what seldom changes. Drawing happens once
 * a frame at most, and only when something has changed.
 */
import { CanvasPen } from "tdsp/draw_canvas.js";

/** @returns {HTMLCanvasElement|OffscreenCanvas} */
function hiddenCanvas() {
    return typeof OffscreenCanvas === "undefined" ? document.createElement("canvas") : new OffscreenCanvas(1, 1);
}

export class Layers {
    /**
     * @param {HTMLCanvasElement} canvas sized by CSS
     * @param {() => void} draw draws whatever has changed
     */
    constructor(canvas, draw) {
        this.canvas = canvas;
        this.kept = hiddenCanvas();
        this.pen = new CanvasPen(canvas.getContext("2d"));
        this.keptPen = new CanvasPen(/** @type {any} */ (this.kept.getContext("2d")));
        this.width = this.height = this.ratio = 0;
        this.frame = 0;
        this.run = () => {
            this.frame = 0;
            draw();
        };
        /** The canvas may have another size than is known: to ask for it makes the browser lay out the page, so that is not done in every frame. */
        this.resized = true;
        // Drawn at once: the browser is about to paint, and would stretch the old picture.
        this.observer = new ResizeObserver(() => {
            this.resized = true;
            draw();
        });
        this.observer.observe(canvas);
    }

    /** Draw with the next frame. */
    ask() {
        if (this.frame === 0) this.frame = requestAnimationFrame(this.run);
    }

    /** Take the size that the canvas has now. @returns {boolean} whether it is another one */
    fitSize() {
        const ratio = globalThis.devicePixelRatio || 1;
        if (!this.resized && ratio === this.ratio) return false;
        const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
        this.resized = width === 0;
        if (width === this.width && height === this.height && ratio === this.ratio) return false;
        Object.assign(this, { width, height, ratio });
        for (const canvas of [this.canvas, this.kept]) {
            canvas.width = Math.max(1, Math.round(width * ratio));
            canvas.height = Math.max(1, Math.round(height * ratio));
        }
        for (const pen of [this.pen, this.keptPen]) {
            pen.context.setTransform(ratio, 0, 0, ratio, 0, 0);
            pen.font = "";
        }
        return true;
    }

    /** The hidden canvas, blank. @param {string} paper */
    blankKept(paper) {
        this.keptPen.context.fillStyle = paper;
        this.keptPen.context.fillRect(0, 0, this.width, this.height);
        return this.keptPen;
    }

    /** The shown canvas, with what the hidden one keeps on it. */
    copyKept() {
        const { context } = this.pen;
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.drawImage(/** @type {any} */ (this.kept), 0, 0);
        context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
        return this.pen;
    }
}
