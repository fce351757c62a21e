// SPDX-License-Identifier: MIT
// What came beside a design: its note, its views and its variants, which are made again as the design is
// and become snapshots. What is here already is kept.
import { signal } from "@preact/signals";
import type { NamedView } from "../design/camera.ts";
import type { Companions } from "../design/companions.ts";
import type { Design } from "../design/design.ts";
import type { Group } from "../design/groups.ts";
import type { Steps } from "../design/recipe.ts";
import { counted } from "../quantity/counted.ts";
import type { MeshReport } from "../solver/protocol.ts";
import { keepGroups } from "./kept-groups.ts";
import { note } from "./note.ts";
import { kept, type Page } from "./page.ts";
import { sectionPlane } from "./shown-section.ts";
import { newSnapshot } from "./snapshots.ts";

/** The note that came with what is shown, until it is put aside; "" for none. */
export const arrivedNote = kept(() => signal(""));

/** A variant that was made again. */
export interface Received {
  readonly name: string;
  readonly design: Design;
  /** Whether it is what its author had. */
  readonly same: boolean;
}

/** The design with what was done in place of what was done. */
export const variantsOf = (recipe: Steps): readonly { name: string; steps: Steps }[] =>
  (recipe.companions?.variants ?? []).map(({ name, steps }) => ({
    name,
    steps: { ...recipe, ...steps, companions: undefined, camera: null },
  }));

/** "A", or "A 2" where another has that name. */
function freeName(taken: readonly string[], name: string): string {
  for (let n = 1; ; ++n) {
    const tried = n === 1 ? name : `${name} ${n}`;
    if (!taken.includes(tried)) return tried;
  }
}

/** Whether it may have been given by freeName(). */
const isNamed = (given: string, name: string): boolean =>
  given === name || /^ \d+$/.test(given.startsWith(name) ? given.slice(name.length) : "");

const isSame = (a: Design, b: Design): boolean =>
  a.shape.positions.length === b.shape.positions.length &&
  a.shape.moved.every((vertex, k) => vertex === b.shape.moved[k]) &&
  a.shape.positions.every((x, k) => x === b.shape.positions[k]) &&
  JSON.stringify([a.handles, a.settings]) === JSON.stringify([b.handles, b.settings]);

function keepVariants(page: Page, received: readonly Received[]): void {
  for (const { name, design } of received) {
    const all = page.snapshots.value;
    if (all.some((one) => isNamed(one.name, name) && isSame(one.design, design))) continue;
    const names = all.map((one) => one.name);
    page.snapshots.value = [...all, newSnapshot(freeName(names, name), design)];
  }
}

function keepViews(page: Page, views: readonly NamedView[]): void {
  for (const { name, camera } of views) {
    const all = page.views.value;
    const same = JSON.stringify(camera);
    if (all.some((one) => isNamed(one.name, name) && JSON.stringify(one.camera) === same)) continue;
    const names = all.map((one) => one.name);
    page.views.value = [...all, { name: freeName(names, name), camera }];
  }
}

/** Whether the mesh has all its members, which ascend. */
const isOfMesh = ({ of, members }: Group, { vertices, faces }: MeshReport): boolean =>
  (members.at(-1) ?? 0) < (of === "points" ? vertices : faces);

/** Groups that came with their mesh: those of the mesh that was open are its own. */
function groupsThatCame(page: Page, came: readonly Group[]): readonly Group[] {
  const mesh = page.mesh.value;
  const list = mesh ? came.filter((group) => isOfMesh(group, mesh.report)) : [];
  if (list.length > 0) keepGroups(page, list);
  return list;
}

/** Keeps a note that came; one's own stays below it. */
function keepNote(page: Page, came: string): void {
  const own = note(page);
  if (!came || own.value.includes(came)) return;
  own.value = own.value ? `${came}\n\n${own.value}` : came;
  arrivedNote(page).value = came;
}

const some = (n: number, what: string): string[] => (n === 0 ? [] : [counted(n, what)]);

/** @returns what came, in a sentence; "" for nothing */
export function receive(
  page: Page,
  came: Companions | undefined,
  received: readonly Received[],
): string {
  if (!came) return "";
  keepNote(page, came.note);
  keepViews(page, came.views);
  const groups = groupsThatCame(page, came.groups);
  if (came.section) sectionPlane(page).value = came.section;
  keepVariants(page, received);
  const words = [
    ...(came.note ? ["a note"] : []),
    ...some(came.views.length, "view"),
    ...some(received.length, "snapshot"),
    ...(came.section ? ["a section"] : []),
    ...some(groups.length, "group"),
  ];
  const others = received.filter(({ same }) => !same).map(({ name }) => name);
  const lost = came.variants.length - received.length;
  return [
    words.length > 0 ? `With it came ${words.join(", ")}.` : "",
    others.length > 0 ? `${others.join(", ")}: not quite what was recorded.` : "",
    lost > 0 ? `${counted(lost, "snapshot")} could not be made again.` : "",
  ]
    .filter((sentence) => sentence !== "")
    .join(" ");
}
