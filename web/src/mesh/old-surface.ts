// SPDX-License-Identifier: MIT
// How far a point is off the surface that it was part of, and how far it went along it: the core's
// measures/motion again, for the colours of whatever the page shows, solved or only tried out. Figures
// in words are the core's; tests/parity/motion.test.ts holds the two together.
import type { Faces } from "./point-frame.ts";
import { row } from "./topology.ts";
import { panelAt } from "./triangulation.ts";
import { add, cross, dot, minus, type Vector } from "./vector.ts";

export interface Motion {
  /** Distance from the old surface, positive on its outside. */
  readonly shape: number;
  /** How far it went across the mean normal of the panels around the old point. */
  readonly slide: number;
}

const NOTHING: Vector = [0, 0, 0];

const scaled = (a: Vector, t: number): Vector => [t * a[0], t * a[1], t * a[2]];

function unit(a: Vector): Vector {
  const length = Math.hypot(...a);
  return length > 0 ? scaled(a, 1 / length) : NOTHING;
}

export class OldSurface {
  readonly #points: ArrayLike<number>;
  readonly #faces: Faces;
  /** Of panels that were asked for. */
  readonly #normals = new Map<number, Vector>();
  /** What the walk of one point has found: the place nearest to it, on a panel that it has passed. */
  readonly #passed = new Set<number>();
  #point: Vector = NOTHING;
  #squared = 0;
  /** From the point to that place. */
  #arm: Vector = NOTHING;
  #panel = -1;
  /** −1 within the panel; with `#second` the ends of an edge, without it a corner. */
  #first = -1;
  #second = -1;

  /** `points`: x, y, z of every vertex of the base. */
  constructor(points: ArrayLike<number>, faces: Faces) {
    this.#points = points;
    this.#faces = faces;
  }

  /** Of a vertex that is now at `point`. */
  motion(vertex: number, point: Vector): Motion {
    const move = minus(point, this.#at(vertex));
    const normal = this.#meanNormal(vertex);
    const slide = Math.hypot(...add(move, normal, -dot(normal, move)));
    if (!this.#walk(vertex, point)) return { shape: 0, slide };
    const height = -dot(this.#normalAtFoot(), this.#arm);
    if (this.#isOnBorder()) return { shape: height, slide };
    const distance = Math.sqrt(this.#squared);
    return { shape: height < 0 ? -distance : distance, slide };
  }

  #at(v: number): Vector {
    const points = this.#points;
    return [points[3 * v] ?? 0, points[3 * v + 1] ?? 0, points[3 * v + 2] ?? 0];
  }

  #cornersOf(panel: number): Int32Array {
    const { offsets, vertices } = this.#faces;
    return vertices.subarray(offsets[panel] ?? 0, offsets[panel + 1] ?? 0);
  }

  *#panelsAround(vertex: number): Generator<number> {
    const { offsets, topology } = this.#faces;
    for (const corner of row(topology.corners, vertex)) yield panelAt(offsets, corner);
  }

  /** Twice the area, along the normal. */
  #areaOf(panel: number): Vector {
    const corners = this.#cornersOf(panel);
    const origin = this.#at(corners[0] ?? 0);
    let area = NOTHING;
    corners.forEach((v, k) => {
      const next = corners[(k + 1) % corners.length] ?? v;
      area = add(area, cross(minus(this.#at(v), origin), minus(this.#at(next), origin)));
    });
    return area;
  }

  #normalOf(panel: number): Vector {
    const known = this.#normals.get(panel);
    if (known) return known;
    const normal = unit(this.#areaOf(panel));
    this.#normals.set(panel, normal);
    return normal;
  }

  /** Of the panels around a vertex, by their areas: a drag follows it. */
  #meanNormal(vertex: number): Vector {
    let sum = NOTHING;
    for (const panel of this.#panelsAround(vertex)) sum = add(sum, this.#areaOf(panel));
    return unit(sum);
  }

  /** From panel to panel, to those that share a corner, while that is nearer. */
  #walk(vertex: number, point: Vector): boolean {
    this.#point = point;
    this.#squared = Number.POSITIVE_INFINITY;
    this.#panel = -1;
    this.#passed.clear();
    this.#lookAround(vertex);
    for (let here = -1; this.#panel !== here; ) {
      here = this.#panel;
      const { offsets, vertices } = this.#faces;
      const end = offsets[here + 1] ?? 0;
      for (let c = offsets[here] ?? 0; c < end; ++c) this.#lookAround(vertices[c] ?? 0);
    }
    return this.#panel >= 0;
  }

  /** At all panels around a vertex that were not passed yet. */
  #lookAround(vertex: number): void {
    const { offsets, topology } = this.#faces;
    const { values, offsets: rows } = topology.corners;
    const end = rows[vertex + 1] ?? 0;
    for (let k = rows[vertex] ?? 0; k < end; ++k) {
      const panel = panelAt(offsets, values[k] ?? 0);
      if (this.#passed.has(panel)) continue;
      this.#passed.add(panel);
      this.#lookAt(panel);
    }
  }

  #lookAt(panel: number): void {
    const points = this.#points;
    const { offsets, vertices } = this.#faces;
    const [begin, end] = [offsets[panel] ?? 0, offsets[panel + 1] ?? 0];
    const normal = this.#normalOf(panel);
    const [x, y, z] = this.#point;
    let height = 0;
    for (let c = begin; c < end; ++c) {
      const v = 3 * (vertices[c] ?? 0);
      height += normal[0] * ((points[v] ?? 0) - x);
      height += normal[1] * ((points[v + 1] ?? 0) - y);
      height += normal[2] * ((points[v + 2] ?? 0) - z);
    }
    height /= end - begin;
    const isNearer = height * height < this.#squared;
    if (normal !== NOTHING && !isNearer) return;
    if (isNearer && this.#covers(begin, end, normal, height))
      this.#take(height * height, scaled(normal, height), panel);
    for (let c = begin; c < end; ++c)
      this.#lookAtEdge(panel, vertices[c] ?? 0, vertices[c + 1 < end ? c + 1 : begin] ?? 0);
  }

  #lookAtEdge(panel: number, v: number, w: number): void {
    const points = this.#points;
    const [x, y, z] = this.#point;
    const [ax, ay, az] = [points[3 * v] ?? 0, points[3 * v + 1] ?? 0, points[3 * v + 2] ?? 0];
    const ex = (points[3 * w] ?? 0) - ax;
    const ey = (points[3 * w + 1] ?? 0) - ay;
    const ez = (points[3 * w + 2] ?? 0) - az;
    const length = ex * ex + ey * ey + ez * ez;
    const along = (x - ax) * ex + (y - ay) * ey + (z - az) * ez;
    const share = length > 0 ? Math.min(1, Math.max(0, along / length)) : 0;
    const arm: Vector = [ax - x + share * ex, ay - y + share * ey, az - z + share * ez];
    const squared = dot(arm, arm);
    if (squared >= this.#squared) return;
    this.#take(squared, arm, panel, share < 1 ? v : w, share > 0 && share < 1 ? w : -1);
  }

  #take(squared: number, arm: Vector, panel: number, first = -1, second = -1): void {
    this.#squared = squared;
    this.#arm = arm;
    this.#panel = panel;
    this.#first = first;
    this.#second = second;
  }

  /** Whether the place under the point is inside of a panel's outline, by the parity of crossings. */
  #covers(begin: number, end: number, normal: Vector, height: number): boolean {
    const points = this.#points;
    const { vertices } = this.#faces;
    const [p, q, r] = normal.map(Math.abs) as [number, number, number];
    const along = p >= q && p >= r ? 0 : q >= r ? 1 : 2;
    const [u, v] = [(along + 1) % 3, (along + 2) % 3];
    const left = (this.#point[u] ?? 0) + height * (normal[u] ?? 0);
    const low = (this.#point[v] ?? 0) + height * (normal[v] ?? 0);
    let inside = false;
    let from = 3 * (vertices[end - 1] ?? 0);
    for (let c = begin; c < end; ++c) {
      const to = 3 * (vertices[c] ?? 0);
      const [ax, ay] = [(points[from + u] ?? 0) - left, (points[from + v] ?? 0) - low];
      const [bx, by] = [(points[to + u] ?? 0) - left, (points[to + v] ?? 0) - low];
      if (ay > 0 !== by > 0 && ax - (ay * (bx - ax)) / (by - ay) > 0) inside = !inside;
      from = to;
    }
    return inside;
  }

  #panelsAtEdge(a: number, b: number): readonly number[] {
    return [...this.#panelsAround(a)].filter((panel) => {
      const corners = this.#cornersOf(panel);
      return corners.some((v, k) => {
        const next = corners[(k + 1) % corners.length];
        return (v === a && next === b) || (v === b && next === a);
      });
    });
  }

  /** The angle inside the panel, radians. */
  #angleAt(panel: number, vertex: number): number {
    const corners = this.#cornersOf(panel);
    const k = corners.indexOf(vertex);
    const arm = (place: number): Vector =>
      minus(this.#at(corners[place % corners.length] ?? vertex), this.#at(vertex));
    const [next, previous] = [arm(k + 1), arm(k + corners.length - 1)];
    const normal = this.#normalOf(panel);
    const angle = Math.atan2(dot(normal, cross(next, previous)), dot(next, previous));
    return angle < 0 ? angle + 2 * Math.PI : angle;
  }

  #normalAtFoot(): Vector {
    const [first, second] = [this.#first, this.#second];
    if (first < 0) return this.#normalOf(this.#panel);
    const panels = second < 0 ? [...this.#panelsAround(first)] : this.#panelsAtEdge(first, second);
    return unit(
      panels.reduce((sum, f) => {
        const weight = second < 0 ? this.#angleAt(f, first) : 1;
        return add(sum, this.#normalOf(f), weight);
      }, NOTHING),
    );
  }

  #isOnBorder(): boolean {
    if (this.#first < 0) return false;
    if (this.#second < 0) return this.#faces.topology.boundary[this.#first] === 1;
    return this.#panelsAtEdge(this.#first, this.#second).length === 1;
  }
}
