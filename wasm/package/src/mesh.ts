// SPDX-License-Identifier: MIT
import { type Core, loadCore } from "./core.ts";
import { insist, PlanishError, wording } from "./error.ts";
import type { MeshFormat } from "./mesh-format.ts";
import type { MeshHandle } from "./planish_package.mjs";
import { once } from "./pool.ts";
import type { Report } from "./report.ts";

/** Points and polygons. Never changes. */
export class Mesh {
  /** @internal */
  readonly core: Core;
  readonly #make: () => MeshHandle;

  /** @internal Use from(), read() or sample(). */
  constructor(core: Core, make: () => MeshHandle) {
    this.core = core;
    this.#make = make;
    this.handle(); // what is wrong with a mesh is said here
  }

  /**
   * A mesh of arrays, which are copied.
   * @param points x, y, z of every point
   * @param faceOffsets for every face where its corners begin in `faceVertices`, and at last their number
   * @param faceVertices the points at the corners, from 0
   * @throws PlanishError that names what is wrong
   */
  static async from(
    points: ArrayLike<number>,
    faceOffsets: ArrayLike<number>,
    faceVertices: ArrayLike<number>,
  ): Promise<Mesh> {
    const core = await loadCore();
    if (points.length % 3 !== 0) {
      throw new PlanishError("mesh", "points must hold three numbers for each point");
    }
    const place = Float64Array.from(points);
    const offsets = indices(faceOffsets, "faceOffsets");
    const vertices = indices(faceVertices, "faceVertices");
    return new Mesh(core, () => insist(core.module.meshOfArrays(place, offsets, vertices)));
  }

  /**
   * The mesh in a file.
   * @param name whose extension is the format, one of MeshFormat
   * @throws PlanishError
   */
  static async read(bytes: Uint8Array | ArrayBuffer, name: string): Promise<Mesh> {
    const core = await loadCore();
    const copy = new Uint8Array(bytes).slice();
    return new Mesh(core, () => insist(core.module.readMesh(name, copy)));
  }

  /** One of the samples: dome, vault, roof, hex, trihex, ... @param size rows */
  static async sample(name: string, size: number): Promise<Mesh> {
    const core = await loadCore();
    return new Mesh(core, () => insist(core.module.sampleMesh(`${name}:${size}`)));
  }

  /** x, y, z of every point; a copy. */
  get points(): Float64Array {
    return this.handle().points();
  }

  /** A copy; see from(). */
  get faceOffsets(): Uint32Array {
    return new Uint32Array(this.handle().faceOffsets());
  }

  /** A copy; see from(). */
  get faceVertices(): Uint32Array {
    return new Uint32Array(this.handle().faceVertices());
  }

  /** What is odd about the mesh and what is done about it, one sentence each. */
  get warnings(): readonly string[] {
    return this.handle().warnings().map(wording);
  }

  /** Counts, edge length, degrees of freedom and flatness. */
  info(): Report {
    return JSON.parse(this.handle().info()) as Report;
  }

  /** The file; every coordinate with all its bits, but single precision in GLB. */
  write(format: MeshFormat): Uint8Array {
    return insist(this.handle().bytes(`mesh.${format}`));
  }

  /** @internal */
  handle(): MeshHandle {
    return this.core.pool.get(this, this.#make);
  }

  /** @internal Of a handle that is read here and not needed any more. */
  static of(core: Core, handle: MeshHandle): Mesh {
    return once(handle, (mesh) => {
      const arrays = [mesh.points(), mesh.faceOffsets(), mesh.faceVertices()] as const;
      return new Mesh(core, () => insist(core.module.meshOfArrays(...arrays)));
    });
  }
}

function indices(values: ArrayLike<number>, what: string): Int32Array {
  const list = Int32Array.from(values);
  const wrong = list.findIndex((value, k) => value !== values[k] || value < 0);
  if (wrong < 0) return list;
  throw new PlanishError("mesh", `${what}[${wrong}] is ${values[wrong]}, no index from 0`);
}
