// SPDX-License-Identifier: MIT
// Groups of the mesh that is open: those of its file until they are changed here; and what is done with
// the points and panels of one.
import { computed, effect } from "@preact/signals";
import { FIRST_SETTINGS } from "../design/design.ts";
import { groupsOfRuns } from "../design/face-runs.ts";
import { GROUP_COLOURS, type Group, MOST_GROUPS } from "../design/groups.ts";
import { springOf, withSpring } from "../design/listed-supports.ts";
import { LONGEST_NAME } from "../design/reading.ts";
import type { DisplayMesh } from "../mesh/display-mesh.ts";
import { cornersOf, panelsOf } from "../mesh/group-members.ts";
import type { Outcome } from "./action-queue.ts";
import { commitSettings, freePins, setPinned } from "./editing.ts";
import { hidden, hiddenPanels } from "./hidden-panels.ts";
import { changedGroups, groupFigures, keepGroups } from "./kept-groups.ts";
import { kept, type Page } from "./page.ts";

const NONE: readonly Group[] = [];

const groupsOfFile = kept((page) =>
  computed((): readonly Group[] => {
    const mesh = page.mesh.value;
    return mesh ? groupsOfRuns(mesh.groups, mesh.report.faces) : NONE;
  }),
);

export const groups = kept((page) =>
  computed((): readonly Group[] => changedGroups(page) ?? groupsOfFile(page).value),
);

const isTaken = (page: Page, name: string): boolean =>
  groups(page).value.some((group) => group.name === name);

/** The first "Group n" that is free. */
function freeName(page: Page): string {
  for (let n = 1; ; ++n) if (!isTaken(page, `Group ${n}`)) return `Group ${n}`;
}

/** What a new group would hold; nothing without a selection. */
export function selectedMembers(page: Page, of: Group["of"]): readonly number[] {
  const [mesh, points, panel] = [
    page.displayMesh.value,
    page.selection.value,
    page.selectedPanel.value,
  ];
  if (of === "points") return [...new Set(points)].sort((a, b) => a - b);
  if (mesh && points.length > 0) return panelsOf(mesh, points);
  return panel === null ? [] : [panel];
}

export function addGroup(page: Page, of: Group["of"]): void {
  const [list, members] = [groups(page).value, selectedMembers(page, of)];
  if (members.length === 0 || list.length >= MOST_GROUPS) return;
  const colour = list.length % GROUP_COLOURS.length;
  keepGroups(page, [...list, { name: freeName(page), of, members, colour }]);
}

const replace = (page: Page, group: Group, by: Partial<Group>): void =>
  keepGroups(
    page,
    groups(page).value.map((one) => (one === group ? { ...one, ...by } : one)),
  );

/** Stays as it is where the name is taken, or none. */
export function renameGroup(page: Page, group: Group, to: string): void {
  const name = to.trim().slice(0, LONGEST_NAME);
  if (name !== "" && !isTaken(page, name)) replace(page, group, { name });
}

/** The next colour, and none behind the last. */
export function recolourGroup(page: Page, group: Group): void {
  const next = group.colour === null ? 0 : group.colour + 1;
  replace(page, group, { colour: next < GROUP_COLOURS.length ? next : null });
}

/** The group alone: its points stay as they are. */
export function deleteGroup(page: Page, group: Group): void {
  keepGroups(
    page,
    groups(page).value.filter((one) => one !== group),
  );
}

interface Members {
  readonly of: DisplayMesh;
  readonly points: readonly number[];
  readonly panels: readonly number[];
}

const NOBODY = { points: [], panels: [] } as const;

/** Found once for a group and a mesh: rows are drawn often. */
const found = kept(() => new WeakMap<Group, Members>());

function membersOf(page: Page, group: Group): Omit<Members, "of"> {
  const [mesh, { of, members }] = [page.displayMesh.value, group];
  if (!mesh) return NOBODY;
  const known = found(page).get(group);
  if (known?.of === mesh) return known;
  const points = of === "points" ? members : cornersOf(mesh, members);
  const panels = of === "panels" ? members : panelsOf(mesh, members);
  const now = { of: mesh, points, panels };
  found(page).set(group, now);
  return now;
}

export const panelsOfGroup = (page: Page, group: Group): readonly number[] =>
  membersOf(page, group).panels;

export function selectGroup(page: Page, group: Group): void {
  page.selection.value = membersOf(page, group).points;
}

/** The pinned points as a text, which frames of a drag leave as it is. */
const pinned = kept((page) =>
  computed(() =>
    (page.draft.value?.handles ?? []).flatMap((row) => (row.pinned ? row.vertex : [])).join(),
  ),
);

const pinnedPoints = kept((page) =>
  computed(() => new Set(pinned(page).value.split(",").filter(Boolean).map(Number))),
);

export const isLocked = (page: Page, group: Group): boolean =>
  membersOf(page, group).points.every((vertex) => pinnedPoints(page).value.has(vertex));

/** Pins all its points, or frees them. */
export function lockGroup(page: Page, group: Group): Outcome {
  const points = membersOf(page, group).points;
  return isLocked(page, group) ? freePins(page, points) : setPinned(page, points, true);
}

export const isGroupHidden = (page: Page, group: Group): boolean =>
  panelsOfGroup(page, group).every((panel) => hiddenPanels(page).value.has(panel));

/** Takes the panels of a group out of the view, or brings them back. */
export function hideGroup(page: Page, group: Group): void {
  const of = page.displayMesh.value;
  if (!of) return;
  const [own, before] = [new Set(panelsOfGroup(page, group)), [...hiddenPanels(page).value]];
  const panels = new Set(
    isGroupHidden(page, group) ? before.filter((panel) => !own.has(panel)) : [...before, ...own],
  );
  hidden(page).value = panels.size > 0 ? { of, panels } : null;
}

const supportsOf = (page: Page): readonly string[] =>
  (page.settings.value ?? FIRST_SETTINGS).supports;

/** "" for that of all others; null where its points differ. */
export const stiffnessOf = (page: Page, group: Group): string | null =>
  springOf(supportsOf(page), membersOf(page, group).points);

/** How unwillingly its points move. @param stiffness "" for that of all others */
export const stiffen = (page: Page, group: Group, stiffness: string): Outcome =>
  commitSettings(page, {
    supports: withSpring(supportsOf(page), membersOf(page, group).points, stiffness),
  });

/** The first group with a colour decides. */
function figures(page: Page): Float32Array {
  const colours = new Float32Array(page.mesh.value?.report.faces ?? 0);
  for (const group of groups(page)
    .value.filter(({ colour }) => colour !== null)
    .reverse())
    for (const panel of panelsOfGroup(page, group)) colours[panel] = (group.colour ?? 0) + 1;
  return colours;
}

/** Colours the panels while someone looks at that. */
export const followGroups = (page: Page): (() => void) =>
  effect(() => {
    groupFigures(page).value = page.colourBy.value === "groups" ? figures(page) : null;
  });
