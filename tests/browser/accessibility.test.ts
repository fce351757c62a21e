// SPDX-License-Identifier: MIT
// Needs: axe.
// axe finds nothing in any state of the page: light and dark, on a desk and on a telephone.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { expectClean, expectReadable } from "./support/axe.ts";
import { flatRoof } from "./support/faults.ts";
import {
  idle,
  openFile,
  openLastSolve,
  openRule,
  openViewOptions,
  showTab,
  typeTarget,
} from "./support/page.ts";
import { readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";
import { hintedPoint, press } from "./support/view.ts";

type Scheme = "light" | "dark";

/** The colours in which each page was opened. */
const schemes = new WeakMap<Page, Scheme>();

/** Everything in the page's own colours, and what depends on colours in the others. */
async function look(page: Page, state: string): Promise<void> {
  const own = schemes.get(page) ?? "light";
  const other = own === "light" ? "dark" : "light";
  await expectClean(page, `${state} in ${own}`);
  await page.emulateMedia({ colorScheme: other });
  await expectReadable(page, `${state} in ${other}`);
  await page.emulateMedia({ colorScheme: own });
}

const push = (page: Page, name: string): Promise<void> =>
  page.getByRole("button", { name, exact: true }).click();

/** Opens something, looks at it, and closes it. */
async function lookInto(page: Page, name: string): Promise<void> {
  await push(page, name);
  await page.locator("dialog[open], .menu:popover-open").waitFor();
  await idle(page); // what is in it may come later
  await expectClean(page, name, "dialog[open], .menu:popover-open");
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
  await look(page, "first visit");
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
  for (const summary of await page.locator("summary").filter({ visible: true }).all()) {
    if ((await summary.locator("..").getAttribute("open")) === null) await summary.click();
  }
  await look(page, "everything unfolded");
  for (const name of ["Limits", "Supports", "Symmetry", "Keep-outs"]) {
    await openRule(page, name);
    await expectClean(page, name, ".rules");
  }
  await push(page, "Nothing may be in a box");
  await idle(page);
  await expectClean(page, "a keep-out", "aside");
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
  await look(page, "variations, gallery and snapshots");
  await openLastSolve(page);
  await expectClean(page, "the panels", "aside");
}

async function analysing(page: Page): Promise<void> {
  const colours = page.getByRole("combobox", { name: "Colour by" });
  for (const label of await colours.locator("option").allTextContents()) {
    await colours.selectOption({ label });
    await idle(page);
    await expectClean(page, `coloured by ${label}`, ".legend");
  }
  await showTab(page, "Check and make");
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
  await look(page, "import report");
  await push(page, "Not now");
  await expectClean(page, "not flat");
}

/** A group and a view that are kept under names. */
async function naming(page: Page): Promise<void> {
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowUp");
  await showTab(page, "Edit");
  await push(page, "Group points");
  await page.getByRole("textbox", { name: "Name of Group 1" }).waitFor();
  await openViewOptions(page);
  await push(page, "Keep this view");
  await page.getByRole("textbox", { name: "Name of View 1" }).waitFor();
  await expectClean(page, "with a group and a named view", "main");
  await push(page, "View options");
}

/** The palette, by touch where there is one. */
async function commanding(page: Page): Promise<void> {
  await push(page, "Help");
  await push(page, "All commands");
  const field = page.getByRole("combobox", { name: "Command" });
  await field.waitFor();
  await idle(page);
  await expectClean(page, "the palette", "dialog[open]");
  await field.fill("sample: dome");
  await expectClean(page, "a few letters", "dialog[open]");
  await page.keyboard.press("Escape");
}

/** The tool that cuts, one cut made and one refused. */
async function cutting(page: Page): Promise<void> {
  await push(page, "Start cutting");
  const tool = page.getByRole("region", { name: "Cut panels" });
  const numbers = tool.getByRole("textbox").first();
  await tool.getByRole("button", { name: "Corner", exact: true }).click();
  await numbers.fill("0:0");
  await numbers.press("Enter");
  await idle(page);
  await numbers.fill("0:999");
  await tool.getByText("corner=0:999: panel 0 has no corner 999.").waitFor();
  await look(page, "cutting");
  await tool.getByRole("button", { name: "Refine" }).click();
  await expectClean(page, "refining", ".cut-strip");
  await push(page, "Stop cutting");
}

/** What is looked at in one page, one after the other. */
const WALKS = [
  ["editing and exploring", [editing, exploring]],
  [
    "figures, names, commands and files",
    [(page: Page) => typeTarget(page, "+40cm"), analysing, naming, commanding, cutting, opening],
  ],
] as const;

describe.each([
  ["desk", "light", 1280, 800],
  ["telephone", "dark", 360, 740],
] as const)(
  "on a %s, whatever the colours, nothing is wrong with",
  (_, colorScheme, width, height) => {
    it.each(WALKS)("%s", async (_name, parts) => {
      const page = await site.open({ colorScheme, viewport: { width, height } });
      schemes.set(page, colorScheme);
      for (const part of parts) await part(page);
      await page.context().close();
    });
  },
);

/** 1280 × 800 at 200 %, and as narrow as WCAG's reflow asks for. */
const SMALL = [
  ["200 %", { width: 640, height: 400 }],
  ["320 px", { width: 320, height: 640 }],
] as const;

it("forced colours leave tracks of sliders and the scale visible; an edit at 200 % and 320 px has no fault and is no wider than the window", async () => {
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
  await typeTarget(page, "+40cm");
  for (const [name, viewport] of SMALL) {
    await page.setViewportSize(viewport);
    await idle(page);
    await expectClean(page, `edited in forced colours at ${name}`);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    expect(wide, `at ${name}`).toBeLessThanOrEqual(viewport.width);
    await page.emulateMedia({ forcedColors: "none" });
    await expectClean(page, `edited at ${name}`);
    await page.emulateMedia({ forcedColors: "active" });
  }
  await page.context().close();
});
