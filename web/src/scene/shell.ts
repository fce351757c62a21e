// SPDX-License-Identifier: MIT
// The structure on screen: panels, their edges, and a ghost of where it was.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  Group,
  type Material,
  Mesh,
} from "three";
import type { DisplayMesh, Polygons } from "../mesh/display-mesh.ts";
import { hasSamePoints, isSameStructure } from "../mesh/likeness.ts";
import { OldSurface } from "../mesh/old-surface.ts";
import { row, type Topology } from "../mesh/topology.ts";
import { panelAt } from "../mesh/triangulation.ts";
import type { ColourBy } from "../state/page-state.ts";
import { motionEnd } from "../state/ramp-ends.ts";
import { DirtyRange } from "./dirty-range.ts";
import { displaySphere } from "./framing.ts";
import type { Palette } from "./palette.ts";
import { PanelColours } from "./panel-colours.ts";
import { PanelCuts } from "./panel-cuts.ts";
import { ShellLines } from "./shell-lines.ts";
import { mattMaterial, type Skin } from "./skin.ts";

/** Triangles above which a mesh is shown before its shadow, which takes as long again. */
const LATE_SHADOW = 400_000;
/** More outlines than this would hide the model. */
const MARKED = 400;
/** Below this share of the largest displacement the ghost would only double the edges. */
const GHOST_SHARE = 0.08;

/** Edges under a skin: it says more than they do. */
const FAINT = 0.35;

export class Shell {
  readonly group = new Group();
  readonly topology: Topology;
  readonly base: Float32Array;
  /** Display coordinates of the design shown. */
  readonly current: Float32Array;
  readonly corners: Float32Array;
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
  readonly #moved = new Set<number>();
  readonly panels: Mesh<BufferGeometry, Material>;
  readonly #matt = mattMaterial();
  #skin: Skin | null = null;
  readonly #colours: PanelColours;
  readonly #oldSurface: OldSurface;
  #kind: ColourBy = "displacement";
  readonly #cuts: PanelCuts;
  readonly #lines: ShellLines;
  readonly #dirtyCorners = new DirtyRange();
  /** Largest displacement shown, display coordinates. */
  #largest = 0;
  #outlined: number | null = null;
  #atLimit: readonly number[] = [];
  /** Display units: the displacement at the ramp's end is at least this. */
  #scale = 0;

  constructor(mesh: DisplayMesh, palette: Palette) {
    this.base = mesh.display;
    this.current = mesh.display.slice();
    this.topology = mesh.topology;
    this.offsets = mesh.offsets;
    this.vertices = mesh.vertices;
    this.corners = mesh.corners.slice();
    this.#cuts = new PanelCuts(mesh);
    this.#colours = new PanelColours(mesh);
    this.#oldSurface = new OldSurface(this.base, mesh);
    this.panels = this.#makePanels();
    this.#lines = new ShellLines(mesh.topology, this.base);
    this.group.add(this.panels, this.#lines.group);
    this.setPalette(palette);
  }

  get triangles(): Uint32Array {
    return this.#cuts.triangles;
  }

  /** The topology with those edges alone that are in the picture. */
  get drawn(): Topology {
    return this.#lines.topology;
  }

  showsMuchTheSame(mesh: Polygons): boolean {
    const { current: display, offsets, vertices } = this;
    return (
      isSameStructure({ display, offsets, vertices }, mesh) ||
      hasSamePoints(this.base, mesh.display)
    );
  }

  #makePanels(): Mesh<BufferGeometry, Material> {
    const geometry = new BufferGeometry();
    const corners = new BufferAttribute(this.corners, 3).setUsage(DynamicDrawUsage);
    geometry.setAttribute("position", corners);
    geometry.setAttribute("color", this.#colours.attribute);
    geometry.setIndex(new BufferAttribute(this.triangles, 1).setUsage(DynamicDrawUsage));
    geometry.boundingSphere = displaySphere();
    const panels = new Mesh<BufferGeometry, Material>(geometry, this.#matt);
    panels.castShadow = this.triangles.length / 3 < LATE_SHADOW;
    panels.receiveShadow = true;
    panels.frustumCulled = false;
    return panels;
  }

  /** The space that the design shown takes up. */
  bounds(): Box3 {
    return new Box3().setFromArray(this.current);
  }

  setPalette(palette: Palette): void {
    this.#colours.setPalette(palette);
    this.#lines.setPalette(palette);
    this.#colourAll();
  }

  /** `changes` holds vertex, x, y, z in display coordinates. */
  apply(changes: Float32Array): void {
    for (let k = 0; k + 3 < changes.length; k += 4) {
      const v = changes[k] ?? 0;
      this.current.set(changes.subarray(k + 1, k + 4), 3 * v);
      if (this.#displacement(v) > 0) this.#moved.add(v);
      else this.#moved.delete(v);
      this.#place(v, this.current);
      this.#colours.paintVertex(v, 0);
    }
    this.#cuts.cutAt(
      changes.filter((_, k) => k % 4 === 0),
      this.corners,
    );
    this.#colourMoved();
    this.#uploadPositions();
    this.#drawGhost();
    if (this.#outlined !== null) this.outlinePanel(this.#outlined);
    if (this.#atLimit.length > 0) this.markLimits(this.#atLimit);
  }

  /** Gives several structures one scale of displacement, display units. */
  scaleTo(largest: number): void {
    this.#scale = largest;
    this.#colourAll();
  }

  /** The largest displacement shown, display units. */
  get largest(): number {
    return this.#largest;
  }

  colourBy(kind: ColourBy, figures: Float32Array | null): void {
    this.#kind = kind;
    this.#colours.choose(kind, figures);
    this.#colourAll();
  }

  /** null: the panels' own colours. */
  wear(skin: Skin | null): void {
    if (!skin && !this.#skin) return;
    this.#skin?.dispose();
    this.#skin = skin;
    this.panels.material = skin?.material ?? this.#matt;
    skin?.update(this.panels.geometry, this.offsets, this.topology);
  }

  /** Draws a line around one panel and gives its corners; null for none. */
  outlinePanel(panel: number | null): Float32Array | null {
    this.#outlined = panel;
    const corners = panel === null ? null : this.cornersOf(panel);
    this.#lines.outline.draw(corners ? [corners] : []);
    return corners;
  }

  /** Draws a line around panels that let an edit go no further. */
  markLimits(panels: readonly number[]): void {
    if (panels.length === 0 && this.#atLimit.length === 0) return;
    this.#atLimit = panels;
    const shown = panels.filter((panel) => !this.#cuts.hidden.has(panel)).slice(0, MARKED);
    this.#lines.limits.draw(shown.flatMap((panel) => this.cornersOf(panel) ?? []));
  }

  /** Leaves panels out of the picture, and the edges that are theirs alone: `shown` has the others. */
  hide(panels: ReadonlySet<number>, shown: Topology): void {
    if (panels.size === 0 && this.#cuts.hidden.size === 0) return;
    this.#cuts.hide(panels, this.corners);
    this.#lines.draw(shown, this.current);
    this.#uploadPositions();
    this.#drawGhost();
    this.markLimits(this.#atLimit);
  }

  /** Whether some panel at a point is in the picture. */
  readonly isShown = (vertex: number): boolean => {
    const { hidden } = this.#cuts;
    if (hidden.size === 0) return true;
    return row(this.topology.corners, vertex).some((c) => !hidden.has(panelAt(this.offsets, c)));
  };

  cornersOf(panel: number): Float32Array | null {
    const [begin, end] = [this.offsets[panel] ?? 0, this.offsets[panel + 1] ?? 0];
    return end > begin ? this.corners.slice(3 * begin, 3 * end) : null;
  }

  /** `alone`: what is drawn has nothing of the other beside it. */
  showBase(on: boolean, alone: boolean): void {
    for (const v of this.#moved) this.#place(v, on ? this.base : this.current);
    this.#lines.ghost.object.visible = !on && !alone;
    this.#uploadPositions();
  }

  setSize(width: number, height: number): void {
    this.#lines.setSize(width, height);
  }

  /** `pixel`: what one spans, display units. */
  inkEdges(pixel: number): void {
    this.#lines.ink(pixel, this.#skin ? FAINT : 1);
  }

  /** True if it casts none yet. */
  get shadowToCome(): boolean {
    return !this.panels.castShadow;
  }

  castShadow(): void {
    this.panels.castShadow = true;
  }

  dispose(): void {
    this.panels.geometry.dispose();
    this.#matt.dispose();
    this.#skin?.dispose();
    this.#lines.dispose();
  }

  #place(v: number, from: Float32Array): void {
    const [x, y, z] = [from[3 * v] ?? 0, from[3 * v + 1] ?? 0, from[3 * v + 2] ?? 0];
    for (const corner of row(this.topology.corners, v)) {
      this.corners[3 * corner] = x;
      this.corners[3 * corner + 1] = y;
      this.corners[3 * corner + 2] = z;
      this.#dirtyCorners.add(corner);
    }
    this.#lines.move(v, x, y, z);
  }

  #uploadPositions(): void {
    const { attributes, index } = this.panels.geometry;
    const { position } = attributes;
    if (position instanceof BufferAttribute) this.#dirtyCorners.flush(position, 3);
    if (index) this.#cuts.flush(index);
    this.#skin?.update(this.panels.geometry, this.offsets, this.topology);
    this.#lines.upload();
  }

  #displacement(v: number): number {
    const at = (axis: number) => (this.current[3 * v + axis] ?? 0) - (this.base[3 * v + axis] ?? 0);
    return Math.hypot(at(0), at(1), at(2));
  }

  #colourMoved(): void {
    this.#largest = this.#scale;
    for (const v of this.#moved) this.#largest = Math.max(this.#largest, this.#displacement(v));
    if (this.#kind === "shape" || this.#kind === "slide") this.#colourMotion(this.#kind);
    else
      for (const v of this.#moved)
        this.#colours.paintVertex(v, this.#displacement(v) / this.#largest);
    this.#colours.upload();
  }

  #colourMotion(kind: "shape" | "slide"): void {
    const { current } = this;
    const figures = Array.from(this.#moved, (v) => {
      const [x = 0, y = 0, z = 0] = current.subarray(3 * v, 3 * v + 3);
      return [v, this.#oldSurface.motion(v, [x, y, z])[kind]] as const;
    });
    const end = motionEnd(
      figures.map(([, figure]) => figure),
      this.#largest,
    );
    for (const [v, figure] of figures) this.#colours.paintVertex(v, figure / end);
  }

  #colourAll(): void {
    this.#colours.paintAll();
    this.#colourMoved();
  }

  /** Edges of the base at vertices that moved visibly. */
  #drawGhost(): void {
    const least = GHOST_SHARE * this.#largest;
    this.#lines.drawGhost([...this.#moved].filter((v) => this.#displacement(v) >= least));
  }
}
