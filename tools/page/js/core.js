// SPDX-License-Identifier: MIT
/**
 * libtdsp in JavaScript: exact earliest arrivals among growing discs, and certified tables of them, by the C library itself, compiled to WebAssembly. Needs the module's
 * bytes (build/page/tdsp.wasm) and nothing else: no page, no server. docs/page.md shows how to use it in a page of your own.
 *
 * Whatever is wrong is a CoreError with a sentence, the library's stable status and, in a description, the place.
 */
import { CoreError } from "./core_error.js";
import { parseJson } from "./core_json.js";
import { Scene } from "./core_scene.js";
import { Table } from "./core_table.js";
import { writeLeg } from "./core_legs.js";
import { Wasm } from "./core_wasm.js";

export { CoreError };

/** @typedef {import("./core_description.js").Description} Description */
/** @typedef {import("./core_legs.js").Leg} Leg */
/** @typedef {import("./core_legs.js").Place} Place */
/** @typedef {import("./core_legs.js").Gap} Gap */

export class Core {
    /** @type {Wasm} */ #wasm;
    /** Of the library. @type {string} */ version;

    /** @param {Wasm} wasm */
    constructor(wasm) {
        this.#wasm = wasm;
        this.version = wasm.string(wasm.call("version"));
    }

    /**
     * The description in a scene file's text. Strict, where JSON.parse() is not: two equal keys, or a number too large for a double, are refused with their place.
     * @param {string | Uint8Array} source
     * @returns {Description} as far as it is JSON: scene() checks the rest
     */
    parse(source) {
        return parseJson(source);
    }

    /**
     * Check and prepare a scene; scene.free() gives its memory back.
     * @param {Description} description the parsed JSON of a scene file
     */
    scene(description) {
        return new Scene(this.#wasm, description);
    }

    /**
     * Open a table; table.free() gives its memory back.
     * @param {Uint8Array} bytes copied
     */
    table(bytes) {
        return new Table(this.#wasm, bytes);
    }

    /**
     * Where the robot is at a time, which is clamped to the leg.
     * @param {Leg} leg
     * @param {number} time
     * @returns {Place}
     */
    position(leg, time) {
        const at = this.#wasm.scratch;
        const numbers = writeLeg(leg);
        this.#wasm.numbers(at, numbers.length).set(numbers);
        this.#wasm.call("leg_position", at, time, at);
        const [x, y] = this.#wasm.numbers(at, 2);
        return [x, y];
    }

    /**
     * One English sentence without a full stop for a status such as "cut_off".
     * @param {string} status
     */
    statusText(status) {
        const text = this.#wasm.texts.get(status);
        if (text === undefined || status === "unknown") throw new CoreError(`there is no status "${status}"`, "invalid_argument");
        return text;
    }

    /** Blocks of the module's memory that are held: the same again once everything was freed. @returns {number} */
    get blocksHeld() {
        return this.#wasm.call("blocks_held");
    }

    /** Bytes of the module's memory, which never becomes smaller. */
    get memoryBytes() {
        return this.#wasm.memoryBytes;
    }
}

/**
 * Make a core from the bytes of tdsp.wasm. Each has a memory of its own.
 * @param {BufferSource} bytes
 * @returns {Promise<Core>}
 */
export async function loadCore(bytes) {
    return new Core(await Wasm.load(bytes));
}
