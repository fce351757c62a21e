// SPDX-License-Identifier: MIT
// The built site in a real browser, for the scripts that take pictures of it.
import { launch } from "./browser.mjs";
import { serve } from "./serve.mjs";

export async function openBrowser() {
  const { server, url } = await serve(new URL("../../dist/", import.meta.url).pathname, {
    port: 0,
  });
  const browser = await launch({ smooth: true });
  return {
    browser,
    url,
    async close() {
      await browser.close();
      server.close();
    },
  };
}

/** A page that is ready to be used; `prepare` runs in it before anything else. */
export async function openPage({ browser, url }, options, prepare = null) {
  const context = await browser.newContext(options);
  if (prepare) await context.addInitScript(prepare);
  const page = await context.newPage();
  await page.goto(url);
  await page.getByRole("status").filter({ hasText: "points move" }).waitFor({ timeout: 60_000 });
  await settled(page);
  return page;
}

/** Pixels from the first visit's sentence to the point that it speaks of. */
const TIP = 26;

/** That point; the sentence stands below it where the drag tools are above. */
export async function hintedPoint(page) {
  const sentence = page.getByText("Drag this point");
  await sentence.waitFor();
  const box = await sentence.boundingBox();
  const below = (await page.locator(".hint").getAttribute("data-side")) === "below";
  return { x: box.x + box.width / 2, y: below ? box.y - TIP : box.y + box.height + TIP };
}

/** Waits until nothing runs and shadows have been cast again. */
export async function settled(page) {
  await page.waitForTimeout(250);
  await page.getByRole("button", { name: "Cancel" }).and(page.locator(":disabled")).waitFor();
  await page.waitForTimeout(700);
}

export async function openSample(page, name) {
  const chooser = page.getByRole("combobox", { name: "Sample" });
  const options = await chooser.locator("option").allTextContents();
  const label = options.find((option) => option.toLowerCase().startsWith(name.toLowerCase()));
  await chooser.selectOption({ label: label ?? name });
  await settled(page);
}

/** Brings one of the tabs of the inspector into sight: "Edit", "Explore" or "Check and make". */
export const showTab = (page, name) => page.getByRole("tab", { name, exact: true }).click();

/** Moves a sensible point up by typing. */
export async function lift(page, amount) {
  await showTab(page, "Edit");
  await page.getByRole("button", { name: "Add handle" }).click();
  const z = page.getByRole("table", { name: "Handles" }).getByRole("spinbutton", { name: "Z" });
  await z.last().fill(amount);
  await z.last().press("Enter");
  await settled(page);
}

export async function findVariations(page) {
  await page
    .getByRole("button", { name: /variations/i })
    .first()
    .click();
  await page.getByRole("slider", { name: "Variation 1" }).waitFor({ timeout: 60_000 });
  await settled(page);
}
