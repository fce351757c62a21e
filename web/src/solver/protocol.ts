// SPDX-License-Identifier: MIT
// What the page and the solver worker say to each other. Every request carries a job number;
// every request but `start` gets exactly one reply with that number, `failed` if nothing changed.
// Progress messages (`progress` in solver steps, of many a few; `reading` in bytes; `standing`) may come before the reply.

import type * as Reports from "@wasm/planish.mjs";
import type { FreedomReport, NodeCounts } from "@wasm/planish.mjs";
import type {
  AlikeAsked,
  AlikeMesh,
  CuttingHeader,
  CuttingOptions,
  CuttingPreview,
  DrawnHeader,
  MeshOffset,
  OffsetKind,
  PanelTypes,
  ShopOrder,
} from "@wasm/planish_documents.mjs";
import type { DisplayMesh } from "../mesh/display-mesh.ts";
import type { UpAxis } from "../mesh/up-axis.ts";
import type { Unit } from "../quantity/units.ts";
import type { Context } from "../rhino/context.ts";
import type { WrittenModel } from "../rhino/write-model.ts";
import type {
  EditMode,
  EditSettings,
  Fairness,
  HandleList,
  PullLimit,
  SoughtLimits,
  Targets,
} from "./edit-asked.ts";
import type { FileFormat } from "./file-formats.ts";

export type {
  CutTrial,
  DesignReading,
  DesignValue,
  DesignVariation,
  FewestFound,
  FreedomReport,
  KindDefects,
  MeshReport,
  NodeCounts,
  Optimality,
  Planarising,
  ResultMark,
  SplitFinding,
  SplitStanding,
  VariationFamily,
  VariationsReport,
  VariationWeights,
} from "@wasm/planish.mjs";
export type {
  AlikeMesh,
  CuttingHeader,
  CuttingOptions,
  CuttingPreview,
  DrawingOptions,
  DrawnHeader,
  LinkCode,
  MeshOffset,
  OffsetKind,
  PanelTypes,
  ShopOrder,
} from "@wasm/planish_documents.mjs";
export type * from "./edit-asked.ts";

/** Under which edits of a mesh have images, and how flat its evened base has to be, mm/m. */
export interface Symmetry {
  readonly elements: readonly string[];
  readonly tolerance: number;
}

/** A finished design: where it differs from its base, in float64. */
export interface Shape {
  readonly moved: Int32Array;
  readonly positions: Float64Array;
}

export type Source =
  | { readonly kind: "sample"; readonly name: string; readonly size: number }
  | {
      readonly kind: "file";
      readonly name: string;
      readonly format: FileFormat;
      /** The page's own copy, outside its heap: the file on disk may change or go. */
      readonly bytes: Blob;
      /** CRC-32 of `bytes`. */
      readonly crc: number;
    };

/** Triangles become quads, points of one place one, panels face one way. */
export type Mending = "joinTriangles" | "joinPoints" | "orient";

export type Request =
  /** The worker holds the lock named `alive` for as long as it lives. */
  | { kind: "start"; job: 0; compiled: WebAssembly.Module; alive: string }
  | {
      kind: "open";
      job: number;
      source: Source;
      planarise: Reports.Planarising | null;
      /** Where that is known to put the points, and more behind them: nothing is solved for it. */
      found?: Float64Array;
      symmetry: Symmetry | null;
      cuts: readonly string[];
    } // → opened
  /** Instead of the cuts of the mesh that is open; refused, it has those that it had. */
  | { kind: "cut"; job: number; cuts: readonly string[]; tolerance: number } // → opened
  /** One cut more of the mesh that is open, which is not made. */
  | { kind: "tryCut"; job: number; cut: string; tolerance: number } // → tried
  /** What splitting `most` panels at most lets the handles do; the design shown stays. */
  | { kind: "splitEdit"; job: number; targets: Targets; settings: EditSettings; most: number } // → split
  /** Makes the mesh that is open flat, with `most` panels split at most. */
  | { kind: "splitMesh"; job: number; how: Reports.Planarising; most: number } // → hybrid
  /** A file of the user's, read for the first time. */
  | { kind: "read"; job: number; file: Blob; name: string; format: FileFormat } // → opened
  /** The mesh shown, mended in one of these ways, as a file of this name. */
  | { kind: "join"; job: number; name: string; way: Mending } // → opened
  /** The design shown with more of its panels alike; it stays. */
  | { kind: "alike"; job: number; asked: AlikeAsked } // → alike
  /** The mesh shown, which was turned for another axis to go up, as a file of this name. */
  | { kind: "turn"; job: number; name: string; from: UpAxis; to: UpAxis } // → opened
  /** `found`: the flat mesh, where another worker made it so already. */
  | {
      kind: "planarise";
      job: number;
      how: Reports.Planarising;
      found: Float64Array | null;
    } // → opened
  | {
      kind: "edit";
      job: number;
      mode: EditMode;
      targets: Targets;
      settings: EditSettings;
      budget: number;
      /** Holds the handles back to where they get within it; null: no limit of a drag. */
      limit: PullLimit | null;
      /** Tried in this order in place of that of the settings, see reach-steps.ts; empty: only that. */
      reaches: readonly number[];
      /** Limits that are looked for, see found-limits.ts; null: none. */
      sought: SoughtLimits | null;
    } // → shown
  /** The edit that makes few panels again, at once. `withinHandle`: of the longest way of a handle, so
   * near to their targets handles have arrived; `mostPanels`: enough of them, 0 for as few as can be. */
  | {
      kind: "fewest";
      job: number;
      targets: Targets;
      settings: EditSettings;
      withinHandle: number;
      mostPanels: number;
    } // → fewest
  /** `keep`: the design is one of the family that was found last, or its centre. */
  | {
      kind: "restore";
      job: number;
      targets: Targets;
      settings: EditSettings;
      shape: Shape;
      keep: boolean;
    } // → shown
  | { kind: "explore"; job: number; family: Reports.VariationFamily } // → explored
  | { kind: "vary"; job: number; coefficients: readonly number[] } // → shown
  /** Where the sliders of the family found last stop, standing at these values. */
  | { kind: "stops"; job: number; coefficients: readonly number[] } // → stops
  | { kind: "exact"; job: number } // → shown
  /** What `vary` and then `exact` would give; the design shown stays. */
  | { kind: "project"; job: number; coefficients: readonly number[] } // → projected
  | { kind: "panels"; job: number; also: AlsoMeasured } // → panels
  /** Measures any shape of the mesh that is open, with folds, and how it bends by `fairness`; the design
   * shown stays. */
  | { kind: "measure"; job: number; shape: Shape; fairness?: Fairness } // → panels
  | { kind: "freedom"; job: number; targets: Targets } // → freedom
  /** Does a design again on the mesh that is open. */
  | { kind: "replay"; job: number; design: Reports.DesignValue } // → replayed
  | { kind: "mark"; job: number; shape: Shape } // → marked
  | { kind: "readDesign"; job: number; text: string } // → design
  /** `groups`: runs of faces that an OBJ names; null for those of the file. */
  | {
      kind: "export";
      job: number;
      format: Exclude<FileFormat, "glb">;
      design: null;
      groups: string | null;
    } // → exported
  /** `design`: of the mesh that is open, whose hash is added; "link" is its JSON, too, with the mesh's
   * file as text. `offset`: the points of a second layer that a GLB shows beside it. */
  | {
      kind: "export";
      job: number;
      format: "glb" | "json" | "link";
      design: Reports.DesignValue;
      offset: Float64Array | null;
    } // → exported
  /** The design shown at a distance, model units. `form`: "" for the first that it has. */
  | { kind: "offset"; job: number; distance: number; form: OffsetKind | "" } // → offset
  | { kind: "shop"; job: number; order: ShopOrder } // → made
  /** What a package would hold. `face`: the panel to draw; `map`: whether the map is wanted. */
  | { kind: "preview"; job: number; options: CuttingOptions; face: number; map: boolean } // → previewed
  /** Which panels are alike, see PanelTypes, of a shape of the mesh that is open; null: of the design
   * shown. */
  | { kind: "types"; job: number; share: number; mirrored: boolean; shape: Shape | null } // → types
  /** A mesh beside the one that is open, which stays. */
  | { kind: "readModel"; job: number; file: Blob; name: string; format: FileFormat } // → readModel
  /** What a .3dm holds; the mesh that is open stays. */
  | { kind: "unpack"; job: number; file: Blob; name: string } // → unpacked
  /** The design shown as a .3dm. `design`: of the mesh that is open, whose hash is added. */
  | { kind: "model"; job: number; unit: Unit; design: Reports.DesignValue }; // → modelled

/** The core's ShapeReport; less of it in records from before there was more. */
export type ShapeReport = Omit<Reports.ShapeReport, Younger> &
  Partial<Pick<Reports.ShapeReport, Exclude<Younger, "sharpestFold">>> & {
    readonly sharpestFold: SharpestFold | null;
  };
type Younger = "sharpestFold" | "motion" | "continuation" | "lowerAtOnce" | "bounds" | "violations";

/** `panels`, `growth`: absent where nobody measured them. */
export type SharpestFold = Omit<Reports.SharpestFold, "panels" | "growth"> &
  Partial<Pick<Reports.SharpestFold, "panels" | "growth">>;

/** Numbers per panel in PanelMeasures. */
export const PER_PANEL = { figures: 3, health: 4 } as const;

/** What is measured only while someone looks. */
export interface AlsoMeasured {
  /** How sharply the edit bends at each point, by this operator. */
  readonly fairness: Fairness | null;
  readonly folds: boolean;
  /** How far panels or points are from the kind of this name. */
  readonly defectsOf: string | null;
}

/** What is measured on a finished design. */
export interface PanelMeasures {
  /** Gap in model units, mm/m, and mm/m or 0 where rounding accounts for it, for every panel. */
  readonly figures: Float32Array;
  /** Outline, shortest edge, smallest angle and the core's PanelChange, for every panel. */
  readonly health: Float32Array;
  /** Nodes to make again against the base. */
  readonly nodes: NodeCounts;
  /** What became of every panel since the mesh was opened: a place in DAMAGES. */
  readonly damage: Uint8Array;
  /** The sharpest fold of every panel with a neighbour, degrees; null if not asked for. */
  readonly folds: Float32Array | null;
  /** How sharply the edit bends at every vertex, model units; null if not asked for. */
  readonly bending: Float32Array | null;
  /** How far every panel or vertex is from a kind, degrees, -1 if free of it; null if not asked for. */
  readonly defects: Float32Array | null;
}

/** What a slider does at value 1. */
export interface SliderLead {
  /** The point that it moves most, and that point's move, model units. */
  readonly vertex: number;
  readonly move: readonly [number, number, number];
  /** How many points it moves. */
  readonly points: number;
}

/** Where a slider stops because a panel would lose its shape; ±∞ and −1 where none would. */
export interface SliderRange {
  readonly lower: number;
  readonly lowerPanel: number;
  readonly upper: number;
  readonly upperPanel: number;
}

/** The base mesh as the worker read it. Display coordinates are (p − centre) · scale. */
export interface OpenedMesh extends DisplayMesh {
  /** Runs of faces that its file names: see Session.groups. */
  readonly groups: string;
  /** Of every panel which of the mesh before its cuts; empty without any. */
  readonly parents: Int32Array;
  readonly report: Reports.MeshReport;
  readonly positions: Float64Array;
  /** Under which its edits have images; null without one. */
  readonly symmetry: Reports.MeshSymmetry | null;
}

/** Panels of another model. */
export interface Model {
  /** x, y, z of every point, model units. */
  readonly points: Float64Array;
  /** Where the points of every panel begin in `vertices`, and their end. */
  readonly offsets: Int32Array;
  readonly vertices: Int32Array;
}

/** What a GLB held beside its mesh. */
export interface StoredDesign {
  /** The recipe; null for none. */
  readonly design: Reports.DesignReading | null;
  /** The stored result; empty without a recipe. */
  readonly shape: Shape;
  readonly warnings: readonly string[];
}

export type Reply =
  | { kind: "ready"; job: 0 }
  | { kind: "progress"; job: number; step: number; residual: number }
  | { kind: "reading"; job: number; done: number; total: number }
  /** `source`: the copy to keep of a file that was read; `stored`: what came with a GLB. */
  | {
      kind: "opened";
      job: number;
      source: Source | null;
      mesh: OpenedMesh;
      stored: StoredDesign | null;
    }
  /**
   * `changes`: vertex, x, y, z in display coordinates. `shape` is absent during a drag. `taken`: the
   * handles that were edited, where a limit held them back; null: those that were asked for.
   * `found`: limits that the edit has beside those asked for. `reach`: of those tried; null: that asked for.
   */
  | {
      kind: "shown";
      job: number;
      changes: Float32Array;
      report: ShapeReport;
      shape: Shape | null;
      taken: HandleList | null;
      found: readonly string[];
      reach: number | null;
      /** The handles, where some are on a mirror plane or an axis and were to leave it; else null. */
      placed: HandleList | null;
    }
  /**
   * `directions`: found for each variation; `centre`: what the last was found around; `leads`:
   * of its sliders; `deviation`: from the recorded result, model units.
   */
  | {
      kind: "replayed";
      job: number;
      changes: Float32Array;
      report: ShapeReport;
      shape: Shape;
      directions: readonly number[];
      centre: Shape;
      leads: readonly SliderLead[];
      deviation: number;
    }
  | { kind: "fewest"; job: number; shape: Shape; report: ShapeReport; found: Reports.FewestFound }
  | { kind: "alike"; job: number; made: AlikeMesh }
  | { kind: "tried"; job: number; trial: Reports.CutTrial }
  /** On the way to `split`: the best with so many lines so far. */
  | { kind: "standing"; job: number; standing: Reports.SplitStanding }
  | { kind: "split"; job: number; finding: Reports.SplitFinding }
  /** `panels`: how many are split; `file`: the mesh as OBJ, every bit of it. */
  | { kind: "hybrid"; job: number; mesh: OpenedMesh; panels: number; file: Uint8Array }
  | { kind: "marked"; job: number; mark: Reports.ResultMark }
  | { kind: "design"; job: number; reading: Reports.DesignReading }
  | {
      kind: "explored";
      job: number;
      report: Reports.VariationsReport;
      leads: readonly SliderLead[];
    }
  /** null before anything was explored. */
  | { kind: "stops"; job: number; ranges: readonly SliderRange[] | null }
  | { kind: "projected"; job: number; shape: Shape; report: ShapeReport }
  | { kind: "panels"; job: number; measures: PanelMeasures }
  /** null where too many points move to count. */
  | { kind: "freedom"; job: number; freedom: FreedomReport | null }
  | { kind: "exported"; job: number; bytes: Uint8Array }
  | { kind: "made"; job: number; file: Blob; header: CuttingHeader | DrawnHeader }
  | { kind: "types"; job: number; types: PanelTypes }
  | { kind: "previewed"; job: number; preview: CuttingPreview }
  | { kind: "offset"; job: number; offset: MeshOffset }
  | { kind: "readModel"; job: number; model: Model }
  | { kind: "unpacked"; job: number; model: OpenedModel }
  | { kind: "modelled"; job: number; model: WrittenModel }
  /** `fatal`: the session cannot be trusted any more and the worker must be replaced. */
  | { kind: "failed"; job: number; message: string; fatal: boolean };

/** What a Rhino model held. */
export interface OpenedModel {
  /** OBJ; of no use where there is a design. */
  readonly mesh: Uint8Array;
  /** "" for none. */
  readonly design: string;
  readonly unit: Unit | null;
  readonly context: Context | null;
  readonly remarks: readonly string[];
}
