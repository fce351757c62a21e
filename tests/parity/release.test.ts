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
  readonly #solver = new SolverHere(module);
  base: Float64Array = new Float64Array();

  async open(): Promise<void> {
    this.base = (await this.#solver.openSample("vault", 20)).positions;
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
    return this.#solver.ask(request, "shown");
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
