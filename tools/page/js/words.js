// SPDX-License-Identifier: MIT
// What the pictures show, in sentences: read by people who see them, and aloud to those who do not. Pure: numbers come in, words go out.
import { number, withUnit as spaced } from "tdsp/numbers.js";

/** So many digits, and all of those before the point; a number and its unit stay on one line. */
const withUnit = (value, unit, digits) => spaced(value, unit, Math.max(digits, Math.min(15, Math.floor(Math.log10(Math.abs(value) || 1)) + 1))).replace(" ", "\u00a0");

const NEVER = {
    source_covered: "the source is covered",
    destination_covered: "the destination is covered before it can be reached",
    cut_off: "the discs have closed every way to the destination",
    horizon: "the table ends",
    outside_table: "the table ends",
};

/** Why there is no way any more. @param {string} status */
export const reasonWords = (status) => NEVER[status] ?? status.replaceAll("_", " ");

/** A time with the digits that people read. @param {number} t @param {string} unit */
export const timeWords = (t, unit) => withUnit(t, unit, 5);

/** "12.3 %" @param {number} share */
export const percentWords = (share) => `${number(share * 100, 2)} %`;

/** "1 disc", "2 discs" @param {number} n @param {string} one */
export const countWords = (n, one) => `${n.toLocaleString("en")} ${n === 1 ? one : one + "s"}`;

/** The jump that comes first at `departure` or later. @param {any[]} jumps in order @param {number} departure */
export const nextJump = (jumps, departure) => jumps.find((jump) => jump.departure >= departure) ?? null;

/** Digits that tell a time from another one that is `apart` away. */
function digits(t, apart) {
    if (!(apart > 0) || t === 0) return 5;
    return Math.min(12, Math.max(5, Math.ceil(Math.log10(Math.abs(t) / apart)) + 1));
}

/** @param {{gap: {first: number, second: number}|null}} jump */
const gapName = ({ gap }) => (gap ? `the gap between discs ${gap.first} and ${gap.second}` : "a gap");

const JUST = 0.01; // of all departures: so little after a jump it has just been missed

/** The jump that leaving at `departure` has just missed. */
function missedWords({ departure, jumps, last, unit }) {
    const jump = jumps?.findLast((j) => j.departure < departure);
    if (!jump || !last || !(departure - jump.departure <= JUST * last.departure)) return [];
    return [{ text: `${withUnit(departure - jump.departure, unit, 2)} earlier you would have slipped through ${gapName(jump)}: missing it costs ${withUnit(jump.size, unit, 3)}.`, jump: true }];
}

/** Sentences about what comes after leaving at `departure`. */
function aheadWords({ departure, jumps, last, unit }) {
    const jump = jumps ? nextJump(jumps, departure) : null;
    if (jump) {
        const left = jump.departure - departure;
        const when = left > 0 ? `${withUnit(left, unit, 3)} later` : "A moment later";
        return [{ text: `${when} ${gapName(jump)} closes and the way takes ${withUnit(jump.size, unit, 3)} longer.`, jump: true }];
    }
    if (!last) return [];
    if (!Number.isFinite(last.departure)) return [{ text: "Nothing ever closes the way: you may leave when you like." }];
    return [{ text: `The last departure is ${withUnit(last.departure, unit, 5)}: after it, ${reasonWords(last.reason)}.` }];
}

/** @returns {{text: string, jump?: boolean}[]} */
function journeyWords({ departure, answer, jumps, unit }) {
    const jump = jumps ? nextJump(jumps, departure) : null;
    const leave = withUnit(departure, unit, digits(departure, jump ? jump.departure - departure : 0));
    if (answer.status === "ok") {
        const spent = answer.arrival - departure;
        const lasts = departure > 0 ? `, ${withUnit(spent, unit, 5)} later` : "";
        return [{ text: `Leaving at ${leave} you arrive at ${timeWords(answer.arrival, unit)}${lasts}.` }];
    }
    return [{ text: `Leaving at ${leave} you do not arrive: ${reasonWords(answer.status)}.`, jump: true }];
}

/** @returns {{text: string, jump?: boolean}[]} */
function deadlineWords({ deadline, latest, unit }) {
    if (deadline === null || !latest) return [];
    if (latest.status !== "ok") return [{ text: `Nobody arrives by ${timeWords(deadline, unit)}.`, jump: true }];
    return [{ text: `To arrive by ${timeWords(deadline, unit)}, leave at ${timeWords(latest.departure, unit)} at the latest.` }];
}

/**
 * What the page shows, as sentences.
 * @param {{departure: number, answer: {status: string, arrival: number|null}|null, jumps: any[]|null, last: any, deadline: number|null, latest: any, unit: string}} shown
 * @returns {{text: string, jump?: boolean}[]}
 */
export function answerWords(shown) {
    if (!shown.answer) return [];
    const ahead = shown.answer.status === "ok" ? [...missedWords(shown), ...aheadWords(shown)] : lastWords(shown);
    return [...journeyWords(shown), ...ahead, ...deadlineWords(shown)];
}

/** Where there is no way, what would have been the last moment. */
function lastWords({ last, departure, unit }) {
    if (!last || !(last.departure >= 0 && last.departure < departure)) return [];
    return [{ text: `The last departure was ${withUnit(last.departure, unit, 5)}.` }];
}

/** A stored table's answer. @param {{departure: number, answer: {status: string, lower: number|null, upper: number|null}, deadline: number|null, latest: any, unit: string}} shown */
export const tableWords = (shown) => [...storedWords(shown), ...deadlineWords(shown)];

function storedWords({ departure, answer, unit }) {
    const leave = timeWords(departure, unit);
    if (answer.status !== "ok") return [{ text: `Leaving at ${leave} the table has no way: ${reasonWords(answer.status)}.`, jump: true }];
    if (answer.upper - answer.lower <= 1e-6 * answer.upper) return [{ text: `Leaving at ${leave} you arrive at ${timeWords(answer.upper, unit)}.` }];
    return [{ text: `Leaving at ${leave} you arrive by ${timeWords(answer.upper, unit)} along the stored path; nothing arrives before ${timeWords(answer.lower, unit)}.` }];
}

/** What the scene's picture shows, for those who do not see it. */
export function sceneWords({ name, scene, answer, time, unit }) {
    const rides = (answer?.legs ?? []).filter((leg) => leg.type !== "line").length;
    const way = answer?.status === "ok" ? `a path of ${countWords(answer.legs.length, "leg")}, ${rides === 0 ? "straight" : countWords(rides, "ride") + " along discs among them"}` : "no path";
    return `${name} at ${timeWords(time, unit)}: ${scene ? countWords(scene.discs.length, "disc") : "no discs"}, ${way}.`;
}

/** What the curve shows. */
export function curveWords({ jumps, last, mode, unit }) {
    const what = mode === "travel" ? "Travel time over departure" : "Arrival over departure";
    if (!jumps) return `${what}.`;
    const many = jumps.length === 0 ? "no jumps" : `${countWords(jumps.length, "jump")}, the largest by ${withUnit(Math.max(...jumps.map((j) => j.size)), unit, 3)}`;
    const end = last && Number.isFinite(last.departure) ? `, until ${timeWords(last.departure, unit)}` : "";
    return `${what}${end}: ${many}.`;
}

const sizeWords = (bytes) => (bytes < 10000 ? countWords(bytes, "byte") : `${number(bytes / 1000, 3)} kB`);

/** @param {{rows: number, bytes: number, forwardCalls: number, reverseCalls: number}} report @param {number} seconds */
export function buildWords(report, seconds) {
    return { rows: countWords(report.rows, "row"), size: sizeWords(report.bytes), calls: countWords(report.forwardCalls + report.reverseCalls, "search").replace(/searchs$/, "searches"),
        time: seconds < 1 ? `${number(seconds * 1000, 3)} ms` : `${number(seconds, 3)} s` };
}

const quoted = (word) => (/^[\w.-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

/** What an opened table is. @param {{rows: number, bytes: number, guarantee: string, epsilon: number|null, delta: number|null}} info @param {string} unit */
export function infoWords({ rows, bytes, guarantee, epsilon, delta }, unit) {
    const what = { travel: "travel times", arrival: "arrivals", absolute: "arrivals" }[guarantee];
    const within = epsilon === null ? withUnit(delta, unit, 4) : percentWords(epsilon);
    return `${countWords(rows, "row")}, ${sizeWords(bytes)}, as opened: ${what} within ${within}.`;
}

/** The command that makes the same table. @param {{file: string, epsilon: number, horizon: number|null}} build */
export function buildCommand({ file, epsilon, horizon }) {
    const end = horizon === null ? "" : ` --horizon ${horizon}`;
    return `tdsp build ${quoted(file + ".json")} -o ${quoted(file + ".tdsp")} --epsilon ${epsilon}${end}`;
}
