// SPDX-License-Identifier: MIT
/** The curve's picture: pieces between jumps, the last departure that makes a deadline, windows, labels, the file. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { curveOf, curveWindow, lastShown, latestDeparture, stairsOf, travelAt, withBends } from "../../tools/page/js/curve_data.js";
import { arrangeCurve, deadlineLine, jumpText, layoutCurve, legendOf } from "../../tools/page/js/curve_layout.js";
import { drawCurveLive, hoverText, momentText } from "../../tools/page/js/curve_picture.js";
import { blankCurve, curveSvg } from "../../tools/page/js/curve_svg.js";
import { guessedWidth } from "../../tools/page/js/draw_text.js";
import { light } from "../../tools/page/js/palette.js";
import { newCore, read } from "./support.js";

const core = await newCore();
const scene = core.scene(read("examples/scenes/fire-oregon-c.json"));
/** Departures, evenly over all of them. */
const sampleTimes = (until, count) => Float64Array.from({ length: count }, (_, i) => (until * i) / (count - 1));
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
    const travel = (departure) => (departure > 5000 ? NaN : 5065.22);
    assert.equal(momentText(stateOf({ travel }), 1000), "leave at 1000 s: takes 5065.22 s");
    assert.equal(momentText(stateOf({ travel, mode: "arrival" }), 1000), "leave at 1000 s, arrive at 6065.22 s");
    assert.equal(momentText(stateOf({ travel }), 6000), "leave at 6000 s: no way");
});

test("who points at a jump is told what it does, also where its label has no room", () => {
    assert.equal(hoverText(stateOf(), jumps[0].departure), "52.5001 s: discs 2 and 3 close, 4497.68 s becomes 4947.75 s");
    assert.match(hoverText(stateOf({ mode: "arrival" }), jumps[0].departure), /close, 4550\.18 s becomes 5000\.25 s$/);
    assert.match(hoverText(stateOf(), 1000), /^leave at 1000 s: takes /);
});

/** Boxes of all that is written in a picture of the curve, with a pen that draws nothing. */
function written(state, width, height) {
    const arrangement = arrangeCurve(state, width, height, guessedWidth), layout = layoutCurve(state, arrangement, guessedWidth), texts = [];
    const pen = new Proxy({}, { get: (_, name) => (name === "width" ? guessedWidth : (x, y, text, style) => { if (name === "text" && style.halo) texts.push({ x, y, text, style }); }) });
    drawCurveLive(pen, state, arrangement, layout);
    return { texts, arrangement, layout };
}

test("labels of jumps hide neither the curve nor the edge of the band, however many there are", () => {
    for (const [width, height] of [[900, 500], [560, 300], [340, 260]]) {
        const { layout } = written(stateOf({ departure: 1000, deadline: 8000, leaveBy: 2229 }), width, height);
        const ofJumps = layout.placed.filter(({ style }) => style.colour === light.alarmText);
        assert.ok(ofJumps.length > 0);
        for (const label of ofJumps) assert.equal(layout.labels.hidden(label), 0, label.text);
    }
});

test("the departure's label is not struck through by the curve while there is room beside it", () => {
    const level = curveOf({ times: [0, 50, 100], arrivals: [20, 70, 150] }, [], null);
    const state = stateOf({ curve: level, rows: null, jumps: [], last: null, departure: 40, travel: () => 20 });
    const { texts, layout } = written(state, 900, 500);
    const [label] = texts, half = guessedWidth(label.text, label.style) / 2;
    assert.equal(layout.labels.hidden({ left: label.x - half, right: label.x + half, top: label.y - 6, bottom: label.y + 6 }), 0);
});

test("the words of the last departure stand right of its line, where there is no curve", () => {
    for (const width of [900, 340]) {
        const { layout, arrangement } = written(stateOf(), width, 260), { frame } = arrangement;
        assert.match(layout.last.text, /^last departure/);
        assert.ok(frame.left + frame.width - layout.last.x >= 19.9);
    }
});

test("a jump that only the very last departures are after leaves the window, and does not press the others flat", () => {
    const many = read("tools/page/gallery/nsquared.json"), bent = core.scene(many), end = bent.last(), [jump] = bent.jumps({}).slice(-1);
    const at = sampleTimes(end.departure, 129), drawn = curveOf({ times: at, arrivals: bent.samples(at) }, [jump], end);
    const window = curveWindow(drawn, end, "travel", null);
    assert.ok(jump.travelAfter > window.yHigh && jump.travelBefore < window.yHigh);
    assert.ok(window.yHigh - window.yLow < 0.05 * (jump.travelAfter - drawn.travel[0]));
    const state = { ...stateOf({ curve: drawn, jumps: [jump], last: end, rows: null, units: { time: "" } }), window };
    assert.ok(written(state, 900, 500).texts.some(({ text }) => text === "356038: discs 4 and 9 close, to 550.748"));
    assert.ok(curveWindow(drawn, end, "arrival", null).yHigh > end.arrival, "arrivals are not pressed by it");
});

test("a jump in the midst of the departures stays in the window, however large it is", () => {
    const high = curveOf({ times: [0, 100], arrivals: [1, 220] }, [{ departure: 50, travelBefore: 1.5, travelAfter: 100 }], { departure: 100, arrival: 220 });
    assert.ok(curveWindow(high, { departure: 100, arrival: 220 }, "travel", null).yHigh > 120);
});

test("bends are points of the curve, and named in the legend", () => {
    const bends = [{ departure: 33, travel: 21 }, { departure: 50, travel: 22 }];
    const bent = withBends({ times: [0, 50, 100], arrivals: [20, 72, 130] }, bends);
    assert.deepEqual([[...bent.times], [...bent.arrivals]], [[0, 33, 50, 100], [20, 54, 72, 130]]);
    const svg = curveSvg(stateOf({ bends }), { width: 900, height: 500 });
    assert.match(svg, /<g class="bends">/);
    assert.match(svg, />bends \(2\)</);
    assert.equal(withBends(null, bends), null);
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
