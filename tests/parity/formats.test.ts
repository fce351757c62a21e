// SPDX-License-Identifier: MIT
// One table of the core has the formats of meshes; every other list of them is held to it here.
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { FILE_FORMATS, filesOfFormats, namesOfFormats } from "../../web/src/solver/file-formats.ts";
import { EXPORT_COMMANDS } from "../../web/src/ui/commands/export-commands.ts";

const ROOT = new URL("../../", import.meta.url);
const CLI = new URL("build/native/planish", ROOT).pathname;

/** What the core names where a file is none: its table. */
function known(): string[] {
  const { stderr } = spawnSync(CLI, ["info", "mesh.none"], { encoding: "utf8" });
  const list = /the extension must be (.*)$/m.exec(stderr)?.[1] ?? "";
  return [...list.matchAll(/\.([a-z]+)/g)].map((extension) => extension[1] ?? "");
}

/** Lists by hand: where, what comes before the names, and how often. `plain`: without GLB. */
const LISTS = [
  { file: "wasm/planish.d.ts", before: "write\\(format: ", plain: true, times: 1 },
  { file: "wasm/package/src/mesh.ts", before: "type MeshFormat = ", times: 1 },
  { file: "wasm/package/src/mesh.ts", before: "with the extension ", times: 1 },
  { file: "wasm/package/src/planish-editor.ts", before: "type ExportKind = ", times: 1 },
  { file: "python/planish/mesh.py", before: '"""(?:From|To) ', times: 2 },
  { file: "python/planish/shape.py", before: '"""To ', times: 2 },
  { file: "python/planish/design.py", before: '"""To ', times: 1 },
] as const;

it("the core names its formats", () => {
  expect(known()).toContain("obj");
});

it("the page has the formats of the core, and says them in sentences and dialogs", () => {
  expect([...FILE_FORMATS].sort()).toEqual(known().sort());
  expect(namesOfFormats("3dm")).toBe("OBJ, OFF, PLY, GLB or 3DM");
  expect(filesOfFormats()).toBe(".obj,.off,.ply,.glb");
});

/** Not in the menu: OBJ says all that OFF does. The editor's own export and the command line write it. */
const NO_EXPORT = ["off"];

it("the Export menu has the formats of the page, all but OFF", () => {
  const names = Object.values(EXPORT_COMMANDS).map(({ name }) => name.toLowerCase());
  const offered = FILE_FORMATS.filter((format) => names.includes(format));
  expect(offered).toEqual(FILE_FORMATS.filter((format) => !NO_EXPORT.includes(format)));
});

it.each(LISTS)("$file: what follows $before names the formats of the core", (list) => {
  const text = readFileSync(new URL(list.file, ROOT), "utf8");
  // Words that are no names of formats end a list: "which", or "json" of the editor's own kinds.
  const names = known().join("|");
  const one = `[".]+(?:${names})"?`;
  const found = [
    ...text.matchAll(new RegExp(`${list.before}((?:${one}(?:, | or | \\| )?)+)`, "g")),
  ];
  expect(found).toHaveLength(list.times);
  const expected = known().filter((format) => !("plain" in list && format === "glb"));
  for (const [, said = ""] of found)
    expect([...said.matchAll(/[a-z]{3,}/g)].map(String).sort()).toEqual(expected.sort());
});

it("docs/formats.md has a row of each", () => {
  const text = readFileSync(new URL("docs/formats.md", ROOT), "utf8");
  for (const format of known()) expect(text).toContain(`\n| ${format.toUpperCase()} | `);
});
