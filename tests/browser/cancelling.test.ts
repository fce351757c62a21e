// SPDX-License-Identifier: MIT
// Needs: workers.
// Cancel gives the page back at once: nobody waits for the solver that replaces the stopped one.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { exportAs, idle, movedCount, status, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";

interface HeldWindow extends Window {
  /** Solvers are given nothing from now on, until they are let go. */
  hold: boolean;
  waiting: (() => void)[];
}

/** Lets the test say when a solver gets its messages: an edit goes on for as long as it likes. */
const holdMessages = (context: { addInitScript(script: () => void): Promise<unknown> }) =>
  context.addInitScript(() => {
    const page = window as unknown as HeldWindow & { Worker: typeof Worker };
    page.hold = false;
    page.waiting = [];
    page.Worker = class extends Worker {
      override postMessage(message: unknown): void {
        if (page.hold) page.waiting.push(() => super.postMessage(message));
        else super.postMessage(message);
      }
    };
  });

const hold = (page: Page): Promise<void> =>
  page.evaluate(() => {
    (window as unknown as HeldWindow).hold = true;
  });

const letGo = (page: Page): Promise<void> =>
  page.evaluate(() => {
    const held = window as unknown as HeldWindow;
    held.hold = false;
    for (const post of held.waiting.splice(0)) post();
  });

const cancelButton = (page: Page) => page.getByRole("button", { name: "Cancel" });

it("is idle with the last design before the next solver has begun, which then knows it", async () => {
  const page = await site.openVault({}, async (context) => void (await holdMessages(context)));
  await typeTarget(page, "+40cm");
  const [numbers, before] = [await status(page), await exportAs(page, "OBJ")];
  await hold(page);
  const field = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton", { name: "Z" });
  const height = await field.inputValue();
  await field.fill("+90cm");
  await field.press("Enter");
  await expect.poll(() => cancelButton(page).isEnabled()).toBe(true);
  await cancelButton(page).click();
  await idle(page);
  expect(await status(page)).toBe(numbers);
  expect(await field.inputValue()).toBe(height);
  expect(await page.getByRole("alert").count()).toBe(0);
  // What is asked for meanwhile waits, and says so.
  await page.getByRole("button", { name: "Undo" }).click();
  await expect.poll(() => cancelButton(page).isEnabled()).toBe(true);
  expect(await status(page)).toBe(numbers);
  await letGo(page);
  await idle(page);
  expect(await movedCount(page)).toBe(0);
  await page.getByRole("button", { name: "Redo" }).click();
  await idle(page);
  expect(await status(page)).toBe(numbers);
  expect(await exportAs(page, "OBJ")).toEqual(before);
  // It can be pressed again while the next solver is still being told.
  await hold(page);
  for (let k = 0; k < 2; ++k) {
    await page.getByRole("button", { name: "Undo" }).click();
    await expect.poll(() => cancelButton(page).isEnabled()).toBe(true);
    await cancelButton(page).click();
    await idle(page);
    expect(await status(page)).toBe(numbers);
  }
  await letGo(page);
  expect(await exportAs(page, "OBJ")).toEqual(before);
  await page.context().close();
});
