// SPDX-License-Identifier: MIT
// Panel edges, never triangle diagonals: lines of a chosen width, or hairlines on a large mesh.
import {
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  LineBasicMaterial,
  LineSegments,
} from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { row, type Topology } from "../mesh/topology.ts";
import { DirtyRange } from "./dirty-range.ts";
import { displaySphere } from "./framing.ts";

/** Above this a line is a pixel of its own accord, and wide lines would cost 12 times the memory. */
const WIDE_LIMIT = 60_000;

/** Edges darken what lies under them, so that they show on light and on deep colours alike. */
export const INK = 0.62;

/**
 * Pixels: shorter edges are left out, longer than the second are drawn in full ink. Closer together
 * they would only darken the picture, in waves, and take longer than the panels.
 */
const FADING = [1, 3] as const;

/** How dark edges are whose mean length on screen is `pixels`. */
export const edgeInk = (pixels: number): number =>
  INK * Math.min(1, Math.max(0, (pixels - FADING[0]) / (FADING[1] - FADING[0])));

export abstract class EdgeLines {
  abstract readonly object: LineSegments2 | LineSegments<BufferGeometry, LineBasicMaterial>;
  abstract move(vertex: number, x: number, y: number, z: number): void;
  /** Sends what moved to the graphics card. */
  abstract upload(): void;
  abstract setSize(width: number, height: number): void;

  setColour(colour: string): void {
    this.object.material.color.set(colour);
  }

  /** 0 (not drawn at all) … 1. */
  setInk(ink: number): void {
    this.object.material.opacity = ink;
    this.object.visible = ink > 0;
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}

class WideLines extends EdgeLines {
  readonly object: LineSegments2;
  readonly #topology: Topology;
  readonly #ends: Float32Array;
  readonly #dirty = new DirtyRange();

  constructor(topology: Topology, points: Float32Array, width: number) {
    super();
    this.#topology = topology;
    this.#ends = new Float32Array(3 * topology.edges.length);
    topology.edges.forEach((v, end) => {
      this.#ends.set(points.subarray(3 * v, 3 * v + 3), 3 * end);
    });
    const geometry = new LineSegmentsGeometry().setPositions(this.#ends);
    this.object = new LineSegments2(
      geometry,
      new LineMaterial({ linewidth: width, transparent: true, opacity: INK }),
    );
    this.object.frustumCulled = false;
  }

  move(vertex: number, x: number, y: number, z: number): void {
    for (const end of row(this.#topology.edgeEnds, vertex)) {
      this.#ends[3 * end] = x;
      this.#ends[3 * end + 1] = y;
      this.#ends[3 * end + 2] = z;
      this.#dirty.add(end);
    }
  }

  upload(): void {
    const start = this.object.geometry.attributes.instanceStart;
    if (start && "data" in start) this.#dirty.flush(start.data, 3);
  }

  setSize(width: number, height: number): void {
    this.object.material.resolution.set(width, height);
  }
}

class Hairlines extends EdgeLines {
  readonly object: LineSegments<BufferGeometry, LineBasicMaterial>;
  readonly #points: BufferAttribute;
  readonly #dirty = new DirtyRange();

  constructor(topology: Topology, points: Float32Array) {
    super();
    this.#points = new BufferAttribute(points.slice(), 3).setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.#points);
    const { buffer, byteOffset, length } = topology.edges;
    geometry.setIndex(new BufferAttribute(new Uint32Array(buffer, byteOffset, length), 1));
    geometry.boundingSphere = displaySphere();
    const material = new LineBasicMaterial({ transparent: true, opacity: INK });
    this.object = new LineSegments(geometry, material);
    this.object.frustumCulled = false;
  }

  move(vertex: number, x: number, y: number, z: number): void {
    this.#points.setXYZ(vertex, x, y, z);
    this.#dirty.add(vertex);
  }

  upload(): void {
    this.#dirty.flush(this.#points, 3);
  }

  setSize(): void {}
}

/** The mean length of a thousand edges, evenly from the list: all of a million would take a frame's time. */
export function meanEdge({ edges }: Topology, points: Float32Array): number {
  const count = edges.length / 2;
  const step = Math.max(1, Math.floor(count / 1000));
  const at = (end: number, axis: number): number => points[3 * (edges[end] ?? 0) + axis] ?? 0;
  let [sum, seen] = [0, 0];
  for (let e = 0; e < count; e += step, ++seen) {
    const along = (axis: number): number => at(2 * e + 1, axis) - at(2 * e, axis);
    sum += Math.hypot(along(0), along(1), along(2));
  }
  return sum / Math.max(1, seen);
}

export const makeEdgeLines = (
  topology: Topology,
  points: Float32Array,
  width: number,
): EdgeLines =>
  topology.edges.length / 2 > WIDE_LIMIT
    ? new Hairlines(topology, points)
    : new WideLines(topology, points, width);
