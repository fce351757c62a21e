// SPDX-License-Identifier: MIT
// GLB, and designs as text, are read and written by the module of documents.
// Meshes pass between it and the session as OBJ, which keeps every bit.
import type { Session } from "@wasm/planish.mjs";
import type { DesignReading, DesignValue, GlbModule } from "@wasm/planish_documents.mjs";
import type { JoinPoints } from "../rhino/weld.ts";
import { loadDocuments } from "./documents.ts";
import type { Mending, Request, StoredDesign } from "./protocol.ts";
import { aboutFile } from "./reading.ts";

interface OpenedGlb {
  readonly mesh: Uint8Array;
  readonly format: "obj";
  /** null for a GLB without a design. */
  readonly stored: StoredDesign | null;
}

/** A design with the mesh that is open as its base. */
const withBase = (session: Session, { source, ...design }: DesignValue): DesignValue => ({
  ...design,
  source: "sample" in source ? source : { ...source, hash: session.baseHash() },
});

type Export = Extract<Request, { kind: "export"; format: "glb" | "json" | "link" }>;

/** Every call rejects with a sentence where the module cannot be had; the next one tries again. */
export class DesignFiles {
  #loading: Promise<GlbModule> | null = null;

  /** The base of the design in a GLB, or its mesh; throws a sentence if it is refused. */
  async openGlb(name: string, bytes: Uint8Array): Promise<OpenedGlb> {
    const glb = await this.#module();
    const { problem, mesh, stored, moved, positions, warnings } = glb.openGlb(bytes);
    if (problem) throw new Error(aboutFile(name, problem));
    const shape = { moved, positions };
    return { mesh, format: "obj", stored: { design: stored, shape, warnings } };
  }

  /** OBJ in and out. */
  async mend(way: Mending, mesh: Uint8Array): Promise<Uint8Array> {
    return (await this.#module()).mend(mesh, way);
  }

  async read(text: string): Promise<DesignReading> {
    return (await this.#module()).readDesign(text);
  }

  /** The design shown as text. */
  async text(session: Session, design: DesignValue): Promise<string> {
    return (await this.#module()).writeDesign(withBase(session, design));
  }

  /** The design shown: as text, or as GLB with its base, its variations as morph targets, its recipe as
   * text, and a second layer if there is one. */
  async write(session: Session, { format, design, offset }: Export): Promise<Uint8Array> {
    const glb = await this.#module();
    const whole = withBase(session, design);
    if (format === "json") return new TextEncoder().encode(glb.writeDesign(whole));
    if (format === "link") return new TextEncoder().encode(glb.writeLinkText(whole));
    return glb.assembleGlb(
      session.write("obj"),
      session.basePositions(),
      session.variationSupport(),
      session.variationDisplacements(),
      offset ?? new Float64Array(),
      whole,
    );
  }

  /** What joins points that the panels of a file have of their own. */
  async joinPoints(): Promise<JoinPoints> {
    const files = await this.#module();
    return (points, within) => {
      const places = files.joinedPoints(points, within);
      if (3 * places.length === points.length) return places;
      throw new Error("There is not enough memory for this model in the browser.");
    };
  }

  async #module(): Promise<GlbModule> {
    this.#loading ??= loadDocuments();
    try {
      return await this.#loading;
    } catch {
      this.#loading = null;
      throw new Error(
        "The part that reads and writes designs could not be loaded. Try again online.",
      );
    }
  }
}
