// SPDX-License-Identifier: MIT
// What the edit's limits promise: nothing beyond the reach moves, a kept boundary stays, and a drag is
// held back before panels fold sharply. A new visitor has them.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { type ObjMesh, readObj } from "../browser/support/obj.ts";
import {
  exportAs,
  idle,
  movedCount,
  openAdvanced,
  openFile,
  openRule,
  status,
  typeTarget,
} from "../browser/support/page.ts";
import { handleRows, hintedPoint, middleOf, press } from "../browser/support/view.ts";
import { site } from "./support/site.ts";

async function slide(page: Page, name: string, value: string): Promise<void> {
  await page.getByRole("slider", { name }).fill(value);
  await idle(page);
}

const exported = async (page: Page): Promise<ObjMesh> =>
  readObj((await exportAs(page, "OBJ")).toString());

/** Points on edges that one panel alone uses. */
function boundaryOf({ faces }: ObjMesh): Set<number> {
  const uses = new Map<string, number>();
  const sides = faces.flatMap((face) =>
    face.map((v, k) => [v, face[(k + 1) % face.length] ?? v].sort((a, b) => a - b)),
  );
  for (const side of sides) uses.set(side.join(), (uses.get(side.join()) ?? 0) + 1);
  return new Set(sides.filter((side) => uses.get(side.join()) === 1).flat());
}

function within({ faces }: ObjMesh, from: number, rings: number): Set<number> {
  let inside = new Set([from]);
  for (let ring = 0; ring < rings; ++ring) {
    inside = new Set([...faces.filter((f) => f.some((v) => inside.has(v))).flat(), ...inside]);
  }
  return inside;
}

const movedIn = (edited: ObjMesh, base: ObjMesh): number[] =>
  edited.lines.flatMap((line, v) => (line === base.lines[v] ? [] : [v]));

async function handle(page: Page): Promise<number> {
  const [row] = await handleRows(page);
  if (!row) throw new Error("no handle");
  return row.vertex;
}

/** "" where it is free. */
const boundaryIs = (page: Page): Promise<string> =>
  page.getByRole("combobox", { name: "Boundary" }).inputValue();

it("a new visitor's edit stays in its reach, and the boundary stays, to the last digit", async () => {
  const page = await site.open();
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  expect(await page.getByRole("slider", { name: "Reach" }).inputValue()).toBe("6");
  expect(await page.getByRole("slider", { name: "Softness" }).inputValue()).toBe("5");
  expect(await boundaryIs(page)).toBe("fixed");
  const base = await exported(page);
  await typeTarget(page, "+50cm");
  const boundary = boundaryOf(base);
  const panels: number[] = [];
  // Whatever the sliders say.
  for (const [reach, softness] of [
    ["6", "5"],
    ["4", "10"],
    ["2", "1"],
  ] as const) {
    await slide(page, "Reach", reach);
    await slide(page, "Softness", softness);
    const edited = await exported(page);
    const moved = movedIn(edited, base);
    const near = within(base, await handle(page), Number(reach));
    expect(moved.length).toBeGreaterThan(2);
    expect(moved.filter((v) => !near.has(v))).toEqual([]);
    expect(moved.filter((v) => boundary.has(v))).toEqual([]);
    const effect = page.getByText(new RegExp(`^${moved.length} points, \\d+ panels again$`));
    await effect.waitFor();
    const [, again] = /, (\d+) panels/.exec((await effect.textContent()) ?? "") ?? [];
    panels.push(Number(again));
    await page
      .getByText(/^sharpest fold [\d.]+° \(was [\d.]+°\)$/)
      .first()
      .waitFor();
  }
  expect(await status(page)).toMatch(/ · sharpest fold [\d.]+° \(was [\d.]+°\) · /);
  // A shorter reach says what it saves.
  expect(panels[0]).toBeGreaterThan(panels[1] ?? 0);
  expect(panels[1]).toBeGreaterThan(panels[2] ?? 0);
  expect(panels[2]).toBeGreaterThan(0);
  await page.context().close();
});

it("a point on a kept boundary moves where it is dragged, alone of the boundary", async () => {
  const page = await site.open();
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  const base = await exported(page);
  const boundary = boundaryOf(base);
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowUp");
  for (let k = 0; k < 12; ++k) await page.keyboard.press("ArrowLeft");
  await typeTarget(page, "+10cm");
  const vertex = await handle(page);
  expect(boundary.has(vertex)).toBe(true);
  const moved = movedIn(await exported(page), base);
  expect(moved.filter((v) => boundary.has(v))).toEqual([vertex]);
  await page.context().close();
});

/** Distance of a point from the nearest boundary edge of `base`. */
function offOutline(base: ObjMesh, point: readonly number[]): number {
  const uses = new Map<string, [number, number, number]>();
  for (const face of base.faces) {
    for (const [k, a] of face.entries()) {
      const b = face[(k + 1) % face.length] ?? a;
      const key = [a, b].sort((x, y) => x - y).join();
      uses.set(key, [a, b, (uses.get(key)?.[2] ?? 0) + 1]);
    }
  }
  const edges = [...uses.values()].filter(([, , count]) => count === 1);
  const at = (v: number): readonly number[] => base.points[v] ?? [];
  const distances = edges.map(([a, b]) => {
    const along = at(a).map((x, c) => (at(b)[c] ?? 0) - x);
    const way = at(a).map((x, c) => (point[c] ?? 0) - x);
    const dot = (u: readonly number[], w: readonly number[]): number =>
      u.reduce((sum, x, c) => sum + x * (w[c] ?? 0), 0);
    const share = Math.min(1, Math.max(0, dot(way, along) / dot(along, along)));
    return Math.hypot(...way.map((x, c) => x - share * (along[c] ?? 0)));
  });
  return Math.min(...distances);
}

it("a boundary that moves stays on its level or its outline, and the design says so", async () => {
  const page = await site.open();
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  const base = await exported(page);
  const boundary = boundaryOf(base);
  const slides = page.getByRole("combobox", { name: "Boundary" });
  await slides.selectOption("free");
  await idle(page);
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowUp");
  // A point whose sides slope one way: on top of an arch nothing could go up.
  for (let k = 0; k < 14; ++k) await page.keyboard.press("ArrowRight");
  await typeTarget(page, "+30cm");
  const vertex = await handle(page);
  expect(boundary.has(vertex)).toBe(true);
  const free = await exported(page);
  expect(free.points[vertex]?.[2]).not.toBe(base.points[vertex]?.[2]);

  await slides.selectOption("keeps its level");
  await idle(page);
  const level = await exported(page);
  for (const v of boundary) expect(level.points[v]?.[2]).toBe(base.points[v]?.[2]);

  await slides.selectOption("on its outline");
  await idle(page);
  const outline = await exported(page);
  for (const v of boundary) {
    expect(offOutline(base, outline.points[v] ?? [])).toBeLessThan(1e-8);
  }
  expect(movedIn(outline, base).length).toBeGreaterThan(2);
  const design = JSON.parse((await exportAs(page, "JSON")).toString());
  expect(design.supports).toEqual(["outline:boundary"]);
  await page.context().close();
});

it("raw weights are the command line's, in Advanced; Softness takes over again", async () => {
  const page = await site.open();
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  await typeTarget(page, "+50cm");
  const soft = await movedCount(page);
  await openAdvanced(page);
  const locality = page.getByRole("slider", { name: "Locality" });
  expect(await locality.isDisabled()).toBe(true);
  const choice = page.getByRole("combobox", { name: "Bends by" });
  await choice.selectOption("Raw weights");
  await idle(page);
  expect(await locality.isDisabled()).toBe(false);
  expect(await locality.inputValue()).toBe("1");
  expect(await boundaryIs(page)).toBe("");
  await page.getByText("no limit", { exact: true }).first().waitFor();
  const raw = await movedCount(page);
  expect(raw).not.toBe(soft);
  const vault = await site.openVault({ size: 21 });
  await typeTarget(vault, "+50cm");
  expect(await movedCount(vault)).toBe(raw);
  await vault.context().close();
  await choice.selectOption("Reach and softness");
  await idle(page);
  expect(await movedCount(page)).toBe(soft);
  await page.context().close();
});

/** Millimetres that panels allow, and that were asked for, of the note that says so. */
async function allowed(page: Page): Promise<readonly number[]> {
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  const said = /(?:allow|at) (\d+) of (\d+) mm/.exec((await why.textContent()) ?? "");
  const [, got, asked] = said ?? [];
  return [Number(got), Number(asked)];
}

/** Degrees by which the sharpest fold is sharper than it was, as the status line says. */
async function sharpening(page: Page): Promise<number> {
  const [, now, before] =
    /sharpest fold ([\d.]+)° \(was ([\d.]+)°\)/.exec(await status(page)) ?? [];
  return Number(now) - Number(before);
}

it("where a drag is held back, it ends with its limit, and opens again as it was", async () => {
  const page = await site.open();
  const at = await hintedPoint(page);
  // Another number, taken back, is not what the limit of the drag shows.
  await openRule(page, "Limits");
  const limit = page.getByRole("checkbox", { name: "Folds sharper by" });
  await limit.check();
  await idle(page);
  await limit.uncheck();
  await idle(page);
  await press(page, at, { x: at.x, y: at.y - 140 });
  const said = page.getByText(/^Held back: /);
  await said.waitFor();
  expect(await said.textContent()).toContain("fold more than 10° sharper. Shift goes through.");
  await page.mouse.up();
  await idle(page);
  const held = JSON.parse((await exportAs(page, "JSON")).toString());
  expect(held.options.bounds).toEqual(["fold=+10"]);
  expect(await limit.isChecked()).toBe(true);
  const degrees = page.getByRole("textbox", { name: "Folds sharper by" });
  expect(await degrees.inputValue()).toBe("10");
  expect(await sharpening(page)).toBeLessThan(10.5);
  const [stop] = await handleRows(page);
  const edited = await exported(page);
  await openFile(page, "held.json", JSON.stringify(held));
  await page.getByText(/^Verified:/).waitFor();
  expect((await exported(page)).lines).toEqual(edited.lines);
  expect((await handleRows(page))[0]?.target).toEqual(stop?.target);
  await page.context().close();
});

it("a drag ends where it was held back, and presses go on towards the same target", async () => {
  const page = await site.open();
  const at = await hintedPoint(page);
  // Further than any edit within the reach gets, whichever way its frames went.
  await press(page, at, { x: at.x, y: at.y - 240 });
  await page.getByText(/^Held back: /).waitFor();
  await expect.poll(() => page.locator(".pull.open").count()).toBe(1);
  const [shown] = await handleRows(page);
  await page.mouse.up();
  await idle(page);
  expect((await handleRows(page))[0]?.target).toEqual(shown?.target);
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  expect(await why.textContent()).toMatch(
    /^Held back at \d+ of \d+ mm here\. Dragged on, folds would be more than 10° sharper\./,
  );
  const [held = Number.NaN] = await allowed(page);
  await page.getByRole("button", { name: "Within the limit", exact: true }).click();
  await idle(page);
  expect(await why.textContent()).toContain("Further, folds would be more than 10° sharper.");
  expect(await page.getByRole("button", { name: "Within the limit" }).count()).toBe(0);
  const [got = Number.NaN, asked = Number.NaN] = await allowed(page);
  // One solve with the limit lets it go so far.
  expect(got).toBeGreaterThan(1.2 * held);
  expect(got).toBeGreaterThan(0.4 * asked);
  expect(got).toBeLessThan(0.85 * asked);
  expect(await sharpening(page)).toBeLessThan(10.5);
  await page.getByRole("button", { name: "Reach 9 panels", exact: true }).click();
  await idle(page);
  expect(await page.getByText(/^Panels allow/).count()).toBe(0);
  await expect.poll(() => page.locator(".pull.open").count()).toBe(0);
  expect(await sharpening(page)).toBeLessThan(10.5);
  const [there] = await handleRows(page);
  expect(there?.target[2]).toBeGreaterThan(16);
  await page.context().close();
});

it("each way on says how far it gets, the furthest first, and a press gets there", async () => {
  const page = await site.openSmall();
  const at = await hintedPoint(page);
  await press(page, at, { x: at.x, y: at.y - 240 });
  await page.getByText(/^Held back: /).waitFor();
  await page.mouse.up();
  await idle(page);
  const moved = await movedCount(page);
  const edited = await exported(page);
  const ways = page.getByRole("group", { name: "Get further" });
  const figures = ways.locator(".way-on .quiet");
  await expect.poll(() => figures.count(), { timeout: 60_000 }).toBeGreaterThan(0);
  await expect.poll(() => ways.getAttribute("aria-busy"), { timeout: 60_000 }).toBe("false");
  expect(await movedCount(page)).toBe(moved); // nothing was changed by trying
  expect((await exported(page)).lines).toEqual(edited.lines);
  const texts = await ways.locator(".way-on").allTextContents();
  expect(texts.length).toBeGreaterThan(1);
  const got = texts.map((text) => {
    const [, far] =
      /(all the way|no further|[\d.]+ m?m)(?:, [\d.]+°)?(?:spoils \d+ panels?)?$/.exec(text) ?? [];
    if (far === "all the way") return Number.POSITIVE_INFINITY;
    return far === "no further"
      ? 0
      : Number.parseFloat(far ?? "") * (far?.endsWith("mm") ? 1 : 1000);
  });
  expect(
    got.every((far) => far >= 0),
    texts.join("\n"),
  ).toBe(true);
  expect(got).toEqual([...got].sort((a, b) => b - a));
  const shared = /^Within the limit(all the way|\d+ mm)/.exec(
    texts.find((text) => text.startsWith("Within")) ?? "",
  );
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  expect(await why.textContent()).toMatch(
    new RegExp(`^Held back at \\d+ of \\d+ mm here, ${shared?.[1]} sharing the bend\\. Dragged on`),
  );
  expect(got[0]).toBe(Number.POSITIVE_INFINITY);
  const first =
    /^(Within the limit|Reach 9 panels|Softer|Folds up to \d+°|Let the boundary move|Meet it exactly)/.exec(
      texts[0] ?? "",
    )?.[1];
  await page.getByRole("button", { name: first ?? "", exact: true }).click();
  await idle(page);
  expect(await page.getByText(/^Panels allow/).count()).toBe(0);
  await page.context().close();
});

it("a way on that gets less far leaves the design as it was; the others get as far as they say", async () => {
  const page = await site.openSmall();
  await page.getByLabel("3D view").focus();
  await page.keyboard.press("ArrowUp");
  // On the boundary, where frames get further than an edit of the whole pull.
  for (let k = 0; k < 5; ++k) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  const { x, y } = await middleOf(page, page.locator(".marker:not([hidden])").first());
  await page.keyboard.press("Escape");
  await press(page, { x, y }, ...Array.from({ length: 20 }, (_, k) => ({ x, y: y - 8 * k - 8 })));
  await page.mouse.up();
  await idle(page);
  const [held] = await allowed(page);
  const edited = await exported(page);
  await page.getByRole("button", { name: "Within the limit", exact: true }).click();
  await idle(page);
  await page.getByText(/^Within the limit gets no further: \d+ of \d+ mm\.$/).waitFor();
  expect((await allowed(page))[0]).toBe(held);
  expect((await exported(page)).lines).toEqual(edited.lines);
  const ways = page.getByRole("group", { name: "Get further" });
  await expect.poll(() => ways.locator(".way-on .quiet").count()).toBeGreaterThan(0);
  await expect.poll(() => ways.getAttribute("aria-busy"), { timeout: 60_000 }).toBe("false");
  expect(await ways.getByRole("button", { name: "Within the limit" }).count()).toBe(0);
  // What keeps the limit says so: its figure is of an edit with the limit.
  const reach = await ways.locator(".way-on", { hasText: "Reach 9 panels" }).allTextContents();
  for (const text of reach) {
    expect(Number(/, ([\d.]+)°/.exec(text)?.[1])).toBeLessThan(31);
  }
  const [first = ""] = await ways.locator(".way-on").allTextContents();
  const [, label = "", far] = /^(.*?)(all the way|[\d.]+ mm)/.exec(first) ?? [];
  await page.getByRole("button", { name: label, exact: true }).click();
  await idle(page);
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  if (far === "all the way") expect(await why.count()).toBe(0);
  else expect((await allowed(page))[0]).toBe(Number.parseFloat(far ?? ""));
  await page.context().close();
});

/** Types a height for the first handle; how far *As far as it goes* says that it gets, and how far a press does. */
async function farthest(z: string): Promise<readonly number[]> {
  const page = await site.openSmall();
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  const field = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton", { name: "Z" });
  await field.first().fill(z);
  await field.first().press("Enter");
  await idle(page);
  const ways = page.getByRole("group", { name: "Get further" });
  await expect.poll(() => ways.locator(".way-on .quiet").count()).toBeGreaterThan(0);
  await expect.poll(() => ways.getAttribute("aria-busy"), { timeout: 60_000 }).toBe("false");
  const search = page.getByRole("button", { name: "As far as it goes", exact: true });
  const said = await ways.locator(".way-on", { hasText: "As far as it goes" }).textContent();
  await search.click();
  await idle(page);
  expect(await search.count()).toBe(0);
  const why = page.getByRole("region", { name: "Why the target is not reached" });
  const got = /^Panels allow (\d+) (?:mm )?of [\d.]+ m here/.exec((await why.textContent()) ?? "");
  await page.context().close();
  return [/goes(\d+) mm/.exec(said ?? ""), got].map((found) => Number(found?.[1]));
}

it("a typed target of 500 m gets as far as one of 10 m: as far as it goes", async () => {
  const [[nearSaid = 0, near = 0], [farSaid = 0, far = 0]] = [
    await farthest("+10"),
    await farthest("+500"),
  ];
  expect(near).toBeGreaterThan(4000);
  expect(Math.abs(near - far)).toBeLessThan(0.1 * Math.min(near, far));
  expect([nearSaid, farSaid]).toEqual([near, far]);
});
