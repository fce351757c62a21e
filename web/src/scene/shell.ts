// SPDX-License-Identifier: MIT
// The structure on screen: panels, their edges, and a ghost of where it was.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  type Material,
  Mesh,
  MeshStandardMaterial,
} from "three";
import type { DisplayMesh, Polygons } from "../mesh/display-mesh.ts";
import { isSameStructure } from "../mesh/likeness.ts";
import { row, type Topology } from "../mesh/topology.ts";
import { firstTriangle, panelAt, triangulatePanel } from "../mesh/triangulation.ts";
import type { ColourBy } from "../state/store.ts";
import { DirtyRange } from "./dirty-range.ts";
import { type EdgeLines, edgeInk, makeEdgeLines, meanEdge } from "./edge-lines.ts";
import { outwards } from "./facing.ts";
import { displaySphere } from "./framing.ts";
import { Ghost } from "./ghost.ts";
import type { Palette } from "./palette.ts";
import { PanelColours } from "./panel-colours.ts";
import { PanelOutline } from "./panel-outline.ts";

/** Triangles above which a mesh is shown before its shadow, which takes as long again. */
const LATE_SHADOW = 400_000;
/** More outlines than this would hide the model. */
const MARKED = 400;
/** Below this share of the largest displacement the ghost would only double the edges. */
const GHOST_SHARE = 0.08;

const mattMaterial = (): MeshStandardMaterial =>
  new MeshStandardMaterial({
    vertexColors: true,
    flatShading: true,
    side: DoubleSide,
    roughness: 0.85,
    metalness: 0,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });

/** Another look of the panels than their colours. */
export interface Skin {
  readonly material: Material;
  /** After points moved. */
  update(geometry: BufferGeometry, offsets: Int32Array, topology: Topology): void;
  dispose(): void;
}

/** Edges under a skin: it says more than they do. */
const FAINT = 0.35;

export class Shell {
  readonly group = new Group();
  readonly topology: Topology;
  readonly base: Float32Array;
  /** Display coordinates of the design shown. */
  readonly current: Float32Array;
  readonly corners: Float32Array;
  readonly triangles: Uint32Array;
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
  readonly #moved = new Set<number>();
  readonly #panels: Mesh<BufferGeometry, Material>;
  readonly #matt = mattMaterial();
  #skin: Skin | null = null;
  readonly #colours: PanelColours;
  readonly #edges: EdgeLines;
  /** Display units. */
  readonly #meanEdge: number;
  readonly #outline = new PanelOutline();
  readonly #limits = new PanelOutline();
  readonly #ghost: Ghost;
  readonly #dirtyCorners = new DirtyRange();
  readonly #dirtyTriangles = new DirtyRange();
  /** See outward. */
  #outward: number | null = null;
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
    this.triangles = mesh.triangles.slice();
    this.#colours = new PanelColours(mesh);
    this.#panels = this.#makePanels();
    this.#edges = makeEdgeLines(mesh.topology, mesh.display, 1.1);
    this.#meanEdge = meanEdge(mesh.topology, mesh.display);
    this.#ghost = new Ghost(this.base);
    const lines = [this.#edges, this.#ghost, this.#limits, this.#outline];
    this.group.add(this.#panels, ...lines.map(({ object }) => object));
    this.setPalette(palette);
  }

  showsMuchTheSame(mesh: Polygons): boolean {
    const { current: display, offsets, vertices } = this;
    return isSameStructure({ display, offsets, vertices }, mesh);
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
    this.#edges.setColour(palette.edge);
    this.#ghost.setColour(palette.ghost);
    this.#outline.setColour(palette.selected);
    this.#limits.setColour(palette.limit);
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
    this.#cutAnew(changes);
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
    this.#colours.choose(kind, figures);
    this.#colourAll();
  }

  /** null: the panels' own colours. */
  wear(skin: Skin | null): void {
    if (!skin && !this.#skin) return;
    this.#skin?.dispose();
    this.#skin = skin;
    this.#panels.material = skin?.material ?? this.#matt;
    skin?.update(this.#panels.geometry, this.offsets, this.topology);
  }

  /** Draws a line around one panel and gives its corners; null for none. */
  outlinePanel(panel: number | null): Float32Array | null {
    this.#outlined = panel;
    const corners = panel === null ? null : this.#cornersOf(panel);
    this.#outline.draw(corners ? [corners] : []);
    return corners;
  }

  /** Draws a line around panels that let an edit go no further. */
  markLimits(panels: readonly number[]): void {
    if (panels.length === 0 && this.#atLimit.length === 0) return;
    this.#atLimit = panels;
    this.#limits.draw(panels.slice(0, MARKED).flatMap((panel) => this.#cornersOf(panel) ?? []));
  }

  #cornersOf(panel: number): Float32Array | null {
    const [begin, end] = [this.offsets[panel] ?? 0, this.offsets[panel + 1] ?? 0];
    return end > begin ? this.corners.slice(3 * begin, 3 * end) : null;
  }

  showBase(on: boolean): void {
    for (const v of this.#moved) this.#place(v, on ? this.base : this.current);
    this.#ghost.object.visible = !on;
    this.#uploadPositions();
  }

  setSize(width: number, height: number): void {
    this.#edges.setSize(width, height);
    this.#outline.setSize(width, height);
    this.#limits.setSize(width, height);
  }

  /** `pixel`: what one spans, display units. */
  inkEdges(pixel: number): void {
    this.#edges.setInk((this.#skin ? FAINT : 1) * edgeInk(this.#meanEdge / pixel));
  }

  /** True if it casts none yet. */
  get shadowToCome(): boolean {
    return !this.#panels.castShadow;
  }

  castShadow(): void {
    this.#panels.castShadow = true;
  }

  dispose(): void {
    this.#panels.geometry.dispose();
    this.#matt.dispose();
    this.#skin?.dispose();
    this.#edges.dispose();
    this.#outline.dispose();
    this.#limits.dispose();
    this.#ghost.dispose();
  }

  /** See outwards(); an edit does not turn a model inside out. */
  get outward(): number {
    this.#outward ??= outwards(this.corners, this.triangles, this.topology.boundary);
    return this.#outward;
  }

  #place(v: number, from: Float32Array): void {
    const [x, y, z] = [from[3 * v] ?? 0, from[3 * v + 1] ?? 0, from[3 * v + 2] ?? 0];
    for (const corner of row(this.topology.corners, v)) {
      this.corners[3 * corner] = x;
      this.corners[3 * corner + 1] = y;
      this.corners[3 * corner + 2] = z;
      this.#dirtyCorners.add(corner);
    }
    this.#edges.move(v, x, y, z);
  }

  /** A panel that was convex may have become concave, and the other way round. */
  #cutAnew(changes: Float32Array): void {
    const touched = new Set<number>();
    for (let k = 0; k + 3 < changes.length; k += 4) {
      for (const corner of row(this.topology.corners, changes[k] ?? 0)) {
        touched.add(panelAt(this.offsets, corner));
      }
    }
    for (const f of touched) {
      const [begin, end] = [this.offsets[f] ?? 0, this.offsets[f + 1] ?? 0];
      if (end - begin < 4) continue;
      const first = firstTriangle(this.offsets, f);
      triangulatePanel(this.corners, begin, end, this.triangles, first);
      this.#dirtyTriangles.add(first);
      this.#dirtyTriangles.add(first + end - begin - 3);
    }
  }

  #uploadPositions(): void {
    const { attributes, index } = this.#panels.geometry;
    const { position } = attributes;
    if (position instanceof BufferAttribute) this.#dirtyCorners.flush(position, 3);
    if (index) this.#dirtyTriangles.flush(index, 3);
    this.#skin?.update(this.#panels.geometry, this.offsets, this.topology);
    this.#edges.upload();
  }

  #displacement(v: number): number {
    const at = (axis: number) => (this.current[3 * v + axis] ?? 0) - (this.base[3 * v + axis] ?? 0);
    return Math.hypot(at(0), at(1), at(2));
  }

  #colourMoved(): void {
    this.#largest = this.#scale;
    for (const v of this.#moved) this.#largest = Math.max(this.#largest, this.#displacement(v));
    for (const v of this.#moved) {
      this.#colours.paintVertex(v, this.#displacement(v) / this.#largest);
    }
    this.#colours.upload();
  }

  #colourAll(): void {
    this.#colours.paintAll();
    this.#colourMoved();
  }

  /** Edges of the base at vertices that moved visibly. */
  #drawGhost(): void {
    const { edges, edgeEnds } = this.topology;
    const seen = new Set<number>();
    for (const v of this.#moved) {
      if (this.#displacement(v) < GHOST_SHARE * this.#largest) continue;
      for (const end of row(edgeEnds, v)) seen.add(end >> 1);
    }
    this.#ghost.draw(seen, edges);
  }
}
