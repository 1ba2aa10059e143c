// SPDX-License-Identifier: MIT
// JSON read strictly, and told where it is wrong: JSON.parse() names no line in some browsers, takes the last of two equal keys in silence, and makes
// 1e999 infinite. What is refused here is what the command refuses.

const DEEPEST = 64;
const NUMBER = /-?(?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?/y;
const ESCAPES = { '"': '"', "\\": "\\", "/": "/", b: "\b", f: "\f", n: "\n", r: "\r", t: "\t" };

/** Where a text is wrong, and why. */
export class JsonError extends Error {
  /** @param {string} text @param {number} at @param {string} reason */
  constructor(text, at, reason) {
    super(reason);
    const before = text.slice(0, at);
    this.line = before.split("\n").length;
    this.column = at - before.lastIndexOf("\n");
  }
}

class Reader {
  /** @param {string} text */
  constructor(text) {
    this.text = text;
    this.at = 0;
    /** Where each value begins that someone wants to find again: its path, as in discs[3].radius. @type {Map<string, number>|null} */
    this.places = null;
  }

  fail(reason, at = this.at) {
    throw new JsonError(this.text, at, reason);
  }

  skip() {
    for (;;) {
      const code = this.text.charCodeAt(this.at);
      if (code !== 32 && code !== 10 && code !== 13 && code !== 9) return;
      this.at++;
    }
  }

  /** The next character that is no space, not consumed; "" at the end. */
  peek() {
    this.skip();
    return this.text.charAt(this.at);
  }

  value(path, depth) {
    const next = this.peek();
    this.places?.set(path, this.at);
    if (depth > DEEPEST) this.fail(`nested more than ${DEEPEST} deep`);
    if (next === "{") return this.object(path, depth);
    if (next === "[") return this.array(path, depth);
    if (next === '"') return this.string();
    if (next === "-" || (next >= "0" && next <= "9")) return this.number();
    return this.word(next);
  }

  word(next) {
    for (const [word, value] of [["true", true], ["false", false], ["null", null]]) {
      if (this.text.startsWith(word, this.at)) {
        this.at += word.length;
        return value;
      }
    }
    return this.fail(next === "" ? "the file ends too soon" : "expected a value");
  }

  number() {
    NUMBER.lastIndex = this.at;
    const found = NUMBER.exec(this.text);
    if (!found) return this.fail("not a number");
    const value = Number(found[0]);
    if (!Number.isFinite(value)) this.fail("the number is too large");
    this.at += found[0].length;
    return value;
  }

  string() {
    let out = "";
    const start = this.at++;
    for (;;) {
      const char = this.text.charAt(this.at);
      if (char === "") this.fail("a string without an end", start);
      if (char < " ") this.fail("a control character in a string");
      this.at++;
      if (char === '"') return out;
      out += char === "\\" ? this.escape() : char;
    }
  }

  escape() {
    const char = this.text.charAt(this.at++);
    if (char === "u") {
      const digits = this.text.slice(this.at, this.at + 4);
      if (!/^[0-9a-fA-F]{4}$/.test(digits)) this.fail("\\u needs four hexadecimal digits");
      this.at += 4;
      return String.fromCharCode(parseInt(digits, 16));
    }
    return ESCAPES[char] ?? this.fail("an escape that JSON does not know", this.at - 1);
  }

  array(path, depth) {
    const out = [];
    this.at++;
    if (this.peek() === "]") return this.close(out);
    for (;;) {
      out.push(this.value(`${path}[${out.length}]`, depth + 1));
      if (this.peek() === "]") return this.close(out);
      this.expect(",", "expected a comma or ]");
    }
  }

  object(path, depth) {
    const out = {};
    this.at++;
    if (this.peek() === "}") return this.close(out);
    for (;;) {
      if (this.peek() !== '"') this.fail("expected a key in quotes");
      const at = this.at;
      const key = this.string();
      if (Object.hasOwn(out, key)) this.fail(`the key "${key}" is there twice`, at);
      if (this.peek() !== ":") this.fail("expected a colon");
      this.at++;
      const value = this.value(path === "" ? key : `${path}.${key}`, depth + 1);
      Object.defineProperty(out, key, { value, enumerable: true, writable: true, configurable: true });
      if (this.peek() === "}") return this.close(out);
      this.expect(",", "expected a comma or }");
    }
  }

  close(out) {
    this.at++;
    return out;
  }

  expect(char, reason) {
    if (this.peek() !== char) this.fail(this.peek() === "" ? "the file ends too soon" : reason);
    this.at++;
  }

  all() {
    const value = this.value("", 0);
    if (this.peek() !== "") this.fail("there is more after the end");
    return value;
  }
}

/** The value of `text`; throws JsonError. @param {string} text @returns {any} */
export function parseJson(text) {
  return new Reader(text).all();
}

/** Line and column of the value at `path`, as "discs[3].radius"; of the closest one around it where there is none. @param {string} text @param {string} path */
export function locate(text, path) {
  const reader = new Reader(text);
  reader.places = new Map();
  reader.all();
  let wanted = path;
  while (!reader.places.has(wanted)) wanted = wanted.replace(/(^|\.?)[^.[\]]*$|\[\d*\]$/, "");
  const { line, column } = new JsonError(text, reader.places.get(wanted), "");
  return { line, column };
}
