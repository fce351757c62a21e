// SPDX-License-Identifier: MIT
// What the view says about points: under the pointer, chosen, and where a handle came from.
import { expect, it } from "vitest";
import { idle, openAdvanced, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

it("every slider says its value with its unit", async () => {
  const page = await site.openVault();
  await openAdvanced(page);
  const spoken = (name: string) =>
    page.getByRole("slider", { name, exact: true }).getAttribute("aria-valuetext");
  expect(await spoken("Locality")).toBe(
    "1.0 times the default weight: from more points follow to fewer follow",
  );
  expect(await spoken("Smoothness")).toBe(
    "1.0 times the default weight: from sharp, close by to gentle, wider",
  );
  expect(await spoken("Dimension")).toMatch(/^4 directions: /);
  await page.getByRole("slider", { name: "Dimension" }).fill("1");
  await expect.poll(() => spoken("Dimension")).toMatch(/^1 direction: /);
  await page.getByRole("slider", { name: "Dimension" }).fill("3");
  await typeTarget(page, "+40cm");
  await page.getByRole("button", { name: "Find variations" }).click();
  await idle(page);
  const sliders = page.getByRole("slider", { name: /^Variation \d+$/ });
  await expect.poll(() => sliders.count()).toBeGreaterThan(0);
  for (const slider of await sliders.all())
    expect(await slider.getAttribute("aria-valuetext")).toBe("0 mm");
  const first = sliders.first();
  await first.fill("0.5");
  await first.dispatchEvent("change");
  await idle(page);
  expect(await first.getAttribute("aria-valuetext")).toMatch(/^\+[\d.]+ mm$/);
  const all = await page.getByRole("slider").all();
  for (const slider of all)
    expect(await slider.getAttribute("aria-valuetext")).toMatch(
      /^(?:[+−]?[\d.]+ (mm|m|times|directions?|panels?|of 10)|no limit|by the raw weights)\b/,
    );
  await page.context().close();
});

it("Share puts the link itself on the clipboard", async () => {
  const page = await site.openVault({ permissions: ["clipboard-read", "clipboard-write"] });
  await typeTarget(page, "+40cm");
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(link);
  expect(await page.getByText(`Copied: ${link.length} characters.`).count()).toBe(1);
  expect(link.startsWith(`${site.url}#v1=`)).toBe(true);
  await page.context().close();
});
