// SPDX-License-Identifier: MIT
/**
 * The curve of travel times T(t), or of arrivals A(t) = t + T(t), over all departures, from samples and jumps. T never falls and is
 * continuous from the left: at a jump's departure the robot still gets through, and right after it the way is longer. So the curve is
 * pieces, each from just after one jump to the next one's departure.
 */

/** @typedef {{first: number, second: number, time: number, place: [number, number]}} Gap */
/** @typedef {{departure: number, travelBefore: number, travelAfter: number, size?: number, gap?: Gap|null}} Jump */
/** @typedef {{times: ArrayLike<number>, arrivals: ArrayLike<number>}} Samples arrivals: NaN where there is none */
/** @typedef {{departure: number, travel: number}} Bend from here on the way rides other discs, and takes no longer for that */
/** @typedef {{departure: number, arrival?: number|null, reason?: string}} Last the core's last(), or as much of it as is known */
/** @typedef {{departures: ArrayLike<number>, left: ArrayLike<number>, right: ArrayLike<number>}} Rows as the core's Table.rows() gives them */

/**
 * Points of the curve in order.
 * @typedef {object} Curve
 * @property {Float64Array} departure
 * @property {Float64Array} travel
 * @property {Uint8Array} starts 1 where a piece begins
 * @property {number} count
 */

const ABOVE = 0.1; // of the range of values, over the highest
const ABOVE_CUT = 0.25; // the same where a jump leaves the window, which has to be said there
const FLAT = 1e-3; // of the window's height: so little is level anyway
const PRESSED = 0.2; // of the window's height: most departures have to share less than this

/** @param {Jump[]} jumps */
function inOrder(jumps) {
    return [...jumps].sort((one, other) => one.departure - other.departure);
}

/**
 * @param {Samples|null} samples in order of time
 * @param {Jump[]} jumps
 * @param {Last|null} last
 * @returns {Curve}
 */
export function curveOf(samples, jumps, last) {
    const most = (samples?.times.length ?? 0) + 2 * jumps.length + 1;
    const curve = { departure: new Float64Array(most), travel: new Float64Array(most), starts: new Uint8Array(most), count: 0 };
    const add = (departure, travel, starts) => {
        curve.departure[curve.count] = departure;
        curve.travel[curve.count] = travel;
        curve.starts[curve.count++] = starts ? 1 : 0;
    };
    const sorted = inOrder(jumps);
    let next = 0;
    for (let i = 0; samples && i < samples.times.length; i++) {
        const departure = samples.times[i], arrival = samples.arrivals[i];
        for (; next < sorted.length && sorted[next].departure < departure; next++) addJump(add, curve, sorted[next]);
        if (Number.isFinite(arrival) && !(departure < curve.departure[curve.count - 1])) add(departure, arrival - departure, curve.count === 0);
    }
    for (; next < sorted.length; next++) addJump(add, curve, sorted[next]);
    addLast(add, curve, last);
    return curve;
}

/** Samples with those at the bends among them, where chords would cut the corner. @param {Samples|null} samples @param {Bend[]} bends @returns {Samples|null} */
export function withBends(samples, bends) {
    if (!samples || bends.length === 0) return samples;
    const arrivals = new Map(bends.map(({ departure, travel }) => [departure, departure + travel]));
    for (let i = 0; i < samples.times.length; i++) arrivals.set(samples.times[i], samples.arrivals[i]);
    const times = Float64Array.from(arrivals.keys()).sort();
    return { times, arrivals: times.map((departure) => arrivals.get(departure)) };
}

/** @param {Curve} curve @param {Jump} jump */
function addJump(add, curve, jump) {
    add(jump.departure, jump.travelBefore, curve.count === 0);
    add(jump.departure, jump.travelAfter, true);
}

/** @param {Curve} curve @param {Last|null} last */
function addLast(add, curve, last) {
    if (!last || !Number.isFinite(last.departure) || !Number.isFinite(last.arrival ?? NaN) || curve.count === 0) return;
    if (last.departure > curve.departure[curve.count - 1]) add(last.departure, last.arrival - last.departure, false);
}

/**
 * The travel times of the paths that a table stores, where nothing exact is known: a row's holds for the departures after the row before.
 * @param {Rows} rows
 * @returns {Curve}
 */
export function stairsOf({ departures, left }) {
    const count = 2 * Math.max(departures.length, 1) - 1;
    const curve = { departure: new Float64Array(count), travel: new Float64Array(count), starts: new Uint8Array(count), count: departures.length > 0 ? count : 0 };
    for (let i = 0; i < curve.count; i++) {
        const row = (i + 1) >> 1;
        curve.departure[i] = departures[i >> 1];
        curve.travel[i] = left[row];
        curve.starts[i] = i === 0 || i % 2 === 1 ? 1 : 0;
    }
    return curve;
}

/** The first point at a departure, or else the last one before it: between the two points of a jump there is no departure. @param {Curve} curve */
function before(curve, departure) {
    let low = 0, high = curve.count - 1;
    while (low < high) {
        const middle = (low + high) >> 1;
        if (curve.departure[middle] < departure) low = middle + 1;
        else high = middle;
    }
    return curve.departure[low] > departure && low > 0 ? low - 1 : low;
}

/**
 * The travel time of a departure, between samples on their chord; NaN where the curve is not.
 * @param {Curve} curve
 * @param {number} departure
 */
export function travelAt(curve, departure) {
    if (curve.count === 0 || !(departure >= curve.departure[0]) || departure > curve.departure[curve.count - 1]) return NaN;
    const i = before(curve, departure);
    if (curve.departure[i] === departure || i + 1 >= curve.count) return curve.travel[i];
    const share = (departure - curve.departure[i]) / (curve.departure[i + 1] - curve.departure[i]);
    return curve.travel[i] + share * (curve.travel[i + 1] - curve.travel[i]);
}

/**
 * The latest departure that arrives by `arrival`: A rises strictly, in a piece and from one to the next.
 * @param {Curve} curve
 * @param {number} arrival
 * @returns {number|null} null where none does
 */
export function latestDeparture(curve, arrival) {
    const at = (i) => curve.departure[i] + curve.travel[i];
    if (curve.count === 0 || at(0) > arrival) return null;
    let low = 0, high = curve.count - 1;
    if (at(high) <= arrival) return curve.departure[high];
    while (high - low > 1) {
        const middle = (low + high) >> 1;
        if (at(middle) <= arrival) low = middle;
        else high = middle;
    }
    if (curve.starts[high]) return curve.departure[low];
    return curve.departure[low] + ((arrival - at(low)) / (at(high) - at(low))) * (curve.departure[high] - curve.departure[low]);
}

/** @param {"travel"|"arrival"} mode what is over a departure */
export function valueOf(mode, departure, travel) {
    return mode === "arrival" ? departure + travel : travel;
}

/**
 * The last departure that the picture shows: the true one, and where departures never end, or nobody knows, that of the samples.
 * @param {Curve} curve
 * @param {Last|null} last
 */
export function lastShown(curve, last) {
    if (last && Number.isFinite(last.departure) && last.departure > 0) return last.departure;
    const end = curve.count > 0 ? curve.departure[curve.count - 1] : 0;
    return end > 0 ? end : 1;
}

/**
 * The highest value of the window. What only the very last departures reach, by a jump, is above it, where it would press all others flat.
 * @param {Curve} curve
 * @param {"travel"|"arrival"} mode
 * @param {number} late departures after this are the very last ones
 */
function cutHigh(curve, mode, late, low, high) {
    for (let i = 1; i < curve.count; i++) {
        if (!curve.starts[i] || curve.departure[i] < late) continue;
        const share = (valueOf(mode, curve.departure[i - 1], curve.travel[i - 1]) - low) / (high - low);
        if (share > FLAT && share < PRESSED) return low + share * (high - low);
    }
    return high;
}

/**
 * The window of the picture, by the rules of `tdsp plot`: all departures and some room, travel times with a tenth of their range around.
 * @param {Curve} curve
 * @param {Last|null} last
 * @param {"travel"|"arrival"} mode
 * @param {Rows|null} rows the table's band is in the window too
 */
export function curveWindow(curve, last, mode, rows) {
    const until = lastShown(curve, last);
    let low = Infinity, high = -Infinity;
    for (let i = 0; i < curve.count; i++) {
        const value = valueOf(mode, curve.departure[i], curve.travel[i]);
        low = Math.min(low, value);
        high = Math.max(high, value);
    }
    for (let i = 0; rows && i < rows.departures.length; i++) {
        const value = valueOf(mode, rows.departures[i], rows.left[i]);
        if (!Number.isFinite(value) || rows.departures[i] > until) continue;
        low = Math.min(low, value);
        high = Math.max(high, value);
    }
    if (!(high >= low)) [low, high] = [0, 1];
    const most = cutHigh(curve, mode, 0.98 * until, low, high), above = most < high ? ABOVE_CUT : ABOVE;
    high = most;
    const range = high - low, xLow = -0.01 * until, xHigh = 1.04 * until;
    // A level curve is in the middle.
    if (!(range > 1e-9 * Math.abs(high))) return { xLow, xHigh, yLow: high > 0 ? 0.9 * low : low - 1, yHigh: high > 0 ? 1.1 * high : high + 1 };
    return { xLow, xHigh, yLow: low > 0 ? Math.max(low - 0.08 * range, 0) : -0.08 * range, yHigh: high + above * range };
}
