// SPDX-License-Identifier: MIT
// What shop_bindings.cpp, shop_preview_bindings.cpp and offset_bindings.cpp list, by hand.

/** The core's CuttingOptions; lengths in `unit`. */
export interface CuttingOptions {
  readonly name: string;
  readonly modelUnit: string;
  readonly unit: string;
  readonly gap: number;
  /** 0: not known. */
  readonly thickness: number;
  /** The size of a sheet; both 0: no sheets. */
  readonly sheetWidth: number;
  readonly sheetHeight: number;
  /** 0: by the size of the panel. */
  readonly textHeight: number;
  /** By how much the joint may be wider or narrower where one template a type is cut; 0: no types. */
  readonly jointBy: number;
  /** A panel may be its template turned over. */
  readonly mirrored: boolean;
  /** One drawing a type; needs jointBy. */
  readonly byType: boolean;
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
  /** As --axis says them, model units: "x=4.5:A". */
  readonly axes: readonly string[];
}

/** A design against `base`; `moved`: the vertices that lie elsewhere, with their positions. */
export interface ShopDesign {
  readonly base: Float64Array;
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
  readonly moved: Int32Array;
  readonly movedPositions: Float64Array;
  /** See Session.panelParents. */
  readonly parents: Int32Array;
}

export type ShopOrder =
  | { readonly what: "package"; readonly options: CuttingOptions; readonly code: LinkCode }
  | { readonly what: "ifc"; readonly options: CuttingOptions }
  | { readonly what: "drawings"; readonly options: DrawingOptions };

/** A panel that the gap cuts into several pieces. */
export interface PanelApart {
  readonly panel: string;
  readonly pieces: number;
}

/** What of the header of a cutting package or an IFC model is read, see docs/fabrication.md. */
export interface CuttingHeader {
  readonly counts: { readonly panels: number; readonly drawn: number };
  readonly remake: {
    readonly outline: number;
    readonly bevel: number;
    readonly nodes_moved: number;
    readonly nodes_arms: number;
  } | null;
  readonly flatness_mm_per_m: number;
  /** That flatness, or 0 where rounding accounts for it. */
  readonly excess_mm_per_m: number;
  readonly vanished: readonly string[];
  /** Absent if there is none. */
  readonly apart?: readonly PanelApart[];
  /** Of which the gap takes whole sides; absent if there is none. */
  readonly lost_sides?: readonly string[];
  /** Absent where they were not asked for. */
  readonly types?: { readonly types: number };
  /** Of a package alone. */
  readonly sheets?: {
    readonly count: number;
    readonly used_fraction: number;
    readonly oversize: readonly string[];
  } | null;
  /** Of a package alone. */
  readonly labels?: { readonly link: string | null; readonly code: boolean };
}

/** Of drawings.json. */
export interface DrawnHeader {
  /** 1 : scale. */
  readonly scale: number;
  /** 1 : scale of each drawing. */
  readonly scales: readonly number[];
  /** Sections, from 0, that do not meet the structure. */
  readonly missed: readonly number[];
}

/** With `problem` not empty the rest is absent. */
export interface Written {
  readonly problem: string;
  /** Of package.json, the same of an IFC model, or of drawings.json. */
  readonly header: CuttingHeader | DrawnHeader;
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
  /** That flatness, or 0 where rounding accounts for it. */
  readonly excess: number;
  readonly vanished: readonly string[];
  readonly apart: readonly PanelApart[];
  readonly lostSides: readonly string[];
  readonly oversize: readonly string[];
  readonly sheets: number;
  readonly usedFraction: number;
  /** Of panels; 0 where they were not asked for. */
  readonly types: number;
  /** SVG; "" if it was not wanted. */
  readonly map: string;
  /** The panel or type in `drawing`; "" if none is drawn. */
  readonly shown: string;
  /** SVG. */
  readonly drawing: string;
}

/** What of the panels is alike; absent but for `problem` where that is not empty. */
export interface PanelTypes {
  readonly problem: string;
  /** The type of each panel, from 0: the one with most panels. */
  readonly ofPanel: Int32Array;
  /** Panels of each type. */
  readonly sizes: Int32Array;
  /** Model units: how far a corner is from its template's, at most and allowed. */
  readonly worstFit: number;
  readonly within: number;
}

/** panels.csv; absent with `problem` not empty. */
export interface PanelRows {
  readonly problem: string;
  readonly csv: string;
}

export type OffsetKind = "face" | "vertex" | "parallel";

interface Spread {
  readonly min: number;
  readonly mean: number;
  readonly max: number;
}

/** The core's MeshOffset, lengths in model units; with `problem` not empty the rest is absent. */
export interface MeshOffset {
  /** A clause: "point 955 misses being conical by 0.0134124 deg". */
  readonly problem: string;
  readonly kind: OffsetKind;
  /** Distances of the planes and of the points, positive outside. */
  readonly panels: Spread;
  readonly nodes: Spread;
  /** Of a plane's (face) or a point's (vertex) distance from the one asked for. */
  readonly deviation: number;
  /** Edges that run the other way: the distance is too large for them. */
  readonly turnedEdges: number;
  /** Panels that cross, turned over, collapsed or became concave. */
  readonly spoilt: number;
  /** Of the worst panel, mm/m, 0 where rounding accounts for it. */
  readonly excess: number;
  /** x, y, z of every vertex. */
  readonly positions: Float64Array;
}

export interface ShopModule {
  /** `kind`: "" for the first that the mesh has. */
  offsetMesh(design: ShopDesign, distance: number, kind: OffsetKind | ""): MeshOffset;
  /** `take` gets the file in pieces, each valid until it returns. */
  write(design: ShopDesign, order: ShopOrder, take: (piece: Uint8Array) => void): Written;
  /** `face`: the panel to draw if it is in the scope, else the first that is. */
  cuttingPreview(
    design: ShopDesign,
    options: CuttingOptions,
    face: number,
    map: boolean,
  ): CuttingPreview;
  /** `share` of the mean edge: how far a corner may be from its template's. */
  panelTypes(design: ShopDesign, share: number, mirrored: boolean): PanelTypes;
  panelRows(design: ShopDesign, options: CuttingOptions): PanelRows;
}
