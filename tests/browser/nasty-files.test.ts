// SPDX-License-Identifier: MIT
// Files that nobody here made, each opened over an edit: either the import report, and undo brings
// the edit back to the last bit, or one sentence, and nothing has changed.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { catchExports, Hands } from "./support/hands.ts";
import { openFile, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";

const FOLDER = new URL("../../../shared/meshes/nasty/", import.meta.url);
const NAMES = existsSync(FOLDER) ? readdirSync(FOLDER).sort() : [];

describe.skipIf(NAMES.length === 0)("a nasty file", () => {
  let page: Page;
  let before: string;

  it("finds an edit", async () => {
    const viewport = { width: 600, height: 480 };
    page = await site.open({ viewport, reducedMotion: "reduce" }, "", catchExports);
    await typeTarget(page, "+60cm");
    before = await new Hands(page).obj();
  });

  it.each(NAMES)("%s", async (name) => {
    const hands = new Hands(page);
    await openFile(page, name, readFileSync(new URL(name, FOLDER)));
    const heading = page.getByRole("heading", { name, exact: true });
    const refused = async () => (await hands.alert()).startsWith(`${name}: `);
    await expect.poll(async () => (await refused()) !== ((await heading.count()) === 1)).toBe(true);
    if (await refused()) expect(await hands.alert()).toMatch(/^[^\n]{10,300}\.$/);
    else await hands.press("Undo");
    await expect.poll(() => hands.obj()).toBe(before);
  });
});
