// SPDX-License-Identifier: MIT
/**
 * What is under a pointer. The ends come first, because the robot's journey is what is moved most; then the selected disc's rim and
 * centre; then the smallest disc that holds the point, so that none is out of reach below a larger one; last a rim nearby.
 *
 * @typedef {object} Target
 * @property {"source"|"destination"|"disc"|"rim"} what
 * @property {number} index of the disc; -1 for an end
 */

/** @typedef {import("tdsp/scene_projection.js").Projection} Projection */

/** Half of what WCAG asks of a target for fingers: 44 by 44 pixels. */
const FINGER = 22;
const MOUSE = 12;
const RIM = { mouse: 6, touch: 16 };

/**
 * @typedef {object} Ground what can be hit
 * @property {[number, number]} source
 * @property {[number, number]} destination
 * @property {import("tdsp/scene_discs.js").Centers} centers
 * @property {Float64Array} radii as drawn
 * @property {number} count
 * @property {number} selected the selected disc, -1 for none
 */

/** @param {Projection} projection @param {[number, number]} place */
function away(projection, place, x, y) {
    return Math.hypot(projection.x(place[0]) - x, projection.y(place[1]) - y);
}

/** @returns {Target|null} */
function hitEnds(projection, ground, x, y, reach) {
    const source = away(projection, ground.source, x, y), destination = away(projection, ground.destination, x, y);
    if (Math.min(source, destination) > reach) return null;
    return { what: source <= destination ? "source" : "destination", index: -1 };
}

/** How far inside a disc the point is, in pixels; negative outside. */
function depth(projection, ground, i, x, y) {
    const dx = projection.x(ground.centers.x[i]) - x, dy = projection.y(ground.centers.y[i]) - y;
    return ground.radii[i] * projection.scale - Math.hypot(dx, dy);
}

/** The rim counts where the disc is large enough to be held by its inside too. @returns {Target|null} */
function hitSelected(projection, ground, x, y, rim) {
    const i = ground.selected;
    if (i < 0 || i >= ground.count) return null;
    const inside = depth(projection, ground, i, x, y), radius = ground.radii[i] * projection.scale;
    if (Math.abs(inside) <= Math.min(rim, Math.max(2, radius / 2)) || (inside < 0 && inside >= -rim)) return { what: "rim", index: i };
    return inside > 0 ? { what: "disc", index: i } : null;
}

/** @returns {Target|null} */
function hitDiscs(projection, ground, x, y, reach, rim) {
    let best = -1, least = Infinity, onRim = false;
    for (let i = 0; i < ground.count; i++) {
        const inside = depth(projection, ground, i, x, y), radius = ground.radii[i] * projection.scale;
        const grabbed = inside >= 0 || (radius < reach && inside >= radius - reach);
        if (!grabbed && inside < -rim) continue;
        const cost = grabbed ? radius : 1e9 - inside;
        if (cost < least) [best, least, onRim] = [i, cost, !grabbed || (inside <= rim && radius > 4 * rim)];
    }
    return best < 0 ? null : { what: onRim ? "rim" : "disc", index: best };
}

/**
 * @param {Projection} projection
 * @param {Ground} ground
 * @param {number} x pixels
 * @param {number} y
 * @param {boolean} [touch] a finger, which needs more room than a mouse
 * @returns {Target|null}
 */
export function hit(projection, ground, x, y, touch = false) {
    const reach = touch ? FINGER : MOUSE, rim = touch ? RIM.touch : RIM.mouse;
    const first = hitEnds(projection, ground, x, y, reach) ?? hitSelected(projection, ground, x, y, rim);
    return first ?? hitDiscs(projection, ground, x, y, touch ? FINGER / 2 : 6, rim);
}

/** @param {Target|null} one @param {Target|null} other */
export function sameTarget(one, other) {
    return one === other || (!!one && !!other && one.what === other.what && one.index === other.index);
}
