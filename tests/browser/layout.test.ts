// SPDX-License-Identifier: MIT
// Needs: layout.
// From the narrowest telephone to a 4K screen: nothing overlaps, sticks out or is cut short.
import type { Locator, Page } from "playwright-core";
import { expect, it } from "vitest";
import {
  idle,
  movedCount,
  openFile,
  openRule,
  showTab,
  still,
  typeTarget,
} from "./support/page.ts";
import { site } from "./support/site.ts";
import { hintedPoint, press, viewBox } from "./support/view.ts";

/** Width, height. 320 pixels are what is left of 1280 at 400 % zoom. */
const SIZES = [
  [320, 568],
  [360, 740],
  [640, 400],
  [667, 375],
  [740, 360],
  [768, 1024],
  [1280, 800],
  [1440, 900],
  [2560, 1440],
  [3840, 2160],
] as const;

/** There are words beside the icons of the drag tools in a wide view. */
const TOOL_WORDS = ["Box", "Loop", "Pin", "Cut", "Plane", "Local", "Snap", "Hide", "Isolate"];

interface Rectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

async function boxOf(locator: Locator): Promise<Rectangle> {
  const box = await locator.boundingBox();
  if (!box) throw new Error(`not shown: ${locator}`);
  return box;
}

const apart = (a: Rectangle, b: Rectangle): boolean =>
  a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;

const inside = (a: Rectangle, b: Rectangle): boolean =>
  a.x >= b.x && a.y >= b.y && a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height;

/** Names of buttons, fields and headings whose words do not fit. */
const cutShort = (page: Page): Promise<string[]> =>
  page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>("button, th, h2, label, .number, .slider-ends span")]
      .filter((element) => element.checkVisibility() && element.clientWidth > 1)
      .filter((element) => element.scrollWidth > element.clientWidth + 1)
      .map((element) => element.getAttribute("aria-label") ?? element.textContent ?? ""),
  );

async function expectPlaces(page: Page, width: number, height: number): Promise<void> {
  const view = await viewBox(page);
  const window = { x: 0, y: 0, width, height };
  expect(view.width * view.height).toBeGreaterThan(0.3 * width * height);
  if (width < 900 && height > 559) expect(view.height).toBeGreaterThanOrEqual(0.49 * height);

  const over = await Promise.all(
    [
      page.getByRole("toolbar", { name: "Drag tools" }),
      page.getByRole("group", { name: "Views" }),
      page.getByRole("group", { name: "Legend" }),
      page.getByRole("button", { name: "View options", exact: true }),
    ].map(boxOf),
  );
  const line = await boxOf(page.locator(".status-line"));
  for (const [k, box] of over.entries()) {
    expect(inside(box, view), `part ${k} over the view`).toBe(true);
    expect(apart(box, line), `part ${k} beside the status line`).toBe(true);
    for (const other of over.slice(k + 1)) expect(apart(box, other)).toBe(true);
  }
  for (const name of [
    "Open file",
    "Undo",
    "Redo",
    "Snapshot",
    "Export",
    "Share",
    "Help",
    "Cancel",
  ]) {
    const box = await boxOf(page.getByRole("button", { name, exact: true }));
    expect(inside(box, window), name).toBe(true);
  }
  const scroll = await page.evaluate<number[]>(
    "[document.documentElement.scrollWidth, document.documentElement.scrollHeight]",
  );
  expect(scroll).toEqual([width, height]);
  expect(await cutShort(page)).toEqual([]);
}

/** What the drag tools have beside their icons. */
const toolWords = (page: Page): Promise<string[]> =>
  page.locator(".drag-tools .tool[data-word]").evaluateAll((all) =>
    all
      .map((tool) => getComputedStyle(tool, "::after").content.split(" / ")[0] ?? "")
      .map((content) => content.replaceAll('"', ""))
      .filter((word) => word !== "none"),
  );

const SADDLE = "v 0 0 0\nv 1 0 0.1\nv 1 1 0\nv 0 1 0.1\nf 1 2 3 4\n";

const REPORT_SIZES = [
  [360, 740],
  [740, 360],
  [768, 1024],
  [900, 640],
  [1440, 900],
] as const;

/** What is said of joints that slide is said where there is room, and never makes the status line higher. */
async function expectNoLineForTheSlide(page: Page): Promise<void> {
  const [said, unsaid] = await page.evaluate<number[]>(`(() => {
    const [line, note] = [".status-line", ".motion-note"].map((name) => document.querySelector(name));
    const said = line.offsetHeight;
    note.remove();
    const unsaid = line.offsetHeight;
    document.querySelector(".status-line .remake-note")?.after(note) ?? line.append(note);
    return [said, unsaid];
  })()`);
  expect(said).toBe(unsaid);
}

/** A long sentence there lies over the work; below, on telephones, it takes of the controls. */
async function expectViewToStay(page: Page): Promise<void> {
  const [unsaid, said] = await page.evaluate<number[]>(`(() => {
    const view = document.querySelector(".viewport");
    const unsaid = view.offsetHeight;
    const notice = document.createElement("div");
    notice.className = "notice";
    notice.textContent = "Something to be said in three lines. ".repeat(9);
    document.querySelector(".status-line").append(notice);
    const said = view.offsetHeight;
    notice.remove();
    return [unsaid, said];
  })()`);
  expect(said).toBe(unsaid);
}

it("everything has its place at every size, the import report too, and bars are no text to select", async () => {
  const page = await site.open();
  for (const [width, height] of [[1100, 680] as const, ...SIZES]) {
    await page.setViewportSize({ width, height });
    await expectSentence(page);
  }
  await typeTarget(page, "+0.2345m");
  for (const [width, height] of SIZES) {
    await page.setViewportSize({ width, height });
    await expectPlaces(page, width, height);
    await expectNoLineForTheSlide(page);
    await expectViewToStay(page);
    expect(await toolWords(page)).toEqual((await viewBox(page)).width < 1280 ? [] : TOOL_WORDS);
  }
  await page.setViewportSize({ width: 900, height: 640 });
  await dragOverBars(page);
  // The camera has kept the model in place.
  const [at, view] = [await hintedPoint(page), await viewBox(page)];
  expect(inside({ ...at, width: 0, height: 0 }, view)).toBe(true);
  await openFile(page, "saddle.obj", SADDLE);
  for (const [width, height] of REPORT_SIZES) {
    await page.setViewportSize({ width, height });
    await expectReportBeside(page, width, height);
  }
  await page.context().close();
});

/** What the first visit's sentence says is read whole, and not behind the drag tools. */
async function expectSentence(page: Page): Promise<void> {
  await still(page);
  const sentence = await boxOf(page.getByText("Drag this point"));
  // On a narrow screen they come with a drag.
  for (const tools of await page.locator(".drag-tools").filter({ visible: true }).all())
    expect(apart(sentence, await boxOf(tools))).toBe(true);
  expect(inside(sentence, await viewBox(page))).toBe(true);
}

/** Selects no words. */
async function dragOverBars(page: Page): Promise<void> {
  for (const bar of [
    page.getByRole("banner"),
    page.getByRole("toolbar", { name: "Drag tools" }),
    page.getByRole("group", { name: "Views" }),
  ]) {
    const box = await boxOf(bar);
    await press(
      page,
      { x: box.x + 2, y: box.y + 2 },
      { x: box.x + box.width - 2, y: box.y + box.height - 2 },
    );
    await page.mouse.up();
    expect(await page.evaluate(() => getSelection()?.toString())).toBe("");
  }
}

/** Of the status line; two lines of words on a telephone. */
const lineHeight = (page: Page): Promise<number> =>
  page.locator(".status-line").evaluate((line) => (line as HTMLElement).offsetHeight);

it("on a telephone an edit is said in the two lines that the mesh at rest has, and the view stays", async () => {
  const page = await site.open({ viewport: { width: 390, height: 844 } });
  const [rest, view, at] = [await lineHeight(page), await viewBox(page), await hintedPoint(page)];
  expect(rest).toBeLessThan(50);
  await press(page, at, { x: at.x, y: at.y - 10 });
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  expect([await lineHeight(page), await viewBox(page)]).toEqual([rest, view]);
  await page.mouse.up();
  await idle(page);
  for (const width of [320, 360, 390, 400]) {
    await page.setViewportSize({ width, height: 844 });
    expect(await lineHeight(page), `${width} pixels`).toBe(rest);
    expect((await viewBox(page)).height, `${width} pixels`).toBe(view.height);
  }
  // What is left out leaves no dot behind.
  const seen = await page.locator(".figures").evaluate((line: HTMLElement) => line.innerText);
  expect(seen).toMatch(/points move ·/);
  expect(seen).not.toMatch(/·\s*(·|$)/);
  // A sentence takes of the controls.
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  await press(page, at, { x: at.x, y: at.y - 200 });
  await page.getByText(/^Held back/).waitFor();
  expect(await lineHeight(page)).toBeGreaterThan(rest);
  expect((await viewBox(page)).height).toBe(view.height);
  await page.mouse.up();
  await page.context().close();
});

it("dialogs and menus fit a small screen, and the controls fold away and come back", async () => {
  const page = await site.open({ viewport: { width: 320, height: 568 }, reducedMotion: "reduce" });
  const window = { x: 0, y: 0, width: 320, height: 568 };
  for (const name of ["Help", "Share"]) {
    await page.getByRole("button", { name, exact: true }).click();
    expect(inside(await boxOf(page.getByRole("dialog")), window), name).toBe(true);
    await page.keyboard.press("Escape");
  }
  await page.getByRole("button", { name: "Export" }).click();
  for (const name of ["OBJ", "GLB", "PLY", "PNG"]) {
    const box = await boxOf(page.getByRole("button", { name, exact: true }));
    expect(inside(box, window), name).toBe(true);
  }
  await page.keyboard.press("Escape");
  for (const [width, height] of [
    [390, 844],
    [740, 360],
  ] as const) {
    await page.setViewportSize({ width, height });
    await foldAndUnfold(page, width, height);
  }
  await page.context().close();
});

async function foldAndUnfold(page: Page, width: number, height: number): Promise<void> {
  const before = await viewBox(page);
  const fold = page.getByRole("button", { name: "Controls", exact: true });
  expect(await fold.getAttribute("aria-expanded")).toBe("true");
  await fold.click();
  await expect
    .poll(async () => (await viewBox(page)).width * (await viewBox(page)).height)
    .toBeGreaterThan(1.3 * before.width * before.height);
  expect(inside(await boxOf(fold), { x: 0, y: 0, width, height })).toBe(true);
  expect(await page.getByRole("button", { name: "Add handle" }).isVisible()).toBe(false);
  await fold.click();
  await expect.poll(() => viewBox(page)).toEqual(before);
}

/** How many times its own height a tab has to scroll through, and how far to the side. */
const screens = (page: Page): Promise<number[]> =>
  page
    .locator(".inspector-body")
    .evaluate((shown) => [
      shown.scrollHeight / shown.clientHeight,
      shown.scrollWidth - shown.clientWidth,
    ]);

async function expectCalm(page: Page, state: string): Promise<void> {
  for (const name of ["Edit", "Explore", "Check and make"] as const) {
    await showTab(page, name);
    const [high = 0, aside] = await screens(page);
    expect(high, `${name}, ${state}`).toBeLessThanOrEqual(1.5);
    expect(aside, `${name}, ${state}`).toBe(0);
    expect(await cutShort(page)).toEqual([]);
  }
}

/** Each rule unfolded below an edit, one of them stated. */
async function expectCalmRules(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Undo" }).click();
  await idle(page);
  await typeTarget(page, "+40cm");
  await openRule(page, "Keep-outs");
  await page.getByRole("button", { name: "Nothing may be in a box" }).click();
  await idle(page);
  for (const name of ["Keep-outs", "Limits", "Supports", "Symmetry"]) {
    await openRule(page, name);
    const [high = 0, aside] = await screens(page);
    expect([high <= 1.5, aside], `${name}: ${high}`).toEqual([true, 0]);
    expect(await cutShort(page)).toEqual([]);
  }
}

async function showGallery(page: Page): Promise<void> {
  await showTab(page, "Explore");
  await page.getByRole("button", { name: "Find variations" }).click();
  await page.getByRole("slider", { name: "Variation 4" }).waitFor();
  const gallery = page.getByRole("list", { name: "Gallery of variations" });
  await expect.poll(() => gallery.getAttribute("aria-busy"), { timeout: 60_000 }).toBe("false");
  await idle(page);
  expect(await gallery.getByRole("listitem").count()).toBeGreaterThan(6);
  await expect.poll(() => page.getByText("Stopped by panel").count()).toBeGreaterThan(0);
}

/** Orange is for alarms; what is said of an edit that stops short is none, and lies on grey. */
async function expectNoAlarm(note: Locator): Promise<void> {
  await note.waitFor();
  const ground = await note.evaluate((shown) => getComputedStyle(shown).backgroundColor);
  const channels = [...ground.matchAll(/\d+/g)].slice(0, 3).map(Number);
  expect(Math.max(...channels) - Math.min(...channels), ground).toBeLessThan(12);
}

it("no tab is more than one and a half screens, at rest, after a long drag, with a rule or a gallery", async () => {
  const page = await site.openSmall({ viewport: { width: 1440, height: 900 } });
  await page.getByRole("button", { name: "Group points" }).waitFor();
  const at = await hintedPoint(page);
  await expectCalm(page, "at rest");
  await press(page, at, { x: at.x, y: at.y - 300 });
  await page.mouse.up();
  await expectNoAlarm(page.getByRole("region", { name: "Why the target is not reached" }));
  await idle(page);
  await expectCalm(page, "after a long drag");
  // With the figures of the ways on, which are tried while they are seen.
  await showTab(page, "Edit");
  const ways = page.getByRole("group", { name: "Get further" });
  await expect.poll(() => ways.getAttribute("aria-busy")).toBe("true");
  await expect.poll(() => ways.getAttribute("aria-busy"), { timeout: 150_000 }).toBe("false");
  await expectCalm(page, "with what each way on gains");
  await expectCalmRules(page);
  // On a sample whose sliders have stops, which take a line each.
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Roof");
  await idle(page);
  await typeTarget(page, "+50cm");
  await showGallery(page);
  await expectCalm(page, "with sliders and a gallery");
  await page.context().close();
}, 200_000);

/** The model stays in view. */
async function expectReportBeside(page: Page, width: number, height: number): Promise<void> {
  const report = await boxOf(page.getByRole("region", { name: "saddle.obj" }));
  expect(apart(report, await viewBox(page))).toBe(true);
  for (const name of ["Planarise", "Not now", "Open file", "Cancel"]) {
    const button = await boxOf(page.getByRole("button", { name, exact: true }));
    const where = `${name} at ${width} × ${height}: ${JSON.stringify(button)}`;
    expect(inside(button, { x: 0, y: 0, width, height }), where).toBe(true);
  }
  expect(await cutShort(page)).toEqual([]);
}
