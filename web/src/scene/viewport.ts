// SPDX-License-Identifier: MIT
// The 3D view: puts stage, shell, gizmo, pointer and overlay together and follows the state.
import { effect, untracked } from "@preact/signals";
import { type Ray, Vector3 } from "three";
import { row } from "../mesh/topology.ts";
import { onChanges } from "../state/connection.ts";
import type { Point } from "../state/design.ts";
import { askedPoint, beginDrag, frameAt } from "../state/dragging.ts";
import { commitSettings, handleOf, previewSettings } from "../state/editing.ts";
import { fetchPart } from "../state/later.ts";
import {
  deselect,
  selectAlso,
  selectOnly,
  selectThese,
  toggleSelected,
  visit,
} from "../state/selection.ts";
import { sensibleVertex } from "../state/sensible-vertex.ts";
import { settled, shortfalls } from "../state/shortfall.ts";
import {
  baseFlat,
  bending,
  boxTool,
  type ColourBy,
  colourBy,
  displayMesh,
  draft,
  handles,
  kindDefects,
  localArrows,
  lock,
  mesh,
  mobility,
  offsetLayer,
  panelFigures,
  panelFolds,
  panelHealth,
  panelTroubles,
  ready,
  selected,
  selectedPanel,
  selection,
  settings,
  showBefore,
  snapDistance,
  snapping,
  visited,
} from "../state/store.ts";
import { beyond, panelsAtLimit } from "../state/wanted.ts";
import type { Subject } from "./clearance.ts";
import { followContext } from "./context-follower.ts";
import { DragSession, type Snap } from "./drag-session.ts";
import type { ViewName } from "./framing.ts";
import { Gizmo } from "./gizmo.ts";
import { neighbourTowards } from "./neighbour.ts";
import { Overlay, type OverlayParts, putAt } from "./overlay.ts";
import { DARK, LIGHT, type Palette } from "./palette.ts";
import { type Box, type Place, pickVertex, project, type View, verticesIn } from "./picking.ts";
import { type Click, type Hold, PointerTool } from "./pointer.ts";
import type { Pull } from "./pull-lines.ts";
import { followKnob } from "./reach-knob.ts";
import { ReachLine } from "./reach-line.ts";
import { Shell } from "./shell.ts";
import { Stage } from "./stage.ts";
import { surfaceHit } from "./surface-hit.ts";

export interface ViewportParts extends OverlayParts {
  readonly canvas: HTMLCanvasElement;
  /** What lies over the lower corners of the view; a fitted model is not under it. */
  readonly legend: HTMLElement;
  readonly views: HTMLElement;
  /** On the line of the reach. */
  readonly knob: HTMLElement;
}

/** Pixels about a selected point that are its own, even where arrows begin. */
const CORE = 9;
/** Milliseconds after which a large mesh gets its shadow. */
const SHADOW_DELAY = 1000;
/** Height of the legend over its width once there is something to count: it grows with an edit. */
const GROWN = 0.65;
/** Pixels within which a snapped drag goes back to the base position. */
const HOME = 10;
/** Pixels: the pointer still means the same place. */
const SAME = 1;

const dark = window.matchMedia("(prefers-color-scheme: dark)");
const palette = (): Palette => (dark.matches ? DARK : LIGHT);

/** What the colours show, where it is not how far points moved. */
function figuresOf(kind: ColourBy): Float32Array | null {
  if (kind === "health") return panelTroubles.value;
  if (kind === "remake") return panelHealth.value;
  if (kind === "fairness") return bending.value;
  if (kind === "fold") return panelFolds.value;
  if (kind === "mobility")
    return mobility.value?.of === mesh.value ? (mobility.value?.ways ?? null) : null;
  if (kindDefects.value?.kind === kind) return kindDefects.value.values;
  return kind === "planarity" ? panelFigures.value : null;
}

/** A window may move to a screen with other pixels. Returns how to stop watching. */
function watchPixelRatio(changed: () => void): () => void {
  const off = new AbortController();
  const watch = (): void => {
    const now = window.matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    const next = (): void => {
      changed();
      watch();
    };
    now.addEventListener("change", next, { once: true, signal: off.signal });
  };
  watch();
  return () => off.abort();
}

export class Viewport {
  readonly stage: Stage;
  readonly #canvas: HTMLCanvasElement;
  readonly #parts: ViewportParts;
  readonly #gizmo: Gizmo;
  readonly #pointer: PointerTool;
  readonly #overlay: Overlay;
  readonly #stop: (() => void)[] = [];
  readonly #reach = new ReachLine();
  #shell: Shell | null = null;
  #offset: { dispose(): void } | null = null;
  /** The panel was chosen here, so that it is in view already. */
  #choosing = false;
  /** Clicks so far: what an earlier one would choose comes too late. */
  #clicks = 0;
  /** The last place on the surface that the wheel or a turn began at. */
  #approached: Vector3 | null = null;

  constructor(parts: ViewportParts) {
    this.#canvas = parts.canvas;
    this.#parts = parts;
    this.#overlay = new Overlay(parts);
    this.stage = new Stage(parts.canvas, {
      before: (pixel) => this.#shell?.inkEdges(pixel),
      after: () => this.#placeOverlay(),
    });
    this.#gizmo = new Gizmo(this.stage);
    this.#pointer = this.#makePointer();
    this.#follow();
  }

  view(name: ViewName): void {
    const subject = this.#subject();
    if (subject) this.stage.view(name, subject, this.#over(), false);
  }

  /** Brings what is selected, or the whole design, into view without turning the camera. */
  fit(all: boolean): void {
    const chosen = all ? null : this.#chosen();
    const subject = chosen ?? this.#subject();
    if (subject) this.stage.fit(subject, this.#over());
  }

  /** Gives up a drag; without one, deselects. */
  escape(): void {
    if (this.#pointer.dragging) this.#pointer.abandon();
    else deselect();
  }

  turn(right: number, down: number): void {
    this.stage.turn(right * 0.12, down * 0.12, this.#leader());
  }

  zoom(factor: number): void {
    this.stage.zoom(factor);
  }

  /** Goes to the nearest point in a direction on screen; `also` keeps what was chosen. */
  stepSelection(right: number, down: number, also: boolean): void {
    const shell = this.#shell;
    if (!shell || !ready.value) return;
    const next =
      selected.value === null
        ? sensibleVertex(shell.base, shell.topology.boundary, [])
        : neighbourTowards(shell, selected.value, right, down, this.#view());
    if (next === null) return;
    if (also) selectAlso([next]);
    else selectOnly(next);
  }

  picture(): Promise<Blob | null> {
    this.stage.draw();
    return new Promise((resolve) => this.#canvas.toBlob(resolve, "image/png"));
  }

  #subject(): Subject | null {
    const shell = this.#shell;
    return shell && { points: shell.current, edges: shell.topology.edges };
  }

  /** The edges at the selected points, or around the selected panel; null if nothing is selected. */
  #chosen(): Subject | null {
    const shell = this.#shell;
    if (!shell) return null;
    const { current, corners, offsets, topology } = shell;
    const panel = selectedPanel.value;
    if (selection.value.length > 0) {
      const ends = selection.value.flatMap((v) => [...row(topology.edgeEnds, v)]);
      const edges = ends.flatMap((end) => [end, end ^ 1]).map((end) => topology.edges[end] ?? 0);
      const points = edges.flatMap((v) => [...current.subarray(3 * v, 3 * v + 3)]);
      return { points: Float32Array.from(points), edges: Int32Array.from(edges.keys()) };
    }
    if (panel === null) return null;
    const points = corners.slice(3 * (offsets[panel] ?? 0), 3 * (offsets[panel + 1] ?? 0));
    const ends = Array.from({ length: points.length / 3 - 1 }, (_, k) => [k, k + 1]);
    return { points, edges: Int32Array.from(ends.flat()) };
  }

  /** Where the point chosen last is; null if it is out of view. */
  #leader(): Vector3 | null {
    const [shell, vertex] = [this.#shell, selected.value];
    if (!shell || vertex === null) return null;
    const view = this.#view();
    const at = project(shell.current, vertex, view);
    if (!at || at.x < 0 || at.y < 0 || at.x > view.width || at.y > view.height) return null;
    return new Vector3().fromArray(shell.current, 3 * vertex);
  }

  #rayThrough({ x, y }: Place): Ray {
    const { width, height } = this.#view();
    return this.stage.rayThrough((2 * x) / width - 1, 1 - (2 * y) / height);
  }

  /** What lies under a pixel; zooming to it keeps it there, so that one search does for a ride. */
  #surfaceAt(place: Place): Vector3 | null {
    const view = this.#view();
    const found = this.#approached;
    const seen = found && project(Float32Array.from(found.toArray()), 0, view);
    if (!seen || Math.hypot(seen.x - place.x, seen.y - place.y) > SAME) {
      const hit = this.#shell && surfaceHit(this.#shell, this.#rayThrough(place));
      this.#approached = hit?.at ?? null;
    }
    return this.#approached;
  }

  /** Where the legend and the buttons of the views lie, or will once there is an edit. */
  #over(): Box[] {
    const { left, top } = this.#canvas.getBoundingClientRect();
    return [this.#parts.legend, this.#parts.views].map((part, k) => {
      const box = part.getBoundingClientRect();
      const grows = k === 0 && colourBy.peek() !== "none";
      const high = Math.max(box.height, grows ? GROWN * box.width : 0);
      const [right, bottom] = [box.right - left, box.bottom - top];
      return { left: box.left - left, right, top: bottom - high, bottom };
    });
  }

  #view(): View {
    const { width, height } = this.#canvas.getBoundingClientRect();
    return { camera: this.stage.camera, width, height };
  }

  dispose(): void {
    for (const stop of this.#stop) stop();
    this.#reach.dispose();
    this.#pointer.dispose();
    this.#gizmo.dispose();
    this.#shell?.dispose();
    this.#shell = null; // its shadow may still be to come
    this.stage.dispose();
  }

  #makePointer(): PointerTool {
    return new PointerTool(this.#canvas, this.stage, {
      find: (x, y, coarse) => this.#find(x, y, coarse),
      boxing: () => boxTool.value,
      hover: (hold) => this.#hover(hold),
      click: (x, y, hold, press) => this.#click(x, y, hold, press),
      double: (x, y, how) => void this.#chooseLine({ x, y }, how),
      grab: (hold, press) => this.#grab(hold, press),
      turn: (x, y) => this.stage.turnAbout(this.#leader() ?? this.#surfaceAt({ x, y })),
      zoom: (x, y) => {
        const at = this.#surfaceAt({ x, y });
        if (at) this.stage.aim(at);
      },
      drag: (session, { snap, free, through }, ray) =>
        session.move({ lock: lock.value, snap: this.#snap(snap), free, through }, ray),
      box: (box) => this.#overlay.drawBox(box),
      choose: (box, also) => this.#choose(box, also),
    });
  }

  #find(x: number, y: number, coarse: boolean): Hold | null {
    const shell = this.#shell;
    if (!shell || !ready.value) return null;
    const view = this.#view();
    const leader = selected.value;
    const marked = (vertex: number): boolean => {
      const at = project(shell.current, vertex, view);
      return at !== null && Math.hypot(at.x - x, at.y - y) < CORE;
    };
    const own = selection.value.findLast(marked);
    if (own !== undefined) return { vertex: own, arrow: null };
    const arrow = this.#gizmo.hover(x, y, view.width, view.height);
    if (leader !== null && arrow) return { vertex: leader, arrow };
    const vertex = pickVertex(shell.current, shell.topology, x, y, coarse, view);
    return vertex === null ? null : { vertex, arrow: null };
  }

  #hover(hold: Hold | null): void {
    this.#canvas.style.cursor = hold ? "grab" : boxTool.value ? "crosshair" : "";
    const vertex = hold && !hold.arrow ? hold.vertex : null;
    if (vertex === visited.value) return;
    visit(vertex);
    this.#placeOverlay();
  }

  #click(x: number, y: number, hold: Hold | null, { also, coarse }: Click): void {
    this.#clicks += 1;
    if (hold?.arrow) return;
    if (hold && also) toggleSelected(hold.vertex);
    else if (hold) selectOnly(hold.vertex);
    else if (!also) void this.#choosePanel(x, y, coarse);
  }

  /** The panel that a click means becomes the selected one; beside the model nothing is selected. */
  async #choosePanel(x: number, y: number, coarse: boolean): Promise<void> {
    deselect();
    const [shell, click] = [this.#shell, this.#clicks];
    const part = await fetchPart(() => import("./panel-picking.ts"));
    if (!shell || !part || shell !== this.#shell || click !== this.#clicks) return;
    const rayThrough = (at: Place): Ray => this.#rayThrough(at);
    this.#choosing = true;
    selectedPanel.value = part.pickPanel(shell, { x, y }, coarse, this.#view(), rayThrough);
    this.#choosing = false;
  }

  /** The line of the mesh, or the strip, that a double click on an edge means. */
  async #chooseLine(place: Place, { also, ring }: { also: boolean; ring: boolean }): Promise<void> {
    const shell = this.#shell;
    if (!shell || !ready.value) return;
    this.#clicks += 1;
    const part = await fetchPart(() => import("./line-picking.ts"));
    const line = shell === this.#shell ? part?.pickLine(shell, place, ring, this.#view()) : null;
    if (!line) return;
    if (also) selectAlso(line);
    else selectThese(line);
    selectedPanel.value = null;
  }

  #choose(box: Box, also: boolean): void {
    if (!this.#shell || !ready.value) return;
    const inside = verticesIn(box, this.#shell.current, this.#view());
    if (also) selectAlso(inside);
    else selectThese(inside);
    boxTool.value = false;
  }

  #grab({ vertex, arrow }: Hold, press: Ray): DragSession | null {
    const shell = this.#shell;
    if (!selection.value.includes(vertex)) selectOnly(vertex);
    const frame = frameAt(vertex);
    const drag = beginDrag([...selection.value.filter((v) => v !== vertex), vertex]);
    if (!shell || !frame || !drag) return null;
    return new DragSession(drag, {
      start: new Vector3(...this.#toDisplay(askedPoint(vertex))),
      base: new Vector3().fromArray(shell.base, 3 * vertex),
      press,
      view: this.stage.camera.getWorldDirection(new Vector3()),
      frame,
      scale: mesh.value?.report.scale ?? 1,
      arrow,
    });
  }

  /** `inverted`: Ctrl turns snapping on, or off where it is on. */
  #snap(inverted: boolean): Snap | null {
    if (snapping.value === inverted) return null;
    return { step: snapDistance.value, reach: HOME * this.stage.pixel() };
  }

  #toDisplay(target: Point): Point {
    const { centre, scale } = mesh.value?.report ?? { centre: [0, 0, 0] as const, scale: 1 };
    const at = (axis: 0 | 1 | 2): number => (target[axis] - centre[axis]) * scale;
    return [at(0), at(1), at(2)];
  }

  /** To where the handles were asked to go; those that stop on the way leave their target open. */
  #pulls(): Pull[] {
    const held = beyond.value;
    const short = new Set(shortfalls.value.flatMap((s) => (s.noticeable ? [s.vertex] : [])));
    const asked = (held?.handles ?? handles.value).filter(({ pinned }) => !pinned);
    return asked.map(({ vertex, target }) => {
      const open = held !== null || (settled.value && short.has(vertex));
      return { vertex, to: this.#toDisplay(target), open };
    });
  }

  #follow(): void {
    const recolour = (): void => {
      this.stage.setPalette(palette());
      this.#shell?.setPalette(palette());
      this.#reach.setColour(palette().ghost);
    };
    dark.addEventListener("change", recolour);
    const observer = new ResizeObserver(() => this.#resize());
    observer.observe(this.#canvas);
    this.#stop.push(
      () => dark.removeEventListener("change", recolour),
      () => observer.disconnect(),
      watchPixelRatio(() => this.#resize()),
      onChanges((changes) => this.#apply(changes)),
      effect(() => this.#build()),
      effect(() => {
        const kind = colourBy.value;
        displayMesh.value;
        this.#shell?.colourBy(kind, figuresOf(kind));
        void this.#dress(kind === "zebra");
        this.stage.invalidate();
      }),
      effect(() => void this.#layOffset()),
      effect(() => this.#drawReach()),
      followContext(this.stage, dark),
      followKnob(this.#parts.knob, this.#canvas, {
        move: (place) => this.#dragReach(place),
        end: () => void commitSettings({ reach: settings.value?.reach ?? 0, reachLength: 0 }),
      }),
      effect(() => this.#outline(selectedPanel.value)),
      effect(() => {
        this.#shell?.markLimits(panelsAtLimit.value);
        this.stage.invalidate();
      }),
      effect(() => {
        this.#shell?.showBase(showBefore.value);
        this.#overlay.showPulls(!showBefore.value);
        this.stage.moved();
      }),
      effect(() => {
        this.#overlay.update();
        this.#updateGizmo();
        this.#overlay.setPulls(this.#pulls());
        this.stage.invalidate();
      }),
      effect(() => {
        this.#gizmo.show(lock.value);
        untracked(() => this.#pointer.refresh());
        this.stage.invalidate();
      }),
    );
    recolour();
  }

  /** The design's second layer, which nothing picks or drags. */
  async #layOffset(): Promise<void> {
    const [shell, layer] = [this.#shell, offsetLayer.value];
    if (!shell || (!layer && !this.#offset)) return;
    const part = await fetchPart(() => import("./offset-layer.ts"));
    if (shell !== this.#shell || layer !== offsetLayer.peek()) return;
    this.#offset?.dispose();
    this.#offset = (layer && part?.layOffset(shell, layer, palette())) ?? null;
    this.stage.invalidate();
  }

  async #dress(striped: boolean): Promise<void> {
    const shell = this.#shell;
    const part = striped ? await fetchPart(() => import("./zebra.ts")) : null;
    if (shell !== this.#shell || striped !== (colourBy.peek() === "zebra")) return;
    shell?.wear(part && new part.Zebra());
    this.stage.invalidate();
  }

  /** Around what is pulled, or about to be. */
  #drawReach(): void {
    const [shell, limits, opened] = [this.#shell, settings.value, mesh.value];
    if (!shell || !limits || !opened || displayMesh.value !== opened) return;
    const pulled = handles.value.flatMap(({ vertex, pinned }) => (pinned ? [] : [vertex]));
    const next = selected.value === null || !baseFlat.value ? [] : [selected.value];
    const length = limits.reachLength * opened.report.scale;
    const seeds = pulled.length > 0 ? pulled : next;
    this.#reach.draw(shell, seeds, { rings: limits.reach, length });
    this.stage.invalidate();
  }

  #dragReach(place: Place): void {
    const shell = this.#shell;
    if (!shell) return;
    const reach = this.#reach.ringsAt(shell, place, this.#view());
    if (reach !== settings.peek()?.reach) previewSettings({ reach, reachLength: 0 });
  }

  #outline(panel: number | null): void {
    const corners = this.#shell?.outlinePanel(panel) ?? null;
    this.#overlay.setPanel(corners);
    if (corners && !this.#choosing) this.stage.lookAt(corners, this.#shell?.outward ?? 0);
    this.stage.invalidate();
  }

  #build(): void {
    const shown = displayMesh.value;
    if (!shown) return;
    const kept = this.#shell?.showsMuchTheSame(shown) ?? false;
    this.#shell?.dispose();
    this.#shell = new Shell(shown, palette());
    this.#shell.group.add(this.#reach.object);
    this.#reach.forget();
    untracked(() => this.#drawReach());
    this.#overlay.setPanel(null);
    this.#resize();
    this.stage.setSubject(this.#shell.group, this.#shell.bounds());
    const subject = { points: shown.display, edges: shown.topology.edges };
    if (!kept) this.stage.view("Perspective", subject, this.#over(), true);
    if (this.#shell.shadowToCome) this.#castLater(this.#shell);
  }

  #castLater(shell: Shell): void {
    setTimeout(() => {
      if (shell !== this.#shell) return;
      shell.castShadow();
      this.stage.castShadows();
    }, SHADOW_DELAY);
  }

  #apply(changes: Float32Array): void {
    this.#shell?.apply(changes);
    const panel = selectedPanel.peek();
    if (panel !== null) this.#overlay.setPanel(this.#shell?.outlinePanel(panel) ?? null);
    this.#updateGizmo();
    this.stage.moved();
  }

  #resize(): void {
    const { width, height } = this.#canvas.getBoundingClientRect();
    this.stage.resize(width, height);
    this.#shell?.setSize(width, height);
    this.#reach.setSize(width, height);
    this.#gizmo.resize(height);
  }

  #updateGizmo(): void {
    const [vertex, shell] = [selected.value, this.#shell];
    if (vertex === null || !shell || !ready.value || !draft.value || handleOf(vertex)?.pinned) {
      this.#gizmo.detach();
      return;
    }
    const turned = localArrows.value || lock.value?.axis === "normal";
    const [x = 0, y = 0, z = 0] = shell.current.subarray(3 * vertex, 3 * vertex + 3);
    this.#gizmo.attach(x, y, z, turned ? frameAt(vertex) : null);
  }

  #placeOverlay(): void {
    if (!this.#shell) return;
    const view = this.#view();
    this.#overlay.place(this.#shell.current, this.#shell.base, view);
    putAt(this.#parts.knob, this.#reach.knob(this.#shell, view));
  }
}
