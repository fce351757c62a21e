// SPDX-License-Identifier: MIT
// What making the opened mesh flat did to it, before any edit.

import { fairFlat, nearestFlat } from "virtual:core-defaults";
import { counted } from "../quantity/counted.ts";
import { formatLength, type Unit } from "../quantity/units.ts";
import type { MeshReport, OpenedMesh, PanelMeasures, Planarising } from "../solver/protocol.ts";

/** What links and designs mean that only say that a mesh was planarised. */
export const NEAREST_FLAT: Planarising = nearestFlat;

/** The command line's default. */
export const FAIR_FLAT: Planarising = fairFlat;

/** What a way to make a mesh flat gives, tried out. */
export interface Trial {
  readonly how: Planarising;
  /** Whether it is what there is near the file in place of what was asked for. */
  readonly instead: boolean;
  readonly mesh: OpenedMesh;
  /** null where it cannot be measured. */
  readonly measures: PanelMeasures | null;
  /** How many panels are split for it, and its mesh as a file; null where none may be. */
  readonly split: { readonly panels: number; readonly file: Uint8Array } | null;
}

export type Preview =
  | { readonly kind: "none" }
  | {
      readonly kind: "running";
      /** null where it is refused, overtaken or given up. */
      readonly done: Promise<Trial | null>;
      readonly giveUp: () => void;
      /** Steps of the solver so far. */
      readonly step: number;
      /** What there is near the file, shown meanwhile. */
      readonly near: Trial | null;
    }
  | { readonly kind: "refused"; readonly sentence: string }
  | {
      readonly kind: "shown";
      readonly trial: Trial;
      /** Another place of the slider that showed the same points; null for none. */
      readonly sameAs: string | null;
    };

export const sameWay = (a: Planarising | null, b: Planarising | null): boolean =>
  a?.smooth === b?.smooth &&
  a?.keepBoundary === b?.keepBoundary &&
  a?.keepShape === b?.keepShape &&
  a?.within === b?.within &&
  a?.flat === b?.flat &&
  a?.constraints.join() === b?.constraints.join();

/** "2570 points moved by up to 1675 mm"; "" where nothing had to be made flat. */
export function planarisingWords({ planarising }: MeshReport, unit: Unit): string {
  const { moved, largest } = planarising;
  if (moved === 0) return "";
  return `${counted(moved, "point")} moved by up to ${formatLength(largest, unit)}`;
}
