// SPDX-License-Identifier: MIT
/**
 * The module and its memory. Invariant: no view of the memory outlives a call into the module, for a call may make the memory grow, which detaches every view;
 * whatever is kept is a copy.
 */
import { CoreError } from "./core_error.js";

/** @typedef {(settled: number, all: number) => (boolean | void)} Progress told how far it is; true cancels */

export const SCRATCH_NUMBERS = 64; // for arguments and results of one call
const STATUSES = 128; // codes are below this
const ANSWERS = 16; // and those that are answers, below this

export class Wasm {
    /** @type {Record<string, any>} */ #exports;
    /** @type {Progress | null} */ #progress = null;
    /** @type {{error: unknown} | null} */ #thrown = null;
    #inside = false;
    #broken = false;

    /** @param {BufferSource} bytes */
    static async load(bytes) {
        const wasm = new Wasm();
        const { instance } = await WebAssembly.instantiate(bytes, { tdsp: { progress: (/** @type {number} */ settled, /** @type {number} */ all) => wasm.#told(settled, all) } });
        wasm.#exports = instance.exports;
        wasm.#exports._initialize();
        wasm.scratch = wasm.allocate(SCRATCH_NUMBERS * 8);
        wasm.#readStatuses();
        return wasm;
    }

    constructor() {
        this.#exports = {};
        this.scratch = 0;
        /** @type {string[]} */ this.names = [];
        /** @type {Map<string, string>} */ this.texts = new Map();
    }

    #readStatuses() {
        for (let code = 0; code < STATUSES; code++) {
            const name = this.string(this.call("status_name", code));
            this.names.push(name);
            if (!this.texts.has(name)) this.texts.set(name, this.string(this.call("status_text", code)));
        }
    }

    /**
     * @param {number} settled
     * @param {number} all
     */
    #told(settled, all) {
        if (!this.#progress) return 0;
        this.#inside = true;
        try {
            return this.#progress(settled, all) === true ? 1 : 0;
        } catch (error) {
            this.#thrown = { error }; // thrown on when C has cleaned up
            return 1;
        } finally {
            this.#inside = false;
        }
    }

    /**
     * Call an exported function.
     * @param {string} name
     * @param {...any} args
     * @returns {any}
     */
    call(name, ...args) {
        if (this.#inside) throw new CoreError("progress may not ask the core: it is busy", "invalid_argument");
        if (this.#broken) throw new CoreError("the core failed before and has to be loaded again", "failed");
        try {
            return this.#exports[name](...args);
        } catch (error) {
            this.#broken = true;
            throw new CoreError(`the core failed: ${error instanceof Error ? error.message : error}`, "failed");
        }
    }

    /**
     * Call one that tells its progress.
     * @param {Progress | undefined} progress
     * @param {string} name
     * @param {...any} args
     * @returns {any}
     */
    callTelling(progress, name, ...args) {
        this.#progress = progress ?? null;
        this.#thrown = null;
        const result = this.call(name, ...args);
        this.#progress = null;
        const thrown = /** @type {{error: unknown} | null} */ (this.#thrown);
        if (thrown) throw thrown.error;
        return result;
    }

    /**
     * A status's name; throws what is no answer.
     * @param {number} code
     * @returns {string}
     */
    answer(code) {
        if (code >= ANSWERS) throw new CoreError(this.reason(this.names[code]), this.names[code]);
        return this.names[code];
    }

    /**
     * A status as the end of a sentence.
     * @param {string} status
     */
    reason(status) {
        const text = this.texts.get(status) ?? "an unknown status";
        return text[0].toLowerCase() + text.slice(1);
    }

    /** @param {number} size in bytes */
    allocate(size) {
        const at = this.call("allocate", size) >>> 0; // addresses over 2 GiB come back negative
        if (!at) throw new CoreError(this.reason("no_memory"), "no_memory");
        return at;
    }

    /** @returns {number} */
    get memoryBytes() {
        return this.#exports.memory.buffer.byteLength;
    }

    /** @param {number} at */
    release(at) {
        this.call("release", at);
    }

    /** @param {number} [index] of 32-bit words */
    word(index = 0) {
        return new DataView(this.#exports.memory.buffer).getUint32(this.scratch + 4 * index, true);
    }

    /**
     * A view: use it up before the next call.
     * @param {number} at
     * @param {number} count
     */
    numbers(at, count) {
        return new Float64Array(this.#exports.memory.buffer, at, count);
    }

    /**
     * A view: use it up before the next call.
     * @param {number} at
     * @param {number} length
     */
    bytes(at, length) {
        return new Uint8Array(this.#exports.memory.buffer, at, length);
    }

    /** The array that a call wrote to scratch as PageNumbers, copied and released. */
    take() {
        const at = this.word(0);
        const copy = this.numbers(at, this.word(1)).slice();
        this.release(at);
        return copy;
    }

    /**
     * Run with blocks that hold these, numbers or text ended by a zero; they are released whatever happens.
     * @template T
     * @param {(ArrayLike<number> | string)[]} parts
     * @param {(...at: number[]) => T} run
     * @returns {T}
     */
    lend(parts, run) {
        /** @type {number[]} */
        const blocks = [];
        try {
            for (const part of parts) blocks.push(typeof part === "string" ? this.#giveText(part) : this.#giveNumbers(part));
            return run(...blocks);
        } finally {
            if (!this.#broken) for (const block of blocks) this.release(block);
        }
    }

    /** @param {ArrayLike<number>} numbers */
    #giveNumbers(numbers) {
        const at = this.allocate(8 * numbers.length);
        this.numbers(at, numbers.length).set(numbers);
        return at;
    }

    /** @param {string} text */
    #giveText(text) {
        const encoded = new TextEncoder().encode(`${text}\0`);
        const at = this.allocate(encoded.length);
        this.bytes(at, encoded.length).set(encoded);
        return at;
    }

    /**
     * Text up to its zero.
     * @param {number} at
     */
    string(at) {
        const all = new Uint8Array(this.#exports.memory.buffer, at);
        return new TextDecoder().decode(all.slice(0, all.indexOf(0)));
    }
}
