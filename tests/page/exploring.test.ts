// SPDX-License-Identifier: MIT
// Sliders act without a solve and are exact on release; the other order of the directions.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj, worstFlatness } from "../browser/support/obj.ts";
import { idle, obj, showTab, status, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

async function findVariations(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Find variations" }).click();
  const gallery = page.getByRole("list", { name: "Gallery of variations" });
  await expect.poll(() => gallery.getAttribute("aria-busy")).toBe("false");
  await idle(page);
}

/** The slider under the finger: it has moved and is not let go. */
const hold = (page: Page, name: string, value: number): Promise<void> =>
  page.getByRole("slider", { name, exact: true }).evaluate((slider: HTMLInputElement, to) => {
    slider.valueAsNumber = to;
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, value);

const letGo = (page: Page, name: string): Promise<void> =>
  page
    .getByRole("slider", { name, exact: true })
    .dispatchEvent("change")
    .then(() => idle(page));

const worst = async (page: Page): Promise<number> =>
  Number(/worst panel ([\d.]+) mm/.exec(await status(page))?.[1]);

it("a slider shows the worst panel while it moves, and is exact when let go", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+80cm");
  const edited = await obj(page);
  await findVariations(page);
  await hold(page, "Variation 1", 0.3);
  await expect.poll(() => worst(page)).toBeGreaterThan(0);
  const near = await worst(page);
  await hold(page, "Variation 1", 0.9);
  await expect.poll(() => worst(page)).toBeGreaterThan(2 * near);
  expect(await page.getByText(/^Worst panel [\d.]+ mm out of flat/).count()).toBe(1);
  // Nothing was solved: at zero the sliders give the edit again.
  await hold(page, "Variation 1", 0);
  await expect.poll(() => worst(page)).toBe(0);
  await hold(page, "Variation 1", 0.9);
  await expect.poll(() => worst(page)).toBeGreaterThan(0);
  await letGo(page, "Variation 1");
  expect(await worst(page)).toBe(0);
  const varied = await obj(page);
  expect(worstFlatness(readObj(varied))).toBeLessThan(1e-6);
  expect(varied).not.toBe(edited);
  // The whole ride was one step.
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await obj(page)).toBe(edited);
  await page.context().close();
});

it("offers as many directions as asked for, and the smoothest first if wanted", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+80cm");
  await showTab(page, "Explore");
  await page.getByRole("slider", { name: "Number of sliders" }).fill("3");
  await findVariations(page);
  const sliders = page.getByRole("slider", { name: /^Variation \d+$/ });
  expect(await sliders.count()).toBe(3);
  const firstOne = async (): Promise<string> => {
    await hold(page, "Variation 1", 0.5);
    await letGo(page, "Variation 1");
    const text = await obj(page);
    expect(worstFlatness(readObj(text))).toBeLessThan(1e-6);
    return text;
  };
  const local = await firstOne();
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  await page.getByRole("checkbox", { name: "Smoothest slider first" }).check();
  await findVariations(page);
  expect(await sliders.count()).toBe(3);
  expect(await firstOne()).not.toBe(local);
  await page.context().close();
});
