// SPDX-License-Identifier: MIT
// What travels beside a design, in a link or in a file that a page saves: a note, views to look from,
// and variants of the design on the same mesh (variant-text.ts). It makes no part of the design: whatever
// is wrong with it is left out, and costs the design nothing.
import type { NamedView } from "./camera.ts";
import { type Group, type GroupJson, MOST_GROUPS, readGroups, writeGroup } from "./groups.ts";
import type { MarkedSteps } from "./marked-steps.ts";
import { isName, isRecord, LONGEST_NAME, readCamera, writeCamera } from "./reading.ts";
import { readSection, type SectionPlane, writeSection } from "./section-plane.ts";
import type { VariantJson } from "./variant-text.ts";

/** Characters. */
export const LONGEST_NOTE = 2000;
export const MOST_VIEWS = 50;
export const MOST_VARIANTS = 20;

export interface Variant {
  readonly name: string;
  readonly steps: MarkedSteps;
}

export interface Companions {
  /** For people, as plain text. */
  readonly note: string;
  /** No two have the same name. */
  readonly views: readonly NamedView[];
  readonly variants: readonly Variant[];
  /** null: the view is not cut. */
  readonly section: SectionPlane | null;
  /** Of the design's mesh. */
  readonly groups: readonly Group[];
}

/** Short names: they are part of every link. */
export interface CompanionsJson {
  /** The note. */
  n?: string;
  /** Views: a name, then position and target of the camera. */
  v?: [string, ...number[]][];
  /** Variants. */
  s?: VariantJson[];
  /** The section: axis, place, whether the other side is shown. */
  p?: [0 | 1 | 2, number, 0 | 1];
  /** Groups. */
  g?: GroupJson[];
}

/** null where there is nothing to say. @param variants those of the companions */
export function writeCompanions(
  { note, views, section, groups }: Companions,
  variants: readonly VariantJson[],
): CompanionsJson | null {
  const cut = (name: string): string => name.slice(0, LONGEST_NAME);
  const json: CompanionsJson = {
    ...(note && { n: note.slice(0, LONGEST_NOTE) }),
    ...(views.length > 0 && {
      v: views.slice(0, MOST_VIEWS).map(({ name, camera }) => [cut(name), ...writeCamera(camera)]),
    }),
    ...(variants.length > 0 && { s: variants.slice(0, MOST_VARIANTS) }),
    ...(section && { p: writeSection(section) }),
    ...(groups.length > 0 && { g: groups.slice(0, MOST_GROUPS).map(writeGroup) }),
  };
  return Object.keys(json).length > 0 ? json : null;
}

export const listOf = (value: unknown, most: number): readonly unknown[] =>
  Array.isArray(value) ? value.slice(0, most) : [];

function readViews(value: unknown): NamedView[] {
  const views = new Map<string, NamedView>();
  for (const one of listOf(value, MOST_VIEWS)) {
    const [name, ...numbers]: readonly unknown[] = Array.isArray(one) ? one : [];
    const camera = readCamera(numbers);
    if (isName(name) && camera) views.set(name, { name, camera });
  }
  return [...views.values()];
}

/** Anything gives what can be read of it; undefined for nothing. @param variants those of `value` */
export function readCompanions(
  value: unknown,
  variants: readonly Variant[],
): Companions | undefined {
  const { n, v, p, g } = isRecord(value) ? value : {};
  const note = typeof n === "string" ? n.slice(0, LONGEST_NOTE) : "";
  const views = readViews(v);
  const section = readSection(p);
  const groups = readGroups(g);
  const lists = [views, variants, groups];
  const some = note !== "" || section !== null || lists.some(({ length }) => length > 0);
  return some ? { note, views, variants, section, groups } : undefined;
}
