// SPDX-License-Identifier: MIT
// Where nothing may go is added, moved and removed in the page, and edits keep to it wherever they go.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import { idle, obj, openRule, pickFile, ruleChip, typeTarget } from "../browser/support/page.ts";
import { middleOf, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

async function add(page: Page, words: string): Promise<void> {
  await page.getByRole("button", { name: `Nothing may be ${words}` }).click();
  await idle(page);
}

async function type(page: Page, label: string, text: string): Promise<void> {
  const field = page.getByRole("textbox", { name: label, exact: true });
  await field.fill(text);
  await field.press("Enter");
  await idle(page);
}

const numberIn = async (page: Page, label: string): Promise<number> =>
  Number(await page.getByRole("textbox", { name: label, exact: true }).inputValue());

/** z of every point that is exported, and of the highest. */
async function heights(page: Page): Promise<{ all: number[]; highest: number }> {
  const all = readObj(await obj(page)).lines.map((line) => Number(line.split(" ")[2]));
  return { all, highest: Math.max(...all) };
}

it("edits stay below a level with its clearance, in the link too, until it is removed", async () => {
  const page = await site.open({ permissions: ["clipboard-read", "clipboard-write"] });
  const { highest: roof } = await heights(page);
  await openRule(page, "Keep-outs");
  await add(page, "above a level");
  expect(await ruleChip(page, "Keep-outs").innerText()).toBe("Keep-outs 1");
  expect(await numberIn(page, "Nothing above, level Z")).toBeGreaterThanOrEqual(roof - 1e-3);
  await type(page, "Nothing above, level Z", `${roof + 0.3}`);
  await type(page, "Clearance", "5cm");
  await typeTarget(page, "+1.5");
  const held = await obj(page);
  const { highest } = await heights(page);
  expect(highest).toBeGreaterThan(roof + 0.1);
  expect(highest).toBeLessThanOrEqual(roof + 0.25 + 1e-9);
  expect(await page.getByText(/^They hold \d+ points? of this edit back\.$/).count()).toBe(1);
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.keyboard.press("Escape");
  const other = await site.open({}, new URL(link).hash);
  await other.getByText(/^Verified:/).waitFor();
  expect(await obj(other)).toBe(held);
  await expect.poll(() => ruleChip(other, "Keep-outs").innerText()).toBe("Keep-outs 1");
  await other.context().close();
  await page.getByRole("button", { name: "Remove: Nothing above" }).click();
  await idle(page);
  expect((await heights(page)).highest).toBeGreaterThan(roof + 0.3);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await obj(page)).toBe(held);
  expect(await ruleChip(page, "Keep-outs").innerText()).toBe("Keep-outs 1");
  await page.context().close();
});

it("a box is moved by its arrows as one step, and a wrong corner is refused with nothing lost", async () => {
  const page = await site.open();
  await page.getByRole("button", { name: "Top", exact: true }).click();
  // A box is put above the point that is chosen, and is seen there from above.
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowUp");
  const marker = page.locator(".marker.selected");
  await marker.waitFor();
  await openRule(page, "Keep-outs");
  await add(page, "in a box");
  const name = "Nothing in a box";
  const fields = ["from X", "from Y", "from Z", "to X", "to Y", "to Z"];
  const numbers = (): Promise<number[]> =>
    Promise.all(fields.map((field) => numberIn(page, `${name}, ${field}`)));
  const before = await numbers();
  await page.getByRole("button", { name: `Move in the view: ${name}` }).click();
  const middle = await middleOf(page, marker);
  await press(page, middle, { x: middle.x + 60, y: middle.y });
  await page.mouse.up();
  await idle(page);
  const after = await numbers();
  expect((after[0] ?? 0) - (before[0] ?? 0)).toBeGreaterThan(0.1);
  expect((after[3] ?? 0) - (after[0] ?? 0)).toBeCloseTo((before[3] ?? 0) - (before[0] ?? 0), 3);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await numbers()).toEqual(before);
  await type(page, `${name}, from X`, `${(before[3] ?? 0) + 1}`);
  await page.getByText(/^The first corner must be lower/).waitFor();
  expect(await numberIn(page, `${name}, from X`)).toBe((before[3] ?? 0) + 1);
  await type(page, `${name}, from X`, `${before[0]}`);
  expect(await page.getByText(/^The first corner must be lower/).count()).toBe(0);
  expect(await numbers()).toEqual(before);
  await page.context().close();
});

it("a model from a file is stood beside the structure, and edits stop at it", async () => {
  const page = await site.open();
  const { highest } = await heights(page);
  const slab = highest + 0.2;
  const corners = ["-99 -99", "99 -99", "99 99", "-99 99"].map((at) => `v ${at} ${slab}`);
  await openRule(page, "Keep-outs");
  await pickFile(page, "slab.obj", `${corners.join("\n")}\nf 1 2 3 4\n`, (shown) =>
    shown.getByRole("button", { name: "Nothing may be through a model" }).click(),
  );
  await expect.poll(() => ruleChip(page, "Keep-outs").innerText()).toBe("Keep-outs 1");
  await idle(page);
  await typeTarget(page, "+0.8");
  const { highest: now } = await heights(page);
  expect(now).toBeLessThanOrEqual(slab + 1e-9);
  expect(now).toBeGreaterThan(highest + 0.05);
  expect(await page.getByText(/^They hold \d+ points? of this edit back\.$/).count()).toBe(1);
  await page.getByRole("button", { name: "Remove: No panel through a model" }).click();
  await idle(page);
  expect((await heights(page)).highest).toBeGreaterThan(slab);
  await page.context().close();
});
