// SPDX-License-Identifier: MIT
// Needs: network.
// A new version of the page is put beside the running one: it is offered, never forced, and the
// design survives the change.
import { cp, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, beforeAll, expect, it } from "vitest";
import { holdSolvers, killNow } from "./support/faults.ts";
import { KEEPING, openSite, type Site } from "./support/open.ts";
import { exportAs, idle, showTab, typeTarget, usable } from "./support/page.ts";
import { SITE } from "./support/server.ts";

let directory: string;
let site: Site;
beforeAll(async () => {
  directory = await mkdtemp(join(tmpdir(), "planish-update-"));
  await cp(SITE, directory, { recursive: true });
  site = await openSite(directory);
});
afterAll(async () => {
  await site.close();
  await rm(directory, { recursive: true });
});

/** Publishes a version that differs from the one before in its name alone. */
async function publish(name: string): Promise<void> {
  const path = join(directory, "service-worker.js");
  const source = await readFile(path, "utf8");
  await writeFile(path, source.replace(/const VERSION = "[^"]*"/, `const VERSION = "${name}"`));
}

it("is offered during an edit, waits for the user, and loses nothing", async () => {
  const page = await site.open(KEEPING, "", holdSolvers);
  await page.evaluate("navigator.serviceWorker.ready");
  await page.reload();
  await usable(page);
  await typeTarget(page, "+60cm");
  await showTab(page, "Explore");
  await page.getByRole("button", { name: "Take snapshot" }).click();
  await page.evaluate("window.sameVisit = true");
  await publish("second");
  await page.evaluate("navigator.serviceWorker.getRegistration().then((r) => r.update())");
  const reload = page.getByRole("button", { name: "Reload" });
  await expect.poll(() => reload.count()).toBe(1);
  expect(await page.getByText("A new version is ready.").count()).toBe(1);
  // On a telephone it takes a line of its own, not the room of the figures.
  const wide = page.viewportSize();
  await page.setViewportSize({ width: 360, height: 740 });
  const figures = await page.getByRole("status").boundingBox();
  const offer = await reload.boundingBox();
  expect(figures?.width).toBeGreaterThan(200);
  expect(offer?.y).toBeGreaterThan((figures?.y ?? 0) + (figures?.height ?? 0) - 1);
  if (wide) await page.setViewportSize(wide);

  await typeTarget(page, "+25cm");
  await killNow(page);
  await expect.poll(() => page.getByRole("alert").count()).toBe(1);
  await idle(page);
  expect(await page.evaluate("window.sameVisit")).toBe(true);
  const before = await exportAs(page, "OBJ");

  const loaded = page.waitForEvent("load");
  await reload.click();
  await loaded;
  await usable(page);
  await idle(page);
  expect(await page.evaluate("window.sameVisit")).toBeUndefined();
  expect(await exportAs(page, "OBJ")).toEqual(before);
  await showTab(page, "Explore");
  expect(await page.getByRole("button", { name: "Adopt Snapshot 1" }).count()).toBe(1);
  expect(await page.evaluate("caches.keys()")).toContain("planish-second");
  await page.context().close();
});

it("does not reload another tab, which goes on with its own version", async () => {
  const first = await site.open(KEEPING, "", holdSolvers);
  await first.evaluate("navigator.serviceWorker.ready");
  await first.reload();
  await usable(first);
  const second = await site.openTab(first);
  await typeTarget(first, "+60cm");
  await first.evaluate("window.sameVisit = true");
  const before = await exportAs(first, "OBJ");
  await publish("third");
  await second.evaluate("navigator.serviceWorker.getRegistration().then((r) => r.update())");
  const loaded = second.waitForEvent("load");
  await second.getByRole("button", { name: "Reload" }).click();
  await loaded;
  await usable(second);
  expect(await first.evaluate("window.sameVisit")).toBe(true);
  await killNow(first);
  await expect.poll(() => first.getByRole("alert").count()).toBe(1);
  await idle(first);
  expect(await exportAs(first, "OBJ")).toEqual(before);
  await first.context().close();
});
