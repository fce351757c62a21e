// SPDX-License-Identifier: MIT
// Needs: pointer.
// The first minute of a visitor, by accessible names only; the exported file is judged by
// code that shares nothing with the product.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { expectLocalAndFlat, type ObjMesh, readObj } from "./support/obj.ts";
import { exportAs, idle, movedCount } from "./support/page.ts";
import { site } from "./support/site.ts";

const exportObj = async (page: Page): Promise<ObjMesh> =>
  readObj((await exportAs(page, "OBJ")).toString());

describe("the first minute", () => {
  it("moves a point by dragging, undoes and redoes it", async () => {
    const page = await site.open();
    const before = await exportObj(page);
    const box = await page.getByLabel("3D view").boundingBox();
    if (!box) throw new Error("no 3D view");
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let k = 1; k <= 6; ++k) await page.mouse.move(x, y - 5 * k);
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
