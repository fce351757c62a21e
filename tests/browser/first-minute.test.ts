// SPDX-License-Identifier: MIT
// Needs: pointer.
// The first minute of a visitor, by accessible names only; the exported file is judged by
// code that shares nothing with the product.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { expectLocalAndFlat, type ObjMesh, readObj } from "./support/obj.ts";
import { exportAs, idle, movedCount } from "./support/page.ts";
import { site } from "./support/site.ts";
import { hintedPoint, press } from "./support/view.ts";

const exportObj = async (page: Page): Promise<ObjMesh> =>
  readObj((await exportAs(page, "OBJ")).toString());

describe("the first minute", () => {
  it("moves a point by dragging, undoes and redoes it", async () => {
    const page = await site.open();
    const before = await exportObj(page);
    const at = await hintedPoint(page);
    await press(page, at, { x: at.x, y: at.y - 30 });
    await page.mouse.up();
    await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
    await idle(page);
    const moved = await movedCount(page);
    const after = await exportObj(page);
    expectLocalAndFlat(before, after, moved);

    await page.getByRole("button", { name: "Undo" }).click();
    await expect.poll(() => movedCount(page)).toBe(0);
    await idle(page);
    expect((await exportObj(page)).lines).toEqual(before.lines);
    await page.getByRole("button", { name: "Redo" }).click();
    await expect.poll(() => movedCount(page)).toBe(moved);
    await idle(page);
    expect((await exportObj(page)).lines).toEqual(after.lines);
    await page.context().close();
  });
});
