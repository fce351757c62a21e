// SPDX-License-Identifier: MIT
// The paper's figures as designs to open; made by .tools/paper.mjs, see docs/paper.md.
import offered from "../../../docs/scenes/offered.json";

export interface Figure {
  readonly name: string;
  readonly label: string;
  readonly link: string;
}

export const FIGURES: readonly Figure[] = offered;

/** By the page's address, as any link. False if there is no such figure. */
export function openFigure(name: string): boolean {
  const figure = FIGURES.find((f) => f.name === name);
  if (figure) location.hash = figure.link;
  return figure !== undefined;
}
