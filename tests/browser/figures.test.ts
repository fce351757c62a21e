// SPDX-License-Identifier: MIT
// Needs: workers.
// Every scene of docs/paper.md opens from its link and is the recorded design to the last bit. If an
// engine was changed on purpose, `node .tools/paper.mjs scenes` records them anew.
import { readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { idle, movedCount } from "./support/page.ts";
import { site } from "./support/site.ts";

interface Link {
  readonly name: string;
  readonly moved: number;
  readonly link: string;
}

const read = <T>(name: string): T =>
  JSON.parse(readFileSync(new URL(`../../docs/scenes/${name}`, import.meta.url), "utf8"));

const links = read<Link[]>("links.json");

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

it("the Sample list offers a scene of every figure", async () => {
  const group = page
    .getByRole("combobox", { name: "Sample" })
    .getByRole("option", { name: /^Figure/ });
  expect(await group.count()).toBe(9);
  await startAfresh();
  const first = (await group.first().textContent()) ?? "";
  await page.getByRole("combobox", { name: "Sample" }).selectOption({ label: first });
  await expect.poll(saysVerified).toBe(1);
});
