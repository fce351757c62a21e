// SPDX-License-Identifier: MIT
// Every scene of docs/paper.md opens from its link and is the recorded design to the last bit. A few of them
// open in the workers of browsers, too (tests/browser/figures.test.ts, tests/firefox). If an engine was
// changed on purpose, `node .tools/paper/paper.mjs scenes` records them anew.
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { replay } from "../../web/src/state/replaying.ts";
import { decodeLink } from "./support/links.ts";
import { pageHere } from "./support/page-here.ts";

interface Link {
  readonly name: string;
  readonly moved: number;
  readonly link: string;
}

const links: readonly Link[] = JSON.parse(
  readFileSync(new URL("../../docs/scenes/links.json", import.meta.url), "utf8"),
);

it.each(links)("$name opens from its link, verified", async ({ link, moved }) => {
  const recipe = await decodeLink(link);
  if (!recipe.ok) throw new Error(recipe.reason);
  const page = pageHere();
  expect(await replay(page, recipe.value)).toBe(true);
  expect(page.problem.value).toBeNull();
  expect(page.notice.value).toMatch(/^Verified/);
  expect(page.figures.value.movedVertices).toBe(moved);
});
