// SPDX-License-Identifier: MIT
// The camera, fingers, before and after; and nothing is drawn when nothing changes.
import { describe, expect, it } from "vitest";
import { idle } from "../browser/support/page.ts";
import { hintedPoint, type Place, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const gap = (a: Place, b: Place): number => Math.hypot(a.x - b.x, a.y - b.y);

it("a mouse that dragged a point is asked nothing", async () => {
  const page = await site.open();
  const at = await hintedPoint(page);
  await press(page, at, { x: at.x, y: at.y - 40 });
  await page.mouse.up();
  await idle(page);
  expect(await page.getByRole("button", { name: "Discard" }).count()).toBe(0);
  await page.context().close();
});

describe("the camera", () => {
  it("goes to named views by buttons and keys, and fits the model again", async () => {
    const page = await site.open({ reducedMotion: "reduce" });
    const begin = await hintedPoint(page);
    let last = begin;
    for (const name of ["Front", "Top", "Side"]) {
      await page.getByRole("button", { name, exact: true }).click();
      const before = last;
      await expect.poll(async () => gap(before, await hintedPoint(page))).toBeGreaterThan(1);
      last = await hintedPoint(page);
    }
    await page.getByLabel("3D view").focus();
    await page.keyboard.press("1");
    await expect.poll(async () => gap(begin, await hintedPoint(page))).toBeLessThan(2);
    for (let k = 0; k < 5; ++k) await page.keyboard.press("+");
    await page.keyboard.press("f");
    await expect.poll(async () => gap(begin, await hintedPoint(page))).toBeLessThan(2);
    await page.context().close();
  });
});
