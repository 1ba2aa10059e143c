// SPDX-License-Identifier: MIT
/**
 * Where the plane meets the screen. One scale in both directions; y grows upwards in the plane, downwards on the screen. Everything is
 * taken relative to the plane's point in the middle of the window before it is scaled, so that places around 10^6 keep their precision
 * however near the view comes.
 */

/** @typedef {[number, number]} Point */
/** @typedef {{xLow: number, xHigh: number, yLow: number, yHigh: number}} Extent */

const LEAST_SHARE = 1 / 200; // of the fitting scale
const MOST_SHARE = 1e6;
const MARGIN = 0.05;
const FAR = 1.5; // discs count for the view up to so many lengths of the journey away

export class Projection {
    constructor() {
        this.left = this.top = 0;
        this.width = this.height = 1;
        this.centerX = this.centerY = 0;
        /** Pixels for a unit of length. */
        this.scale = 1;
        this.fitting = 1;
    }

    /** @param {number} x */
    x(x) { return this.left + this.width / 2 + (x - this.centerX) * this.scale; }
    /** @param {number} y */
    y(y) { return this.top + this.height / 2 - (y - this.centerY) * this.scale; }
    /** @param {number} x on the screen */
    worldX(x) { return this.centerX + (x - this.left - this.width / 2) / this.scale; }
    /** @param {number} y on the screen */
    worldY(y) { return this.centerY - (y - this.top - this.height / 2) / this.scale; }

    /** The window as axes.js wants it. @returns {import("tdsp/axes.js").Frame} */
    frame() {
        const { left, top, width, height } = this;
        const halfX = width / this.scale / 2, halfY = height / this.scale / 2;
        const xLow = this.centerX - halfX, yLow = this.centerY - halfY;
        return { left, top, width, height, xLow, xHigh: this.centerX + halfX, yLow, yHigh: this.centerY + halfY };
    }

    /** Is a pixel in the window? @param {number} x @param {number} y */
    holds(x, y) {
        return x >= this.left && x <= this.left + this.width && y >= this.top && y <= this.top + this.height;
    }

    /** The window's place on the screen; what is in its middle stays there. */
    place(left, top, width, height) {
        [this.left, this.top] = [left, top];
        [this.width, this.height] = [Math.max(1, width), Math.max(1, height)];
    }

    /** Show all of an extent, with a margin. @param {Extent} extent */
    fit(extent) {
        const wide = extent.xHigh - extent.xLow || 1, high = extent.yHigh - extent.yLow || wide;
        this.centerX = (extent.xLow + extent.xHigh) / 2;
        this.centerY = (extent.yLow + extent.yHigh) / 2;
        this.scale = this.fitting = Math.min(this.width / wide, this.height / high);
    }

    /** Closer by `factor`, with what is at this pixel staying there. */
    zoomAt(x, y, factor) {
        const worldX = this.worldX(x), worldY = this.worldY(y);
        this.scale = Math.min(this.fitting * MOST_SHARE, Math.max(this.fitting * LEAST_SHARE, this.scale * factor));
        this.centerX += worldX - this.worldX(x);
        this.centerY += worldY - this.worldY(y);
    }

    /** Move what is seen by so many pixels. */
    pan(dx, dy) {
        this.centerX -= dx / this.scale;
        this.centerY += dy / this.scale;
    }
}

/** @param {Extent} extent */
function larger(extent) {
    return Math.max(extent.xHigh - extent.xLow, extent.yHigh - extent.yLow);
}

/** @param {Extent} extent */
function add(extent, x, y, around) {
    extent.xLow = Math.min(extent.xLow, x - around);
    extent.xHigh = Math.max(extent.xHigh, x + around);
    extent.yLow = Math.min(extent.yLow, y - around);
    extent.yHigh = Math.max(extent.yHigh, y + around);
}

/** @returns {Extent} */
function empty() {
    return { xLow: Infinity, xHigh: -Infinity, yLow: Infinity, yHigh: -Infinity };
}

/** Discs as far as `near` reaches, each no wider than the view it adds to. */
function addDiscs(extent, near, discs, radii) {
    for (let i = 0; i < discs.length; i++) {
        const [x, y] = discs[i].center, radius = radii[i];
        const xLow = Math.max(x - radius, near.xLow), yLow = Math.max(y - radius, near.yLow);
        const xHigh = Math.min(x + radius, near.xHigh), yHigh = Math.min(y + radius, near.yHigh);
        if (xLow > xHigh || yLow > yHigh) continue;
        add(extent, xLow, yLow, 0);
        add(extent, xHigh, yHigh, 0);
    }
}

/**
 * What a view of a scene shows at first, by the rule of `tdsp plot`: both ends, the path, and the discs at departure that are not far
 * from the journey.
 * @param {{source: Point, destination: Point, discs: {center: Point}[]}} description
 * @param {ArrayLike<number>} radii of the discs, then
 * @param {{from: Point, to: Point, center?: Point, radii?: [number, number]}[]} legs
 * @returns {Extent}
 */
export function sceneExtent(description, radii, legs) {
    const extent = empty(), ends = [description.source, description.destination];
    for (const [x, y] of ends) add(extent, x, y, 0);
    for (const leg of legs) {
        add(extent, leg.from[0], leg.from[1], 0);
        add(extent, leg.to[0], leg.to[1], 0);
        if (leg.center && leg.radii) addRide(extent, leg);
    }
    let side = larger(extent);
    if (!(side > 0)) side = radii.length > 0 && radii[0] > 0 ? radii[0] : 1;
    const near = { ...extent };
    for (const [x, y] of ends) add(near, x, y, FAR * side);
    addDiscs(extent, near, description.discs, radii);
    side = Math.max(larger(extent), side);
    const margin = MARGIN * side;
    return { xLow: extent.xLow - margin, xHigh: extent.xHigh + margin, yLow: extent.yLow - margin, yHigh: extent.yHigh + margin };
}

/** A ride may bulge beyond its ends; a short one hardly does. */
function addRide(extent, leg) {
    const reach = Math.hypot(leg.to[0] - leg.from[0], leg.to[1] - leg.from[1]);
    if (reach > 0.5 * leg.radii[1]) add(extent, leg.center[0], leg.center[1], leg.radii[1]);
}
