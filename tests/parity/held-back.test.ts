// SPDX-License-Identifier: MIT
// A drag far beyond what the limit on folds lets through, to and fro, by the page's own dispatcher.
import { expect, it } from "vitest";
import { FIRST_SETTINGS } from "../../web/src/design/design.ts";
import { loadPlanish } from "./support/planish.ts";
import { SolverHere } from "./support/solver-here.ts";

const SIZE = 24;
const VERTEX = 12 * SIZE + 12;
const LIMIT = 10;
const FRAMES = 90;

/** Mean edges from where the drag began. */
const pull = (k: number): readonly number[] => [
  1.2 * Math.sin(k / 7),
  0.8 * Math.cos(k / 5),
  k < 30 ? k / 12 : 2.5 * Math.sin(k / 9),
];

it.each(["vault", "dome"])("every frame on a %s holds the limit and moves", async (name) => {
  const solver = new SolverHere(await loadPlanish());
  const { positions, report } = await solver.openSample(name, SIZE);
  const from = [VERTEX, ...positions.slice(3 * VERTEX, 3 * VERTEX + 3)];
  let shown = 0;
  for (let k = 1; k <= FRAMES; ++k) {
    const target = pull(k).map((x, axis) => (from[axis + 1] ?? 0) + report.meanEdge * x);
    const pulled = {
      kind: "edit",
      job: 2,
      mode: "drag",
      targets: { handles: [VERTEX, ...target], pins: [] },
      settings: FIRST_SETTINGS,
      budget: 10,
      limit: { degrees: LIMIT, short: 0, from, base: from },
      reaches: [],
      sought: null,
    } as const;
    const frame = await solver.ask(pulled, "shown");
    const { sharpestFold, maxDisplacement } = frame.report;
    expect(sharpestFold).not.toBeNull();
    const grown = (sharpestFold?.after ?? 0) - (sharpestFold?.before ?? 0);
    expect(grown, `frame ${k}`).toBeLessThanOrEqual(LIMIT + 1e-9);
    shown += maxDisplacement / report.meanEdge / FRAMES;
  }
  expect(shown).toBeGreaterThan(1);
});
