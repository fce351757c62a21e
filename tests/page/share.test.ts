// SPDX-License-Identifier: MIT
// What a link holds, and what a design too large for one is offered.
import type { Page } from "playwright-core";
import { expect, it, onTestFinished } from "vitest";
import { flatRoof } from "../browser/support/faults.ts";
import {
  exportAs,
  idle,
  movedCount,
  openFile,
  status,
  still,
  typeTarget,
} from "../browser/support/page.ts";
import { randomFrom } from "../web/support/mutations.ts";
import { site } from "./support/site.ts";

/** The status line without what the clock says and what comes later. */
const figures = async (page: Page): Promise<string> =>
  /^.*worst panel [^·]*/.exec(await status(page))?.[0].trim() ?? "none";

it("a shared link opens as the same design, to the last bit", async () => {
  const page = await site.openVault();
  await page.getByRole("button", { name: "Add handle" }).click();
  const z = page.getByRole("spinbutton", { name: "Z" });
  await z.fill("+40cm");
  await z.press("Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);
  const numbers = await figures(page);
  const file = await exportAs(page, "OBJ");
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  expect(link.length).toBeLessThan(600);
  expect(await page.getByRole("button", { name: "Save design" }).count()).toBe(0);
  await page.context().close();

  const other = await site.open({}, new URL(link).hash);
  await expect.poll(() => other.getByText(/Verified/).count()).toBe(1);
  expect(await figures(other)).toBe(numbers);
  expect(await exportAs(other, "OBJ")).toEqual(file);
  await other.context().close();
});

async function linkOf(page: Page): Promise<string> {
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.keyboard.press("Escape");
  return link;
}

async function vary(page: Page, slider: string, value: string): Promise<void> {
  await page.getByRole("button", { name: "Find variations" }).click();
  await expect.poll(() => page.getByRole("slider", { name: slider }).count()).toBe(1);
  await idle(page);
  await page.getByRole("slider", { name: slider }).fill(value);
  await idle(page);
}

it("a link holds file, unit, families and camera: shared again it is the same link", async () => {
  const page = await site.openVault({ reducedMotion: "reduce" });
  await openFile(page, "roof.obj", flatRoof(10));
  await page.getByRole("combobox", { name: "Unit of the file" }).selectOption("cm");
  await page.getByRole("button", { name: "Start editing" }).click();
  await typeTarget(page, "+0.6");
  await vary(page, "Variation 1", "0.4");
  await vary(page, "Variation 2", "-0.3");
  await page.getByRole("button", { name: "Top", exact: true }).click();
  await still(page);
  const link = await linkOf(page);
  const file = await exportAs(page, "OBJ");
  await page.context().close();

  const other = await site.open({ reducedMotion: "reduce" }, new URL(link).hash);
  await expect.poll(() => other.getByText(/Verified/).count()).toBe(1);
  await idle(other);
  expect(await exportAs(other, "OBJ")).toEqual(file);
  expect(await linkOf(other)).toBe(link);
  await other.context().close();
});

/** Triangles with coordinates that cannot be packed. */
function noise(triangles: number): string {
  const random = randomFrom(7);
  const lines = Array.from(
    { length: 3 * triangles },
    () => `v ${random()} ${random()} ${random()}`,
  );
  for (let k = 0; k < triangles; ++k) lines.push(`f ${3 * k + 1} ${3 * k + 2} ${3 * k + 3}`);
  return `${lines.join("\n")}\n`;
}

it("warns of long links and offers the saved design beside them, and instead of longer ones", async () => {
  const page = await site.openVault();
  await openFile(page, "noise.obj", noise(100));
  await page.getByRole("button", { name: "Start editing" }).click();
  expect((await linkOf(page)).length).toBeGreaterThan(8_000);
  await page.getByRole("button", { name: "Share" }).click();
  await page.getByRole("textbox", { name: "Link" }).waitFor();
  expect(await page.getByText(/Some programs cut links this long/).count()).toBe(1);
  const save = page.getByRole("button", { name: "Save design" });
  const beside = page.waitForEvent("download");
  await save.click();
  expect((await beside).suggestedFilename()).toBe("noise-design.json");
  await openFile(page, "noise.obj", noise(400));
  await page.getByRole("button", { name: "Start editing" }).click();
  await expect.poll(async () => (await linkOf(page)).length).toBeGreaterThan(32_000);
  await page.getByRole("button", { name: "Share" }).click();
  const download = page.waitForEvent("download");
  await save.click();
  expect((await download).suggestedFilename()).toBe("noise-design.json");
  await page.context().close();
});

it("where the browser keeps the clipboard from the page, Copy takes the link the older way", async () => {
  const page = await site.openVault();
  const { writeText } = navigator.clipboard;
  onTestFinished(() => {
    navigator.clipboard.writeText = writeText;
    Reflect.deleteProperty(document, "execCommand");
  });
  await page.evaluate(() => {
    const taken = { text: "" };
    Object.assign(globalThis, { taken });
    navigator.clipboard.writeText = () => Promise.reject(new Error("not allowed"));
    document.execCommand = (command: string) => {
      const box = document.querySelector<HTMLInputElement>(".link-box");
      if (command === "copy" && box)
        taken.text = box.value.slice(box.selectionStart ?? 0, box.selectionEnd ?? 0);
      return taken.text !== "";
    };
  });
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.getByText(/^Copy this link: \d+ characters\./).waitFor();
  const copy = page.getByRole("button", { name: "Copy", exact: true });
  await copy.click();
  await page.getByText(/^Copied: \d+ characters\./).waitFor();
  expect(await copy.count()).toBe(0);
  const taken = () => (globalThis as unknown as { taken: { text: string } }).taken.text;
  expect(await page.evaluate(taken)).toBe(link);
  await page.context().close();
});
