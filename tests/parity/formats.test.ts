// SPDX-License-Identifier: MIT
// One table of the core has the formats of meshes; every other list of them is held to it here.
import { execFileSync, spawnSync } from "node:child_process";
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

it("page and npm package have one type of them by hand", () => {
  const text = readFileSync(new URL("wasm/package/src/mesh-format.ts", ROOT), "utf8");
  const said = /type MeshFormat = (.*);/.exec(text)?.[1] ?? "";
  expect([...said.matchAll(/\w+/g)].map(String).sort()).toEqual(known().sort());
});

it("neither the page nor a package lists them anywhere else", () => {
  const files = execFileSync("git", ["ls-files", "web/src", "wasm", "python/planish"], {
    cwd: ROOT,
    encoding: "utf8",
  });
  const list = /\bobj\W{1,7}off\W{1,7}ply\b/i;
  const found = files
    .split("\n")
    .filter((file) => /\.(ts|tsx|mts|py|pyi)$/.test(file))
    .filter((file) => list.test(readFileSync(new URL(file, ROOT), "utf8")));
  expect(found).toEqual(["wasm/package/src/mesh-format.ts"]);
});

it("docs/formats.md has a row of each", () => {
  const text = readFileSync(new URL("docs/formats.md", ROOT), "utf8");
  for (const format of known()) expect(text).toContain(`\n| ${format.toUpperCase()} | `);
});
