// SPDX-License-Identifier: MIT
/** The curve's picture: pieces between jumps, the last departure that makes a deadline, windows, labels, the file. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { curveOf, curveWindow, lastShown, latestDeparture, sampleTimes, stairsOf, travelAt } from "../../tools/page/js/curve_data.js";
import { arrangeCurve, deadlineLine, jumpText, layoutCurve, legendOf, reasonWords } from "../../tools/page/js/curve_layout.js";
import { momentText } from "../../tools/page/js/curve_picture.js";
import { blankCurve, curveSvg } from "../../tools/page/js/curve_svg.js";
import { guessedWidth } from "../../tools/page/js/draw_text.js";
import { light } from "../../tools/page/js/palette.js";
import { newCore, read } from "./support.js";

const core = await newCore();
const scene = core.scene(read("examples/scenes/fire-oregon-c.json"));
const last = scene.last(), jumps = scene.jumps({});
const times = sampleTimes(last.departure, 129), samples = { times, arrivals: scene.samples(times) };
const curve = curveOf(samples, jumps, last);
const table = core.table(scene.build({ guarantee: "travel", epsilon: 0.01 }).bytes);

/** The state of a picture of this scene. @param {object} [more] */
function stateOf(more = {}) {
    const state = { ...blankCurve(light), curve, jumps, last, rows: table.rows(), travel: (t) => travelAt(curve, t), units: { time: "s" }, ...more };
    return { ...state, window: curveWindow(state.curve, state.last, state.mode, state.rows) };
}

test("the curve breaks at every jump, and at nothing else", () => {
    const starts = Array.from(curve.starts.subarray(0, curve.count)).reduce((sum, one) => sum + one, 0);
    assert.equal(starts, 1 + jumps.length);
    for (let i = 1; i < curve.count; i++) assert.ok(curve.departure[i] >= curve.departure[i - 1] && curve.travel[i] >= curve.travel[i - 1] - 1e-9);
});

test("at a jump's departure the robot still gets through, right after it does not", () => {
    for (const jump of jumps) {
        assert.equal(travelAt(curve, jump.departure), jump.travelBefore);
        assert.ok(Math.abs(travelAt(curve, jump.departure * (1 + 1e-9)) - jump.travelAfter) < 1e-3);
    }
});

test("between samples the curve is near the exact one, before the first and after the last there is none", () => {
    for (let i = 1; i < 100; i++) {
        const departure = (last.departure * i) / 100.37;
        assert.ok(Math.abs(travelAt(curve, departure) - scene.arrival(departure).travelTime) < 1e-3 * last.arrival);
    }
    assert.ok(Number.isNaN(travelAt(curve, -1)) && Number.isNaN(travelAt(curve, last.departure * 1.01)));
});

test("the latest departure for a deadline arrives by it, and the core knows none much later", () => {
    for (const arrival of [4500, 5000, 7600, 8000, 11000]) {
        const departure = latestDeparture(curve, arrival), exact = scene.departure(arrival).departure;
        assert.ok(Math.abs(departure - exact) < 1e-3 * last.departure, `${arrival}: ${departure} ${exact}`);
    }
});

test("within a jump all deadlines have the departure before it", () => {
    const [jump] = jumps, before = jump.departure + jump.travelBefore, after = jump.departure + jump.travelAfter;
    assert.equal(latestDeparture(curve, before + 0.5 * (after - before)), jump.departure);
});

test("a deadline before the first arrival has no departure, one after the last has the last", () => {
    assert.equal(latestDeparture(curve, 100), null);
    assert.equal(latestDeparture(curve, 1e9), last.departure);
    assert.equal(latestDeparture(curveOf(null, [], null), 5), null);
});

test("samples that know no arrival leave the curve shorter", () => {
    const short = curveOf({ times: [0, 1, 2, 3], arrivals: [5, 6.5, NaN, NaN] }, [], null);
    assert.equal(short.count, 2);
    assert.equal(lastShown(short, null), 1);
});

test("where nothing ends the departures the window is that of the samples", () => {
    const still = curveOf({ times: [0, 50, 100], arrivals: [20, 70, 120] }, [], null), endless = { departure: Infinity, arrival: Infinity, reason: "horizon" };
    const window = curveWindow(still, endless, "travel", null);
    assert.deepEqual([window.xLow, window.xHigh], [-1, 104]);
    assert.ok(window.yLow < 20 && window.yHigh > 20 && Number.isFinite(window.yHigh));
});

test("a scene without any departure has a window all the same", () => {
    const window = curveWindow(curveOf(null, [], null), { departure: -Infinity, arrival: NaN, reason: "source_covered" }, "travel", null);
    for (const value of Object.values(window)) assert.ok(Number.isFinite(value));
});

test("samples are in order, and each jump's departure is among them", () => {
    const asked = sampleTimes(100, 11, [{ departure: 33.3 }, { departure: 250 }]);
    assert.deepEqual([...asked], [0, 10, 20, 30, 33.3, 40, 50, 60, 70, 80, 90, 100]);
});

test("the stairs of a table are what its stored paths take", () => {
    const rows = table.rows(), stairs = stairsOf(rows);
    for (let i = 1; i < rows.departures.length; i++) {
        assert.equal(travelAt(stairs, rows.departures[i]), rows.left[i]);
        assert.equal(travelAt(stairs, (rows.departures[i - 1] + rows.departures[i]) / 2), rows.left[i]);
    }
});

test("a deadline is a level line over arrivals, a falling one over travel times", () => {
    for (const [mode, falls] of [["arrival", false], ["travel", true]]) {
        const state = stateOf({ mode, deadline: 8000 }), { frame } = arrangeCurve(state, 900, 500, guessedWidth);
        const { from, to } = deadlineLine(state, frame);
        assert.equal(to.y > from.y + 1, falls);
    }
});

test("a deadline outside of the window has no line", () => {
    for (const mode of ["arrival", "travel"]) {
        const state = stateOf({ mode, deadline: 1 }), { frame } = arrangeCurve(state, 900, 500, guessedWidth);
        assert.equal(deadlineLine(state, frame), null);
    }
});

test("the curve is called exact only when its jumps are known", () => {
    const named = (more) => legendOf(stateOf(more)).find(({ kind }) => kind === "curve").text;
    assert.equal(named({}), "travel time, exact");
    assert.equal(named({ sampled: true, jumps: [] }), "travel time, sampled");
    assert.equal(named({ sampled: true, jumps: [], mode: "arrival" }), "earliest arrival, sampled");
});

test("jumps are labelled with what closes, as `tdsp plot` does", () => {
    assert.equal(jumpText(jumps[0], "s"), "52.5001 s: discs 2 and 3 close");
    assert.equal(jumpText({ ...jumps[0], gap: null }, "s"), "52.5001 s");
});

test("labels of the curve are inside the window and apart", () => {
    for (const [width, height] of [[900, 500], [390, 300], [300, 180]]) {
        const state = stateOf({ deadline: 8000, leaveBy: 2229 }), arrangement = arrangeCurve(state, width, height, guessedWidth), { frame } = arrangement;
        const { placed } = layoutCurve(state, arrangement, guessedWidth);
        for (const one of placed) {
            assert.ok(one.left >= frame.left && one.right <= frame.left + frame.width && one.top >= frame.top && one.bottom <= frame.top + frame.height);
            for (const other of placed) assert.ok(one === other || one.right <= other.left || other.right <= one.left || one.bottom <= other.top || other.bottom <= one.top);
        }
    }
});

test("a departure is said with what it takes, or when it arrives, or that there is no way", () => {
    assert.equal(momentText(stateOf(), 1000, 5065.22), "leave at 1000 s: takes 5065.22 s");
    assert.equal(momentText(stateOf({ mode: "arrival" }), 1000, 5065.22), "leave at 1000 s, arrive at 6065.22 s");
    assert.equal(momentText(stateOf(), 6000, NaN), "leave at 6000 s: no way");
});

test("every reason of a scene that ends departures has words", () => {
    for (const reason of ["source_covered", "destination_covered", "cut_off"]) assert.ok(reasonWords(reason).length > 10);
    assert.equal(reasonWords("horizon"), "");
});

test("the picture as a file is whole XML with all parts", () => {
    const svg = curveSvg(stateOf({ departure: 1000, deadline: 8000, leaveBy: 2229.05 }), { width: 1000, height: 600, title: "Travel time" });
    for (const part of ["grid", "certified", "last-departure", "deadline", "curve", "jumps", "axes", "legend", "departure", "labels"]) assert.match(svg, new RegExp(`<g class="${part}">`));
    assert.doesNotMatch(svg, /class="slider"/);
    assert.match(svg, />52\.5001 s: discs 2 and 3 close</);
    assert.match(svg, />leave by 2229\.05 s</);
    assert.equal(svg.match(/<g[ >]/g).length, svg.match(/<\/g>/g).length);
    assert.doesNotMatch(svg, /NaN|Infinity|undefined/);
});

test("the picture of no curve says why", () => {
    const svg = curveSvg(stateOf({ curve: curveOf(null, [], null), jumps: [], last: null, rows: null, message: "no departure arrives" }), { width: 500, height: 300 });
    assert.match(svg, />no departure arrives</);
    assert.doesNotMatch(svg, /NaN|Infinity/);
});

test("a departure after the last is shown without a place on the curve", () => {
    assert.doesNotMatch(curveSvg(stateOf({ departure: last.departure * 1.02 }), { width: 900, height: 500 }), /NaN/);
});
