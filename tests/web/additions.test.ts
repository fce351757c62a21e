// SPDX-License-Identifier: MIT
// In how many places by hand a kind, an option, a format or a feature is added: tests/additions names them one by
// one. The build for sanitizers makes those of C++ in copies and runs them (tests/unit/additions_test.cpp,
// example_kind_test.cpp); the others are made here.
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import additions from "../additions/additions.json" with { type: "json" };

interface Edit {
  readonly find: string;
  readonly put: string;
}
interface Place {
  readonly new?: string;
  readonly file?: string;
  readonly edits?: readonly Edit[];
}
type Addition = keyof typeof additions;

const read = (path: string): string =>
  readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");
const placesOf = (name: Addition): readonly Place[] => additions[name].places;

/** `path` with what `name` adds to it. */
function added(name: Addition, path: string): string {
  let text = read(path);
  for (const { file, edits = [] } of placesOf(name))
    if (file === path) for (const { find, put } of edits) text = text.replace(find, () => put);
  return text;
}

const PLACES: readonly (readonly [Addition, number])[] = [
  ["kind", 2],
  // Member, table, --help, the type that page and npm package share, and Python's typed keyword.
  ["number option", 5],
  ["list option", 7],
  // Its reader, its row, its name as a type for page and npm package, its row of the documents.
  ["format", 4],
  // Its folder, here one file, and a line of the table.
  ["feature", 2],
];

it.each(PLACES)("a %s is added in %i places", (name, count) => {
  expect(placesOf(name)).toHaveLength(count);
  for (const { new: own, file, edits } of placesOf(name)) {
    if (own) expect(read(own).length).toBeGreaterThan(0);
    for (const { find } of edits ?? [])
      expect(read(file ?? "").split(find), `${file}: ${find}`).toHaveLength(2);
  }
});

it("what the page and programs are told of options is said in one place for TypeScript and one for Python", () => {
  for (const [name, key, keyword] of [
    ["number option", "exampleNumber", "example_number"],
    ["list option", "exampleItems", "example_items"],
  ] as const) {
    const member = new RegExp(`interface EditValues \\{(?:(?!\\n\\}).)*\\b${key}\\b`, "s");
    const file = "wasm/package/src/edit-values.ts";
    expect(read(file)).not.toMatch(member);
    expect(added(name, file)).toMatch(member);
    const signature = new RegExp(`^def edit\\((?:(?!\\) -> ).)*\\n {4}${keyword}: `, "ms");
    expect(added(name, "python/planish/edits.py")).toMatch(signature);
  }
});
