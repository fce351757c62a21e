// SPDX-License-Identifier: MIT

import { camelCase, insist } from "./error.ts";
import createPackage, { type PackageModule } from "./planish_package.mjs";
import { Pool } from "./pool.ts";
import { wasmBytes } from "./wasm-source.ts";

/** Commands with options. */
export type Command = "edit" | "explore" | "project" | "offset" | "mobility" | "convert" | "types";

/** The solver, once it is there: all that meshes and results share. */
export class Core {
  readonly pool = new Pool();
  readonly module: PackageModule;

  constructor(module: PackageModule) {
    this.module = module;
  }
}

let loading: Promise<Core> | undefined;

/** One core for all callers. A load that failed is tried again by the next one. */
export function loadCore(): Promise<Core> {
  loading ??= wasmBytes()
    .then((wasmBinary) => createPackage({ wasmBinary }))
    .then((module) => new Core(module))
    .catch((error: unknown) => {
      loading = undefined;
      throw error;
    });
  return loading;
}

/** What a command takes: each option with what it does. */
export async function options(command: Command): Promise<Record<string, string>> {
  const core = await loadCore();
  const lines = insist(core.module.options(command)).map(({ name, help }) => {
    return [camelCase(name), help.replace(/\s+/g, " ").trim()] as const;
  });
  return Object.fromEntries(lines);
}
