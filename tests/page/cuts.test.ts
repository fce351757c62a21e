// SPDX-License-Identifier: MIT
// A design with cuts as a visitor has it: opened from a file, edited, saved as JSON and GLB, and opened again.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { flatRoof } from "../browser/support/faults.ts";
import { readObj } from "../browser/support/obj.ts";
import { exportAs, idle, movedCount, obj, openFile, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

/** A point of the roof, and one that the strip adds. */
const CUTS = ["strip=14-15@0.25", "corner=3:3"];

const design = (more: object = {}): string =>
  JSON.stringify({
    format: "planish-design",
    version: 1,
    source: { file: "roof.obj", format: "obj", bytes: btoa(flatRoof(6)) },
    cuts: CUTS,
    ...more,
  });

async function openedCut(): Promise<Page> {
  const page = await site.openVault();
  await openFile(page, "cut.json", design({ handles: [[14, 2, 2, 0.4]] }));
  await page.getByText(/^Opened: the design holds no result/).waitFor();
  return page;
}

const pointsOf = async (page: Page): Promise<number> => readObj(await obj(page)).points.length;

it.each(["JSON", "GLB"] as const)(
  "a design with cuts is saved as %s and opens again, verified, to the last bit",
  async (format) => {
    const page = await openedCut();
    await typeTarget(page, "+40cm");
    const [moved, edited] = [await movedCount(page), await obj(page)];
    expect(readObj(edited).points.length).toBeGreaterThan(readObj(flatRoof(6)).points.length);
    const bytes = await exportAs(page, format);
    if (format === "JSON") expect(JSON.parse(bytes.toString()).cuts).toEqual(CUTS);
    const other = await site.open();
    await openFile(other, `cut.${format.toLowerCase()}`, bytes);
    await other.getByText(/^Verified:/).waitFor({ timeout: 60_000 });
    await idle(other);
    expect(await movedCount(other)).toBe(moved);
    expect(await obj(other)).toBe(edited);
    // What opened is edited, and saved, as the first is.
    await typeTarget(page, "+60cm");
    await typeTarget(other, "+60cm");
    expect(await obj(other)).toBe(await obj(page));
    const again = await exportAs(other, "JSON");
    expect(JSON.parse(again.toString()).cuts).toEqual(CUTS);
    await other.context().close();
    await page.context().close();
  },
);

it("Undo goes back to the mesh before, and Redo to the cut one", async () => {
  const page = await site.openVault();
  const before = await obj(page);
  await openFile(page, "cut.json", design());
  await page.getByText(/^Opened: the design holds no result/).waitFor();
  const cut = await pointsOf(page);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await obj(page)).toBe(before);
  await page.getByRole("button", { name: "Redo" }).click();
  await idle(page);
  expect(await pointsOf(page)).toBe(cut);
  await page.context().close();
});

it("a cut that cannot be made is one sentence", async () => {
  const page = await site.openVault();
  const before = await obj(page);
  await openFile(page, "cut.json", design({ cuts: ["corner=3:99"] }));
  await page.getByText("cut.json: Cuts: corner=3:99: panel 3 has no corner 99.").waitFor();
  await openFile(page, "saw.json", design({ cuts: ["saw=1"] }));
  await page.getByText(/^saw\.json: cuts: "saw=1" is no cut: there are split=F:A,B/).waitFor();
  expect(await obj(page)).toBe(before);
  await page.context().close();
});
