// SPDX-License-Identifier: MIT
// Several points are one thing: lines and borders are selected at once, moved, pinned and let go.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import { idle, movedCount, obj } from "../browser/support/page.ts";
import { press as dragTo, handleRows, hintedPoint, type Place } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

/** Points along and across the first sample. */
const SIDE = 21;

const strip = (page: Page) => page.getByRole("toolbar", { name: "Selected points" });

const press = async (page: Page, name: string): Promise<void> => {
  await strip(page).getByRole("button", { name, exact: true }).click();
};

const selected = async (page: Page): Promise<number> =>
  (await strip(page).count()) === 0
    ? 0
    : Number.parseInt((await strip(page).textContent()) ?? "", 10);

const expectSelected = (page: Page, count: number): Promise<void> =>
  expect.poll(() => selected(page)).toBe(count);

/** Where the selected points are on screen. */
const marked = (page: Page): Promise<Place[]> =>
  page.locator(".marker.selected").evaluateAll((all) =>
    all.map((mark) => {
      const { x, y, width, height } = mark.getBoundingClientRect();
      return { x: x + width / 2, y: y + height / 2 };
    }),
  );

/** Selects the first visit's point and its neighbour to the right; gives the middle of their edge. */
async function selectEdge(page: Page): Promise<Place> {
  const at = await hintedPoint(page);
  await page.mouse.click(at.x, at.y);
  await page.keyboard.press("Control+ArrowRight");
  await expectSelected(page, 2);
  // A mark lies at the corner of the view until it is drawn.
  await expect
    .poll(async () => Math.abs(((await marked(page))[1]?.x ?? 0) - at.x))
    .toBeLessThan(60);
  const [a = at, b = at] = await marked(page);
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
}

it("a double click on an edge selects its line, with Alt its strip; the strip's buttons too", async () => {
  const page = await site.openVault({ size: 21 });
  const middle = await selectEdge(page);
  await page.mouse.dblclick(middle.x, middle.y);
  await expectSelected(page, SIDE);
  await page.keyboard.down("Alt");
  await page.mouse.dblclick(middle.x, middle.y);
  await page.keyboard.up("Alt");
  await expectSelected(page, 2 * SIDE);
  await page.keyboard.press("Escape");
  expect(await selected(page)).toBe(0);
  const again = await hintedPoint(page);
  await page.mouse.click(again.x, again.y);
  await page.keyboard.press("Control+ArrowRight");
  await press(page, "Line");
  await expectSelected(page, SIDE);
  await page.context().close();
});

it("a selection grows, shrinks and is turned round", async () => {
  const page = await site.openVault({ size: 21 });
  await selectEdge(page);
  await press(page, "Grow");
  await expectSelected(page, 8);
  await press(page, "Shrink");
  await expectSelected(page, 2);
  await press(page, "Invert");
  await expectSelected(page, SIDE * SIDE - 2);
  await press(page, "Ring");
  await expectSelected(page, SIDE * SIDE - 2);
  await press(page, "Invert");
  await expectSelected(page, 2);
  await press(page, "Ring");
  await expectSelected(page, 2 * SIDE);
  await page.context().close();
});

it("the boundary is pinned and a line raised by an amount, in twelve actions; both are let go", async () => {
  const page = await site.openVault({ size: 21 });
  const base = readObj(await obj(page));
  const middle = await selectEdge(page);
  await page.keyboard.press("Escape");
  let actions = 0;
  const act = async (action: Promise<unknown>): Promise<void> => {
    actions += 1;
    await action;
  };
  await act(page.getByRole("button", { name: "Select in a box" }).click());
  await act(press(page, "Boundary"));
  await expectSelected(page, 4 * (SIDE - 1));
  await act(press(page, "Pin"));
  await idle(page);
  await act(page.getByRole("button", { name: "Select in a box" }).click());
  await act(page.mouse.dblclick(middle.x, middle.y));
  await expectSelected(page, SIDE);
  const raise = strip(page).getByRole("spinbutton", { name: "Move by Z" });
  await act(raise.fill("300mm"));
  await act(raise.press("Enter"));
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  expect(actions).toBeLessThanOrEqual(12);
  expect(await raise.inputValue()).toBe("0");
  const table = page.getByRole("table", { name: "Handles" });
  await expect.poll(() => table.getByText(/^80 pinned/).count()).toBe(1);
  // The two ends of the line are on the boundary: they are pinned, and stay.
  await expect.poll(() => table.getByText(new RegExp(`^${SIDE - 2} handles`)).count()).toBe(1);
  await table.getByRole("button", { name: "List" }).first().click();
  const raised = (await handleRows(page)).filter(
    ({ pinned, target }) => !pinned && target.length > 0,
  );
  expect(raised.length).toBe(SIDE - 2);
  for (const { vertex, target } of raised) {
    const [x, y, z = 0] = base.points[vertex] ?? [];
    expect(target.slice(0, 2)).toEqual([x, y]);
    expect(target[2]).toBeCloseTo(z + 0.3, 12);
  }
  await press(page, "Remove");
  await idle(page);
  expect(await movedCount(page)).toBe(0);
  await table.getByRole("button", { name: "Select", exact: true }).click();
  // Without those of the line.
  await expectSelected(page, 4 * (SIDE - 1) - 2);
  await press(page, "Free");
  await idle(page);
  await expect.poll(() => table.getByRole("row").count()).toBe(1);
  await page.context().close();
});

it("a point is moved by an amount in eight keys, along the axis of the lock", async () => {
  const page = await site.openVault({ size: 21 });
  const base = readObj(await obj(page));
  await page.getByLabel("3D view").focus();
  const keys = async (...pressed: readonly string[]): Promise<void> => {
    expect(pressed.length).toBeLessThanOrEqual(8);
    for (const key of pressed) await page.keyboard.press(key);
  };
  await page.keyboard.press("ArrowRight");
  await expect.poll(async () => (await marked(page)).length).toBe(1);
  await page.keyboard.press("m");
  const up = strip(page).getByRole("spinbutton", { name: "Move by Z" });
  await expect.poll(() => up.evaluate((field) => field === document.activeElement)).toBe(true);
  await keys("3", "0", "0", "m", "m", "Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  const [row] = await handleRows(page);
  const [x, y, z = 0] = base.points[row?.vertex ?? 0] ?? [];
  expect(row?.target.slice(0, 2)).toEqual([x, y]);
  expect(row?.target[2]).toBeCloseTo(z + 0.3, 12);
  await page.getByLabel("3D view").focus();
  await expect.poll(() => strip(page).count()).toBe(0);
  await page.keyboard.press("x");
  await page.keyboard.press("m");
  const across = strip(page).getByRole("spinbutton", { name: "Move by X" });
  await expect.poll(() => across.evaluate((field) => field === document.activeElement)).toBe(true);
  await page.context().close();
});

it("the boundary is pinned and a line raised by keys alone, in forty", async () => {
  const page = await site.openVault({ size: 21 });
  const base = readObj(await obj(page));
  await page.getByLabel("3D view").focus();
  let pressed = 0;
  const keys = async (...all: readonly string[]): Promise<void> => {
    pressed += all.length;
    for (const key of all) await page.keyboard.press(key);
  };
  const command = async (word: string): Promise<void> => {
    await keys("Control+k");
    await page.getByRole("dialog").waitFor();
    await keys(...word, "Enter");
    await expect.poll(() => page.getByRole("dialog").count()).toBe(0);
  };
  await command("boun");
  await expectSelected(page, 4 * (SIDE - 1));
  await keys("p");
  await idle(page);
  await page.getByLabel("3D view").focus();
  await keys("Escape", "ArrowRight", "Control+ArrowRight");
  await expectSelected(page, 2);
  await command("line of");
  await expectSelected(page, SIDE);
  await keys("m");
  const up = strip(page).getByRole("spinbutton", { name: "Move by Z" });
  await expect.poll(() => up.evaluate((field) => field === document.activeElement)).toBe(true);
  await keys(..."300mm", "Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  expect(pressed).toBeLessThanOrEqual(40);
  const table = page.getByRole("table", { name: "Handles" });
  await table.getByRole("button", { name: "List" }).first().click();
  const lifted = (await handleRows(page)).filter(({ pinned, target, vertex }) => {
    const z = base.points[vertex]?.[2] ?? 0;
    return !pinned && Math.abs((target[2] ?? 0) - z - 0.3) < 1e-12;
  });
  expect(lifted.length).toBe(SIDE - 2);
  await page.context().close();
});

/** How far up each point of the table was asked to go, model units, in the order of the points. */
async function raised(page: Page, base: readonly (readonly number[])[]): Promise<number[]> {
  const rows = (await handleRows(page)).toSorted((a, b) => a.vertex - b.vertex);
  return rows.map(({ vertex, target }) => (target[2] ?? 0) - (base[vertex]?.[2] ?? 0));
}

it("with a fall-off a line rises as a bump, by a typed amount and by a drag; a link has its targets", async () => {
  const page = await site.openVault({ size: 21, viewport: { width: 1440, height: 900 } });
  const { points } = readObj(await obj(page));
  await selectEdge(page);
  await press(page, "Line");
  await expectSelected(page, SIDE);
  const fallOff = strip(page).getByRole("combobox", { name: "Fall-off" });
  expect(await fallOff.inputValue()).toBe("0");
  await fallOff.selectOption("from the middle");
  const raise = strip(page).getByRole("spinbutton", { name: "Move by Z" });
  await raise.fill("300mm");
  await raise.press("Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  await page.getByRole("button", { name: "List" }).click();
  const ways = await raised(page, points);
  expect(ways.length).toBe(SIDE);
  const middle = (SIDE - 1) / 2;
  expect(Math.max(...ways)).toBeCloseTo(0.3, 9);
  for (let k = 1; k <= middle; ++k) {
    expect(ways[middle + k]).toBeLessThan(ways[middle + k - 1] ?? 0);
    expect(ways[middle - k]).toBeCloseTo(ways[middle + k] ?? 0, 6);
  }
  expect(ways[0]).toBeGreaterThan(0);

  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => movedCount(page)).toBe(0);
  await page.getByRole("button", { name: "Lock to Z" }).click();
  const at = await hintedPoint(page);
  await page.getByRole("button", { name: "Select in a box" }).click();
  await dragTo(page, { x: at.x - 90, y: at.y - 70 }, { x: at.x + 90, y: at.y + 70 });
  await page.mouse.up();
  await dragTo(page, at, { x: at.x, y: at.y - 40 });
  await page.mouse.up();
  await idle(page);
  const dragged = (await raised(page, points)).toSorted((a, b) => b - a);
  expect(dragged.length).toBeGreaterThan(4);
  expect(dragged[1]).toBeLessThan(dragged[0] ?? 0);
  expect(dragged.at(-1)).toBeLessThan(0.3 * (dragged[0] ?? 0));
  await page.context().close();
});
