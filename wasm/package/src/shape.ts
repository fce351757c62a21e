// SPDX-License-Identifier: MIT
// What every operation gives: positions, what moved, a report, and a way to write it.
import type { Core } from "./core.ts";
import { insist, wording } from "./error.ts";
import { Mesh } from "./mesh.ts";
import type { MeshFormat } from "./mesh-format.ts";
import type { Answer, ShapeHandle, Watch } from "./planish_package.mjs";
import { Place } from "./pool.ts";
import type { Report } from "./report.ts";

/** Called after every step; false stops with the last valid state and the status "cancelled". */
export type Progress = Watch;

/** The figures of a shape, read once. */
interface Figures {
  readonly positions: Float64Array;
  readonly moved: Uint32Array;
  readonly report: Report;
  readonly messages: readonly string[];
}

function figuresOf(shape: ShapeHandle): Figures {
  return {
    positions: shape.positions(),
    moved: new Uint32Array(shape.moved()),
    report: JSON.parse(shape.report()) as Report,
    messages: shape.messages().map(wording),
  };
}

/** Calls back with a shape that may be gone afterwards. */
type Lend = <R>(use: (shape: ShapeHandle) => R) => R;

/** Positions over the faces of a base mesh. */
export class Shape {
  /** x, y, z of every point, model units. */
  readonly positions: Float64Array;
  /** Points whose coordinates differ from the base's, ascending. */
  readonly moved: Uint32Array;
  readonly report: Report;
  /** What the command line would say about the result, one sentence each; empty if all is well. */
  readonly messages: readonly string[];
  readonly #core: Core;
  readonly #read: Lend;
  readonly #bytes: (name: string) => Answer<Uint8Array>;

  /** @internal @param read lends the core's shape  @param bytes the shape as a file */
  constructor(core: Core, read: Lend, bytes: (name: string) => Answer<Uint8Array>) {
    const figures = read(figuresOf);
    this.positions = figures.positions;
    this.moved = figures.moved;
    this.report = figures.report;
    this.messages = figures.messages;
    this.#core = core;
    this.#read = read;
    this.#bytes = bytes;
  }

  /** @internal Of an operation on a whole mesh. */
  static of(core: Core, make: () => ShapeHandle): Shape {
    const place = new Place(core.pool, make);
    const shape = new Shape(
      core,
      (use) => use(place.handle()),
      (name) => place.handle().bytes(name),
    );
    place.keepIfStopped(shape.report.status);
    return shape;
  }

  /** What was edited: the mesh as given, or a flat one near it. */
  get base(): Mesh {
    return this.#read((shape) => Mesh.of(this.#core, shape.base()));
  }

  /** The result as a mesh of its own. */
  get mesh(): Mesh {
    const core = this.#core;
    const points = this.positions.slice();
    const offsets = new Int32Array(this.base.faceOffsets);
    const vertices = new Int32Array(this.base.faceVertices);
    return new Mesh(core, () => insist(core.module.meshOfArrays(points, offsets, vertices)));
  }

  /** The file; a GLB also holds the base, and of an edit its design and its variations. */
  write(format: MeshFormat): Uint8Array {
    return insist(this.#bytes(`mesh.${format}`));
  }
}
