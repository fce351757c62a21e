// SPDX-License-Identifier: MIT
// Needs: layout.
// The table of panels fits, and the scale of their planarity can be read.
import type { Locator, Page } from "playwright-core";
import { expect, it } from "vitest";
import { openFile, pickFile, showTab, typeTarget } from "./support/page.ts";
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
  const sizes = [
    { width: 1440, height: 900 },
    { width: 360, height: 740 },
  ] as const;
  const page = await site.openVault();
  await typeTarget(page, "+40cm");
  await showTab(page, "Check and make");
  await expect.poll(() => shows(page).count()).toBe(8);
  for (const size of sizes) {
    await page.setViewportSize(size);
    expect(await collisions(page)).toEqual([]);
  }
  for (const name of ["Least angle", "Least edge mm"]) {
    const head = table(page).getByRole("columnheader", { name }).getByRole("button");
    expect(await head.getAttribute("title")).toMatch(/^(The panel's|Length of)/);
  }
  await openFile(page, "bow.obj", BOW_TIE);
  await page.getByRole("button", { name: "Start editing" }).click();
  await showTab(page, "Check and make");
  await expect.poll(() => shows(page).count()).toBe(2);
  for (const size of sizes.toReversed()) {
    await page.setViewportSize(size);
    expect(await collisions(page)).toEqual([]);
  }
  await page.context().close();
});

/** A quad 1 m long whose last corner is `by` metres out of the plane, after a flat one. */
const bent = (by: number): string =>
  `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 ${by}\nf 1 2 3 4\nf 2 5 6 3\n`;

/** The ticks are ten times apart: a decade lies between a name and the next, unnamed. */
async function expectDecades(page: Page): Promise<void> {
  await page.getByText(/mm\/m, logarithmic/).waitFor();
  const named = page.locator(".decades").getByText(/^(0\.0*1|10*)$/);
  expect(await named.allTextContents()).toEqual(["0.001", "0.1", "10"]);
  const placesOf = async (ticks: Locator): Promise<number[]> =>
    ticks.evaluateAll((all) =>
      all.map((at) => Number.parseFloat((at as HTMLElement).style.getPropertyValue("--place"))),
    );
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
}

it("the scale of planarity is logarithmic, grows by decades to hold the worst panel, and leads to it", async () => {
  const page = await site.openVault({ viewport: { width: 1440, height: 900 } });
  await page.getByRole("combobox", { name: "Colour by" }).selectOption("Planarity");
  const named = async (): Promise<string[]> => {
    const legend = page.getByRole("group", { name: "Legend", exact: true });
    const shown = await legend
      .getByText(/^(0\.0*1|10*)$/)
      .evaluateAll((all) =>
        all.map((tick) => ({ text: tick.textContent ?? "", box: tick.getBoundingClientRect() })),
      );
    shown.slice(1).forEach(({ box }, k) => {
      expect(box.left - (shown[k]?.box.right ?? Number.NaN)).toBeGreaterThan(4);
    });
    return shown.map(({ text }) => text);
  };
  await expect.poll(named).toEqual(["0.001", "0.1", "10"]);
  await expectDecades(page);
  const worst = page.getByRole("button", { name: /^Worst panel / });
  expect(await worst.count()).toBe(0);
  for (const [by, ticks] of [
    [0.01, ["0.001", "0.1", "10"]],
    [0.1, ["0.0001", "0.1", "100"]],
    [0.4, ["0.001", "1", "1000"]],
  ] as const) {
    await pickFile(page, "bent.obj", bent(by));
    await page.getByRole("button", { name: "Not now" }).click();
    await expect.poll(named).toEqual(ticks);
  }
  await page.setViewportSize({ width: 390, height: 844 });
  await expect.poll(named).toEqual(["0.001", "1", "1000"]);
  await page.setViewportSize({ width: 1440, height: 900 });
  await worst.focus();
  await page.keyboard.press("Enter");
  await expect.poll(() => page.getByText(/^Panel 1 4 corners, /).count()).toBe(1);
  await page.context().close();
});
