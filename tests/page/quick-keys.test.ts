// SPDX-License-Identifier: MIT
// Keys on a slider or a coordinate come faster than results: what is kept, shared or exported is where
// they went, and all of them are one step.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import {
  downloaded,
  exportAs,
  idle,
  openAdvanced,
  status,
  typeTarget,
} from "../browser/support/page.ts";
import { hintedPoint, press as hold } from "../browser/support/view.ts";
import { decodeLink } from "../web/support/links.ts";
import { site } from "./support/site.ts";

const press = async (page: Page, name: string): Promise<void> => {
  await page.getByRole("button", { name, exact: true }).click();
  await idle(page);
};

const slider = (page: Page, name: string) => page.getByRole("slider", { name, exact: true });

/** Twenty keys at once, as a held key sends them, and then `after` before anything is done. */
async function twentyKeys(page: Page, name: string, after: () => Promise<void>): Promise<void> {
  await slider(page, name).focus();
  for (let k = 0; k < 20; ++k) await page.keyboard.press("ArrowRight");
  await after();
  await idle(page);
}

it("a snapshot, a link and a file hold where twenty quick keys went", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+80cm");
  await press(page, "Find variations");
  await twentyKeys(page, "Variation 1", () =>
    page.getByRole("button", { name: "Take snapshot" }).click(),
  );
  const kept = (await exportAs(page, "OBJ")).toString();
  expect(await slider(page, "Variation 1").inputValue()).toBe("0.2");
  await twentyKeys(page, "Variation 1", async () => {
    await page.getByRole("button", { name: "Share" }).click();
  });
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.keyboard.press("Escape");
  const shared = await decodeLink(new URL(link).hash);
  expect(shared.ok && shared.value.families.at(-1)?.coefficients[0]).toBe(0.4);
  let file = "";
  await twentyKeys(page, "Variation 1", async () => {
    file = (await exportAs(page, "OBJ")).toString();
  });
  expect(await slider(page, "Variation 1").inputValue()).toBe("0.6");
  expect((await exportAs(page, "OBJ")).toString()).toBe(file);
  await press(page, "Adopt Snapshot 1");
  expect(await slider(page, "Variation 1").inputValue()).toBe("0.2");
  expect((await exportAs(page, "OBJ")).toString()).toBe(kept);
  await page.context().close();
});

it("twenty quick keys in a coordinate are twenty steps of it and one of the history", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+60cm");
  const field = page.getByRole("spinbutton", { name: "Z", exact: true });
  const before = Number(await field.getAttribute("aria-valuenow"));
  const edited = (await exportAs(page, "OBJ")).toString();
  await field.focus();
  await page.keyboard.press("ArrowUp");
  await idle(page);
  const one = Number(await field.getAttribute("aria-valuenow")) - before;
  expect(one).toBeGreaterThan(0);
  for (let k = 0; k < 20; ++k) await page.keyboard.press("ArrowUp");
  await idle(page);
  await expect
    .poll(async () => Number(await field.getAttribute("aria-valuenow")))
    .toBeCloseTo(before + 21 * one, 9);
  await press(page, "Undo");
  expect((await exportAs(page, "OBJ")).toString()).toBe(edited);
  await page.context().close();
});

it("all keys until the slider is left are one step", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+60cm");
  const edited = (await exportAs(page, "OBJ")).toString();
  await openAdvanced(page);
  await slider(page, "Locality").focus();
  for (let k = 0; k < 3; ++k) {
    await page.keyboard.press("ArrowRight");
    await idle(page);
  }
  const [changed, value] = [
    (await exportAs(page, "OBJ")).toString(),
    await slider(page, "Locality").inputValue(),
  ];
  expect([changed === edited, value]).toEqual([false, "1.3"]);
  await slider(page, "Locality").focus();
  await page.keyboard.press("ArrowLeft");
  await idle(page);
  // The slider was left in between: two steps.
  await press(page, "Undo");
  expect((await exportAs(page, "OBJ")).toString()).toBe(changed);
  await press(page, "Undo");
  expect((await exportAs(page, "OBJ")).toString()).toBe(edited);
  expect(await slider(page, "Locality").inputValue()).toBe("1");
  await page.context().close();
});

it("Ctrl Z under an open dialog changes nothing that nobody sees", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+60cm");
  const edited = (await exportAs(page, "OBJ")).toString();
  await page.getByRole("button", { name: "Help" }).click();
  await page.getByText("all commands: type a few letters of one").waitFor();
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Escape");
  expect((await exportAs(page, "OBJ")).toString()).toBe(edited);
  await page.keyboard.press("Control+z");
  await idle(page);
  expect((await exportAs(page, "OBJ")).toString()).not.toBe(edited);
  await page.context().close();
});

it("Ctrl Z with a point in the hand leaves the steps alone, and the drag within its limit", async () => {
  const page = await site.openSmall();
  await typeTarget(page, "+60cm");
  const edited = (await exportAs(page, "OBJ")).toString();
  const from = await hintedPoint(page);
  await hold(page, from, { x: from.x, y: from.y - 140 });
  await page.getByText(/^Held back: /).waitFor();
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+y");
  await page.mouse.move(from.x, from.y - 150);
  await page.mouse.up();
  await idle(page);
  const [, now, before] =
    /sharpest fold ([\d.]+)° \(was ([\d.]+)°\)/.exec(await status(page)) ?? [];
  // Folds are said to a tenth of a degree.
  expect(Number(now)).toBeLessThan(Number(before) + 10.1);
  expect(Number(now)).toBeGreaterThan(Number(before) + 1);
  expect((await exportAs(page, "OBJ")).toString()).not.toBe(edited);
  await press(page, "Undo");
  expect((await exportAs(page, "OBJ")).toString()).toBe(edited);
  await page.context().close();
});

it("Ctrl S saves the design as Export JSON does, from a field too, and the tab says its name", async () => {
  const page = await site.openVault();
  await typeTarget(page, "+60cm");
  const exported = (await exportAs(page, "JSON")).toString();
  const saved = page.waitForEvent("download");
  await page.keyboard.press("Control+s");
  const file = await saved;
  expect(file.suggestedFilename()).toBe("vault-design.json");
  expect((await downloaded(file)).toString()).toBe(exported);
  expect(await page.evaluate(() => document.title)).toBe("Vault · Planish");
  await page.context().close();
});
