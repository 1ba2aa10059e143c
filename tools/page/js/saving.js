// SPDX-License-Identifier: MIT
// The menu that saves: one function for each kind of file.
import { all, byId } from "tdsp/dom.js";
import { answersJson, buildKeys, curveCsv, pathCsv, stackPng, stackSvg } from "tdsp/export.js";
import { save, sceneText } from "tdsp/files.js";
import { effectiveScene } from "tdsp/state.js";

export class Saving {
    /** @param {import("tdsp/page.js").Page} page */
    constructor(page) {
        this.page = page;
        for (const button of all("[data-save]")) {
            button.addEventListener("click", () => {
                byId("save-menu").open = false;
                this[button.dataset.save]();
            });
        }
        byId("save-menu").addEventListener("focusout", (event) => { if (!byId("save-menu").contains(event.relatedTarget)) byId("save-menu").open = false; });
        addEventListener("pointerdown", (event) => { if (!byId("save-menu").contains(event.target)) byId("save-menu").open = false; });
    }

    /** What files are called: as what was opened. */
    get name() {
        return this.page.store.state.name || "scene";
    }

    scene() {
        save(`${this.name}.json`, sceneText(effectiveScene(this.page.store.state.edit)), "application/json");
    }

    table() {
        const { answers, store } = this.page;
        save(`${this.name}.tdsp`, store.state.bytes ?? answers.found.built.bytes, "application/octet-stream");
    }

    svg() {
        const { scene, curve, title } = this.page;
        save(`${this.name}.svg`, stackSvg([scene.toSVG({ title, description: byId("words").textContent }), curve.toSVG({ title })]), "image/svg+xml");
    }

    async png() {
        const { scene, curve } = this.page;
        scene.draw();
        curve.draw();
        save(`${this.name}.png`, await stackPng([byId("scene"), byId("curve")], getComputedStyle(document.documentElement).getPropertyValue("--paper")), "image/png");
    }

    json() {
        const { found } = this.page.answers;
        const { built } = found;
        const build = built && !found.tableStale ? buildKeys(built.report, { epsilon: built.epsilon, seconds: built.seconds, file: `${this.name}.tdsp` }) : null;
        save(`${this.name}-answers.json`, answersJson({ name: this.page.title, path: found.path, jumps: found.stale ? null : found.jumps, last: found.last, build }), "application/json");
    }

    curve() {
        const { answers } = this.page;
        const { samples, jumps } = answers.found;
        const points = samples ? Array.from(samples.times, (departure, i) => ({ departure, arrival: samples.arrivals[i] })) : rowPoints(answers.table);
        save(`${this.name}-curve.csv`, curveCsv(points.filter((p) => Number.isFinite(p.arrival)), samples ? jumps ?? [] : []), "text/csv");
    }

    path() {
        const { core, answers } = this.page;
        save(`${this.name}-path.csv`, pathCsv(answers.found.path.legs, (leg, time) => core.position(leg, time)), "text/csv");
    }

    /** Offer what there is. */
    show() {
        const { found, table } = this.page.answers;
        const there = { scene: this.page.store.state.edit !== null, curve: found.samples !== null || table !== null, path: (found.path?.legs.length ?? 0) > 0 };
        for (const [kind, can] of Object.entries(there)) for (const button of all(`[data-save="${kind}"]`)) button.disabled = !can;
    }
}

/** A table's certified latest arrivals as points. */
function rowPoints(table) {
    const { departures, left } = table.rows();
    return Array.from(departures, (departure, i) => ({ departure, arrival: departure + left[i] }));
}
