// SPDX-License-Identifier: MIT
// What an edit is asked for and a design says by the same name with the same values. The page's types of
// designs (wasm/planish_designs.d.ts) take these from here, too.

/** Options of an edit, each with the value that holds if it is left out. */
export interface EditValues {
  /** Where nothing may go: "below=0", "plane=0,0,1,4", "box=0,0,2,1,1,3", ...; model units. */
  readonly keepOuts: readonly string[];
  readonly locality: number;
  readonly smoothness: number;
  /** 1 to 10: in place of locality and smoothness; 0: these two hold. */
  readonly softness: number;
  /** Points on a boundary stay, handles excepted. */
  readonly keepBoundary: boolean;
  readonly attraction: number;
  readonly fairness: "laplacian" | "second" | "third";
  readonly sparsity: "l21" | "l2" | "none";
  /** Worst panel of a finished edit, mm per m. */
  readonly tolerance: number;
}
