// SPDX-License-Identifier: MIT
// Circular panels, kept by the edits of a mesh that has them; designs and links carry that.
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import {
  exportAs,
  idle,
  movedCount,
  obj,
  openAdvanced,
  openFile,
  openLastSolve,
  showTab,
  status,
  typeTarget,
} from "../browser/support/page.ts";
import { site } from "./support/site.ts";

const CIRCULAR = "Keep panels circular";

const CONICAL = "Keep nodes conical";

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
  await openLastSolve(page);
  await page.getByText("Worst, of circular", { exact: true }).waitFor();
  const text = (await exportAs(page, "JSON")).toString();
  expect(JSON.parse(text).options.constraints).toEqual([{ kind: "circular", tolerance: 1e-9 }]);
  await showTab(page, "Edit");
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
  await showTab(page, "Check and make");
  const table = page.getByRole("table", { name: "Panels" });
  const worst = () => table.getByRole("row").nth(1).getByRole("cell").first().innerText();
  await table.getByRole("columnheader", { name: "Circular" }).getByRole("button").click();
  await expect.poll(async () => Number(await worst())).toBeGreaterThan(1);
  await showTab(page, "Edit");
  await page.getByRole("button", { name: "Make panels circular" }).click();
  await idle(page);
  await showTab(page, "Check and make");
  await expect.poll(worst).toBe("0");
  await showTab(page, "Edit");
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

const MESHES = new URL("../../../shared/meshes/", import.meta.url);

const shared = (name: string): Promise<Buffer> => readFile(new URL(name, MESHES));

/** The offers that are seen without unfolding anything. */
async function offers(page: Page): Promise<string[]> {
  const seen: string[] = [];
  for (const name of [CIRCULAR, CONICAL]) {
    const offer = page.getByRole("checkbox", { name });
    if ((await offer.count()) > 0 && (await offer.isVisible())) seen.push(name);
  }
  return seen;
}

it("samples that are meant to be so are recognised on opening, others are not", async () => {
  const page = await site.open();
  const samples = page.getByRole("combobox", { name: "Sample" });
  for (const [sample, meant] of [
    ["Roof", [CIRCULAR, CONICAL]],
    ["Vault", []],
    ["Dome", [CIRCULAR, CONICAL]],
    ["Freeform roof", []],
  ] as const) {
    await samples.selectOption(sample);
    await idle(page);
    await expect.poll(() => offers(page)).toEqual(meant);
  }
  await page.context().close();
});

it.skipIf(!existsSync(MESHES))(
  "files that nearly are so can be made exact, and are kept so",
  async () => {
    const page = await site.open();
    // Nodes at most 0.043° off, panels up to 4.9°: and none of it exact.
    await openFile(page, "saddle.obj", await shared("pq_conical_saddle.obj"));
    await page
      .getByText("half to 0.0012°, all to 0.043°; can be made exact and kept (Edit)")
      .waitFor();
    await expect.poll(() => offers(page)).toEqual([CONICAL]);
    const conical = page.getByRole("checkbox", { name: CONICAL });
    expect(await conical.isEnabled()).toBe(false);
    await page.getByRole("button", { name: "Make nodes conical" }).click();
    await idle(page);
    await expect.poll(() => conical.isChecked()).toBe(true);
    await typeTarget(page, "+5cm");
    await openLastSolve(page);
    await page.getByText("Worst, of conical", { exact: true }).waitFor();
    const design = JSON.parse((await exportAs(page, "JSON")).toString());
    expect(design.options.constraints).toEqual([{ kind: "conical", tolerance: 1e-9 }]);
    // Half of the vase's panels and nodes are nearer than 0.05° to both.
    await openFile(page, "vase.obj", await shared("pq_vase_small.obj"));
    await page
      .getByText("half to 0.02°, all to 0.031°; can be made exact and kept (Edit)")
      .waitFor();
    await expect.poll(() => offers(page)).toEqual([CIRCULAR, CONICAL]);
    await page.getByRole("button", { name: "Make panels circular" }).click();
    await idle(page);
    await expect.poll(() => page.getByRole("checkbox", { name: CIRCULAR }).isChecked()).toBe(true);
    await page.context().close();
  },
);
