// SPDX-License-Identifier: MIT
/** A long question by itself: a scene made, asked and freed. Results can be sent between threads. */

/** @typedef {"build" | "jumps" | "curve" | "last"} What */
/**
 * @param {import("./core.js").Core} core
 * @param {What} what
 * @param {import("./core.js").Description} description
 * @param {Record<string, any>} options as of the scene's method
 */
export function runJob(core, what, description, options) {
    const scene = core.scene(description);
    try {
        if (what === "last") return scene.last();
        if (what !== "curve") return scene[what](options);
        const { evaluate, ...curve } = scene.curve(options); // a function cannot be sent
        return curve;
    } finally {
        scene.free();
    }
}
