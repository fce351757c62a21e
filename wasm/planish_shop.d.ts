// SPDX-License-Identifier: MIT
// What shop_bindings.cpp and shop_preview_bindings.cpp list, by hand.

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
  /** 0: by the size of the panel. */
  readonly textHeight: number;
  /** Draws only what must be made again. */
  readonly remakeOnly: boolean;
  /** Draws these panels only; empty: no such limit. */
  readonly panels: readonly number[];
}

/** The core's LinkCode. */
export interface LinkCode {
  readonly link: string;
  /** 0: no code. */
  readonly size: number;
  /** size² numbers, 1 for black. */
  readonly dark: readonly number[];
}

/** The core's DrawingOptions. */
export interface DrawingOptions {
  readonly name: string;
  readonly modelUnit: string;
  readonly unit: string;
  /** 0: the first usual one that fits A3. */
  readonly scale: number;
  /** a, b, c, d of each plane a·x + b·y + c·z = d, (a, b, c) of length 1; model units. */
  readonly sections: readonly number[];
}

/** A design against `base`; `moved`: the vertices that lie elsewhere, with their positions. */
export interface ShopDesign {
  readonly base: Float64Array;
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
  readonly moved: Int32Array;
  readonly movedPositions: Float64Array;
}

export type ShopOrder =
  | { readonly what: "package"; readonly options: CuttingOptions; readonly code: LinkCode }
  | { readonly what: "ifc"; readonly options: CuttingOptions }
  | { readonly what: "drawings"; readonly options: DrawingOptions };

/** With `problem` not empty the rest is absent. */
export interface Written {
  readonly problem: string;
  readonly bytes: Uint8Array;
  /** JSON: package.json without its tables, the same of an IFC model, or drawings.json. */
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
  /** Nodes to be made again: they moved, or only their axis or an arm turned. */
  readonly nodesMoved: number;
  readonly nodesArms: number;
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
  write(design: ShopDesign, order: ShopOrder): Written;
  /** `face`: the panel to draw if it is in the scope, else the first that is. */
  cuttingPreview(
    design: ShopDesign,
    options: CuttingOptions,
    face: number,
    map: boolean,
  ): CuttingPreview;
  panelRows(design: ShopDesign, options: CuttingOptions): PanelRows;
}

export default function createPlanishShop(options?: object): Promise<ShopModule>;
