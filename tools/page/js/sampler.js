// SPDX-License-Identifier: MIT
// The curve from samples, within the time that a frame leaves over: first a few departures over the whole range, then those between. What is there can be
// drawn at any time, so that a curve of a slow scene grows finer rather than late.

/** Departures looked at, and the coarsest step between them. */
export const SAMPLES = 129;
const COARSEST = 16;
const DRAWABLE = 17;

/** Indices from coarse to fine. */
export function refinedOrder(count = SAMPLES, coarsest = COARSEST) {
    const order = [];
    for (let step = coarsest; step >= 1; step /= 2) {
        for (let i = 0; i < count; i += step) if (step === coarsest || i % (2 * step) !== 0) order.push(i);
    }
    return order;
}

const ORDER = refinedOrder();

export class Sampler {
    #done = 0;

    /** @param {{samples: (times: Float64Array) => Float64Array}} scene @param {number} until the last departure */
    constructor(scene, until) {
        this.scene = scene;
        this.times = Float64Array.from({ length: SAMPLES }, (_, i) => (i === SAMPLES - 1 ? until : (until * i) / (SAMPLES - 1)));
        this.arrivals = new Float64Array(SAMPLES);
        this.known = new Uint8Array(SAMPLES);
    }

    get finished() {
        return this.#done === ORDER.length;
    }

    /** Enough to be drawn? */
    get drawable() {
        return this.#done >= DRAWABLE;
    }

    /** Go on for about so many milliseconds, and for one sample at least. @param {number} budget */
    run(budget) {
        const end = performance.now() + budget;
        while (!this.finished) {
            const index = ORDER[this.#done++];
            this.arrivals[index] = this.scene.samples(this.times.subarray(index, index + 1))[0];
            this.known[index] = 1;
            if (performance.now() >= end) return;
        }
    }

    /** What is known, in order. @returns {{times: Float64Array, arrivals: Float64Array}} */
    get samples() {
        const known = (_, i) => this.known[i] === 1;
        return { times: this.times.filter(known), arrivals: this.arrivals.filter(known) };
    }
}
