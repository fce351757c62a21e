// SPDX-License-Identifier: MIT
// The page says why something cannot be done, what is selected, and what is being looked at.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, openFile, status, typeTarget } from "../browser/support/page.ts";
import { hintedPoint, press, viewBox } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

/** One bent quad in the middle of the view, and a flat one beside it. */
const BENT = "v 0 0 0\nv 2 0 0\nv 2 2 0.3\nv 0 2 0\nv 4 0 0\nv 4 2 0\nf 1 2 3 4\nf 2 5 6 3\n";

const REASON = "First planarise it, or edit it as it is.";

/** Where a point of the model is under the pointer. */
async function somePoint(page: Page): Promise<{ x: number; y: number }> {
  const { x, y, width, height } = await viewBox(page);
  const cursor = () =>
    page.getByLabel("3D view").evaluate((canvas: HTMLElement) => canvas.style.cursor);
  for (let row = 0.2; row < 0.8; row += 0.03)
    for (let column = 0.1; column < 0.9; column += 0.03) {
      const place = { x: x + column * width, y: y + row * height };
      await page.mouse.move(place.x, place.y);
      if ((await cursor()) === "grab") return place;
    }
  throw new Error("no point in view");
}

it("a mesh that is not flat says why no point moves", async () => {
  const page = await site.open();
  await openFile(page, "bent.obj", BENT);
  await page.getByRole("button", { name: "Not now" }).click();
  const add = page.getByRole("button", { name: "Add handle" });
  expect(await add.isDisabled()).toBe(true);
  expect(await add.getAttribute("aria-description")).toBe(REASON);
  const said = page.getByText(REASON, { exact: true }).filter({ visible: true });
  expect(await said.count()).toBe(1);
  const at = await somePoint(page);
  await press(page, at, { x: at.x, y: at.y - 40 });
  await page.mouse.up();
  await expect.poll(() => said.count()).toBe(2);
  expect(await status(page)).toContain("0 of 6 points move");
  await page.getByRole("button", { name: "Planarise" }).click();
  await idle(page);
  expect(await said.count()).toBe(0);
  expect(await add.isDisabled()).toBe(false);
  await page.context().close();
});

it("arrow keys announce the point, and the first sentence gives way to it", async () => {
  const page = await site.open();
  const sentence = page.getByText("Drag this point");
  await sentence.waitFor();
  const live = page.locator("p[aria-live=polite]");
  await live.waitFor({ state: "attached" });
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => live.textContent()).toMatch(/^Point \d+ selected, untouched$/);
  const first = await live.textContent();
  await page.keyboard.press("ArrowRight");
  await expect.poll(() => live.textContent()).toMatch(/^Point \d+ selected, untouched$/);
  expect(await live.textContent()).not.toBe(first);
  await expect.poll(() => sentence.isVisible()).toBe(false);
  await page.keyboard.press("Control+ArrowRight");
  await expect.poll(() => live.textContent()).toMatch(/^2 points selected, the last is point \d+$/);
  await page.context().close();
});

it("a lock chosen in a drag ends with it, one chosen before ends with the mesh", async () => {
  const page = await site.open();
  const held = (name: string) =>
    page.getByRole("button", { name, exact: true }).getAttribute("aria-pressed");
  const at = await hintedPoint(page);
  await press(page, at, { x: at.x, y: at.y - 10 });
  await page.keyboard.press("z");
  await expect.poll(() => held("Lock to Z")).toBe("true");
  await page.mouse.move(at.x, at.y - 30);
  await page.mouse.up();
  await idle(page);
  expect(await held("Lock to Z")).toBe("false");
  await page.getByRole("button", { name: "Lock to X", exact: true }).click();
  await page.getByRole("slider", { name: "Reach" }).fill("4");
  await idle(page);
  expect(await held("Lock to X")).toBe("true");
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
  await idle(page);
  expect(await held("Lock to X")).toBe("false");
  await page.context().close();
});

it("says why a drag towards the viewer moves nothing", async () => {
  const page = await site.open({ reducedMotion: "reduce" });
  await page.getByRole("button", { name: "Top", exact: true }).click();
  await page.getByRole("button", { name: "Lock to Z", exact: true }).click();
  const place = await hintedPoint(page);
  await press(page, place, { x: place.x, y: place.y - 40 });
  const said = page.getByText("This direction points at you");
  await said.waitFor();
  await page.keyboard.press("x");
  await page.mouse.move(place.x + 30, place.y - 40);
  await expect.poll(() => said.count()).toBe(0);
  await page.mouse.up();
  await idle(page);
  expect(await status(page)).not.toContain("0 of 425 points move");
  await page.context().close();
});

it("says that the base is shown while B is held", async () => {
  const page = await site.open();
  await typeTarget(page, "+40cm");
  const note = page.getByText("Before the edit", { exact: true });
  await page.getByLabel("3D view").focus();
  await page.keyboard.down("b");
  await note.waitFor();
  await page.keyboard.up("b");
  await expect.poll(() => note.count()).toBe(0);
  await page.context().close();
});
