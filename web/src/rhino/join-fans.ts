// SPDX-License-Identifier: MIT
// A mesh from Rhino has triangles and quads only: panels with more corners come as triangles. They
// are put together where that is certain, and stay triangles where it is not.
import { cross, dot, minus, type Vector } from "../mesh/vector.ts";
import type { Faces } from "./model.ts";

export interface JoinedFans {
  readonly faces: readonly (readonly number[])[];
  /** Panels of five and more corners that were put together. */
  readonly joined: number;
  /** Groups of coplanar triangles that may be panels, or not. */
  readonly uncertain: number;
  /** Groups with quads in one plane that would be one convex panel each; they stay. */
  readonly quads: number;
}

/** Out of plane over extent. What single precision keeps of a flat panel; a fold that is meant is larger. */
const COPLANAR = 1e-6;

const unit = (a: Vector): Vector => {
  const length = Math.hypot(...a) || 1;
  return [a[0] / length, a[1] / length, a[2] / length];
};

class FanFinder {
  readonly #points: Faces["points"];
  readonly #faces: Faces["faces"];
  /** The face that has the side from a to b; −1 where there are several. */
  readonly #sides = new Map<string, number>();

  constructor({ points, faces }: Faces) {
    this.#points = points;
    this.#faces = faces;
    faces.forEach((face, f) => {
      face.forEach((a, k) => {
        const key = `${a} ${face[(k + 1) % face.length]}`;
        this.#sides.set(key, this.#sides.has(key) ? -1 : f);
      });
    });
  }

  #at(v: number): Vector {
    const p = this.#points;
    return [p[3 * v] ?? 0, p[3 * v + 1] ?? 0, p[3 * v + 2] ?? 0];
  }

  #normal(f: number): Vector {
    const [a = 0, b = 0, c = 0] = this.#faces[f] ?? [];
    const at = this.#at(a);
    return unit(cross(minus(this.#at(b), at), minus(this.#at(c), at)));
  }

  /** Faces of at most `most` corners in the plane of face `first` that hang together, `first` among them, none in `done`. */
  group(first: number, done: ReadonlySet<number>, most = 3): readonly number[] {
    const [normal, origin] = [this.#normal(first), this.#at(this.#faces[first]?.[0] ?? 0)];
    const isIn = (f: number): boolean => {
      const face = this.#faces[f] ?? [];
      if (done.has(f) || face.length > most || dot(normal, this.#normal(f)) <= 0) return false;
      const offsets = face.map((v) => minus(this.#at(v), origin));
      const extent = Math.max(...offsets.map((offset) => Math.hypot(...offset)));
      return offsets.every((offset) => Math.abs(dot(offset, normal)) <= COPLANAR * extent);
    };
    const group = new Set([first]);
    for (const f of group)
      (this.#faces[f] ?? []).forEach((a, k, face) => {
        const other = this.#sides.get(`${face[(k + 1) % face.length]} ${a}`) ?? -1;
        if (other >= 0 && isIn(other)) group.add(other);
      });
    return [...group];
  }

  /** The outline of a group if it is one strictly convex polygon without points inside; else null. */
  outline(group: readonly number[]): readonly number[] | null {
    const members = new Set(group);
    const next = new Map<number, number>();
    for (const f of group)
      (this.#faces[f] ?? []).forEach((a, k, face) => {
        const b = face[(k + 1) % face.length] ?? 0;
        if (!members.has(this.#sides.get(`${b} ${a}`) ?? -1)) next.set(a, b);
      });
    const corners: number[] = [];
    const start = this.#faces[group[0] ?? 0]?.find((v) => next.has(v)) ?? -1;
    for (let v = start; corners.length <= next.size && !(v === start && corners.length > 0); ) {
      corners.push(v);
      v = next.get(v) ?? -1;
    }
    // A polygon without points inside has two corners more than triangles; a quad is two of them.
    const triangles = group.reduce((sum, f) => sum + (this.#faces[f]?.length ?? 0) - 2, 0);
    const closes = corners.length === next.size && corners.length === triangles + 2;
    return closes && this.#isConvex(corners, this.#normal(group[0] ?? 0)) ? corners : null;
  }

  #isConvex(corners: readonly number[], normal: Vector): boolean {
    return corners.every((v, k) => {
      const [before = 0, after = 0] = [corners.at(k - 1), corners[(k + 1) % corners.length]];
      const to = unit(minus(this.#at(v), this.#at(before)));
      return dot(cross(to, unit(minus(this.#at(after), this.#at(v)))), normal) > COPLANAR;
    });
  }
}

/** Groups of faces, quads among them, in one plane and with one strictly convex outline. */
function countQuadGroups(mesh: Faces, finder: FanFinder): number {
  const done = new Set<number>();
  let count = 0;
  mesh.faces.forEach((face, f) => {
    if (face.length !== 4 || done.has(f)) return;
    const group = finder.group(f, done, 4);
    for (const member of group) done.add(member);
    if (group.length > 1 && finder.outline(group)) count += 1;
  });
  return count;
}

/** Two coplanar triangles stay: a panel of four corners would have come as a quad. */
export function joinFans(mesh: Faces): JoinedFans {
  const finder = new FanFinder(mesh);
  const done = new Set<number>();
  const faces: (readonly number[])[] = [];
  let [joined, uncertain] = [0, 0];
  mesh.faces.forEach((face, f) => {
    if (done.has(f)) return;
    const group = face.length === 3 ? finder.group(f, done) : [f];
    const outline = group.length > 2 ? finder.outline(group) : null;
    if (outline) {
      faces.push(outline);
      joined += 1;
      for (const member of group) done.add(member);
      return;
    }
    faces.push(face);
    if (group.length > 2) {
      uncertain += 1;
      for (const member of group.filter((m) => m !== f)) {
        faces.push(mesh.faces[member] ?? []);
        done.add(member);
      }
    }
  });
  return { faces, joined, uncertain, quads: countQuadGroups(mesh, finder) };
}
