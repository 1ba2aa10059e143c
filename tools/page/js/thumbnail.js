// SPDX-License-Identifier: MIT
// A scene in a few dozen pixels: what discs cover at departure and at arrival, and the way between the ends. No words, no numbers.

import { sceneExtent } from "tdsp/scene_projection.js";

const POINTS = 160;

/** What the large picture shows at first, on this canvas. @param {HTMLCanvasElement} canvas @param {import("tdsp/gallery.js").Entry} entry */
function fitted(canvas, { scene, view }, radii, legs) {
    const extent = sceneExtent(scene, radii, legs);
    const [x, y] = view ? [view.x, view.y] : [(extent.xLow + extent.xHigh) / 2, (extent.yLow + extent.yHigh) / 2];
    const scale = view ? canvas.width / view.width : Math.min(canvas.width / (extent.xHigh - extent.xLow), canvas.height / (extent.yHigh - extent.yLow));
    return { scale, x: (at) => canvas.width / 2 + (at - x) * scale, y: (at) => canvas.height / 2 - (at - y) * scale };
}

/** Points along the legs, dense enough for this size. */
function pointsOf(core, path) {
    const points = [];
    const span = path.arrival - path.departure;
    for (const leg of path.legs) {
        const steps = leg.type === "line" ? 1 : Math.max(3, Math.ceil((POINTS * (leg.end_time - leg.start_time)) / span));
        for (let i = 0; i <= steps; i++) points.push(core.position(leg, leg.start_time + ((leg.end_time - leg.start_time) * i) / steps));
    }
    return points;
}

function fillDiscs(context, frame, discs, radii, colour) {
    context.fillStyle = colour;
    context.beginPath();
    discs.forEach((disc, i) => {
        const x = frame.x(disc.center[0]);
        const y = frame.y(disc.center[1]);
        const radius = Math.max(radii[i] * frame.scale, 0.8);
        context.moveTo(x + radius, y);
        context.arc(x, y, radius, 0, 2 * Math.PI);
    });
    context.fill();
}

function drawWay(context, frame, points, palette) {
    context.strokeStyle = palette.path;
    context.lineWidth = 3;
    context.lineJoin = "round";
    context.beginPath();
    points.forEach((p, i) => (i === 0 ? context.moveTo(frame.x(p[0]), frame.y(p[1])) : context.lineTo(frame.x(p[0]), frame.y(p[1]))));
    context.stroke();
}

function drawEnds(context, frame, { source, destination }, palette) {
    context.lineWidth = 3;
    for (const [place, fill] of [[source, palette.path], [destination, palette.paper]]) {
        context.fillStyle = fill;
        context.beginPath();
        context.arc(frame.x(place[0]), frame.y(place[1]), 5, 0, 2 * Math.PI);
        context.fill();
        context.stroke();
    }
}

/** @param {HTMLCanvasElement} canvas @param {any} core @param {import("tdsp/gallery.js").Entry} entry @param {any} palette */
export function drawThumbnail(canvas, core, entry, palette) {
    const context = canvas.getContext("2d");
    const scene = core.scene(entry.scene);
    try {
        const path = scene.path(0);
        const points = path.status === "ok" ? pointsOf(core, path) : [];
        const frame = fitted(canvas, entry, scene.radii(0), path.legs ?? []);
        context.fillStyle = palette.paper;
        context.fillRect(0, 0, canvas.width, canvas.height);
        fillDiscs(context, frame, entry.scene.discs, scene.radii(path.arrival ?? 0), palette.later);
        fillDiscs(context, frame, entry.scene.discs, scene.radii(0), palette.disc);
        drawWay(context, frame, points, palette);
        drawEnds(context, frame, entry.scene, palette);
    } finally {
        scene.free();
    }
}
