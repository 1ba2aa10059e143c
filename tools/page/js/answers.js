// SPDX-License-Identifier: MIT
// All that is computed about the scene or the table at hand. What a drag needs in every frame (path, latest departure, samples of the curve) is asked here and
// now; what takes longer (jumps, the table) goes to a worker once nothing has changed for a while, and is called off as soon as something does. Until the new
// answer is there the old one stays, marked as stale.
import { Sampler } from "tdsp/sampler.js";

const QUIET = 140; // milliseconds without a change before a worker is asked
const FRAME_BUDGET = 4; // milliseconds of a frame for samples
const QUICK_LAST = 6; // milliseconds: a question for the last departure that takes longer goes to the worker
const BENDS_UP_TO = 24; // discs: of more, to find all bends takes minutes
const SAME = 1e-9; // of a departure: two searches for one jump are nearer
const HORIZON_TRIPS = 4; // where no disc ends the departures, the curve ends after about so many travel times

/** A round number of about this size, not below it. @param {number} value */
export function roundUp(value) {
    if (!(value > 0)) return 1;
    const power = 10 ** Math.floor(Math.log10(value));
    return [1, 1.5, 2, 3, 4, 5, 6, 8, 10].map((x) => x * power).find((x) => x >= value * (1 - 1e-12)) ?? 10 * power;
}

/**
 * @typedef {object} Found
 * @property {any} path of the departure chosen
 * @property {any} latest for the deadline; null without one
 * @property {any} latestPath and its path
 * @property {any} last what ends the departures; null while unknown
 * @property {number|null} horizon where the curve ends though departures do not; null where they do
 * @property {{times: Float64Array, arrivals: Float64Array}|null} samples
 * @property {any[]|null} jumps
 * @property {{departure: number, travel: number}[]} bends where the curve bends without a jump, as far as they are known
 * @property {{bytes: Uint8Array, report: any, seconds: number, epsilon: number, table: any}|null} built
 * @property {boolean} stale the curve is of the scene before
 * @property {boolean} tableStale and so is the table
 * @property {boolean} working a worker computes
 * @property {{jumps: string|null, table: string|null}} problems sentences
 */

const NO_PROBLEMS = Object.freeze({ jumps: null, table: null });

/** @returns {Found} */
const nothing = () => ({ path: null, latest: null, latestPath: null, last: null, horizon: null, samples: null, jumps: null, bends: [], built: null, stale: false, tableStale: false, working: false, problems: NO_PROBLEMS });

export class Answers {
    found = nothing();
    /** The prepared scene, or null. @type {any} */ scene = null;
    /** A table that was opened, or null. @type {any} */ table = null;
    #sampler = null;
    #retired = [];
    #sampling = 0;
    #quiet = 0;
    #jobs = { shape: new AbortController(), table: new AbortController() };
    #lastCost = 0;
    #epsilon = 0.01;
    /** What the latest departure was asked for. */
    asked = { source: null, description: null, deadline: null };
    #shaped = false; // all jumps of this scene are known

    /** @param {any} core @param {any} remote @param {() => void} changed called when something more is known */
    constructor(core, remote, changed) {
        this.core = core;
        this.remote = remote;
        this.changed = changed;
    }

    /** Look at another scene from now on. Throws CoreError and leaves everything as it was where it is none. */
    openScene(description, epsilon) {
        const scene = this.core.scene(description);
        this.#forget();
        this.scene = scene;
        this.#epsilon = epsilon;
        this.#begin();
    }

    /** @param {Uint8Array} bytes */
    openTable(bytes) {
        const table = this.core.table(bytes);
        this.#forget();
        this.table = table;
        this.found = { ...nothing(), jumps: table.jumps(), last: { departure: table.info.last_departure, reason: table.info.last_reason } };
    }

    /** The same scene, edited. Moved ends cost nothing; anything else prepares the scene anew. */
    edit(description) {
        const before = this.scene.description;
        if (before.discs === description.discs && before.robot === description.robot) this.scene.setEnds(description.source, description.destination);
        else {
            const scene = this.core.scene(description);
            this.#retired.push(this.scene);
            this.scene = scene;
        }
        this.found = { ...this.found, stale: true, tableStale: true, problems: NO_PROBLEMS };
        this.#begin();
    }

    /** The path for a departure, and the latest departure for a deadline. */
    ask(departure, deadline) {
        const source = this.scene ?? this.table;
        this.found = { ...this.found, path: source.path(departure), ...this.#latest(source, deadline) };
    }

    /** The latest departure for a deadline and its path; asked again only where one of the two is another. */
    #latest(source, deadline) {
        const { description } = source;
        const { asked } = this;
        if (asked.source === source && asked.description === description && asked.deadline === deadline) return {};
        this.asked = { source, description, deadline };
        const latest = deadline === null ? null : source.departure(deadline);
        return { latest, latestPath: latest?.status === "ok" ? source.path(latest.departure) : null };
    }

    /** Another epsilon: only the table changes. */
    rebuild(epsilon) {
        this.#epsilon = epsilon;
        this.#jobs.table.abort();
        this.#wait(true);
    }

    /** The exact travel time of a departure. */
    travel(departure) {
        const { path } = this.found;
        if (path?.departure === departure && path.status === "ok") return path.arrival - departure;
        const answer = this.scene?.arrival(departure);
        return answer?.travelTime ?? NaN;
    }

    /** Give back the memory of scenes that were replaced: to be called when nothing draws them any more. */
    sweep() {
        for (const scene of this.#retired) scene.free();
        this.#retired = [];
    }

    /** Are all samples of the curve taken? */
    get sampled() {
        return this.#sampler === null || this.#sampler.finished;
    }

    /** The end of the curve: a departure. */
    get until() {
        const { last, horizon } = this.found;
        if (horizon !== null) return horizon;
        return last && last.departure > 0 ? last.departure : 0;
    }

    #forget() {
        this.#callOff();
        cancelAnimationFrame(this.#sampling);
        this.#sampling = 0;
        this.#sampler = null;
        if (this.scene) this.#retired.push(this.scene);
        this.table?.free();
        this.found.built?.table.free();
        this.scene = this.table = null;
        this.#lastCost = 0;
        this.found = nothing();
    }

    #callOff() {
        clearTimeout(this.#quiet);
        this.#jobs.shape.abort();
        this.#jobs.table.abort();
    }

    /** The scene is new or edited: what is quick now, the rest later. */
    #begin() {
        this.#callOff();
        this.#shaped = false;
        cancelAnimationFrame(this.#sampling); // those samples are of a scene that is given back soon
        this.#sampler = null;
        if (this.#lastCost < QUICK_LAST) {
            const began = performance.now();
            this.#learnLast(this.scene.last());
            this.#lastCost = performance.now() - began;
        }
        this.#wait(false);
    }

    #learnLast(last) {
        const horizon = Number.isFinite(last.departure) ? null : roundUp(HORIZON_TRIPS * (this.scene.arrival(0).travelTime || 1));
        this.found = { ...this.found, last, horizon };
        if (last.departure < 0) {
            this.found = { ...this.found, samples: null, jumps: [], stale: false, tableStale: false };
            this.#sampler = null;
            return;
        }
        this.#sampler = new Sampler(this.scene, this.until);
        this.#sample();
    }

    /** A slice of samples now, the next with the next frame. */
    #sample() {
        cancelAnimationFrame(this.#sampling);
        this.#sampling = 0;
        const sampler = this.#sampler;
        if (!sampler) return;
        sampler.run(FRAME_BUDGET);
        if (sampler.drawable) this.found = { ...this.found, samples: sampler.samples, ...(this.found.stale ? { stale: false, jumps: null, bends: [] } : {}) };
        if (sampler.finished) return;
        this.#sampling = requestAnimationFrame(() => {
            this.#sample();
            this.changed();
        });
    }

    #wait(tableOnly) {
        clearTimeout(this.#quiet);
        const shape = !tableOnly || !this.#shaped;
        this.found = { ...this.found, working: true };
        this.#quiet = setTimeout(() => this.#workLater(shape), QUIET);
    }

    async #workLater(shape) {
        const { scene } = this;
        this.#callOff();
        this.#jobs = { shape: new AbortController(), table: new AbortController() };
        const jobs = this.#jobs;
        try {
            if (shape && this.#lastCost >= QUICK_LAST) this.#learnLast(await this.remote.last(scene.description, { signal: jobs.shape.signal }));
            const work = [this.#build(scene, jobs.table.signal)];
            if (shape) work.push(this.#shape(scene, jobs.shape.signal));
            await Promise.all(work);
        } catch (error) {
            unlessCancelled(error);
            return;
        }
        if (this.scene !== scene || jobs !== this.#jobs) return;
        this.found = { ...this.found, working: false, stale: false };
        this.changed();
        if (shape) await this.#bend(scene, jobs.shape.signal);
    }

    /** What nobody has to wait for: where the way rides other discs than a moment before. */
    async #bend(scene, signal) {
        if (this.found.last.departure < 0 || scene.count > BENDS_UP_TO) return;
        const { curve } = await settled(this.remote.curve(scene.description, { signal, until: this.until }), "curve").catch(unlessCancelled);
        if (signal.aborted || !curve) return;
        const bends = curve.pieces.filter(({ change }) => change === "touch" || change === "switch").map(({ until, travelUntil }) => ({ departure: until, travel: travelUntil }));
        this.found = { ...this.found, bends, jumps: withSmallJumps(this.found.jumps ?? [], curve.pieces), problems: { ...this.found.problems, jumps: null } };
        this.changed();
    }

    async #shape(scene, signal) {
        if (this.found.last.departure < 0) return;
        const options = this.found.horizon === null ? { signal } : { signal, until: this.found.horizon };
        const { jumps, problem } = await settled(this.remote.jumps(scene.description, options), "jumps");
        if (signal.aborted) return;
        this.#shaped = true;
        this.found = { ...this.found, jumps: jumps ?? null, problems: { ...this.found.problems, jumps: problem }, stale: false };
        this.changed();
    }

    async #build(scene, signal) {
        const epsilon = this.#epsilon;
        const { horizon } = this.found;
        const began = performance.now();
        const options = horizon === null ? { epsilon, signal } : { epsilon, horizon, signal };
        const { built, problem } = await settled(this.remote.build(scene.description, options), "built");
        if (signal.aborted) return;
        const seconds = (performance.now() - began) / 1000;
        const table = built ? this.core.table(built.bytes) : null;
        this.found.built?.table.free();
        // A table knows its jumps, and is often there before the worker has found all of them.
        const jumps = this.found.jumps ?? (this.found.problems.jumps === null ? table?.jumps().filter((jump) => Number.isFinite(jump.size)) : null) ?? null;
        this.found = { ...this.found, jumps, tableStale: false, built: built ? { ...built, seconds, epsilon, table } : null, problems: { ...this.found.problems, table: problem } };
        this.changed();
    }
}

/** All jumps of the curve: those that are known, and those between its pieces that are too small to be looked for. @param {any[]} jumps @param {any[]} pieces */
function withSmallJumps(jumps, pieces) {
    const known = (departure) => jumps.some((jump) => Math.abs(jump.departure - departure) <= SAME * departure);
    const small = pieces.slice(0, -1).flatMap(({ change, until: departure, travelUntil: travelBefore, gap }, i) => {
        const travelAfter = pieces[i + 1].travelFrom;
        return change === "jump" && !known(departure) ? [{ departure, travelBefore, travelAfter, size: travelAfter - travelBefore, gap }] : [];
    });
    return [...jumps, ...small].sort((one, other) => one.departure - other.departure);
}

/** Being called off is no failure. @returns {any} nothing */
function unlessCancelled(error) {
    if (error.status !== "cancelled") throw error;
    return {};
}

/** The result under its name, or the sentence that says why there is none. Being called off is neither. */
async function settled(promise, name) {
    try {
        return { [name]: await promise, problem: null };
    } catch (error) {
        if (error.status === "cancelled" || !error.status) throw error;
        return { [name]: null, problem: error.message };
    }
}
