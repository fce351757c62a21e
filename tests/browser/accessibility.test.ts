// SPDX-License-Identifier: MIT
// Needs: axe.
// axe finds nothing in any state of the page: light and dark, on a desk and on a telephone.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { expectClean } from "./support/axe.ts";
import { flatRoof } from "./support/faults.ts";
import { idle, openFile, typeTarget } from "./support/page.ts";
import { readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";
import { hintedPoint, press } from "./support/view.ts";

const push = (page: Page, name: string): Promise<void> =>
  page.getByRole("button", { name, exact: true }).click();

/** Opens something, looks at it, and closes it. */
async function lookInto(page: Page, name: string): Promise<void> {
  await push(page, name);
  await page.locator("dialog[open], .menu:popover-open").waitFor();
  await idle(page); // what is in it may come later
  await expectClean(page, name);
  await page.keyboard.press("Escape");
}

/** A saddle whose panels are not flat. */
const warped = (): string =>
  flatRoof(6)
    .split("\n")
    .map((line) => {
      const [kind, x, y] = line.split(" ");
      return kind === "v" ? `v ${x} ${y} ${0.05 * Number(x) * Number(y)}` : line;
    })
    .join("\n");

async function editing(page: Page): Promise<void> {
  await expectClean(page, "first visit");
  const at = await hintedPoint(page);
  await press(page, at, { x: at.x, y: at.y - 30 });
  await expectClean(page, "dragging");
  await page.mouse.up();
  await idle(page);
  await typeTarget(page, "+40cm");
  await expectClean(page, "edited");
  for (const name of ["Export", "Share", "Help"]) await lookInto(page, name);
  await page.getByText("Move along the surface").click();
  await page.getByRole("checkbox", { name: "Pinned" }).focus();
  for (const summary of await page.locator("summary").all()) {
    if ((await summary.locator("..").getAttribute("open")) === null) await summary.click();
  }
  await expectClean(page, "everything unfolded");
  await push(page, "Nothing may be in a box");
  await idle(page);
  await expectClean(page, "a keep-out");
  await push(page, "Remove all");
  await idle(page);
}

async function exploring(page: Page): Promise<void> {
  await push(page, "Find variations");
  await page.getByRole("slider", { name: "Variation 1" }).waitFor();
  const gallery = page.getByRole("list", { name: "Gallery of variations" });
  await expect.poll(() => gallery.getAttribute("aria-busy")).toBe("false");
  await page.getByRole("slider", { name: "Variation 1" }).fill("0.5");
  await idle(page);
  await push(page, "Take snapshot");
  await expectClean(page, "variations, gallery and snapshots");
}

async function analysing(page: Page): Promise<void> {
  const colours = page.getByRole("combobox", { name: "Colour by" });
  for (const label of await colours.locator("option").allTextContents()) {
    await colours.selectOption({ label });
    await idle(page);
    await expectClean(page, `coloured by ${label}`, ".legend");
  }
  await page
    .getByRole("button", { name: /Show panel/ })
    .first()
    .click();
  await expectClean(page, "a panel chosen");
}

async function opening(page: Page): Promise<void> {
  await openFile(page, "broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
  await page.getByRole("alert").waitFor();
  await expectClean(page, "a file refused");
  await openFile(page, "warped.obj", warped());
  await page.getByRole("heading", { name: "warped.obj" }).waitFor();
  await expectClean(page, "import report");
  await push(page, "Leave as it is");
  await expectClean(page, "not flat");
}

const SCREENS = {
  desk: { width: 1280, height: 800 },
  telephone: { width: 360, height: 740 },
} as const;

describe.each(["light", "dark"] as const)("in %s", (colorScheme) => {
  it.each(["desk", "telephone"] as const)("nothing is wrong on a %s", async (screen) => {
    const options = { colorScheme, viewport: SCREENS[screen], reducedMotion: "reduce" } as const;
    const page = await site.open(options);
    await editing(page);
    await exploring(page);
    await analysing(page);
    await opening(page);
    await page.context().close();
  });
});

it("forced colours leave tracks of sliders and the scale visible", async () => {
  const page = await site.open({ forcedColors: "active" });
  const track = page.getByRole("slider", { name: "Softness" });
  const width = (await track.boundingBox())?.width ?? 0;
  const slider = await readPng(await track.screenshot());
  const colour = (x: number, y: number): string => slider.at(Math.round(x), y).join(",");
  for (const x of [0.1 * width, 0.9 * width]) {
    expect(colour(x, 12), "the track against what is above it").not.toBe(colour(x, 3));
  }
  const scale = await readPng(await page.locator(".legend-bar").first().screenshot());
  expect(scale.at(4, 4).join(","), "the two ends").not.toBe(scale.at(200, 4).join(","));
  await expectClean(page, "forced colours");
  await page.context().close();
});
