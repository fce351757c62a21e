// SPDX-License-Identifier: MIT
// What is hidden is hidden in the view alone.
import { expect, it } from "vitest";
import { hideSelected, isolateSelected, showAll } from "../../web/src/features/hiding/hiding.ts";
import { hiddenPanels, isHidden } from "../../web/src/state/hidden-panels.ts";
import { openSample } from "../../web/src/state/opening.ts";
import { selectOnly, selectThese } from "../../web/src/state/selection.ts";
import { openedPage } from "./support/page-here.ts";

/** A point inside the vault of 20 by 20 panels. */
const INSIDE = 22 * 10;

it("the panels at selected points, or the selected panel, are hidden and no longer selected", async () => {
  const page = await openedPage("vault");
  const before = page.history.value;
  selectOnly(page, INSIDE);
  hideSelected(page);
  expect(hiddenPanels(page).value.size).toBe(4);
  expect(page.selection.value).toEqual([]);
  page.selectedPanel.value = 0;
  hideSelected(page);
  expect(hiddenPanels(page).value.size).toBe(5);
  expect(hiddenPanels(page).value.has(0)).toBe(true);
  hideSelected(page);
  expect(hiddenPanels(page).value.size).toBe(5);
  showAll(page);
  expect(hiddenPanels(page).value.size).toBe(0);
  expect(page.history.value).toBe(before);
});

it("isolating hides all the others, and keeps what is selected", async () => {
  const page = await openedPage("vault");
  selectThese(page, [INSIDE, INSIDE + 1]);
  isolateSelected(page);
  expect(hiddenPanels(page).value.size).toBe(400 - 6);
  expect(page.selection.value).toEqual([INSIDE, INSIDE + 1]);
  expect(isHidden(page, INSIDE)).toBe(false);
  // Beside it a point has panels in view, further on none.
  expect([INSIDE + 2, INSIDE + 3].map((v) => isHidden(page, v))).toEqual([false, true]);
  selectThese(page, []);
  isolateSelected(page);
  expect(hiddenPanels(page).value.size).toBe(400 - 6);
});

it("another mesh is shown whole", async () => {
  const page = await openedPage("vault");
  selectOnly(page, INSIDE);
  isolateSelected(page);
  await openSample(page, "dome");
  expect(hiddenPanels(page).value.size).toBe(0);
});
