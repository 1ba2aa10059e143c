// SPDX-License-Identifier: MIT
// What the page shows, as files for other programs. JSON has the keys of `tdsp path --json`, `tdsp jumps --json` and `tdsp build --json`; CSV of a path has
// the columns of `tdsp convert path.json -o path.csv`.

/** A line of CSV; what is null is empty. */
const csvLine = (values) => values.map((v) => (v === null || v === undefined ? "" : String(v))).join(",");

const legDisc = (leg) => (leg.disc === undefined ? null : leg.disc);

/** Points of the path: the ends of its legs, and rides in steps of at most `most` radians. @param {any[]} legs @param {(leg: any, time: number) => [number, number]} position */
export function pathCsv(legs, position, most = 0.1) {
    const lines = ["time,x,y,leg,type,disc"];
    legs.forEach((leg, index) => {
        const steps = leg.type === "line" ? 1 : Math.max(1, Math.ceil(Math.abs(legAngle(leg)) / most));
        for (let i = index === 0 ? 0 : 1; i <= steps; i++) {
            const time = i === steps ? leg.end_time : leg.start_time + ((leg.end_time - leg.start_time) * i) / steps;
            const [x, y] = i === 0 ? leg.from : i === steps ? leg.to : position(leg, time);
            lines.push(csvLine([time, x, y, index, leg.type, legDisc(leg)]));
        }
    });
    return lines.join("\n") + "\n";
}

/** The angle that a ride turns about its disc; where the leg does not say it, a whole turn is more than it can be between two rows of a file. */
const legAngle = (leg) => leg.sweep ?? leg.angle ?? 2 * Math.PI;

/** The curve: both sides of every jump stand below one another. @param {{departure: number, arrival: number}[]} points @param {any[]} jumps */
export function curveCsv(points, jumps) {
    const rows = points.map(({ departure, arrival }) => [departure, 0, arrival - departure, arrival, null, null]);
    for (const { departure, travelBefore: before, travelAfter: after, gap } of jumps) {
        rows.push([departure, 1, before, departure + before, gap?.first, gap?.second], [departure, 2, after, departure + after, gap?.first, gap?.second]);
    }
    rows.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const seen = rows.filter((row, i) => row[1] !== 0 || (row[0] !== rows[i + 1]?.[0] && row[0] !== rows[i - 1]?.[0]));
    return ["departure,travel_time,arrival,first,second", ...seen.map(([t, , T, A, i, j]) => csvLine([t, T, A, i, j]))].join("\n") + "\n";
}

/** A jump with the command's keys. */
function jumpKeys({ departure, travelBefore, travelAfter, size, gap }) {
    const { first, second, time, place } = gap ?? { first: null, second: null, time: null, place: null };
    return { departure, before: travelBefore, after: travelAfter, size, first, second, time, place };
}

/** A leg with the command's keys: its arcs are also those whose rates change. */
function legKeys({ type, angle, sweep, ...leg }) {
    return type === "curve" ? { type: "arc", ...leg, sweep } : { type, ...leg };
}

/** The answers as one object: {scene, path, jumps, build}; what is not known is left out. */
export function answersJson({ name, path, jumps, last, build }) {
    const out = { scene: name };
    if (path) out.path = { departure: path.departure, arrival: path.arrival, status: path.status, legs: path.legs.map(legKeys) };
    if (jumps) out.jumps = { status: last && last.departure < 0 ? last.reason : "ok", jumps: jumps.map(jumpKeys) };
    if (build) out.build = build;
    return JSON.stringify(out, null, 1) + "\n";
}

/** The report of a build with the command's keys. */
export function buildKeys(report, { epsilon, seconds, file }) {
    return { rows: report.rows, bytes: report.bytes, forward_calls: report.forwardCalls, reverse_calls: report.reverseCalls, seconds, last_departure: report.lastDeparture,
        last_reason: report.lastReason, oracle_delta: report.oracleDelta, rough_calls: report.roughCalls, guarantee: "travel", epsilon, delta: null, sampling: "adaptive", table: file };
}

/** Two pictures in one SVG, one above the other. @param {string[]} pictures whole SVG documents */
export function stackSvg(pictures) {
    const sizes = pictures.map((svg) => ({ width: Number(/\bwidth="([\d.]+)/.exec(svg)?.[1]), height: Number(/\bheight="([\d.]+)/.exec(svg)?.[1]) }));
    const width = Math.max(...sizes.map((s) => s.width));
    const height = sizes.reduce((sum, s) => sum + s.height, 0);
    let top = 0;
    const parts = pictures.map((svg, i) => {
        const body = svg.replace(/^<\?xml[^>]*\?>\s*/, "").replace(/<svg\b/, `<svg x="0" y="${top}"`);
        top += sizes[i].height;
        return body;
    });
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">\n${parts.join("\n")}\n</svg>\n`;
}

/** Two canvases in one PNG, one above the other. @param {HTMLCanvasElement[]} canvases @param {string} paper the background @returns {Promise<Blob>} */
export function stackPng(canvases, paper) {
    const sheet = document.createElement("canvas");
    sheet.width = Math.max(...canvases.map((c) => c.width));
    sheet.height = canvases.reduce((sum, c) => sum + c.height, 0);
    const context = sheet.getContext("2d");
    context.fillStyle = paper;
    context.fillRect(0, 0, sheet.width, sheet.height);
    let top = 0;
    for (const canvas of canvases) {
        context.drawImage(canvas, 0, top);
        top += canvas.height;
    }
    return new Promise((resolve, reject) => sheet.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("The browser could not make a PNG of this size."))), "image/png"));
}
