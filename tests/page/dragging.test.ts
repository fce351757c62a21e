// SPDX-License-Identifier: MIT
// Dragging in the view: locks, steps, several points at once, boxes, pins.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { type ObjMesh, readObj } from "../browser/support/obj.ts";
import { exportAs, idle, movedCount, openFile, still } from "../browser/support/page.ts";
import {
  type HandleRow,
  handleRows,
  hintedPoint,
  middleOf,
  type Place,
  press,
  viewBox,
} from "../browser/support/view.ts";
import { site } from "./support/site.ts";

let base: ObjMesh | null = null;

const ROOMY = { width: 1280, height: 800 };

/** A fresh page; the first time also reads its mesh, by export. */
async function openPage(viewport = { width: 900, height: 640 }): Promise<Page> {
  const page = await site.openVault({ viewport });
  base ??= readObj((await exportAs(page, "OBJ")).toString());
  return page;
}

const offset = ({ vertex, target }: HandleRow): number[] =>
  target.map((x, axis) => x - (base?.points[vertex]?.[axis] ?? 0));

/** Of the first handle. */
async function firstOffset(page: Page): Promise<number[]> {
  const [row] = await handleRows(page);
  if (!row) throw new Error("no handle");
  return offset(row);
}

async function release(page: Page): Promise<void> {
  await page.mouse.up();
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
}

/** Drags the hinted point by an oblique way, with `keys` pressed on the way; gives its offset. Twice as far in
 * a level plane is 8 m of a vault of 20 m, where nothing flat is found, and that takes the solver its time. */
async function dragWith(page: Page, ...keys: readonly string[]): Promise<number[]> {
  const from = await hintedPoint(page);
  await press(page, from, { x: from.x + 15, y: from.y - 15 });
  for (const key of keys) await page.keyboard.press(key);
  await page.mouse.move(from.x + 21, from.y - 28);
  await release(page);
  return firstOffset(page);
}

const pressed = (page: Page, name: string): Promise<string | null> =>
  page.getByRole("button", { name, exact: true }).getAttribute("aria-pressed");

/** A wall of 8 × 8 squares, along X and up. */
function wall(): string {
  const places = Array.from({ length: 81 }, (_, k) => `v ${k % 9} 0 ${Math.floor(k / 9)}`);
  const faces = Array.from({ length: 64 }, (_, k) => {
    const a = Math.floor(k / 8) * 9 + (k % 8) + 1;
    return `f ${a} ${a + 1} ${a + 10} ${a + 9}`;
  });
  return [...places, ...faces].join("\n");
}

/** A finger on the view. */
const touch = (page: Page, type: string, { x, y }: Place): Promise<void> =>
  page.evaluate(
    ([event, clientX, clientY]) => {
      const touched = { pointerType: "touch", isPrimary: true, pointerId: 2 };
      const at = { bubbles: true, cancelable: true, clientX, clientY };
      document
        .querySelector("canvas")
        ?.dispatchEvent(new PointerEvent(event, { ...touched, ...at }));
    },
    [type, x, y] as const,
  );

describe("a drag without a lock", () => {
  it("goes up on a roof, and with Alt where the pointer goes", async () => {
    const page = await openPage();
    const [x, y, z] = await dragWith(page);
    expect([x, y]).toEqual([0, 0]);
    expect(z).toBeGreaterThan(0.1);
    await page.getByRole("button", { name: "Undo" }).click();
    await expect.poll(() => movedCount(page)).toBe(0);
    const [row] = await handleRows(page);
    expect(row).toBeUndefined();
    await page.context().close();
    const other = await openPage();
    const from = await hintedPoint(other);
    await other.keyboard.down("Alt");
    await press(other, from, { x: from.x + 42, y: from.y - 10 });
    await release(other);
    await other.keyboard.up("Alt");
    const free = await firstOffset(other);
    expect(Math.hypot(...free.slice(0, 2))).toBeGreaterThan(0.1);
    await other.context().close();
  });

  it("says on the way what frees it, once the pointer is well aside of its line", async () => {
    const page = await openPage();
    const from = await hintedPoint(page);
    const words = page.getByText("It goes up and down only: hold Alt to move it freely.");
    await press(page, from, { x: from.x + 20, y: from.y - 6 });
    await idle(page);
    expect(await words.count()).toBe(0);
    await page.mouse.move(from.x + 90, from.y - 6);
    await idle(page);
    expect(await words.count()).toBe(1);
    await page.mouse.move(from.x + 10, from.y - 8);
    await idle(page);
    expect(await words.count()).toBe(0);
    await release(page);
    // Sideways is no way along the line.
    expect((await firstOffset(page)).slice(0, 2)).toEqual([0, 0]);
    await page.context().close();
  });

  it("says to a finger what frees it where there is no key", async () => {
    const page = await openPage();
    const from = await hintedPoint(page);
    const words = page.getByText(
      "It goes up and down only: lift your finger, then choose another axis above.",
    );
    await touch(page, "pointerdown", { x: from.x, y: from.y });
    await touch(page, "pointermove", { x: from.x + 20, y: from.y });
    await idle(page);
    expect(await words.count()).toBe(0);
    await touch(page, "pointermove", { x: from.x + 90, y: from.y });
    await idle(page);
    expect(await words.count()).toBe(1);
    await touch(page, "pointerup", { x: from.x + 90, y: from.y });
    await idle(page);
    expect(await words.count()).toBe(0);
    await page.context().close();
  });

  it("goes out of a wall, and along it where that points at the viewer", async () => {
    const page = await site.openVault();
    await openFile(page, "wall.obj", wall());
    await page.getByRole("button", { name: "Start editing" }).click();
    const pull = async (): Promise<readonly number[]> => {
      await page.getByRole("button", { name: "Add handle" }).click();
      await idle(page);
      const [before] = await handleRows(page);
      if (!before) throw new Error("no handle");
      const from = await middleOf(page, page.locator(".marker").first());
      await press(page, from, { x: from.x + 30, y: from.y + 24 });
      await page.mouse.up();
      await idle(page);
      const [after] = await handleRows(page);
      return (after?.target ?? []).map((value, axis) => value - (before.target[axis] ?? 0));
    };
    const out = await pull();
    expect([out[0], out[2]]).toEqual([0, 0]);
    expect(Math.abs(out[1] ?? 0)).toBeGreaterThan(0.1);
    await page.getByRole("button", { name: "Remove" }).click();
    await idle(page);
    await page.getByRole("button", { name: "Front", exact: true }).click();
    const along = await pull();
    expect(Math.abs(along[1] ?? 1)).toBeLessThan(1e-9);
    expect(along[0]).toBeGreaterThan(0.1);
    expect(along[2]).toBeLessThan(-0.1);
    await page.context().close();
  });
});

describe("a drag", () => {
  it("is held to an axis by its key, and keeps the other coordinates' bits", async () => {
    const page = await openPage();
    const [x, y, z] = await dragWith(page, "z");
    expect([x, y]).toEqual([0, 0]);
    expect(z).toBeGreaterThan(0.1);
    // A lock chosen in a drag ends with it.
    expect(await pressed(page, "Lock to Z")).toBe("false");
    await page.context().close();
  });

  it("is held to a plane by Shift and a key", async () => {
    const page = await openPage();
    const [x, y, z] = await dragWith(page, "Shift+Z");
    expect(z).toBe(0);
    expect(Math.hypot(x ?? 0, y ?? 0)).toBeGreaterThan(0.1);
    await page.context().close();
  });

  it("is held to the normal of the surface", async () => {
    const page = await openPage();
    const along = await dragWith(page, "n");
    const [row] = await handleRows(page);
    const faces = base?.faces.filter((face) => face.includes(row?.vertex ?? -1));
    // Every edge at a point of a smooth shell is nearly at right angles to its normal.
    const length = Math.hypot(...along);
    for (const face of faces ?? []) {
      const [a = [], b = []] = face.map((v) => base?.points[v] ?? []);
      const edge = a.map((value, k) => value - (b[k] ?? 0));
      const cosine =
        edge.reduce((sum, value, k) => sum + value * (along[k] ?? 0), 0) /
        (length * Math.hypot(...edge));
      expect(Math.abs(cosine)).toBeLessThan(0.2);
    }
    expect(length).toBeGreaterThan(0.1);
    await page.context().close();
  });

  it("goes in steps with Snap, and home again near the base position", async () => {
    const page = await openPage();
    await page.getByRole("button", { name: "Snap", exact: true }).click();
    const step = page.getByRole("spinbutton", { name: "Snap step" });
    await step.fill("25cm");
    await step.press("Enter");
    const from = await hintedPoint(page);
    await press(page, from, { x: from.x + 23, y: from.y - 60 });
    await release(page);
    for (const part of await firstOffset(page))
      expect(Math.abs(part / 0.25 - Math.round(part / 0.25))).toBeLessThan(1e-6);
    await page.keyboard.press("Control+z");
    await expect.poll(() => movedCount(page)).toBe(0);
    await press(page, from, { x: from.x, y: from.y - 40 }, { x: from.x + 4, y: from.y + 3 });
    await page.mouse.up();
    await idle(page);
    expect(Math.hypot(...(await firstOffset(page)))).toBeLessThan(1e-6);
    expect(await movedCount(page)).toBe(0);
    await page.context().close();
  });

  it("is given up by Escape", async () => {
    const page = await openPage();
    const from = await hintedPoint(page);
    await press(page, from, { x: from.x, y: from.y - 40 });
    await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
    await page.keyboard.press("Escape");
    await expect.poll(() => movedCount(page)).toBe(0);
    expect(await handleRows(page)).toEqual([]);
    await page.mouse.up();
    await page.context().close();
  });
});

describe("several points", () => {
  it("are chosen in a box and move together, as one step", async () => {
    const page = await openPage(ROOMY);
    const { x, y } = await hintedPoint(page);
    await page.getByRole("button", { name: "Select in a box" }).click();
    await press(page, { x: x - 66, y: y - 56 }, { x: x + 66, y: y + 56 });
    await page.mouse.up();
    expect(await movedCount(page)).toBe(0);
    await page.getByRole("button", { name: "Lock to Z" }).click();
    await press(page, { x, y }, { x, y: y - 30 });
    await release(page);
    // Many are one row until they are asked for.
    await page.getByRole("button", { name: "List" }).click();
    const rows = await handleRows(page);
    expect(rows.length).toBeGreaterThan(10);
    const [first = []] = rows.map(offset);
    for (const row of rows) {
      expect(offset(row).slice(0, 2)).toEqual([0, 0]);
      expect(offset(row)[2]).toBeCloseTo(first[2] ?? Number.NaN, 9);
    }
    await page.getByRole("button", { name: "Undo" }).click();
    await expect.poll(() => movedCount(page)).toBe(0);
    expect(await handleRows(page)).toEqual([]);
    await page.context().close();
  });

  it("are those in the last box; with Shift a box adds, and an empty one clears", async () => {
    const page = await openPage(ROOMY);
    const { x, y } = await hintedPoint(page);
    const pins = page.getByRole("button", { name: "Pin selected points" });
    const rows = async (): Promise<number[]> => {
      await pins.click();
      await idle(page);
      const found = (await handleRows(page)).map((row) => row.vertex);
      await page.getByRole("button", { name: "Undo" }).click();
      await expect.poll(() => handleRows(page)).toEqual([]);
      return found;
    };
    const box = async (at: Place, kind: "tool" | "Shift"): Promise<void> => {
      if (kind === "tool") await page.getByRole("button", { name: "Select in a box" }).click();
      else await page.keyboard.down("Shift");
      // Small, for the table shows no more than 40 handles.
      await press(page, { x: at.x - 12, y: at.y - 12 }, { x: at.x + 12, y: at.y + 12 });
      await page.mouse.up();
      if (kind === "Shift") await page.keyboard.up("Shift");
    };
    await box({ x, y }, "tool");
    const first = await rows();
    await box({ x: x + 70, y }, "tool");
    const second = await rows();
    expect(second.length).toBeGreaterThan(0);
    expect(second.filter((vertex) => first.includes(vertex))).toEqual([]);
    await box({ x, y }, "Shift");
    expect((await rows()).toSorted()).toEqual([...first, ...second].toSorted());
    const { x: left, y: top } = await viewBox(page);
    await box({ x: left + 60, y: top + 150 }, "Shift");
    expect(await pins.isDisabled()).toBe(false);
    await box({ x: left + 60, y: top + 150 }, "tool");
    expect(await pins.isDisabled()).toBe(true);
    await page.context().close();
  });

  it("are chosen by keys, pinned and let go; Escape chooses none", async () => {
    const page = await openPage();
    await page.getByLabel("3D view").focus();
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Control+ArrowUp");
    await page.keyboard.press("Control+ArrowRight");
    await page.getByRole("button", { name: "Pin selected points" }).click();
    await idle(page);
    const rows = await handleRows(page);
    expect(rows.map((row) => row.pinned)).toEqual([true, true, true]);
    expect(await pressed(page, "Pin selected points")).toBe("true");
    await page.getByRole("button", { name: "Pin selected points" }).click();
    await idle(page);
    // They were to go nowhere: what is let go is no handle.
    expect(await handleRows(page)).toEqual([]);
    await page.getByLabel("3D view").focus();
    await page.keyboard.press("Escape");
    expect(await page.getByRole("button", { name: "Pin selected points" }).isDisabled()).toBe(true);
    await page.context().close();
  });

  it("are chosen by Ctrl and clicks", async () => {
    const page = await openPage();
    const { x, y } = await hintedPoint(page);
    await page.mouse.click(x, y);
    await page.keyboard.down("Control");
    await page.keyboard.press("ArrowRight");
    await page.mouse.click(x, y);
    await page.keyboard.up("Control");
    await page.getByRole("button", { name: "Pin selected points" }).click();
    await idle(page);
    expect((await handleRows(page)).length).toBe(1);
    await page.context().close();
  });
});

it("an arrow at the chosen point moves it along its axis alone", async () => {
  const page = await openPage();
  const { x, y } = await hintedPoint(page);
  await page.mouse.click(x, y);
  await still(page); // the arrows are fetched with the first chosen point
  await press(page, { x, y: y - 40 }, { x: x + 25, y: y - 80 });
  await release(page);
  const moved = await firstOffset(page);
  expect(moved.slice(0, 2)).toEqual([0, 0]);
  expect(moved[2]).toBeGreaterThan(0.1);
  await page.context().close();
});

it("the arrows of several points stand in their middle, and move all of them", async () => {
  const page = await openPage(ROOMY);
  const { x, y } = await hintedPoint(page);
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowUp");
  for (let k = 0; k < 4; ++k) await page.keyboard.press("Control+ArrowRight");
  await page.getByText("5 points", { exact: true }).waitFor();
  await still(page);
  const marks = await Promise.all(
    (await page.locator(".marker.selected").all()).map((mark) => mark.boundingBox()),
  );
  const mean = (of: "x" | "y"): number =>
    marks.reduce((sum, box) => sum + (box?.[of] ?? 0) + 8, 0) / marks.length;
  // Beside all of the points, over their middle.
  const at = { x: mean("x"), y: mean("y") - 40 };
  expect(Math.hypot(at.x - x, at.y - y)).toBeGreaterThan(20);
  await press(page, at, { x: at.x, y: at.y - 40 });
  await release(page);
  const rows = await handleRows(page);
  expect(rows).toHaveLength(5);
  const [first] = rows;
  for (const row of rows) {
    expect(offset(row).slice(0, 2)).toEqual([0, 0]);
    expect(offset(row)[2]).toBeCloseTo(offset(first ?? row)[2] ?? Number.NaN, 9);
  }
  expect(offset(first ?? { vertex: 0, target: [], pinned: false })[2]).toBeGreaterThan(0.1);
  await page.context().close();
});

it("points move by typed amounts along the surface and out of it", async () => {
  const page = await openPage();
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowUp");
  await page.getByText("Move along the surface").click();
  const out = page.getByRole("spinbutton", { name: "Out" });
  await out.fill("(3+4)*50mm");
  await out.press("Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  const moved = await firstOffset(page);
  expect(Math.hypot(...moved)).toBeCloseTo(0.35, 9);
  expect(moved[2]).toBeGreaterThan(0.3);
  await page.context().close();
});
