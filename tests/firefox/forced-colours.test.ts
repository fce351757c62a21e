// SPDX-License-Identifier: MIT
// axe finds nothing where the system's colours replace those of the page, and at 200 %, in the second engine.
import { afterAll, beforeAll, expect, it } from "vitest";
import { expectClean } from "../browser/support/axe.ts";
import { usable, type Visitor, visit } from "./support/visitor.ts";

/** Firefox's "override the colours specified by the page: always". */
const FORCED = { "browser.display.document_color_use": 2 };

const DESK = { width: 1280, height: 800 };
/** The pixels that a desk has left at 200 %. */
const ENLARGED = { width: 640, height: 400 };

let visitor: Visitor;
beforeAll(async () => {
  visitor = await visit(FORCED);
});
afterAll(() => visitor.leave());

const tab = (name: string): Promise<void> =>
  visitor.page.locator(`::-p-aria([name="${name}"][role="tab"])`).click();

it("in every tab, on a desk and at 200 %, at first sight and edited", async () => {
  const { page } = visitor;
  await usable(visitor);
  expect(await page.evaluate(() => matchMedia("(forced-colors: active)").matches)).toBe(true);
  await page.setViewport(DESK);
  await expectClean(page, "first visit");
  await visitor.press("Add handle");
  await page.waitForSelector("::-p-aria([name='Z'][role='spinbutton'])");
  await page.locator("::-p-aria([name='Z'][role='spinbutton'])").fill("+40cm");
  await page.keyboard.press("Enter");
  await expect.poll(visitor.moved).toBeGreaterThan(0);
  for (const viewport of [DESK, ENLARGED]) {
    await page.setViewport(viewport);
    for (const name of ["Explore", "Check and make", "Edit"]) {
      await tab(name);
      await expectClean(page, `${name} at ${viewport.width} pixels`);
    }
  }
});
