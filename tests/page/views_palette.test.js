// SPDX-License-Identifier: MIT
/** The colours can be told apart by everyone: WCAG 2.1, 1.4.3 for text and 1.4.11 for marks. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { contrast, dark, light, paletteOf } from "../../tools/page/js/palette.js";

const TEXT = 4.5;
const MARK = 3;

/** Text is written on paper, or with a halo of paper around it. */
const TEXTS = ["ink", "grey", "pathText", "otherText", "alarmText"];

/** What must be told from what: a mark, and all it is drawn upon. */
const MARKS = [
    ["discEdge", ["paper", "later"]],
    ["laterEdge", ["paper", "later"]],
    ["path", ["paper", "later", "tint"]],
    ["ahead", ["paper", "later"]],
    ["other", ["paper", "later"]],
    ["alarm", ["paper", "later"]],
    ["alarmFaint", ["paper"]],
    ["focus", ["paper", "later", "disc"]],
    ["ink", ["later", "tint"]],
];

for (const palette of [light, dark]) {
    for (const colour of TEXTS)
        test(`${palette.name}: ${colour} reads on paper`, () => assert.ok(contrast(palette[colour], palette.paper) >= TEXT, `${contrast(palette[colour], palette.paper)}`));
    for (const [colour, grounds] of MARKS)
        for (const ground of grounds)
            test(`${palette.name}: ${colour} stands out from ${ground}`, () => assert.ok(contrast(palette[colour], palette[ground]) >= MARK, `${contrast(palette[colour], palette[ground])}`));
}

test("a colour against itself has no contrast, black against white has all", () => {
    assert.equal(contrast("#000000", "#ffffff"), 21);
    assert.equal(contrast("#e69f00", "#e69f00"), 1);
});

test("a palette goes by its name", () => {
    assert.equal(paletteOf("dark"), dark);
    assert.equal(paletteOf("light"), light);
});
