// SPDX-License-Identifier: MIT
// Named sets of points or panels of one mesh.
import { isName, LONGEST_NAME } from "./reading.ts";

export interface Group {
  readonly name: string;
  readonly of: "points" | "panels";
  /** Ascending. */
  readonly members: readonly number[];
  /** Place among GROUP_COLOURS; null for none. */
  readonly colour: number | null;
}

/** Told apart by their order and by name; never by colour alone. */
export const GROUP_COLOURS: readonly string[] = [
  "#4E79A7",
  "#F28E2B",
  "#59A14F",
  "#E15759",
  "#B07AA1",
  "#76B7B2",
  "#EDC948",
  "#9C755F",
];

export const MOST_GROUPS = 100;

/** Name, whether of panels, colour from 1 (0: none), first member, gaps to the next ones. */
export type GroupJson = [string, 0 | 1, number, ...number[]];

export const writeGroup = ({ name, of, members, colour }: Group): GroupJson => [
  name.slice(0, LONGEST_NAME),
  of === "panels" ? 1 : 0,
  colour === null ? 0 : colour + 1,
  ...members.map((member, k) => member - (members[k - 1] ?? 0)),
];

const isCount = (value: unknown): value is number =>
  typeof value === "number" && Number.isSafeInteger(value) && value >= 0 && value <= 0x7fffffff;

function readGroup(value: unknown): Group | null {
  const [name, of, colour, ...gaps]: readonly unknown[] = Array.isArray(value) ? value : [];
  if (!isName(name) || name.trim() === "" || (of !== 0 && of !== 1) || !gaps.every(isCount))
    return null;
  if (gaps.length === 0 || gaps.slice(1).includes(0)) return null;
  let last = 0;
  const members = gaps.map((gap) => (last += gap));
  const known = isCount(colour) && colour >= 1 && colour <= GROUP_COLOURS.length;
  return { name, of: of === 1 ? "panels" : "points", members, colour: known ? colour - 1 : null };
}

/** Anything gives what can be read of it; of one name the first. */
export function readGroups(value: unknown): Group[] {
  const groups = new Map<string, Group>();
  for (const one of Array.isArray(value) ? value.slice(0, MOST_GROUPS) : []) {
    const group = readGroup(one);
    if (group && !groups.has(group.name)) groups.set(group.name, group);
  }
  return [...groups.values()];
}
