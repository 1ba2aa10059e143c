// SPDX-License-Identifier: MIT
/** What mouse and fingers mean, on a stand-in for the canvas. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { CurveGestures } from "../../tools/page/js/curve_gestures.js";
import { SceneGestures } from "../../tools/page/js/scene_gestures.js";

/** A canvas as far as gestures know one: at (10, 20) of the window. */
class Stage extends EventTarget {
    style = {};
    captured = [];
    getBoundingClientRect() { return { left: 10, top: 20 }; }
    setPointerCapture(id) { this.captured.push(id); }

    /** @param {string} type @param {number} x of the canvas */
    send(type, x, y, more = {}) {
        const event = Object.assign(new Event(type, { cancelable: true }), { clientX: x + 10, clientY: y + 20, pointerId: 1, pointerType: "mouse", button: 0, ...more });
        this.dispatchEvent(event);
        return event;
    }
}

const DISC = { what: "disc", index: 3 };

/** Gestures over a thing everywhere, or nothing; what they meant is in `said`. */
function scene({ target = null, selected = false } = {}) {
    const said = [], stage = new Stage();
    const say = (what) => (...values) => said.push([what, ...values]);
    new SceneGestures(/** @type {any} */ (stage), {
        hit: () => target, isSelected: () => selected, anchor: () => [100, 100],
        hover: say("hover"), select: say("select"), drag: say("drag"), dragEnd: say("dragEnd"), pan: say("pan"), zoom: say("zoom"), fit: say("fit"),
    });
    const kinds = () => said.map(([what]) => what);
    return { said, stage, kinds };
}

const finger = (id) => ({ pointerType: "touch", pointerId: id });

test("a mouse drags what it pressed, by where it pressed it", () => {
    const { said, stage } = scene({ target: DISC });
    stage.send("pointerdown", 103, 98);
    stage.send("pointermove", 104, 99);
    assert.deepEqual(said, [], "a trembling hand is no drag");
    stage.send("pointermove", 123, 108);
    stage.send("pointerup", 123, 108);
    assert.deepEqual(said, [["drag", DISC, 120, 110], ["dragEnd", DISC]]);
    assert.deepEqual(stage.captured, [1]);
});

test("a rim is dragged to the pointer itself", () => {
    const rim = { what: "rim", index: 3 }, { said, stage } = scene({ target: rim });
    stage.send("pointerdown", 150, 100);
    stage.send("pointermove", 160, 100);
    assert.deepEqual(said, [["drag", rim, 160, 100]]);
});

test("on empty ground a drag pans", () => {
    const { said, stage } = scene();
    stage.send("pointerdown", 50, 50);
    stage.send("pointermove", 60, 50);
    stage.send("pointermove", 60, 57);
    stage.send("pointerup", 60, 57);
    assert.deepEqual(said, [["pan", 10, 0], ["pan", 0, 7]]);
});

test("a finger pans over a disc that is not selected, and drags one that is", () => {
    for (const selected of [false, true]) {
        const { kinds, stage } = scene({ target: DISC, selected });
        stage.send("pointerdown", 50, 50, finger(1));
        stage.send("pointermove", 70, 50, finger(1));
        assert.deepEqual(kinds(), [selected ? "drag" : "pan"]);
    }
});

test("a finger drags an end without selecting it first", () => {
    const { kinds, stage } = scene({ target: { what: "source", index: -1 } });
    stage.send("pointerdown", 50, 50, finger(1));
    stage.send("pointermove", 70, 50, finger(1));
    assert.deepEqual(kinds(), ["drag"]);
});

test("a press without a move selects, on empty ground nothing", () => {
    for (const target of [DISC, null]) {
        const { said, stage } = scene({ target });
        stage.send("pointerdown", 50, 50);
        stage.send("pointerup", 51, 50);
        assert.deepEqual(said, [["select", target]]);
    }
});

test("two presses in quick succession show everything", () => {
    const { kinds, stage } = scene();
    for (let i = 0; i < 2; i++) {
        stage.send("pointerdown", 50, 50);
        stage.send("pointerup", 50, 50);
    }
    assert.deepEqual(kinds(), ["select", "fit"]);
});

test("two fingers zoom by their distance about their middle, and move it", () => {
    const { said, stage } = scene();
    stage.send("pointerdown", 100, 100, finger(1));
    stage.send("pointerdown", 200, 100, finger(2));
    stage.send("pointermove", 300, 100, finger(2));
    assert.deepEqual(said, [["pan", 50, 0], ["zoom", 200, 100, 2]]);
    stage.send("pointerup", 300, 100, finger(2));
    stage.send("pointermove", 105, 100, finger(1));
    assert.deepEqual(said.at(-1), ["pan", 5, 0], "and the one that stays pans");
});

test("a second finger ends a drag", () => {
    const { kinds, stage } = scene({ target: DISC, selected: true });
    stage.send("pointerdown", 50, 50, finger(1));
    stage.send("pointermove", 70, 50, finger(1));
    stage.send("pointerdown", 200, 50, finger(2));
    stage.send("pointermove", 80, 50, finger(1));
    assert.deepEqual(kinds(), ["drag", "dragEnd", "pan", "zoom"]);
});

test("a drag that the system takes away ends", () => {
    const { kinds, stage } = scene({ target: DISC });
    stage.send("pointerdown", 50, 50);
    stage.send("pointermove", 70, 50);
    stage.send("pointercancel", 70, 50);
    stage.send("pointermove", 90, 50);
    assert.deepEqual(kinds(), ["drag", "dragEnd", "hover"]);
});

test("the wheel zooms about the pointer and does not scroll the page", () => {
    const { said, stage } = scene();
    const event = stage.send("wheel", 30, 40, { deltaY: -100, deltaMode: 0, ctrlKey: false });
    assert.ok(event.defaultPrevented);
    assert.deepEqual(said[0].slice(0, 3), ["zoom", 30, 40]);
    assert.ok(said[0][3] > 1.1 && said[0][3] < 1.3);
    stage.send("wheel", 30, 40, { deltaY: 3, deltaMode: 1, ctrlKey: false });
    assert.ok(said[1][3] < 1);
});

test("the right button does nothing", () => {
    const { said, stage } = scene({ target: DISC });
    stage.send("pointerdown", 50, 50, { button: 2 });
    stage.send("pointermove", 90, 50, { button: 2, pointerId: 7, pointerType: "touch" });
    assert.deepEqual(said, []);
});

/** Gestures over a part of the curve. @param {"deadline"|"slider"|"plot"|null} part */
function curve(part) {
    const said = [], stage = new Stage();
    const say = (what) => (...values) => said.push([what, ...values]);
    new CurveGestures(/** @type {any} */ (stage), { hit: () => part, slide: say("slide"), moveDeadline: say("deadline"), hover: say("hover"), hold: say("hold") });
    return { said, stage };
}

test("a press on the curve takes the slider there and holds it", () => {
    const { said, stage } = curve("plot");
    stage.send("pointerdown", 40, 30);
    stage.send("pointermove", 55, 90);
    stage.send("pointermove", 5, 5, { pointerId: 2 });
    stage.send("pointerup", 55, 90);
    assert.deepEqual(said, [["hover", null], ["hold", true], ["slide", 40], ["slide", 55], ["hold", false]]);
});

test("a press on the deadline holds that", () => {
    const { said, stage } = curve("deadline");
    stage.send("pointerdown", 40, 30);
    stage.send("pointermove", 41, 35);
    assert.deepEqual(said.slice(2), [["deadline", 40, 30], ["deadline", 41, 35]]);
});

test("a mouse points without pressing, a finger does not", () => {
    const { said, stage } = curve("plot");
    stage.send("pointermove", 40, 30, finger(3));
    stage.send("pointermove", 40, 30);
    stage.send("pointerleave", 500, 30);
    assert.deepEqual(said, [["hover", 40], ["hover", null]]);
});

test("beside the curve nothing is held", () => {
    const { said, stage } = curve(null);
    stage.send("pointerdown", 40, 30);
    stage.send("pointermove", 40, 31);
    assert.deepEqual(said, [["hover", null]]);
});
