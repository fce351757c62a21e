// SPDX-License-Identifier: MIT
// The lines of the structure: its panels' edges, a ghost of where they were, and outlines of some panels.
import { Group } from "three";
import { row, type Topology } from "../mesh/topology.ts";
import { type EdgeLines, edgeInk, makeEdgeLines, meanEdge } from "./edge-lines.ts";
import { Ghost } from "./ghost.ts";
import type { Palette } from "./palette.ts";
import { PanelOutline } from "./panel-outline.ts";

/** Pixels. */
const WIDTH = 1.1;

export class ShellLines {
  readonly group = new Group();
  readonly outline = new PanelOutline();
  readonly limits = new PanelOutline();
  readonly ghost: Ghost;
  /** Of the edges that are drawn. */
  #topology: Topology;
  #edges: EdgeLines;
  /** Display units. */
  readonly #meanEdge: number;
  #colour = "";
  #size: readonly [number, number] = [1, 1];

  /** `base`: display coordinates of all points before the edit. */
  constructor(topology: Topology, base: Float32Array) {
    this.#topology = topology;
    this.#edges = makeEdgeLines(topology, base, WIDTH);
    this.#meanEdge = meanEdge(topology, base);
    this.ghost = new Ghost(base);
    const lines = [this.#edges, this.ghost, this.limits, this.outline];
    this.group.add(...lines.map(({ object }) => object));
  }

  /** Draws these edges in place of those before; `points`: where they are now. */
  draw(topology: Topology, points: Float32Array): void {
    if (topology === this.#topology) return;
    this.group.remove(this.#edges.object);
    this.#edges.dispose();
    this.#topology = topology;
    this.#edges = makeEdgeLines(topology, points, WIDTH);
    this.#edges.setColour(this.#colour);
    this.#edges.setSize(...this.#size);
    this.group.add(this.#edges.object);
  }

  get topology(): Topology {
    return this.#topology;
  }

  setPalette(palette: Palette): void {
    this.#colour = palette.edge;
    this.#edges.setColour(palette.edge);
    this.ghost.setColour(palette.ghost);
    this.outline.setColour(palette.selected);
    this.limits.setColour(palette.limit);
  }

  setSize(width: number, height: number): void {
    this.#size = [width, height];
    this.#edges.setSize(width, height);
    this.outline.setSize(width, height);
    this.limits.setSize(width, height);
  }

  /** `pixel`: what one spans, display units. `share` of the ink that the edges have by themselves. */
  ink(pixel: number, share: number): void {
    this.#edges.setInk(share * edgeInk(this.#meanEdge / pixel));
  }

  move(vertex: number, x: number, y: number, z: number): void {
    this.#edges.move(vertex, x, y, z);
  }

  upload(): void {
    this.#edges.upload();
  }

  /** Edges of the base at these points. */
  drawGhost(vertices: Iterable<number>): void {
    const { edges, edgeEnds } = this.#topology;
    const seen = new Set<number>();
    for (const v of vertices) for (const end of row(edgeEnds, v)) seen.add(end >> 1);
    this.ghost.draw(seen, edges);
  }

  dispose(): void {
    this.#edges.dispose();
    this.outline.dispose();
    this.limits.dispose();
    this.ghost.dispose();
  }
}
