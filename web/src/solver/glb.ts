// SPDX-License-Identifier: MIT
// GLB, and designs as text, are read and written by a module of its own, fetched when it is needed
// for the first time.
// Meshes pass between it and the session as OBJ, which keeps every bit.
import type { Session } from "@wasm/planish.mjs";
import type { DesignReading, DesignValue, GlbModule } from "@wasm/planish_glb.mjs";
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
    throw new Error(
      "The part that reads and writes designs could not be loaded. Try again online.",
    );
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
  const { problem, mesh, stored, moved, positions, warnings } = glb.openGlb(bytes);
  if (problem) throw new Error(aboutFile(name, problem));
  const shape = { moved, positions };
  return { mesh, format: "obj", stored: { design: stored, shape, warnings } };
}

/** The design shown, with its base, its variations as morph targets, its recipe as text, and a second
 * layer if there is one. */
export async function writeGlb(
  session: Session,
  design: DesignValue,
  offset: Float64Array | null,
): Promise<Uint8Array> {
  const glb = await loadGlb();
  return glb.assembleGlb(
    session.write("obj"),
    session.basePositions(),
    session.variationSupport(),
    session.variationDisplacements(),
    offset ?? new Float64Array(),
    withBase(session, design),
  );
}

export const readDesign = async (text: string): Promise<DesignReading> =>
  (await loadGlb()).readDesign(text);

export async function writeDesign(session: Session, design: DesignValue): Promise<Uint8Array> {
  const glb = await loadGlb();
  return new TextEncoder().encode(glb.writeDesign(withBase(session, design)));
}

/** With the mesh that is open as its base. */
const withBase = (session: Session, { source, ...design }: DesignValue): DesignValue => ({
  ...design,
  source: "sample" in source ? source : { ...source, hash: session.baseHash() },
});
