// SPDX-License-Identifier: MIT
// The planarising that is tried out at the door: what the view shows of it, and its figures.
import { batch, type Signal, signal } from "@preact/signals";
import type { OpenedMesh } from "../solver/protocol.ts";
import { type Design, NO_REPORT } from "./design.ts";
import { shapeOf } from "./planarise-figures.ts";
import { GivenUp, PlanariseTrials, type Trial } from "./planarise-trial.ts";
import { showOnly } from "./showing.ts";
import { draft, figures, mesh } from "./store.ts";

export type Preview =
  | { readonly kind: "none" }
  | { readonly kind: "running" }
  | { readonly kind: "refused"; readonly sentence: string }
  | { readonly kind: "shown"; readonly trial: Trial };

/** Points: larger meshes wait until they are asked for. */
export const EAGER_POINTS = 5000;

/** Tries ways to planarise one mesh while its door is open. */
export class PlanarisePreview {
  readonly state: Signal<Preview> = signal({ kind: "none" });
  readonly #trials = new PlanariseTrials();
  readonly #opened: OpenedMesh;
  readonly #design: Design;

  constructor(opened: OpenedMesh, design: Design) {
    this.#opened = opened;
    this.#design = design;
  }

  /** Whether every panel becomes flat; null where something newer is tried. */
  async show(how: Trial["how"]): Promise<boolean | null> {
    this.state.value = { kind: "running" };
    try {
      const trial = await this.#trials.run(this.#design.source, how);
      this.#draw(trial.mesh);
      this.state.value = { kind: "shown", trial };
      return trial.mesh.report.worstExcess <= this.#design.settings.tolerance;
    } catch (error) {
      if (error instanceof GivenUp) return null;
      this.#drawFile();
      const sentence = error instanceof Error ? error.message : String(error);
      this.state.value = { kind: "refused", sentence };
      return false;
    }
  }

  /** The file is shown again. */
  end(): void {
    this.#trials.end();
    this.#drawFile();
    this.state.value = { kind: "none" };
  }

  #isHere(): boolean {
    return mesh.peek() === this.#opened && draft.peek() === this.#design;
  }

  #draw({ positions, report }: OpenedMesh): void {
    if (!this.#isHere()) return;
    const shape = shapeOf(positions, this.#opened.positions);
    const { worstGap, worstMmPerM, worstExcess, planarising } = report;
    batch(() => {
      figures.value = {
        ...NO_REPORT,
        worstGap,
        worstMmPerM,
        worstExcess,
        movedVertices: shape.moved.length,
        maxDisplacement: planarising.largest,
      };
      // What the trial before it moved goes back where this one does not move it.
      showOnly({ ...this.#design, shape });
    });
  }

  #drawFile(): void {
    if (!this.#isHere() || figures.peek() === this.#design.report) return;
    figures.value = this.#design.report;
    showOnly(this.#design);
  }
}
