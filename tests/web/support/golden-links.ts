// SPDX-License-Identifier: MIT
// Links as the last page that wrote version 1 wrote them, with what they hold: they open for ever.
import { readFileSync } from "node:fs";
import type { Recipe } from "../../../web/src/design/recipe.ts";

interface Golden {
  readonly name: string;
  readonly link: string;
  readonly recipe: Recipe;
}

type Stored = Record<string, { link: string; recipe: Recipe }>;

/** What edits have learnt since: no link of version 1 asks for it. */
const SINCE = { keepBends: false } as const;

const stored: Stored = JSON.parse(
  readFileSync(new URL("../golden/links-v1.json", import.meta.url), "utf8"),
  (key, value) => (key === "settings" ? { ...value, ...SINCE } : value),
);

/** In JSON the bytes of a file are a list. */
function withBlob(recipe: Recipe): Recipe {
  const { source } = recipe;
  if (source.kind === "sample") return recipe;
  const bytes = new Blob([Uint8Array.from(source.bytes as unknown as number[])]);
  return { ...recipe, source: { ...source, bytes } };
}

export const GOLDEN_LINKS: readonly Golden[] = Object.entries(stored).map(
  ([name, { link, recipe }]) => ({ name, link, recipe: withBlob(recipe) }),
);
