// SPDX-License-Identifier: MIT
// The paper's figures as designs to open; made by .tools/paper/paper.mjs, see docs/paper.md.

import { computed, signal } from "@preact/signals";
import type { OpenedMesh } from "../solver/protocol.ts";
import { fetchPart } from "./later.ts";
import { kept, type Page } from "./page.ts";

export interface Figure {
  readonly name: string;
  readonly label: string;
  readonly link: string;
}

/** The paper's figures that are offered; none until the page can be used. */
export const offeredFigures = kept(() => signal<readonly Figure[]>([]));

/** What the mesh on screen came from, as long as no other mesh is opened. */
const followed = kept(() =>
  signal<{
    readonly key: "link" | "name";
    readonly value: string;
    readonly opened: OpenedMesh | null;
  } | null>(null),
);

/** The link or the figure's name that the design on screen was opened by. */
export function rememberOrigin(page: Page, key: "link" | "name", value: string): void {
  followed(page).value = { key, value, opened: page.mesh.peek() };
}

/** The figure that the design on screen began as. */
export const shownFigure = kept((page) =>
  computed(() => {
    const origin = followed(page).value;
    if (!origin || origin.opened !== page.mesh.value) return null;
    const { key, value } = origin;
    return offeredFigures(page).value.find((figure) => figure[key] === value) ?? null;
  }),
);

export async function loadFigures(page: Page): Promise<void> {
  const part = await fetchPart(page, () => import("../../../docs/scenes/offered.json"));
  offeredFigures(page).value = part?.default ?? [];
}

/** Opens a figure by the page's address, as any link. False if there is no such figure. */
export function openFigure(page: Page, name: string): boolean {
  const figure = offeredFigures(page).value.find((f) => f.name === name);
  if (figure) location.hash = figure.link;
  return figure !== undefined;
}
