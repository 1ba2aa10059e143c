// SPDX-License-Identifier: MIT
/** A table: certified answers by look-up, from bytes that a file or a build gave. */
import { CoreError } from "./core_error.js";
import { readTime } from "./core_description.js";
import { GAP_NUMBERS, readGap, readLegs } from "./core_legs.js";
import { GUARANTEES, SAMPLINGS } from "./core_scene.js";

/** @typedef {import("./core_wasm.js").Wasm} Wasm */
/** @typedef {import("./core_legs.js").Leg} Leg */
/** @typedef {import("./core_legs.js").Gap} Gap */
/** @typedef {{row: number, departure: number, travelBefore: number, travelAfter: number, size: number, gap: Gap | null}} TableJump */
/** @typedef {{departures: Float64Array, left: Float64Array, right: Float64Array}} Rows travel times at each departure, and right after it */
/** @typedef {{status: string, departure: number, lower: number | null, upper: number | null}} Interval */
/** @typedef {{status: string, arrival: number, departure: number | null, departureUpper: number | null}} TableDeparture leaving at `departure` arrives in time; after `departureUpper` nothing can */
/** @typedef {{status: string, departure: number, arrival: number | null, row: number | null, computed_for: number | null, legs: Leg[]}} TablePath */

const MONOTONES = ["travel", "arrival"];
const INFO_NUMBERS = 22;

export class Table {
    /** @type {Wasm} */ #wasm;
    #at = 0;
    /** As they were given. @type {Uint8Array} */ bytes;
    /** What `tdsp info --json` prints, but for the file's name. */ info;
    /** Of the scene that it was built for. @type {bigint} */ hash;

    /**
     * @param {Wasm} wasm
     * @param {Uint8Array} bytes
     */
    constructor(wasm, bytes) {
        this.#wasm = wasm;
        this.bytes = bytes.slice();
        this.#open(bytes);
        this.hash = BigInt.asUintN(64, wasm.call("table_hash", this.#at));
        try {
            this.info = this.#readInfo();
        } catch (error) {
            this.free(); // no memory
            throw error;
        }
    }

    /** @param {Uint8Array} bytes */
    #open(bytes) {
        const wasm = this.#wasm, at = wasm.allocate(bytes.length);
        wasm.bytes(at, bytes.length).set(bytes);
        const code = wasm.call("table_open", at, bytes.length, wasm.scratch);
        if (wasm.names[code] !== "ok") wasm.release(at); // else the table owns it
        wasm.answer(code);
        this.#at = wasm.word();
    }

    /** Free what the module holds; the table is of no use afterwards. */
    free() {
        if (this.#at) this.#wasm.call("table_free", this.#at);
        this.#at = 0;
    }

    /** @returns {number} */
    get #handle() {
        if (!this.#at) throw new CoreError("the table was freed", "invalid_argument");
        return this.#at;
    }

    #units() {
        const at = this.#wasm.scratch;
        this.#wasm.call("table_units", this.#handle, at, at + 16);
        return { length: this.#wasm.string(at), time: this.#wasm.string(at + 16) };
    }

    #readInfo() {
        this.#wasm.call("table_info", this.#handle, this.#wasm.scratch);
        const n = this.#wasm.numbers(this.#wasm.scratch, INFO_NUMBERS).slice();
        const [major, minor, monotone, guarantee, sampling, rows, legs, bytes, epsilon, delta, error, time_scale, speed] = n;
        const absolute = GUARANTEES[guarantee] === "absolute";
        const { left } = this.#rows(rows);
        return {
            format_version: `${major}.${minor}`,
            ...{ bytes, rows, legs, curves: n[21], bytes_per_row: bytes / rows, guide_bytes: n[20] },
            ...{ guarantee: GUARANTEES[guarantee], epsilon: absolute ? null : epsilon, delta: absolute ? delta : null },
            ...{ sampling: SAMPLINGS[sampling], monotone: MONOTONES[monotone], error, time_scale },
            scene_hash: this.hash.toString(16).padStart(16, "0"),
            units: this.#units(),
            ...{ speed, source: [n[13], n[14]], destination: [n[15], n[16]] },
            ...{ first_departure: n[17], last_departure: n[18], last_reason: this.#wasm.names[n[19]] },
            ...{ first_travel_time: left[0], last_travel_time: left[rows - 1] },
            jumps: this.jumps().map(({ row, departure, travelBefore, travelAfter, size, gap }) => {
                const { first, second, time, place } = gap ?? { first: null, second: null, time: null, place: null };
                return { row, departure, before: travelBefore, after: travelAfter, size, first, second, time, place };
            }),
        };
    }

    /**
     * @param {number} count
     * @returns {Rows}
     */
    #rows(count) {
        const all = this.#wasm.lend([new Float64Array(3 * count)], (at) => {
            this.#wasm.call("table_rows", this.#handle, at, count);
            return this.#wasm.numbers(at, 3 * count).slice();
        });
        return { departures: all.subarray(0, count), left: all.subarray(count, 2 * count), right: all.subarray(2 * count) };
    }

    /** The staircase: for departures after the one before, up to each of these, T is from the `right` before to `left`. @returns {Rows} */
    rows() {
        return this.#rows(this.info.rows);
    }

    /**
     * The certified interval of the earliest arrival.
     * @param {number} departure
     * @returns {Interval}
     */
    arrival(departure) {
        const status = this.#wasm.answer(this.#wasm.call("table_arrival", this.#handle, readTime(departure, "departure"), this.#wasm.scratch));
        const [lower, upper] = this.#wasm.numbers(this.#wasm.scratch, 2);
        return status === "ok" ? { status, departure, lower, upper } : { status, departure, lower: null, upper: null };
    }

    /**
     * The latest departure for an arrival.
     * @param {number} arrival may be infinite: the last departure of all
     * @returns {TableDeparture}
     */
    departure(arrival) {
        const status = this.#wasm.answer(this.#wasm.call("table_departure", this.#handle, readTime(arrival, "arrival", true), this.#wasm.scratch));
        const [departure, departureUpper] = this.#wasm.numbers(this.#wasm.scratch, 2);
        return status === "ok" ? { status, arrival, departure, departureUpper } : { status, arrival, departure: null, departureUpper: null };
    }

    /**
     * The path that the table gives for a departure: that of its row, moved earlier, so that its arcs lie off their discs as these are then.
     * @param {number} departure
     * @returns {TablePath}
     */
    path(departure) {
        const wasm = this.#wasm;
        const status = wasm.answer(wasm.call("table_find", this.#handle, readTime(departure, "departure"), wasm.scratch));
        if (status !== "ok") return { status, departure, arrival: null, row: null, computed_for: null, legs: [] };
        const [row, computed_for, left] = wasm.numbers(wasm.scratch, 3);
        wasm.answer(wasm.call("table_path", this.#handle, departure, wasm.scratch));
        const legs = readLegs(wasm.take());
        return { status, departure, arrival: legs.length > 0 ? legs[legs.length - 1].end_time : departure + left, row, computed_for, legs };
    }

    /**
     * Where the travel time jumps.
     * @returns {TableJump[]}
     */
    jumps() {
        const wasm = this.#wasm;
        /** @type {TableJump[]} */
        const jumps = [];
        for (let from = 0; ; ) {
            const code = wasm.call("table_next_jump", this.#handle, from, wasm.scratch);
            if (wasm.names[code] === "no_answer") return jumps;
            wasm.answer(code);
            const n = wasm.numbers(wasm.scratch, 4 + GAP_NUMBERS).slice();
            jumps.push({ row: n[0], departure: n[1], travelBefore: n[2], travelAfter: n[3], size: n[3] - n[2], gap: readGap(n, 4) });
            from = nextUp(n[1]);
        }
    }
}

/**
 * The next double after one that is not negative.
 * @param {number} number
 */
function nextUp(number) {
    const view = new DataView(new ArrayBuffer(8));
    view.setFloat64(0, number);
    view.setBigInt64(0, view.getBigInt64(0) + 1n);
    return view.getFloat64(0);
}
