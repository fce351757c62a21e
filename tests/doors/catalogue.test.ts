// SPDX-License-Identifier: MIT
// The catalogue of a sweep as whoever has the wheel makes it: opened from the disk, brushed, and left
// by a link that opens a design in the editor.
import { execFileSync } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { launch } from "../../.tools/page/browser.mjs";
import { expectClean } from "../browser/support/axe.ts";
import { drawNothing } from "../browser/support/drawing.ts";
import { idle, movedCount, status } from "../browser/support/page.ts";
import { site } from "../browser/support/site.ts";
import { PYTHON, ROOT } from "./support/places.ts";

const PLAN = {
  design: {
    format: "planish-design",
    version: 1,
    source: { sample: "vault", size: 12 },
    handles: [[78, 6, 6, 4]],
    options: { shape: true },
  },
  values: {
    "handles[0].by[2]": { from: 0.1, to: 0.8, count: 4 },
    "options.softness": [2, 5, 8],
    "options.keep_boundary": [true, false],
  },
};

let folder = "";
let browser: Awaited<ReturnType<typeof launch>>;
beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "planish-catalogue-"));
  const at = (name: string): string => join(folder, name);
  writeFileSync(at("plan.json"), JSON.stringify(PLAN));
  const sweep = ["sweep", at("plan.json"), "--part=1/1", "-o", at("out")];
  execFileSync(join(ROOT, "build/native/planish"), sweep);
  const make = ["-m", "planish", "catalogue", at("out"), "-o", at("catalogue")];
  execFileSync(PYTHON, [...make, "--page", site.url, "--title", "A vault, raised"]);
  browser = await launch();
});
afterAll(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

type Options = Parameters<typeof browser.newContext>[0];

async function open(options: Options = {}): Promise<Page> {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 900 },
    reducedMotion: "reduce",
    ...options,
  });
  await drawNothing(context);
  const page = await context.newPage();
  page.on("pageerror", (error) => expect.soft(error.message).toBe(""));
  await page.goto(`file://${folder}/catalogue/index.html`);
  await page.getByRole("heading", { name: "A vault, raised" }).waitFor();
  return page;
}

/** How many of the 24 designs are left. */
const left = async (page: Page): Promise<number> =>
  Number(/^(\d+) of 24 designs$/.exec(await status(page))?.[1] ?? Number.NaN);

it("a folder of plain files opens from the disk, with a picture, figures and a link each", async () => {
  expect(readdirSync(join(folder, "catalogue/pictures"))).toHaveLength(24);
  const page = await open();
  expect(await left(page)).toBe(24);
  const cards = page.getByRole("list", { name: "Designs" }).getByRole("listitem");
  expect(await cards.count()).toBe(24);
  const picture = cards.first().locator("img");
  await expect
    .poll(() => picture.evaluate((image) => (image as HTMLImageElement).naturalWidth))
    .toBeGreaterThan(100);
  expect(await cards.first().textContent()).toMatch(/softness[258].*points moved\d+/);
  await page.context().close();
});

it("brushing an axis leaves the designs on it, and the fields say so", async () => {
  const page = await open();
  const box = await page
    .getByRole("img", { name: /^Parallel axes: lift of handle 1, z/ })
    .boundingBox();
  if (!box) throw new Error("there is no chart");
  const x = box.x + 64; // the first axis, from 0.1 below to 0.8 above
  await page.mouse.move(x, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(x, box.y + 100, { steps: 4 });
  await page.mouse.move(x, box.y + 150, { steps: 4 });
  await page.mouse.up();
  await expect.poll(() => left(page)).toBe(6); // of 0.1, 0.33, 0.57 and 0.8
  const from = page.getByRole("spinbutton", { name: "lift of handle 1, z, from" });
  const brushed = Number(await from.inputValue());
  expect(brushed).toBeGreaterThan(0.34);
  expect(brushed).toBeLessThan(0.56);
  await page.getByRole("button", { name: "Show all" }).click();
  await expect.poll(() => left(page)).toBe(24);
  await page.context().close();
});

it("the keyboard brushes by fields, chooses words and sorts", async () => {
  const page = await open();
  await page.getByRole("spinbutton", { name: "softness, from" }).focus();
  await page.keyboard.type("5");
  await page.keyboard.press("Tab");
  await expect.poll(() => left(page)).toBe(16);
  await page.getByRole("combobox", { name: "keep boundary" }).selectOption("true");
  await expect.poll(() => left(page)).toBe(8);
  await page
    .getByRole("combobox", { name: "Sort by" })
    .selectOption({ label: "lift of handle 1, z" });
  await page.getByRole("checkbox", { name: "largest first" }).check();
  const first = page.getByRole("list", { name: "Designs" }).getByRole("listitem").first();
  expect(await first.textContent()).toContain("lift of handle 1, z0.8");
  await page.context().close();
});

it("a design opens in the editor, which verifies it", async () => {
  const page = await open();
  const card = page.getByRole("list", { name: "Designs" }).getByRole("listitem").first();
  const moved = Number(/points moved(\d+)/.exec((await card.textContent()) ?? "")?.[1]);
  const link = card.getByRole("link", { name: /^Open in the editor: [0-9a-f]{8}$/ });
  const editor = await site.open({}, new URL((await link.getAttribute("href")) ?? "").hash);
  await idle(editor);
  await editor.getByText(/^(Verified|Replayed: recomputed here).*/).waitFor();
  expect(await movedCount(editor)).toBe(moved);
  await editor.context().close();
  await link.focus();
  await page.keyboard.press("Enter");
  await page.waitForURL(/\/under\/a\/path\/#v2=/);
  await page.context().close();
});

it("a link that was changed on the way is refused in words", async () => {
  const page = await open();
  const href = await page
    .getByRole("link", { name: /^Open in the editor/ })
    .first()
    .getAttribute("href");
  const hash = new URL(href ?? "").hash;
  const half = Math.floor(hash.length / 2);
  const turned = hash.slice(0, half) + (hash[half] === "A" ? "B" : "A") + hash.slice(half + 1);
  for (const [damaged, words] of [
    [turned, /damaged: part of it is missing or was changed/],
    [hash.slice(0, -9), /damaged/],
    [hash.replace("#v2=", "#v7="), /This link is of version 7/],
  ] as const) {
    const editor = await site.open({}, damaged);
    await idle(editor);
    expect(await editor.getByRole("alert").textContent()).toMatch(words);
    expect(await status(editor)).toMatch(/0 of 425 points move/);
    await editor.context().close();
  }
  await page.context().close();
});

const SCREENS = [
  ["light", 1280],
  ["dark", 1280],
  ["light", 360],
  ["dark", 360],
] as const;
it.each(SCREENS)("axe finds nothing in %s at %i pixels", async (colorScheme, width) => {
  const page = await open({ colorScheme, viewport: { width, height: 740 } });
  await expectClean(page, "all designs");
  await page.getByRole("spinbutton", { name: "softness, from" }).fill("5");
  await page.getByRole("combobox", { name: "Sort by" }).selectOption("softness");
  await expectClean(page, "some designs, sorted");
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(
    width,
  );
  await page.context().close();
});
