// SPDX-License-Identifier: MIT
// Needs: storage, axe.
// Three variants with a view and a note are handed over, as a link and as a file, and are all there in
// the browser of someone else, verified.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { expectClean } from "./support/axe.ts";
import {
  exportAs,
  idle,
  obj,
  openFile,
  openViewOptions,
  showTab,
  typeTarget,
} from "./support/page.ts";
import { site } from "./support/site.ts";

const NOTE = "The middle comes up.\nThe third is the one that we would build.";

/** In an order that the page keeps. */
const named = (page: Page, what: string): Promise<string[]> =>
  page
    .getByRole("textbox", { name: new RegExp(`^Name of ${what}`) })
    .evaluateAll((fields) => fields.map((field) => (field as HTMLInputElement).value));

/** The shape of each variant, as it is exported once it is adopted. */
async function shapes(page: Page): Promise<string[]> {
  await showTab(page, "Explore");
  const all: string[] = [];
  for (const name of await named(page, "Variant")) {
    await page.getByRole("button", { name: `Adopt ${name}` }).click();
    await idle(page);
    all.push(await obj(page));
  }
  return all;
}

async function author(): Promise<Page> {
  const page = await site.open({ permissions: ["clipboard-read", "clipboard-write"] });
  for (const [k, rise] of ["+20cm", "+15cm", "+30cm"].entries()) {
    await typeTarget(page, rise);
    await showTab(page, "Explore");
    await page.getByRole("button", { name: "Take snapshot" }).click();
    const name = page.getByRole("textbox", { name: "Name of Snapshot 1" });
    await name.fill(`Variant ${k + 1}`);
    await name.press("Enter");
    await page.getByRole("textbox", { name: `Name of Variant ${k + 1}` }).waitFor();
  }
  await page.getByRole("button", { name: "Top", exact: true }).click();
  await openViewOptions(page);
  await page.getByRole("combobox", { name: "Cut the view" }).selectOption("across X");
  await idle(page);
  await page.getByText(/^Cuts \d+ panels, .* in all\./).waitFor();
  await page.getByRole("button", { name: "Keep this view" }).click();
  await page.getByRole("textbox", { name: "Name of View 1" }).waitFor();
  await page.getByRole("button", { name: "Perspective", exact: true }).click();
  await showTab(page, "Check and make");
  const note = page.getByRole("textbox", { name: "Note" });
  await note.fill(NOTE);
  await note.blur();
  return page;
}

interface HandedOver {
  readonly link: string;
  readonly sent: readonly string[];
  readonly shown: string;
}

async function expectHandedOver(page: Page, { link, sent, shown }: HandedOver): Promise<void> {
  await page
    .getByText(/^Verified:.* With it came a note, 1 view, 3 snapshots, a section\.$/)
    .waitFor();
  expect(await obj(page)).toBe(shown);
  // The same view, note, section, views and variants are the same link.
  await page.getByRole("button", { name: "Share" }).click();
  const again = await page.getByRole("textbox", { name: "Link" }).inputValue();
  expect(new URL(again).hash).toBe(new URL(link).hash);
  await page.keyboard.press("Escape");
  const arrived = page.getByRole("region", { name: "Note that came with the design" });
  await arrived.waitFor();
  expect(await arrived.locator("p").innerText()).toBe(NOTE);
  await expectClean(page, "a design that was handed over");
  await page.getByRole("button", { name: "Dismiss the note" }).click();
  expect(await arrived.count()).toBe(0);
  await showTab(page, "Check and make");
  expect(await page.getByRole("textbox", { name: "Note" }).inputValue()).toBe(NOTE);
  await openViewOptions(page);
  expect(await named(page, "View")).toEqual(["View 1"]);
  const cut = page.getByRole("combobox", { name: "Cut the view" });
  expect(await cut.locator("option:checked").innerText()).toBe("across X");
  await showTab(page, "Explore");
  expect(await named(page, "Variant")).toEqual(["Variant 1", "Variant 2", "Variant 3"]);
  expect(await shapes(page)).toEqual(sent);
}

let file: Buffer;
let handedOver: HandedOver;

it("three variants, a view and a note are made, and are what Share and Export hold", async () => {
  const page = await author();
  const shown = await obj(page);
  await page.getByRole("button", { name: "Share" }).click();
  const link = page.getByRole("textbox", { name: "Link" });
  const whole = await link.inputValue();
  await expectClean(page, "sharing with what goes along");
  await page.getByRole("checkbox", { name: "3 snapshots" }).uncheck();
  await expect.poll(async () => (await link.inputValue()).length).toBeLessThan(whole.length);
  await page.keyboard.press("Escape");
  file = await exportAs(page, "JSON");
  const sent = await shapes(page);
  expect(new Set(sent).size).toBe(3);
  expect(sent[2]).toBe(shown);
  await page.context().close();
  handedOver = { link: whole, sent, shown };
});

it("they come with a link", async () => {
  const page = await site.open({}, new URL(handedOver.link).hash);
  await expectHandedOver(page, handedOver);
  await page.reload();
  await page.getByText(/is back\./).waitFor();
  await showTab(page, "Check and make");
  expect(await page.getByRole("textbox", { name: "Note" }).inputValue()).toBe(NOTE);
  await page.context().close();
});

it("they come with a file", async () => {
  const page = await site.open();
  await openFile(page, "handed-over.json", file);
  await expectHandedOver(page, handedOver);
  await page.context().close();
});
