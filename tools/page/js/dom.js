// SPDX-License-Identifier: MIT
// The few things that every part of the page does with its elements.

/** The element with this id, which index.html has. @param {string} id @returns {any} */
export function byId(id) {
    const found = document.getElementById(id);
    if (!found) throw new Error(`index.html has no element #${id}`);
    return found;
}

/** The elements that a selector finds. @param {string} selector @returns {NodeListOf<any>} */
export const all = (selector) => document.querySelectorAll(selector);

/** @param {string} tag @param {Record<string, any>} [properties] @param {(Node|string)[]} [children] */
export function element(tag, properties = {}, children = []) {
    const made = document.createElement(tag);
    for (const [key, value] of Object.entries(properties)) {
        if (key.includes("-") || key === "role" || key === "scope") made.setAttribute(key, value);
        else made[key] = value;
    }
    made.append(...children);
    return made;
}

/** Show a sentence next to its cause; null takes it away. @param {HTMLElement} box @param {string|null} sentence */
export function tell(box, sentence) {
    const text = box.querySelector("p") ?? box;
    if (sentence !== null && text.textContent !== sentence) text.textContent = sentence;
    box.hidden = sentence === null;
}

/** Set an input's value, but not under the hands of who is typing in it. @param {HTMLInputElement} input @param {string|number} value */
export function setValue(input, value) {
    const text = String(value);
    if (input.value !== text && !(document.activeElement === input && input.type !== "range" && input.type !== "checkbox")) input.value = text;
}

/** `work` once, a while after the last call. @param {number} milliseconds @param {() => void} work */
export function afterQuiet(milliseconds, work) {
    let timer = 0;
    return () => {
        clearTimeout(timer);
        timer = setTimeout(work, milliseconds);
    };
}
