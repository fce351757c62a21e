// SPDX-License-Identifier: MIT
// Needs: storage.
// Points stand on what is chosen for them: their coordinates keep their bits, and the design says so
// wherever it goes.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { type ObjMesh, readObj } from "./support/obj.ts";
import { idle, kept, obj, typeTarget, usable } from "./support/page.ts";
import { site } from "./support/site.ts";

const supports = (page: Page) => page.getByText(/^Supports/).filter({ visible: true });

async function stand(page: Page, words: string): Promise<void> {
  await page.getByRole("combobox", { name: /^Selected: / }).selectOption(words);
  await idle(page);
}

/** Points of edges that one panel has alone. */
function boundaryOf({ faces }: ObjMesh): Set<number> {
  const sides = faces.flatMap((face) => face.map((v, k) => [v, face[(k + 1) % face.length] ?? v]));
  const known = new Set(sides.map(([a, b]) => `${a} ${b}`));
  return new Set(sides.filter(([a, b]) => !known.has(`${b} ${a}`)).flat());
}

it("a boundary that only goes up and down keeps every x and y, also after a reload", async () => {
  const page = await site.open();
  await page.getByRole("checkbox", { name: "Keep boundary" }).uncheck();
  await page.getByRole("button", { name: "Select in a box" }).click();
  await page.getByRole("button", { name: "Boundary", exact: true }).click();
  await supports(page).click();
  await stand(page, "only go up and down");
  const before = readObj(await obj(page));
  await kept(page);
  await page.reload();
  await usable(page);
  const boundary = boundaryOf(before);
  // What was saved comes back after the page is usable.
  await expect.poll(() => supports(page).innerText()).toBe(`Supports (${boundary.size} points)`);
  await page.getByRole("slider", { name: "Reach" }).fill("10");
  await typeTarget(page, "+40cm");
  const after = readObj(await obj(page));
  const moved = [...boundary].filter((v) => before.lines[v] !== after.lines[v]);
  expect(moved.length).toBeGreaterThan(3);
  const plan = (line = ""): string => line.split(" ").slice(0, 2).join(" ");
  for (const v of moved) expect(plan(after.lines[v])).toBe(plan(before.lines[v]));
  await page.context().close();
});
