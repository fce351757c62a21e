// SPDX-License-Identifier: MIT
// What is measured on a finished design.

import { newSliver } from "virtual:core-defaults";
import type { Analysis, PlanishModule, Session } from "@wasm/planish.mjs";
import type {
  AlsoMeasured,
  Fairness,
  FreedomReport,
  PanelMeasures,
  Shape,
  Targets,
} from "./protocol.ts";

/** What sliders do to an edit. */
export interface ShapeFamily {
  readonly centre: Shape;
  /** Vertices, ascending. */
  readonly support: Int32Array;
  /** x, y, z of each of them at value 1, slider by slider. */
  readonly moves: Float64Array;
}

/** Measures what one session shows. */
export class DesignAnalysis {
  readonly #module: PlanishModule;
  readonly #session: Session;
  #analysis: Analysis | null = null;
  /** The family that it knows. */
  #family: ShapeFamily | null = null;

  constructor(module: PlanishModule, session: Session) {
    this.#module = module;
    this.#session = session;
  }

  /** The session has another base now. */
  forget(): void {
    this.#analysis?.delete();
    this.#analysis = null;
    this.#family = null;
  }

  panels(also: AlsoMeasured): PanelMeasures {
    return this.#measures(this.#current(), also);
  }

  #measures(analysis: Analysis, { fairness, folds, defectsOf }: AlsoMeasured): PanelMeasures {
    return {
      figures: analysis.panelFigures(),
      health: analysis.panelHealth(),
      nodes: analysis.nodesToRemake(),
      damage: analysis.panelDamage(),
      folds: folds ? analysis.panelFolds() : null,
      bending: fairness ? analysis.vertexBending(this.#module.FairnessKind[fairness]) : null,
      defects: defectsOf ? analysis.defects(defectsOf) : null,
    };
  }

  /** How many panels became slivers. */
  slivers(): number {
    return this.#current()
      .panelDamage()
      .reduce((count, kind) => count + (kind === newSliver ? 1 : 0), 0);
  }

  /** Measures a shape that need not be shown; how it bends, by `fairness` if that is given. */
  measure({ moved, positions }: Shape, fairness?: Fairness): PanelMeasures {
    const analysis = this.#current();
    analysis.show(moved, positions);
    return this.#measures(analysis, { fairness: fairness ?? null, folds: true, defectsOf: null });
  }

  /** Stops of each slider of a family, the others where they are: lower stop, its panel, upper stop, its panel. */
  stops(family: ShapeFamily, values: readonly number[]): Float64Array {
    const analysis = this.#current();
    if (this.#family !== family) {
      const { centre, support, moves } = family;
      analysis.setFamily(centre.moved, centre.positions, support, moves);
      this.#family = family;
    }
    return analysis.sliderStops(Float64Array.from(values));
  }

  freedom({ handles, pins }: Targets): FreedomReport | null {
    return this.#current().freedom(Float64Array.from(handles), Int32Array.from(pins));
  }

  /** The analysis of what the session shows now. */
  #current(): Analysis {
    const session = this.#session;
    this.#analysis ??= new this.#module.Analysis(
      session.basePositions(),
      session.faceOffsets(),
      session.faceVertices(),
      session.beforePlanarising(),
    );
    this.#analysis.show(session.moved(), session.movedPositions());
    return this.#analysis;
  }
}
