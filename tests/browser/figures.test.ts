// SPDX-License-Identifier: MIT
// Needs: workers.
// Scenes of docs/paper.md open from their links in a worker and are the recorded designs to the last bit: an
// edit, one within a region, and a mixture of variations. All of them open in node at every commit
// (tests/web/figures.test.ts), on the same engine and the same WebAssembly, and here every night.
import { readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { NIGHTLY } from "../patience.ts";
import { idle, movedCount } from "./support/page.ts";
import { site } from "./support/site.ts";

interface Link {
  readonly name: string;
  readonly moved: number;
  readonly link: string;
}

const read = <T>(name: string): T =>
  JSON.parse(readFileSync(new URL(`../../docs/scenes/${name}`, import.meta.url), "utf8"));

const FEW = ["figure-3-a", "figure-2-region", "figure-4-mix-a"];
const links = read<Link[]>("links.json").filter(({ name }) => NIGHTLY || FEW.includes(name));

/** One page for all: a fresh one for each link would take longer than the links do. */
let page: Page;

const saysVerified = (): Promise<number> => page.getByText(/Verified:/).count();

/** A page with nothing said and nothing moved. */
async function startAfresh(): Promise<void> {
  page ??= await site.open({ viewport: { width: 480, height: 360 } });
  await page.getByRole("combobox", { name: "Sample" }).selectOption("vault");
  await expect.poll(() => movedCount(page)).toBe(0);
  await idle(page);
  expect(await saysVerified()).toBe(0);
}

it.each(links)("$name opens from its link, verified", async ({ link, moved }) => {
  await startAfresh();
  await page.evaluate((hash) => {
    location.hash = hash;
  }, link);
  await expect.poll(saysVerified).toBe(1);
  expect(await movedCount(page)).toBe(moved);
});
