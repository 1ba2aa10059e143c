// SPDX-License-Identifier: MIT
/**
 * Numbers as people read them, by the rules of `tdsp plot`: so many significant digits, no zeros that say nothing, and a true minus
 * sign. The page and the command write the same number the same way.
 */

const MINUS = "\u2212";

/** Exponents as C writes them: at least two digits. @param {string} exponent */
function exponentOf(exponent) {
    const sign = exponent[0] === "-" ? "-" : "+";
    return `e${sign}${exponent.replace(/^[+-]/, "").padStart(2, "0")}`;
}

/** @param {string} text */
function withoutZeros(text) {
    return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

/**
 * What C's printf writes for "%.{digits}g".
 * @param {number} value
 * @param {number} digits significant ones, 1 to 17
 * @returns {string}
 */
export function brief(value, digits) {
    if (Number.isNaN(value)) return "nan";
    if (!Number.isFinite(value)) return value > 0 ? "inf" : "-inf";
    if (value === 0) return "0";
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    const power = Number(exponent);
    if (power < -4 || power >= digits) return withoutZeros(mantissa) + exponentOf(exponent);
    return withoutZeros(value.toFixed(digits - 1 - power));
}

/** All digits before the point, up to a thousand million: people read 200000 more easily than 2e+05. */
function wholeDigits(value) {
    const size = Math.round(Math.abs(value));
    return size >= 1 && size < 1e9 ? Math.floor(Math.log10(size) + 1e-12) + 1 : 0;
}

/**
 * A number on an axis or in a label: as brief(), with a true minus sign, and never with an exponent where whole digits do.
 * @param {number} value
 * @param {number} [digits]
 */
export function number(value, digits = 10) {
    return brief(value, Math.max(digits, wholeDigits(value))).replace(/^-/, MINUS);
}

/**
 * "52.5 s", or the number alone where there is no unit.
 * @param {number} value
 * @param {string} unit
 * @param {number} [digits]
 */
export function withUnit(value, unit, digits = 7) {
    return unit ? `${number(value, digits)} ${unit}` : number(value, digits);
}

/**
 * Digits enough to tell `value` from its neighbours `step` away, at least `least` of them: labels of a curve zoomed in stay distinct.
 * @param {number} value
 * @param {number} step
 * @param {number} [least]
 */
export function digitsFor(value, step, least = 4) {
    if (!(step > 0) || value === 0) return least;
    const needed = Math.floor(Math.log10(Math.abs(value))) - Math.floor(Math.log10(step)) + 1;
    return Math.min(15, Math.max(least, needed));
}
