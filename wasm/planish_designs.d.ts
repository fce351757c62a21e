// SPDX-License-Identifier: MIT
// Designs and their options as design_values.cpp writes and reads them, by hand: types alone.

import type { EditValues } from "./package/src/edit-values.ts";
import type { MeshFormat } from "./package/src/mesh-format.ts";

export type { MeshFormat };

/** An option of an edit, once for every language: the core's table of them. */
export interface EditOptionRow {
  /** In designs and messages. */
  readonly name: string;
  /** In EditOptions. */
  readonly key: keyof EditOptions;
  readonly usual: EditOptions[keyof EditOptions];
  /** Of an option that is one of a few. */
  readonly words: readonly string[] | null;
}

/** What holds where nobody says otherwise. */
export interface Defaults {
  readonly options: readonly EditOptionRow[];
  readonly fairFlat: Planarising;
  /** What links and designs mean that only say that a mesh was planarised. */
  readonly nearestFlat: Planarising;
  /** Degrees, by the name of each kind that can be kept beside planarity. */
  readonly kinds: Readonly<Record<string, number>>;
  readonly variationWeights: VariationWeights;
  /** Degrees: a panel with a sharper corner is a sliver. */
  readonly sliverAngle: number;
  /** What panel_damage() says of a panel that became one. */
  readonly newSliver: number;
  /** The limit on corners with which panels can be built. */
  readonly buildableCorners: string;
  /** Of every format of meshes the media type of its files. */
  readonly formats: Readonly<Record<MeshFormat, string>>;
  /** Of its way: as near to its target a handle meets it. */
  readonly metShare: number;
  /** Of its way: a handle that stops short by less is not said to. */
  readonly noticeableShare: number;
  /** Degrees by which folds may sharpen, of an edit that nobody gave a limit. */
  readonly fairFolds: readonly number[];
  /** zlib's preset dictionary of links "#v2=": ASCII. */
  readonly linkDictionary: string;
}

/** Opaque enumerator: how an edit is computed. */
export interface EnumValue {
  readonly value: number;
}

/** The core's HandleEditOptions: those of EditValues, and those that are asked for in other ways. */
export interface EditOptions extends EditValues {
  /** Targets are met exactly, or the edit is refused. */
  readonly hardHandles: boolean;
  readonly engine: "newton" | "alm";
  /** 0: the engine's own limit. */
  readonly maxIterations: number;
  /** No panel becomes concave, crossing, turned over or collapsed that was not. */
  readonly keepShape: boolean;
  /** Face rings around the handles that may move; 0: no limit. */
  readonly reach: number;
  /** How far from a handle points may move, model units; 0: no limit. */
  readonly reachLength: number;
  /** Panels that move stay as bent as they are: none bends more. `tolerance` is the most that the base may be bent. */
  readonly keepBends: boolean;
  /** Kept beside planarity, with tolerances in degrees: "circular:1e-9". See design/kept-kind.ts. */
  readonly constraints: readonly string[];
  /** As --bound says them: "fold=25"; degrees and model units. See design/stated-limit.ts. */
  readonly limits: readonly string[];
  /** Kept from every one of `keepOuts`, model units. */
  readonly clearance: number;
}

/** How an opened mesh is made flat. */
export interface Planarising {
  /** Weight of fairness, at least 0; 0: the nearest flat mesh. */
  readonly smooth: number;
  readonly keepBoundary: boolean;
  /** No panel becomes concave, crossing, turned over or collapsed that was not. */
  readonly keepShape: boolean;
  /** What it becomes beside flat, as EditOptions has them. */
  readonly constraints: readonly string[];
  /** No point moves farther, model units; 0: any distance. */
  readonly within: number;
  /** mm/m: panels may stay that far out of flat; 0: exactly flat. */
  readonly flat: number;
}

/** Enough of a result to recognise it, or to say how far another one is from it. */
export interface ResultMark {
  /** CRC-32 of the moved indices and their coordinates, bit by bit. */
  readonly hash: number;
  readonly moved: number;
  /** A few moved vertices and where they went, model units: vertex, x, y, z for each. */
  readonly probes: readonly number[];
}

export type DesignSource =
  | { readonly sample: string; readonly size: number }
  /** `hash`: of the base that was edited, null where it is not known; no `bytes`: they lie beside it. */
  | {
      readonly file: string;
      readonly hash: number | null;
      readonly format: string;
      readonly bytes: Uint8Array;
    };

/** The core's SubspaceOptions beside the dimension and the order. */
export interface VariationWeights {
  /** β_f; higher: smoother, wider variations. */
  readonly fairness: number;
  /** β_s; higher: fewer points each. */
  readonly sparsity: number;
  /** β_h; higher: the handles stay put. */
  readonly closeness: number;
  /** β_c as a share of its bound, in [0, 1); higher: nearer to the edit. */
  readonly correlation: number;
  /** Face rings around the edit that they may use. */
  readonly spread: number;
  /** How many the smoothest are chosen from; 0: no more than are asked for. */
  readonly family: number;
}

export interface VariationFamily {
  /** How many directions were asked for; fewer may have been found. */
  readonly asked: number;
  /** Ordered by stiffness instead of by how local they are. */
  readonly eigenbasis: boolean;
  /** Absent: Defaults.variationWeights. */
  readonly weights?: VariationWeights;
}

/** A family of variations and the member that was chosen. */
export interface DesignVariation extends VariationFamily {
  /** One per slider; 1 moves some point as far as the edit's own largest move. */
  readonly coefficients: readonly number[];
}

/** The core's Design. */
export interface DesignValue {
  readonly source: DesignSource;
  readonly planarised: Planarising | null;
  readonly unit: string;
  /** Vertex, x, y, z for each. */
  readonly handles: readonly number[];
  readonly pins: readonly number[];
  /** As --support says them. */
  readonly supports: readonly string[];
  readonly continuation: number;
  /** As --symmetry says it, one each. */
  readonly symmetry: readonly string[];
  /** Made before the edit, as --cut says them. */
  readonly cuts: readonly string[];
  readonly options: EditOptions;
  readonly variations: readonly DesignVariation[];
  readonly result: ResultMark | null;
}

/** `plain`: exact, and without what only the command line can set. */
export interface ReadDesignValue extends DesignValue {
  readonly variations: readonly (DesignVariation & { readonly plain: boolean })[];
}

/** With `problem` not empty, the text was refused. */
export interface DesignReading {
  readonly problem: string;
  readonly design?: ReadDesignValue;
}
