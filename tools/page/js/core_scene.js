// SPDX-License-Identifier: MIT
/**
 * A prepared scene and its exact answers. The prepared scene is kept while the ends are moved, which is what makes dragging them cheap; a table is about ends of its
 * scene, so for moved ends it is built from a scene of its own, and has the bytes that the command writes for a file with these ends.
 */
import { CoreError, sceneError } from "./core_error.js";
import { readDescription, readTime } from "./core_description.js";
import { GAP_NUMBERS, NO_DISC, readGap, readLegs, writeLeg } from "./core_legs.js";

/** @typedef {import("./core_wasm.js").Wasm} Wasm */
/** @typedef {import("./core_wasm.js").Progress} Progress */
/** @typedef {import("./core_legs.js").Leg} Leg */
/** @typedef {import("./core_legs.js").Gap} Gap */
/** @typedef {import("./core_legs.js").Place} Place */
/** @typedef {import("./core_description.js").Description} Description */
/** @typedef {{status: string, departure: number, arrival: number | null, travelTime: number | null}} Arrival */
/** @typedef {Arrival & {legs: Leg[]}} Path */
/** @typedef {{status: string, arrival: number, departure: number | null, arrives: number | null}} Departure */
/**
 * What ends the departures: `departure` is infinite when nothing does, minus infinity when there is no way at all.
 * @typedef {{departure: number, arrival: number, reason: string, disc: number | null, other: number | null, time: number, place: Place | null}} Last
 */
/** @typedef {{departure: number, travelBefore: number, travelAfter: number, size: number, gap: Gap | null}} Jump later departures take longer by `size` */
/**
 * Departures whose paths ride the same discs in the same order.
 * @typedef {Object} Piece
 * @property {number} from
 * @property {number} until
 * @property {number} travelFrom T just after `from`
 * @property {number} travelUntil T at `until`
 * @property {number} form pieces of one form have one number
 * @property {{disc: number, turn: "ccw" | "cw"}[]} rides
 * @property {"end" | "jump" | "touch" | "switch"} change how it ends
 * @property {Gap | null} gap of a jump
 */
/** @typedef {{status: string, pieces: Piece[], forms: number, resolution: number}} Curve */
/** @typedef {{from?: number, until?: number, least?: number, progress?: Progress}} JumpOptions */
/** @typedef {{from?: number, until?: number, resolution?: number, progress?: Progress}} CurveOptions */
/**
 * @typedef {Object} BuildOptions
 * @property {"travel" | "arrival" | "absolute"} [guarantee] travel
 * @property {number} [epsilon] of travel and arrival: 0.01
 * @property {number} [delta] of absolute, which needs it
 * @property {"adaptive" | "geometric"} [sampling] adaptive
 * @property {number} [horizon] departures up to this; needed where no disc ends them
 * @property {number} [maxRows] 2^24
 * @property {boolean} [exact] exact arrivals only, also where nearly the best would do
 * @property {Progress} [progress]
 */
/**
 * @typedef {Object} BuildReport
 * @property {number} rows
 * @property {number} bytes
 * @property {number} forwardCalls
 * @property {number} reverseCalls
 * @property {number} lastDeparture
 * @property {string} lastReason
 * @property {number} oracleDelta what nearly exact answers were held to; 0: exact only
 * @property {number} roughCalls
 * @property {number} gaps
 */
/** @typedef {{ok: boolean, minClearance: number | null, time: number | null, disc: number | null, leg: number, tolerance: number, problems: string[]}} Verdict */

export const GUARANTEES = /** @type {const} */ (["travel", "arrival", "absolute"]);
export const SAMPLINGS = /** @type {const} */ (["adaptive", "geometric"]);
const CHANGES = /** @type {const} */ (["end", "jump", "touch", "switch"]);
const MOST_ROWS = 2 ** 24;
const REPORT_NUMBERS = 9;
const UNIT_BYTES = 15; // what a table holds of a unit's name
const FRAME = 16; // how much larger or smaller a journey may be than the one prepared for
const JOURNEY_ENDS = 2; // where the ends stand among the numbers of a scene
const PROBLEMS = [
    "does not start at the source at the departure",
    "does not end at the destination at the arrival",
    "legs do not join in place or time",
    "faster than the robot",
    "enters a disc",
    "a leg is not well formed",
];

/**
 * A scene is prepared in the frame of its journey, and answers are as exact as that is small: are these ends beyond what is lost unnoticed?
 * @param {Iterable<number>} ends
 * @param {Iterable<number>} prepared
 */
function isElsewhere([x, y, u, v], [a, b, c, d]) {
    const frame = Math.hypot(c - a, d - b);
    const length = Math.hypot(u - x, v - y);
    const [middleX, middleY] = [(a + c) / 2, (b + d) / 2];
    const reach = Math.max(Math.hypot(x - middleX, y - middleY), Math.hypot(u - middleX, v - middleY));
    return reach > FRAME * frame || (length > 0 && FRAME * length < frame);
}

/** @param {number} disc */
const discOrNull = (disc) => (disc === NO_DISC ? null : disc);

/**
 * @param {Wasm} wasm
 * @param {Float64Array} numbers
 * @param {number} count
 * @returns {number} where the scene is
 */
function createScene(wasm, numbers, count) {
    wasm.answer(wasm.lend([numbers], (at) => wasm.call("scene_create", at, count, wasm.scratch)));
    return wasm.word();
}

/**
 * @param {unknown} word
 * @param {readonly string[]} words
 * @param {string} name
 */
function wordIndex(word, words, name) {
    const index = words.indexOf(String(word));
    if (index < 0) throw new CoreError(`the ${name} "${word}" must be one of ${words.join(", ")}`, "invalid_argument", name);
    return index;
}

/**
 * The options as numbers, in the order of core/build.c.
 * @param {BuildOptions} options
 */
function readBuildOptions(options) {
    const { guarantee = "travel", sampling = "adaptive", epsilon = 0.01, delta = 0, horizon = Infinity, maxRows = MOST_ROWS, exact = false } = options;
    /** @type {(reason: string, where: string) => never} */
    const refuse = (reason, where) => {
        throw new CoreError(reason, "invalid_argument", where);
    };
    const numbers = [wordIndex(guarantee, GUARANTEES, "guarantee"), wordIndex(sampling, SAMPLINGS, "sampling"), epsilon, delta];
    if (sampling === "geometric" && guarantee !== "arrival") refuse("geometric sampling gives the guarantee arrival only", "sampling");
    if (guarantee === "absolute" && !(Number.isFinite(delta) && delta > 0)) refuse("the guarantee absolute needs a delta greater than zero", "delta");
    if (guarantee !== "absolute" && !(epsilon >= 1e-9 && epsilon <= 1)) refuse("epsilon must be from 1e-9 to 1", "epsilon");
    if (!Number.isInteger(maxRows) || maxRows < 1 || maxRows > MOST_ROWS) refuse(`the most rows must be a whole number from 1 to ${MOST_ROWS}`, "maxRows");
    return [...numbers, readTime(horizon, "horizon", true), maxRows, exact ? 1 : 0];
}

export class Scene {
    /** @type {Wasm} */ #wasm;
    #at = 0;
    /** @type {Float64Array} */ #numbers;
    /** @type {{length: string, time: string}} */ #units;
    #moved = false; // other ends than the scene was prepared for
    #room = 0; // of `count` numbers in the module's memory, for radii
    /** The description as given, with the ends asked about. @type {Description} */ description;
    /** Number of discs. */ count;
    /** What was ignored in the description, in sentences. @type {string[]} */ warnings;

    /**
     * @param {Wasm} wasm
     * @param {Description} description
     */
    constructor(wasm, description) {
        const read = readDescription(wasm, description);
        this.#wasm = wasm;
        this.#numbers = read.numbers;
        this.#units = read.units;
        this.description = { ...description };
        this.count = read.count;
        this.warnings = read.warnings;
        this.#at = createScene(wasm, read.numbers, read.count);
    }

    /** Free what the module holds; the scene is of no use afterwards. */
    free() {
        if (this.#at) this.#wasm.call("scene_free", this.#at);
        if (this.#room) this.#wasm.release(this.#room);
        this.#at = this.#room = 0;
    }

    /** @returns {number} */
    get #handle() {
        if (!this.#at) throw new CoreError("the scene was freed", "invalid_argument");
        return this.#at;
    }

    /**
     * Throws what is no answer, with what this scene knows about it.
     * @param {number} code
     * @returns {string}
     */
    #answer(code) {
        const status = this.#wasm.names[code];
        if (status !== "shrinks") return this.#wasm.answer(code);
        const until = this.#wasm.call("scene_valid_until", this.#handle, this.#wasm.scratch);
        const where = `discs[${this.#wasm.word()}].growth`;
        throw new CoreError(`${where}: the radius shrinks after t = ${until}, and this question reaches beyond`, status, where);
    }

    /** The hash that a table of this scene carries. @returns {bigint} */
    get hash() {
        return BigInt.asUintN(64, this.#wasm.call("scene_hash", this.#handle));
    }

    /**
     * Ask about other ends from now on. Nothing is prepared anew unless they are many times nearer to each other, or farther away, than before.
     * @param {Place} source
     * @param {Place} destination
     */
    setEnds(source, destination) {
        const ends = [...source, ...destination];
        if (ends.length !== 4 || !ends.every((number) => Number.isFinite(number) && Math.abs(number) <= 1e100))
            throw sceneError("", "the source or the destination is not finite, or beyond 1e100");
        if (isElsewhere(ends, this.#numbers.subarray(JOURNEY_ENDS, JOURNEY_ENDS + 4))) this.#prepareAt(ends);
        else this.#answer(this.#wasm.call("scene_set_ends", this.#handle, ...ends));
        this.#moved = ends.some((number, i) => number !== this.#numbers[JOURNEY_ENDS + i]);
        this.description = { ...this.description, source: [source[0], source[1]], destination: [destination[0], destination[1]] };
    }

    /** @param {number[]} ends */
    #prepareAt(ends) {
        const numbers = this.#numbers.slice();
        numbers.set(ends, JOURNEY_ENDS);
        const at = createScene(this.#wasm, numbers, this.count);
        this.#wasm.call("scene_free", this.#handle);
        this.#at = at;
        this.#numbers = numbers;
    }

    /**
     * A(t): the earliest arrival for a departure.
     * @param {number} departure
     * @returns {Arrival}
     */
    arrival(departure) {
        readTime(departure, "departure");
        const status = this.#answer(this.#wasm.call("scene_arrival", this.#handle, departure, this.#wasm.scratch));
        if (status !== "ok") return { status, departure, arrival: null, travelTime: null };
        const arrival = this.#wasm.numbers(this.#wasm.scratch, 1)[0];
        return { status, departure, arrival, travelTime: arrival - departure };
    }

    /**
     * The fastest path for a departure.
     * @param {number} departure
     * @returns {Path}
     */
    path(departure) {
        const found = this.arrival(departure);
        return { ...found, legs: found.status === "ok" ? this.#legs() : [] };
    }

    #legs() {
        this.#answer(this.#wasm.call("scene_path", this.#handle, this.#wasm.scratch));
        return readLegs(this.#wasm.take());
    }

    /**
     * The latest departure that arrives at `arrival` or before.
     * @param {number} arrival may be infinite: the last departure of all
     * @returns {Departure}
     */
    departure(arrival) {
        readTime(arrival, "arrival", true);
        const status = this.#answer(this.#wasm.call("scene_departure", this.#handle, arrival, this.#wasm.scratch));
        const [departure, arrives] = this.#wasm.numbers(this.#wasm.scratch, 2);
        return status === "ok" ? { status, arrival, departure, arrives } : { status, arrival, departure: null, arrives: null };
    }

    /** @returns {Last} */
    last() {
        const status = this.#answer(this.#wasm.call("scene_last", this.#handle, this.#wasm.scratch));
        if (status !== "ok") return { departure: -Infinity, arrival: Infinity, reason: status, disc: null, other: null, time: 0, place: null };
        const [departure, arrival, reason, disc, other, time, x, y] = this.#wasm.numbers(this.#wasm.scratch, 8);
        return { departure, arrival, reason: this.#wasm.names[reason], disc: discOrNull(disc), other: discOrNull(other), time, place: [x, y] };
    }

    /**
     * What closes where the arrival jumps right after a departure.
     * @param {number} departure
     * @returns {Gap | null}
     */
    gap(departure) {
        readTime(departure, "departure");
        const code = this.#wasm.call("scene_gap", this.#handle, departure, this.#wasm.scratch);
        if (this.#wasm.names[code] === "no_answer") return null;
        return this.#answer(code) === "ok" ? readGap(this.#wasm.numbers(this.#wasm.scratch, GAP_NUMBERS), 0) : null;
    }

    /**
     * A question about the shape of A from numbers; null where there is no way.
     * @param {Progress | undefined} progress
     * @param {string} name
     * @param {number[]} asked
     * @returns {{status: string, numbers: Float64Array | null}}
     */
    #shape(progress, name, asked) {
        const code = this.#wasm.callTelling(progress, name, this.#handle, ...asked, this.#wasm.scratch);
        if (this.#wasm.names[code] === "needs_horizon") throw this.#needsHorizon();
        const status = this.#answer(code);
        return { status, numbers: status === "ok" ? this.#wasm.take() : null };
    }

    #needsHorizon() {
        return new CoreError("no disc ever ends the departures of this scene: say how far to go with a horizon", "needs_horizon", "horizon");
    }

    /**
     * All jumps of the arrival. Those up to `least` are left out (default: a 256th of the rise of all travel times).
     * @param {JumpOptions} [options]
     * @returns {Jump[]}
     */
    jumps({ from = 0, until = Infinity, least = 0, progress } = {}) {
        const { numbers } = this.#shape(progress, "scene_jumps", [readTime(from, "from"), readTime(until, "until", true), least]);
        const jumps = [];
        for (let i = 0, n = numbers ?? []; i < n.length; i += 4 + GAP_NUMBERS)
            jumps.push({ departure: n[i], travelBefore: n[i + 1], travelAfter: n[i + 2], size: n[i + 3], gap: readGap(/** @type {Float64Array} */ (n), i + 4) });
        return jumps;
    }

    /**
     * The pieces of which the arrival is made, each wider than `resolution` (default: a 1024th of the departures looked at), and the exact T.
     * @param {CurveOptions} [options]
     * @returns {Curve & {evaluate: (departure: number) => number}}
     */
    curve({ from = 0, until = Infinity, resolution = 0, progress } = {}) {
        const { status, numbers } = this.#shape(progress, "scene_curve", [readTime(from, "from"), readTime(until, "until", true), resolution]);
        const evaluate = (/** @type {number} */ departure) => this.arrival(departure).travelTime ?? NaN;
        if (!numbers) return { status, pieces: [], forms: 0, resolution: 0, evaluate };
        return { status, pieces: readPieces(numbers), forms: numbers[0], resolution: numbers[1], evaluate };
    }

    /**
     * A at each of these departures; not a number where there is no way.
     * @param {Float64Array} times
     * @returns {Float64Array}
     */
    samples(times) {
        times.forEach((time) => readTime(time, "departure"));
        return this.#wasm.lend([times], (at) => {
            this.#answer(this.#wasm.call("scene_samples", this.#handle, at, times.length));
            return this.#wasm.numbers(at, times.length).slice();
        });
    }

    /**
     * Build a table: the bytes that `tdsp build` writes for this scene.
     * @param {BuildOptions} [options]
     * @returns {{bytes: Uint8Array, report: BuildReport}}
     */
    build(options = {}) {
        const asked = readBuildOptions(options);
        for (const [name, unit] of Object.entries(this.#units))
            if (new TextEncoder().encode(unit).length > UNIT_BYTES) throw sceneError(`units.${name}`, `longer than the ${UNIT_BYTES} bytes a table holds`);
        if (!this.#moved) return this.#build(this.#handle, asked, options);
        const { source, destination } = this.description;
        const numbers = this.#numbers.slice();
        numbers.set([...source, ...destination], JOURNEY_ENDS);
        const own = createScene(this.#wasm, numbers, this.count);
        try {
            return this.#build(own, asked, options);
        } finally {
            this.#wasm.call("scene_free", own);
        }
    }

    /**
     * @param {number} scene
     * @param {number[]} asked
     * @param {BuildOptions} options
     */
    #build(scene, asked, options) {
        const wasm = this.#wasm;
        const { code, numbers } = wasm.lend([asked, this.#units.length, this.#units.time, new Float64Array(REPORT_NUMBERS)], (at, length, time, report) => {
            const code = wasm.callTelling(options.progress, "scene_build", scene, at, length, time, wasm.scratch, wasm.scratch + 4, report);
            return { code, numbers: wasm.numbers(report, REPORT_NUMBERS).slice() };
        });
        if (wasm.names[code] !== "ok") throw this.#buildError(code, asked, options);
        const bytes = wasm.bytes(wasm.word(0), wasm.word(1)).slice();
        wasm.release(wasm.word(0));
        return { bytes, report: this.#report(numbers) };
    }

    /**
     * @param {Float64Array} n
     * @returns {BuildReport}
     */
    #report(n) {
        const [rows, bytes, forwardCalls, reverseCalls, lastDeparture, reason, oracleDelta, roughCalls, gaps] = n;
        return { rows, bytes, forwardCalls, reverseCalls, lastDeparture, lastReason: this.#wasm.names[reason], oracleDelta, roughCalls, gaps };
    }

    /**
     * Why nothing was built, as the command says it.
     * @param {number} code
     * @param {number[]} asked
     * @param {BuildOptions} options
     */
    #buildError(code, asked, options) {
        const status = this.#wasm.names[code];
        const nearer = Number.isFinite(asked[4]) ? ", or a nearer horizon" : "";
        if (status === "needs_horizon") return this.#needsHorizon();
        if (status === "too_many_rows") return new CoreError(`the guarantee needs more than ${asked[5]} rows: ask for a weaker one${nearer}`, status, "epsilon");
        if (status === "not_supported" && options.sampling === "geometric")
            return new CoreError("geometric sampling needs a journey that takes time: source and destination are one", status, "sampling");
        if (status === "not_supported") return new CoreError("departures reach too many journeys away: end them with a nearer horizon", status, "horizon");
        try {
            this.#answer(code);
        } catch (error) {
            return error;
        }
        return new CoreError(`nothing to build: no path at departure 0: ${this.#wasm.reason(status)}`, status);
    }

    /**
     * Check a path by the library's verifier, which shares nothing with the search.
     * @param {Leg[]} legs
     * @returns {Verdict}
     */
    verify(legs) {
        const numbers = legs.flatMap(writeLeg);
        const [departure, arrival] = legs.length > 0 ? [legs[0].start_time, legs[legs.length - 1].end_time] : [0, 0];
        this.#answer(this.#wasm.lend([numbers], (at) => this.#wasm.call("scene_verify", this.#handle, at, legs.length, departure, arrival, this.#wasm.scratch)));
        const [problems, clearance, time, disc, leg, tolerance] = this.#wasm.numbers(this.#wasm.scratch, 6);
        const near = disc !== NO_DISC;
        return {
            ok: problems === 0,
            minClearance: near ? clearance : null,
            time: near ? time : null,
            disc: discOrNull(disc),
            leg,
            tolerance,
            problems: PROBLEMS.filter((_, bit) => problems & (1 << bit)).map((sentence) => `${sentence} (leg ${leg})`),
        };
    }

    /**
     * A disc's radius at a time, without the robot's.
     * @param {number} disc
     * @param {number} time
     * @returns {number}
     */
    discRadius(disc, time) {
        if (!Number.isInteger(disc) || disc < 0 || disc >= this.count) throw new CoreError(`there is no disc ${disc}`, "invalid_argument", "disc");
        this.#answer(this.#wasm.call("scene_radius", this.#handle, disc, readTime(time, "time"), this.#wasm.scratch));
        return this.#wasm.numbers(this.#wasm.scratch, 1)[0];
    }

    /**
     * The radii of all discs at a time, without the robot's.
     * @param {number} time
     * @param {Float64Array} [out] of `count` numbers
     * @returns {Float64Array} `out`
     */
    radii(time, out = new Float64Array(this.count)) {
        const scene = this.#handle;
        if (!this.#room) this.#room = this.#wasm.allocate(8 * this.count);
        this.#answer(this.#wasm.call("scene_radii", scene, readTime(time, "time"), this.#room, this.count));
        out.set(this.#wasm.numbers(this.#room, this.count));
        return out;
    }
}

/**
 * @param {Float64Array} n
 * @returns {Piece[]}
 */
function readPieces(n) {
    /** @type {Piece[]} */
    const pieces = [];
    for (let i = 2; i < n.length; ) {
        const [from, until, travelFrom, travelUntil, form, change, rideCount] = n.subarray(i, i + 7);
        const gap = change === CHANGES.indexOf("jump") ? readGap(n, i + 7) : null;
        i += 7 + GAP_NUMBERS;
        /** @type {Piece["rides"]} */
        const rides = [];
        for (let k = 0; k < rideCount; k++, i += 2) rides.push({ disc: n[i], turn: n[i + 1] > 0 ? "ccw" : "cw" });
        pieces.push({ from, until, travelFrom, travelUntil, form, rides, change: CHANGES[change], gap });
    }
    return pieces;
}
