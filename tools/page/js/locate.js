// SPDX-License-Identifier: MIT
// Where in a scene file the value is that a message names by its place, as "discs[3].radius". The text was read already, so it is JSON: its tokens suffice.

const TOKEN = /"(?:[^"\\]|\\.)*"|[{}[\],:]|[^\s{}[\],:"]+/g;

const path = (levels) => levels.map(({ key }, i) => (typeof key === "number" ? `[${key}]` : i === 0 ? key : `.${key}`)).join("");

/** Where the value at each place begins. @param {string} text @returns {Map<string, number>} */
function places(text) {
    const found = new Map();
    /** @type {{object: boolean, key: any, wantsKey: boolean}[]} the containers around */
    const levels = [];
    for (const { 0: token, index } of text.matchAll(TOKEN)) {
        const level = levels.at(-1);
        if (token === "}" || token === "]") levels.pop();
        else if (token === ":") level.wantsKey = false;
        else if (token === ",") {
            level.wantsKey = level.object;
            if (!level.object) level.key++;
        } else if (level?.wantsKey) level.key = JSON.parse(token);
        else {
            found.set(path(levels), index);
            if (token === "{" || token === "[") levels.push({ object: token === "{", key: token === "{" ? "" : 0, wantsKey: token === "{" });
        }
    }
    return found;
}

/** The place around a place; "" around all. */
const around = (place) => place.replace(/(?:^|\.)[^.[\]]*$|\[\d*\]$/, "");

/** Line and column of the value at `place`, or of the closest one around it that is there. @param {string} text @param {string} place */
export function locate(text, place) {
    const found = places(text);
    let wanted = place;
    while (wanted !== "" && !found.has(wanted)) wanted = around(wanted);
    const at = found.get(wanted) ?? 0;
    const lines = text.slice(0, at).split("\n");
    return { line: lines.length, column: [...lines.at(-1)].length + 1 };
}
