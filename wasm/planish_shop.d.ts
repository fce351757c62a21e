// SPDX-License-Identifier: MIT
// What shop_bindings.cpp lists, by hand.

/** The core's CuttingOptions; lengths in `unit`. */
export interface CuttingOptions {
  readonly name: string;
  readonly modelUnit: string;
  readonly unit: string;
  readonly gap: number;
  /** 0: not known. */
  readonly thickness: number;
  /** Both 0: no sheets. */
  readonly sheetWidth: number;
  readonly sheetHeight: number;
  /** Draws only what must be made again. */
  readonly remakeOnly: boolean;
}

/** With `problem` not empty the rest is absent. */
export interface WrittenPackage {
  readonly problem: string;
  readonly zip: Uint8Array;
  /** package.json without its tables. */
  readonly header: string;
}

/** What a package would hold; with `problem` not empty the rest is absent. */
export interface CuttingPreview {
  /** A clause, not a sentence: "gap must be at least 0". */
  readonly problem: string;
  readonly panels: number;
  readonly drawn: number;
  /** To be made again against the base; `bevel` of them with the same outline. */
  readonly outline: number;
  readonly bevel: number;
  /** Of the worst panel, mm/m. */
  readonly flatness: number;
  readonly vanished: readonly string[];
  readonly oversize: readonly string[];
  readonly sheets: number;
  readonly usedFraction: number;
  /** SVG; "" if it was not wanted. */
  readonly map: string;
  /** The panel in `drawing`; "" if none is drawn. */
  readonly shown: string;
  /** SVG. */
  readonly drawing: string;
}

/** panels.csv; absent with `problem` not empty. */
export interface PanelRows {
  readonly problem: string;
  readonly csv: string;
}

export interface ShopModule {
  /** Against `base`; `moved`: the vertices that lie elsewhere, with their positions. */
  cuttingPackage(
    base: Float64Array,
    offsets: Int32Array,
    vertices: Int32Array,
    moved: Int32Array,
    movedPositions: Float64Array,
    options: CuttingOptions,
  ): WrittenPackage;
  /** `face`: the panel to draw if it is in the scope, else the first that is. */
  cuttingPreview(
    base: Float64Array,
    offsets: Int32Array,
    vertices: Int32Array,
    moved: Int32Array,
    movedPositions: Float64Array,
    options: CuttingOptions,
    face: number,
    map: boolean,
  ): CuttingPreview;
  panelRows(
    base: Float64Array,
    offsets: Int32Array,
    vertices: Int32Array,
    moved: Int32Array,
    movedPositions: Float64Array,
    options: CuttingOptions,
  ): PanelRows;
}

export default function createPlanishShop(options?: object): Promise<ShopModule>;
