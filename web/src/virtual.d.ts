// SPDX-License-Identifier: MIT
declare module "virtual:first-mesh" {
  const mesh: {
    readonly positions: readonly number[];
    readonly offsets: readonly number[];
    readonly vertices: readonly number[];
  };
  export default mesh;
}

declare module "rhino3dm/rhino3dm.module.js" {
  export { default } from "rhino3dm";
}

declare module "virtual:core-defaults" {
  import type { Defaults, EditOptions } from "@wasm/planish.mjs";
  /** The command line's defaults. */
  export const usual: EditOptions;
  /** The words of options that are one of a few. */
  export const words: {
    readonly [Key in "fairness" | "sparsity" | "engine"]: readonly EditOptions[Key][];
  };
  export const fairFlat: Defaults["fairFlat"];
  export const nearestFlat: Defaults["nearestFlat"];
  export const kinds: Defaults["kinds"];
  export const variationWeights: Defaults["variationWeights"];
  export const sliverAngle: Defaults["sliverAngle"];
  export const newSliver: Defaults["newSliver"];
  export const buildableCorners: Defaults["buildableCorners"];
  export const formats: Defaults["formats"];
  export const metShare: Defaults["metShare"];
  export const noticeableShare: Defaults["noticeableShare"];
  export const fairFolds: Defaults["fairFolds"];
  export const linkDictionary: Defaults["linkDictionary"];
}
