// SPDX-License-Identifier: MIT
/**
 * The long questions as promises, asked on workers, so that the page stays alive. Invariant: a worker has at most one job, so that ending a worker, which is how a job
 * is called off, ends no other.
 *
 * Where no worker can be started the job runs on the main thread: the page stands still meanwhile, and only a signal that was given before is heeded.
 *
 * Tried with real workers, from a file and from a server, and without any in tests/page/browser, and by itself in tests/page/bundle.test.js.
 */
import { CoreError, loadCore } from "./core.js";
import { wasmBytes, workerSource } from "./inlined.js";
import { runJob } from "./job.js";

/** @typedef {import("./core.js").Description} Description */
/** @typedef {import("./core_scene.js").BuildOptions & {signal?: AbortSignal}} BuildOptions */
/** @typedef {import("./core_scene.js").JumpOptions & {signal?: AbortSignal}} JumpOptions */
/** @typedef {import("./core_scene.js").CurveOptions & {signal?: AbortSignal}} CurveOptions */
/** @typedef {{postMessage(message: any): void, terminate(): void, onmessage: any, onerror: any}} WorkerLike */
/**
 * @typedef {Object} Job
 * @property {number} id
 * @property {import("./job.js").What} what
 * @property {Description} description
 * @property {Record<string, any>} options without progress and signal
 * @property {((settled: number, all: number) => any) | undefined} progress true calls the job off
 * @property {AbortSignal | undefined} signal
 * @property {(result: any) => void} resolve
 * @property {(error: unknown) => void} reject
 */

const MOST_WORKERS = 2; // a table and a curve at once

/** @returns {WorkerLike} */
function startWorker() {
    if (workerSource === null) return new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    const url = URL.createObjectURL(new Blob([workerSource], { type: "text/javascript" }));
    const worker = new Worker(url);
    setTimeout(() => URL.revokeObjectURL(url), 10000); // it is loaded by then
    return worker;
}

const cancelled = () => new CoreError("the work was called off", "cancelled");

export class Remote {
    /** @type {ArrayBuffer} */ #bytes;
    /** @type {() => WorkerLike} */ #start;
    /** @type {WorkerLike[]} */ #idle = [];
    /** @type {Map<WorkerLike, Job>} */ #running = new Map();
    /** @type {Job[]} */ #waiting = [];
    #lastId = 0;

    /**
     * @param {ArrayBuffer} bytes of the module
     * @param {() => WorkerLike} start
     */
    constructor(bytes, start) {
        this.#bytes = bytes;
        this.#start = start;
    }

    /**
     * As scene.build().
     * @param {Description} description
     * @param {BuildOptions} [options]
     * @returns {Promise<{bytes: Uint8Array, report: import("./core_scene.js").BuildReport}>}
     */
    build(description, options) {
        return this.#ask("build", description, options);
    }

    /**
     * As scene.jumps().
     * @param {Description} description
     * @param {JumpOptions} [options]
     * @returns {Promise<import("./core_scene.js").Jump[]>}
     */
    jumps(description, options) {
        return this.#ask("jumps", description, options);
    }

    /**
     * As scene.curve(), without evaluate.
     * @param {Description} description
     * @param {CurveOptions} [options]
     * @returns {Promise<import("./core_scene.js").Curve>}
     */
    curve(description, options) {
        return this.#ask("curve", description, options);
    }

    /**
     * As scene.last().
     * @param {Description} description
     * @param {{signal?: AbortSignal}} [options]
     * @returns {Promise<import("./core_scene.js").Last>}
     */
    last(description, options) {
        return this.#ask("last", description, options);
    }

    /** End all workers and call off all jobs. */
    close() {
        for (const worker of [...this.#idle, ...this.#running.keys()]) worker.terminate();
        for (const job of [...this.#running.values(), ...this.#waiting]) job.reject(cancelled());
        this.#idle = [];
        this.#waiting = [];
        this.#running.clear();
    }

    /**
     * @param {import("./job.js").What} what
     * @param {Description} description
     * @param {Record<string, any>} [all]
     * @returns {Promise<any>}
     */
    #ask(what, description, all = {}) {
        const { progress, signal, ...options } = all;
        return new Promise((resolve, reject) => {
            const job = { id: ++this.#lastId, what, description, options, progress, signal, resolve, reject };
            if (signal?.aborted) return reject(cancelled());
            signal?.addEventListener("abort", () => this.#callOff(job), { once: true });
            this.#waiting.push(job);
            this.#next();
        });
    }

    #next() {
        while (this.#waiting.length > 0 && this.#running.size < MOST_WORKERS) {
            const job = /** @type {Job} */ (this.#waiting.shift());
            const worker = this.#idle.pop() ?? this.#tryStart();
            if (!worker) {
                this.#runHere(job);
                continue;
            }
            this.#running.set(worker, job);
            const { id, what, description, options } = job;
            worker.postMessage({ id, what, description, options });
        }
    }

    /** @returns {WorkerLike | null} */
    #tryStart() {
        let worker;
        try {
            worker = this.#start();
        } catch {
            return null; // a browser or a policy without workers: #runHere() does it
        }
        worker.onmessage = (/** @type {MessageEvent} */ event) => this.#hear(worker, event.data);
        worker.onerror = (/** @type {ErrorEvent} */ event) => this.#lose(worker, event);
        worker.postMessage(this.#bytes);
        return worker;
    }

    /**
     * @param {WorkerLike} worker
     * @param {any} message
     */
    #hear(worker, message) {
        const job = this.#running.get(worker);
        if (!job || job.id !== message.id) return;
        if (message.progress) {
            if (job.progress?.(message.progress[0], message.progress[1]) === true) this.#callOff(job);
            return;
        }
        this.#running.delete(worker);
        this.#idle.push(worker);
        if (message.error) job.reject(new CoreError(message.error.message, message.error.status, message.error.where));
        else job.resolve(message.result);
        this.#next();
    }

    /**
     * A worker that could not load, or died. One that never did anything is no reason to fail: the job runs here.
     * @param {WorkerLike} worker
     * @param {ErrorEvent} event
     */
    #lose(worker, event) {
        const job = this.#running.get(worker);
        this.#running.delete(worker);
        this.#idle = this.#idle.filter((other) => other !== worker);
        worker.terminate();
        if (job && event.message) job.reject(new CoreError(`the worker failed: ${event.message}`, "failed"));
        else if (job) this.#runHere(job);
        this.#next();
    }

    /** @param {Job} job */
    #callOff(job) {
        job.reject(cancelled());
        this.#waiting = this.#waiting.filter((other) => other !== job);
        for (const [worker, running] of this.#running) {
            if (running !== job) continue;
            this.#running.delete(worker);
            worker.terminate();
        }
        this.#next();
    }

    /** @param {Job} job */
    async #runHere(job) {
        await new Promise((resolve) => setTimeout(resolve, 0)); // let the page say that it works
        if (job.signal?.aborted) return;
        try {
            const core = await loadCore(this.#bytes);
            job.resolve(runJob(core, job.what, job.description, { ...job.options, progress: job.progress }));
        } catch (error) {
            job.reject(error);
        }
    }
}

/**
 * Workers for the long questions. Both parts can be brought along: the module's bytes, and what starts a worker.
 * @param {{wasm?: ArrayBuffer, start?: () => WorkerLike}} [parts]
 * @returns {Promise<Remote>}
 */
export async function remoteCore({ wasm, start = startWorker } = {}) {
    return new Remote(wasm ?? (await wasmBytes()), start);
}
