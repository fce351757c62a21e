// SPDX-License-Identifier: MIT
// Needs: pixels.
// Sliders act without a solve and are exact on release; the other order of the directions.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, typeTarget } from "./support/page.ts";
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

/** How far apart neighbouring pictures of the gallery are: mean over all pixels, share of the range. */
const tileDifferences = (page: Page): Promise<number[]> =>
  page.locator(".tiles canvas").evaluateAll((all) => {
    const pictures = all.map((one) => {
      const { width, height } = one as HTMLCanvasElement;
      const paper = new OffscreenCanvas(width, height).getContext("2d");
      if (!paper) return new Uint8ClampedArray(0);
      paper.fillStyle = "white";
      paper.fillRect(0, 0, width, height);
      paper.drawImage(one as HTMLCanvasElement, 0, 0);
      return paper.getImageData(0, 0, width, height).data.filter((_, k) => k % 4 < 3);
    });
    return pictures.slice(1).map((picture, k) => {
      const sum = picture.reduce((s, x, i) => s + Math.abs(x - (pictures[k]?.[i] ?? 0)), 0);
      return sum / picture.length / 255;
    });
  });

it("says what sliders do and where they stop, and shows the design that is pointed at", async () => {
  const page = await site.open({ draws: true });
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  await typeTarget(page, "+50cm");
  await findVariations(page);
  const about = page.getByText(/^To the right point \d+ moves most, /);
  expect(await about.count()).toBe(4);
  await expect.poll(() => page.getByText("Stopped by panel").count()).toBeGreaterThan(0);
  const stopped = page.getByRole("button", { name: /which stops it$/ }).first();
  const panel = await stopped.textContent();
  await stopped.click();
  await page.getByText(new RegExp(`^Panel ${panel} 4 corners`)).waitFor();
  const hatched = page.locator(".slider-stops span");
  const widths = (): Promise<string> =>
    hatched.evaluateAll((all) => all.map((one) => (one as HTMLElement).style.width).join());
  const before = await widths();
  await hold(page, "Variation 1", 0.3);
  await expect.poll(widths).not.toBe(before);
  await hold(page, "Variation 1", 0);
  await letGo(page, "Variation 1");
  const view = page.getByLabel("3D view");
  const apart = await tileDifferences(page);
  expect(apart.length).toBeGreaterThan(5);
  expect(Math.min(...apart)).toBeGreaterThan(0.05);
  await page.mouse.move(5, 5);
  const own = await view.screenshot();
  const tile = page.getByRole("button", { name: /^Adopt design 1/ });
  await tile.hover();
  await expect.poll(async () => (await view.screenshot()).equals(own)).toBe(false);
  // Under each how far it is from the edit; where and which way tells them apart.
  for (const words of await page.locator(".tile-figures").allTextContents())
    expect(words).toMatch(/^[+−][\d.]+ mm$/);
  const said = await page
    .locator(".tiles button.tile")
    .evaluateAll((all) => all.map((one) => one.getAttribute("title") ?? ""));
  for (const words of said)
    expect(words).toMatch(
      /from the edit [\d.]+ mm at point \d+, .* fold [\d.]+° \(was [\d.]+°\), \d+ panels to make again/,
    );
  expect(new Set(said).size).toBe(said.length);
  await page.context().close();
});
