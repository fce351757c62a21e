// SPDX-License-Identifier: MIT
// The GLB module, fetched when a GLB is opened or exported for the first time.
import type { GlbModule } from "@wasm/planish_glb.mjs";
import glbUrl from "@wasm/planish_glb.wasm?url";

let loading: Promise<GlbModule> | null = null;

async function load(): Promise<GlbModule> {
  const { default: create } = await import("@wasm/planish_glb.mjs");
  return create({ locateFile: () => glbUrl });
}

/** Rejects with a sentence where it cannot be had; the next call tries again. */
export async function loadGlb(): Promise<GlbModule> {
  loading ??= load();
  try {
    return await loading;
  } catch {
    loading = null;
    throw new Error("The part that reads and writes GLB could not be loaded. Try again online.");
  }
}
