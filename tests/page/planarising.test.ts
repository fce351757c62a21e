// SPDX-License-Identifier: MIT
// Planarising is tried out at the door: the model shows what it gives, the file stays as it is until taken.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import { exportAs, idle, openFile, status, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

const SIZE = 10;

/** A shallow dome of quads that are not flat, 1 m apart. */
function dome(): string {
  const lines: string[] = [];
  const height = (t: number): number => Math.cos(((t / SIZE - 0.5) * Math.PI) / 1.2);
  for (let i = 0; i <= SIZE; ++i)
    for (let j = 0; j <= SIZE; ++j)
      lines.push(`v ${i} ${j + 0.04 * i * j} ${(2 * height(i) * height(j)).toFixed(9)}`);
  const at = (i: number, j: number): number => i * (SIZE + 1) + j + 1;
  for (let i = 0; i < SIZE; ++i)
    for (let j = 0; j < SIZE; ++j)
      lines.push(`f ${at(i, j)} ${at(i + 1, j)} ${at(i + 1, j + 1)} ${at(i, j + 1)}`);
  return `${lines.join("\n")}\n`;
}

const exported = async (page: Page) => readObj((await exportAs(page, "OBJ")).toString());

const figures = (page: Page) => page.getByRole("table", { name: "Before and after planarising" });

const cell = (page: Page, row: string, column: number) =>
  figures(page).getByRole("row", { name: row }).getByRole("cell").nth(column).textContent();

const millimetres = (words: string | null): number =>
  Number(/([\d.]+) mm/.exec(words ?? "")?.[1] ?? Number.NaN);

it("leaves the file as it is, and says where the boundary is in the way", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await openFile(page, "dome.obj", dome());
  const file = await exported(page);
  await figures(page).waitFor();
  await page.getByRole("button", { name: "Not now" }).click();
  await expect.poll(() => status(page)).toContain(`0 of ${(SIZE + 1) ** 2} points move`);
  expect(await exported(page)).toEqual(file);
  // A panel that lies on the boundary alone cannot stay and become flat.
  await openFile(page, "one.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0.3\nv 0 2 0\nf 1 2 3 4\n");
  const keep = page.getByRole("checkbox", { name: "Keep the boundary where it is" });
  await expect.poll(() => keep.isChecked()).toBe(false);
  await expect.poll(() => cell(page, "Worst panel", 1)).toBe("flat");
  await keep.check();
  await page.getByText(/Let the boundary move/).waitFor();
  await page.context().close();
});

it("goes no farther than it may, and stays out of flat by what it may", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await openFile(page, "dome.obj", dome());
  await figures(page).waitFor();
  const free = millimetres(await cell(page, "Largest move", 1));
  const most = page.getByRole("textbox", { name: "Largest move" });
  expect(await most.inputValue()).toBe("any");
  await most.fill("30mm");
  await most.press("Enter");
  await page
    .getByText(/Not every panel can be exactly flat: .* no point may move farther/)
    .waitFor();
  expect(free).toBeGreaterThan(30);
  expect(millimetres(await cell(page, "Largest move", 1))).toBeLessThanOrEqual(30);
  expect(millimetres(await cell(page, "Largest move", 1))).toBeGreaterThan(10);
  expect(await cell(page, "Worst panel", 1)).toMatch(/^[\d.]+ mm\/m$/);

  await most.fill("any");
  await most.press("Enter");
  await page.getByRole("combobox", { name: "Flat" }).selectOption("to within 5 mm/m");
  await expect.poll(() => cell(page, "Worst panel", 1)).toMatch(/^[1-4]\.\d* mm\/m$/);
  const near = millimetres(await cell(page, "Largest move", 1));
  expect(near).toBeLessThan(free);
  await page.getByRole("button", { name: "Planarise", exact: true }).click();
  await page.getByRole("button", { name: "Start editing" }).click();
  await idle(page);
  // It can be edited, and a link makes the same mesh.
  await typeTarget(page, "+10cm");
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.context().close();
  const again = await site.open({}, new URL(link).hash);
  await again.getByText(/Verified/).waitFor();
  await again.context().close();
});
