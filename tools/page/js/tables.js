// SPDX-License-Identifier: MIT
// The pictures as tables: for those who do not see them, and for those who want the numbers.
import { byId, element } from "tdsp/dom.js";
import { number } from "tdsp/numbers.js";

const MOST_ROWS = 500;

/** @param {string} caption @param {string[]} heads @param {(string|number)[][]} rows */
function table(caption, heads, rows) {
    const head = element("thead", {}, [element("tr", {}, heads.map((text) => element("th", { scope: "col", textContent: text })))]);
    const body = element("tbody", {}, rows.slice(0, MOST_ROWS).map((row) => element("tr", {}, row.map((cell) => element("td", { textContent: typeof cell === "number" ? number(cell, 8) : cell })))));
    const made = element("table", {}, [element("caption", { textContent: caption }), head, body]);
    const parts = [made];
    if (rows.length > MOST_ROWS) parts.push(element("p", { textContent: `And ${rows.length - MOST_ROWS} more: save the file for all of them.` }));
    return element("div", { className: "scroll", tabIndex: 0, role: "region", "aria-label": caption }, parts);
}

const timed = (name, unit) => (unit ? `${name} (${unit})` : name);

function jumpTable(jumps, unit) {
    const rows = jumps.map((j) => [j.departure, j.travelBefore, j.travelAfter, j.size, j.gap ? `${j.gap.first} and ${j.gap.second}` : "", j.gap ? j.gap.time : ""]);
    const heads = [timed("last departure before", unit), timed("travel time", unit), timed("then", unit), timed("longer by", unit), "discs that close", timed("at", unit)];
    return table(jumps.length === 0 ? "Jumps: none" : `Jumps (${jumps.length})`, heads, rows);
}

function rowTable(certified, unit) {
    const { departures, left, right } = certified.rows();
    const rows = Array.from(departures, (t, i) => [t, left[i], right[i]]);
    return table(`Rows of the table (${rows.length})`, [timed("departures up to", unit), timed("travel time at most", unit), timed("after it at least", unit)], rows);
}

function legTable(legs, unit) {
    const rows = legs.map((leg) => [leg.type === "line" ? "straight" : `rides disc ${leg.disc}, ${leg.turn === "ccw" ? "left" : "right"} turning`, leg.start_time, leg.end_time, leg.to[0], leg.to[1]]);
    return table(`The way (${legs.length} ${legs.length === 1 ? "leg" : "legs"})`, ["leg", timed("from", unit), timed("until", unit), "to x", "to y"], rows);
}

/** Where the table and what it is of have not changed it is left alone, scrolled as it is. */
let shown = { path: null, jumps: null, certified: null };

/** Fill the tables, where they are open. @param {{path: any, jumps: any[]|null, certified: any, unit: string}} facts */
export function showTables({ path, jumps, certified, unit }) {
    if (!byId("numbers").open) return;
    if (shown.path === path && shown.jumps === jumps && shown.certified === certified) return;
    shown = { path, jumps, certified };
    const parts = [];
    if (path) parts.push(legTable(path.legs, unit));
    if (jumps) parts.push(jumpTable(jumps, unit));
    if (certified) parts.push(rowTable(certified, unit));
    byId("numbers-body").replaceChildren(...parts);
}
