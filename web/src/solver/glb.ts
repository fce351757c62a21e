// SPDX-License-Identifier: MIT
// GLB is read and written by a module of its own, fetched when it is needed for the first time.
// Meshes pass between it and the session as OBJ, which keeps every bit.
import type { Session } from "@wasm/planish.mjs";
import type { GlbModule } from "@wasm/planish_glb.mjs";
import glbUrl from "@wasm/planish_glb.wasm?url";
import type { StoredDesign } from "./protocol.ts";
import { aboutFile } from "./reading.ts";

let loading: Promise<GlbModule> | null = null;

async function load(): Promise<GlbModule> {
  const { default: create } = await import("@wasm/planish_glb.mjs");
  return create({ locateFile: () => glbUrl });
}

/** Rejects with a sentence where it cannot be had; the next call tries again. */
async function loadGlb(): Promise<GlbModule> {
  loading ??= load();
  try {
    return await loading;
  } catch {
    loading = null;
    throw new Error("The part that reads and writes GLB could not be loaded. Try again online.");
  }
}

interface OpenedGlb {
  readonly mesh: Uint8Array;
  readonly format: "obj";
  /** null for a GLB without a design. */
  readonly stored: StoredDesign | null;
}

/** The base of the design in a GLB, or its mesh; throws a sentence if it is refused. */
export async function openGlb(name: string, bytes: Uint8Array): Promise<OpenedGlb> {
  const glb = await loadGlb();
  const { problem, mesh, design, moved, positions, warnings } = glb.openGlb(bytes);
  if (problem) throw new Error(aboutFile(name, problem));
  return { mesh, format: "obj", stored: { design, shape: { moved, positions }, warnings } };
}

/** The design shown, with its base, its variations as morph targets, and its recipe as text. */
export async function writeGlb(session: Session, design: string): Promise<Uint8Array> {
  const glb = await loadGlb();
  return glb.assembleGlb(
    session.write("obj"),
    session.basePositions(),
    session.variationSupport(),
    session.variationDisplacements(),
    design,
  );
}
