// SPDX-License-Identifier: MIT
// Files that nobody here made, each opened over an edit: either the import report, and undo brings
// the edit back to the last bit, or one sentence, and nothing has changed.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { catchExports, Hands } from "./support/hands.ts";
import { openFile, openSite, type Site, typeTarget } from "./support/page.ts";

const FOLDER = new URL("../../../shared/meshes/nasty/", import.meta.url);
const NAMES = existsSync(FOLDER) ? readdirSync(FOLDER).sort() : [];

describe.skipIf(NAMES.length === 0)("a nasty file", () => {
  let site: Site;
  let page: Page;
  let before: string;
  beforeAll(async () => {
    site = await openSite();
  });
  afterAll(() => site.close());

  it("finds an edit", async () => {
    const viewport = { width: 600, height: 480 };
    page = await site.open({ viewport, reducedMotion: "reduce" }, "", catchExports);
    await typeTarget(page, "+60cm");
    before = await new Hands(page).obj();
  });

  it.each(NAMES)("%s", async (name) => {
    const hands = new Hands(page);
    await openFile(page, name, readFileSync(new URL(name, FOLDER)));
    const sentence = await hands.alert();
    const reported = await page.getByRole("heading", { name }).count();
    expect([sentence !== "", reported === 1]).toEqual([reported === 0, sentence === ""]);
    if (sentence) {
      expect(sentence.startsWith(`${name}: `), sentence).toBe(true);
      expect(sentence).toMatch(/^[^\n]{10,300}\.$/);
    } else {
      expect(await hands.names("button")).toContain("Undo");
      await hands.press("Undo");
    }
    expect(await hands.obj()).toBe(before);
  });
});
