// SPDX-License-Identifier: MIT
// Needs: layout.
// The page is as high as its window in every state, so the wheel never moves it out of sight.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { idle, openAdvanced, openFile, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";

const SADDLE = "v 0 0 0\nv 1 0 0.1\nv 1 1 0\nv 0 1 0.1\nf 1 2 3 4\n";

const press = async (page: Page, name: string): Promise<void> => {
  await page.getByRole("button", { name, exact: true }).click();
  await idle(page);
};

/** How much of the last slider lies below the inspector: what the button gave is brought into view. */
async function cutOff(page: Page): Promise<number> {
  const last = page.getByRole("slider", { name: "Variation 4", exact: true });
  const inspector = page.getByRole("complementary", { name: "Inspector" });
  const [slider, around] = [await last.boundingBox(), await inspector.boundingBox()];
  if (!slider || !around) return Number.POSITIVE_INFINITY;
  return slider.y + slider.height - (around.y + around.height);
}

async function findVariations(page: Page): Promise<void> {
  await press(page, "Find variations");
  // A telephone has no room for what is below it, too.
  if ((page.viewportSize()?.width ?? 0) > 900)
    await expect.poll(() => cutOff(page)).toBeLessThanOrEqual(0);
  const gallery = page.getByRole("list", { name: "Gallery of variations" });
  await expect.poll(() => gallery.getAttribute("aria-busy")).toBe("false");
}

/** One after the other, in the same page. */
const STATES: readonly (readonly [string, (page: Page) => Promise<void>])[] = [
  ["opened", async () => {}],
  ["edited", (page) => typeTarget(page, "+80cm")],
  ["varied", findVariations],
  ["kept", (page) => press(page, "Take snapshot")],
  ["under Advanced", openAdvanced],
  ["imported", (page) => openFile(page, "saddle.obj", SADDLE)],
  ["planarised", (page) => press(page, "Planarise")],
];

interface Heights {
  readonly content: number;
  readonly window: number;
  readonly scrolled: number;
}

const heights = (page: Page): Promise<Heights> =>
  page.evaluate(() => {
    const { scrollHeight, scrollTop } = document.documentElement;
    const content = Math.max(scrollHeight, document.body.scrollHeight);
    const scrolled = Math.max(scrollTop, document.body.scrollTop, window.scrollY);
    return { content, window: window.innerHeight, scrolled };
  });

/** As far as 20 ticks go, over the bar, the view, the inspector and the status line. */
async function turnTheWheel(page: Page, width: number, height: number): Promise<void> {
  const inspector = height > width ? [0.5, 0.75] : [0.95, 0.7];
  for (const [x = 0, y = 0] of [[0.5, 0.02], [0.2, 0.3], inspector, [0.3, 0.99]]) {
    await page.mouse.move(x * width, y * height);
    for (let turn = 0; turn < 3; ++turn) await page.mouse.wheel(0, 800);
  }
}

describe.each([
  [1440, 900],
  [390, 844],
])("at %d × %d", (width, height) => {
  it("the page fills the window in every state, and stays; what was found is in view", async () => {
    const page = await site.open({ viewport: { width, height } });
    for (const [state, reach] of STATES) {
      await reach(page);
      await turnTheWheel(page, width, height);
      expect(await heights(page), state).toEqual({ content: height, window: height, scrolled: 0 });
    }
    await page.context().close();
  });
});
