// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";
import { JsonError, locate, parseJson } from "../../tools/page/js/json.js";

/** Where and why a text is refused. */
function refused(text) {
  try {
    parseJson(text);
  } catch (error) {
    assert.ok(error instanceof JsonError, String(error));
    return `${error.line}:${error.column} ${error.message}`;
  }
  return assert.fail(`taken: ${text}`);
}

test("what JSON.parse reads is read alike", () => {
  for (const text of ['{"a": [1, -2.5e-3, true, false, null, "x\\n\\u00e9\\"\\\\"], "": {}}', " [] ", "0", '"\u{1f600}"', "-0", "[[[]]]", '{"__proto__": 1}']) {
    assert.deepEqual(JSON.stringify(parseJson(text)), JSON.stringify(JSON.parse(text)), text);
  }
});

test("every number comes back as the same double", () => {
  for (const value of [0.1, 1 / 3, 5e-324, 1.7976931348623157e308, 9849.623113198598]) assert.equal(parseJson(JSON.stringify(value)), value);
});

test("a wrong text is refused with its line, its column and the reason", () => {
  assert.equal(refused('{"a": 1,\n "b" 2}'), "2:6 expected a colon");
  assert.equal(refused('{"a": 1,\n "a": 2}'), '2:2 the key "a" is there twice');
  assert.equal(refused("[1 2]"), "1:4 expected a comma or ]");
  assert.equal(refused('{"a": [1}'), "1:9 expected a comma or ]");
  assert.equal(refused('{"a": 1e999}'), "1:7 the number is too large");
  assert.equal(refused('{"a": NaN}'), "1:7 expected a value");
  assert.equal(refused("{"), "1:2 expected a key in quotes");
  assert.equal(refused("[1,"), "1:4 the file ends too soon");
  assert.equal(refused("[1] x"), "1:5 there is more after the end");
  assert.equal(refused('"abc'), "1:1 a string without an end");
  assert.equal(refused("[01]"), "1:3 expected a comma or ]");
  assert.equal(refused("-"), "1:1 not a number");
  assert.equal(refused('"\\x"'), "1:3 an escape that JSON does not know");
  assert.equal(refused('"\\u12"'), "1:4 \\u needs four hexadecimal digits");
});

test("absurd nesting is refused and does not exhaust the stack", () => {
  assert.match(refused("[".repeat(200000)), /nested more than 64 deep/);
});

test("a place in a scene is found again in its text", () => {
  const text = '{"robot": {"speed": 1},\n "discs": [{"radius": 1},\n  {"radius": -2}]}';
  assert.deepEqual(locate(text, "discs[1].radius"), { line: 3, column: 14 });
  assert.deepEqual(locate(text, "robot.speed"), { line: 1, column: 21 });
  assert.deepEqual(locate(text, "discs[1].center"), { line: 3, column: 3 }, "what is missing is missing in what is around it");
  assert.deepEqual(locate(text, "source"), { line: 1, column: 1 });
});
