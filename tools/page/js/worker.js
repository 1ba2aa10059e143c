// SPDX-License-Identifier: MIT
/**
 * The core off the main thread. The first message is the module's bytes; each other one a job: {id, what, description, options}. Answers are {id, progress: [settled, all]},
 * and at last {id, result} or {id, error}. A job cannot be called off from here, for a worker that is busy hears nothing: remote.js ends the worker.
 */
import { loadCore } from "./core.js";
import { runJob } from "./job.js";

const PROGRESS_EVERY = 50; // milliseconds

/** @type {Promise<import("./core.js").Core> | null} */
let core = null;

/** @param {number} id */
function teller(id) {
    let next = 0;
    return (/** @type {number} */ settled, /** @type {number} */ all) => {
        const now = performance.now();
        if (now < next) return;
        next = now + PROGRESS_EVERY;
        postMessage({ id, progress: [settled, all] });
    };
}

/** @param {MessageEvent} event */
async function take(event) {
    if (!core) {
        core = loadCore(event.data);
        return;
    }
    const { id, what, description, options } = event.data;
    try {
        postMessage({ id, result: runJob(await core, what, description, { ...options, progress: teller(id) }) });
    } catch (error) {
        const { message, status = "failed", where } = /** @type {any} */ (error);
        postMessage({ id, error: { message, status, where } });
    }
}

addEventListener("message", take);
