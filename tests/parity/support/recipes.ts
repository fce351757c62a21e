// SPDX-License-Identifier: MIT
// Designs to be made by every build and compared to the last bit.
import type { EditOptions, PlanishModule } from "@wasm/planish.mjs";

export interface Recipe {
  readonly name: string;
  /** A sample, or the text of an OBJ file that is planarised first. */
  readonly source: { readonly sample: string; readonly size: number } | { readonly obj: string };
  /** Point, x, y, z each. */
  readonly handles: readonly (readonly [number, number, number, number])[];
  readonly pins: readonly number[];
  readonly options: {
    readonly fairness: "laplacian" | "second" | "third";
    readonly sparsity: "l21" | "l2" | "none";
    readonly solver: "newton" | "alm";
    readonly hard: boolean;
    readonly shape?: boolean;
  };
  /** Slider values; absent: no variation. */
  readonly coefficients?: readonly number[];
}

/**
 * The design as the page makes it, as OBJ: seventeen digits, so equal texts are equal bits. Refers to
 * nothing outside itself: its source also runs in a worker.
 */
export function makeDesign(module: PlanishModule, recipe: Recipe, usual: EditOptions): string {
  const done = (refusal: string): void => {
    if (refusal !== "") throw new Error(`${recipe.name}: ${refusal}`);
  };
  const { source, options } = recipe;
  const session = new module.Session();
  if ("obj" in source) {
    done(session.openFile(new TextEncoder().encode(source.obj), "obj"));
    done(
      session.planarise({
        smooth: 10,
        keepBoundary: false,
        keepShape: true,
        constraints: [],
        within: 0,
        flat: 0,
      }),
    );
  } else {
    done(session.openSample(source.sample, source.size));
  }
  done(
    session.setOptions({
      ...usual,
      fairness: options.fairness,
      sparsity: options.sparsity,
      hardHandles: options.hard,
      keepShape: options.shape ?? false,
      engine: options.solver,
    }),
  );
  const handles = Float64Array.from(recipe.handles.flat());
  done(session.edit(module.EditMode.solve, handles, Int32Array.from(recipe.pins), 0, 1));
  if (recipe.coefficients) {
    done(session.explore({ asked: recipe.coefficients.length, eigenbasis: false }));
    done(session.vary(Float64Array.from(recipe.coefficients)));
    done(session.makeExact());
  }
  const text = new TextDecoder().decode(session.write("obj"));
  session.delete();
  return text;
}

/** The same as a saved design, for the command line. */
export function designText(recipe: Recipe): string {
  const { source, options, coefficients } = recipe;
  const file = "obj" in source;
  return JSON.stringify({
    format: "planish-design",
    version: 1,
    source: file ? { file: "given.obj", format: "obj", bytes: btoa(source.obj) } : source,
    planarised: file && { smooth: 10, keep_boundary: false, shape: true },
    handles: recipe.handles,
    pins: recipe.pins,
    options,
    variations: coefficients ? [{ dimension: coefficients.length, coefficients }] : [],
  });
}
