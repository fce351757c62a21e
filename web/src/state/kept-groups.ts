// SPDX-License-Identifier: MIT
// The groups that were made or changed here, and the mesh that they are of.
import { signal } from "@preact/signals";
import type { Group } from "../design/groups.ts";
import type { Source } from "../solver/protocol.ts";
import { kept, type Page } from "./page.ts";

export interface KeptGroups {
  /** Meshes with the same points and panels: what was continued from, too. */
  readonly sources: readonly Source[];
  readonly list: readonly Group[];
}

/** null: those of the file hold. */
export const keptGroups = kept(() => signal<KeptGroups | null>(null));

/** The colour of every panel by its group, from 1; 0 for none; null while nobody looks. */
export const groupFigures = kept(() => signal<Float32Array | null>(null));

export const isSameSource = (a: Source, b: Source): boolean => {
  if (a.kind === "sample") return b.kind === "sample" && a.name === b.name && a.size === b.size;
  return b.kind === "file" && a.crc === b.crc && a.bytes.size === b.bytes.size;
};

export const isOf = ({ sources }: KeptGroups, source: Source): boolean =>
  sources.some((one) => isSameSource(one, source));

/** Those of a mesh hold for another with the same points and panels, too. */
export function holdAlsoFor(page: Page, source: Source, next: Source): void {
  const groups = keptGroups(page);
  if (groups.value && isOf(groups.value, source))
    groups.value = { ...groups.value, sources: [...groups.value.sources, next] };
}

/** Those of the mesh that is open; null where those of its file hold. */
export function changedGroups(page: Page): readonly Group[] | null {
  const [own, source] = [keptGroups(page).value, page.history.value?.present.source];
  return own && source && isOf(own, source) ? own.list : null;
}
