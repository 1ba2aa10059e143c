// SPDX-License-Identifier: MIT
// Dark or light: what the system prefers, until somebody says otherwise here. The page takes its colours from the palette of the pictures.
import { byId } from "tdsp/dom.js";
import { paletteOf } from "tdsp/palette.js";

const KEY = "tdsp-theme";

function stored() {
    try {
        return localStorage.getItem(KEY);
    } catch {
        return null; // no storage for files in some browsers: the choice lasts as long as the page
    }
}

function store(name) {
    try {
        localStorage.setItem(KEY, name);
    } catch {
        // as above
    }
}

function paint(palette) {
    const root = document.documentElement;
    root.dataset.theme = palette.name;
    for (const [name, value] of Object.entries(palette)) if (name !== "name") root.style.setProperty("--" + name.replace(/[A-Z]/g, (c) => "-" + c.toLowerCase()), value);
    byId("theme").setAttribute("aria-pressed", String(palette.name === "dark"));
}

/** Follow system and switch; `changed(palette)` is called at once and for each change. @param {(palette: any) => void} changed */
export function followTheme(changed) {
    const system = matchMedia("(prefers-color-scheme: dark)");
    let chosen = stored();
    const apply = () => {
        const palette = paletteOf(chosen ?? (system.matches ? "dark" : "light"));
        paint(palette);
        changed(palette);
    };
    system.addEventListener("change", apply);
    byId("theme").addEventListener("click", () => {
        chosen = document.documentElement.dataset.theme === "dark" ? "light" : "dark";
        store(chosen);
        apply();
    });
    apply();
}
