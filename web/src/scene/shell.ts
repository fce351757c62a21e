// SPDX-License-Identifier: MIT
// The structure on screen: panels, their edges, and a ghost of where it was.
import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshStandardMaterial,
} from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { ColourBy, DisplayMesh } from "../state/store.ts";
import { buildTopology, row, type Topology } from "../state/topology.ts";
import type { Palette } from "./palette.ts";
import { makeRamp, planarityShare, type Ramp, writeRamp } from "./ramp.ts";

/** Below this share of the largest displacement the ghost would only double the edges. */
const GHOST_SHARE = 0.04;

/** Every panel as a fan of triangles over its own corners, so that it can be shaded by itself. */
function fanIndex(offsets: Int32Array): Uint32Array {
  const triangles: number[] = [];
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const begin = offsets[f] ?? 0;
    const end = offsets[f + 1] ?? 0;
    for (let c = begin + 1; c + 1 < end; ++c) triangles.push(begin, c, c + 1);
  }
  return Uint32Array.from(triangles);
}

export class Shell {
  readonly group = new Group();
  readonly topology: Topology;
  readonly base: Float32Array;
  /** Display coordinates of the design shown. */
  readonly current: Float32Array;
  readonly #offsets: Int32Array;
  readonly #vertices: Int32Array;
  readonly #moved = new Set<number>();
  readonly #panels: Mesh<BufferGeometry, MeshStandardMaterial>;
  readonly #edges: LineSegments2;
  readonly #outline: LineSegments2;
  readonly #ends: Float32Array;
  readonly #ghost: LineSegments<BufferGeometry, LineBasicMaterial>;
  readonly #corner: Float32Array;
  readonly #colour: Float32Array;
  #ramp: Ramp = [];
  #panelRamp: Ramp = [];
  /** Largest displacement shown, display coordinates. */
  #largest = 0;
  #figures: Float32Array | null = null;
  #plain = false;
  #outlined: number | null = null;

  constructor({ display, offsets, vertices }: DisplayMesh, palette: Palette) {
    this.base = Float32Array.from(display);
    this.current = Float32Array.from(display);
    this.#offsets = Int32Array.from(offsets);
    this.#vertices = Int32Array.from(vertices);
    this.topology = buildTopology(this.#offsets, this.#vertices, display.length / 3);
    this.#corner = new Float32Array(3 * vertices.length);
    this.#colour = new Float32Array(3 * vertices.length);
    this.#panels = this.#makePanels();
    this.#ends = new Float32Array(3 * this.topology.edges.length);
    this.#edges = this.#makeLines(1.1);
    this.#outline = this.#makeLines(3);
    this.#outline.visible = false;
    this.#outline.renderOrder = 1;
    this.#ghost = this.#makeGhost();
    this.group.add(this.#panels, this.#edges, this.#ghost, this.#outline);
    for (let v = 0; v < this.base.length / 3; ++v) this.#place(v);
    this.#edges.geometry.setPositions(this.#ends);
    this.setPalette(palette);
    this.#panels.geometry.computeBoundingSphere();
  }

  #makePanels(): Mesh<BufferGeometry, MeshStandardMaterial> {
    const geometry = new BufferGeometry();
    const dynamic = (data: Float32Array) => new BufferAttribute(data, 3).setUsage(DynamicDrawUsage);
    geometry.setAttribute("position", dynamic(this.#corner));
    geometry.setAttribute("color", dynamic(this.#colour));
    geometry.setIndex(new BufferAttribute(fanIndex(this.#offsets), 1));
    const material = new MeshStandardMaterial({
      vertexColors: true,
      flatShading: true,
      side: DoubleSide,
      roughness: 0.85,
      metalness: 0,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    const panels = new Mesh(geometry, material);
    panels.castShadow = true;
    panels.receiveShadow = true;
    panels.frustumCulled = false;
    return panels;
  }

  #makeLines(linewidth: number): LineSegments2 {
    const lines = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ linewidth }));
    lines.frustumCulled = false;
    return lines;
  }

  #makeGhost(): LineSegments<BufferGeometry, LineBasicMaterial> {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(this.base, 3));
    geometry.setIndex([]);
    const material = new LineBasicMaterial({ transparent: true, opacity: 0.35 });
    const ghost = new LineSegments(geometry, material);
    ghost.frustumCulled = false;
    return ghost;
  }

  setPalette(palette: Palette): void {
    this.#ramp = makeRamp(palette.displacement);
    this.#panelRamp = makeRamp(palette.planarity);
    this.#edges.material.color.set(palette.edge);
    this.#ghost.material.color.set(palette.ghost);
    this.#outline.material.color.set(palette.ghost);
    this.#colourAll();
  }

  /** `changes` holds vertex, x, y, z in display coordinates. */
  apply(changes: Float32Array): void {
    for (let k = 0; k + 3 < changes.length; k += 4) {
      const v = changes[k] ?? 0;
      this.current.set(changes.subarray(k + 1, k + 4), 3 * v);
      if (this.#displacement(v) > 0) this.#moved.add(v);
      else this.#moved.delete(v);
      this.#place(v);
      this.#colourVertex(v, 0);
    }
    this.#colourMoved();
    this.#uploadPositions();
    this.#drawGhost();
    if (this.#outlined !== null) this.outlinePanel(this.#outlined);
  }

  /** Panels by how far they are out of flat, points by how far they moved, or neither. */
  colourBy(kind: ColourBy, figures: Float32Array | null): void {
    this.#figures = kind === "planarity" ? figures : null;
    this.#plain = kind === "none";
    this.#colourAll();
  }

  /** Draws a line around one panel and gives its corners; null for none. */
  outlinePanel(panel: number | null): Float32Array | null {
    this.#outlined = panel;
    const begin = panel === null ? 0 : (this.#offsets[panel] ?? 0);
    const end = panel === null ? 0 : (this.#offsets[panel + 1] ?? 0);
    this.#outline.visible = end > begin;
    if (end <= begin) return null;
    const corners = this.#corner.slice(3 * begin, 3 * end);
    const lines = new Float32Array(2 * corners.length);
    for (let k = 0; k < end - begin; ++k) {
      const next = (k + 1) % (end - begin);
      lines.set(corners.subarray(3 * k, 3 * k + 3), 6 * k);
      lines.set(corners.subarray(3 * next, 3 * next + 3), 6 * k + 3);
    }
    this.#outline.geometry.dispose();
    this.#outline.geometry = new LineSegmentsGeometry().setPositions(lines);
    return corners;
  }

  showBase(on: boolean): void {
    const shown = on ? this.base : this.current;
    for (const v of this.#moved) this.#place(v, shown);
    this.#uploadPositions();
  }

  setSize(width: number, height: number): void {
    this.#edges.material.resolution.set(width, height);
    this.#outline.material.resolution.set(width, height);
  }

  dispose(): void {
    this.#panels.geometry.dispose();
    this.#panels.material.dispose();
    for (const lines of [this.#edges, this.#outline]) {
      lines.geometry.dispose();
      lines.material.dispose();
    }
    this.#ghost.geometry.dispose();
    this.#ghost.material.dispose();
  }

  #place(v: number, from: Float32Array = this.current): void {
    const point = from.subarray(3 * v, 3 * v + 3);
    for (const corner of row(this.topology.corners, v)) this.#corner.set(point, 3 * corner);
    for (const end of row(this.topology.edgeEnds, v)) this.#ends.set(point, 3 * end);
  }

  #uploadPositions(): void {
    const { position } = this.#panels.geometry.attributes;
    if (position) position.needsUpdate = true;
    const start = this.#edges.geometry.attributes.instanceStart;
    if (start && "data" in start) {
      (start.data.array as Float32Array).set(this.#ends);
      start.data.needsUpdate = true;
    }
  }

  #displacement(v: number): number {
    const at = (axis: number) => (this.current[3 * v + axis] ?? 0) - (this.base[3 * v + axis] ?? 0);
    return Math.hypot(at(0), at(1), at(2));
  }

  #colourVertex(v: number, t: number): void {
    if (this.#figures) return;
    for (const corner of row(this.topology.corners, v)) {
      writeRamp(this.#ramp, t, this.#colour, 3 * corner);
    }
  }

  #colourMoved(): void {
    this.#largest = 0;
    for (const v of this.#moved) this.#largest = Math.max(this.#largest, this.#displacement(v));
    if (!this.#plain) {
      for (const v of this.#moved) this.#colourVertex(v, this.#displacement(v) / this.#largest);
    }
    this.#uploadColours();
  }

  #colourAll(): void {
    if (this.#figures) this.#colourPanels(this.#figures);
    else for (let v = 0; v < this.base.length / 3; ++v) this.#colourVertex(v, 0);
    this.#colourMoved();
  }

  /** Neutral up to the tolerance, then logarithmic up to the fabrication limit. */
  #colourPanels(figures: Float32Array): void {
    for (let f = 0; f + 1 < this.#offsets.length; ++f) {
      const t = planarityShare(figures[2 * f + 1] ?? 0);
      for (let c = this.#offsets[f] ?? 0; c < (this.#offsets[f + 1] ?? 0); ++c) {
        writeRamp(this.#panelRamp, t, this.#colour, 3 * c);
      }
    }
  }

  #uploadColours(): void {
    const { color } = this.#panels.geometry.attributes;
    if (color) color.needsUpdate = true;
  }

  /** Edges of the base at vertices that moved visibly. */
  #drawGhost(): void {
    const { edges, edgeEnds } = this.topology;
    const seen = new Set<number>();
    for (const v of this.#moved) {
      if (this.#displacement(v) < GHOST_SHARE * this.#largest) continue;
      for (const end of row(edgeEnds, v)) seen.add(end >> 1);
    }
    const index = new Uint32Array(2 * seen.size);
    let k = 0;
    for (const edge of seen) {
      index[k++] = edges[2 * edge] ?? 0;
      index[k++] = edges[2 * edge + 1] ?? 0;
    }
    this.#ghost.geometry.setIndex(new BufferAttribute(index, 1));
  }
}
