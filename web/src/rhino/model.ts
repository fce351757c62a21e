// SPDX-License-Identifier: MIT
// What a .3dm file of ours holds beside its geometry, and by which names. See docs/formats.md.
import type { RhinoModule, UnitSystem } from "rhino3dm";
import { crc32 } from "../bytes/crc32.ts";
import type { Unit } from "../quantity/units.ts";

export type { RhinoModule } from "rhino3dm";

/** Points: x, y, z one after the other, model units; faces: the corners of each. */
export interface Faces {
  readonly points: readonly number[] | Float64Array;
  readonly faces: readonly (readonly number[])[];
}

/** The layers below `Planish`. */
export const LAYERS = ["Panels", "Outlines", "Mesh", "Remake", "Text"] as const;
export type LayerName = (typeof LAYERS)[number];
export const ROOT = "Planish";
export const layerPath = (name: LayerName): string => `${ROOT}::${name}`;

/** Document strings: the design as text, and the mark of the outlines that it gave. */
export const DESIGN_KEY = "Planish\\design";
export const OUTLINES_KEY = "Planish\\outlines";

/** CRC-32 of the number of corners and their coordinates, bit by bit, outline after outline. */
export function outlinesMark(outlines: readonly (readonly number[])[]): string {
  let mark = 0;
  for (const outline of outlines) {
    const sized = Float64Array.of(outline.length / 3, ...outline);
    mark = crc32(new Uint8Array(sized.buffer), mark);
  }
  return mark.toString(16).padStart(8, "0");
}

const SYSTEMS = {
  mm: "Millimeters",
  cm: "Centimeters",
  m: "Meters",
  km: "Kilometers",
  in: "Inches",
  ft: "Feet",
} as const satisfies Readonly<Record<Unit, string>>;

export const unitSystem = (rhino: RhinoModule, unit: Unit): UnitSystem =>
  rhino.UnitSystem[SYSTEMS[unit]];

/** null for one that the page does not know. */
export function unitOf(rhino: RhinoModule, system: UnitSystem): Unit | null {
  const units = Object.keys(SYSTEMS) as Unit[];
  return units.find((unit) => unitSystem(rhino, unit) === system) ?? null;
}
