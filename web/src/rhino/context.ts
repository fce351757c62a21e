// SPDX-License-Identifier: MIT
// What of a file is no panel, as lines, triangles and points to draw behind the panels.
import type { Brep, Curve, GeometryBase, Mesh } from "rhino3dm";
import type { Faces, RhinoModule } from "./model.ts";

/** x, y, z one after the other, model units. */
export interface Context {
  /** Objects. */
  readonly count: number;
  /** Both ends of each line. */
  readonly lines: Float64Array;
  /** Three corners of each triangle. */
  readonly triangles: Float64Array;
  readonly points: Float64Array;
}

/** Lines to one span of a curve. */
const STEPS = 16;
/** Above this many coordinates a drawing would hold the page up: what comes later stays out. */
const MOST_COORDINATES = 6_000_000;

/** A list that grows to millions. */
class Coordinates {
  #array = new Float64Array(1024);
  length = 0;

  push(point: readonly number[]): void {
    if (this.length + 3 > this.#array.length) {
      const larger = new Float64Array(2 * this.#array.length);
      larger.set(this.#array);
      this.#array = larger;
    }
    this.#array.set([point[0] ?? 0, point[1] ?? 0, point[2] ?? 0], this.length);
    this.length += 3;
  }

  take(): Float64Array {
    return this.#array.slice(0, this.length);
  }
}

export class ContextCollector {
  readonly #rhino: RhinoModule;
  readonly #lines = new Coordinates();
  readonly #triangles = new Coordinates();
  readonly #points = new Coordinates();
  #count = 0;

  constructor(rhino: RhinoModule) {
    this.#rhino = rhino;
  }

  /** null for none. */
  take(): Context | null {
    if (this.#count === 0) return null;
    const [lines, triangles, points] = [this.#lines, this.#triangles, this.#points];
    return {
      count: this.#count,
      lines: lines.take(),
      triangles: triangles.take(),
      points: points.take(),
    };
  }

  /** False, and nothing is kept, if there is no room. */
  outline(corners: readonly number[]): boolean {
    return this.#object(() => {
      for (let k = 0; k < corners.length; k += 3) {
        this.#lines.push(corners.slice(k, k + 3));
        this.#lines.push(corners.slice((k + 3) % corners.length).slice(0, 3));
      }
    });
  }

  mesh({ points, faces }: Faces): boolean {
    const at = (v: number): readonly number[] => [...points.slice(3 * v, 3 * v + 3)];
    return this.#object(() => {
      for (const [a = 0, ...others] of faces)
        for (let k = 0; k + 1 < others.length; ++k)
          for (const v of [a, others[k] ?? 0, others[k + 1] ?? 0]) this.#triangles.push(at(v));
    });
  }

  /** False for what cannot be drawn, or if there is no room. */
  object(geometry: GeometryBase): boolean {
    const rhino = this.#rhino;
    return this.#object(() => {
      if (geometry instanceof rhino.Curve) this.#curve(geometry);
      else if (geometry instanceof rhino.Brep) this.#brep(geometry);
      else if (geometry instanceof rhino.Extrusion)
        this.#surface(geometry.getMesh(rhino.MeshType.Any), geometry.toBrep(false));
      else if (geometry instanceof rhino.Surface)
        this.#surface(null, rhino.Brep.createFromSurface(geometry));
      else if (geometry instanceof rhino.Point) this.#points.push(geometry.location);
      else if (geometry instanceof rhino.PointCloud)
        for (const point of geometry.getPoints()) this.#points.push(point);
    });
  }

  /** Counts what `add` adds something of, and takes back what is too much. */
  #object(add: () => void): boolean {
    const lists = [this.#lines, this.#triangles, this.#points];
    const before = lists.map(({ length }) => length);
    const total = (): number => lists.reduce((sum, { length }) => sum + length, 0);
    const old = total();
    add();
    if (total() > MOST_COORDINATES)
      lists.forEach((list, k) => {
        list.length = before[k] ?? 0;
      });
    if (total() === old) return false;
    this.#count += 1;
    return true;
  }

  /** Adds a curve span after span, so that corners stay corners. */
  #curve(curve: Curve): void {
    const nurbs = curve.toNurbsCurve();
    if (!nurbs) return;
    const knots = [...new Set(nurbs.knots().toList())];
    const steps = nurbs.degree === 1 ? 1 : STEPS;
    let before = nurbs.pointAt(knots[0] ?? 0);
    for (let span = 0; span + 1 < knots.length; ++span) {
      const [from = 0, to = 0] = knots.slice(span, span + 2);
      for (let k = 1; k <= steps; ++k) {
        const point = nurbs.pointAt(k === steps ? to : from + ((to - from) * k) / steps);
        this.#lines.push(before);
        this.#lines.push(point);
        before = point;
      }
    }
  }

  /** Adds the edges of a solid, and the meshes by which Rhino showed it where they were saved. */
  #brep(brep: Brep): void {
    const [edges, faces] = [brep.edges(), brep.faces()];
    for (let k = 0; k < edges.count; ++k) this.#curve(edges.get(k));
    for (let k = 0; k < faces.count; ++k)
      this.#surface(faces.get(k).getMesh(this.#rhino.MeshType.Any), null);
  }

  #surface(mesh: Mesh | null, brep: Brep | null): void {
    if (brep) this.#brep(brep);
    if (!mesh) return;
    const list = mesh.faces();
    for (let f = 0; f < list.count; ++f) {
      const [a = 0, b = 0, c = 0, d = 0] = list.get(f);
      const corners = c === d ? [a, b, c] : [a, b, c, a, c, d];
      for (const v of corners) this.#triangles.push(mesh.vertices().point3dAt(v));
    }
  }
}
