// SPDX-License-Identifier: MIT
// Links that are not what they were: each opens with a sentence that says so, or with how far its
// design is from the one that was shared.
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import type { Recipe } from "../../web/src/design/recipe.ts";
import { exportAs, idle, status, typeTarget } from "../browser/support/page.ts";
import { decodeLink, encodeLink } from "../web/support/links.ts";
import { site } from "./support/site.ts";

let shared: Recipe;

let fragment = "";

it("a link is shown with its length", async () => {
  const page = await site.open();
  await typeTarget(page, "+60cm");
  await page.getByRole("button", { name: "Share" }).click();
  const link = await page.getByRole("textbox", { name: "Link" }).inputValue();
  await page.getByText(new RegExp(`^(Copied|Copy this link): ${link.length} characters`)).waitFor();
  fragment = new URL(link).hash;
  const decoded = await decodeLink(fragment);
  if (!decoded.ok) throw new Error(decoded.reason);
  if (!decoded.value.mark) throw new Error("no mark");
  shared = { ...decoded.value, mark: decoded.value.mark };
  await page.context().close();
});

async function openWith(hash: string): Promise<Page> {
  const page = await site.open({}, hash);
  await idle(page);
  return page;
}

it("a result that is not the shared one opens with how far it is off", async () => {
  const { mark, handles } = shared;
  const probes = mark.probes.map((x, k) => (k === 3 ? x + 0.005 : x));
  const moved = { ...shared, mark: { ...mark, hash: (mark.hash ^ 1) >>> 0, probes } };
  const page = await openWith(await encodeLink(moved));
  await expect
    .poll(() => page.getByRole("alert").textContent())
    .toMatch(/^Replayed: differs from the shared result by up to 5\.0 mm/);
  expect(await page.getByText(/Verified/).count()).toBe(0);
  const z = page.getByRole("spinbutton", { name: "Z" });
  expect(Number(await z.getAttribute("aria-valuenow"))).toBe(handles[0]?.target[2]);
  await page.context().close();
});

describe("a link that cannot be opened says why, and the page still works", () => {
  const cut = (): string => fragment.slice(0, fragment.length - 9);

  const turned = (): string => {
    const k = Math.floor(fragment.length / 2);
    return fragment.slice(0, k) + (fragment[k] === "A" ? "B" : "A") + fragment.slice(k + 1);
  };

  const family = { coefficients: [0.1, 0.1], asked: 1, eigenbasis: false };

  const handle = { vertex: 5000, target: [0, 0, 0], pinned: false } as const;

  const cases: readonly (readonly [string, () => string | Promise<string>, RegExp])[] = [
    ["cut", cut, /damaged: part of it is missing or was changed/],
    ["changed", turned, /damaged/],
    ["of a later version", () => fragment.replace("#v2=", "#v9="), /version 9.*versions 1 and 2/],
    ["empty", () => "#v2=", /damaged/],
    [
      "of a point that is not there",
      () => encodeLink({ ...shared, handles: [handle] }),
      /^Handle 5000: the mesh has vertices 0 to 424\.$/,
    ],
    [
      "of a sample that is not there",
      () => encodeLink({ ...shared, source: { kind: "sample", name: "castle", size: 9 } }),
      /There is no sample "castle"/,
    ],
    [
      "of more sliders than directions",
      () => encodeLink({ ...shared, families: [family] }),
      /coefficients must be at most as many as dimension/i,
    ],
  ];

  it.each(cases)("%s", async (_, make, sentence) => {
    const page = await openWith(await make());
    expect(await page.getByRole("alert").textContent()).toMatch(sentence);
    expect(await status(page)).toMatch(/0 of 425 points move/);
    await typeTarget(page, "+10cm");
    expect((await exportAs(page, "OBJ")).length).toBeGreaterThan(1000);
    await page.context().close();
  });
});
