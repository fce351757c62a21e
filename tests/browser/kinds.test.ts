// SPDX-License-Identifier: MIT
// Circular panels, kept by the edits of a mesh that has them; designs and links carry that.
import { expect, it } from "vitest";
import {
  exportAs,
  idle,
  movedCount,
  obj,
  openAdvanced,
  openFile,
  status,
  typeTarget,
} from "./support/page.ts";
import { site } from "./support/site.ts";

const CIRCULAR = "Keep panels circular";

it("a mesh of circular panels offers to keep them so, and a design says that it does", async () => {
  const page = await site.open();
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
  await idle(page);
  const circular = page.getByRole("checkbox", { name: CIRCULAR });
  expect(await circular.isChecked()).toBe(false);
  await typeTarget(page, "+30cm");
  const free = await obj(page);
  await circular.check();
  await idle(page);
  const kept = await obj(page);
  expect(kept).not.toBe(free);
  expect(await movedCount(page)).toBeGreaterThan(0);
  await page.getByText("Last solve", { exact: true }).click();
  await page.getByText("Worst, of circular", { exact: true }).waitFor();
  const text = (await exportAs(page, "JSON")).toString();
  expect(JSON.parse(text).options.constraints).toEqual([{ kind: "circular", tolerance: 1e-9 }]);
  await circular.uncheck();
  await idle(page);
  expect(await obj(page)).toBe(free);
  await openFile(page, "circular.json", text);
  await page.getByText(/^Verified:/).waitFor();
  expect(await circular.isChecked()).toBe(true);
  expect(await obj(page)).toBe(kept);
  // On a mesh that is not so it would refuse every edit: the mesh itself becomes so first.
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  await openAdvanced(page);
  expect(await circular.isChecked()).toBe(false);
  expect(await circular.isEnabled()).toBe(false);
  await page
    .getByText(/^The mesh misses it by up to \d+°/)
    .first()
    .waitFor();
  const colours = page.getByRole("combobox", { name: "Colour by" });
  await colours.selectOption("Circular");
  await page.getByText(/^\d+ panels miss it, \d+ circular$/).waitFor();
  const table = page.getByRole("table", { name: "Panels" });
  const worst = () => table.getByRole("row").nth(1).getByRole("cell").first().innerText();
  await table.getByRole("columnheader", { name: "Circular" }).getByRole("button").click();
  await expect.poll(async () => Number(await worst())).toBeGreaterThan(1);
  await page.getByRole("button", { name: "Make panels circular" }).click();
  await idle(page);
  await expect.poll(worst).toBe("0");
  await expect.poll(() => circular.isChecked()).toBe(true);
  await expect.poll(() => status(page)).toMatch(/planarised first: \d+ points moved by up to/);
  await page.getByText(/^0 panels miss it, \d+ circular$/).waitFor();
  const base = await obj(page);
  await typeTarget(page, "+30cm");
  expect(await movedCount(page)).toBeGreaterThan(0);
  const made = (await exportAs(page, "JSON")).toString();
  expect(JSON.parse(made).planarised.constraints).toEqual([{ kind: "circular", tolerance: 1e-9 }]);
  const edited = await obj(page);
  expect(edited).not.toBe(base);
  await openFile(page, "made.json", made);
  await page.getByText(/^Verified:/).waitFor();
  expect(await obj(page)).toBe(edited);
  // Variations keep it, too: what a slider leaves is circular to the same tolerance.
  await page.getByRole("button", { name: "Find variations" }).click();
  await idle(page);
  await page.getByRole("slider", { name: "Variation 1" }).fill("0.2");
  await page.getByRole("slider", { name: "Variation 1" }).press("ArrowRight");
  await idle(page);
  expect(await obj(page)).not.toBe(edited);
  await page.getByText(/^0 panels miss it, \d+ circular$/).waitFor();
  const varied = (await exportAs(page, "JSON")).toString();
  expect(JSON.parse(varied).variations).toHaveLength(1);
  await openFile(page, "varied.json", varied);
  await page.getByText(/^Verified:/).waitFor();
  await page.context().close();
});
