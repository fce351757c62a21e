// SPDX-License-Identifier: MIT
// Needs: storage, axe.
// Views that are kept under a name, gone back to, and there again after a reload.
import { expect, it } from "vitest";
import { expectClean } from "./support/axe.ts";
import { idle, kept, still, usable } from "./support/page.ts";
import { site } from "./support/site.ts";

it("a view is kept, named, gone back to by button and by command, and survives a reload", async () => {
  const page = await site.open();
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  /** Where the handle is seen, which tells views apart. */
  const handle = async (): Promise<{ x: number; y: number }> => {
    const box = await page.locator(".marker.handle").boundingBox();
    return { x: box?.x ?? Number.NaN, y: box?.y ?? Number.NaN };
  };
  await still(page);
  const at = await handle();
  const gap = async (): Promise<number> => {
    const { x, y } = await handle();
    return Math.hypot(x - at.x, y - at.y);
  };
  const section = page.getByRole("region", { name: "Named views" });
  await section.getByRole("button", { name: "Keep this view" }).click();
  await section.getByRole("textbox", { name: "Name of View 1" }).fill("From the street");
  await page.keyboard.press("Enter");
  await section.getByRole("button", { name: "Show From the street" }).waitFor();
  await expectClean(page, "with a named view");
  const away = async (): Promise<void> => {
    await page.getByRole("button", { name: "Top", exact: true }).click();
    await expect.poll(gap).toBeGreaterThan(15);
  };
  // The status line has another height after a reload, and so has the view.
  const back = (): Promise<void> => expect.poll(gap).toBeLessThan(6);
  await away();
  await section.getByRole("button", { name: "Show From the street" }).click();
  await back();
  await kept(page);
  await page.reload();
  await usable(page);
  await idle(page);
  await away();
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "Command" }).fill("street");
  await page.keyboard.press("Enter");
  await back();
  await section.getByRole("button", { name: "Delete From the street" }).click();
  await expect.poll(() => section.getByRole("listitem").count()).toBe(0);
  await page.context().close();
});
