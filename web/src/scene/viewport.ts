// SPDX-License-Identifier: MIT
// The 3D view: puts stage, shell, gizmo and markers together and follows the state.
import { effect } from "@preact/signals";
import type { Vector3 } from "three";
import { onChanges } from "../state/connection.ts";
import type { Point } from "../state/design.ts";
import { abandonDrag, basePoint, dragHandle, endDrag, handleOf } from "../state/editing.ts";
import { sensibleVertex } from "../state/sensible-vertex.ts";
import {
  colourBy,
  displayMesh,
  draft,
  handles,
  hintVertex,
  mesh,
  panelFigures,
  ready,
  selected,
  selectedPanel,
  showBefore,
} from "../state/store.ts";
import { Gizmo } from "./gizmo.ts";
import { type Marker, Markers } from "./markers.ts";
import { neighbourTowards } from "./neighbour.ts";
import { DARK, LIGHT, type Palette } from "./palette.ts";
import { project, type View } from "./picking.ts";
import { PointerTool } from "./pointer.ts";
import { Shell } from "./shell.ts";
import { Stage, type ViewName } from "./stage.ts";

export interface ViewportParts {
  readonly canvas: HTMLCanvasElement;
  readonly markers: HTMLElement;
  /** The first visit's sentence; placed beside its point. */
  readonly hint: HTMLElement;
}

const dark = window.matchMedia("(prefers-color-scheme: dark)");
const palette = (): Palette => (dark.matches ? DARK : LIGHT);

export class Viewport {
  readonly stage: Stage;
  readonly #parts: ViewportParts;
  readonly #gizmo: Gizmo;
  readonly #pointer: PointerTool;
  readonly #markers: Markers;
  readonly #stop: (() => void)[] = [];
  #shell: Shell | null = null;
  #hovered: number | null = null;
  #gizmoVertex: number | null = null;

  constructor(parts: ViewportParts) {
    this.#parts = parts;
    this.stage = new Stage(parts.canvas, () => this.#placeOverlay());
    this.#markers = new Markers(parts.markers);
    this.#gizmo = new Gizmo(this.stage, parts.canvas, {
      start: () => {
        this.#gizmoVertex = selected.value;
      },
      move: (place) => {
        if (this.#gizmo.dragging && this.#gizmoVertex !== null)
          this.#drag(this.#gizmoVertex, place);
      },
      end: () => void endDrag(),
    });
    this.#pointer = this.#makePointer();
    this.#follow();
  }

  view(name: ViewName): void {
    if (this.#shell) this.stage.view(name, this.#shell.current);
  }

  /** Gives up a drag; without one, deselects. */
  escape(): void {
    if (this.#pointer.dragging) this.#pointer.abandon();
    else selected.value = null;
  }

  turn(right: number, down: number): void {
    this.stage.turn(right * 0.12, down * 0.12);
  }

  zoom(factor: number): void {
    this.stage.zoom(factor);
  }

  /** Selects the nearest point in a direction on screen; starts in the middle. */
  stepSelection(right: number, down: number): void {
    const shell = this.#shell;
    if (!shell || !ready.value) return;
    selected.value =
      selected.value === null
        ? sensibleVertex(shell.base, shell.topology.boundary, [])
        : neighbourTowards(shell, selected.value, right, down, this.#view());
  }

  picture(): Promise<Blob | null> {
    this.stage.draw();
    return new Promise((resolve) => this.#parts.canvas.toBlob(resolve, "image/png"));
  }

  #view(): View {
    const { width, height } = this.#parts.canvas.getBoundingClientRect();
    return { camera: this.stage.camera, width, height };
  }

  dispose(): void {
    for (const stop of this.#stop) stop();
    this.#pointer.dispose();
    this.#gizmo.dispose();
    this.#shell?.dispose();
    this.stage.dispose();
  }

  #makePointer(): PointerTool {
    return new PointerTool(this.#parts.canvas, this.stage, this.#gizmo, {
      points: () => (ready.value ? (this.#shell?.current ?? null) : null),
      hover: (vertex) => {
        if (vertex === this.#hovered) return;
        this.#hovered = vertex;
        this.#parts.canvas.style.cursor = vertex === null ? "" : "grab";
        this.#updateMarkers();
        this.#placeOverlay();
      },
      select: (vertex) => {
        selected.value = vertex;
      },
      drag: (vertex, place) => {
        selected.value = vertex;
        this.#drag(vertex, place);
      },
      release: () => void endDrag(),
      abandon: () => void abandonDrag(),
    });
  }

  #drag(vertex: number, place: Vector3): void {
    if (ready.value && mesh.value?.report.flat) dragHandle(vertex, this.#toModel(vertex, place));
  }

  /** Relative to the base point, so that a point dragged along one axis keeps the others' bits. */
  #toModel(vertex: number, place: Vector3): Point {
    const base = basePoint(vertex);
    const scale = mesh.value?.report.scale ?? 1;
    const from = this.#shell?.base ?? new Float32Array(0);
    const shift = (axis: 0 | 1 | 2): number => {
      const moved = place.getComponent(axis) - (from[3 * vertex + axis] ?? 0);
      return Math.abs(moved) < 1e-6 ? base[axis] : base[axis] + moved / scale;
    };
    return [shift(0), shift(1), shift(2)];
  }

  #toDisplay(target: Point): Point {
    const { centre, scale } = mesh.value?.report ?? { centre: [0, 0, 0] as const, scale: 1 };
    const at = (axis: 0 | 1 | 2): number => (target[axis] - centre[axis]) * scale;
    return [at(0), at(1), at(2)];
  }

  #follow(): void {
    const recolour = (): void => {
      this.stage.setPalette(palette());
      this.#shell?.setPalette(palette());
    };
    dark.addEventListener("change", recolour);
    const observer = new ResizeObserver(() => this.#resize());
    observer.observe(this.#parts.canvas);
    this.#stop.push(
      () => dark.removeEventListener("change", recolour),
      () => observer.disconnect(),
      onChanges((changes) => this.#apply(changes)),
      effect(() => this.#build()),
      effect(() => {
        const panels = colourBy.value === "planarity" ? panelFigures.value : null;
        this.#shell?.colourBy(colourBy.value, panels);
        this.stage.invalidate();
      }),
      effect(() => {
        const corners = this.#shell?.outlinePanel(selectedPanel.value);
        if (corners) this.stage.lookAt(corners);
        this.stage.invalidate();
      }),
      effect(() => {
        this.#shell?.showBase(showBefore.value);
        this.stage.moved();
      }),
      effect(() => {
        this.#updateMarkers();
        this.#updateGizmo();
        this.stage.invalidate();
      }),
    );
    recolour();
  }

  #build(): void {
    const shown = displayMesh.value;
    if (!shown) return;
    const first = this.#shell === null;
    const same = this.#shell?.base.length === shown.display.length;
    this.#shell?.dispose();
    this.#shell = new Shell(shown, palette());
    this.stage.setSubject(this.#shell.group, this.#shell.bounds());
    this.#resize();
    if (first || !same) this.view("3D");
  }

  #apply(changes: Float32Array): void {
    this.#shell?.apply(changes);
    this.#updateGizmo();
    this.stage.moved();
  }

  #resize(): void {
    const { width, height } = this.#parts.canvas.getBoundingClientRect();
    this.stage.resize(width, height);
    this.#shell?.setSize(width, height);
  }

  #updateMarkers(): void {
    const markers: Marker[] = handles.value.map(({ vertex, pinned }) => ({
      vertex,
      kind: pinned ? "pin" : "handle",
      selected: vertex === selected.value,
    }));
    const known = (vertex: number) => markers.some((marker) => marker.vertex === vertex);
    if (selected.value !== null && !known(selected.value)) {
      markers.push({ vertex: selected.value, kind: "hover", selected: true });
    }
    if (this.#hovered !== null && !known(this.#hovered)) {
      markers.push({ vertex: this.#hovered, kind: "hover", selected: false });
    }
    if (hintVertex.value !== null) {
      markers.push({ vertex: hintVertex.value, kind: "first", selected: false });
    }
    this.#markers.set(markers);
  }

  #updateGizmo(): void {
    const vertex = selected.value;
    const row = vertex === null ? undefined : handleOf(vertex);
    if (vertex === null || !ready.value || !draft.value || row?.pinned) {
      this.#gizmo.detach();
      return;
    }
    if (row) this.#gizmo.attach(...this.#toDisplay(row.target));
    else {
      const points = this.#shell?.current;
      this.#gizmo.attach(
        points?.[3 * vertex] ?? 0,
        points?.[3 * vertex + 1] ?? 0,
        points?.[3 * vertex + 2] ?? 0,
      );
    }
  }

  #placeOverlay(): void {
    if (!this.#shell) return;
    const view = this.#view();
    this.#markers.place(this.#shell.current, view);
    const { hint } = this.#parts;
    const at =
      hintVertex.value === null ? null : project(this.#shell.current, hintVertex.value, view);
    hint.hidden = at === null;
    if (at) hint.style.transform = `translate(${at.x.toFixed(0)}px, ${at.y.toFixed(0)}px)`;
  }
}
