// SPDX-License-Identifier: MIT
// Views that are kept under a name and gone back to.
import { expect, it } from "vitest";
import { idle, openViewOptions, still } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

it("a view is kept, named, and gone back to by button and by command", async () => {
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
  await openViewOptions(page);
  const section = page.getByRole("region", { name: "Named views" });
  await section.getByRole("button", { name: "Keep this view" }).click();
  await section.getByRole("textbox", { name: "Name of View 1" }).fill("From the street");
  await page.keyboard.press("Enter");
  await section.getByRole("button", { name: "Show From the street" }).waitFor();
  const away = async (): Promise<void> => {
    await page.getByRole("button", { name: "Top", exact: true }).click();
    await expect.poll(gap).toBeGreaterThan(15);
  };
  const back = (): Promise<void> => expect.poll(gap).toBeLessThan(6);
  await away();
  await section.getByRole("button", { name: "Show From the street" }).click();
  await back();
  await away();
  await page.keyboard.press("Control+k");
  await page.getByRole("combobox", { name: "Command" }).fill("street");
  await page.keyboard.press("Enter");
  await back();
  await section.getByRole("button", { name: "Delete From the street" }).click();
  await expect.poll(() => section.getByRole("listitem").count()).toBe(0);
  await page.context().close();
});
