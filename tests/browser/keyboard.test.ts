// SPDX-License-Identifier: MIT
// Needs: focus, axe.
// The first minute without a pointer: Tab, Enter, arrows and typing, nothing else.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { expectClean } from "./support/axe.ts";
import { downloaded, idle, movedCount, status } from "./support/page.ts";
import { site } from "./support/site.ts";

/** The accessible name of what has the focus. */
const focused = (page: Page): Promise<string> =>
  page.evaluate(() => {
    const element = document.activeElement === document.body ? null : document.activeElement;
    const labels = element instanceof HTMLInputElement ? [...(element.labels ?? [])] : [];
    const name =
      element?.getAttribute("aria-label") ||
      labels.map((label) => label.textContent).join(" ") ||
      element?.textContent;
    return (name ?? "").replace(/\s+/g, " ").trim();
  });

/** What the eye sees of the focus: an outline of the element or of its row. */
const marked = (page: Page): Promise<boolean> =>
  page.evaluate(() => {
    const element = document.activeElement;
    if (!element) return false;
    return [getComputedStyle(element), getComputedStyle(element, "::after")].some(
      ({ outlineStyle, outlineWidth }) => outlineStyle !== "none" && outlineWidth !== "0px",
    );
  });

/** Tabs on until something of that name has the focus, which must be visible on the way. */
async function tabTo(page: Page, name: string): Promise<void> {
  for (let k = 0; k < 90; ++k) {
    await page.keyboard.press("Tab");
    const at = await focused(page);
    if (at === "") continue;
    expect(await marked(page), `focus on ${at}`).toBe(true);
    if (at === name) return;
  }
  throw new Error(`Tab never came to ${name}`);
}

it("edits, explores, makes exact, shares and exports", async () => {
  const page = await site.open({ reducedMotion: "reduce" });
  await tabTo(page, "3D view");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowRight");
  await tabTo(page, "Add handle");
  await page.keyboard.press("Enter");
  await idle(page);
  // On to the fields of the new handle, which lie before the button.
  await expect.poll(() => focused(page)).toBe("X");
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  expect(await focused(page)).toBe("Z");
  await page.keyboard.type("+(2+3)*20cm");
  await page.keyboard.press("Enter");
  await expect.poll(() => movedCount(page)).toBeGreaterThan(0);
  await idle(page);

  await tabTo(page, "Find variations");
  await page.keyboard.press("Enter");
  await page.getByRole("slider", { name: "Variation 1" }).waitFor();
  await idle(page);
  await tabTo(page, "Variation 1");
  for (let k = 0; k < 5; ++k) await page.keyboard.press("ArrowRight");
  await idle(page);
  expect(await page.getByRole("slider", { name: "Variation 1" }).inputValue()).toBe("0.05");
  await tabTo(page, "Explore");
  await page.keyboard.press("ArrowRight");
  await tabTo(page, "Make exact");
  await page.keyboard.press("Enter");
  await idle(page);
  expect(await status(page)).toContain("worst panel 0.0000 mm");

  await tabTo(page, "Export");
  await page.keyboard.press("Enter");
  await tabTo(page, "OBJ");
  const download = page.waitForEvent("download");
  await page.keyboard.press("Enter");
  expect((await downloaded(await download)).length).toBeGreaterThan(1000);
  await tabTo(page, "Share");
  await page.keyboard.press("Enter");
  await page.getByRole("dialog").waitFor();
  expect(await page.getByRole("textbox", { name: "Link" }).inputValue()).toContain("#v2=");
  await page.keyboard.press("Escape");
  expect(await focused(page)).toBe("Share");
  await page.keyboard.press("Control+z");
  await idle(page);
  await page.context().close();
});

it("Tab skips to the view and the controls; F6 goes from part to part, and Shift F6 back", async () => {
  const page = await site.open();
  for (const [name, region] of [
    ["Skip to the 3D view", "canvas"],
    ["Skip to the controls", "aside"],
  ] as const) {
    await page.evaluate("document.activeElement?.blur()");
    const link = page.getByRole("link", { name });
    await tabTo(page, name);
    await expect.poll(async () => (await link.boundingBox())?.height ?? 0).toBeGreaterThan(24);
    await expectClean(page, name);
    await page.keyboard.press("Enter");
    await expect
      .poll(() =>
        page.evaluate(() => document.activeElement?.closest("header, canvas, aside")?.localName),
      )
      .toBe(region);
    await expect.poll(async () => (await link.boundingBox())?.height ?? 0).toBeLessThan(2);
  }
  expect(new URL(page.url()).hash).toBe("");
  const region = (): Promise<string> =>
    page.evaluate(() => {
      const here = document.activeElement?.closest("header, canvas, aside");
      return here?.localName ?? "none";
    });
  const steps = [
    ["F6", ["header", "canvas", "aside", "header"]],
    ["Shift+F6", ["aside", "canvas", "header"]],
  ] as const;
  for (const [key, order] of steps) {
    for (const name of order) {
      await page.keyboard.press(key);
      await expect.poll(region).toBe(name);
    }
  }
  // From a field, too.
  await page.getByRole("button", { name: "Add handle" }).click();
  await idle(page);
  await page.getByRole("spinbutton").first().focus();
  await page.keyboard.press("F6");
  await expect.poll(region).toBe("header");
  await page.context().close();
});

it("reduced motion: nothing pulses, and the camera is there at once", async () => {
  const page = await site.open({ reducedMotion: "reduce" });
  await page.getByText("Drag this point").waitFor();
  const moving = (): Promise<number> => page.evaluate("document.getAnimations().length");
  expect(await moving()).toBe(0);
  await page.getByRole("button", { name: "Help" }).click();
  expect(await moving()).toBe(0);
  await page.keyboard.press("Escape");
  const places = await page.evaluate(async () => {
    const frame = (): Promise<unknown> => new Promise((done) => requestAnimationFrame(done));
    const sentence = (): string => {
      const span = [...document.querySelectorAll("span")].find(
        (element) => element.textContent === "Drag this point. Every panel stays flat.",
      );
      return JSON.stringify(span?.getBoundingClientRect());
    };
    const seen = [sentence()];
    [...document.querySelectorAll("button")].find((b) => b.textContent === "Top")?.click();
    for (let k = 0; k < 20; ++k) {
      await frame();
      seen.push(sentence());
    }
    return [...new Set(seen)];
  });
  expect(places.length).toBe(2);
  // Where motion is welcome, something does.
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await expect.poll(moving).toBeGreaterThan(0);
  await page.context().close();
});
