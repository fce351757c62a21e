// SPDX-License-Identifier: MIT
// Needs: pixels, layout, storage.
// The panels one by one: a table that fits and goes on, a scale that says what it is, a legend that
// leads to its panels; and words that need no paper to be read.
import type { Locator, Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, kept, openFile, typeTarget } from "./support/page.ts";
import { readPng } from "./support/pixels.ts";
import { site } from "./support/site.ts";

const BOW_TIE = "v 0 0 0\nv 2 1 0\nv 2 0 0\nv 0 1 0\nv 3 0 0\nv 3 1 0\nf 1 2 3 4\nf 3 5 6 2\n";

const table = (page: Page) => page.getByRole("table", { name: "Panels" });

const shows = (page: Page) => table(page).getByRole("button", { name: /^Show panel \d+$/ });

/** Cells whose words reach over the cell's own sides, or into the words of the next one. */
const collisions = (page: Page): Promise<string[]> =>
  table(page)
    .getByRole("row")
    .evaluateAll((rows) =>
      rows.flatMap((row) => {
        const boxes = [...row.children].map((cell) => {
          const range = document.createRange();
          range.selectNodeContents(cell);
          return { text: cell.textContent ?? "", words: range.getBoundingClientRect(), cell };
        });
        return boxes.flatMap(({ text, words, cell }, k) => {
          const sides = cell.getBoundingClientRect();
          const next = boxes[k + 1]?.words.left ?? Number.POSITIVE_INFINITY;
          const over = words.right > sides.right + 0.5 || words.left < sides.left - 0.5;
          return over || words.right > next ? [text] : [];
        });
      }),
    );

it("has a head that fits and is explained, at a desk and on a telephone", async () => {
  for (const viewport of [
    { width: 1440, height: 900 },
    { width: 360, height: 740 },
  ]) {
    const page = await site.openVault({ viewport });
    await typeTarget(page, "+40cm");
    await expect.poll(() => shows(page).count()).toBe(8);
    expect(await collisions(page)).toEqual([]);
    for (const name of ["Least angle", "Least edge mm"]) {
      const head = table(page).getByRole("columnheader", { name }).getByRole("button");
      expect(await head.getAttribute("title")).toMatch(/^(The panel's|Length of)/);
    }
    await openFile(page, "bow.obj", BOW_TIE);
    await page.getByRole("button", { name: "Start editing" }).click();
    await expect.poll(() => shows(page).count()).toBe(2);
    expect(await collisions(page)).toEqual([]);
    await page.context().close();
  }
});

it("says and colours how many panels must be made again after the edit", async () => {
  const page = await site.openVault({ draws: true, viewport: { width: 1440, height: 900 } });
  const note = page.getByRole("button", { name: /^\d+ panels to make again$/ });
  await typeTarget(page, "+40cm");
  await expect.poll(() => note.count()).toBe(1);
  const total = Number.parseInt((await note.textContent()) ?? "", 10);
  const view = page.getByLabel("3D view");
  const before = await view.screenshot();
  await note.press("Enter");
  expect(await page.getByRole("combobox", { name: "Colour by" }).inputValue()).toBe("remake");
  const legend = page.getByRole("group", { name: "Legend", exact: true });
  const countOf = async (word: string): Promise<number> => {
    const text = await legend.getByRole("button", { name: new RegExp(`^${word}`) }).textContent();
    return Number(/\d+$/.exec(text ?? "")?.[0]);
  };
  await expect.poll(() => countOf("cut again")).toBeGreaterThan(0);
  const [cut, bevel] = [await countOf("cut again"), await countOf("new bevel only")];
  expect(bevel).toBeGreaterThan(0);
  expect(cut + bevel).toBe(total);
  expect(await countOf("unchanged")).toBe(400 - total);
  expect((await view.screenshot()).equals(before)).toBe(false);
  await legend.getByRole("button", { name: /^new bevel only/ }).click();
  await page.getByText(/^Panel \d+ 4 corners/).waitFor();
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => note.count()).toBe(0);
  await expect.poll(() => countOf("unchanged")).toBe(400);
  await page.context().close();
});

it("says that the planarity scale is logarithmic, with ticks ten times apart", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Planarity");
  await page.getByText(/mm\/m, logarithmic/).waitFor();
  const named = page.locator(".decades").getByText(/^(0\.0*1|10*)$/);
  expect(await named.allTextContents()).toEqual(["0.001", "0.1", "10"]);
  const placesOf = async (ticks: Locator): Promise<number[]> =>
    ticks.evaluateAll((all) =>
      all.map((at) => Number.parseFloat((at as HTMLElement).style.getPropertyValue("--place"))),
    );
  // A decade lies between a name and the next, unnamed.
  const ticks = (await placesOf(page.locator(".decade"))).filter((place) => !Number.isNaN(place));
  expect(await placesOf(named)).toEqual([ticks[2], ticks[4], ticks[6]]);
  const gaps = ticks.slice(1).map((place, k) => place - (ticks[k] ?? 0));
  for (const gap of gaps) expect(gap).toBeCloseTo(gaps[0] ?? 0, 6);
  expect(ticks.at(-1)).toBeCloseTo(100, 6);
  const words = await page.locator(".decade").evaluateAll((all) =>
    all
      .filter((one) => one.textContent)
      .map((one) => {
        const { left, right } = one.getBoundingClientRect();
        return { left, right };
      }),
  );
  words.slice(1).forEach(({ left }, k) => {
    expect(left).toBeGreaterThan(words[k]?.right ?? 0);
  });
  await page.context().close();
});

it("mirrors stripes in the surface, and shows those panels first that fold most", async () => {
  const page = await site.openVault({ draws: true, viewport: { width: 1440, height: 900 } });
  await typeTarget(page, "+40cm");
  const view = page.getByLabel("3D view");
  const shares = async (): Promise<readonly number[]> => {
    const picture = readPng(await view.screenshot());
    const [x, y] = [picture.width >> 1, picture.height >> 1];
    const middle = Array.from({ length: 200 * 200 }, (_, k) =>
      picture.at(x - 100 + (k % 200), y - 50 + Math.floor(k / 200)),
    );
    const grey = middle.filter((rgb) => Math.max(...rgb) - Math.min(...rgb) < 24);
    const dark = grey.filter(([red]) => red < 60).length / middle.length;
    return [dark, grey.filter(([red]) => red > 180).length / middle.length];
  };
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Reflection lines");
  // Most of it is stripes, dark and light.
  await expect.poll(async () => Math.min(...(await shares()))).toBeGreaterThan(0.2);
  // What lies behind glass shows through: no place is as dark as a stripe, and none is one colour.
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Glass");
  await expect.poll(async () => (await shares())[0]).toBeLessThan(0.02);
  const folds = await table(page)
    .getByRole("row")
    .evaluateAll((rows) => rows.slice(1).map((row) => Number(row.lastElementChild?.textContent)));
  expect(folds.length).toBeGreaterThan(4);
  expect(folds[0]).toBeGreaterThan(5);
  expect([...folds].sort((a, b) => b - a)).toEqual(folds);
  await page.context().close();
});

it("names the figure that was chosen, until another mesh is opened", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  const sample = page.getByRole("combobox", { name: "Sample" });
  const chosen = (): Promise<string> =>
    sample.evaluate((select: HTMLSelectElement) => select.selectedOptions[0]?.textContent ?? "");
  await expect.poll(() => sample.getByRole("option", { name: /^Figure 1:/ }).count()).toBe(1);
  const figure = (await sample.getByRole("option", { name: /^Figure 1:/ }).textContent()) ?? "";
  await sample.selectOption(figure);
  await expect.poll(chosen).toBe(figure);
  await idle(page);
  expect(await chosen()).toBe(figure);
  // Also of what was made of it, after a reload.
  await page.getByRole("checkbox", { name: "Pinned" }).first().click();
  await idle(page);
  await kept(page);
  expect(new URL(page.url()).hash).toBe("");
  await page.reload();
  await expect.poll(chosen).toBe(figure);
  await idle(page);
  await sample.selectOption("Dome");
  await expect.poll(chosen).toBe("Dome");
  await idle(page);
  expect(await chosen()).toBe("Dome");
  await page.context().close();
});

/** A tilted plane of quads of nearly 1 m, so far from the origin that its coordinates are coarse. */
function farPlane(offset: number): string {
  const lines: string[] = [];
  for (let j = 0; j < 4; ++j)
    for (let i = 0; i < 4; ++i) {
      const [x, y] = [0.9 * i + 0.13 * j, 0.7 * j - 0.11 * i];
      lines.push(`v ${offset + x} ${offset + y} ${0.9 * x + 0.8 * y}`);
    }
  for (let j = 0; j < 3; ++j)
    for (let i = 0; i < 3; ++i) {
      const a = 4 * j + i + 1;
      lines.push(`f ${a} ${a + 1} ${a + 5} ${a + 4}`);
    }
  return lines.join("\n");
}

it("calls flat what the coordinates cannot hold flatter, and says so", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  const verdict = page.getByText(/^(Every|Worst) panel/).last();
  const colour = (): Promise<string> => verdict.evaluate((at) => getComputedStyle(at).color);
  await expect.poll(() => verdict.textContent()).toBe("Every panel is flat (< 0.000001 mm/m).");
  const good = await colour();
  await openFile(page, "far.obj", farPlane(1e8 + 0.1));
  const held = /as flat as its coordinates can hold \(0\.0000\d+ mm\/m\)/;
  await page.getByRole("definition").filter({ hasText: held }).waitFor();
  expect(await page.getByRole("button", { name: "Planarise" }).count()).toBe(0);
  await page.getByRole("button", { name: "Start editing" }).click();
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Planarity");
  await expect.poll(() => verdict.textContent()).toMatch(/^Every panel is as flat as/);
  expect(await colour()).toBe(good);
  await page.getByText("0 panels out of flat, 9 flat").waitFor();
  expect(await page.getByRole("status").textContent()).toContain("flat but for rounding");
  await page.context().close();
});
