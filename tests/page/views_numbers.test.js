// SPDX-License-Identifier: MIT
/** Numbers and ticks are those of `tdsp plot`. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { lengthAxis, niceStep, ticksOf } from "../../tools/page/js/axes.js";
import { brief, digitsFor, number, withUnit } from "../../tools/page/js/numbers.js";

/** What the C library writes. @param {string} format @param {number[]} values */
function printf(format, values) {
    const text = execFileSync("printf", [`${format}\n`, ...values.map(String)], { encoding: "utf8", env: { LC_ALL: "C" } });
    return text.trim().split("\n");
}

const VALUES = [0, 1, -1, 0.1, 52.5000894, 4497.681824, 1e-4, 9.99999e-5, 1e6, 999999.5, 1234567.89, 1e21, -3.25e-17, 2137.3229617, 0.30000000000000004];

for (const digits of [2, 5, 6, 7, 10, 15])
    test(`numbers of ${digits} digits are printf's`, () => assert.deepEqual(VALUES.map((value) => brief(value, digits)), printf(`%.${digits}g`, VALUES)));

test("a negative number has a true minus sign", () => assert.equal(number(-2.5), "\u22122.5"));

test("a label has all digits before the point", () => {
    assert.equal(number(200000, 5), "200000");
    assert.equal(number(-356330.4, 5), "\u2212356330");
    assert.equal(number(999999.7, 5), "999999.7");
    assert.equal(number(2e9, 5), "2e+09");
});

test("a unit stands behind its number, and no unit leaves no space", () => {
    assert.equal(withUnit(52.50008940356232, "s", 6), "52.5001 s");
    assert.equal(withUnit(5, ""), "5");
});

test("what is infinite or no number says so", () => assert.deepEqual([Infinity, -Infinity, NaN].map((value) => brief(value, 6)), ["inf", "-inf", "nan"]));

test("neighbours are told apart by as many digits as that takes", () => {
    assert.equal(digitsFor(1000000.25, 0.05), 9);
    assert.equal(digitsFor(3, 1), 4);
});

test("steps are 1, 2 or 5 times a power of ten", () => {
    assert.equal(niceStep(5252, 10), 500);
    assert.equal(niceStep(21.7, 9), 2);
    assert.equal(niceStep(0.003, 4), 0.001);
});

test("ticks are within the range, and none is written as minus zero", () => {
    const ticks = ticksOf(-0.4, 0.4, 380, { name: "x", unit: "m", divisor: 1 });
    assert.deepEqual(ticks.map((tick) => tick.text), ["\u22120.4", "\u22120.2", "0", "0.2", "0.4"]);
});

test("ticks far from the origin keep the digits that tell them apart", () => {
    const ticks = ticksOf(1e6, 1e6 + 1e-5, 380, { name: "x", unit: "m", divisor: 1 });
    assert.equal(new Set(ticks.map((tick) => tick.text)).size, ticks.length);
    assert.ok(ticks.length >= 3);
});

test("no range has no ticks, instead of endless ones", () => {
    const axis = { name: "x", unit: "m", divisor: 1 };
    assert.deepEqual(ticksOf(1, 1, 100, axis), []);
    assert.deepEqual(ticksOf(NaN, 1, 100, axis), []);
    assert.deepEqual(ticksOf(0, 1, 0, axis), []);
});

test("many metres are kilometres", () => {
    assert.deepEqual(lengthAxis("x", "m", 5000), { name: "x", unit: "km", divisor: 1000 });
    assert.deepEqual(lengthAxis("x", "m", 4999), { name: "x", unit: "m", divisor: 1 });
    assert.deepEqual(lengthAxis("x", "", 1e9), { name: "x", unit: "", divisor: 1 });
});

test("ticks of a range finer than the numbers in it end", () => {
    const axis = { name: "x", unit: "m", divisor: 1 };
    assert.ok(ticksOf(1e17, 1e17 + 64, 500, axis).length <= 1000);
    assert.ok(ticksOf(-Infinity, Infinity, 500, axis).length === 0);
});
