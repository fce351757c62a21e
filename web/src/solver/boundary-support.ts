// SPDX-License-Identifier: MIT
import type { BoundarySupport } from "./protocol.ts";

/** As the command line's --support says them. */
export const SUPPORT_WORDS: Readonly<Record<BoundarySupport, string>> = {
  none: "",
  level: "level=z:boundary",
  outline: "outline:boundary",
};

/** null where the page has no control for them. */
export function supportOf(words: readonly string[]): BoundarySupport | null {
  if (words.length === 0) return "none";
  const all = Object.keys(SUPPORT_WORDS) as BoundarySupport[];
  return all.find((name) => words.length === 1 && words[0] === SUPPORT_WORDS[name]) ?? null;
}
