// SPDX-License-Identifier: MIT
// What features put into places of the shell.
import { h, render } from "preact";
import { expect, it } from "vitest";
import type { Page } from "../../web/src/state/page.ts";
import { PageProvider } from "../../web/src/ui/page-context.ts";
import { place } from "../../web/src/ui/place.tsx";
import * as example from "../additions/example-section.ts";
import { pageAlone } from "../web/support/page-here.ts";

/** What a place draws on a page. */
function drawn(page: Page, Place: ReturnType<typeof place>): HTMLElement {
  const root = document.createElement("div");
  render(h(PageProvider, { value: page, children: h(Place, {}) }), root);
  return root;
}

it("a place draws what was put there in that order, on that page alone", () => {
  const [Place, one, other] = [place(), pageAlone(), pageAlone()];
  for (const word of ["first ", "second "]) Place.put(one, () => word);
  Place.put(other, () => "another");
  expect(drawn(one, Place).textContent).toBe("first second ");
  expect(drawn(other, Place).textContent).toBe("another");
});

it("the section of tests/additions is fetched and drawn once the page can be used", async () => {
  const [Place, page] = [place(), pageAlone()];
  Place.later(page, "ExampleSection", async () => example);
  const root = drawn(page, Place);
  expect(root.textContent).toBe("");
  page.ready.value = true;
  await expect.poll(() => root.querySelector("h2")?.textContent).toBe("Example");
});
