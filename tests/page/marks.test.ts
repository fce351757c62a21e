// SPDX-License-Identifier: MIT
// What the view says about points: under the pointer, chosen, and where a handle came from.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import {
  idle,
  movedCount,
  openAdvanced,
  showTab,
  status,
  typeTarget,
} from "../browser/support/page.ts";
import { hintedPoint, press, viewBox } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

it("every slider says its value with its unit", async () => {
  const page = await site.openVault();
  await openAdvanced(page);
  const spoken = (name: string) =>
    page.getByRole("slider", { name, exact: true }).getAttribute("aria-valuetext");
  expect(await spoken("Locality")).toBe(
    "1.0 times the default weight: from more points follow to fewer follow",
  );
  expect(await spoken("Smoothness")).toBe(
    "1.0 times the default weight: from sharp, close by to gentle, wider",
  );
  await showTab(page, "Explore");
  expect(await spoken("Number of sliders")).toMatch(/^4 directions: /);
  await page.getByRole("slider", { name: "Number of sliders" }).fill("1");
  await expect.poll(() => spoken("Number of sliders")).toMatch(/^1 direction: /);
  await page.getByRole("slider", { name: "Number of sliders" }).fill("3");
  await typeTarget(page, "+40cm");
  await page.getByRole("button", { name: "Find variations" }).click();
  await idle(page);
  const sliders = page.getByRole("slider", { name: /^Variation \d+$/ });
  await expect.poll(() => sliders.count()).toBeGreaterThan(0);
  for (const slider of await sliders.all())
    expect(await slider.getAttribute("aria-valuetext")).toBe("0 mm");
  const first = sliders.first();
  await first.fill("0.5");
  await first.dispatchEvent("change");
  await idle(page);
  expect(await first.getAttribute("aria-valuetext")).toMatch(/^\+[\d.]+ mm$/);
  const all = await page.getByRole("slider").all();
  for (const slider of all)
    expect(await slider.getAttribute("aria-valuetext")).toMatch(
      /^(?:[+−]?[\d.]+ (mm|m|times|directions?|panels?|of 10)|no limit|by the raw weights)\b/,
    );
  await page.context().close();
});

it("Share puts the link itself on the clipboard", async () => {
  const page = await site.openVault({ permissions: ["clipboard-read", "clipboard-write"] });
  await typeTarget(page, "+40cm");
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(link);
  expect(await page.getByText(`Copied: ${link.length} characters.`).count()).toBe(1);
  expect(link.startsWith(`${site.url}#v2=`)).toBe(true);
  await page.context().close();
});

/** The figure beside the point looked at; "" if there is none. */
const pointFigure = async (page: Page): Promise<string> => {
  const found = page.getByText(/^Point \d+ (moved|untouched|bends|smooth)/);
  return (await found.count()) > 0 ? ((await found.first().textContent()) ?? "") : "";
};

describe("the pointer on a point", () => {
  it("marks it and says its figure; beside the model neither", async () => {
    const page = await site.openVault();
    const at = await hintedPoint(page);
    const { x, y, height } = await viewBox(page);
    const beside = { x: x + 20, y: y + height / 2 };
    await page.mouse.move(beside.x, beside.y);
    const cursor = () => page.getByLabel("3D view").evaluate((view) => view.style.cursor);
    expect(await cursor()).toBe("");
    expect(await pointFigure(page)).toBe("");
    await page.mouse.move(at.x, at.y);
    await expect.poll(() => pointFigure(page)).toMatch(/^Point \d+ untouched$/);
    expect(await cursor()).toBe("grab");
    await page.mouse.move(beside.x, beside.y);
    await expect.poll(() => pointFigure(page)).toBe("");
    expect(await cursor()).toBe("");
    await page.context().close();
  });

  it("leaves it when a box is drawn from there, before the box is done", async () => {
    const page = await site.openVault();
    const at = await hintedPoint(page);
    await page.mouse.move(at.x, at.y);
    await expect.poll(() => pointFigure(page)).toMatch(/^Point \d+ untouched$/);
    await page.keyboard.down("Shift");
    await press(page, at, { x: at.x + 6, y: at.y - 6 });
    await expect.poll(() => pointFigure(page)).toBe("");
    await page.mouse.up();
    await page.keyboard.up("Shift");
    await page.context().close();
  });

  it("and a chosen point: the figure follows the drag, and the colours' meaning", async () => {
    const page = await site.openVault({ size: 21 });
    const at = await hintedPoint(page);
    await press(page, at, { x: at.x, y: at.y - 50 });
    const largest = async (): Promise<string> =>
      /largest ([\d.]+ m?m)/.exec(await status(page))?.[1] ?? "";
    await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
    await expect
      .poll(
        async () =>
          (await pointFigure(page)).split(",")[0] === `Point 220 moved ${await largest()}`,
      )
      .toBe(true);
    await page.mouse.up();
    await idle(page);
    const moved = `Point 220 moved ${await largest()}`;
    expect(await pointFigure(page)).toMatch(new RegExp(`^${moved}, raised [\\d.]+ m?m$`));
    await page.getByRole("combobox", { name: "Colour by" }).selectOption("Slide");
    await expect.poll(() => pointFigure(page)).toMatch(/, slid [\d.]+ m?m$/);
    await page.getByRole("combobox", { name: "Colour by" }).selectOption("Displacement");
    await expect.poll(() => pointFigure(page)).toBe(moved);
    await page.getByRole("combobox", { name: "Colour by" }).selectOption("Fairness");
    await expect.poll(() => pointFigure(page)).toMatch(/^Point 220 bends [\d.]+ m?m$/);
    await page.context().close();
  });
});

it("Before and the key B show the base while held", async () => {
  const page = await site.open();
  const at = await hintedPoint(page);
  await press(page, at, { x: at.x, y: at.y - 60 });
  await page.mouse.up();
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  await showTab(page, "Check and make");
  const before = page.getByRole("button", { name: "Before" });
  await page.getByLabel("3D view").focus();
  await page.keyboard.down("b");
  await expect.poll(() => before.getAttribute("aria-pressed")).toBe("true");
  await page.keyboard.up("b");
  await expect.poll(() => before.getAttribute("aria-pressed")).toBe("false");
  await before.focus();
  await page.keyboard.down("Space");
  expect(await before.getAttribute("aria-pressed")).toBe("true");
  await page.keyboard.up("Space");
  expect(await before.getAttribute("aria-pressed")).toBe("false");
  await page.context().close();
});
