// SPDX-License-Identifier: MIT
// What must not depend on one browser engine: the first drag, links that verify, export and storage.
import { readFileSync } from "node:fs";
import { afterAll, beforeAll, expect, it } from "vitest";
import { expectClean } from "../browser/support/axe.ts";
import { expectLocalAndFlat, readObj } from "../browser/support/obj.ts";
import { NIGHTLY } from "../patience.ts";
import { usable, type Visitor, visit } from "./support/visitor.ts";

interface Link {
  readonly name: string;
  readonly moved: number;
  readonly link: string;
}

const every: readonly Link[] = JSON.parse(
  readFileSync(new URL("../../docs/scenes/links.json", import.meta.url), "utf8"),
);

/** An edit, one within a region, and a mixture of variations. All open in node at every commit
 * (tests/web/figures.test.ts), and what solves is the same WebAssembly. */
const FEW = ["figure-3-a", "figure-2-region", "figure-4-mix-a"];
const links = NIGHTLY ? every : every.filter(({ name }) => FEW.includes(name));

/** Pixels from the tip of the first visit's sentence to its point. */
const TIP = 26;

let visitor: Visitor;
beforeAll(async () => {
  visitor = await visit();
});
afterAll(() => visitor.leave());

/** As the menu of Export gives it. */
async function exportObj(): Promise<string> {
  await visitor.press("Export");
  return visitor.download(() => visitor.press("OBJ"));
}

it("a drag is exact, local, saved as a file and still there after a reload", async () => {
  const { page } = visitor;
  await usable(visitor);
  const before = readObj(await exportObj());
  const hint = await page.waitForSelector("::-p-text(Drag this point)");
  const box = await hint?.boundingBox();
  if (!box) throw new Error("no point to begin with");
  const side = await page.$eval(".hint", (sentence) => sentence.getAttribute("data-side"));
  const [x, y] = [box.x + box.width / 2, side === "below" ? box.y - TIP : box.y + box.height + TIP];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 6; ++k) await page.mouse.move(x, y - 5 * k);
  await page.mouse.up();
  await expect.poll(visitor.moved).toBeGreaterThan(0);
  await page.waitForSelector("::-p-aria([name='Cancel'][role='button'][disabled])");
  const moved = await visitor.moved();
  const text = await exportObj();
  expectLocalAndFlat(before, readObj(text), moved);
  await page.reload();
  await usable(visitor);
  await expect.poll(visitor.moved).toBe(moved);
  expect(await exportObj()).toBe(text);
});

it("axe finds nothing, edited or exported, on a desk and in the 320 pixels left at 400 %", async () => {
  const { page } = visitor;
  await usable(visitor);
  await expectClean(page, "edited");
  await visitor.press("Export");
  await expectClean(page, "exporting", ".menu:popover-open");
  await page.keyboard.press("Escape");
  await page.setViewport({ width: 320, height: 568 });
  await expectClean(page, "at 400 %");
  await page.setViewport({ width: 900, height: 640 });
});

it("there are as many links as are to be opened", () => {
  expect(links).toHaveLength(NIGHTLY ? 30 : FEW.length);
});

it.each(links)("$name opens from its link, verified", async ({ link, moved }) => {
  const { page, url } = visitor;
  await page.goto("about:blank");
  await page.goto(url + link);
  await usable(visitor);
  await expect.poll(visitor.verified).toBe(1);
  expect(await visitor.moved()).toBe(moved);
});
