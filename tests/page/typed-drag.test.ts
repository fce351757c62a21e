// SPDX-License-Identifier: MIT
// A number typed while the button is down says how far a drag goes.
import { expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import { exportAs, idle, movedCount } from "../browser/support/page.ts";
import { handleRows, hintedPoint, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

it("a drag goes as far as is typed, the way of the pointer; Enter ends it there", async () => {
  const page = await site.openVault({ viewport: { width: 900, height: 640 } });
  const base = readObj((await exportAs(page, "OBJ")).toString());
  const from = await hintedPoint(page);
  await press(page, from, { x: from.x + 4, y: from.y - 30 });
  for (const key of "0.23") await page.keyboard.press(key);
  await page.getByText("typed 0.23 m").waitFor();
  await page.keyboard.press("Backspace");
  await page.keyboard.press("5");
  await page.mouse.move(from.x, from.y - 60);
  await page.keyboard.press("Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  const [row] = await handleRows(page);
  if (!row) throw new Error("no handle");
  const z = base.points[row.vertex]?.[2] ?? Number.NaN;
  expect(row.target).toEqual([...(base.points[row.vertex]?.slice(0, 2) ?? []), z + 0.25]);
  // The button comes up only now: the point is not dragged any more, and the view is as it was.
  await page.mouse.move(from.x, from.y - 90);
  await page.mouse.up();
  await idle(page);
  expect(await handleRows(page)).toEqual([row]);
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => movedCount(page)).toBe(0);
  expect(await page.getByRole("button", { name: "Undo" }).isEnabled()).toBe(false);
  await page.context().close();
});
