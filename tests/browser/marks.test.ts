// SPDX-License-Identifier: MIT
// Needs: pixels.
// What the view says about points: under the pointer, chosen, and where a handle came from.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { idle, movedCount, still, typeTarget } from "./support/page.ts";
import { readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";
import { hintedPoint, type Place, press, viewBox } from "./support/view.ts";

/** The figure beside the point looked at; "" if there is none. */
const pointFigure = async (page: Page): Promise<string> => {
  const found = page.getByText(/^Point \d+ (moved|untouched|bends|smooth)/);
  return (await found.count()) > 0 ? ((await found.first().textContent()) ?? "") : "";
};

/** A small part of the 3D view as bytes. */
async function pixels(page: Page, { x, y }: Place, size = 24): Promise<string> {
  const clip = { x: x - size / 2, y: y - size / 2, width: size, height: size };
  return (await page.screenshot({ clip })).toString("base64");
}

/** Mean difference of two pictures of one size, per channel, 0 … 255. A line that comes back may be smoothed
 * otherwise: that is a little more than 1. */
function difference(first: string, second: string): number {
  const [a, b] = [first, second].map((text) => readPng(Buffer.from(text, "base64")));
  if (!a || !b) throw new Error("no picture");
  let sum = 0;
  for (let x = 0; x < a.width; ++x) {
    for (let y = 0; y < a.height; ++y) {
      const other = b.at(x, y);
      a.at(x, y).forEach((channel, c) => {
        sum += Math.abs(channel - (other[c] ?? 0));
      });
    }
  }
  return sum / (3 * a.width * a.height);
}

describe("the pointer on a point", () => {
  it("draws a ring about it", async () => {
    const page = await site.openVault({ draws: true, reducedMotion: "reduce" });
    await typeTarget(page, "+60cm");
    await page.getByRole("button", { name: "Top", exact: true }).click();
    const { x, y, width, height } = await viewBox(page);
    // Points are everywhere in the middle of the top view: one step of a search finds one.
    let at: Place | null = null;
    for (let k = 0; k < 40 && !at; ++k) {
      const place = { x: x + width / 2 + 60 + 2 * k, y: y + height / 2 + 40 };
      await page.mouse.move(place.x, place.y);
      if (/untouched/.test(await pointFigure(page))) at = place;
    }
    if (!at) throw new Error("no point found");
    const ringed = await pixels(page, at, 40);
    await page.mouse.move(x + 4, y + height - 4);
    await expect.poll(() => pixels(page, at, 40)).not.toBe(ringed);
    await page.context().close();
  });
});

it("a line goes from where a handle was to where it is pulled, and hides with Before", async () => {
  const page = await site.open({
    draws: true,
    reducedMotion: "reduce",
    viewport: { width: 1280, height: 800 },
  });
  const start = await hintedPoint(page);
  const end = { x: start.x, y: start.y - 90 };
  // Off the ring of the first visit, on the way of the pull and on its start.
  const way = { x: start.x, y: start.y - 45 };
  const before = { start: await pixels(page, start, 8), way: await pixels(page, way, 8) };
  await press(page, start, end);
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await expect.poll(() => pixels(page, way, 8)).not.toBe(before.way);
  await page.mouse.up();
  await idle(page);
  // The line is over the surface: the pull's own ink, unlike the panels beside it.
  const beside = { x: way.x + 10, y: way.y };
  await expect
    .poll(async () => (await pixels(page, way, 4)) === (await pixels(page, beside, 4)))
    .toBe(false);
  await page.getByLabel("3D view").focus();
  // The shade comes once the edit rests.
  await still(page);
  const pulled = await pixels(page, start, 8);
  expect(pulled).not.toBe(before.start);
  const edited = await page.getByLabel("3D view").screenshot();
  await page.keyboard.down("b");
  const fromPulled = async () => difference(await pixels(page, start, 8), pulled);
  await expect.poll(fromPulled).toBeGreaterThan(10);
  // What is shown is the base.
  await still(page);
  expect((await page.getByLabel("3D view").screenshot()).equals(edited)).toBe(false);
  await page.keyboard.up("b");
  await expect.poll(fromPulled).toBeLessThan(4);
  await page.getByRole("button", { name: "Remove" }).click();
  await idle(page);
  await expect.poll(fromPulled).toBeGreaterThan(10);
  await page.context().close();
});

it("a ticked box in the table of handles shows a tick", async () => {
  const page = await site.openVault({ deviceScaleFactor: 4 });
  await typeTarget(page, "+10cm");
  const pin = page.getByRole("checkbox", { name: "Pinned" });
  await pin.check();
  await idle(page);
  await page.mouse.move(2, 2);
  await still(page);
  const picture = readPng(await pin.screenshot());
  const light: number[] = [];
  for (let x = 8; x < picture.width - 8; ++x)
    for (let y = 8; y < picture.height - 8; ++y)
      if (Math.min(...picture.at(x, y)) > 200) light.push(x / picture.width);
  const [left, right] = [Math.min(...light), Math.max(...light)];
  expect(left).toBeGreaterThan(0.15);
  expect(right - left).toBeGreaterThan(0.4);
  expect(Math.abs((left + right) / 2 - 0.5)).toBeLessThan(0.1);
  await page.context().close();
});
