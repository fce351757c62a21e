// SPDX-License-Identifier: MIT
// Needs: storage.
// What a reload brings back: all that was made of a file, the sliders of variations, a new start, and the
// figure that a design came from.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { type ObjMesh, readObj } from "./support/obj.ts";
import {
  idle,
  kept,
  movedCount,
  obj,
  openFile,
  openRule,
  openViewOptions,
  ruleChip,
  showTab,
  status,
  typeTarget,
  usable,
} from "./support/page.ts";
import { site } from "./support/site.ts";

async function reload(page: Page): Promise<void> {
  await kept(page);
  await page.reload();
  await usable(page);
  await idle(page);
}

const press = async (page: Page, name: string): Promise<void> => {
  await page.getByRole("button", { name, exact: true }).click();
  await idle(page);
};

async function slide(page: Page, name: string, value: string): Promise<void> {
  await page.getByRole("slider", { name, exact: true }).fill(value);
  await idle(page);
}

const NOTE = "The middle comes up.\nThe third is the one that we would build.";

const region = (page: Page, name: string) => page.getByRole("region", { name });

const names = (page: Page, name: string): Promise<string[]> =>
  region(page, name)
    .getByRole("textbox")
    .evaluateAll((all) => all.map((one) => (one as HTMLInputElement).value));

/** Points of edges that one panel has alone. */
function boundaryOf({ faces }: ObjMesh): Set<number> {
  const sides = faces.flatMap((face) => face.map((v, k) => [v, face[(k + 1) % face.length] ?? v]));
  const known = new Set(sides.map(([a, b]) => `${a} ${b}`));
  return new Set(sides.filter(([a, b]) => !known.has(`${b} ${a}`)).flat());
}

/** A boundary that only goes up and down, a group that hardly moves and a view, each under a name. */
async function describe(page: Page): Promise<void> {
  await page.getByRole("combobox", { name: "Boundary" }).selectOption("free");
  await idle(page);
  await press(page, "Select in a box");
  await press(page, "Boundary");
  await openRule(page, "Supports");
  await page.getByRole("combobox", { name: /^Selected: / }).selectOption("only go up and down");
  await idle(page);
  await press(page, "Add handle");
  await press(page, "Group points");
  await region(page, "Groups").getByRole("textbox", { name: "Name of Group 1" }).fill("Lantern");
  await page.keyboard.press("Enter");
  const will = page.getByRole("combobox", { name: "How willingly Lantern moves" });
  await will.selectOption("hardly move");
  await openViewOptions(page);
  await press(page, "Keep this view");
  const view = region(page, "Named views").getByRole("textbox", { name: "Name of View 1" });
  await view.fill("From the street");
  await page.keyboard.press("Enter");
  await page.getByRole("button", { name: "Show From the street" }).waitFor();
}

it("of a file: its edit, unit, supports, groups, views, snapshots, section, note and name", async () => {
  const page = await site.open();
  await openFile(page, "my roof.obj", await obj(page));
  await page.getByRole("combobox", { name: "Unit of the file" }).selectOption("mm");
  await page.getByRole("button", { name: "Start editing" }).click();
  const base = readObj(await obj(page));
  const boundary = boundaryOf(base);
  await describe(page);
  await typeTarget(page, "+0.2");
  await press(page, "Snapshot");
  await page.getByRole("combobox", { name: "Cut the view" }).selectOption("across Y");
  await showTab(page, "Check and make");
  await page.getByRole("textbox", { name: "Note" }).fill(NOTE);
  await page.getByRole("textbox", { name: "Note" }).blur();
  const before = await obj(page);
  const numbers = (await status(page)).replace(/ · \d+ ms$/, "");
  await reload(page);
  expect(await obj(page)).toBe(before);
  expect(await status(page)).toContain(numbers);
  await page.getByText(/is back\./).waitFor();
  // In the tab that was left.
  expect(await page.getByRole("textbox", { name: "Note" }).inputValue()).toBe(NOTE);
  await showTab(page, "Explore");
  expect(await page.getByRole("button", { name: "Adopt Snapshot 1" }).count()).toBe(1);
  expect(await page.getByTitle(/my roof\.obj · \d+ points/).count()).toBe(1);
  await expect.poll(() => page.getByText(/^Cuts \d+ panels/).count()).toBe(1);
  await showTab(page, "Edit");
  await openViewOptions(page);
  await expect.poll(() => names(page, "Groups")).toEqual(["Lantern"]);
  const will = page.getByRole("combobox", { name: "How willingly Lantern moves" });
  expect(await will.inputValue()).toBe("30");
  expect(await names(page, "Named views")).toEqual(["From the street"]);
  await expect.poll(() => ruleChip(page, "Supports").innerText()).toBe(`Supports ${boundary.size}`);
  // They still hold: every x and y of the boundary keeps its digits.
  await page.getByRole("slider", { name: "Reach" }).fill("10");
  await typeTarget(page, "+0.2");
  const after = readObj(await obj(page));
  const moved = [...boundary].filter((v) => base.lines[v] !== after.lines[v]);
  expect(moved.length).toBeGreaterThan(3);
  const plan = (line = ""): string => line.split(" ").slice(0, 2).join(" ");
  for (const v of moved) expect(plan(after.lines[v])).toBe(plan(base.lines[v]));
  await page.context().close();
});

it("the sliders of variations, and the shape that became the new base", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+70cm");
  await press(page, "Find variations");
  await slide(page, "Variation 1", "0.5");
  const varied = await obj(page);
  await reload(page);
  expect(await obj(page)).toBe(varied);
  await slide(page, "Variation 1", "-0.25");
  await slide(page, "Variation 1", "0.5");
  expect(await obj(page)).toBe(varied);
  expect(await page.getByRole("button", { name: "Show gallery" }).count()).toBe(1);
  await press(page, "Continue from this shape");
  await typeTarget(page, "+30cm");
  const [edited, moved] = [await obj(page), await movedCount(page)];
  await reload(page);
  expect([await obj(page), await movedCount(page)]).toEqual([edited, moved]);
  await page.context().close();
});

it("which figure a design came from, of one of every figure, until another mesh is opened", async () => {
  const page = await site.openVault();
  const sample = page.getByRole("combobox", { name: "Sample" });
  const chosen = (): Promise<string> =>
    sample.evaluate((select: HTMLSelectElement) => select.selectedOptions[0]?.textContent ?? "");
  const option = sample.getByRole("option", { name: /^Figure 8:/ }).first();
  await option.waitFor({ state: "attached" });
  expect(await sample.getByRole("option", { name: /^Figure/ }).count()).toBe(9);
  const figure = (await option.textContent()) ?? "";
  await sample.selectOption(figure);
  await page.getByText(/^Verified/).waitFor();
  await idle(page);
  expect(await chosen()).toBe(figure);
  await page.getByRole("checkbox", { name: "Pinned" }).first().click();
  await reload(page);
  expect(new URL(page.url()).hash).toBe("");
  await expect.poll(chosen).toBe(figure);
  await idle(page);
  await sample.selectOption("Dome");
  await expect.poll(chosen).toBe("Dome");
  await idle(page);
  expect(await chosen()).toBe("Dome");
  await page.context().close();
});
