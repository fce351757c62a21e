// SPDX-License-Identifier: MIT
// The paper's figures as designs to open; made by .tools/paper.mjs, see docs/paper.md.
import { signal } from "@preact/signals";
import { fetchPart } from "./later.ts";

export interface Figure {
  readonly name: string;
  readonly label: string;
  readonly link: string;
}

/** None until the page can be used. */
export const offeredFigures = signal<readonly Figure[]>([]);

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
