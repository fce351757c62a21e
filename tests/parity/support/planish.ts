// SPDX-License-Identifier: MIT
import { readFile } from "node:fs/promises";
import type { PlanishModule } from "@wasm/planish.mjs";
import type { AnalysisModule } from "@wasm/planish_analysis.mjs";
import type { GlbModule } from "@wasm/planish_glb.mjs";
import type { MobilityModule } from "@wasm/planish_mobility.mjs";
import type { ShopModule } from "@wasm/planish_shop.mjs";

const BUILT = new URL("../../../build/wasm/wasm/", import.meta.url);

/** The wasm core in node, as the worker has it in the browser. `name`: or planish, the one of a first
 * visit, which knows no keep-outs and no variations. */
export async function loadPlanish(name = "planish_whole"): Promise<PlanishModule> {
  const { default: create } = await import(new URL(`${name}.mjs`, BUILT).href);
  return create({ wasmBinary: await readFile(new URL(`${name}.wasm`, BUILT)) });
}

/** The module that measures designs, in node. */
export async function loadAnalysis(): Promise<AnalysisModule> {
  const { default: create } = await import(new URL("planish_analysis.mjs", BUILT).href);
  return create({ wasmBinary: await readFile(new URL("planish_analysis.wasm", BUILT)) });
}

/** The module that measures where a mesh can move, in node. */
export async function loadMobility(): Promise<MobilityModule> {
  const { default: create } = await import(new URL("planish_mobility.mjs", BUILT).href);
  return create({ wasmBinary: await readFile(new URL("planish_mobility.wasm", BUILT)) });
}

/** The module that writes cutting packages, in node. */
export async function loadShop(): Promise<ShopModule> {
  const { default: create } = await import(new URL("planish_shop.mjs", BUILT).href);
  return create({ wasmBinary: await readFile(new URL("planish_shop.wasm", BUILT)) });
}

/** The module that reads and writes designs, in node. */
export async function loadGlb(): Promise<GlbModule> {
  const { default: create } = await import(new URL("planish_glb.mjs", BUILT).href);
  return create({ wasmBinary: await readFile(new URL("planish_glb.wasm", BUILT)) });
}
