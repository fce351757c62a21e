// SPDX-License-Identifier: MIT
// What the edit's limits promise: nothing beyond the reach moves, and a kept boundary stays.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { type ObjMesh, readObj } from "./support/obj.ts";
import { exportAs, idle, movedCount, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";
import { handleRows } from "./support/view.ts";

const REACH = 4;

async function slide(page: Page, name: string, value: string): Promise<void> {
  await page.getByRole("slider", { name }).fill(value);
  await idle(page);
}

/** Points on edges that one panel alone uses. */
function boundaryOf({ faces }: ObjMesh): Set<number> {
  const uses = new Map<string, number>();
  const sides = faces.flatMap((face) =>
    face.map((v, k) => [v, face[(k + 1) % face.length] ?? v].sort((a, b) => a - b)),
  );
  for (const side of sides) uses.set(side.join(), (uses.get(side.join()) ?? 0) + 1);
  return new Set(sides.filter((side) => uses.get(side.join()) === 1).flat());
}

function within({ faces }: ObjMesh, from: number, rings: number): Set<number> {
  let inside = new Set([from]);
  for (let ring = 0; ring < rings; ++ring) {
    inside = new Set([...faces.filter((f) => f.some((v) => inside.has(v))).flat(), ...inside]);
  }
  return inside;
}

it("nothing beyond the reach moves, and a kept boundary stays, to the last digit", async () => {
  const page = await site.open();
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  const base = readObj((await exportAs(page, "OBJ")).toString());
  await typeTarget(page, "+50cm");
  const weights = await movedCount(page);

  await slide(page, "Reach", String(REACH));
  await slide(page, "Softness", "5");
  await page.getByRole("checkbox", { name: "Keep boundary" }).check();
  await idle(page);
  expect(await page.getByRole("slider", { name: "Locality" }).isDisabled()).toBe(true);
  const edited = readObj((await exportAs(page, "OBJ")).toString());
  const moved = edited.points.flatMap((p, v) => (p.join() === base.points[v]?.join() ? [] : [v]));
  const [handle = { vertex: -1 }] = await handleRows(page);
  const [near, boundary] = [within(base, handle.vertex, REACH), boundaryOf(base)];
  expect(moved.length).toBeGreaterThan(20);
  expect(moved.filter((v) => !near.has(v))).toEqual([]);
  expect(moved.filter((v) => boundary.has(v))).toEqual([]);

  // Back to the weights: the edit that they give.
  await slide(page, "Softness", "0");
  await slide(page, "Reach", "0");
  await page.getByRole("checkbox", { name: "Keep boundary" }).uncheck();
  await idle(page);
  expect(await movedCount(page)).toBe(weights);
  await page.context().close();
});
