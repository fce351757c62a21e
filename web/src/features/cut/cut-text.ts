// SPDX-License-Identifier: MIT
// Cuts as --cut says them, put together from what is pointed at, and in words.

/** In the order in which they are offered. */
export const CUT_KINDS = ["split", "strip", "corner", "refine", "trim"] as const;

export type CutKind = (typeof CUT_KINDS)[number];

/** A corner of a panel, or a share of the way along one of its sides. */
export type OutlinePlace =
  | { readonly vertex: number }
  | { readonly from: number; readonly to: number; readonly share: number };

const placeText = (place: OutlinePlace): string =>
  "vertex" in place ? String(place.vertex) : `${place.from}-${place.to}@${place.share}`;

export const splitText = (panel: number, start: OutlinePlace, end: OutlinePlace): string =>
  `split=${panel}:${placeText(start)},${placeText(end)}`;

export const stripText = (side: Extract<OutlinePlace, { from: number }>): string =>
  `strip=${placeText(side)}`;

export const cornerText = (panel: number, vertex: number, share: number): string =>
  `corner=${panel}:${vertex}${share === 1 ? "" : `@${share}`}`;

export const refineText = (panels: readonly number[], collar: boolean): string =>
  `refine=${panels.join()}${collar ? ":collar" : ""}`;

const WORDS: Readonly<Record<CutKind, string>> = {
  split: "Split",
  strip: "Strip",
  corner: "Corner",
  refine: "Refine",
  trim: "Trim",
};

export const kindWord = (kind: CutKind): string => WORDS[kind];

/** "Split 7:12,40-41@0.3": the kind as a button says it, and its numbers as they are typed. */
export function cutWords(text: string): string {
  const [kind, numbers] = [text.slice(0, text.indexOf("=")), text.slice(text.indexOf("=") + 1)];
  const known = CUT_KINDS.find((one) => one === kind);
  return known ? `${WORDS[known]} ${numbers}` : text;
}
