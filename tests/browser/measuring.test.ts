// SPDX-License-Identifier: MIT
// What is measured between selected points is what is exported, and can be copied with every digit.
import { expect, it } from "vitest";
import { readObj } from "./support/obj.ts";
import { obj, typeTarget } from "./support/page.ts";
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
