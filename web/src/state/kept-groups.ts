// SPDX-License-Identifier: MIT
// The groups that were made or changed here, and the meshes that their numbers are of. On a mesh with other
// cuts they are carried over: the parts of a panel are in its groups.
import { computed, signal } from "@preact/signals";
import type { Group } from "../design/groups.ts";
import type { OpenedMesh, Source } from "../solver/protocol.ts";
import { kept, type Page } from "./page.ts";

interface NumberedMesh {
  readonly source: Source;
  readonly cuts: readonly string[];
  /** See OpenedMesh. */
  readonly parents: Int32Array;
}

export interface KeptGroups {
  /** With the same points and panels: what was continued from, too. */
  readonly meshes: readonly NumberedMesh[];
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

const UNCUT: NumberedMesh["cuts"] = [];

const sourceShown = kept((page) => computed(() => page.history.value?.present.source));

const cutsShown = kept((page) => computed(() => page.draft.value?.settings.cuts ?? UNCUT));

/** The mesh that is open, as numbers are of it; null before there is one. */
function meshShown(page: Page): NumberedMesh | null {
  const [source, cuts, mesh] = [sourceShown(page).value, cutsShown(page).value, page.mesh.value];
  return source && mesh ? { source, cuts, parents: mesh.parents } : null;
}

const isSameMesh = (a: NumberedMesh, b: NumberedMesh): boolean =>
  isSameSource(a.source, b.source) && a.cuts.join() === b.cuts.join();

/** What its members are on `mesh`, whose numbers were of a mesh with these parents. */
function carried(group: Group, parents: Int32Array, mesh: OpenedMesh): Group {
  const { report } = mesh;
  if (group.of === "points")
    return { ...group, members: group.members.filter((vertex) => vertex < report.vertices) };
  const before = new Set(group.members.map((panel) => parents[panel] ?? panel));
  const members = Array.from({ length: report.faces }, (_, panel) => panel);
  return {
    ...group,
    members: members.filter((panel) => before.has(mesh.parents[panel] ?? panel)),
  };
}

const changed = kept((page) =>
  computed((): readonly Group[] | null => {
    const [own, shown, mesh] = [keptGroups(page).value, meshShown(page), page.mesh.value];
    if (!own || !shown || !mesh) return null;
    if (own.meshes.some((one) => isSameMesh(one, shown))) return own.list;
    const from = own.meshes.find(({ source }) => isSameSource(source, shown.source));
    if (!from) return null;
    const list = own.list.map((group) => carried(group, from.parents, mesh));
    return list.filter(({ members }) => members.length > 0);
  }),
);

/** The groups of the mesh that is open; null where those of its file hold. */
export const changedGroups = (page: Page): readonly Group[] | null => changed(page).value;

/** Keeps `list` as the groups of the open mesh, and of the others that its numbers are of. */
export function keepGroups(page: Page, list: readonly Group[]): void {
  const [own, shown] = [keptGroups(page).value, meshShown(page)];
  if (!shown) return;
  const same = own?.meshes.some((one) => isSameMesh(one, shown)) ?? false;
  keptGroups(page).value = { meshes: own && same ? own.meshes : [shown], list };
}

/** Keeps the groups of the open mesh for another with the same points and panels, too. */
export function holdAlsoFor(page: Page, next: Source): void {
  const list = changedGroups(page);
  if (!list) return;
  keepGroups(page, list);
  const own = keptGroups(page).value;
  const mesh = { source: next, cuts: UNCUT, parents: new Int32Array(0) };
  if (own) keptGroups(page).value = { ...own, meshes: [...own.meshes, mesh] };
}
