// SPDX-License-Identifier: MIT
// The second layer's section.
import type { Page } from "playwright-core";
import { expect } from "vitest";
import { showTab } from "./page.ts";

/** Asks for a layer, and waits for what is said of it. */
export async function layOut(
  page: Page,
  distance: string,
  says: RegExp,
  keeps?: string,
): Promise<void> {
  await showTab(page, "Check and make");
  const part = page.locator("details").filter({ hasText: "Second layer" });
  if ((await part.getAttribute("open")) === null) await part.locator("summary").click();
  await part.getByRole("spinbutton").fill(distance);
  const form = part.getByRole("combobox", { name: "Offset kind" });
  await form.selectOption(keeps ?? "What the design allows");
  await part.getByRole("button", { name: "Show" }).click();
  await expect.poll(() => part.locator("[aria-live]").innerText()).toMatch(says);
}
