// SPDX-License-Identifier: MIT
// What autosave keeps of one tab. Files are kept beside it, and so are the steps of its history; the record
// names them.

import type { Unit } from "../quantity/units.ts";
import type { Camera, NamedView } from "./camera.ts";
import type { Design } from "./design.ts";
import type { Group } from "./groups.ts";
import type { SectionPlane } from "./section-plane.ts";

/** Keys, oldest first: of the steps before the design, and of those that were undone. */
export interface StepKeys {
  readonly past: readonly string[];
  readonly future: readonly string[];
}

export interface Snapshot {
  readonly id: string;
  readonly name: string;
  /** Milliseconds since 1970. */
  readonly time: number;
  /** A data: address of a small picture; "" for none. */
  readonly picture: string;
  readonly design: Design;
}

export interface SavedRecord {
  /** Milliseconds since 1970. */
  readonly time: number;
  readonly unit: Unit;
  readonly camera: Camera | null;
  /** The paper's figure that the design began as, by its name; null if it is none. */
  readonly figure: string | null;
  readonly present: Design;
  readonly snapshots: readonly Snapshot[];
  readonly views: readonly NamedView[];
  /** What its author says of the design; "" for nothing. */
  readonly note: string;
  /** What cuts the view open; null for nothing. */
  readonly section: SectionPlane | null;
  /** Made or changed here, of the present mesh; null for those of its file. */
  readonly groups: readonly Group[] | null;
  /** Undo and redo. */
  readonly steps: StepKeys;
}

export type ReadRecord =
  | { readonly kind: "record"; readonly record: SavedRecord }
  | { readonly kind: "newer" }
  | { readonly kind: "damaged" };
