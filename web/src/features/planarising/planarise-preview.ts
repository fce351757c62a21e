// SPDX-License-Identifier: MIT
// The planarising that is tried out at the door: what the view shows of it, and its figures.

import { batch } from "@preact/signals";
import { type Design, NO_REPORT } from "../../design/design.ts";
import type { Preview, Trial } from "../../design/planarising.ts";
import type { OpenedMesh, Planarising, Shape } from "../../solver/protocol.ts";
import { GivenUp } from "../../solver/second-solver.ts";
import { damageWords } from "../../state/damage.ts";
import type { Page } from "../../state/page.ts";
import { showOnly } from "../../state/showing.ts";
import { Beside } from "./beside.ts";
import { isMet, serves } from "./is-met.ts";
import { PlanariseTrials } from "./planarise-trial.ts";
import { ShownStops } from "./shown-stops.ts";
import { TrialMemory } from "./trial-memory.ts";
import { WayCosts } from "./way-costs.ts";

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

/** The sharpest one; null without one. */
export const sharpestFold = (folds: Float32Array): number | null =>
  folds.reduce<number | null>((most, fold) => (fold >= 0 ? Math.max(most ?? 0, fold) : most), null);

/** "4 panels became concave"; "none" where no panel is spoilt. */
export const spoiltWords = ({ measures }: Trial): string =>
  measures ? damageWords(measures.damage, measures.health) || "none" : "not measured";

/** Points: larger meshes wait until they are asked for. */
export const EAGER_POINTS = 5000;

/** Trials that are kept of one mesh; of a larger one, which takes room. */
const [KEPT, KEPT_LARGE] = [24, 2];

/** Milliseconds after which what is near the file is shown, while what was asked for is still tried. */
const NEAR_AFTER_MS = 150;

/** What is shown while a way is tried. */
type Running = Extract<Preview, { kind: "running" }>;

/** Tries ways to planarise one mesh while its door is open. */
export class PlanarisePreview {
  readonly costs: WayCosts;
  readonly #page: Page;
  readonly #memory: TrialMemory;
  readonly #trials: PlanariseTrials;
  readonly #stops = new ShownStops();
  /** Of what is near the file, beside what was asked for. */
  #beside: Beside | null = null;
  readonly #opened: OpenedMesh;
  readonly #design: Design;
  /** Counts what was wanted. */
  #newest = 0;
  #drawn = false;

  constructor(page: Page, opened: OpenedMesh, design: Design) {
    this.#page = page;
    this.#memory = new TrialMemory(opened.report.vertices > EAGER_POINTS ? KEPT_LARGE : KEPT);
    this.#trials = this.#newTrials();
    this.#opened = opened;
    this.#design = design;
    this.costs = new WayCosts(this.#newTrials(), opened, design);
  }

  #newTrials(): PlanariseTrials {
    return new PlanariseTrials(this.#page.spawn, this.#memory);
  }

  /** The first of the ways that makes every panel flat. Where none does, what there is near the file, or
   * else the last of them; null where it is refused, given up, or something newer is tried.
   * @param split so many panels may be split for it */
  show(split: number, ...ways: readonly Planarising[]): Promise<Trial | null> {
    this.#newest += 1;
    this.#beside?.end();
    const mine = this.#newest;
    this.costs.end();
    const trials = this.#newTrials();
    const tell = (near: Trial): void => this.#meanwhile(mine, near);
    const beside = new Beside(trials, this.#opened, this.#design, split, ways, tell);
    this.#beside = beside;
    const done = this.#find(mine, split, ways, beside);
    const giveUp = () => this.stop();
    this.#page.planariseTrial.value = { kind: "running", done, giveUp, step: 0, near: null };
    setTimeout(() => {
      if (this.#running(mine)) void beside.run();
    }, NEAR_AFTER_MS);
    return done;
  }

  async #find(
    mine: number,
    split: number,
    ways: readonly Planarising[],
    beside: Beside,
  ): Promise<Trial | null> {
    try {
      const trial = await this.#try(mine, split, ways, beside);
      if (!trial) return null;
      return this.#show(
        mine,
        serves(trial, this.#design, this.#opened) ? trial : ((await beside.run()) ?? trial),
      );
    } catch (error) {
      if (error instanceof GivenUp) return null;
      const instead = await beside.run();
      if (instead) return this.#show(mine, instead);
      if (mine !== this.#newest) return null;
      this.#drawFile();
      const sentence = error instanceof Error ? error.message : String(error);
      this.#page.planariseTrial.value = { kind: "refused", sentence };
      return null;
    }
  }

  #show(mine: number, trial: Trial): Trial | null {
    if (mine !== this.#newest) return null;
    this.#beside?.end();
    this.#draw(trial.mesh);
    this.#conclude(trial);
    return trial;
  }

  /** `trial` is what there is at its place of the slider. */
  #conclude(trial: Trial): void {
    const sameAs = this.#stops.show(trial.how.smooth, trial.mesh.positions);
    this.#page.planariseTrial.value = { kind: "shown", trial, sameAs };
  }

  async #try(
    mine: number,
    split: number,
    [how, ...others]: readonly Planarising[],
    beside: Beside,
  ): Promise<Trial | null> {
    if (!how) return null;
    const last = others.length === 0;
    const { source, settings } = this.#design;
    const { cuts } = settings;
    const said = (step: number): void => this.#change(mine, { step });
    const found = last ? beside.takeLast() : null;
    const trial =
      (await found) ??
      (await this.#trials.run({ source, cuts, how, split }, said).catch((error) => {
        if (last || error instanceof GivenUp) throw error;
        return null;
      }));
    const flat = trial && isMet(trial, this.#design);
    return flat || last ? trial : this.#try(mine, split, others, beside);
  }

  /** What is asked for takes its time. */
  #meanwhile(mine: number, trial: Trial): void {
    if (!this.#running(mine)) return;
    this.#draw(trial.mesh);
    this.#change(mine, { near: trial });
  }

  #running(mine: number): Running | null {
    const preview = this.#page.planariseTrial.peek();
    return mine === this.#newest && preview.kind === "running" ? preview : null;
  }

  #change(mine: number, changed: Partial<Pick<Running, "step" | "near">>): void {
    const running = this.#running(mine);
    if (running) this.#page.planariseTrial.value = { ...running, ...changed };
  }

  /** What is shown meanwhile is what there is. */
  stop(): void {
    const near = this.#running(this.#newest)?.near;
    if (!near) {
      this.end();
      return;
    }
    this.#newest += 1;
    this.#trials.end();
    this.#beside?.end();
    if (!near.instead) {
      const { keepBoundary } = near.how;
      this.#page.planarising.value = { ...this.#page.planarising.peek(), keepBoundary };
    }
    this.#conclude(near);
  }

  /** The file is shown again. */
  end(): void {
    this.#newest += 1;
    this.#trials.end();
    this.#beside?.end();
    this.costs.end();
    this.#drawFile();
    this.#page.planariseTrial.value = { kind: "none" };
  }

  #isHere(): boolean {
    return this.#page.mesh.peek() === this.#opened && this.#page.draft.peek() === this.#design;
  }

  #draw({ positions, report }: OpenedMesh): void {
    if (!this.#isHere()) return;
    this.#drawn = true;
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

  /** Settings may have changed since, as those of a mesh that is edited as it is. */
  #drawFile(): void {
    const now = this.#page.draft.peek();
    if (!this.#drawn || !now || this.#page.mesh.peek() !== this.#opened) return;
    this.#drawn = false;
    this.#page.figures.value = now.report;
    showOnly(this.#page, now);
  }
}
