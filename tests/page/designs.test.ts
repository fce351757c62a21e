// SPDX-License-Identifier: MIT
// A design is data: every step can be undone, kept under a name, adopted from the gallery.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj, worstFlatness } from "../browser/support/obj.ts";
import {
  idle,
  movedCount,
  obj,
  openAdvanced,
  openFile,
  showTab,
  status,
  typeTarget,
} from "../browser/support/page.ts";
import { site } from "./support/site.ts";

const press = async (page: Page, name: string): Promise<void> => {
  await page.getByRole("button", { name, exact: true }).click();
  await idle(page);
};

async function findVariations(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Find variations" }).click();
  const gallery = page.getByRole("list", { name: "Gallery of variations" });
  await expect.poll(() => gallery.getAttribute("aria-busy")).toBe("false");
  await idle(page);
}

async function slide(page: Page, name: string, value: string): Promise<void> {
  await page.getByRole("slider", { name, exact: true }).fill(value);
  await idle(page);
}

/** Twice as tall as it is long, one quad pushed out of flat. */
const BENT = "v 0 0 0\nv 2 0 0\nv 2 2 0.3\nv 0 2 0\nv 4 0 0\nv 4 2 0\nf 1 2 3 4\nf 2 5 6 3\n";

it("undoes and redoes every kind of step to the same bits", async () => {
  const page = await site.openVault();
  const seen: string[] = [await obj(page)];
  const step = async (act: () => Promise<unknown>): Promise<void> => {
    await act();
    await idle(page);
    seen.push(await obj(page));
  };
  await openAdvanced(page);
  await step(() => typeTarget(page, "+60cm"));
  await step(() => slide(page, "Locality", "3"));
  await step(() => page.getByRole("checkbox", { name: "Pinned" }).check());
  await step(() => page.getByRole("checkbox", { name: "Pinned" }).uncheck());
  await step(() => findVariations(page));
  await step(() => slide(page, "Variation 2", "0.4"));
  await step(() => page.getByRole("button", { name: /^Adopt design 4/ }).click());
  await step(() => openFile(page, "bent.obj", BENT));
  await step(() => page.getByRole("button", { name: "Planarise" }).last().click());
  await step(() => page.getByRole("combobox", { name: "Sample" }).selectOption("Dome"));
  // Add handle is a step of its own.
  const steps = seen.length;
  for (let k = seen.length - 2; k > 0; --k) {
    await press(page, "Undo");
    expect(await obj(page), `undo to step ${k}`).toBe(seen[k]);
  }
  for (let k = 2; k < steps; ++k) {
    await press(page, "Redo");
    expect(await obj(page), `redo to step ${k}`).toBe(seen[k]);
  }
  expect(await page.getByRole("button", { name: "Redo" }).isDisabled()).toBe(true);
  await page.context().close();
});

it("shows exact designs in a gallery; Enter adopts one as one step", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+80cm");
  await findVariations(page);
  const centre = await obj(page);
  const tiles = page.getByRole("button", { name: /^Adopt design \d/ });
  expect(await tiles.count()).toBeGreaterThanOrEqual(6);
  for (const k of [0, 5]) {
    const tile = tiles.nth(k);
    const title = (await tile.getAttribute("title")) ?? "";
    const [, points, length] = /(\d+) points move, largest ([\d.]+ mm)/.exec(title) ?? [];
    expect(title).toMatch(/\d+ panels? to make again/);
    // The name is short; the rest is its description, and stands under the tiles for a finger.
    const figure = await tile.locator(".tile-figures").textContent();
    const name = await tile.locator(".visually-hidden").textContent();
    expect(name).toBe(`Adopt design ${k + 1}, ${figure}`);
    await tile.focus();
    await page.getByText(`Design ${k + 1}: ${title}.`, { exact: true }).waitFor();
    await page.keyboard.press("Enter");
    await idle(page);
    expect(await tile.getAttribute("aria-pressed")).toBe("true");
    expect(await status(page)).toContain(`${points} of 225 points move · largest ${length}`);
    expect(worstFlatness(readObj(await obj(page)))).toBeLessThan(1e-6);
    await press(page, "Undo");
    expect(await obj(page)).toBe(centre);
  }
  await page.context().close();
});

it("takes, renames, adopts and deletes snapshots by keyboard", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+50cm");
  const first = await obj(page);
  await showTab(page, "Explore");
  const take = page.getByRole("button", { name: "Take snapshot" });
  await take.focus();
  await page.keyboard.press("Enter");
  const name = page.getByRole("textbox", { name: "Name of Snapshot 1" });
  await name.focus();
  await name.fill("Low roof");
  await page.keyboard.press("Enter");
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
  await idle(page);
  const dome = await obj(page);
  const adopt = page.getByRole("button", { name: "Adopt Low roof" });
  await adopt.focus();
  await page.keyboard.press("Enter");
  await idle(page);
  expect(await obj(page)).toBe(first);
  expect(await adopt.getAttribute("aria-pressed")).toBe("true");
  await press(page, "Undo");
  expect(await obj(page)).toBe(dome);
  await page.getByRole("button", { name: "Delete Low roof" }).focus();
  await page.keyboard.press("Enter");
  expect(await adopt.count()).toBe(0);
  expect(await movedCount(page)).toBe(0);
  await page.context().close();
});

it("keeps the sliders through undo and redo", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+70cm");
  await findVariations(page);
  const slider = page.getByRole("slider", { name: "Variation 1", exact: true });
  await slide(page, "Variation 1", "0.5");
  const varied = await obj(page);
  await press(page, "Undo");
  await press(page, "Undo");
  expect(await slider.count()).toBe(0);
  await press(page, "Redo");
  await press(page, "Redo");
  expect(await slider.inputValue()).toBe("0.5");
  await slide(page, "Variation 1", "-0.25");
  await slide(page, "Variation 1", "0.5");
  expect(await obj(page)).toBe(varied);
  await page.context().close();
});
