// SPDX-License-Identifier: MIT
// The page splits moves for its colours as the core does for its reports.
import type { Session } from "@wasm/planish.mjs";
import { expect, it } from "vitest";
import { FIRST_SETTINGS } from "../../web/src/design/design.ts";
import { OldSurface } from "../../web/src/mesh/old-surface.ts";
import { buildTopology } from "../../web/src/mesh/topology.ts";
import { loadPlanish } from "./support/planish.ts";

/** The largest of the page's, of the design that a session shows. */
function rangeOf(session: Session): { raised: number; lowered: number; slide: number } {
  const base = session.basePositions();
  const [offsets, vertices] = [session.faceOffsets(), session.faceVertices()];
  const topology = buildTopology(offsets, vertices, base.length / 3);
  const surface = new OldSurface(base, { offsets, vertices, topology });
  const places = session.movedPositions();
  const range = { raised: 0, lowered: 0, slide: 0 };
  session.moved().forEach((v, k) => {
    const [x = 0, y = 0, z = 0] = places.subarray(3 * k, 3 * k + 3);
    const { shape, slide } = surface.motion(v, [x, y, z]);
    range.raised = Math.max(range.raised, shape);
    range.lowered = Math.max(range.lowered, -shape);
    range.slide = Math.max(range.slide, slide);
  });
  return range;
}

it.each(["roof", "vault", "dome", "freeform", "hex", "trihex"])("on a %s", async (name) => {
  const module = await loadPlanish();
  const session = new module.Session();
  expect(session.openSample(name, 12)).toBe("");
  const { meanEdge, vertices } = session.meshReport();
  for (const keepBoundary of [true, false])
    for (const [share, up] of [
      [0.4, 0.5],
      [0.6, -0.5],
      [0.5, 2],
    ] as const) {
      expect(session.setOptions({ ...FIRST_SETTINGS, keepBoundary })).toBe("");
      const v = Math.floor(share * vertices);
      const [x = 0, y = 0, z = 0] = session.basePositions().subarray(3 * v);
      const target = Float64Array.of(v, x + 0.3 * meanEdge, y, z + up * meanEdge);
      expect(session.edit(module.EditMode.solve, target, new Int32Array(0), 0, 1)).toBe("");
      const { motion, movedVertices, maxDisplacement } = session.shapeReport();
      if (movedVertices === 0) continue; // it was pulled along a boundary that is kept
      const range = rangeOf(session);
      for (const key of ["raised", "lowered", "slide"] as const)
        expect(Math.abs(range[key] - motion[key])).toBeLessThan(1e-9 * maxDisplacement);
      expect(motion.slide).toBeGreaterThan(0);
    }
  session.delete();
});
