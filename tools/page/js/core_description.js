// SPDX-License-Identifier: MIT
/**
 * Scene descriptions (docs/cli.md, "The scene file") into numbers, as core/scene.c reads them. What is taken and what is refused, in which order and in which words,
 * is as in tools/tdsp/scene_description.c and growth_json.c; the library's own checks stay the last word.
 */
import { CoreError, sceneError } from "./core_error.js";
import { SCRATCH_NUMBERS } from "./core_wasm.js";

/** @typedef {import("./core_wasm.js").Wasm} Wasm */
/** @typedef {number | number[] | {times: number[], rates: number[]}} Growth a rate; coefficients of t, t^2, ...; rates from times on */
/** @typedef {{center: [number, number], radius: number, growth: Growth}} Disc */
/**
 * @typedef {Object} Description
 * @property {string} [name]
 * @property {{length?: string, time?: string}} [units]
 * @property {{origin: [number, number], projection?: string, ellipsoid?: string}} [georeference]
 * @property {{speed: number, radius?: number}} robot
 * @property {[number, number]} source
 * @property {[number, number]} destination
 * @property {Disc[]} discs
 */
/** @typedef {{numbers: Float64Array, count: number, units: {length: string, time: string}, warnings: string[]}} Read */

const MOST_WARNINGS = 20;
const MOST_COEFFICIENTS = 8;
const LARGEST = 1e100; // as the library has it
const KINDS = { rate: 0, polynomial: 1, rates: 2 };

/** @param {unknown} value */
function typeOf(value) {
    if (value === null) return "null";
    if (Array.isArray(value)) return "an array";
    const types = /** @type {Record<string, string>} */ ({ object: "an object", string: "a string", boolean: "true or false", number: "a number" });
    return types[typeof value] ?? typeof value;
}

/** Typed access, with places in its messages. A place is a member path: "discs[3].radius". */
class Reader {
    /** @type {string[]} */ warnings = [];
    /** @type {Set<string>} */ #warned = new Set();

    /**
     * @param {unknown} value
     * @param {string} where
     * @returns {Record<string, unknown>}
     */
    object(value, where) {
        if (typeof value !== "object" || value === null || Array.isArray(value)) throw sceneError(where, `must be an object, not ${typeOf(value)}`);
        return /** @type {Record<string, unknown>} */ (value);
    }

    /**
     * @param {unknown} value
     * @param {string} where
     * @returns {unknown[]}
     */
    array(value, where) {
        if (!Array.isArray(value)) throw sceneError(where, `must be an array, not ${typeOf(value)}`);
        return value;
    }

    /**
     * @param {unknown} value
     * @param {string} where
     * @returns {number}
     */
    number(value, where) {
        if (typeof value !== "number") throw sceneError(where, `must be a number, not ${typeOf(value)}`);
        if (Number.isNaN(value)) throw sceneError(where, "not a number as JSON writes them");
        if (!Number.isFinite(value)) throw sceneError(where, "a number too large for a double");
        return value;
    }

    /**
     * @param {unknown} value
     * @param {string} where
     * @returns {[number, number]}
     */
    point(value, where) {
        const items = this.array(value, where);
        if (items.length !== 2) throw sceneError(where, `a point has exactly two numbers, not ${items.length}`);
        return [this.number(items[0], `${where}[0]`), this.number(items[1], `${where}[1]`)];
    }

    /**
     * @param {unknown} value
     * @param {string} where
     */
    notNegative(value, where) {
        const number = this.number(value, where);
        if (number < 0) throw sceneError(where, "must not be negative");
        return number;
    }

    /**
     * A member that must be there, read by `read`.
     * @template T
     * @param {Record<string, unknown>} object
     * @param {string} name
     * @param {string} above
     * @param {(this: Reader, value: unknown, where: string) => T} read
     * @returns {T}
     */
    member(object, name, above, read) {
        const where = above ? `${above}.${name}` : name;
        if (!has(object, name)) throw sceneError(where, "missing");
        return read.call(this, object[name], where);
    }

    /**
     * An optional string.
     * @param {Record<string, unknown>} object
     * @param {string} name
     * @param {string} where
     */
    text(object, name, where) {
        if (!has(object, name)) return "";
        const value = object[name];
        if (typeof value !== "string") throw sceneError(where, `must be a string, not ${typeOf(value)}`);
        return value;
    }

    /**
     * Warn of unknown keys, once for each under each kind of place.
     * @param {Record<string, unknown>} object
     * @param {string} where
     * @param {string[]} known
     */
    warn(object, where, known) {
        for (const name of Object.keys(object)) {
            if (known.includes(name) || object[name] === undefined) continue;
            const kind = (where ? `${where}.${name}` : name).replace(/\[\d+\]/g, "[]");
            if (this.#warned.size > MOST_WARNINGS || this.#warned.has(kind)) continue;
            this.#warned.add(kind);
            this.warnings.push(this.#warned.size > MOST_WARNINGS ? "more unknown keys ignored" : `${kind}: unknown key ignored`);
        }
    }
}

/**
 * @param {Record<string, unknown>} object
 * @param {string} name
 */
function has(object, name) {
    return Object.hasOwn(object, name) && object[name] !== undefined;
}

/**
 * @param {Reader} reader
 * @param {Record<string, unknown>} root
 */
function readUnits(reader, root) {
    if (!has(root, "units")) return { length: "", time: "" };
    const units = reader.object(root.units, "units");
    const read = { length: reader.text(units, "length", "units.length"), time: reader.text(units, "time", "units.time") };
    reader.warn(units, "units", ["length", "time"]);
    return read;
}

/**
 * @param {Reader} reader
 * @param {Record<string, unknown>} root
 */
function readGeoreference(reader, root) {
    if (!has(root, "georeference")) return;
    const where = "georeference";
    const value = reader.object(root.georeference, where);
    const [longitude, latitude] = reader.member(value, "origin", where, reader.point);
    for (const [name, only] of [["projection", "azimuthal equidistant"], ["ellipsoid", "WGS84"]])
        if (has(value, name) && reader.text(value, name, `${where}.${name}`) !== only) throw sceneError(`${where}.${name}`, `must be "${only}"`);
    if (Math.abs(latitude) > 90) throw sceneError(`${where}.origin`, "a latitude is from -90 to 90");
    if (Math.abs(longitude) > 180) throw sceneError(`${where}.origin`, "a longitude is from -180 to 180");
    reader.warn(value, where, ["origin", "projection", "ellipsoid"]);
}

/**
 * @param {Reader} reader
 * @param {Record<string, unknown>} root
 */
function readRobot(reader, root) {
    const robot = reader.member(root, "robot", "", reader.object);
    const speed = reader.member(robot, "speed", "robot", reader.number);
    if (!(speed > 0)) throw sceneError("robot.speed", "must be greater than zero");
    const radius = has(robot, "radius") ? reader.notNegative(robot.radius, "robot.radius") : 0;
    reader.warn(robot, "robot", ["speed", "radius"]);
    return [speed, radius];
}

/**
 * @param {Reader} reader
 * @param {unknown[]} coefficients
 * @param {string} where
 */
function readPolynomial(reader, coefficients, where) {
    if (coefficients.length === 0) throw sceneError(where, "has no coefficient");
    if (coefficients.length > MOST_COEFFICIENTS)
        throw sceneError(where, `${coefficients.length} coefficients, where at most ${MOST_COEFFICIENTS} are supported`);
    const values = coefficients.map((item, i) => {
        const value = reader.number(item, `${where}[${i}]`);
        if (Math.abs(value) > LARGEST) throw sceneError(`${where}[${i}]`, "is beyond 1e100");
        return value;
    });
    return [KINDS.polynomial, values.length, ...values];
}

/**
 * @param {Reader} reader
 * @param {unknown} value
 * @param {string} where
 */
function readRate(reader, value, where) {
    const rate = reader.number(value, where);
    if (rate < 0) throw sceneError(where, "must not be negative: discs never shrink");
    return rate;
}

/**
 * @param {Reader} reader
 * @param {Record<string, unknown>} growth
 * @param {string} where
 */
function readTimes(reader, growth, where) {
    const items = reader.member(growth, "times", where, reader.array);
    if (items.length === 0) throw sceneError(`${where}.times`, "is empty");
    const times = items.map((item, i) => reader.number(item, `${where}.times[${i}]`));
    if (times[0] !== 0) throw sceneError(`${where}.times[0]`, "the first time must be 0");
    const late = times.findIndex((time, i) => i > 0 && !(time > times[i - 1]));
    if (late >= 0) throw sceneError(`${where}.times[${late}]`, "times must increase");
    return times;
}

/**
 * @param {Reader} reader
 * @param {Record<string, unknown>} growth
 * @param {string} where
 */
function readRates(reader, growth, where) {
    const times = readTimes(reader, growth, where);
    const items = reader.member(growth, "rates", where, reader.array);
    if (items.length !== times.length) throw sceneError(`${where}.rates`, `${items.length} rates for ${times.length} times`);
    const rates = items.map((item, i) => readRate(reader, item, `${where}.rates[${i}]`));
    reader.warn(growth, where, ["times", "rates"]);
    return [KINDS.rates, rates.length, ...rates, ...times];
}

/**
 * Kind, count, values, times.
 * @param {Reader} reader
 * @param {unknown} value
 * @param {string} where
 * @returns {number[]}
 */
function readGrowth(reader, value, where) {
    if (Array.isArray(value)) return readPolynomial(reader, value, where);
    if (typeof value === "object" && value !== null) return readRates(reader, reader.object(value, where), where);
    return [KINDS.rate, 1, readRate(reader, value, where)];
}

/**
 * What the library says of numbers.
 * @param {Wasm} wasm
 * @param {string} check
 * @param {number[]} numbers
 * @param {string} where
 */
function checkNumbers(wasm, check, numbers, where) {
    let sentence;
    if (numbers.length <= SCRATCH_NUMBERS) {
        wasm.numbers(wasm.scratch, numbers.length).set(numbers);
        sentence = wasm.call(check, wasm.scratch);
    } else {
        sentence = wasm.lend([numbers], (at) => wasm.call(check, at));
    }
    if (sentence) throw sceneError(where, wasm.string(sentence));
}

/**
 * @param {Wasm} wasm
 * @param {Reader} reader
 * @param {unknown} value
 * @param {string} where
 * @returns {number[]}
 */
function readDisc(wasm, reader, value, where) {
    const disc = reader.object(value, where);
    const center = reader.member(disc, "center", where, reader.point);
    const radius = reader.member(disc, "radius", where, reader.notNegative);
    if (!has(disc, "growth")) throw sceneError(`${where}.growth`, "missing");
    checkNumbers(wasm, "disc_check", [...center, radius], where);
    const numbers = [...center, radius, ...readGrowth(reader, disc.growth, `${where}.growth`)];
    checkNumbers(wasm, "growth_check", numbers, `${where}.growth`);
    reader.warn(disc, where, ["center", "radius", "growth"]);
    return numbers;
}

/**
 * Check a description whole, and turn it into numbers.
 * @param {Wasm} wasm
 * @param {unknown} description
 * @returns {Read}
 */
export function readDescription(wasm, description) {
    const reader = new Reader();
    const root = reader.object(description, "");
    reader.text(root, "name", "name");
    const units = readUnits(reader, root);
    readGeoreference(reader, root);
    const robot = readRobot(reader, root);
    const ends = [...reader.member(root, "source", "", reader.point), ...reader.member(root, "destination", "", reader.point)];
    const discs = reader.member(root, "discs", "", reader.array);
    /** @type {number[]} */
    const numbers = [...robot, ...ends];
    discs.forEach((disc, i) => {
        for (const number of readDisc(wasm, reader, disc, `discs[${i}]`)) numbers.push(number);
    });
    reader.warn(root, "", ["name", "units", "georeference", "robot", "source", "destination", "discs"]);
    checkNumbers(wasm, "journey_check", numbers.slice(0, 6), "");
    return { numbers: Float64Array.from(numbers), count: discs.length, units, warnings: reader.warnings };
}

/**
 * A moment that is asked about.
 * @param {unknown} value
 * @param {string} name
 * @param {boolean} [endless] may it be infinite?
 * @returns {number}
 */
export function readTime(value, name, endless = false) {
    if (typeof value === "number" && value >= 0 && (endless || Number.isFinite(value))) return value;
    throw new CoreError(`the ${name} must be a number, ${endless ? "" : "finite and "}not negative`, "invalid_argument", name);
}
