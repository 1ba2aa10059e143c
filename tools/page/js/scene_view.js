// SPDX-License-Identifier: MIT
/**
 * The scene on a canvas: discs growing, the robot on its path, gaps that close; panned, zoomed, and its things dragged. What it shows is
 * told to it (show()); what a person does to it is told by the callbacks, and nothing changes until show() says so, but for the view
 * itself, which is the view's own.
 */
import { light } from "tdsp/palette.js";
import { Layers } from "tdsp/draw_layers.js";
import { centersOf } from "tdsp/scene_discs.js";
import { SceneGestures } from "tdsp/scene_gestures.js";
import { hit, sameTarget } from "tdsp/scene_hit.js";
import { layoutScene } from "tdsp/scene_layout.js";
import { prepareLegs } from "tdsp/scene_legs.js";
import { arrangeScene, drawGround, drawLive } from "tdsp/scene_picture.js";
import { sceneExtent } from "tdsp/scene_projection.js";
import { BLANK, blankScene, sceneSvg } from "tdsp/scene_svg.js";

/** @typedef {import("tdsp/scene_hit.js").Target} Target */
/** @typedef {import("tdsp/scene_picture.js").SceneState} SceneState */
/** @typedef {import("tdsp/palette.js").Palette} Palette */

/**
 * What a view needs to know of a scene: the core's Scene has it all.
 * @typedef {object} SceneLike
 * @property {SceneState["description"] & {units?: {length?: string, time?: string}}} description
 * @property {(time: number, out: Float64Array) => any} radii radii of all discs at a time, the robot's not included
 */

/** @typedef {{legs: import("tdsp/scene_legs.js").LegJson[], departure?: number, arrival?: number|null}} PathLike */

/**
 * @typedef {object} Shown each left out stays as it was; null is nothing
 * @property {SceneLike|null} scene
 * @property {PathLike|null} path the path of the departure that is chosen
 * @property {PathLike|null} ghost of the departure that is pointed at
 * @property {SceneState["jumps"]} jumps whose gaps are marked
 * @property {number} time that the picture is of
 * @property {Target|null} selected
 * @property {Palette} palette
 * @property {{width: number, height: number}|null} corner of the canvas, its top right one, where something else lies: no label goes there
 */

/**
 * @typedef {object} Drag
 * @property {"source"|"destination"|"disc"|"rim"} what
 * @property {number} index of the disc; -1 for an end
 * @property {[number, number]} place where it is dragged to: the end, the disc's centre (of a rim: where the centre stays)
 * @property {number} [radius] rim: the radius at time 0 that has the rim at the pointer now
 */

/**
 * @typedef {object} SceneOptions
 * @property {Palette} [palette]
 * @property {(drag: Drag) => void} [onDrag]
 * @property {(drag: Drag) => void} [onDragEnd] the last one again
 * @property {(target: Target|null) => void} [onSelect]
 */

const CURSORS = { source: "grab", destination: "grab", disc: "move", rim: "nwse-resize" };
const STEP = 1.25;
const LIVE = ["time", "selected", "ghost"];

/** The view of a scene: {@link Shown}, {@link SceneOptions}. */
export class SceneView {
    /** @param {HTMLCanvasElement} canvas sized by CSS @param {SceneOptions} [options] */
    constructor(canvas, options = {}) {
        this.options = options;
        this.canvas = canvas;
        this.state = blankScene(options.palette ?? light);
        this.dirty = { ground: true, live: true, fit: true };
        this.layers = new Layers(canvas, () => this.draw());
        this.measure = this.layers.pen.width.bind(this.layers.pen);
        new SceneGestures(canvas, this.intentions());
    }

    /**
     * Show these; what is left out stays. Draws with the next frame; draw() draws at once.
     * @param {Partial<Shown>} shown
     */
    show(shown) {
        const { state } = this;
        if (shown.scene !== undefined) this.takeScene(shown.scene);
        if (shown.path !== undefined) this.takePath(shown.path);
        if (shown.ghost !== undefined) state.ghost = prepareLegs(shown.ghost?.legs ?? [], state.description.robot.speed);
        if (shown.jumps !== undefined) state.jumps = shown.jumps ?? [];
        if (shown.palette !== undefined) state.palette = shown.palette;
        if (shown.corner !== undefined) state.corner = shown.corner;
        if (shown.time !== undefined) state.time = shown.time;
        if (shown.selected !== undefined) state.selected = shown.selected;
        if (Object.keys(shown).some((key) => !LIVE.includes(key))) this.dirty.ground = true;
        this.change();
    }

    /** @param {SceneLike|null} scene */
    takeScene(scene) {
        const { state } = this, description = scene?.description ?? BLANK;
        this.scene = scene;
        state.description = description;
        state.count = description.discs.length;
        state.centers = centersOf(description.discs);
        if (state.now.length !== state.count) state.now = new Float64Array(state.count);
        state.units = { length: description.units?.length ?? "", time: description.units?.time ?? "" };
        state.later = null;
        if (state.hover && state.hover.index >= state.count) state.hover = null;
        this.radiiTime = NaN;
        this.takePath(this.path ?? null);
    }

    /** @param {PathLike|null} path */
    takePath(path) {
        const { state } = this;
        this.path = path;
        state.legs = prepareLegs(path?.legs ?? [], state.description.robot.speed);
        const arrival = path?.arrival ?? state.legs.at(-1)?.end;
        state.later = this.scene && Number.isFinite(arrival) ? this.radiiAt(arrival, new Float64Array(state.count)) : null;
    }

    /** Radii as they are drawn: a robot that has a radius of its own makes every disc larger by it. */
    radiiAt(time, out) {
        if (this.scene) this.scene.radii(time, out);
        const inflated = this.state.description.robot.radius ?? 0;
        if (inflated > 0) for (let i = 0; i < out.length; i++) out[i] += inflated;
        return out;
    }

    change() {
        this.dirty.live = true;
        this.layers.ask();
    }

    /** Another view of the same. */
    changeView() {
        this.dirty.ground = true;
        this.change();
    }

    /** Draw now, if anything has changed since the last time. */
    draw() {
        if (this.layers.fitSize()) this.dirty.ground = true;
        if (this.layers.width === 0 || !(this.dirty.ground || this.dirty.live)) return;
        if (this.dirty.fit) this.fitNow();
        this.updateRadii();
        if (this.dirty.ground) this.drawKept();
        drawLive(this.layers.copyKept(), this.state);
        this.dirty.ground = this.dirty.live = false;
    }

    updateRadii() {
        const { state } = this;
        if (this.radiiTime !== state.time) this.radiiAt(state.time, state.now);
        this.radiiTime = state.time;
    }

    drawKept() {
        const { state, layers } = this;
        this.arrangement = arrangeScene(state, layers.width, layers.height, this.measure);
        state.layout = layoutScene(state, this.measure);
        this.arrangement = arrangeScene(state, layers.width, layers.height, this.measure);
        drawGround(layers.blankKept(state.palette.paper), state, this.arrangement);
    }

    /** Show the whole journey, and go on doing so until a person moves the view. */
    fit() {
        this.dirty.fit = true;
        this.changeView();
    }

    fitNow() {
        const { state, layers } = this, { description } = state;
        const radii = this.radiiAt(this.path?.departure ?? 0, new Float64Array(state.count));
        const extent = sceneExtent(description, radii, this.path?.legs ?? []);
        // Numbers on the axes decide how much room the window has, and the window which numbers those are.
        for (let i = 0; i < 2; i++) {
            arrangeScene(state, layers.width, layers.height, this.measure);
            state.projection.fit(extent);
        }
    }

    /**
     * Closer by `factor` about the middle, or about a pixel.
     * @param {number} [factor]
     * @param {number} [x]
     * @param {number} [y]
     */
    zoom(factor = STEP, x, y) {
        const { projection } = this.state;
        this.dirty.fit = false;
        projection.zoomAt(x ?? projection.left + projection.width / 2, y ?? projection.top + projection.height / 2, factor);
        this.changeView();
    }

    /** Move what is seen by so many pixels. @param {number} dx @param {number} dy */
    pan(dx, dy) {
        this.dirty.fit = false;
        this.state.projection.pan(dx, dy);
        this.changeView();
    }

    /** What of the plane is seen: its middle and how wide it is, on any screen; null while it fits the journey. */
    get window() {
        const { centerX, centerY, scale, width } = this.state.projection;
        return this.dirty.fit ? null : { x: centerX, y: centerY, width: width / scale };
    }

    set window(window) {
        const { projection } = this.state;
        this.dirty.fit = !window;
        if (window) Object.assign(projection, { centerX: window.x, centerY: window.y, scale: projection.width / window.width });
        this.changeView();
    }

    /** How far one pixel is in the plane: arrow keys move the selected thing by multiples of it. */
    get pixel() {
        return 1 / this.state.projection.scale;
    }

    /** Where a pixel of the canvas is in the plane. @param {number} x @param {number} y @returns {[number, number]} */
    placeAt(x, y) {
        return [this.state.projection.worldX(x), this.state.projection.worldY(y)];
    }

    /**
     * What is seen, as an SVG file.
     * @param {{width?: number, height?: number, title?: string, description?: string, palette?: Palette}} [page]
     */
    toSVG(page = {}) {
        const width = page.width ?? this.layers.width, height = page.height ?? this.layers.height;
        return sceneSvg(this.state, { ...page, width, height }, this.measure);
    }

    /** @returns {import("tdsp/scene_gestures.js").Intentions} */
    intentions() {
        const { state } = this;
        return {
            hit: (x, y, touch) => this.targetAt(x, y, touch),
            isSelected: (target) => state.selected?.index === target.index,
            anchor: (target) => this.anchor(target),
            hover: (target) => this.hover(target),
            select: (target) => this.options.onSelect?.(target?.what === "rim" ? { what: "disc", index: target.index } : target),
            drag: (target, x, y) => this.drag(target, x, y),
            dragEnd: () => this.options.onDragEnd?.(this.dragged),
            pan: (dx, dy) => this.pan(dx, dy),
            zoom: (x, y, factor) => this.zoom(factor, x, y),
            fit: () => this.fit(),
        };
    }

    /** @returns {Target|null} what is under a pixel */
    targetAt(x, y, touch = false) {
        const { projection, description, centers, now, count, selected } = this.state;
        if (!this.scene || !projection.holds(x, y)) return null;
        const { source, destination } = description;
        const ground = { source, destination, centers, radii: now, count, selected: selected?.index ?? -1 };
        return hit(projection, ground, x, y, touch);
    }

    /** @param {Target} target @returns {[number, number]} */
    anchor({ what, index }) {
        const { projection, description, centers } = this.state;
        const [x, y] = index < 0 ? description[what] : [centers.x[index], centers.y[index]];
        return [projection.x(x), projection.y(y)];
    }

    hover(target) {
        this.canvas.style.cursor = target ? CURSORS[target.what] : "";
        if (sameTarget(target, this.state.hover)) return;
        this.state.hover = target;
        this.change();
    }

    drag(target, x, y) {
        const { centers, now, description } = this.state, place = this.placeAt(x, y);
        this.dirty.fit = false; // what is dragged stays under the pointer
        /** @type {Drag} */
        this.dragged = { what: target.what, index: target.index, place };
        if (target.what === "rim") {
            const i = target.index, center = /** @type {[number, number]} */ ([centers.x[i], centers.y[i]]);
            const wanted = Math.hypot(place[0] - center[0], place[1] - center[1]);
            Object.assign(this.dragged, { place: center, radius: Math.max(0, description.discs[i].radius + wanted - now[i]) });
        }
        this.options.onDrag?.(this.dragged);
    }
}
