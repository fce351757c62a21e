// SPDX-License-Identifier: MIT
// Limits on panels: every edit and every frame of a drag keeps them, the page says which panels they
// hold back, and designs and links carry them.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import {
  exportAs,
  idle,
  movedCount,
  obj,
  openFile,
  openRule,
  showTab,
  status,
  typeTarget,
} from "../browser/support/page.ts";
import { handleRows, hintedPoint, press } from "../browser/support/view.ts";
import { decodeLink } from "../web/support/links.ts";
import { site } from "./support/site.ts";

/** Degrees; more than a tenth above a limit would break it. */
async function sharpestFold(page: Page): Promise<number> {
  return Number(/sharpest fold ([\d.]+)°/.exec(await status(page))?.[1] ?? Number.NaN);
}

async function unfold(page: Page): Promise<void> {
  await openRule(page, "Limits");
  await page.getByRole("checkbox", { name: "Folds up to" }).waitFor();
}

async function type(page: Page, name: string, value: string): Promise<void> {
  const field = page.getByRole("textbox", { name, exact: true });
  await field.fill(value);
  await field.press("Enter");
  await idle(page);
}

async function openVault(page: Page): Promise<void> {
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Vault");
  await idle(page);
  await unfold(page);
}

it("an edit keeps them, and the page leads to the panels that they hold back", async () => {
  const page = await site.open();
  await openVault(page);
  await typeTarget(page, "+1m");
  const free = await sharpestFold(page);
  expect(free).toBeGreaterThan(13);
  await type(page, "Folds up to", "12");
  expect(await page.getByRole("checkbox", { name: "Folds up to" }).isChecked()).toBe(true);
  expect(await sharpestFold(page)).toBeLessThanOrEqual(12);
  expect(await movedCount(page)).toBeGreaterThan(0);
  const held = page.getByText(/^The limit on folds holds (a panel|\d+ panels) back/);
  expect(await held.textContent()).toMatch(/\(asked 12°, is 1[12]\.\d\d°\)/);
  await page.getByRole("button", { name: "Show panels at the limit on folds" }).click();
  await page
    .getByText(/^Panel \d+/)
    .first()
    .waitFor();

  const limited = await obj(page);
  const text = (await exportAs(page, "JSON")).toString();
  expect(JSON.parse(text).options.bounds).toEqual(["fold=12", "fold=+10"]);
  await page.getByRole("checkbox", { name: "Folds up to" }).uncheck();
  await idle(page);
  expect(await obj(page)).not.toBe(limited);
  expect(await sharpestFold(page)).toBe(free);
  await openFile(page, "limited.json", text);
  await page.getByText(/^Verified:/).waitFor();
  expect(await page.getByRole("checkbox", { name: "Folds up to" }).isChecked()).toBe(true);
  expect(await obj(page)).toBe(limited);
  await page.context().close();
});

it("where a limit stops a handle, how far it got is said before that the limit holds", async () => {
  const page = await site.open();
  await openVault(page);
  await type(page, "Folds up to", "12");
  await typeTarget(page, "+5m");
  const standing = page.getByText(/the limit on folds holds (a panel|\d+ panels) back/i);
  expect(await standing.textContent()).toMatch(
    /^\d+ of 5000 mm reached: the limit .* back \(asked 12°, is 1[12]\.\d\d°\)/,
  );
  await page.context().close();
});

it("far beyond what a limit allows, the edit ends at it, and it is what is named", async () => {
  const page = await site.open();
  await openVault(page);
  await type(page, "Folds up to", "12");
  await typeTarget(page, "+9m");
  const standing = page.getByText(
    /^\d+ of 9000 mm reached: the limit on folds holds \d+ panels back/,
  );
  expect(await standing.textContent()).toContain("(asked 12°, is 12.00°)");
  expect(await page.getByText("No limit holds this edit back.").count()).toBe(0);
  await page.context().close();
});

it("variations made exact keep the limits", async () => {
  const page = await site.open();
  await openVault(page);
  await type(page, "Folds sharper by", "4");
  await typeTarget(page, "+50cm");
  await page.getByRole("button", { name: "Find variations" }).click();
  const slider = page.getByRole("slider", { name: "Variation 1" });
  await slider.waitFor();
  const before = await obj(page);
  await slider.fill("-1");
  await idle(page);
  await showTab(page, "Check and make");
  await page.getByRole("button", { name: "Make exact" }).click();
  await idle(page);
  expect(await obj(page)).not.toBe(before);
  const was = Number(/\(was ([\d.]+)°\)/.exec(await status(page))?.[1]);
  expect(await sharpestFold(page)).toBeLessThanOrEqual(was + 4.2);
  await page.context().close();
});

it("a limit that cannot be is refused at its field, and the others hold", async () => {
  const page = await site.open();
  await openVault(page);
  await type(page, "Folds sharper by", "4");
  await type(page, "Angles, first", "170");
  const refused = page.getByText(/^angle: the first number must be less than the second$/);
  await refused.waitFor();
  const angles = page.getByRole("checkbox", { name: "Angles" });
  expect(await angles.isChecked()).toBe(false);
  expect(await page.getByRole("checkbox", { name: "Folds sharper by" }).isChecked()).toBe(true);
  const first = page.getByRole("textbox", { name: "Angles, first" });
  expect(await first.getAttribute("aria-invalid")).toBe("true");
  await type(page, "Angles, first", "50");
  expect(await angles.isChecked()).toBe(true);
  expect(await first.getAttribute("aria-invalid")).toBe("false");
  // They are the shop's, not the mesh's; the next one says so.
  await page.getByRole("combobox", { name: "Sample" }).selectOption("Dome");
  await page.getByText("The limits set for the mesh before apply here, too: see Limits.").waitFor();
  await idle(page);
  expect(await page.getByRole("checkbox", { name: "Folds sharper by" }).isChecked()).toBe(true);
  await page.context().close();
});

it("a drag keeps them in its frames and at its end, and a link carries them", async () => {
  const page = await site.open();
  const at = await hintedPoint(page);
  await unfold(page);
  await type(page, "Folds up to", "15");
  await press(page, at, { x: at.x, y: at.y - 60 });
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  expect(await sharpestFold(page)).toBeLessThanOrEqual(15);
  await page.mouse.up();
  await idle(page);
  expect(await movedCount(page)).toBeGreaterThan(0);
  expect(await sharpestFold(page)).toBeLessThanOrEqual(15);
  const limited = await obj(page);
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  const decoded = await decodeLink(new URL(link).hash);
  expect(decoded.ok && decoded.value.settings.limits).toEqual(["fold=15"]);
  const other = await site.open({}, new URL(link).hash);
  await other.getByText(/^Verified:/).waitFor();
  expect(await obj(other)).toBe(limited);
  await other.context().close();
  await page.context().close();
});

it("joints slide no further than their limit, in the page's unit, and it is what is named", async () => {
  const page = await site.open();
  await openVault(page);
  await typeTarget(page, "+50cm");
  const free = await status(page);
  const said = page.getByText(/^raised \d+ mm, joints slide up to \d+ mm$/);
  const [, slides] = /up to (\d+) mm/.exec((await said.textContent()) ?? "") ?? [];
  await unfold(page);
  const offered = Number(
    await page.getByRole("textbox", { name: "Joints slide at most" }).inputValue(),
  );
  expect(1000 * offered).toBeGreaterThan(Number(slides) / 4);
  expect(1000 * offered).toBeLessThan(Number(slides));
  await type(page, "Joints slide at most", "100 mm");
  expect(await page.getByRole("checkbox", { name: "Joints slide at most" }).isChecked()).toBe(true);
  await page
    .getByText(
      /^\d+ of 500 mm reached: the limit on slides holds (a joint|joints of \d+ panels) back/,
    )
    .waitFor();
  await page.getByText("Further, joints would slide by more than their limit.").waitFor();
  await page.getByText(/^raised \d+ mm, joints slide up to 100 mm, the limit$/).waitFor();
  expect(await status(page)).not.toBe(free);
  const text = (await exportAs(page, "JSON")).toString();
  expect(JSON.parse(text).options.bounds).toContain("slide=0.1");
  await page.getByRole("button", { name: "Joints slide twice as far" }).click();
  await idle(page);
  await page.getByText(/joints slide up to 200 mm, the limit$/).waitFor();
  await page.context().close();
});

it("a typed move makes no slivers where its handles get as far without, by a limit that is said", async () => {
  const page = await site.open();
  await typeTarget(page, "+300cm");
  await page
    .getByText(
      "Folds are kept to 10° sharper than they were. Corners are kept between 20° and 170°. To let them go, use Limits.",
    )
    .waitFor();
  expect(await page.getByText(/became slivers?/).count()).toBe(0);
  await unfold(page);
  expect(await page.getByRole("checkbox", { name: "Angles" }).isChecked()).toBe(true);
  const text = (await exportAs(page, "JSON")).toString();
  expect(JSON.parse(text).options.bounds).toEqual(["fold=+10", "angle=20:170"]);
  // Let go, it stays away from what is shown.
  await page.getByRole("checkbox", { name: "Angles" }).uncheck();
  await page.getByText(/became slivers?/).waitFor();
  await typeTarget(page, "+301cm");
  await page.getByText(/became slivers?/).waitFor();
  await page.context().close();
});

it("slivers of an edit can be avoided by one press, which states a limit on corners", async () => {
  const page = await site.open();
  await typeTarget(page, "+300cm");
  await unfold(page);
  await page.getByRole("checkbox", { name: "Angles" }).uncheck();
  const slivers = page.getByText(/became slivers? \(corners? (from )?[\d.]+°\): show/);
  await slivers.waitFor();
  const far = (await handleRows(page))[0]?.target[2] ?? 0;
  await page.getByRole("button", { name: "avoid", exact: true }).click();
  await idle(page);
  expect(await slivers.count()).toBe(0);
  expect((await handleRows(page))[0]?.target[2]).toBe(far);
  expect(await page.getByText(/^Panels allow/).count()).toBe(0);
  expect(await page.getByRole("checkbox", { name: "Angles" }).isChecked()).toBe(true);
  await page.context().close();
});
