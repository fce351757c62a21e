// SPDX-License-Identifier: MIT
// What is measured on a finished design, by a module of its own that is fetched after the first.
import type { Session } from "@wasm/planish.mjs";
import type { Analysis, AnalysisModule } from "@wasm/planish_analysis.mjs";
import analysisUrl from "@wasm/planish_analysis.wasm?url";
import type { AlsoMeasured, FreedomReport, PanelMeasures, Shape, Targets } from "./protocol.ts";

async function load(): Promise<AnalysisModule> {
  const { default: create } = await import("@wasm/planish_analysis.mjs");
  return create({ locateFile: () => analysisUrl });
}

/** What sliders do to an edit. */
export interface ShapeFamily {
  readonly centre: Shape;
  /** Vertices, ascending. */
  readonly support: Int32Array;
  /** x, y, z of each of them at value 1, slider by slider. */
  readonly moves: Float64Array;
}

/** Measures what one session shows; nothing before its module has arrived, so that a drag never
 * waits for it. */
export class DesignAnalysis {
  readonly #session: Session;
  readonly #arrived: () => void;
  #loading = false;
  #module: AnalysisModule | null = null;
  #analysis: Analysis | null = null;
  /** That it knows. */
  #family: ShapeFamily | null = null;

  constructor(session: Session, arrived: () => void) {
    this.#session = session;
    this.#arrived = arrived;
  }

  /** The session has another base now. */
  forget(): void {
    this.#analysis?.delete();
    this.#analysis = null;
    this.#family = null;
  }

  panels({ fairness, folds, defectsOf }: AlsoMeasured): PanelMeasures | null {
    const [module, analysis] = this.#current();
    if (!module || !analysis) return null;
    return {
      figures: analysis.panelFigures(),
      health: analysis.panelHealth(),
      nodes: analysis.nodesToRemake(),
      damage: analysis.panelDamage(),
      folds: folds ? analysis.panelFolds() : null,
      bending: fairness ? analysis.vertexBending(module.FairnessKind[fairness]) : null,
      defects: defectsOf ? analysis.defects(defectsOf) : null,
    };
  }

  /** Of a shape that need not be shown. */
  measure({ moved, positions }: Shape): PanelMeasures | null {
    const [, analysis] = this.#current();
    if (!analysis) return null;
    analysis.show(moved, positions);
    return {
      figures: analysis.panelFigures(),
      health: analysis.panelHealth(),
      nodes: analysis.nodesToRemake(),
      damage: analysis.panelDamage(),
      folds: analysis.panelFolds(),
      bending: null,
      defects: null,
    };
  }

  /** Of each slider of a family, all others where they are: lower stop, its panel, upper stop, its panel. */
  stops(family: ShapeFamily, values: readonly number[]): Float64Array | null {
    const [, analysis] = this.#current();
    if (!analysis) return null;
    if (this.#family !== family) {
      const { centre, support, moves } = family;
      analysis.setFamily(centre.moved, centre.positions, support, moves);
      this.#family = family;
    }
    return analysis.sliderStops(Float64Array.from(values));
  }

  freedom({ handles, pins }: Targets): FreedomReport | null {
    const [, analysis] = this.#current();
    if (!analysis) return null;
    return analysis.freedom(Float64Array.from(handles), Int32Array.from(pins));
  }

  #current(): [AnalysisModule, Analysis] | [null, null] {
    const session = this.#session;
    if (!this.#module) {
      void this.#load();
      return [null, null];
    }
    this.#analysis ??= new this.#module.Analysis(
      session.basePositions(),
      session.faceOffsets(),
      session.faceVertices(),
      session.beforePlanarising(),
    );
    this.#analysis.show(session.moved(), session.movedPositions());
    return [this.#module, this.#analysis];
  }

  /** Without it there are no tables; the next question tries again. */
  async #load(): Promise<void> {
    if (this.#loading) return;
    this.#loading = true;
    try {
      this.#module = await load();
      this.#arrived();
    } catch {
      this.#module = null;
    }
    this.#loading = false;
  }
}
