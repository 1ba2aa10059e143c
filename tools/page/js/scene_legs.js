// SPDX-License-Identifier: MIT
/**
 * Where the robot is on its legs, by the formulas of include/tdsp/types.h: uniform motion on a line; on an arc the distance r from the
 * centre is linear in time and the angle turned is sweep ln(r / r0) / ln(r1 / r0); on a curve both are polynomials of degree 5 with
 * given values and first two derivatives at both ends.
 *
 * Legs come as the core and `tdsp path --json` give them. An arc whose sweep nobody says has the one that its ends and its speed give:
 * the ends give it up to whole turns, w dt ln(r1 / r0) / (r1 - r0) with the tangential speed w gives the turns.
 */

/** @typedef {[number, number]} Point */

/**
 * A leg of a path as JSON has it.
 * @typedef {object} LegJson
 * @property {"line"|"arc"|"curve"} type
 * @property {number} start_time
 * @property {number} end_time
 * @property {Point} from
 * @property {Point} to
 * @property {number} [disc]
 * @property {Point} [center]
 * @property {"cw"|"ccw"|number} [turn]
 * @property {[number, number]} [radii]
 * @property {number} [sweep]
 * @property {number} [angle] direction of `from` seen from the centre
 * @property {[number, number]} [rates]
 * @property {[number, number]} [bends]
 * @property {number} [speed]
 */

/**
 * A leg ready to be followed.
 * @typedef {object} Leg
 * @property {boolean} ride
 * @property {number} start
 * @property {number} end
 * @property {number} fromX
 * @property {number} fromY
 * @property {number} toX
 * @property {number} toY
 * @property {number} disc -1 for a line
 * @property {number} turn +1 counter-clockwise, -1 clockwise, 0 for a line
 * @property {number} centerX
 * @property {number} centerY
 * @property {number} radiusFrom
 * @property {number} radiusTo
 * @property {number} angle
 * @property {number} sweep
 * @property {number[]|null} distance of a curve: coefficients in the share of its duration
 * @property {number[]|null} turned
 */

/** Coefficients of the polynomial of degree 5 with these values, first and second derivatives at 0 and 1. */
function quintic(f0, f1, d0, d1, s0, s1) {
    const rise = f1 - f0;
    const third = 10 * rise - 6 * d0 - 4 * d1 - (3 * s0 - s1) / 2;
    const fourth = -15 * rise + 8 * d0 + 7 * d1 + (3 * s0 - 2 * s1) / 2;
    return [f0, d0, s0 / 2, third, fourth, 6 * rise - 3 * (d0 + d1) - (s0 - s1) / 2];
}

/** @param {number[]} c @param {number} x */
function evaluate(c, x) {
    return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * (c[4] + x * c[5]))));
}

/** The angle's change per time and its derivative, at distance r with rate r' and bend r''. */
function turning(speed, radius, rate, bend) {
    const across = Math.sqrt(Math.max(0, speed * speed - rate * rate));
    const w = across / radius;
    return { w, change: (across > 0 ? (-rate * bend) / (across * radius) : 0) - (w * rate) / radius };
}

/** @param {Leg} leg @param {LegJson} json */
function addPolynomials(leg, json) {
    const dt = leg.end - leg.start, [rate0, rate1] = json.rates, [bend0, bend1] = json.bends ?? [0, 0];
    const from = turning(json.speed, leg.radiusFrom, rate0, bend0), to = turning(json.speed, leg.radiusTo, rate1, bend1);
    leg.distance = quintic(leg.radiusFrom, leg.radiusTo, rate0 * dt, rate1 * dt, bend0 * dt * dt, bend1 * dt * dt);
    leg.turned = quintic(0, leg.sweep, from.w * dt, to.w * dt, from.change * dt * dt, to.change * dt * dt);
}

/** @param {Leg} leg @param {number} speed of the robot */
function sweepOf(leg, speed) {
    const dt = leg.end - leg.start, growth = leg.radiusTo - leg.radiusFrom, share = growth / leg.radiusFrom;
    const across = dt > 0 ? Math.sqrt(Math.max(0, speed * speed - (growth / dt) ** 2)) : 0;
    const expected = ((across * dt) / leg.radiusFrom) * (Math.abs(share) < 1e-12 ? 1 : Math.log1p(share) / share);
    const ends = (Math.atan2(leg.toY - leg.centerY, leg.toX - leg.centerX) - leg.angle) * leg.turn;
    return Math.max(0, ends + 2 * Math.PI * Math.round((expected - ends) / (2 * Math.PI)));
}

/** @param {LegJson} json @param {number} speed of the robot @returns {Leg} */
function prepared(json, speed) {
    const ride = json.type !== "line";
    const leg = {
        ride, start: json.start_time, end: json.end_time, fromX: json.from[0], fromY: json.from[1], toX: json.to[0], toY: json.to[1],
        disc: -1, turn: 0, centerX: 0, centerY: 0, radiusFrom: 0, radiusTo: 0, angle: 0, sweep: 0, distance: null, turned: null,
    };
    if (!ride) return leg;
    leg.disc = json.disc ?? -1;
    leg.turn = typeof json.turn === "number" ? json.turn : json.turn === "cw" ? -1 : 1;
    [leg.centerX, leg.centerY] = json.center;
    [leg.radiusFrom, leg.radiusTo] = json.radii;
    leg.angle = json.angle ?? Math.atan2(leg.fromY - leg.centerY, leg.fromX - leg.centerX);
    leg.sweep = json.sweep ?? sweepOf(leg, speed);
    if (json.rates) addPolynomials(leg, json);
    return leg;
}

/**
 * Legs ready to be followed and drawn.
 * @param {LegJson[]} legs
 * @param {number} speed the robot's
 * @returns {Leg[]}
 */
export function prepareLegs(legs, speed) {
    return legs.map((leg) => prepared(leg, speed));
}

/**
 * Where the robot is at a share of a leg's duration; `out` is x, y.
 * @param {Leg} leg
 * @param {number} share 0 to 1
 * @param {Float64Array|number[]} out
 */
export function positionAtShare(leg, share, out) {
    if (!leg.ride) {
        out[0] = leg.fromX + (leg.toX - leg.fromX) * share;
        out[1] = leg.fromY + (leg.toY - leg.fromY) * share;
        return;
    }
    const radius = leg.distance ? evaluate(leg.distance, share) : leg.radiusFrom + (leg.radiusTo - leg.radiusFrom) * share;
    const direction = leg.angle + leg.turn * turnedAt(leg, share);
    out[0] = leg.centerX + radius * Math.cos(direction);
    out[1] = leg.centerY + radius * Math.sin(direction);
}

/** The angle turned up to a share of a leg's duration, not negative. @param {Leg} leg @param {number} share */
export function turnedAt(leg, share) {
    if (leg.turned) return evaluate(leg.turned, share);
    const all = (leg.radiusTo - leg.radiusFrom) / leg.radiusFrom;
    return leg.sweep * (Math.abs(all) < 1e-12 ? share : Math.log1p(all * share) / Math.log1p(all));
}

/** @param {Leg} leg @param {number} time */
export function shareAt(leg, time) {
    const duration = leg.end - leg.start;
    return duration > 0 ? Math.min(1, Math.max(0, (time - leg.start) / duration)) : 1;
}

/** The leg that is under way at a time; the first before the path begins, the last after. @param {Leg[]} legs */
export function legAt(legs, time) {
    let low = 0, high = legs.length - 1;
    while (low < high) {
        const middle = (low + high) >> 1;
        if (legs[middle].end < time) low = middle + 1;
        else high = middle;
    }
    return low;
}

/**
 * Where the robot is at a time, clamped to the path.
 * @param {Leg[]} legs at least one
 * @param {number} time
 * @param {Float64Array|number[]} out x, y
 */
export function positionAt(legs, time, out) {
    const leg = legs[legAt(legs, time)];
    positionAtShare(leg, shareAt(leg, time), out);
}

/** Does leg i begin a ride? A ride on a disc whose rate changes is many curves. @param {Leg[]} legs @param {number} i */
export function beginsRide(legs, i) {
    if (!legs[i].ride) return false;
    return i === 0 || !legs[i - 1].ride || legs[i - 1].disc !== legs[i].disc || legs[i - 1].turn !== legs[i].turn;
}
