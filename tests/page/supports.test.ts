// SPDX-License-Identifier: MIT
// Points stand on what is chosen for them: their coordinates keep their bits, and the design says so
// wherever it goes.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { readObj } from "../browser/support/obj.ts";
import { idle, movedCount, obj, openRule, ruleChip } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

async function stand(page: Page, words: string): Promise<void> {
  await page.getByRole("combobox", { name: /^Selected: / }).selectOption(words);
  await idle(page);
}

async function type(page: Page, axis: string, by: string): Promise<void> {
  const field = page
    .getByRole("table", { name: "Handles" })
    .getByRole("spinbutton", { name: axis });
  await field.first().fill(by);
  await field.first().press("Enter");
  await idle(page);
}

it("a point keeps its level to the last digit, in the design and its link, until it is let go", async () => {
  const page = await site.open({ permissions: ["clipboard-read", "clipboard-write"] });
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  const vertex = Number(await page.getByRole("button", { name: /^Select point/ }).innerText());
  const before = await obj(page);
  await openRule(page, "Supports");
  await stand(page, "keep their level");
  expect(await ruleChip(page, "Supports").innerText()).toBe("Supports 1");
  await type(page, "X", "+30cm");
  await type(page, "Z", "+20cm");
  expect(await movedCount(page)).toBeGreaterThan(1);
  const at = (text: string): string[] => readObj(text).lines[vertex]?.split(" ") ?? [];
  const held = await obj(page);
  const [[x0 = "", , z0], [x = "", , z]] = [at(before), at(held)];
  expect(z).toBe(z0);
  expect(Number(x) - Number(x0)).toBeGreaterThan(0.2);
  await page.getByRole("button", { name: "Let go" }).click();
  await idle(page);
  expect(Number(at(await obj(page))[2]) - Number(z0)).toBeGreaterThan(0.15);
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  const other = await site.open({}, new URL(link).hash);
  await other.getByText(/^Verified:/).waitFor();
  expect(await obj(other)).toBe(held);
  expect(await ruleChip(other, "Supports").innerText()).toBe("Supports 1");
  await other.context().close();
  await page.context().close();
});

type Point = readonly number[];

/** How far `point` is from the segments between points that follow each other. */
function distanceTo(line: readonly Point[], point: Point): number {
  const minus = (a: Point, b: Point): number[] => a.map((x, k) => x - (b[k] ?? 0));
  const dot = (a: Point, b: Point): number => a.reduce((sum, x, k) => sum + x * (b[k] ?? 0), 0);
  const distances = line.slice(1).map((end, k) => {
    const [start = end] = line.slice(k);
    const [along, way] = [minus(end, start), minus(point, start)];
    const share = Math.min(Math.max(dot(along, way) / dot(along, along), 0), 1);
    return Math.hypot(
      ...minus(
        way,
        along.map((x) => share * x),
      ),
    );
  });
  return Math.min(...distances);
}

it("the points of a line stay on it, and the link says so", async () => {
  const page = await site.openVault({ permissions: ["clipboard-read", "clipboard-write"] });
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  const select = page.getByRole("button", { name: /^Select point/ });
  const handle = Number(await select.innerText());
  const drawn = readObj(await obj(page)).points;
  await select.click();
  await openRule(page, "Supports");
  const choice = page.getByRole("combobox", { name: /^Selected: / });
  expect(await choice.getByRole("option", { name: "stay on their line" }).count()).toBe(0);
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("Control+ArrowRight");
  await page.getByRole("button", { name: "Line", exact: true }).click();
  await stand(page, "stay on their line");
  const count = Number(/\d+/.exec(await ruleChip(page, "Supports").innerText())?.[0]);
  for (const [axis, by] of Object.entries({ X: "+40cm", Y: "+30cm", Z: "+20cm" }))
    await type(page, axis, by);
  expect(await movedCount(page)).toBeGreaterThan(1);
  const held = readObj(await obj(page)).points;
  // A line of the vault has one x or one y; which of both was selected is a matter of the view.
  const off = [0, 1].map((across) => {
    const of = (vertex: number): number => drawn[vertex]?.[across] ?? 0;
    const line = [...drawn.keys()].filter((vertex) => Math.abs(of(vertex) - of(handle)) < 1e-9);
    expect(line.length).toBe(count);
    const polygon = line
      .map((vertex) => drawn[vertex] ?? [])
      .sort((a, b) => (a[1 - across] ?? 0) - (b[1 - across] ?? 0));
    return Math.max(...line.map((vertex) => distanceTo(polygon, held[vertex] ?? [])));
  });
  expect(Math.min(...off)).toBeLessThan(1e-9);
  expect(Math.max(...off)).toBeGreaterThan(1e-4);
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  const other = await site.open({}, new URL(link).hash);
  await other.getByText(/^Verified:/).waitFor();
  expect(readObj(await obj(other)).points).toEqual(held);
  expect(await ruleChip(other, "Supports").innerText()).toBe(`Supports ${count}`);
  await other.context().close();
  await page.context().close();
});

/** Through three points, at `x`. */
function parabolaThrough(points: readonly (readonly [number, number])[], x: number): number {
  return points.reduce((sum, [at, value]) => {
    const others = points.filter(([other]) => other !== at);
    return sum + others.reduce((part, [other]) => (part * (x - other)) / (at - other), value);
  }, 0);
}

it("all points stay on the surface, and the link says so", async () => {
  const page = await site.openVault({ permissions: ["clipboard-read", "clipboard-write"] });
  const drawn = readObj(await obj(page)).points;
  await openRule(page, "Supports");
  await page.getByRole("checkbox", { name: "All points stay on the surface" }).check();
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  for (const [axis, by] of Object.entries({ X: "+40cm", Y: "+30cm" })) await type(page, axis, by);
  const held = readObj(await obj(page)).points;
  // The vault is z = f(x) + g(y): the points of two of its lines say what it is between them.
  const height = ([x = 0, y = 0]: readonly number[]): number => {
    const across = (axis: 0 | 1, value: number): number => {
      const [first = []] = drawn;
      const line = drawn.filter((point) => point[1 - axis] === first[1 - axis]);
      const beside = line.sort(
        (a, b) => Math.abs((a[axis] ?? 0) - value) - Math.abs((b[axis] ?? 0) - value),
      );
      return parabolaThrough(
        beside.slice(0, 3).map((point) => [point[axis] ?? 0, point[2] ?? 0]),
        value,
      );
    };
    return across(0, x) + across(1, y) - (drawn[0]?.[2] ?? 0);
  };
  const moved = held.filter((point, k) => point.some((value, axis) => value !== drawn[k]?.[axis]));
  expect(moved.length).toBeGreaterThan(9);
  const off = moved.map((point) => Math.abs((point[2] ?? 0) - height(point)));
  expect(Math.max(...off)).toBeLessThan(0.005);
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  const other = await site.open({}, new URL(link).hash);
  await other.getByText(/^Verified:/).waitFor();
  expect(readObj(await obj(other)).points).toEqual(held);
  await openRule(other, "Supports");
  const box = other.getByRole("checkbox", { name: "All points stay on the surface" });
  expect(await box.isChecked()).toBe(true);
  await other.context().close();
  await page.context().close();
});
