// SPDX-License-Identifier: MIT
// An edit reaches as far as it has to, until someone chooses how far.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, movedCount, obj, typeTarget } from "../browser/support/page.ts";
import { handleRows, hintedPoint, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

const slider = (page: Page) => page.getByRole("slider", { name: "Reach" });

const reach = async (page: Page): Promise<number> => Number(await slider(page).inputValue());

it("grows while a point is dragged, ends as it was shown, and the next edit begins anew", async () => {
  const page = await site.open({ viewport: { width: 1440, height: 900 } });
  const { x, y } = await hintedPoint(page);
  await press(page, { x, y }, { x, y: y - 8 });
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  const [little, few] = [await reach(page), await movedCount(page)];
  expect(little).toBeLessThan(6);
  await page.mouse.move(x, y - 80);
  await expect.poll(() => reach(page)).toBe(6);
  expect(await movedCount(page)).toBeGreaterThan(few);
  // It stays: what is released is what was shown.
  await page.mouse.move(x, y - 8);
  const [row] = await handleRows(page);
  await page.mouse.up();
  await idle(page);
  expect(await reach(page)).toBe(6);
  expect(await handleRows(page)).toEqual([row]);

  await page.getByRole("button", { name: "Remove" }).click();
  await idle(page);
  expect(await movedCount(page)).toBe(0);
  await press(page, { x, y }, { x, y: y - 8 });
  await page.mouse.up();
  await idle(page);
  expect(await reach(page)).toBe(little);
  expect(await movedCount(page)).toBe(few);
  const whole = await obj(page);
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.context().close();
  const other = await site.open({}, new URL(link).hash);
  await other.getByText(/^Verified:/).waitFor();
  expect(await obj(other)).toBe(whole);
  expect(await reach(other)).toBe(little);
  await other.context().close();
});

it("ends with the reach that its last place needs, however quick the hand is", async () => {
  const page = await site.open({ viewport: { width: 1440, height: 900 } });
  const { x, y } = await hintedPoint(page);
  await press(page, { x, y }, { x, y: y - 8 });
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  const before = (await handleRows(page))[0]?.target[2] ?? Number.NaN;
  // No frame is shown between the two.
  await Promise.all([page.mouse.move(x, y - 80), page.mouse.up()]);
  await idle(page);
  expect(await reach(page)).toBe(6);
  expect((await handleRows(page))[0]?.target[2]).toBeGreaterThan(before + 1);
  expect(await page.getByText(/^Held back/).count()).toBe(0);
  await page.context().close();
});

it("is found for what is typed, and stays where someone chose it", async () => {
  const page = await site.open();
  await typeTarget(page, "+20cm");
  const found = await reach(page);
  expect(found).toBeLessThan(6);
  await typeTarget(page, "+80cm");
  expect(await reach(page)).toBe(6);
  await slider(page).fill("5");
  await idle(page);
  for (const height of ["+20cm", "+80cm"]) {
    await typeTarget(page, height);
    expect(await reach(page)).toBe(5);
  }
  await page.getByRole("button", { name: "Remove" }).click();
  await idle(page);
  await typeTarget(page, "+20cm");
  expect(await reach(page)).toBe(5);
  await page.getByRole("button", { name: "As far as needed" }).click();
  await idle(page);
  expect(await reach(page)).toBe(found);
  expect(await page.getByRole("button", { name: "As far as needed" }).count()).toBe(0);
  expect(await page.getByText(`${found} panels, as needed`).count()).toBe(1);
  await page.context().close();
});

/** Drags the knob on the line of the reach by `way` pixels. */
const dragKnob = (page: Page, way: number, letGo: boolean): Promise<void> =>
  page.locator(".reach-knob").evaluate(
    (knob, by) => {
      const canvas = document.querySelector("canvas")?.getBoundingClientRect();
      const [, x, y] =
        /translate\((-?\d+)px, (-?\d+)px\)/.exec((knob as HTMLElement).style.transform) ?? [];
      const start = { x: (canvas?.left ?? 0) + Number(x), y: (canvas?.top ?? 0) + Number(y) };
      const send = (type: string, moved: number): boolean =>
        knob.dispatchEvent(
          new PointerEvent(type, {
            bubbles: true,
            cancelable: true,
            button: type === "pointermove" ? -1 : 0,
            pointerId: 1,
            clientX: start.x + moved,
            clientY: start.y,
          }),
        );
      (knob as HTMLElement).setPointerCapture = () => {};
      send("pointerdown", 0);
      send("pointermove", by.way);
      if (by.letGo) send("pointerup", by.way);
    },
    { way, letGo },
  );

it("is what the knob on its line is dragged to, shown before it is let go", async () => {
  const page = await site.open({ viewport: { width: 1440, height: 900 } });
  await typeTarget(page, "+50cm");
  await slider(page).fill("3");
  await idle(page);
  const moved = await movedCount(page);
  await expect.poll(() => page.locator(".reach-knob:not([hidden])").count()).toBe(1);
  await dragKnob(page, 60, false);
  await expect.poll(() => reach(page)).toBeGreaterThan(3);
  await expect.poll(() => movedCount(page)).toBeGreaterThan(moved);
  await dragKnob(page, 60, true);
  await idle(page);
  const wide = await reach(page);
  expect(wide).toBeGreaterThan(3);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect(await reach(page)).toBe(3);
  expect(await movedCount(page)).toBe(moved);
  await page.context().close();
});
