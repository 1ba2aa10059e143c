// SPDX-License-Identifier: MIT
// The inputs of the page and the state, in both directions. An input never holds anything of its own: it shows the state, and asks for another one.
import { all, byId, setValue, tell } from "tdsp/dom.js";
import { number } from "tdsp/numbers.js";
import { isEdited, placeOf } from "tdsp/state.js";
import { buildWords, percentWords } from "tdsp/words.js";

/** The robot's speed goes from a quarter to four times that of the scene as it was opened. */
const SPEED_RANGE = 4;
let gestures = 0;

/** A gesture: what is dragged, or held on a slider, is undone as one. */
export const newGesture = () => ++gestures;

/** Ask `act(value, gesture)` for what is slid, one gesture from the first touch to the last. */
function onSlide(input, act) {
    let gesture = newGesture();
    input.addEventListener("input", () => act(Number(input.value), gesture));
    input.addEventListener("change", () => { gesture = newGesture(); });
}

/** Ask `act(value)` for a number that was typed; what is no such number is said beside it by the browser and not taken. */
function onNumber(input, act) {
    input.addEventListener("change", () => {
        const value = input.valueAsNumber;
        if (Number.isFinite(value) && value >= Number(input.min || -Infinity)) act(value);
        else input.reportValidity();
    });
}

const logOf = (ratio) => Math.log(ratio) / Math.log(SPEED_RANGE);

export class Controls {
    /** @param {import("tdsp/state.js").Store} store @param {{tryEdit: (action: any) => string|null, addDisc: () => void}} page tryEdit: the sentence why an edit cannot be, or null when done */
    constructor(store, page) {
        this.store = store;
        this.page = page;
        this.#bindTimes();
        this.#bindWhatIf();
        this.#bindThing();
        this.#bindTable();
    }

    #bindTimes() {
        const { store } = this;
        const leave = (departure) => store.dispatch({ type: "departure", departure });
        const arrive = (deadline) => store.dispatch({ type: "deadline", deadline });
        onSlide(byId("departure"), leave);
        onNumber(byId("departure-number"), leave);
        onSlide(byId("deadline"), arrive);
        onNumber(byId("deadline-number"), arrive);
        byId("deadline-on").addEventListener("change", (event) => arrive(event.target.checked ? middle(byId("deadline")) : null));
        for (const radio of all('input[name="mode"]')) radio.addEventListener("change", () => store.dispatch({ type: "mode", mode: radio.value }));
    }

    #bindWhatIf() {
        const { store } = this;
        const speed = (value, gesture) => store.dispatch({ type: "speed", speed: value, gesture });
        onSlide(byId("speed"), (value, gesture) => speed(Number((store.state.original.scene.robot.speed * SPEED_RANGE ** value).toPrecision(3)), gesture));
        onNumber(byId("speed-number"), (value) => tell(byId("thing-problem"), this.page.tryEdit({ type: "speed", speed: value })));
        const factor = (value, gesture) => store.dispatch({ type: "factor", factor: value, gesture });
        onSlide(byId("factor"), factor);
        onNumber(byId("factor-number"), (value) => factor(value));
        byId("undo").addEventListener("click", () => store.dispatch({ type: "undo" }));
        byId("redo").addEventListener("click", () => store.dispatch({ type: "redo" }));
        byId("reset").addEventListener("click", () => store.dispatch({ type: "reset" }));
    }

    #bindThing() {
        byId("thing").addEventListener("change", (event) => this.store.dispatch({ type: "select", thing: thingOf(event.target.value) }));
        const fields = { "thing-x": this.#moveTo, "thing-y": this.#moveTo, "thing-radius": this.#resize, "thing-growth": this.#regrow };
        for (const [id, act] of Object.entries(fields)) byId(id).addEventListener("change", () => this.#take(act));
        byId("add-disc").addEventListener("click", () => this.page.addDisc());
        byId("remove-disc").addEventListener("click", () => this.store.dispatch({ type: "remove-disc", index: this.store.state.selected.index }));
    }

    #take(act) {
        const { selected } = this.store.state;
        if (selected) tell(byId("thing-problem"), act.call(this, selected));
        else this.show(this.store.state);
    }

    #moveTo(thing) {
        const place = [byId("thing-x").valueAsNumber, byId("thing-y").valueAsNumber];
        if (!place.every(Number.isFinite)) return "A place has two numbers, x and y.";
        return this.page.tryEdit({ type: "place", thing, place });
    }

    #resize({ index }) {
        const radius = byId("thing-radius").valueAsNumber;
        return Number.isFinite(radius) ? this.page.tryEdit({ type: "disc", index, change: { radius } }) : "A radius is a number.";
    }

    #regrow({ index }) {
        let growth;
        try {
            growth = JSON.parse(byId("thing-growth").value);
        } catch {
            return 'A growth is a rate such as 0.3, coefficients such as [0.1, 0.02], or {"times": [0, 60], "rates": [0.1, 0.5]}.';
        }
        return this.page.tryEdit({ type: "disc", index, change: { growth } });
    }

    #bindTable() {
        onSlide(byId("epsilon"), (value) => this.store.dispatch({ type: "epsilon", epsilon: Number((10 ** value).toPrecision(2)) }));
    }

    /** Show the state. @param {import("tdsp/state.js").State} state */
    show(state) {
        const scene = state.edit?.scene ?? null;
        for (const id of ["what-if", "selected-panel"]) byId(id).disabled = scene === null;
        byId("undo").disabled = state.past.length === 0;
        byId("redo").disabled = state.future.length === 0;
        byId("reset").disabled = !isEdited(state);
        byId("epsilon").disabled = scene === null;
        setValue(byId("epsilon"), Math.log10(state.epsilon));
        byId("epsilon-value").textContent = scene ? percentWords(state.epsilon) : ""; // what a table was built with, its facts say
        for (const radio of all('input[name="mode"]')) radio.checked = radio.value === state.mode;
        if (!scene) return;
        setValue(byId("speed"), logOf(scene.robot.speed / state.original.scene.robot.speed));
        setValue(byId("speed-number"), scene.robot.speed);
        setValue(byId("factor"), state.edit.factor);
        setValue(byId("factor-number"), state.edit.factor);
        this.#showThing(state, scene);
    }

    #showThing(state, scene) {
        const { selected } = state;
        this.#listThings(scene.discs.length);
        byId("thing").value = nameOf(selected);
        const place = selected && placeOf(state, selected);
        const disc = selected?.what === "disc" ? scene.discs[selected.index] : null;
        const values = { "thing-x": place?.[0], "thing-y": place?.[1], "thing-radius": disc?.radius, "thing-growth": disc && JSON.stringify(disc.growth) };
        for (const [id, value] of Object.entries(values)) {
            byId(id).parentElement.hidden = value === undefined || value === null;
            setValue(byId(id), value ?? "");
        }
        byId("thing-hint").hidden = selected !== null;
        byId("remove-disc").disabled = disc === null;
    }

    #listThings(count) {
        const list = byId("thing");
        if (list.dataset.count === String(count)) return;
        list.dataset.count = String(count);
        const names = ["nothing", "source", "destination", ...Array.from({ length: count }, (_, i) => `disc ${i}`)];
        list.replaceChildren(...names.map((name) => new Option(name, name)));
    }

    /** Show how far the times can go. @param {{until: number, first: number, arrival: number, departure: number, deadline: number|null, units: {length: string, time: string}}} times */
    showTimes({ until, first, arrival, departure, deadline, units }) {
        const most = Math.max(until * 1.04, departure, 1e-9);
        ranged(byId("departure"), 0, most, departure);
        setValue(byId("departure-number"), tidy(departure));
        ranged(byId("deadline"), Math.min(first, deadline ?? first), Math.max(arrival, deadline ?? 0), deadline ?? first);
        setValue(byId("deadline-number"), deadline === null ? "" : tidy(deadline));
        byId("deadline-on").checked = deadline !== null;
        for (const id of ["deadline", "deadline-number"]) byId(id).disabled = deadline === null;
        const words = { time: units.time, speed: units.length && units.time ? `${units.length}/${units.time}` : "" };
        for (const span of all("[data-unit]")) span.textContent = words[span.dataset.unit];
    }

    /** What is known of the table. @param {{built: any, problem: string|null, none: string|null, stale: boolean}} table */
    showTable({ built, problem, none, stale }) {
        const facts = byId("table-facts");
        facts.classList.toggle("stale", stale);
        byId("copy-command").disabled = !built || stale;
        for (const button of all('[data-save="table"]')) button.disabled = (!built || stale) && !this.store.state.bytes;
        if (none ?? problem) facts.textContent = none ?? problem;
        else if (built) showFacts(facts, buildWords(built.report, built.seconds));
        else facts.textContent = "computing…";
    }
}

/** A number as people type it: no digits that only a computer reads. */
const tidy = (value) => Number(value.toPrecision(7));

/** About the middle of a range, in few digits. */
const middle = (input) => Number(((Number(input.min) + Number(input.max)) / 2).toPrecision(3));

function ranged(input, least, most, value) {
    if (input.min !== String(least)) input.min = String(least);
    if (input.max !== String(most)) input.max = String(most);
    setValue(input, value);
    input.setAttribute("aria-valuetext", number(value, 6));
}

function showFacts(box, { rows, size, calls, time }) {
    const strong = document.createElement("strong");
    strong.textContent = `${rows}, ${size}`;
    box.replaceChildren(strong, ` from ${calls} in ${time}. Answers any departure, with a path that is safe.`);
}

/** @param {import("tdsp/state.js").Thing|null} thing */
const nameOf = (thing) => (!thing ? "nothing" : thing.what === "disc" ? `disc ${thing.index}` : thing.what);

/** @param {string} name */
function thingOf(name) {
    if (name === "nothing") return null;
    return name.startsWith("disc ") ? { what: "disc", index: Number(name.slice(5)) } : { what: name, index: -1 };
}
