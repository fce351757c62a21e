// SPDX-License-Identifier: MIT
// Needs: network, axe.
// The guide that is served with the page: reached from Help, readable by everybody, no link that leads nowhere.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { expectClean } from "./support/axe.ts";
import { KEEPING } from "./support/open.ts";
import { site } from "./support/site.ts";

interface Served {
  readonly links: readonly string[];
  readonly anchors: readonly string[];
}

/** Where a page of the guide leads, within the guide, and the headings that can be led to. */
const look = (page: Page): Promise<Served> =>
  page.evaluate(() => ({
    links: [...document.querySelectorAll("main a, nav a")].map(
      (link) => (link as HTMLAnchorElement).href,
    ),
    anchors: [...document.querySelectorAll("[id]")].map(({ id }) => id),
  }));

it("opens from Help in a tab of its own, has every page that it leads to, and is accessible", async () => {
  const page = await site.open();
  await page.getByRole("button", { name: "Help" }).click();
  const opened = page.context().waitForEvent("page");
  await page.getByRole("link", { name: "The guide" }).click();
  const guide = await opened;
  await guide.getByRole("heading", { name: "Guide", level: 1 }).waitFor();
  const start = guide.url();
  expect(start).toBe(`${site.url}guide/index.html`);
  const seen = new Map<string, Served>();
  const open = [start];
  for (let url = open.pop(); url; url = open.pop()) {
    if (seen.has(url)) continue;
    const answer = await guide.goto(url);
    expect(answer?.status(), url).toBe(200);
    expect(await guide.title(), url).toMatch(/· Planish$/);
    await expectClean(guide, url);
    const served = await look(guide);
    seen.set(url, served);
    open.push(
      ...served.links
        .map((link) => link.split("#")[0] ?? "")
        .filter((link) => link.includes("/guide/")),
    );
  }
  for (const name of ["formats", "glossary", "command-line", "fabrication"]) {
    expect([...seen.keys()]).toContain(`${site.url}guide/${name}.html`);
  }
  const links = [...seen.values()].flatMap((served) => served.links);
  for (const link of links.filter((each) => each.includes("#"))) {
    const [url = "", anchor = ""] = link.split("#");
    expect(seen.get(url)?.anchors, link).toContain(anchor);
  }
  await page.context().close();
});

it("fits a phone, in the dark too", async () => {
  const page = await site.open({ viewport: { width: 320, height: 640 }, colorScheme: "dark" });
  for (const name of ["index", "formats", "command-line"]) {
    await page.goto(`${site.url}guide/${name}.html`);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(overflow, name).toBeLessThanOrEqual(0);
    await expectClean(page, name);
  }
  await page.context().close();
});

it("stays without a network once it was read", async () => {
  const page = await site.open(KEEPING);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.reload();
  await page.goto(`${site.url}guide/index.html`);
  await page.context().setOffline(true);
  await page.reload();
  await page.getByRole("heading", { name: "Guide", level: 1 }).waitFor();
  await page.context().close();
});
