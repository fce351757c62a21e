// SPDX-License-Identifier: MIT
// Numbers on the model are those of tables and reports, and only of what is in sight.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { openViewOptions, still } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

interface Label {
  readonly number: number;
  readonly x: number;
  readonly y: number;
}

/** Of those shown, the first nearest to the middle of the view. */
const labels = (page: Page, kind: "panel" | "point"): Promise<Label[]> =>
  page.evaluate(
    (name) =>
      [...document.querySelectorAll(`.numbers .${name}`)].map((element) => {
        const { x, y, width, height } = element.getBoundingClientRect();
        return { number: Number(element.textContent), x: x + width / 2, y: y + height / 2 };
      }),
    kind,
  );

it("are on the panels and points that have them, and on none that is hidden", async () => {
  const viewport = { width: 1600, height: 1100 };
  const page = await site.openVault({ viewport, reducedMotion: "reduce" });
  await page.getByRole("button", { name: "Top", exact: true }).click();
  await openViewOptions(page);
  await page.getByLabel("Number the panels").check();
  await expect.poll(async () => (await labels(page, "panel")).length).toBeGreaterThan(20);
  const [panel] = await labels(page, "panel");
  if (!panel) throw new Error("no panel");
  await page.mouse.click(panel.x, panel.y);
  await page.getByText(`Panel ${panel.number}`, { exact: true }).first().waitFor();

  await page.getByLabel("3D view").focus();
  await page.keyboard.press("h");
  await expect
    .poll(async () => (await labels(page, "panel")).map(({ number }) => number))
    .not.toContain(panel.number);

  await page.getByLabel("Number the panels").uncheck();
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "Command" }).fill("number the points");
  await page.keyboard.press("Enter");
  await expect.poll(async () => (await labels(page, "point")).length).toBeGreaterThan(20);
  expect(await labels(page, "panel")).toEqual([]);
  const [point] = await labels(page, "point");
  if (!point) throw new Error("no point");
  await page.mouse.click(point.x, point.y - 10);
  await page.getByText(`Point ${point.number}`, { exact: true }).first().waitFor();
  await page.context().close();
});

it("of what lies behind are left out, and come when it is turned to", async () => {
  const page = await site.open({ reducedMotion: "reduce" });
  await openViewOptions(page);
  await page.getByLabel("Number the points").check();
  await page.getByRole("button", { name: "Front", exact: true }).click();
  await expect.poll(async () => (await labels(page, "point")).length).toBeGreaterThan(5);
  const front = new Set((await labels(page, "point")).map(({ number }) => number));
  await page.getByLabel("3D view").focus();
  for (let k = 0; k < 30; ++k) await page.keyboard.press("Shift+ArrowRight");
  await still(page);
  const turned = (await labels(page, "point")).map(({ number }) => number);
  expect(turned.filter((number) => !front.has(number)).length).toBeGreaterThan(5);
  expect([...front].filter((number) => !turned.includes(number)).length).toBeGreaterThan(5);
  await page.context().close();
});
