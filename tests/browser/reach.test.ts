// SPDX-License-Identifier: MIT
// Needs: pointer.
// What the edit's limits promise: nothing beyond the reach moves, a kept boundary stays, and a drag is
// held back before panels fold sharply. A new visitor has them.
import { expect, it } from "vitest";
import { idle, status } from "./support/page.ts";
import { site } from "./support/site.ts";
import { handleRows, hintedPoint, press } from "./support/view.ts";

it("a long drag is held back before panels fold sharply; Shift goes through", async () => {
  const page = await site.open();
  const at = await hintedPoint(page);
  const fold = async (): Promise<number> =>
    Number(/sharpest fold ([\d.]+)°/.exec(await status(page))?.[1]);
  const before = async (): Promise<number> =>
    Number(/\(was ([\d.]+)°\)/.exec(await status(page))?.[1]);
  const said = page.getByText(/^Held back: /);
  await press(page, at, { x: at.x, y: at.y - 140 });
  await said.waitFor();
  await page.mouse.up();
  await idle(page);
  expect(await said.count()).toBe(1);
  expect(await fold()).toBeLessThanOrEqual((await before()) + 11);
  const [held] = await handleRows(page);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  await press(page, at, { x: at.x, y: at.y - 60 });
  await page.keyboard.down("Shift");
  await page.mouse.move(at.x, at.y - 140);
  await page.mouse.up();
  await page.keyboard.up("Shift");
  await idle(page);
  expect(await said.count()).toBe(0);
  expect(await fold()).toBeGreaterThan((await before()) + 11);
  const [through] = await handleRows(page);
  expect(through?.target[2]).toBeGreaterThan((held?.target[2] ?? Number.NaN) + 0.5);
  await page.context().close();
});
