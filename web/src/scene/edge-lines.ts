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

export interface EdgeLines {
  readonly object: LineSegments2 | LineSegments;
  move(vertex: number, x: number, y: number, z: number): void;
  /** Sends what moved to the graphics card. */
  upload(): void;
  setColour(colour: string): void;
  setSize(width: number, height: number): void;
  dispose(): void;
}

class WideLines implements EdgeLines {
  readonly object: LineSegments2;
  readonly #topology: Topology;
  readonly #ends: Float32Array;
  readonly #dirty = new DirtyRange();

  constructor(topology: Topology, points: Float32Array, width: number) {
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

  setColour(colour: string): void {
    this.object.material.color.set(colour);
  }

  setSize(width: number, height: number): void {
    this.object.material.resolution.set(width, height);
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}

class Hairlines implements EdgeLines {
  readonly object: LineSegments<BufferGeometry, LineBasicMaterial>;
  readonly #points: BufferAttribute;
  readonly #dirty = new DirtyRange();

  constructor(topology: Topology, points: Float32Array) {
    this.#points = new BufferAttribute(points.slice(), 3).setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.#points);
    geometry.setIndex(new BufferAttribute(new Uint32Array(topology.edges), 1));
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

  setColour(colour: string): void {
    this.object.material.color.set(colour);
  }

  setSize(): void {}

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}

export const makeEdgeLines = (
  topology: Topology,
  points: Float32Array,
  width: number,
): EdgeLines =>
  topology.edges.length / 2 > WIDE_LIMIT
    ? new Hairlines(topology, points)
    : new WideLines(topology, points, width);
