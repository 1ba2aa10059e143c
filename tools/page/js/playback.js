// SPDX-License-Identifier: MIT
// The clock of the scene. Time runs from 0, when the discs are as described, over the departure to the arrival; waiting for the departure is shown quicker
// than the way itself, which takes about as long for every scene.

/** Seconds on the wall for the way, and at most for the waiting before it. */
export const WAY_SECONDS = 6;
export const WAIT_SECONDS = 1.6;

/** How fast the scene's time runs, in its units a second on the wall. @param {number} time @param {{departure: number, arrival: number}} span */
export function rate(time, { departure, arrival }) {
    const way = Math.max(arrival - departure, 1e-9) / WAY_SECONDS;
    if (time >= departure) return way;
    return Math.max(departure / WAIT_SECONDS, way);
}

export class Playback {
    time = 0;
    pace = 1;
    /** @type {{departure: number, arrival: number}} */
    span = { departure: 0, arrival: 1 };
    #frame = 0;
    #before = 0;
    #ended = null;

    /** @param {() => void} changed called when the time or whether it plays changed */
    constructor(changed) {
        this.changed = changed;
    }

    get playing() {
        return this.#frame !== 0;
    }

    /** Play from here, or from the beginning where it had ended; `ended` is called when the robot arrives. @param {{from?: number, ended?: () => void}} [options] */
    play({ from, ended } = {}) {
        if (from !== undefined) this.time = from;
        else if (this.time >= this.span.arrival) this.time = 0;
        this.#ended = ended ?? null;
        if (this.playing) return;
        this.#before = performance.now();
        this.#frame = requestAnimationFrame((now) => this.#tick(now));
        this.changed();
    }

    pause() {
        cancelAnimationFrame(this.#frame);
        this.#frame = 0;
        this.#ended = null;
        this.changed();
    }

    toggle() {
        if (this.playing) this.pause();
        else this.play();
    }

    /** @param {number} time */
    seek(time) {
        this.time = Math.min(Math.max(0, time), this.span.arrival);
        this.changed();
    }

    /** A new departure or way. The robot stays where it was on its way: the same share of it is done. @param {{departure: number, arrival: number}} span */
    setSpan(span) {
        const before = this.span;
        const share = (this.time - before.departure) / Math.max(before.arrival - before.departure, 1e-9);
        const waited = before.departure > 0 ? this.time / before.departure : 1;
        this.time = this.time >= before.departure ? span.departure + Math.min(1, share) * (span.arrival - span.departure) : waited * span.departure;
        this.span = span;
    }

    #tick(now) {
        // A frame's time may be before the press that began to play, and time never runs back.
        const step = Math.max(0, Math.min(0.1, (now - this.#before) / 1000)) * this.pace;
        this.#before = now;
        this.time = advanced(this.time, step, this.span);
        if (this.time < this.span.arrival) {
            this.#frame = requestAnimationFrame((later) => this.#tick(later));
            this.changed();
            return;
        }
        this.#frame = 0;
        const ended = this.#ended;
        this.#ended = null;
        this.changed();
        ended?.();
    }
}

/** The time `elapsed` seconds on the wall after `time`; none passes in a frame that began before playing did. @param {number} time @param {number} elapsed @param {{departure: number, arrival: number}} span */
export function advanced(time, elapsed, span) {
    const step = Math.max(0, elapsed);
    const next = time + step * rate(time, span);
    if (time < span.departure && next > span.departure) {
        const used = (span.departure - time) / rate(time, span);
        return Math.min(span.arrival, span.departure + (step - used) * rate(span.departure, span));
    }
    return Math.min(span.arrival, next);
}
