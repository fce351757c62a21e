// SPDX-License-Identifier: MIT
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { withoutCodeFromText } from "../../../web/no-code-from-text.ts";
import type { RhinoModule } from "../../../web/src/rhino/model.ts";

const { resolve } = createRequire(import.meta.url);

/** McNeel's library in node, with its glue as the page has it. */
export async function loadRhino(): Promise<RhinoModule> {
  const glue = readFileSync(resolve("rhino3dm/rhino3dm.module.js"), "utf8");
  const folder = mkdtempSync(join(tmpdir(), "planish-rhino-"));
  const path = join(folder, "rhino3dm.mjs");
  writeFileSync(path, withoutCodeFromText(glue));
  const { default: create } = await import(/* @vite-ignore */ pathToFileURL(path).href);
  rmSync(folder, { recursive: true });
  return create({ wasmBinary: readFileSync(resolve("rhino3dm/rhino3dm.wasm")) });
}
