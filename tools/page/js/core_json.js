// SPDX-License-Identifier: MIT
/**
 * A strict reader of JSON for scene files: JSON.parse() keeps the last of two equal keys, turns 1e999 to infinity, and says where a mistake is in the browser's own
 * words, if at all. Takes and refuses what tools/tdsp/json_scan.c does, in the same words.
 *
 * Invariant: a method is called with the cursor on the first character of its production and leaves it just behind, or throws Wrong with the offending place.
 */
import { CoreError } from "./core_error.js";

const DEPTH = 32; // a scene needs 4
const WORDS = /** @type {Record<string, boolean | null>} */ ({ true: true, false: false, null: null });
const ESCAPES = /** @type {Record<string, string>} */ ({ '"': '"', "\\": "\\", "/": "/", b: "\b", f: "\f", n: "\n", r: "\r", t: "\t" });
const NUMBER = /-?(?:0(?![\dA-DF-Za-df-z])|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y;

class Wrong {
    /**
     * @param {number} at
     * @param {string} reason
     */
    constructor(at, reason) {
        this.at = at;
        this.reason = reason;
    }
}

class Scan {
    #at = 0;
    #depth = 0;
    #text;

    /** @param {string} text */
    constructor(text) {
        this.#text = text;
    }

    document() {
        const value = this.#value();
        this.#space();
        if (this.#at < this.#text.length) throw new Wrong(this.#at, "something follows the end of the JSON value");
        return value;
    }

    get #ended() {
        return this.#at >= this.#text.length;
    }

    get #next() {
        return this.#text[this.#at];
    }

    #space() {
        while (!this.#ended && " \t\r\n".includes(this.#next)) this.#at++;
    }

    /** @returns {unknown} */
    #value() {
        this.#space();
        const first = this.#next;
        if (first === "{" || first === "[") return this.#bracketed(first === "{");
        if (first === '"') return this.#string();
        if (first === "-" || (first >= "0" && first <= "9")) return this.#number();
        return this.#word();
    }

    /**
     * An object or an array: items between brackets, with separators.
     * @param {boolean} isObject
     */
    #bracketed(isObject) {
        if (this.#depth === DEPTH) throw new Wrong(this.#at, "nested too deeply");
        const close = isObject ? "}" : "]";
        /** @type {Map<string, unknown>} */ const members = new Map();
        /** @type {unknown[]} */ const items = [];
        this.#depth++;
        this.#at++;
        this.#space();
        let more = this.#next !== close;
        if (!more) this.#at++;
        while (more) {
            if (isObject) this.#member(members);
            else items.push(this.#value());
            more = this.#separator(close);
        }
        this.#depth--;
        return isObject ? Object.fromEntries(members) : items;
    }

    /** @param {Map<string, unknown>} members */
    #member(members) {
        const start = this.#at;
        if (this.#text[start] !== '"') throw new Wrong(start, this.#ended ? "the text ends too early" : "expected a key in double quotes");
        const key = this.#string();
        if (members.has(key)) throw new Wrong(start, `duplicate key: ${key}`);
        this.#space();
        if (this.#next !== ":") throw new Wrong(this.#at, "expected a colon after the key");
        this.#at++;
        members.set(key, this.#value());
    }

    /**
     * A comma, or the closing bracket; true when more follows.
     * @param {string} close
     */
    #separator(close) {
        this.#space();
        const more = this.#next === ",";
        if (!more && this.#next !== close) throw new Wrong(this.#at, this.#ended ? "the text ends too early" : `expected a comma or ${close}`);
        this.#at++;
        if (more) this.#space();
        return more;
    }

    /** @returns {string} */
    #string() {
        const start = this.#at++;
        let value = "";
        for (let from = this.#at; ; ) {
            const next = this.#next;
            if (this.#ended) throw new Wrong(start, "a string that never ends");
            if (next < " ") throw new Wrong(this.#at, "a control character in a string");
            if (next !== '"' && next !== "\\") {
                this.#at++;
                continue;
            }
            value += this.#text.slice(from, this.#at);
            if (next === '"') break;
            value += this.#escape();
            from = this.#at;
        }
        this.#at++;
        return value;
    }

    #escape() {
        const name = this.#text[this.#at + 1];
        if (name === "u") return this.#unicode();
        if (!Object.hasOwn(ESCAPES, name ?? "")) throw new Wrong(this.#at, "unknown escape in a string");
        this.#at += 2;
        return ESCAPES[name];
    }

    /** \uXXXX, or two of them for a character beyond the first plane. */
    #unicode() {
        const start = this.#at;
        const high = this.#hexadecimal();
        if (Number.isNaN(high)) throw new Wrong(start, "a \\u escape needs four hexadecimal digits");
        if (high === 0) throw new Wrong(start, "a zero character in a string");
        if (high < 0xd800 || high >= 0xe000) return String.fromCharCode(high);
        const low = this.#text.startsWith("\\u", this.#at) ? this.#hexadecimal() : NaN;
        if (high >= 0xdc00 || !(low >= 0xdc00 && low < 0xe000)) throw new Wrong(start, "half of a surrogate pair");
        return String.fromCharCode(high, low);
    }

    #hexadecimal() {
        const digits = this.#text.slice(this.#at + 2, this.#at + 6);
        this.#at += 6;
        return /^[\da-fA-F]{4}$/.test(digits) ? parseInt(digits, 16) : NaN;
    }

    #number() {
        NUMBER.lastIndex = this.#at;
        const token = NUMBER.exec(this.#text)?.[0] ?? "";
        const next = this.#text.charAt(this.#at + token.length);
        const cut = /[eE]/.test(token) ? "" : token.includes(".") ? "eE" : ".eE"; // what would have gone on, had digits followed
        if (!token || (next && cut.includes(next))) throw new Wrong(this.#at, "not a number as JSON writes them");
        const value = Number(token);
        if (!Number.isFinite(value)) throw new Wrong(this.#at, "a number too large for a double");
        this.#at += token.length;
        return value;
    }

    #word() {
        const word = /^[\dA-Za-z]*/.exec(this.#text.slice(this.#at, this.#at + 41))?.[0] ?? "";
        if (Object.hasOwn(WORDS, word)) {
            this.#at += word.length;
            return WORDS[word];
        }
        if (this.#ended) throw new Wrong(this.#at, "the text ends too early");
        throw new Wrong(this.#at, word ? `not a JSON value: ${word.slice(0, 40)}` : "expected a value");
    }
}

/**
 * Text from bytes, as far as these are UTF-8, and whether that is all.
 * @param {Uint8Array} bytes
 */
function decode(bytes) {
    const start = (/** @type {number} */ length, stream = true) => new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes.subarray(0, length), { stream });
    try {
        return { text: start(bytes.length, false), whole: true };
    } catch {
        let [good, bad] = [0, bytes.length + 1]; // a start of `good` bytes is fine, one of `bad` is not
        while (bad - good > 1) {
            const middle = (good + bad) >> 1;
            try {
                start(middle);
                good = middle;
            } catch {
                bad = middle;
            }
        }
        return { text: start(good), whole: false };
    }
}

/**
 * @param {string} text
 * @param {Wrong} wrong
 */
function refusal(text, { at, reason }) {
    const lines = text.slice(0, at).split("\n");
    const column = [...lines[lines.length - 1]].length + 1; // in characters
    return new CoreError(`line ${lines.length}, column ${column}: ${reason}`, "bad_scene", `${lines.length}:${column}`);
}

/**
 * Parse a whole document.
 * @param {string | Uint8Array} source
 * @returns {any}
 */
export function parseJson(source) {
    const decoded = typeof source === "string" ? { text: source, whole: true } : decode(source);
    const text = decoded.text.replace(/^\ufeff/, "");
    if (!/^[ \t\r\n]*[[{]/.test(text)) throw new CoreError("this is neither JSON nor a table", "bad_scene");
    try {
        if (text.includes("\0")) throw new Wrong(text.indexOf("\0"), "a zero byte");
        if (!decoded.whole) throw new Wrong(text.length, "not UTF-8");
        return new Scan(text).document();
    } catch (error) {
        throw error instanceof Wrong ? refusal(text, error) : error;
    }
}
