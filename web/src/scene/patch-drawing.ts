// SPDX-License-Identifier: MIT
// Small pictures of the part of a structure that changes: its panels from one fixed direction,
// far ones first, without WebGL.
import { Color } from "three";
import { NO_SHAPE } from "../design/design.ts";
import { add, cross, dot, type Vector } from "../mesh/vector.ts";
import type { OpenedMesh, Shape } from "../solver/protocol.ts";
import { DARK, LIGHT, type Palette } from "./palette.ts";
import { makeRamp, type Ramp, writeRamp } from "./ramp.ts";

/** Panels to draw and where they lie on the picture, the same for all pictures of one family. */
export interface Patch {
  readonly panels: readonly number[];
  /** Left, top, right, bottom of the projection, display coordinates. */
  readonly bounds: readonly [number, number, number, number];
  /** The largest difference in the family, display units: the end of the colour ramp. */
  readonly largest: number;
  /** What the colours are held against. */
  readonly from: Shape;
  /** Whether they tell a way towards the eye from one away from it, by ramps of their own. */
  readonly signed: boolean;
}

/** Unit axes of the picture: to the right, upwards, towards the eye. */
const RIGHT: Vector = [0.8706, -0.4921, 0];
const UP: Vector = [0.249, 0.4405, 0.8625];
const EYE: Vector = [-0.4244, -0.7509, 0.506];
const LIGHT_FROM: Vector = [-0.62, -0.24, 0.75];

/** More panels than this would be dots. */
const MOST_PANELS = 1500;

/** Display coordinates of `shape` on `mesh`, by vertex. */
function placesOf(mesh: OpenedMesh, shape: Shape): (vertex: number) => Vector {
  const { display } = mesh;
  const { centre, scale } = mesh.report;
  const moved = new Map<number, Vector>();
  shape.moved.forEach((v, k) => {
    const at = (c: 0 | 1 | 2): number => ((shape.positions[3 * k + c] ?? 0) - centre[c]) * scale;
    moved.set(v, [at(0), at(1), at(2)]);
  });
  const base = (v: number): Vector => [
    display[3 * v] ?? 0,
    display[3 * v + 1] ?? 0,
    display[3 * v + 2] ?? 0,
  ];
  return (v) => moved.get(v) ?? base(v);
}

const cornersOf = (mesh: OpenedMesh, panel: number): Int32Array =>
  mesh.vertices.subarray(mesh.offsets[panel] ?? 0, mesh.offsets[panel + 1] ?? 0);

/** Moves smaller than this share of the largest one do not widen the picture. */
const VISIBLE = 0.15;

type Differences = ReadonlyMap<number, number>;

/** Where two shapes of a mesh differ, and by how much: by vertex, display units. */
function differences(mesh: OpenedMesh, from: Shape, to: Shape): Differences {
  const [a, b] = [placesOf(mesh, from), placesOf(mesh, to)];
  const found = new Map<number, number>();
  for (const v of [...from.moved, ...to.moved]) {
    const [p, q] = [a(v), b(v)];
    found.set(v, Math.hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
  }
  return found;
}

/** Vertices that differ visibly in any of them. */
function visibly(all: readonly Differences[], largest: number): Set<number> {
  const inside = new Set<number>();
  for (const one of all)
    for (const [v, length] of one) if (length > VISIBLE * largest) inside.add(v);
  return inside;
}

/** Panels with a corner in `inside`, and those around them. */
function panelsAround(mesh: OpenedMesh, inside: Set<number>): number[] {
  const count = mesh.offsets.length - 1;
  if (inside.size === 0) return Array.from({ length: Math.min(count, MOST_PANELS) }, (_, f) => f);
  for (let ring = 0; ; ++ring) {
    const panels: number[] = [];
    for (let f = 0; f < count; ++f) {
      if (cornersOf(mesh, f).some((v) => inside.has(v))) panels.push(f);
    }
    if (ring === 1 || panels.length > MOST_PANELS) return panels.slice(0, MOST_PANELS);
    for (const f of panels) for (const v of cornersOf(mesh, f)) inside.add(v);
  }
}

/** Where panels lie on the picture, in any of the shapes. */
function boundsOf(
  mesh: OpenedMesh,
  panels: readonly number[],
  shapes: readonly Shape[],
): Patch["bounds"] {
  const bounds: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const shape of shapes) {
    const at = placesOf(mesh, shape);
    for (const f of panels) {
      for (const v of cornersOf(mesh, f)) {
        const [x, y] = [dot(at(v), RIGHT), -dot(at(v), UP)];
        bounds[0] = Math.min(bounds[0], x);
        bounds[1] = Math.min(bounds[1], y);
        bounds[2] = Math.max(bounds[2], x);
        bounds[3] = Math.max(bounds[3], y);
      }
    }
  }
  return bounds;
}

/**
 * What differs from `from` in any of `shapes`, near enough to see it; null: from the mesh, whichever
 * way.
 */
export function patchOf(
  mesh: OpenedMesh,
  shapes: readonly Shape[],
  given: Shape | null = null,
): Patch {
  const from = given ?? NO_SHAPE;
  const all = shapes.map((shape) => differences(mesh, from, shape));
  const largest = all.reduce(
    (most, one) => [...one.values()].reduce((m, length) => Math.max(m, length), most),
    0,
  );
  const panels = panelsAround(mesh, visibly(all, largest));
  const bounds = boundsOf(mesh, panels, shapes);
  return { panels, bounds, largest, from, signed: given !== null };
}

/** Moves smaller than this share of a picture's own largest one do not widen it. */
const NOTED = 0.4;

/** `patch` from near by, where `shape` differs from the others; the colours mean what they meant. */
export function zoomedTo(mesh: OpenedMesh, patch: Patch, shape: Shape): Patch {
  const found = differences(mesh, patch.from, shape);
  const most = [...found.values()].reduce((m, length) => Math.max(m, length), 0);
  const noted = new Set([...found].flatMap(([v, length]) => (length > NOTED * most ? [v] : [])));
  if (noted.size === 0) return patch;
  const touched = patch.panels.filter((f) => cornersOf(mesh, f).some((v) => noted.has(v)));
  return { ...patch, bounds: boundsOf(mesh, touched, [patch.from, shape]) };
}

/** The panel's area vector, twice. */
function normalOf(points: readonly Vector[]): Vector {
  return points.reduce<Vector>(
    (sum, a, k) => add(sum, cross(a, points[(k + 1) % points.length] ?? a)),
    [0, 0, 0],
  );
}

/** How much light a panel takes. */
function brightness(points: readonly Vector[]): number {
  const normal = normalOf(points);
  const length = Math.hypot(...normal);
  return length > 0 ? 0.72 + 0.28 * Math.abs(dot(normal, LIGHT_FROM) / length) : 1;
}

/** Whether a panel went away from the eye, along its normal. */
function wentAway(before: readonly Vector[], after: readonly Vector[]): boolean {
  const normal = normalOf(before);
  const along = after.reduce((sum, q, k) => {
    const p = before[k] ?? q;
    return sum + dot([q[0] - p[0], q[1] - p[1], q[2] - p[2]], normal);
  }, 0);
  return along * dot(normal, EYE) < 0;
}

interface Pen {
  readonly context: CanvasRenderingContext2D;
  /** For what comes towards the eye, or whichever way it goes; for what goes away from it. */
  readonly ramps: readonly [Ramp, Ramp];
  readonly palette: Palette;
  readonly onPaper: (point: Vector) => readonly [number, number];
}

/** `share` of the ramp; below 0 of the one for what goes away. */
function drawPanel(
  { context, ramps, palette, onPaper }: Pen,
  points: Vector[],
  share: number,
): void {
  const rgb = new Float32Array(3);
  writeRamp(ramps[share < 0 ? 1 : 0], Math.abs(share), rgb, 0);
  const light = brightness(points);
  const colour = new Color((rgb[0] ?? 0) * light, (rgb[1] ?? 0) * light, (rgb[2] ?? 0) * light);
  context.beginPath();
  for (const point of points) context.lineTo(...(onPaper(point) as [number, number]));
  context.closePath();
  context.fillStyle = `#${colour.getHexString()}`;
  context.strokeStyle = palette.edge;
  context.fill();
  context.stroke();
}

/** Nothing around the drawing, as a share of the picture. */
const MARGIN = 0.05;

/** Draws `shape` over the whole canvas; `width` and `height` are CSS pixels. */
export function drawPatch(
  canvas: HTMLCanvasElement,
  mesh: OpenedMesh,
  patch: Patch,
  shape: Shape,
  [width, height]: readonly [number, number],
): void {
  const ratio = Math.min(window.devicePixelRatio, 2);
  canvas.width = width * ratio;
  canvas.height = height * ratio;
  const context = canvas.getContext("2d");
  if (!context) return;
  context.scale(ratio, ratio);
  context.lineWidth = 0.6;
  context.lineJoin = "round";
  const [left, top, right, bottom] = patch.bounds;
  const room = 1 - 2 * MARGIN;
  const size = room * Math.min(width / (right - left || 1), height / (bottom - top || 1));
  const onPaper = (point: Vector): readonly [number, number] => [
    width / 2 + size * (dot(point, RIGHT) - (left + right) / 2),
    height / 2 + size * (-dot(point, UP) - (top + bottom) / 2),
  ];
  const palette = window.matchMedia("(prefers-color-scheme: dark)").matches ? DARK : LIGHT;
  const ramps = [makeRamp(palette.displacement), makeRamp(palette.lowered)] as const;
  const pen = { context, palette, ramps, onPaper };
  const [before, at] = [placesOf(mesh, patch.from), placesOf(mesh, shape)];
  const moves = differences(mesh, patch.from, shape);
  const depth = (f: number): number => {
    const corners = cornersOf(mesh, f);
    return corners.reduce((sum, v) => sum + dot(at(v), EYE), 0) / corners.length;
  };
  const order = patch.panels.map((f) => [f, depth(f)] as const).sort((a, b) => a[1] - b[1]);
  for (const [f] of order) {
    const corners = [...cornersOf(mesh, f)];
    const most = Math.max(...corners.map((v) => moves.get(v) ?? 0));
    const share = patch.largest > 0 ? most / patch.largest : 0;
    const away = patch.signed && wentAway(corners.map(before), corners.map(at));
    drawPanel(pen, corners.map(at), away ? -share : share);
  }
}
