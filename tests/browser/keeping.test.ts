// SPDX-License-Identifier: MIT
// Needs: storage.
// What was kept is never written over unseen: by a page that its storage kept waiting, by one older
// than the record, by one that cannot open it. A tab that is killed leaves the old or the new design.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { storeRecord } from "../../web/src/design/stored-record.ts";
import { EDITED, RECORD } from "../web/support/golden-designs.ts";
import { keptRecords, putRecord, slowStorage } from "./support/faults.ts";
import { idle, kept, obj, status, typeTarget, usable } from "./support/page.ts";
import { site } from "./support/site.ts";

async function visit(page: Page, search = ""): Promise<void> {
  await page.goto(site.url + search);
  await usable(page);
  await idle(page);
}

it("storage that answers late costs neither the page nor what is kept", async () => {
  const page = await site.open({}, "", slowStorage(9_000));
  await typeTarget(page, "+60cm");
  const before = await obj(page);
  await kept(page);
  const records = await keptRecords(page);
  await visit(page, "?slow");
  expect(await status(page)).toMatch(/0 of 425 points move/);
  expect(await page.getByText(/does not let the page keep your design/).count()).toBe(1);
  await typeTarget(page, "+10cm");
  await page.waitForFunction(() => "storageCame" in window);
  await typeTarget(page, "+5cm");
  await kept(page);
  await visit(page);
  expect(await keptRecords(page)).toEqual(records);
  expect(await obj(page)).toBe(before);
  await page.context().close();
});

it("undo and redo come back after a reload, to the last bit", async () => {
  const page = await site.open();
  const shapes = [await obj(page)];
  for (const way of ["+10cm", "+20cm", "+30cm"]) {
    await typeTarget(page, way);
    shapes.push(await obj(page));
  }
  const press = async (name: string): Promise<string> => {
    await page.getByRole("button", { name, exact: true }).click();
    await idle(page);
    return obj(page);
  };
  expect(await press("Undo")).toBe(shapes[2]);
  await kept(page);
  await visit(page);
  expect(await obj(page)).toBe(shapes[2]);
  expect(await press("Redo")).toBe(shapes[3]);
  for (const shape of shapes.slice(0, 3).reverse()) expect(await press("Undo")).toBe(shape);
  await page.context().close();
});

it("a record of a newer version is left alone; the tab keeps its own beside it", async () => {
  const page = await site.open();
  await typeTarget(page, "+60cm");
  await kept(page);
  const newer = await keptRecords(page, 3);
  await visit(page);
  expect(await status(page)).toMatch(/0 of 425 points move/);
  expect(await page.getByRole("alert").count()).toBe(0);
  await typeTarget(page, "+10cm");
  const own = await obj(page);
  await kept(page);
  await visit(page);
  expect(await obj(page)).toBe(own);
  const now = await keptRecords(page);
  expect(Object.keys(now)).toHaveLength(2);
  expect(now).toMatchObject(newer);
  await page.context().close();
});

it("a design that cannot be opened is said, and stays kept", async () => {
  const page = await site.open();
  await typeTarget(page, "+60cm");
  await kept(page);
  const [slot = ""] = Object.keys(await keptRecords(page));
  const source = { kind: "sample", name: "no such sample", size: 9 } as const;
  const strange = storeRecord({ ...RECORD, present: { ...EDITED, source }, snapshots: [] });
  // Reloaded at once: the page itself would write its own design again when it is left.
  await page.goto("about:blank");
  const other = await site.openTab(page);
  await putRecord(other, slot, strange);
  await other.reload();
  await usable(other);
  expect(await other.getByRole("alert").innerText()).toMatch(/could not be opened; it stays kept/);
  const before = await keptRecords(other);
  await typeTarget(other, "+10cm");
  const own = await obj(other);
  await kept(other);
  await visit(other);
  expect(await obj(other)).toBe(own);
  expect(await keptRecords(other)).toMatchObject(before);
  await page.context().close();
});

it("gives the old design or the new one, whenever the tab is killed", async () => {
  let page = await site.open();
  await typeTarget(page, "+10cm");
  await kept(page);
  let old = await obj(page);
  for (const [k, delay] of [0, 150, 240, 260, 300].entries()) {
    await typeTarget(page, `+${k + 2}cm`);
    const now = await obj(page);
    await page.waitForTimeout(delay);
    const crashed = page.waitForEvent("crash");
    const session = await page.context().newCDPSession(page);
    session.send("Page.crash").catch(() => {});
    await crashed;
    const next = await site.openTab(page);
    await page.close();
    const found = await obj(next);
    expect([old, now]).toContain(found);
    expect(await next.getByRole("alert").count()).toBe(0);
    [page, old] = [next, found];
  }
  await page.context().close();
});
