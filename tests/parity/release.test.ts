// SPDX-License-Identifier: MIT
// The end of a drag, by the page's own dispatcher: what was shown stays, and the recipe gives it again.
import type { PlanishModule } from "@wasm/planish.mjs";
import { beforeAll, expect, it } from "vitest";
import { FIRST_SETTINGS } from "../../web/src/design/design.ts";
import type { EditMode, EditSettings, Reply, Shape } from "../../web/src/solver/protocol.ts";
import { loadPlanish } from "./support/planish.ts";
import { SolverHere } from "./support/solver-here.ts";

type Shown = Extract<Reply, { kind: "shown" }>;

let module: PlanishModule;
beforeAll(async () => {
  module = await loadPlanish();
});

/** An edit with two minima: one along the way, one at once. */
const VERTEX = 81;
const PULL = [-0.755, 0.664, -0.252] as const;
const LENGTH = Math.hypot(...PULL);
const FRAMES = 23;

class Page {
  readonly solver = new SolverHere(module);
  base: Float64Array = new Float64Array();
  edge = 0;

  async open(name: "vault" | "freeform" = "vault", size = 20): Promise<void> {
    const mesh = await this.solver.openSample(name, size);
    this.base = mesh.positions;
    this.edge = mesh.report.meanEdge;
  }

  async edit(mode: EditMode, share: number, settings: EditSettings): Promise<Shown> {
    const target = PULL.map((x, axis) => (this.base[3 * VERTEX + axis] ?? 0) + share * x);
    const targets = { handles: [VERTEX, ...target], pins: [] };
    const request = {
      kind: "edit",
      job: 2,
      mode,
      targets,
      settings,
      budget: 10,
      limit: null,
      reaches: [],
      sought: null,
    } as const;
    return this.solver.ask(request, "shown");
  }
}

/** Where each vertex that either moves lies, apart by at most so much of the pull. */
function apart(base: Float64Array, a: Shape, b: Shape): number {
  const at = ({ moved, positions }: Shape, v: number, axis: number): number => {
    const k = moved.indexOf(v);
    return (k < 0 ? base[3 * v + axis] : positions[3 * k + axis]) ?? Number.NaN;
  };
  const gaps = [...new Set([...a.moved, ...b.moved])].map((v) =>
    Math.hypot(...[0, 1, 2].map((axis) => at(a, v, axis) - at(b, v, axis))),
  );
  return Math.max(...gaps) / LENGTH;
}

it("keeps the shape of the drag, which its recipe gives again bit by bit", async () => {
  const page = new Page();
  await page.open();
  for (let k = 1; k <= FRAMES; ++k) await page.edit("drag", k / FRAMES, FIRST_SETTINGS);
  const released = await page.edit("release", 1, FIRST_SETTINGS);
  const { continuation = 0 } = released.report;
  expect(continuation).toBeGreaterThan(0);
  if (!released.shape) throw new Error("a release has a shape");

  const again = await page.edit("solve", 1, { ...FIRST_SETTINGS, continuation });
  expect(again.shape).toEqual(released.shape);
  const fresh = new Page();
  await fresh.open();
  const elsewhere = await fresh.edit("solve", 1, { ...FIRST_SETTINGS, continuation });
  expect(elsewhere.shape).toEqual(released.shape);
  const atOnce = await page.edit("solve", 1, FIRST_SETTINGS);
  if (!atOnce.shape) throw new Error("an edit has a shape");
  expect(apart(page.base, atOnce.shape, released.shape)).toBeGreaterThan(0.1);
});

/** Of a mesh where a drag up by three edges is held back, and an edit of where it stops is of another minimum. */
const HELD = { vertex: 106, edges: 3, frames: 12 };

/** That drag; `mode` at its end. */
async function heldBack(page: Page, mode: EditMode, share: number): Promise<Shown> {
  const { vertex, edges } = HELD;
  const base = [vertex, ...page.base.subarray(3 * vertex, 3 * vertex + 3)];
  const [v = 0, x = 0, y = 0, z = 0] = base;
  const question = {
    kind: "edit",
    job: 2,
    mode,
    targets: { handles: [v, x, y, z + share * edges * page.edge], pins: [] },
    settings: FIRST_SETTINGS,
    budget: 10,
    limit: { degrees: 10, short: 0, from: base, base },
    reaches: [FIRST_SETTINGS.reach],
    sought: null,
  } as const;
  return page.solver.ask(question, "shown");
}

it("keeps the shape of a drag that was held back, whose recipe has the limit", async () => {
  const page = new Page();
  await page.open("freeform", 14);
  const seen = new Map<number, readonly number[]>();
  const look = ({ changes }: Shown): void => {
    for (let k = 0; k < changes.length; k += 4)
      seen.set(changes[k] ?? -1, [...changes.subarray(k + 1, k + 4)]);
  };
  for (let k = 1; k <= HELD.frames; ++k) look(await heldBack(page, "drag", k / HELD.frames));
  const frame = new Map(seen);
  const released = await heldBack(page, "release", 1);
  look(released);
  const { report, taken, found, shape } = released;
  const most = Math.max(
    ...[...seen].map(([v, place]) =>
      Math.hypot(...place.map((x, axis) => x - (frame.get(v)?.[axis] ?? Number.NaN))),
    ),
  );
  expect(report.maxDisplacement).toBeGreaterThan(0);
  expect(most).toBeLessThan(1e-3);
  const continuation = report.continuation ?? 0;
  expect(continuation).toBeGreaterThan(0);
  const settings = { ...FIRST_SETTINGS, limits: found };
  const again = (steps: number) =>
    page.solver.ask(
      {
        kind: "edit",
        job: 3,
        mode: "solve",
        targets: { handles: taken ?? [], pins: [] },
        settings: { ...settings, continuation: steps },
        budget: 10,
        limit: null,
        reaches: [],
        sought: null,
      },
      "shown",
    );
  expect(await again(continuation)).toMatchObject({ shape });
  expect(await again(0)).not.toMatchObject({ shape });
});
