// SPDX-License-Identifier: MIT
// The tool Cut: panels are parted by clicks in the view, by numbers and by the selection; each cut is a
// step of the history, before the edit, and goes along in links and saved designs.
import { expect, it } from "vitest";
import { flatRoof } from "../browser/support/faults.ts";
import { idle, movedCount, obj, openFile, typeTarget } from "../browser/support/page.ts";
import { handleRows, type Place } from "../browser/support/view.ts";
import {
  cutsOf,
  field,
  kind,
  listed,
  panels,
  roofFromAbove,
  start,
  strip,
  tool,
  typed,
} from "./support/cutting.ts";
import { site } from "./support/site.ts";

it("a panel is split by two clicks, a strip and a corner by one; each is one step", async () => {
  const { page, at } = await roofFromAbove(6);
  const before = await obj(page);
  await start(page);
  const click = async (x: number, y: number): Promise<void> => {
    const { x: left, y: top } = at(x, y);
    await page.mouse.click(left, top);
    await idle(page);
  };
  // Two opposite corners of the panel in the first column and row.
  await click(0.02, 0.02);
  await strip(page).getByText("Click the other end on the same panel.").waitFor();
  await click(0.98, 0.98);
  await expect.poll(() => listed(page)).toEqual(["Split 0:0,8"]);
  expect(await panels(page)).toBe(37);
  await page.getByText("Cut: Split 0:0,8.").waitFor();
  // A quarter of the way along a side.
  await kind(page, "Strip");
  await click(3.25, 4.03);
  await expect
    .poll(async () => (await listed(page)).at(-1))
    .toMatch(/^Strip (31-32@0.25|32-31@0.75)$/);
  expect(await panels(page)).toBe(43);
  await kind(page, "Corner");
  await click(5.1, 5.1);
  await expect.poll(async () => (await listed(page)).at(-1)).toBe("Corner 35:40");
  expect(await panels(page)).toBe(44);
  await kind(page, "Refine");
  await click(5.5, 0.5);
  await expect.poll(async () => (await listed(page)).at(-1)).toBe("Refine 5");
  expect(await panels(page)).toBe(47);
  // Each is one step.
  for (const count of [44, 43, 37, 36]) {
    await page.getByRole("button", { name: "Undo" }).click();
    await idle(page);
    expect(await panels(page)).toBe(count);
  }
  expect(await obj(page)).toBe(before);
  expect(await movedCount(page)).toBe(0);
  await page.context().close();
});

it("what would be cut is tried out under the pointer, and nothing is made of it", async () => {
  const { page, at } = await roofFromAbove(6);
  await start(page);
  await kind(page, "Corner");
  const { x, y } = at(1.1, 1.1);
  await page.mouse.move(x, y);
  await idle(page);
  // The form leaves what is typed alone.
  expect(await field(page).inputValue()).toBe("");
  expect(await strip(page).getByRole("button", { name: "Cut", exact: true }).isDisabled()).toBe(
    false,
  );
  expect(await panels(page)).toBe(36);
  // What cannot be is said before it is asked for.
  await kind(page, "Split");
  const first = at(1.02, 1.02);
  await page.mouse.click(first.x, first.y);
  const next = at(1.98, 1.02);
  await page.mouse.move(next.x, next.y);
  await strip(page).getByText("points 8 and 9 are neighbours on the outline of panel 7").waitFor();
  await page.mouse.click(next.x, next.y);
  await idle(page);
  // Where it was said before it was asked for, and where a typed one is: in the tool alone.
  await strip(page).getByText("points 8 and 9 are neighbours on the outline of panel 7").waitFor();
  const alert = page.getByRole("alert").getByText(/points 8 and 9 are neighbours/);
  expect(await alert.count()).toBe(0);
  await typed(page, "Split", "7:8,9");
  await strip(page).getByText("points 8 and 9 are neighbours on the outline of panel 7").waitFor();
  expect(await alert.count()).toBe(0);
  expect(await panels(page)).toBe(36);
  await page.context().close();
});

it("a trim that takes a handle's panels takes the handle off, says so, and the legend counts anew", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+30cm");
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("shape");
  const legend = page.getByRole("group", { name: "Legend" });
  await legend.getByText(/^\d\d points move/).waitFor();
  await start(page);
  await typed(page, "Trim", "0,0,1,1.5");
  const [words] = await page.getByText(/^Cut: Trim/).allTextContents();
  expect(words).toMatch(
    /^Cut: Trim 0,0,1,1.5\. Point \d+ is gone with its panels, and its handle is removed\.$/,
  );
  expect(await handleRows(page)).toEqual([]);
  expect(await movedCount(page)).toBe(0);
  await legend.getByText(/^0 points move/).waitFor();
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  expect((await handleRows(page)).length).toBe(1);
  await legend.getByText(/^\d\d points move/).waitFor();
  await page.context().close();
});

it("Escape takes the first place back, then leaves the tool; clicks select again", async () => {
  const { page, at } = await roofFromAbove(6);
  await start(page);
  const corner = at(1.02, 1.02);
  await page.mouse.click(corner.x, corner.y);
  await strip(page).getByText("Click the other end on the same panel.").waitFor();
  await page.getByLabel("3D view").press("Escape");
  await strip(page).getByText("Click two corners or sides of one panel.").waitFor();
  await page.getByLabel("3D view").press("Escape");
  await expect.poll(() => strip(page).count()).toBe(0);
  expect(await tool(page).getAttribute("aria-pressed")).toBe("false");
  await page.mouse.click(at(1, 1).x, at(1, 1).y);
  await expect.poll(() => page.locator(".marker.selected:not([hidden])").count()).toBe(1);
  // From the other door and a field of it, too.
  await page.getByRole("button", { name: "Start cutting" }).click();
  await strip(page).waitFor();
  await field(page).press("Escape");
  await expect.poll(() => strip(page).count()).toBe(0);
  expect(await panels(page)).toBe(36);
  await page.context().close();
});

it.each([
  ["Split", "7:8,15-16@0.5", 37, "split=7:8,15-16@0.5"],
  ["Strip", "8-9", 42, "strip=8-9"],
  ["Corner", "7:8@0.25", 37, "corner=7:8@0.25"],
  ["Refine", "7, 8", 42, "refine=7,8"],
  ["Trim", "0,1,0,2.5", 18, "trim=0,1,0,2.5"],
] as const)("%s by numbers alone", async (name, numbers, count, text) => {
  const page = await site.openVault();
  await openFile(page, "roof.obj", flatRoof(6));
  await page.getByRole("button", { name: "Start editing" }).click();
  await start(page);
  await typed(page, name, numbers);
  expect(await panels(page)).toBe(count);
  expect(await cutsOf(page)).toEqual([text]);
  await page.context().close();
});

it("a finger sees first what it cuts, and cuts with its next tap there", async () => {
  const { page, at } = await roofFromAbove(6);
  await start(page);
  await kind(page, "Strip");
  const tap = async ({ x, y }: Place): Promise<void> => {
    await page.evaluate(
      ({ x: clientX, y: clientY }) => {
        const canvas = document.querySelector("canvas");
        for (const type of ["pointerdown", "pointerup", "pointerleave"])
          canvas?.dispatchEvent(
            new PointerEvent(type, {
              bubbles: true,
              cancelable: true,
              pointerType: "touch",
              isPrimary: true,
              pointerId: 2,
              clientX,
              clientY,
            }),
          );
      },
      { x, y },
    );
    await idle(page);
  };
  await tap(at(3.5, 4.05));
  expect(await panels(page)).toBe(36);
  expect(await strip(page).getByRole("button", { name: "Cut", exact: true }).isDisabled()).toBe(
    false,
  );
  // Elsewhere: that is shown instead.
  await tap(at(1.5, 2.05));
  expect(await panels(page)).toBe(36);
  await tap(at(1.5, 2.05));
  expect(await panels(page)).toBe(42);
  expect(await listed(page)).toHaveLength(1);
  expect((await listed(page))[0]).toMatch(/^Strip (15-16|16-15)$/);
  await page.context().close();
});
