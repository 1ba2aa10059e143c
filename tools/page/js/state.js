// SPDX-License-Identifier: MIT
// All that the page shows follows from one value, which nobody changes: an action makes the next one. So undoing is going back, a link is the value
// written down, and no two parts of the page can disagree.

/**
 * @typedef {[number, number]} Place
 * @typedef {number | number[] | {times: number[], rates: number[]}} Growth
 * @typedef {{center: Place, radius: number, growth: Growth}} Disc
 * @typedef {{name?: string, units?: {length: string, time: string}, robot: {speed: number, radius?: number}, source: Place, destination: Place, discs: Disc[]}} Scene
 * @typedef {{scene: Scene, factor: number}} Edit  a scene, and by what all its growth is multiplied
 * @typedef {{what: "source"|"destination"|"disc", index: number}} Thing  index: of the disc; -1 for an end
 * @typedef {{name: string, from: string|null, edit: Edit|null, original: Edit|null, past: Edit[], future: Edit[], gesture: number|null,
 *   bytes: Uint8Array|null, departure: number, deadline: number|null, mode: "travel"|"arrival", epsilon: number, selected: Thing|null}} State
 *   `bytes` is a table that was opened; `from` the scene's name in the gallery; `original` what was opened, before edits
 */

/** How many edits can be undone. */
export const REMEMBERED = 200;
/** The range of epsilon that the slider offers. */
export const EPSILON = { least: 1e-4, most: 0.5, first: 0.01 };

/** @type {State} */
export const START = Object.freeze({
    name: "", from: null, edit: null, original: null, past: [], future: [], gesture: null,
    bytes: null, departure: 0, deadline: null, mode: "travel", epsilon: EPSILON.first, selected: null,
});

/** The growth law `growth`, everywhere multiplied by `factor`. @param {Growth} growth @param {number} factor @returns {Growth} */
export function scaledGrowth(growth, factor) {
    if (typeof growth === "number") return growth * factor;
    if (Array.isArray(growth)) return growth.map((c) => c * factor);
    return { times: growth.times, rates: growth.rates.map((r) => r * factor) };
}

/** The last discs that were scaled: while the ends are dragged they stay the same ones, so that nothing is prepared anew. */
const scaled = { discs: null, factor: 1, result: null };

function scaledDiscs(discs, factor) {
    if (scaled.discs !== discs || scaled.factor !== factor) Object.assign(scaled, { discs, factor, result: discs.map((d) => ({ ...d, growth: scaledGrowth(d.growth, factor) })) });
    return scaled.result;
}

/** The scene that an edit means. The multiplier 1 leaves it as it is, to the bit. @param {Edit} edit @returns {Scene} */
export function effectiveScene(edit) {
    return edit.factor === 1 ? edit.scene : { ...edit.scene, discs: scaledDiscs(edit.scene.discs, edit.factor) };
}

/** Was the scene changed since it was opened? @param {State} state */
export function isEdited(state) {
    return state.edit !== null && (state.edit.scene !== state.original?.scene || state.edit.factor !== state.original?.factor);
}

/** Where the thing is. @param {State} state @param {Thing} thing @returns {Place|null} */
export function placeOf(state, thing) {
    const scene = state.edit?.scene;
    if (!scene) return null;
    return thing.what === "disc" ? scene.discs[thing.index]?.center ?? null : scene[thing.what];
}

/** @param {Scene} scene @param {Thing} thing @param {Place} place @returns {Scene} */
function withPlace(scene, thing, place) {
    return thing.what === "disc" ? withDisc(scene, thing.index, { center: place }) : { ...scene, [thing.what]: place };
}

function withDisc(scene, index, change) {
    return { ...scene, discs: scene.discs.map((d, i) => (i === index ? { ...d, ...change } : d)) };
}

/** What an action makes of the edit; null: it is no edit. @param {Edit} edit @returns {Edit|null} */
function edited({ scene, factor }, action) {
    switch (action.type) {
        case "place": return { scene: withPlace(scene, action.thing, action.place), factor };
        case "disc": return { scene: withDisc(scene, action.index, action.change), factor };
        case "add-disc": return { scene: { ...scene, discs: [...scene.discs, action.disc] }, factor };
        case "remove-disc": return { scene: { ...scene, discs: scene.discs.filter((_, i) => i !== action.index) }, factor };
        case "speed": return { scene: { ...scene, robot: { ...scene.robot, speed: action.speed } }, factor };
        case "factor": return { scene, factor: action.factor };
        default: return null;
    }
}

/** The edits of one gesture (a drag, a slider held) are undone as one. */
function withEdit(state, edit, gesture) {
    const same = gesture !== undefined && gesture === state.gesture;
    const past = same ? state.past : [...state.past, state.edit].slice(-REMEMBERED);
    return { ...state, edit, past, future: [], gesture: gesture ?? null, ...selectionWithin(state, edit) };
}

/** A disc that is not there is not selected. */
function selectionWithin(state, edit) {
    const gone = state.selected?.what === "disc" && !(state.selected.index < edit?.scene.discs.length);
    return gone ? { selected: null } : {};
}

function undone(state) {
    if (state.past.length === 0) return state;
    const edit = state.past.at(-1);
    return { ...state, edit, past: state.past.slice(0, -1), future: [state.edit, ...state.future], gesture: null, ...selectionWithin(state, edit) };
}

function redone(state) {
    if (state.future.length === 0) return state;
    const [edit, ...future] = state.future;
    return { ...state, edit, past: [...state.past, state.edit], future, gesture: null, ...selectionWithin(state, edit) };
}

/** A scene or a table that was opened; what was looked at before is forgotten, what was chosen stays. */
function opened(state, action) {
    const original = action.scene ? { scene: action.scene, factor: 1 } : null;
    const edit = action.edit ?? original;
    const next = { ...START, mode: action.mode ?? state.mode, epsilon: action.epsilon ?? state.epsilon, name: action.name, from: action.from ?? null, bytes: action.bytes ?? null,
        original, edit, departure: action.departure ?? 0, deadline: action.deadline ?? null, selected: action.selected ?? null };
    return { ...next, ...selectionWithin(next, edit) };
}

/** @param {State} state @param {{type: string, [key: string]: any}} action @returns {State} */
export function reduce(state, action) {
    switch (action.type) {
        case "open": return opened(state, action);
        case "undo": return undone(state);
        case "redo": return redone(state);
        case "departure": return { ...state, departure: Math.max(0, action.departure) };
        case "deadline": return { ...state, deadline: action.deadline };
        case "mode": return { ...state, mode: action.mode };
        case "epsilon": return { ...state, epsilon: action.epsilon };
        case "select": return { ...state, selected: action.thing };
        case "reset": return isEdited(state) ? withEdit(state, state.original, undefined) : state;
        default: {
            const edit = state.edit && edited(state.edit, action);
            if (!edit) throw new Error(`no such action: ${action.type}`);
            return withEdit(state, edit, action.gesture);
        }
    }
}

/** The one place that holds the present state. */
export class Store {
    #state = START;
    #listeners = [];

    get state() {
        return this.#state;
    }

    /** `listener(state, before)` is called after each change. */
    listen(listener) {
        this.#listeners.push(listener);
    }

    dispatch(action) {
        const before = this.#state;
        const next = reduce(before, action);
        if (next === before) return;
        this.#state = Object.freeze(next);
        for (const listener of this.#listeners) listener(next, before);
    }
}
