// SPDX-License-Identifier: MIT
/** The scene's picture: what is where on the screen, what is under a pointer, what is drawn and what left out. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { light } from "../../tools/page/js/palette.js";
import { SvgPen } from "../../tools/page/js/draw_svg.js";
import { guessedWidth } from "../../tools/page/js/draw_text.js";
import { Labels } from "../../tools/page/js/draw_labels.js";
import { centersOf, countSeen, outlineDisc, outlineDiscs } from "../../tools/page/js/scene_discs.js";
import { hit } from "../../tools/page/js/scene_hit.js";
import { layoutScene } from "../../tools/page/js/scene_layout.js";
import { prepareLegs } from "../../tools/page/js/scene_legs.js";
import { scaleBar } from "../../tools/page/js/scene_marks.js";
import { arrangeScene, drawGround, drawLive } from "../../tools/page/js/scene_picture.js";
import { Projection, sceneExtent } from "../../tools/page/js/scene_projection.js";
import { blankScene, sceneSvg } from "../../tools/page/js/scene_svg.js";
import { newCore, read } from "./support.js";

const core = await newCore();

/** A window of 1000 by 600 pixels. */
function projectionAt(centerX, centerY, scale) {
    return Object.assign(new Projection(), { left: 0, top: 0, width: 1000, height: 600, centerX, centerY, scale, fitting: scale });
}

/** A scene as the view has it. @param {any} description @param {number} departure @param {number} time */
function stateOf(description, departure, time) {
    const scene = core.scene(description), path = scene.path(departure);
    const jumps = scene.jumps({});
    const extent = sceneExtent(description, scene.radii(departure), path.legs), state = blankScene(light);
    Object.assign(state, {
        description, count: description.discs.length, centers: centersOf(description.discs), now: scene.radii(time), later: path.arrival === null ? null : scene.radii(path.arrival),
        legs: prepareLegs(path.legs, description.robot.speed), jumps, time, units: description.units,
    });
    arrangeScene(state, 1000, 700, guessedWidth);
    state.projection.fit(extent);
    return state;
}

const twoDiscs = read("examples/scenes/two-discs.json");

test("what is at a pixel stays there while the view comes nearer", () => {
    const projection = projectionAt(1e6, -2e6, 3);
    const x = projection.worldX(123), y = projection.worldY(456);
    for (let i = 0; i < 60; i++) projection.zoomAt(123, 456, 1.2);
    assert.ok(Math.abs(projection.x(x) - 123) < 1e-2 && Math.abs(projection.y(y) - 456) < 1e-2);
});

test("places a micrometre apart a thousand kilometres away are told apart", () => {
    const projection = projectionAt(1e6, 1e6, 1e6);
    assert.ok(Math.abs(projection.x(1e6 + 1e-4) - projection.x(1e6) - 100) < 0.01);
});

test("a view comes no nearer than a million times and no further than two hundred times the journey", () => {
    const projection = projectionAt(0, 0, 2);
    projection.zoomAt(0, 0, 1e30);
    assert.equal(projection.scale, 2e6);
    projection.zoomAt(0, 0, 1e-30);
    assert.equal(projection.scale, 0.01);
});

test("a view fits both ends and the discs near the journey, and none that is far", () => {
    const far = { ...twoDiscs, discs: [...twoDiscs.discs, { center: [1e5, 0], radius: 1, growth: 0 }] };
    const extent = sceneExtent(far, [1, 1, 1], []);
    assert.deepEqual([extent.xLow, extent.xHigh, extent.yLow, extent.yHigh], [-11, 11, -5, 5]);
});

test("a scene whose ends are one place, without discs, has an extent", () => {
    const extent = sceneExtent({ source: [3, 3], destination: [3, 3], discs: [] }, [], []);
    assert.ok(extent.xHigh > extent.xLow && extent.yHigh > extent.yLow);
});

const ground = { source: [-10, 0], destination: [10, 0], centers: centersOf([{ center: [0, 0] }, { center: [1, 0] }, { center: [0, 30] }]), radii: Float64Array.of(5, 2, 0.01), count: 3, selected: -1 };
const seen = projectionAt(0, 0, 20);

test("an end is under the pointer within reach, further for a finger", () => {
    assert.deepEqual(hit(seen, ground, seen.x(-10) + 10, seen.y(0)), { what: "source", index: -1 });
    assert.deepEqual(hit(seen, ground, seen.x(10), seen.y(0) + 21, true), { what: "destination", index: -1 });
    assert.equal(hit(seen, ground, seen.x(10), seen.y(0) + 21), null);
});

test("of discs over one another the smallest is under the pointer", () => assert.deepEqual(hit(seen, ground, seen.x(1), seen.y(0)), { what: "disc", index: 1 }));

test("the selected disc comes before a smaller one", () => assert.deepEqual(hit(seen, { ...ground, selected: 0 }, seen.x(1), seen.y(0)), { what: "disc", index: 0 }));

test("a disc is held by its rim from inside and outside", () => {
    assert.deepEqual(hit(seen, ground, seen.x(-5) - 4, seen.y(0)), { what: "rim", index: 0 });
    assert.deepEqual(hit(seen, ground, seen.x(-5) + 4, seen.y(0)), { what: "rim", index: 0 });
    assert.deepEqual(hit(seen, ground, seen.x(-5) + 12, seen.y(0)), { what: "disc", index: 0 });
});

test("empty ground is nothing", () => assert.equal(hit(seen, ground, seen.x(0), seen.y(-10)), null));

test("a disc of a pixel can be held", () => {
    const wide = projectionAt(0, 30, 20);
    assert.deepEqual(hit(wide, ground, wide.x(0) + 3, wide.y(30)), { what: "disc", index: 2 });
});

test("discs outside of the window are left out", () => {
    const centers = centersOf([{ center: [0, 0] }, { center: [1000, 0] }, { center: [26, 0] }]), radii = Float64Array.of(1, 1, 2);
    const drawn = [];
    outlineDiscs({ disc: (x, y, radius) => drawn.push(radius) }, seen, centers, radii);
    assert.deepEqual(drawn, [20, 40]);
    assert.equal(countSeen(seen, centers, radii), 2);
});

test("a disc under half a pixel is a pixel", () => {
    const drawn = [];
    outlineDisc({ rect: (...box) => drawn.push(box) }, seen, 100, 100, 0.01);
    assert.deepEqual(drawn, [[99.5, 99.5, 1, 1]]);
});

/** Is a pixel inside a polygon? */
function inside(polygon, x, y) {
    let odd = false;
    for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
        const [xi, yi] = polygon[i], [xj, yj] = polygon[j];
        if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) odd = !odd;
    }
    return odd;
}

test("of a disc far larger than the window the edge that is seen is exact", () => {
    const projection = projectionAt(0, 0, 1), radius = 1e9;
    for (const angle of [0.3, 1.9, 3.3, 5.1]) {
        const x = 500 + radius * Math.cos(angle), y = 300 + radius * Math.sin(angle), polygon = [];
        outlineDisc({ move: (...at) => polygon.push(at), line: (...at) => polygon.push(at), close: () => {} }, projection, x, y, radius);
        assert.ok(polygon.length > 3 && polygon.length < 200);
        for (let px = 5; px < 1000; px += 90)
            for (let py = 5; py < 600; py += 90) {
                // The edge goes through the window's middle, and is straight there to a micropixel.
                const depth = (px - 500) * Math.cos(angle) + (py - 300) * Math.sin(angle);
                if (Math.abs(depth) > 1) assert.equal(inside(polygon, px, py), depth > 0, `${angle} ${px} ${py}`);
            }
    }
});

test("a disc that holds the window fills it, and one that does not reach it is left out", () => {
    const drawn = [], pen = { rect: (...box) => drawn.push(box) };
    outlineDisc(pen, projectionAt(0, 0, 1), 500, 300, 1e8);
    outlineDisc(pen, projectionAt(0, 0, 1), -2e8, 300, 1e8);
    assert.deepEqual(drawn, [[-4, -4, 1008, 608]]);
});

test("labels hide neither one another nor marks, nor lines while there is room beside them", () => {
    const labels = new Labels({ left: 0, top: 0, right: 400, bottom: 300 }, guessedWidth), style = { size: 13, colour: "#000000" };
    labels.addMark(200, 150, 8);
    labels.addLine(200, 150, 400, 150);
    for (let i = 0; i < 30; i++) labels.place(200, 150, 10, 0, `label ${i}`, style);
    assert.ok(labels.placed.length >= 3);
    for (const one of labels.placed.slice(0, 3)) assert.equal(labels.hidden(one), 0);
    for (const one of labels.placed) {
        for (const other of labels.placed) assert.ok(one === other || one.right <= other.left || other.right <= one.left || one.bottom <= other.top || other.bottom <= one.top);
    }
});

test("a label beside an upright line hides nothing, or is not there", () => {
    const labels = new Labels({ left: 0, top: 0, right: 400, bottom: 300 }, guessedWidth), style = { size: 12, colour: "#000000" };
    labels.addLine(200, 100, 200, 200);
    for (let i = 0; i < 40; i++) labels.placeBeside(200, 100, 200, 9, `label ${i}`, style);
    assert.ok(labels.placed.length > 10 && labels.placed.length < 40, String(labels.placed.length));
    for (const one of labels.placed) assert.equal(labels.hidden(one), 0);
    assert.equal(labels.placed[0].left, 209);
    assert.equal((labels.placed[0].top + labels.placed[0].bottom) / 2, 150);
});

test("what comes and goes may take the place of a label that always stands there", () => {
    const labels = new Labels({ left: 0, top: 0, right: 120, bottom: 20 }, guessedWidth), style = { size: 12, colour: "#000000" };
    assert.ok(labels.place(20, 10, 4, 0, "always", style));
    assert.equal(labels.place(20, 10, 4, 0, "now and then", style), null);
    assert.ok(labels.copy().place(20, 10, 4, 0, "now and then", style));
    assert.equal(labels.placed.length, 1);
});

test("a label without room is left out", () => {
    const labels = new Labels({ left: 0, top: 0, right: 20, bottom: 20 }, guessedWidth);
    assert.equal(labels.place(10, 10, 5, 0, "too long for this", { size: 13, colour: "#000000" }), null);
});

test("what a gap says is not where the robot comes along", () => {
    for (const [width, height] of [[1000, 700], [370, 340]]) {
        const state = stateOf(twoDiscs, 9.8, 19.8);
        arrangeScene(state, width, height, guessedWidth);
        state.projection.fit({ xLow: -11, xHigh: 11, yLow: -5, yHigh: 5 });
        const [label] = layoutScene(state, guessedWidth).labels.filter(({ after }) => after);
        const path = state.projection.y(0);
        assert.ok(label.bottom < path - 6 || label.top > path + 6, `${label.top} to ${label.bottom}, the path at ${path}`);
    }
});

test("a scale bar is a round length that is no longer than asked for, by much", () => {
    for (const scale of [1e-3, 0.07, 1, 33, 1e4]) {
        const bar = scaleBar(scale, { name: "x", unit: "m", divisor: 1 }, 110);
        assert.ok(bar.pixels <= 143 && bar.pixels > 57, `${bar.pixels}`);
        assert.match(bar.text, /^[125]0*(e.*)? m$|^0\.0*[125] m$/);
    }
});

test("a gap says when it closes until then, and that it is closed from then on", () => {
    const state = stateOf(twoDiscs, 5, 10), [jump] = state.jumps;
    state.layout = layoutScene(state, guessedWidth);
    const arrangement = arrangeScene(state, 1000, 700, guessedWidth);
    const words = (time) => {
        const pen = new SvgPen();
        drawGround(pen, state, arrangement);
        drawLive(pen, { ...state, time });
        return pen.elements.join("\n");
    };
    assert.match(words(jump.gap.time - 0.01), />closes at 20\.151 s</);
    assert.match(words(jump.gap.time), />closed at 20\.151 s</);
});

test("the picture as a file is whole XML, with title, description, and all parts", () => {
    const svg = sceneSvg(stateOf({ ...twoDiscs, name: "Fire & <ice>" }, 5, 12), { width: 900, height: 700, description: "leaves at 5 s" });
    assert.match(svg, /<title id="title">Fire &amp; &lt;ice&gt;<\/title>/);
    assert.match(svg, /<desc id="desc">leaves at 5 s<\/desc>/);
    assert.match(svg, />discs at 12 s</);
    for (const part of ["grid", "discs-at-arrival", "axes", "legend", "discs", "path", "gaps", "ends", "labels", "robot", "scale"]) assert.match(svg, new RegExp(`<g class="${part}">`));
    assert.equal(svg.match(/<g[ >]/g).length, svg.match(/<\/g>/g).length);
    assert.doesNotMatch(svg, /NaN|Infinity|undefined/);
});

test("a scene without a way, a sealed-in source, is a picture too", () => {
    const sealed = { ...twoDiscs, source: [0, 3] };
    const svg = sceneSvg(stateOf(sealed, 0, 0), { width: 400, height: 500 });
    assert.doesNotMatch(svg, /class="path"|class="robot"|NaN/);
    assert.match(svg, />source</);
});

test("a time that no answer names, before the first or after the last, is drawn", () => {
    const state = stateOf(twoDiscs, 5, 0);
    for (const time of [0, 1e4]) assert.doesNotMatch(sceneSvg({ ...state, time }, { width: 800, height: 600 }), /NaN/);
});
