// SPDX-License-Identifier: MIT
// Options as the words of the command line, which the core reads. Every option is known to the core
// alone, with its default, its range and its errors; what is undefined is not said.
import type { Command, Core } from "./core.ts";
import { PlanishError } from "./error.ts";

/** Limits of the panels, in degrees and model units. */
export interface Bounds {
  /** Keep every panel's shape; on unless it is false. */
  readonly shape?: boolean;
  /** Most degrees between neighbours; "+5": at most that much sharper than before. */
  readonly fold?: number | string;
  readonly angle?: readonly [least: number, most: number];
  readonly edge?: readonly [least: number, most: number];
  readonly area?: number;
  readonly sheet?: readonly [width: number, height: number];
}

/** One point and where it goes: by a displacement or to a place. */
export type HandleTarget = { readonly vertex: number } & (
  | { readonly by: readonly [x: number, y: number, z: number] }
  | { readonly to: readonly [x: number, y: number, z: number] }
);

/** "circular", "conical", or each with its tolerance in degrees. */
export type Constraints =
  | readonly string[]
  | { readonly circular?: number; readonly conical?: number };

const OTHER_FLAGS: Readonly<Record<string, string>> = {
  cuts: "--cut",
  pins: "--pin",
  supports: "--support",
  bounds: "--bound",
  keepOuts: "--keep-out",
  constraints: "--constraint",
};

export function handleWords(handles: readonly HandleTarget[]): string[] {
  return handles.map((handle) => {
    const [sign, point] = "by" in handle ? ["+=", handle.by] : ["=", handle.to];
    return `--handle=${handle.vertex}${sign}${point.join(",")}`;
  });
}

function boundTexts(bounds: Bounds | readonly string[]): string[] {
  if (Array.isArray(bounds)) return bounds.map(String);
  return Object.entries(bounds).flatMap(([name, value]) => {
    if (value === undefined) return [];
    if (typeof value === "boolean") return [`${name}=${value ? "on" : "off"}`];
    if (Array.isArray(value)) return [`${name}=${value.join(name === "sheet" ? "x" : ":")}`];
    return [`${name}=${value}`];
  });
}

function constraintTexts(constraints: Constraints): string[] {
  if (Array.isArray(constraints)) return constraints.map(String);
  return Object.entries(constraints).map(([kind, tolerance]) => `${kind}:${tolerance}`);
}

/** The values of an option that may be given several times. */
function texts(name: string, value: unknown): string[] {
  if (name === "bounds") return boundTexts(value as Bounds);
  if (name === "constraints") return constraintTexts(value as Constraints);
  const list = Array.isArray(value) ? value : [value];
  const numbers = list.every((entry) => typeof entry === "number");
  return numbers ? (list.length > 0 ? [list.join(",")] : []) : list.map(String);
}

function switchWord(name: string, flag: string, value: unknown): string[] {
  if (typeof value !== "boolean") throw new PlanishError("usage", `${name} must be true or false`);
  return value ? [flag] : [];
}

/** "keepBoundary" → "--keep-boundary" */
const flagOf = (name: string): string =>
  OTHER_FLAGS[name] ?? `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;

/** The words for `options`. An unknown name becomes a word, too: the core says that it is. */
export function optionWords(core: Core, command: Command, options: object): string[] {
  const rows = new Map(core.rows(command).map((row) => [row.name, row.value]));
  return Object.entries(options).flatMap(([name, value]) => {
    if (value === undefined || value === null) return [];
    const flag = flagOf(name);
    if (name in OTHER_FLAGS) return texts(name, value).map((text) => `${flag}=${text}`);
    const row = rows.get(flag);
    // What takes a value only perhaps, such as joinPoints, is also on or off.
    const isSwitch = row === "" || (row?.startsWith("[") && typeof value === "boolean");
    return isSwitch ? switchWord(name, flag, value) : [`${flag}=${value}`];
  });
}
