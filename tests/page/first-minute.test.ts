// SPDX-License-Identifier: MIT
// The first minute of a visitor, by accessible names only; the exported file is judged by
// code that shares nothing with the product.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { expectLocalAndFlat, type ObjMesh, readObj } from "../browser/support/obj.ts";
import { exportAs, idle, movedCount, pickFile, status } from "../browser/support/page.ts";
import { handleRows } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const exportObj = async (page: Page): Promise<ObjMesh> =>
  readObj((await exportAs(page, "OBJ")).toString());

describe("the first minute", () => {
  it("moves a point by typing", async () => {
    const page = await site.open();
    await page.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
    await idle(page);
    const before = await exportObj(page);
    await page.getByRole("button", { name: "Add handle" }).click();
    const z = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton", { name: "Z" });
    await z.fill("+300mm");
    await z.press("Enter");
    await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
    await idle(page);
    expect(await status(page)).toMatch(/largest \d+ mm · worst panel 0\.0000 mm/);
    const after = await exportObj(page);
    expectLocalAndFlat(before, after, await movedCount(page));
    // The point meets what was typed, within a twentieth.
    const [row] = await handleRows(page);
    const [to, from] = [after, before].map((mesh) => mesh.points[row?.vertex ?? -1]?.[2]);
    const raised = (to ?? Number.NaN) - (from ?? Number.NaN);
    expect(raised).toBeGreaterThan(0.285);
    expect(raised).toBeLessThan(0.315);
    await page.context().close();
  });

  it("explains what it cannot read, and keeps the design", async () => {
    const page = await site.open();
    await pickFile(page, "broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n");
    await expect.poll(() => page.getByRole("alert").textContent()).toMatch(/line 3/);
    expect(await status(page)).toMatch(/0 of 425 points move/);
    await page.context().close();
  });
});
