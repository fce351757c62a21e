// SPDX-License-Identifier: MIT
// The paper's figures as designs to open; made by .tools/paper.mjs, see docs/paper.md.
import { computed, signal } from "@preact/signals";
import type { OpenedMesh } from "../solver/protocol.ts";
import { fetchPart } from "./later.ts";
import { mesh } from "./store.ts";

export interface Figure {
  readonly name: string;
  readonly label: string;
  readonly link: string;
}

/** None until the page can be used. */
export const offeredFigures = signal<readonly Figure[]>([]);

/** The link that gave the mesh on screen, as long as no other mesh is opened. */
const followed = signal<{ readonly link: string; readonly opened: OpenedMesh | null } | null>(null);

export function rememberLink(link: string): void {
  followed.value = { link, opened: mesh.peek() };
}

/** The figure that the design on screen began as. */
export const shownFigure = computed(() => {
  if (!followed.value || followed.value.opened !== mesh.value) return null;
  const { link } = followed.value;
  return offeredFigures.value.find((figure) => figure.link === link) ?? null;
});

export async function loadFigures(): Promise<void> {
  const part = await fetchPart(() => import("../../../docs/scenes/offered.json"));
  offeredFigures.value = part?.default ?? [];
}

/** By the page's address, as any link. False if there is no such figure. */
export function openFigure(name: string): boolean {
  const figure = offeredFigures.value.find((f) => f.name === name);
  if (figure) location.hash = figure.link;
  return figure !== undefined;
}
