// SPDX-License-Identifier: MIT
// Files that nobody here made, each opened over an edit: either the import report, and undo brings
// the edit back to the last bit, or one sentence, and nothing has changed.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { idle, obj, openFile, typeTarget } from "../browser/support/page.ts";
import { site } from "./support/site.ts";

const FOLDER = new URL("../../../shared/meshes/nasty/", import.meta.url);
const NAMES = existsSync(FOLDER) ? readdirSync(FOLDER).sort() : [];

const alert = async (page: Page): Promise<string> =>
  (await page.getByRole("alert").allTextContents()).join();

describe.skipIf(NAMES.length === 0)("a nasty file", () => {
  let page: Page;
  let before: string;

  it("finds an edit", async () => {
    page = await site.open();
    await typeTarget(page, "+60cm");
    before = await obj(page);
  });

  it.each(NAMES)("%s", async (name) => {
    await openFile(page, name, readFileSync(new URL(name, FOLDER)));
    const heading = page.getByRole("heading", { name, exact: true });
    const refused = async () => (await alert(page)).startsWith(`${name}: `);
    await expect.poll(async () => (await refused()) !== ((await heading.count()) === 1)).toBe(true);
    if (await refused()) expect(await alert(page)).toMatch(/^[^\n]{10,300}\.$/);
    else await page.getByRole("button", { name: "Undo" }).click();
    await idle(page);
    expect(await obj(page)).toBe(before);
  });
});
