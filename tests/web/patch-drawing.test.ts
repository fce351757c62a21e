// SPDX-License-Identifier: MIT
// The small pictures of the gallery mean by their colours what the view means.
import { Color } from "three";
import { afterEach, expect, it, vi } from "vitest";
import { LIGHT } from "../../web/src/scene/palette.ts";
import { drawPatch, patchOf } from "../../web/src/scene/patch-drawing.ts";
import type { OpenedMesh, Shape } from "../../web/src/solver/protocol.ts";

// A level square of one panel, in a mesh whose units are those of the picture.
const POINTS = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0];
const mesh = {
  display: Float32Array.from(POINTS),
  positions: Float64Array.from(POINTS),
  offsets: Int32Array.of(0, 4),
  vertices: Int32Array.of(0, 1, 2, 3),
  report: { centre: [0, 0, 0], scale: 1 },
} as unknown as OpenedMesh;

const at = (height: number): Shape => ({
  moved: Int32Array.of(0, 1, 2, 3),
  positions: Float64Array.from(POINTS, (x, k) => (k % 3 === 2 ? height : x)),
});

/** With what a panel of `shape` is filled in the picture of a variation of the edit at 0. */
function fillOf(shape: Shape): Color {
  const context = {
    scale() {},
    beginPath() {},
    lineTo() {},
    closePath() {},
    fill() {},
    stroke() {},
  };
  const canvas = { getContext: () => context } as unknown as HTMLCanvasElement;
  drawPatch(canvas, mesh, patchOf(mesh, [shape], at(0)), shape, [100, 80]);
  return new Color((context as unknown as { fillStyle: string }).fillStyle);
}

/** How far apart in hue, 0 to 0.5. */
function hueApart(a: Color, b: Color): number {
  const apart = Math.abs(a.getHSL({ h: 0, s: 0, l: 0 }).h - b.getHSL({ h: 0, s: 0, l: 0 }).h);
  return Math.min(apart, 1 - apart);
}

const end = (ramp: readonly string[]): Color => new Color(ramp.at(-1));

afterEach(() => {
  vi.unstubAllGlobals();
});

it("what goes away from the eye has the view's colour for it, and never the alarm's", () => {
  vi.stubGlobal("window", { devicePixelRatio: 1, matchMedia: () => ({ matches: false }) });
  expect(hueApart(fillOf(at(0.5)), end(LIGHT.displacement))).toBeLessThan(0.02);
  expect(hueApart(fillOf(at(-0.5)), end(LIGHT.lowered))).toBeLessThan(0.02);
  expect(hueApart(fillOf(at(-0.5)), end(LIGHT.planarity))).toBeGreaterThan(0.2);
});
