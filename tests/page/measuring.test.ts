// SPDX-License-Identifier: MIT
// What is measured between selected points is what is exported, and can be copied with every digit.
import { expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import { obj, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

it("the box and the levels of the selected points are those of the file, also after an edit", async () => {
  const page = await site.open({ permissions: ["clipboard-read", "clipboard-write"] });
  await typeTarget(page, "+40cm");
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Select in a box" }).click();
  await page.getByRole("button", { name: "Invert", exact: true }).click();
  await page.getByText("Measure", { exact: true }).click();
  await page.getByRole("button", { name: "Copy", exact: true }).click();
  await page.getByText("Copied", { exact: true }).waitFor();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  const values = new Map(copied.split("\n").map((line) => [line.split("\t")[0], line.split("\t")]));
  const highest = Math.max(...readObj(await obj(page)).points.map(([, , z = 0]) => z));
  expect(values.get("Highest")).toEqual(["Highest", String(highest), "m"]);
  expect(await page.getByText("Across x", { exact: true }).isVisible()).toBe(true);
  await page.context().close();
});

it("a point is where the file has it, from a point of one's own, and from where it was", async () => {
  const page = await site.open();
  const before = readObj((await obj(page)).toString()).points;
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowUp");
  await page.getByText("Position", { exact: true }).click();
  const table = page.getByRole("table", { name: /^Position of point/ });
  const vertex = async (): Promise<number> =>
    Number((await table.getAttribute("aria-label"))?.match(/\d+$/)?.[0]);
  const row = (name: string): Promise<number[]> =>
    table
      .getByRole("row", { name })
      .getByRole("cell")
      .allTextContents()
      .then((all) => all.map(Number));
  const origin = await vertex();
  await page.getByRole("button", { name: "Origin here" }).click();
  expect(await row(`From point ${origin}`)).toEqual([0, 0, 0]);
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  expect(await vertex()).not.toBe(origin);
  await typeTarget(page, "+0.35m");
  const after = readObj((await obj(page)).toString()).points;
  const [own, from, was] = [after[await vertex()], after[origin], before[await vertex()]];
  const written = (of: readonly number[] | undefined, to: readonly number[] | undefined) =>
    (of ?? []).map((x, k) => Number((x - (to?.[k] ?? 0)).toFixed(4)) + 0);
  expect(await row("In the file")).toEqual(written(own, [0, 0, 0]));
  expect(await row(`From point ${origin}`)).toEqual(written(own, from));
  expect(await row("Moved by")).toEqual(written(own, was));
  expect((await row("Moved by"))[2]).toBeGreaterThan(0);
  await page.getByRole("button", { name: "Origin of the file" }).click();
  expect(await table.getByRole("row").count()).toBe(3);
  await page.context().close();
});
