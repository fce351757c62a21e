// SPDX-License-Identifier: MIT
// The planarising that is tried out at the door: what the view shows of it, and its figures.

import { batch } from "@preact/signals";
import { type Design, NO_REPORT } from "../../design/design.ts";
import type { Trial } from "../../design/planarising.ts";
import type { OpenedMesh, Planarising, Shape } from "../../solver/protocol.ts";
import { GivenUp } from "../../solver/second-solver.ts";
import { damageWords } from "../../state/damage.ts";
import type { Page } from "../../state/page.ts";
import { showOnly } from "../../state/showing.ts";
import { PlanariseTrials } from "./planarise-trial.ts";

/** Where two meshes of one topology differ. */
export function shapeOf(now: Float64Array, base: Float64Array): Shape {
  const moved: number[] = [];
  for (let v = 0; 3 * v < now.length; ++v)
    if ([0, 1, 2].some((c) => now[3 * v + c] !== base[3 * v + c])) moved.push(v);
  const positions = Float64Array.from(moved.flatMap((v) => [...now.subarray(3 * v, 3 * v + 3)]));
  return { moved: Int32Array.from(moved), positions };
}

/** The angle that 95 % of the panels fold by at most; null without one. */
export function usualFold(folds: Float32Array): number | null {
  const sorted = folds.filter((fold) => fold >= 0).sort();
  return sorted[Math.ceil(0.95 * sorted.length) - 1] ?? null;
}

/** "4 panels became concave"; "none" where no panel is spoilt. */
export const spoiltWords = ({ measures }: Trial): string =>
  measures ? damageWords(measures.damage, measures.health) || "none" : "not measured";

/** Points: larger meshes wait until they are asked for. */
export const EAGER_POINTS = 5000;

/** Whether every panel is as flat as was asked for. */
export const isMet = ({ how, mesh: { report } }: Trial, { settings }: Design): boolean =>
  report.worstExcess <= Math.max(settings.tolerance, how.flat);

/** Tries ways to planarise one mesh while its door is open. */
export class PlanarisePreview {
  readonly #page: Page;
  readonly #trials: PlanariseTrials;
  readonly #opened: OpenedMesh;
  readonly #design: Design;

  constructor(page: Page, opened: OpenedMesh, design: Design) {
    this.#page = page;
    this.#trials = new PlanariseTrials(page.spawn);
    this.#opened = opened;
    this.#design = design;
  }

  /** The first of the ways that makes every panel flat, or else the last; null where it is refused,
   * given up, or something newer is tried. @param split so many panels may be split for it */
  show(split: number, ...ways: readonly Planarising[]): Promise<Trial | null> {
    const done = this.#find(split, ways);
    this.#page.planariseTrial.value = { kind: "running", done, giveUp: () => this.end() };
    return done;
  }

  async #find(split: number, ways: readonly Planarising[]): Promise<Trial | null> {
    try {
      const trial = await this.#try(split, ways);
      if (!trial) return null;
      this.#draw(trial.mesh);
      this.#page.planariseTrial.value = { kind: "shown", trial };
      return trial;
    } catch (error) {
      if (error instanceof GivenUp) return null;
      this.#drawFile();
      const sentence = error instanceof Error ? error.message : String(error);
      this.#page.planariseTrial.value = { kind: "refused", sentence };
      return null;
    }
  }

  async #try(split: number, [how, ...others]: readonly Planarising[]): Promise<Trial | null> {
    if (!how) return null;
    const last = others.length === 0;
    const { source, settings } = this.#design;
    const { cuts } = settings;
    const trial = await this.#trials.run({ source, cuts, how, split }).catch((error) => {
      if (last || error instanceof GivenUp) throw error;
      return null;
    });
    const flat = trial && isMet(trial, this.#design);
    return flat || last ? trial : this.#try(split, others);
  }

  /** The file is shown again. */
  end(): void {
    this.#trials.end();
    this.#drawFile();
    this.#page.planariseTrial.value = { kind: "none" };
  }

  #isHere(): boolean {
    return this.#page.mesh.peek() === this.#opened && this.#page.draft.peek() === this.#design;
  }

  #draw({ positions, report }: OpenedMesh): void {
    if (!this.#isHere()) return;
    const shape = shapeOf(positions, this.#opened.positions);
    const { worstGap, worstMmPerM, worstExcess, planarising } = report;
    batch(() => {
      this.#page.figures.value = {
        ...NO_REPORT,
        worstGap,
        worstMmPerM,
        worstExcess,
        movedVertices: shape.moved.length,
        maxDisplacement: planarising.largest,
      };
      // What the trial before it moved goes back where this one does not move it.
      showOnly(this.#page, { ...this.#design, shape });
    });
  }

  #drawFile(): void {
    if (!this.#isHere() || this.#page.figures.peek() === this.#design.report) return;
    this.#page.figures.value = this.#design.report;
    showOnly(this.#page, this.#design);
  }
}
