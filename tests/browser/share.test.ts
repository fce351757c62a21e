// SPDX-License-Identifier: MIT
import { afterAll, beforeAll, expect, it } from "vitest";
import { exportAs, idle, movedCount, openSite, type Site, status } from "./support/page.ts";

let site: Site;
beforeAll(async () => {
  site = await openSite();
});
afterAll(() => site.close());

it("a shared link opens as the same design, to the last bit", async () => {
  const page = await site.open();
  await page.getByRole("button", { name: "Add handle" }).click();
  const z = page.getByRole("spinbutton", { name: "Z" });
  await z.fill("+40cm");
  await z.press("Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  const numbers = (await status(page)).replace(/ · \d+ ms$/, "");
  const file = await exportAs(page, "OBJ");
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  expect(link.length).toBeLessThan(600);
  await page.context().close();

  const other = await site.open({}, new URL(link).hash);
  await expect.poll(() => other.getByText(/Verified/).count()).toBe(1);
  expect(await status(other)).toContain(numbers);
  expect(await exportAs(other, "OBJ")).toEqual(file);
  await other.context().close();
});

it("a damaged link gets a sentence and the page still works", async () => {
  const page = await site.open({}, "#v1=AAAA");
  expect(await page.getByRole("alert").textContent()).toMatch(/damaged/);
  expect(await status(page)).toMatch(/0 of 441 points move/);
  await page.context().close();
});
