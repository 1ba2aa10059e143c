// SPDX-License-Identifier: MIT
/** Legs and gaps from numbers, as core/legs.c lays them out, and legs back. */
import { CoreError } from "./core_error.js";

/** @typedef {[number, number]} Place */
/**
 * One leg of a path. The keys are those of `tdsp path --json`; on an arc or a curve `angle` is the direction of `from` seen from the centre, and `sweep` how far it
 * turns, in radians.
 * @typedef {Object} Leg
 * @property {"line" | "arc" | "curve"} type a curve rides a disc whose rate changes
 * @property {number} start_time
 * @property {number} end_time
 * @property {Place} from
 * @property {Place} to
 * @property {number} [disc]
 * @property {Place} [center]
 * @property {"ccw" | "cw"} [turn]
 * @property {Place} [radii] at the start and at the end, the robot's radius included
 * @property {number} [angle]
 * @property {number} [sweep]
 * @property {Place} [rates] of a curve
 * @property {Place} [bends] of a curve
 * @property {number} [speed] of a curve
 */
/** @typedef {{first: number, second: number, time: number, place: Place}} Gap two discs that close, when and where */

export const LEG_NUMBERS = 20;
export const GAP_NUMBERS = 5;
export const NO_DISC = 0xffffffff;
const TYPES = /** @type {const} */ (["line", "arc", "curve"]);

/**
 * @param {Float64Array} n
 * @param {number} i where the leg begins
 * @returns {Leg}
 */
function readLeg(n, i) {
    const type = TYPES[n[i]];
    /** @type {Leg} */
    const leg = { type, start_time: n[i + 3], end_time: n[i + 4], from: [n[i + 5], n[i + 6]], to: [n[i + 7], n[i + 8]] };
    if (type === "line") return leg;
    Object.assign(leg, { disc: n[i + 1], center: [n[i + 9], n[i + 10]], turn: n[i + 2] > 0 ? "ccw" : "cw", radii: [n[i + 11], n[i + 12]] });
    Object.assign(leg, { angle: n[i + 13], sweep: n[i + 14] });
    if (type === "curve") Object.assign(leg, { rates: [n[i + 15], n[i + 16]], bends: [n[i + 17], n[i + 18]], speed: n[i + 19] });
    return leg;
}

/**
 * @param {Float64Array} numbers
 * @returns {Leg[]}
 */
export function readLegs(numbers) {
    const legs = [];
    for (let i = 0; i < numbers.length; i += LEG_NUMBERS) legs.push(readLeg(numbers, i));
    return legs;
}

/**
 * The numbers of a leg.
 * @param {Leg} leg
 * @param {number} index for messages
 * @returns {number[]}
 */
export function writeLeg(leg, index = 0) {
    const { center = [0, 0], radii = [0, 0], rates = [0, 0], bends = [0, 0], angle = 0, sweep = 0, speed = 0 } = leg;
    const kind = TYPES.indexOf(leg.type);
    const head = [kind, leg.disc ?? NO_DISC, kind === 0 ? 0 : leg.turn === "ccw" ? 1 : -1, leg.start_time, leg.end_time, ...leg.from, ...leg.to];
    const numbers = [...head, ...center, ...radii, angle, sweep, ...rates, ...bends, speed];
    const whole = kind === 0 || (leg.angle !== undefined && leg.sweep !== undefined);
    if (kind < 0 || !whole || numbers.length !== LEG_NUMBERS || !numbers.every(Number.isFinite))
        throw new CoreError(`legs[${index}]: not a leg of a path`, "bad_path", `legs[${index}]`);
    return numbers;
}

/**
 * @param {Float64Array} n
 * @param {number} i where the gap begins
 * @returns {Gap | null} null where it is not known what closes
 */
export function readGap(n, i) {
    return n[i] === NO_DISC ? null : { first: n[i], second: n[i + 1], time: n[i + 2], place: [n[i + 3], n[i + 4]] };
}
