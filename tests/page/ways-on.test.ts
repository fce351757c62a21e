// SPDX-License-Identifier: MIT
// The ways on of a handle that stops short: what each gains is said before it is pressed, and true.
import type { Locator, Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, movedCount } from "../browser/support/page.ts";
import { hintedPoint, middleOf, press } from "../browser/support/view.ts";
import { allowed, exported } from "./support/held-back.ts";
import { site } from "./support/site.ts";

/** The ways on, once each has been tried. */
async function tried(page: Page): Promise<Locator> {
  const ways = page.getByRole("group", { name: "Get further" });
  const figures = ways.locator(".way-on .quiet");
  await expect.poll(() => figures.count(), { timeout: 60_000 }).toBeGreaterThan(0);
  await expect.poll(() => ways.getAttribute("aria-busy"), { timeout: 60_000 }).toBe("false");
  return ways;
}

it("each way on says how far it gets, the furthest first, and a press gets there", async () => {
  const page = await site.openSmall();
  const at = await hintedPoint(page);
  await press(page, at, { x: at.x, y: at.y - 240 });
  await page.getByText(/^Held back: /).waitFor();
  await page.mouse.up();
  await idle(page);
  const moved = await movedCount(page);
  const edited = await exported(page);
  const ways = await tried(page);
  expect(await movedCount(page)).toBe(moved); // nothing was changed by trying
  expect((await exported(page)).lines).toEqual(edited.lines);
  const texts = await ways.locator(".way-on").allTextContents();
  expect(texts.length).toBeGreaterThan(1);
  const got = texts.map((text) => {
    const [, far] =
      /(all the way|no further|[\d.]+ m?m)(?:, [\d.]+°)?(?:spoils \d+ panels?)?$/.exec(text) ?? [];
    if (far === "all the way") return Number.POSITIVE_INFINITY;
    return far === "no further"
      ? 0
      : Number.parseFloat(far ?? "") * (far?.endsWith("mm") ? 1 : 1000);
  });
  expect(
    got.every((far) => far >= 0),
    texts.join("\n"),
  ).toBe(true);
  expect(got).toEqual([...got].sort((a, b) => b - a));
  const shared = /^Within the limit(all the way|\d+ mm)/.exec(
    texts.find((text) => text.startsWith("Within")) ?? "",
  );
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  expect(await why.textContent()).toMatch(
    new RegExp(`^Held back at \\d+ of \\d+ mm here, ${shared?.[1]} sharing the bend\\. Dragged on`),
  );
  expect(got[0]).toBe(Number.POSITIVE_INFINITY);
  const first =
    /^(Within the limit|Reach 9 panels|Softer|Folds up to \d+°|Let the boundary move|Meet it exactly)/.exec(
      texts[0] ?? "",
    )?.[1];
  await page.getByRole("button", { name: first ?? "", exact: true }).click();
  await idle(page);
  expect(await page.getByText(/^Panels allow/).count()).toBe(0);
  await page.context().close();
});

it("a way on that gets less far leaves the design as it was; the others get as far as they say", async () => {
  const page = await site.openSmall();
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowUp");
  // On the boundary, where frames get further than an edit of the whole pull.
  for (let k = 0; k < 5; ++k) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  const { x, y } = await middleOf(page, page.locator(".marker:not([hidden])").first());
  await page.keyboard.press("Escape");
  await press(page, { x, y }, ...Array.from({ length: 20 }, (_, k) => ({ x, y: y - 8 * k - 8 })));
  await page.mouse.up();
  await idle(page);
  const [held] = await allowed(page);
  const edited = await exported(page);
  await page.getByRole("button", { name: "Within the limit", exact: true }).click();
  await idle(page);
  await page.getByText(/^Within the limit gets no further: \d+ of \d+ mm\.$/).waitFor();
  expect((await allowed(page))[0]).toBe(held);
  expect((await exported(page)).lines).toEqual(edited.lines);
  const ways = await tried(page);
  expect(await ways.getByRole("button", { name: "Within the limit" }).count()).toBe(0);
  // What keeps the limit says so: its figure is of an edit with the limit.
  const reach = await ways.locator(".way-on", { hasText: "Reach 9 panels" }).allTextContents();
  for (const text of reach) {
    expect(Number(/, ([\d.]+)°/.exec(text)?.[1])).toBeLessThan(31);
  }
  const [first = ""] = await ways.locator(".way-on").allTextContents();
  const [, label = "", far] = /^(.*?)(all the way|[\d.]+ mm)/.exec(first) ?? [];
  await page.getByRole("button", { name: label, exact: true }).click();
  await idle(page);
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  if (far === "all the way") expect(await why.count()).toBe(0);
  else expect((await allowed(page))[0]).toBe(Number.parseFloat(far ?? ""));
  await page.context().close();
});

/** Types a height for the first handle; how far *As far as it goes* says that it gets, and how far a press does. */
async function farthest(z: string): Promise<readonly number[]> {
  const page = await site.openSmall();
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  const field = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton", { name: "Z" });
  await field.first().fill(z);
  await field.first().press("Enter");
  await idle(page);
  const ways = await tried(page);
  const search = page.getByRole("button", { name: "As far as it goes", exact: true });
  const said = await ways.locator(".way-on", { hasText: "As far as it goes" }).textContent();
  await search.click();
  await idle(page);
  expect(await search.count()).toBe(0);
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  const got = /^Panels allow (\d+) (?:mm )?of [\d.]+ m here/.exec((await why.textContent()) ?? "");
  await page.context().close();
  return [/goes(\d+) mm/.exec(said ?? ""), got].map((found) => Number(found?.[1]));
}

it("a typed target of 500 m gets as far as one of 10 m: as far as it goes", async () => {
  const [[nearSaid = 0, near = 0], [farSaid = 0, far = 0]] = [
    await farthest("+10"),
    await farthest("+500"),
  ];
  expect(near).toBeGreaterThan(4000);
  expect(Math.abs(near - far)).toBeLessThan(0.1 * Math.min(near, far));
  expect([nearSaid, farSaid]).toEqual([near, far]);
});
