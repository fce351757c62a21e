// SPDX-License-Identifier: MIT
// Needs: workers, storage, pixels.
// What must never lose a design: the solver dies, memory runs out, the picture is lost, storage
// fails, the tab closes while it writes, a second tab opens, a file comes slowly.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import {
  damageRecords,
  denyStorage,
  dropLarge,
  fillStorage,
  flatRoof,
  holdSolvers,
  insideSolver,
  killDuring,
  killNow,
  NO_MORE_MEMORY,
  SLOW_DISK,
} from "./support/faults.ts";
import {
  idle,
  kept,
  movedCount,
  obj,
  openFile,
  showTab,
  status,
  still,
  typeTarget,
  usable,
} from "./support/page.ts";
import { site } from "./support/site.ts";

const alertText = (page: Page): Promise<string> => page.getByRole("alert").innerText();

async function reload(page: Page): Promise<void> {
  await page.reload();
  await usable(page);
  await idle(page);
}

describe("the solver", () => {
  it("killed during a solve, or while nothing runs, is replaced; the last design is back", async () => {
    const page = await site.openVault({}, holdSolvers);
    await typeTarget(page, "+60cm");
    const before = await obj(page);
    const numbers = await status(page);
    await killDuring(page, "explore", 15);
    await page.getByRole("button", { name: "Find variations" }).click();
    await expect.poll(() => alertText(page)).toMatch(/solver stopped.*back\.$/);
    await idle(page);
    expect(await status(page)).toBe(numbers);
    expect(await obj(page)).toBe(before);
    await killDuring(page, "edit", 0);
    await showTab(page, "Edit");
    const z = page.getByRole("spinbutton", { name: "Z" });
    await z.fill("+20cm");
    await z.press("Enter");
    await expect.poll(() => alertText(page)).toMatch(/solver stopped/);
    await idle(page);
    expect(await obj(page)).toBe(before);
    await typeTarget(page, "+20cm");
    expect(await obj(page)).not.toBe(before);
    // Nor does it matter when nothing runs.
    const last = await obj(page);
    await killNow(page);
    await expect.poll(() => alertText(page)).toMatch(/solver stopped/);
    await idle(page);
    expect(await obj(page)).toBe(last);
    await page.context().close();
  });

  it("out of memory says so and keeps the design", async () => {
    const page = await site.openVault({}, insideSolver(NO_MORE_MEMORY));
    await typeTarget(page, "+60cm");
    const before = await obj(page);
    // More than the memory that the solver starts with, together with its copy.
    const filler = `${flatRoof(4)}# filler\n`;
    await dropLarge(page, "huge.obj", { text: "", filler, bytes: 36_000_000 });
    await expect.poll(() => alertText(page)).toMatch(/not enough memory.*back\.$/);
    await idle(page);
    expect(await obj(page)).toBe(before);
    await page.getByRole("button", { name: "Undo" }).click();
    await idle(page);
    await page.getByRole("button", { name: "Redo" }).click();
    await idle(page);
    expect(await obj(page)).toBe(before);
    await page.context().close();
  });
});

describe("a slow file", () => {
  const slow = insideSolver(SLOW_DISK);

  it("shows how far it is, Cancel keeps the design, and another one arrives whole", async () => {
    const page = await site.openVault({}, slow);
    await typeTarget(page, "+60cm");
    const before = await obj(page);
    const slowly = { text: flatRoof(20), filler: "# slow\n", bytes: 12_000_000 };
    await dropLarge(page, "slow.obj", slowly);
    await expect
      .poll(() => page.getByText(/reading slow\.obj · \d+(\.\d)? of 12 MB/).count())
      .toBe(1);
    await page.getByRole("button", { name: "Cancel" }).click();
    await idle(page);
    expect(await obj(page)).toBe(before);
    expect(await page.getByRole("alert").count()).toBe(0);
    await openFile(page, "roof.obj", flatRoof(40));
    await expect.poll(() => status(page)).toMatch(/0 of 1681 points/);
    await page.context().close();
  });
});

describe("the picture", () => {
  it("comes back after the graphics context was lost", async () => {
    const page = await site.openVault({ draws: true, reducedMotion: "reduce" });
    await typeTarget(page, "+1m");
    const canvas = page.getByLabel("3D view");
    await still(page);
    const before = await canvas.screenshot();
    await canvas.evaluate(async (element: HTMLCanvasElement) => {
      const extension = element.getContext("webgl2")?.getExtension("WEBGL_lose_context");
      const seen = (name: string) => new Promise((done) => element.addEventListener(name, done));
      const lost = seen("webglcontextlost");
      extension?.loseContext();
      await lost;
      await new Promise((done) => setTimeout(done, 100));
      const restored = seen("webglcontextrestored");
      extension?.restoreContext();
      await restored;
    });
    await expect.poll(async () => (await canvas.screenshot()).equals(before)).toBe(true);
    await typeTarget(page, "+50cm");
    await still(page);
    expect((await canvas.screenshot()).equals(before)).toBe(false);
    await page.context().close();
  });
});

describe("storage", () => {
  it.each([
    ["denied", denyStorage],
    ["full", fillStorage],
  ])("that is %s is one quiet sentence; the page works", async (_, prepare) => {
    const page = await site.openVault({}, prepare);
    await typeTarget(page, "+60cm");
    await expect
      .poll(() => page.getByText(/does not let the page keep your design/).count())
      .toBe(1);
    expect(await page.getByRole("alert").count()).toBe(0);
    await page.getByRole("button", { name: "Undo" }).click();
    await expect.poll(() => movedCount(page)).toBe(0);
    await page.context().close();
  });

  it("with a damaged record is one sentence and the sample", async () => {
    const page = await site.openVault();
    await typeTarget(page, "+60cm");
    await kept(page);
    expect(await damageRecords(page)).toBe(1);
    await reload(page);
    expect(await alertText(page)).toMatch(/damaged/);
    expect(await status(page)).toMatch(/0 of 425 points move/);
    await page.context().close();
  });

  it("gives the old design or the new one, whenever the tab closes", async () => {
    const page = await site.openVault();
    await typeTarget(page, "+10cm");
    await kept(page);
    let old = await obj(page);
    for (const [k, delay] of [0, 120, 240, 260, 320].entries()) {
      await typeTarget(page, `+${k + 1}cm`);
      const now = await obj(page);
      await typeTarget(page, "+1cm");
      const last = await obj(page);
      await page.waitForTimeout(delay);
      await reload(page);
      const found = await obj(page);
      expect([old, now, last]).toContain(found);
      expect(await page.getByRole("alert").count()).toBe(0);
      old = found;
    }
    await page.context().close();
  });
});

describe("two tabs", () => {
  it("keep a design each, and neither writes over the other", async () => {
    const first = await site.openVault();
    await typeTarget(first, "+60cm");
    await kept(first);
    const ofFirst = await obj(first);
    const second = await site.openTab(first);
    expect(await movedCount(second)).toBe(0);
    await second.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
    await idle(second);
    await typeTarget(second, "+30cm");
    await kept(second);
    const ofSecond = await obj(second);
    await reload(second);
    await reload(first);
    expect(await obj(first)).toBe(ofFirst);
    expect(await obj(second)).toBe(ofSecond);
    await first.close();
    const third = await site.openTab(second);
    expect(await obj(third)).toBe(ofFirst);
    await second.context().close();
  });
});
