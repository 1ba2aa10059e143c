// SPDX-License-Identifier: MIT
import assert from "node:assert/strict";
import { test } from "node:test";
import { answerWords, buildCommand, buildWords, countWords, curveWords, infoWords, percentWords, sceneWords, tableWords } from "../../tools/page/js/words.js";

const jump = { departure: 9.8496, travelBefore: 20, travelAfter: 23.718, size: 3.718, gap: { first: 0, second: 1, time: 20.15, place: [0, 0] } };
const last = { departure: 60.3, reason: "destination_covered" };
const asked = (more) => ({ departure: 5, answer: { status: "ok", arrival: 25 }, jumps: [jump], last, deadline: null, latest: null, unit: "s", ...more });
/** As one text, with plain spaces. */
const said = (sentences) => sentences.map((s) => s.text).join(" ").replaceAll("\u00a0", " ");

test("a departure: when one arrives, and what leaving later costs", () => {
    assert.equal(said(answerWords(asked())), "Leaving at 5 s you arrive at 25 s, 20 s later. 4.85 s later the gap between discs 0 and 1 closes and the way takes 3.72 s longer.");
});

test("at the last moment itself, a moment later is too late", () => {
    assert.match(said(answerWords(asked({ departure: 9.8496, answer: { status: "ok", arrival: 29.8496 } }))), /A moment later the gap between discs 0 and 1 closes/);
});

test("just after a jump it is said what was missed, later no more", () => {
    assert.match(said(answerWords(asked({ departure: 9.9, answer: { status: "ok", arrival: 33.6 } }))), /0\.05 s earlier you would have slipped through the gap between discs 0 and 1: missing it costs 3\.72 s\. The last departure is 60\.3 s/);
    assert.doesNotMatch(said(answerWords(asked({ departure: 20, answer: { status: "ok", arrival: 44 } }))), /slipped/);
});

test("digits tell a departure from the jump close to it", () => {
    assert.match(said(answerWords(asked({ departure: 9.849599, answer: { status: "ok", arrival: 29.849599 } }))), /^Leaving at 9\.849599 s/);
});

test("large times keep all digits before the point", () => {
    assert.match(said(answerWords(asked({ departure: 200000, answer: { status: "ok", arrival: 200486.52 }, jumps: [], unit: "" }))), /^Leaving at 200000 you arrive at 200487, 486\.52 later\./);
});

test("a gap that is not known is just a gap", () => {
    assert.match(said(answerWords(asked({ jumps: [{ ...jump, gap: null }] }))), /later a gap closes/);
});

test("no way is said with its reason, and what the last departure was", () => {
    const sentences = answerWords(asked({ departure: 70, answer: { status: "destination_covered", arrival: null } }));
    assert.equal(said(sentences), "Leaving at 70 s you do not arrive: the destination is covered before it can be reached. The last departure was 60.3 s.");
});

test("where no disc ends the departures, that is said", () => {
    assert.match(said(answerWords(asked({ jumps: [], last: { departure: Infinity, reason: "ok" } }))), /you may leave when you like/);
});

test("a deadline: when to leave at the latest, or that nobody makes it", () => {
    assert.match(said(answerWords(asked({ deadline: 30, latest: { status: "ok", departure: 9.8496 } }))), /To arrive by 30 s, leave at 9\.8496 s at the latest\./);
    assert.match(said(answerWords(asked({ deadline: 3, latest: { status: "arrival_too_early", departure: null } }))), /Nobody arrives by 3 s\./);
});

test("a table answers with an interval, or with one time where it is none", () => {
    assert.equal(said(tableWords({ departure: 5, answer: { status: "ok", lower: 24.9, upper: 25 }, deadline: null, unit: "s" })), "Leaving at 5 s you arrive by 25 s along the stored path; nothing arrives before 24.9 s.");
    assert.equal(said(tableWords({ departure: 5, answer: { status: "ok", lower: 25 - 1e-9, upper: 25 }, deadline: null, unit: "" })), "Leaving at 5 you arrive at 25.");
    assert.match(said(tableWords({ departure: 99, answer: { status: "cut_off", lower: null, upper: null }, deadline: null, unit: "s" })), /no way: the discs have closed every way/);
});

test("pictures are described to those who do not see them", () => {
    const scene = { discs: [1, 2] };
    assert.equal(sceneWords({ name: "Two", scene, answer: { status: "ok", legs: [{ type: "line" }] }, time: 3, unit: "" }), "Two at 3: 2 discs, a path of 1 leg, straight.");
    assert.match(sceneWords({ name: "Two", scene, answer: { status: "cut_off", legs: [] }, time: 3, unit: "" }), /no path/);
    assert.match(curveWords({ jumps: [jump], last, mode: "travel", unit: "" }), /^Travel time over departure, until 60\.3: 1 jump, the largest by 3\.72\.$/);
    assert.match(curveWords({ jumps: [], last: { departure: Infinity }, mode: "arrival", unit: "" }), /^Arrival over departure: no jumps\.$/);
});

test("counts, shares and reports are words", () => {
    assert.equal(countWords(1, "disc"), "1 disc");
    assert.equal(countWords(2000, "disc"), "2,000 discs");
    assert.equal(percentWords(0.0005), "0.05 %");
    assert.deepEqual(buildWords({ rows: 39, bytes: 8592, forwardCalls: 50, reverseCalls: 3 }, 0.0123), { rows: "39 rows", size: "8,592 bytes", calls: "53 searches", time: "12.3 ms" });
});

test("an opened table says how exact it is", () => {
    assert.equal(infoWords({ rows: 19, bytes: 15800, guarantee: "travel", epsilon: 0.01, delta: null }, "s"), "19 rows, 15.8 kB, as opened: travel times within 1 %.");
    assert.equal(infoWords({ rows: 1, bytes: 488, guarantee: "absolute", epsilon: null, delta: 5 }, ""), "1 row, 488 bytes, as opened: arrivals within 5.");
});

test("the command can be pasted into a shell", () => {
    assert.equal(buildCommand({ file: "two-discs", epsilon: 0.01, horizon: null }), "tdsp build two-discs.json -o two-discs.tdsp --epsilon 0.01");
    assert.equal(buildCommand({ file: "it's", epsilon: 0.01, horizon: 100 }), "tdsp build 'it'\\''s.json' -o 'it'\\''s.tdsp' --epsilon 0.01 --horizon 100");
});

test("where no departure ever arrives, none is said to have been the last", () => {
    const sentences = answerWords({ departure: 9.8, answer: { status: "source_covered", arrival: null }, jumps: [], last: { departure: -Infinity, reason: "source_covered" }, deadline: null, latest: null, unit: "s" });
    assert.equal(said(sentences), "Leaving at 9.8 s you do not arrive: the source is covered.");
});
