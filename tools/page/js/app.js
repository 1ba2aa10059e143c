// SPDX-License-Identifier: MIT
// Where the parts of the page meet: it loads the core, opens what the link, the command or the gallery gives, and ties keys, files and menus to the page.
import { loadCore } from "tdsp/core.js";
import { byId, tell } from "tdsp/dom.js";
import { FileError, acceptDrops, openBytes, openFile, refusal, stem } from "tdsp/files.js";
import { Gallery } from "tdsp/gallery.js";
import { gallery as entries, wasmBytes } from "tdsp/inlined.js";
import { Keys } from "tdsp/keys.js";
import { LONGEST, LinkError, readLink, writeLink } from "tdsp/link.js";
import { Page } from "tdsp/page.js";
import { remoteCore } from "tdsp/remote.js";
import { Saving } from "tdsp/saving.js";
import { Show } from "tdsp/show.js";
import { Store } from "tdsp/state.js";
import { followTheme } from "tdsp/theme.js";
import { buildCommand } from "tdsp/words.js";

const ONLY_TABLE = "A table holds the ways, not the discs: open its scene (.json) to see them.";
const unexpected = (error) => tell(byId("problem"), `Something went wrong in this page: ${error?.message ?? error}`);

async function start() {
    const wasm = await wasmBytes();
    const core = await loadCore(wasm);
    const page = new Page({ core, remote: await remoteCore({ wasm }), store: new Store() });
    const show = new Show(page);
    const strip = new Gallery(entries, core, (entry) => openEntry(page, show, strip, entry));
    byId("version").textContent = core.version;
    followTheme((palette) => {
        page.setPalette(palette);
        strip.paint(palette);
    });
    page.store.listen((state) => strip.mark(state.from));
    bindFiles(page, strip, show);
    bindKeys(page, show);
    addEventListener("hashchange", () => openLink(page, strip, show));
    await openFirst(page, strip, show);
    globalThis.tdspPage = page; // for the console, and for the tests
}

/** What the page begins with: what the command put inside, what the link says, or the first scene, which plays. */
async function openFirst(page, strip, show) {
    const given = JSON.parse(byId("given").textContent);
    if (given && openGiven(page, given)) return;
    if (await openLink(page, strip, show)) return;
    openEntry(page, show, strip, strip.entries[0], true);
}

function openEntry(page, show, strip, entry, story = false) {
    describe(entry.title, entry.words.join(" "), entry.credit);
    page.open({ name: entry.id, from: entry.id, scene: entry.scene, departure: entry.departure, view: entry.view });
    if (story) show.story();
    else show.once();
}

function describe(title, words, credit) {
    byId("scene-title").textContent = title;
    document.title = `${title} · When to leave · libtdsp`;
    byId("scene-words").textContent = words ?? "";
    byId("credit").textContent = credit ?? "";
    byId("credit").hidden = !credit;
}

/** @returns {Promise<boolean>} whether the link led somewhere */
async function openLink(page, strip, show) {
    try {
        /** @type {any} of state.js */
        const action = await readLink(location.hash.slice(1), (name) => strip.find(name)?.scene);
        if (!action) return false;
        const entry = action.from ? strip.find(action.from) : null;
        if (entry) action.view ??= entry.view;
        const words = entry ? [entry.title, entry.words.join(" "), entry.credit] : action.bytes ? [action.name, ONLY_TABLE] : [action.scene.name ?? action.name];
        openWith(page, action, (error) => `The link is damaged: ${error.message}.`, words);
        show.stop();
        return true;
    } catch (error) {
        if (!(error instanceof LinkError)) throw error;
        if (!page.store.state.edit) openEntry(page, show, strip, strip.entries[0], true);
        page.problem(`${error.message} The gallery is all there.`);
        return true;
    }
}

/** Open, or say why not. @param {(error: Error) => string} sentence @param {any[]} words title, words, credit @returns {boolean} */
function openWith(page, action, sentence, words) {
    try {
        page.open(action);
    } catch (error) {
        if (!error.status) throw error;
        if (!page.store.state.edit && !page.store.state.bytes) throw new LinkError(sentence(error));
        page.problem(sentence(error));
        return false;
    }
    describe(...words);
    return true;
}

function openContent(page, content, fileName) {
    const words = content.bytes ? [content.name, ONLY_TABLE] : [content.scene.name ?? content.name];
    return openWith(page, content, (error) => refusal(fileName, error, content.text), words);
}

/** What `tdsp view` put inside. @returns {boolean} */
function openGiven(page, { name, scene, table }) {
    const content = scene ? { name: stem(name), scene } : openBytes(name, Uint8Array.from(atob(table), (c) => c.charCodeAt(0)));
    return openContent(page, content, name);
}

function bindFiles(page, strip, show) {
    const open = async (file) => {
        if (!file) return;
        try {
            if (openContent(page, await openFile(file), file.name)) show.once();
        } catch (error) {
            if (!(error instanceof FileError)) throw error;
            page.problem(error.message);
        }
    };
    byId("open").addEventListener("click", () => byId("file").click());
    byId("file").addEventListener("change", (event) => {
        open(event.target.files[0]);
        event.target.value = "";
    });
    acceptDrops(open);
    const saving = new Saving(page);
    byId("save-menu").addEventListener("toggle", () => saving.show());
    byId("problem").querySelector("button").addEventListener("click", () => page.problem(null));
    byId("share").addEventListener("click", () => share(page));
    byId("copy-command").addEventListener("click", () => {
        const { state } = page.store;
        copy(page, buildCommand({ file: state.name || "scene", epsilon: state.epsilon, horizon: page.answers.found.horizon }), byId("copy-command"));
    });
}

async function share(page) {
    const fragment = await writeLink(page.store.state, page.looked);
    if (fragment.length > LONGEST) {
        page.problem("This is too much for a link: save the file and send it.");
        return;
    }
    history.replaceState(null, "", `#${fragment}`);
    await copy(page, location.href, byId("share"));
}

/** Copy a text and say so on the button; where the browser does not let pages copy, say where the text is. */
async function copy(page, text, button) {
    const before = button.textContent;
    try {
        await navigator.clipboard.writeText(text);
        button.textContent = "Copied";
        byId("live").textContent = "Copied.";
    } catch {
        page.problem(text === location.href ? "This browser does not let the page copy: the link is in the address bar." : `This browser does not let the page copy. The command is: ${text}`);
        return;
    }
    setTimeout(() => { button.textContent = before; }, 1500);
}

function bindKeys(page, show) {
    const { store, playback } = page;
    new Keys({
        play: () => playback.toggle(),
        leave: (direction, fine) => store.dispatch({ type: "departure", departure: store.state.departure + direction * page.answers.until * (fine ? 0.0005 : 0.01) }),
        jump: () => show.nextJump(),
        select: (thing) => { if (store.state.edit) store.dispatch({ type: "select", thing }); },
        selectNext: (by) => show.selectNext(by),
        move: (dx, dy, gesture) => show.move(dx, dy, gesture),
        pan: (dx, dy) => page.scene.pan(dx, dy),
        zoom: (factor) => page.scene.zoom(factor),
        fit: () => page.scene.fit(),
        undo: () => store.dispatch({ type: "undo" }),
        redo: () => store.dispatch({ type: "redo" }),
    });
    const zooms = { "zoom-in": () => page.scene.zoom(1.25), "zoom-out": () => page.scene.zoom(0.8), "zoom-fit": () => page.scene.fit() };
    for (const [id, act] of Object.entries(zooms)) byId(id).addEventListener("click", act);
}

addEventListener("unhandledrejection", (event) => unexpected(event.reason));
addEventListener("error", (event) => unexpected(event.error ?? event.message));
start().catch(unexpected);
