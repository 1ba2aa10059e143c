// SPDX-License-Identifier: MIT
// The page as a whole: every change of the state comes through here once, is computed, and is shown. Views and inputs only ask for changes.
import { Answers } from "tdsp/answers.js";
import { Controls, newGesture } from "tdsp/controls.js";
import { CurveView } from "tdsp/curve_view.js";
import { afterQuiet, byId, tell } from "tdsp/dom.js";
import { Playback } from "tdsp/playback.js";
import { SceneView } from "tdsp/scene_view.js";
import { effectiveScene, reduce } from "tdsp/state.js";
import { showTables } from "tdsp/tables.js";
import { answerWords, curveWords, infoWords, reasonWords, sceneWords, tableWords, timeWords } from "tdsp/words.js";

const SPOKEN_AFTER = 900; // milliseconds of quiet before the sentence is read aloud

export class Page {
    /** The path of the departure that is pointed at, and that departure. */
    #ghost = { departure: null, path: null };
    #gesture = newGesture();
    #frame = 0;
    #travel = (departure) => this.answers.travel(departure);
    /** What the picture of the scene was told last, and that of the curve. */
    #shown = {};
    #told = {};
    #sayLater = afterQuiet(SPOKEN_AFTER, () => { byId("live").textContent = byId("words").textContent; });

    /** @param {{core: any, remote: any, store: import("tdsp/state.js").Store}} parts */
    constructor({ core, remote, store }) {
        this.core = core;
        this.store = store;
        this.answers = new Answers(core, remote, () => this.show());
        this.playback = new Playback(() => this.show());
        this.controls = new Controls(store, { tryEdit: (action) => this.tryEdit(action), addDisc: () => this.addDisc() });
        this.scene = new SceneView(byId("scene"), {
            onDrag: (drag) => this.#drag(drag), onDragEnd: () => { this.#gesture = newGesture(); }, onSelect: (thing) => store.dispatch({ type: "select", thing }),
        });
        this.curve = new CurveView(byId("curve"), {
            onDeparture: (departure) => store.dispatch({ type: "departure", departure }), onDeadline: (deadline) => store.dispatch({ type: "deadline", deadline }),
            onHover: (departure) => this.#point(departure),
        });
        store.listen((state, before) => this.#changed(state, before));
        this.#bindTransport();
        byId("numbers").addEventListener("toggle", () => this.show());
    }

    #bindTransport() {
        byId("play").addEventListener("click", () => this.playback.toggle());
        byId("time").addEventListener("input", (event) => {
            if (this.playback.playing) this.playback.pause();
            this.playback.seek((Number(event.target.value) / 1000) * this.playback.span.arrival);
        });
        byId("pace").addEventListener("change", (event) => { this.playback.pace = Number(event.target.value); });
    }

    get units() {
        const units = this.store.state.edit ? this.store.state.edit.scene.units : this.answers.table?.info.units;
        return { length: units?.length ?? "", time: units?.time ?? "" };
    }

    // ------------------------------------------------------------------------------------------------------------- changes

    /** Open a scene or a table. Throws CoreError where the core refuses it; then everything stays. @param {any} action "open" */
    open(action) {
        if (action.bytes) this.answers.openTable(action.bytes);
        else this.answers.openScene(effectiveScene(action.edit ?? { scene: action.scene, factor: 1 }), action.epsilon ?? this.store.state.epsilon);
        this.#ghost = { departure: null, path: null };
        if (this.playback.playing) this.playback.pause();
        this.store.dispatch({ type: "open", ...action });
        this.playback.time = Math.min(action.time ?? this.#midway, this.playback.span.arrival);
        this.scene.fit();
        this.#showNow();
        if (action.view) this.#look(action.view);
    }

    /** The time that a scene is shown at first. */
    get #midway() {
        const { departure, arrival } = this.playback.span;
        return (departure + arrival) / 2;
    }

    /** What of the picture is not in the state: where it looks, and when. @returns {import("tdsp/link.js").Looked} */
    get looked() {
        const { time } = this.playback;
        return { view: this.scene.window, time: Math.abs(time - this.#midway) <= 1e-9 * time ? null : time };
    }

    /** Numbers on the axes decide how wide the window is, and what it shows, which numbers those are: so twice. @param {import("tdsp/gallery.js").View} view */
    #look(view) {
        for (let i = 0; i < 2; i++) {
            this.scene.draw();
            this.scene.window = view;
        }
    }

    /** Do an edit that may be no good: the sentence why not, or null. @param {any} action */
    tryEdit(action) {
        try {
            const next = reduce(this.store.state, action);
            const trial = this.core.scene(effectiveScene(next.edit));
            try {
                trial.path(next.departure);
            } finally {
                trial.free();
            }
        } catch (error) {
            if (!error.status) throw error;
            return error.message.replace(/\.?$/, ".");
        }
        this.store.dispatch(action);
        return null;
    }

    /** A disc in the middle of what is seen, as large as a typical one. */
    addDisc() {
        const { clientWidth, clientHeight } = byId("scene");
        const { discs } = this.store.state.edit.scene;
        const radius = this.scene.pixel * Math.min(clientWidth, clientHeight) * 0.05;
        const disc = { center: this.scene.placeAt(clientWidth / 2, clientHeight / 2), radius, growth: discs.at(-1)?.growth ?? 0 };
        this.store.dispatch({ type: "add-disc", disc });
        this.store.dispatch({ type: "select", thing: { what: "disc", index: discs.length } });
    }

    /** @param {import("tdsp/scene_view.js").Drag} drag */
    #drag({ what, index, place, radius }) {
        const { store } = this;
        if (!store.state.edit) return;
        const gesture = this.#gesture;
        const thing = { what: what === "rim" ? "disc" : what, index };
        if (store.state.selected?.what !== thing.what || store.state.selected?.index !== index) store.dispatch({ type: "select", thing });
        if (what === "rim") store.dispatch({ type: "disc", index, change: { radius }, gesture });
        else store.dispatch({ type: "place", thing, place, gesture });
    }

    #point(departure) {
        if (departure === this.#ghost.departure) return;
        const source = this.answers.scene ?? this.answers.table;
        this.#ghost = { departure, path: departure === null || !source ? null : source.path(departure) };
        this.show();
    }

    #changed(state, before) {
        const opened = state.original !== before.original || state.bytes !== before.bytes;
        try {
            if (!opened && state.edit !== before.edit) this.answers.edit(effectiveScene(state.edit));
            if (!opened && state.epsilon !== before.epsilon && state.edit) this.answers.rebuild(state.epsilon);
            if (opened || state.edit !== before.edit || state.departure !== before.departure || state.deadline !== before.deadline) this.#ask(state);
            this.problem(null);
        } catch (error) {
            if (!error.status) throw error;
            this.problem(error.message);
        }
        this.show();
    }

    #ask(state) {
        this.answers.ask(state.departure, state.deadline);
        const { path } = this.answers.found;
        const arrival = path.arrival ?? state.departure * 1.2 + (this.answers.until || 1) * 0.1;
        this.playback.setSpan({ departure: state.departure, arrival });
    }

    /** A sentence at the top of the page, or none. @param {string|null} sentence */
    problem(sentence) {
        tell(byId("problem"), sentence);
    }

    // --------------------------------------------------------------------------------------------------------------- showing

    /** Show everything as it is now, with the next frame at the latest. */
    show() {
        if (this.#frame) return;
        this.#frame = requestAnimationFrame(() => {
            this.#frame = 0;
            this.#showNow();
        });
    }

    /** @param {any} palette */
    setPalette(palette) {
        this.scene.show({ palette });
        this.curve.show({ palette });
    }

    #showNow() {
        const { state } = this.store;
        if (!state.edit && !state.bytes) return;
        const { found } = this.answers;
        this.#showScene(state, found);
        this.answers.sweep();
        this.#showCurve(state, found);
        this.controls.show(state);
        const { departure, deadline } = state;
        this.controls.showTimes({ until: this.answers.until, first: found.samples?.arrivals[0] || 0, arrival: this.#lastArrival(found), departure, deadline, units: this.units });
        this.controls.showTable({ built: found.built, problem: found.problems.table, none: this.#noTable(state, found), stale: found.tableStale });
        this.#showWords(state, found);
        this.scene.draw();
        this.curve.draw();
        showTables({ path: found.path, jumps: found.jumps, certified: found.tableStale ? null : this.answers.table ?? found.built?.table ?? null, unit: this.units.time });
        byId("busy").hidden = !found.working;
    }

    #lastArrival(found) {
        const end = this.answers.until;
        return Math.max(found.last?.arrival && Number.isFinite(found.last.arrival) ? found.last.arrival : end * 1.5, found.path?.arrival ?? 0);
    }

    #noTable(state, found) {
        if (state.bytes) return infoWords(this.answers.table.info, this.units.time);
        return found.last && found.last.departure < 0 ? `There is nothing to build: ${reasonWords(found.last.reason)} at departure 0.` : null;
    }

    #showScene(state, found) {
        const { playback } = this;
        if (this.#shown.scene !== this.answers.scene || this.#shown.description !== this.answers.scene?.description || this.#shown.table !== this.answers.table) this.#giveScene();
        const { legs } = { legs: [], ...found.path };
        if (this.#shown.legs !== legs) this.scene.show({ path: found.path });
        const ghost = this.#ghost.path ?? found.latestPath;
        if (this.#shown.ghost !== ghost) this.scene.show({ ghost });
        if (this.#shown.jumps !== found.jumps) this.scene.show({ jumps: found.jumps ?? [] });
        Object.assign(this.#shown, { legs, ghost, jumps: found.jumps });
        this.scene.show({ time: playback.time, selected: state.selected });
        this.#showTransport();
    }

    #giveScene() {
        const { scene, table } = this.answers;
        this.#shown = { scene, table, description: scene?.description };
        const canvas = byId("scene").getBoundingClientRect(), buttons = document.querySelector(".zoom").getBoundingClientRect();
        this.scene.show({ scene: scene ?? withoutDiscs(table, this.store.state.name), corner: { width: canvas.right - buttons.left + 4, height: buttons.bottom - canvas.top + 4 } });
    }

    #showTransport() {
        const { playback } = this;
        const [icon, word] = playback.playing ? ["❚❚", "Pause"] : ["▶", "Play"];
        const button = byId("play");
        button.querySelector("span").textContent = icon;
        button.querySelector("b").textContent = word;
        byId("time").value = String((playback.time / playback.span.arrival) * 1000);
        const clock = timeWords(playback.time, this.units.time);
        byId("time").setAttribute("aria-valuetext", clock);
        byId("clock").textContent = clock;
    }

    #showCurve(state, found) {
        const table = this.answers.table ?? (found.tableStale ? null : found.built?.table ?? null);
        const leaveBy = found.latest?.status === "ok" ? found.latest.departure : null;
        this.#tellCurve({
            samples: found.samples, table, jumps: found.jumps, bends: found.bends, last: found.last, departure: state.departure, deadline: state.deadline, leaveBy, hover: this.#ghost.departure, mode: state.mode,
            evaluate: this.answers.scene ? this.#travel : null, units: state.edit?.scene.units ?? this.answers.table?.info.units ?? null, message: noCurve(found),
        });
        byId("curve").parentElement.classList.toggle("stale", found.stale);
        tell(byId("curve-problem"), found.problems.jumps && `Where the curve jumps could not be found: ${found.problems.jumps.replace(/\.?$/, ".")}`);
    }

    /** Only what has changed: the rest of the picture need not be drawn anew. */
    #tellCurve(all) {
        const news = Object.fromEntries(Object.entries(all).filter(([key, value]) => this.#told[key] !== value));
        if (news.deadline !== undefined || news.leaveBy !== undefined) Object.assign(news, { deadline: all.deadline, leaveBy: all.leaveBy });
        if (Object.keys(news).length > 0) this.curve.show(news);
        this.#told = all;
    }

    #showWords(state, found) {
        const { departure, deadline } = state;
        const unit = this.units.time;
        const spoken = this.answers.table
            ? tableWords({ departure, answer: this.answers.table.arrival(departure), deadline, latest: found.latest, unit })
            : answerWords({ departure, answer: found.path, jumps: found.jumps, last: found.last, deadline, latest: found.latest, unit });
        const text = spoken.map((sentence) => sentence.text).join(" ");
        const box = byId("words");
        if (box.textContent !== text) {
            box.replaceChildren(...spoken.map(({ text: words, jump }) => Object.assign(document.createElement("span"), { textContent: `${words} `, className: jump ? "jump" : "" })));
            this.#sayLater();
        }
        const scene = state.edit?.scene ?? null;
        if (!this.playback.playing) byId("scene").setAttribute("aria-label", sceneWords({ name: this.title, scene, answer: found.path, time: this.playback.time, unit }));
        byId("curve").setAttribute("aria-label", curveWords({ jumps: found.jumps, last: found.last, mode: state.mode, unit }));
    }

    /** What the thing shown is called. */
    get title() {
        return byId("scene-title").textContent;
    }
}

/** What to say where there is no curve. */
function noCurve(found) {
    return found.last && found.last.departure < 0 ? `No departure arrives: ${reasonWords(found.last.reason)}.` : "";
}

/** A table as far as it is a scene: both ends, and no discs. */
function withoutDiscs(table, name) {
    const { source, destination, speed, units } = table.info;
    return { description: { name, units, robot: { speed }, source, destination, discs: [] }, radii: (_time, out) => out };
}
