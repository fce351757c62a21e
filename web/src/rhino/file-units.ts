// SPDX-License-Identifier: MIT
// The units that Rhino has and the page has not: such a file is read in one that it has.
import type { UnitSystem } from "rhino3dm";
import type { Unit } from "../quantity/units.ts";
import { type Faces, type RhinoModule, unitOf } from "./model.ts";

/** What a file's coordinates are multiplied and then divided by, and the unit that they are in then. */
export interface FileUnit {
  /** null where the file does not say it. */
  readonly unit: Unit | null;
  readonly times: number;
  readonly per: number;
  /** One sentence where the page has not the file's unit; "" otherwise. */
  readonly remark: string;
}

type Row = readonly [system: string, name: string, unit: Unit, times: number, per: number];

const OTHERS: readonly Row[] = [
  ["Angstroms", "ångströms", "mm", 1, 1e7],
  ["Nanometers", "nanometres", "mm", 1, 1e6],
  ["Microns", "microns", "mm", 1, 1000],
  ["Decimeters", "decimetres", "cm", 10, 1],
  ["Dekameters", "decametres", "m", 10, 1],
  ["Hectometers", "hectometres", "m", 100, 1],
  ["Megameters", "megametres", "km", 1000, 1],
  ["Gigameters", "gigametres", "km", 1e6, 1],
  ["Microinches", "microinches", "in", 1, 1e6],
  ["Mils", "mils", "in", 1, 1000],
  ["PrinterPoints", "points of printers", "in", 1, 72],
  ["PrinterPicas", "picas of printers", "in", 1, 6],
  ["Yards", "yards", "ft", 3, 1],
  ["Miles", "miles", "ft", 5280, 1],
  ["NauticalMiles", "nautical miles", "m", 1852, 1],
  ["AstronomicalUnits", "astronomical units", "m", 149597870700, 1],
  ["LightYears", "light years", "m", 9460730472580800, 1],
  ["Parsecs", "parsecs", "km", 30856775814913.7, 1],
];

const NAMES: Readonly<Record<string, string>> = {
  cm: "centimetres",
  m: "metres",
  mm: "millimetres",
  km: "kilometres",
  in: "inches",
  ft: "feet",
};

export function fileUnit(rhino: RhinoModule, system: UnitSystem): FileUnit {
  const own = unitOf(rhino, system);
  if (own) return { unit: own, times: 1, per: 1, remark: "" };
  const systems = rhino.UnitSystem as unknown as Readonly<Record<string, UnitSystem>>;
  const row = OTHERS.find(([name]) => systems[name] !== undefined && systems[name] === system);
  if (!row) {
    const remark = "The file does not say its unit, or has one of its own: check the unit shown.";
    return { unit: null, times: 1, per: 1, remark };
  }
  const [, name, unit, times, per] = row;
  const remark = `The file is in ${name}, which the page does not have: it is read in ${NAMES[unit]}.`;
  return { unit, times, per, remark };
}

const scaledArray = (values: readonly number[] | Float64Array, { times, per }: FileUnit) =>
  Float64Array.from(values, (value) => (value * times) / per);

/** Coordinates in the unit that the page has. */
export const inUnit = (mesh: Faces, unit: FileUnit): Faces =>
  unit.times === unit.per ? mesh : { ...mesh, points: scaledArray(mesh.points, unit) };

/** Lists of coordinates that are drawn, in the unit that the page has. */
export const drawnInUnit = <
  T extends Readonly<Record<"lines" | "triangles" | "points", Float64Array>>,
>(
  drawn: T,
  unit: FileUnit,
): T =>
  unit.times === unit.per
    ? drawn
    : {
        ...drawn,
        lines: scaledArray(drawn.lines, unit),
        triangles: scaledArray(drawn.triangles, unit),
        points: scaledArray(drawn.points, unit),
      };
