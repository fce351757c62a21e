// SPDX-License-Identifier: MIT
// Limits on an edit, in the words of the command line: "fold=+5", "edge=0.5:2".

const NUMBER = String.raw`\d+(?:\.\d*)?(?:e[+-]?\d+)?`;
const LIMIT = new RegExp(
  `^(?:(?:fold=\\+?|area=|slide=)${NUMBER}|(?:angle|edge)=${NUMBER}:${NUMBER}|sheet=${NUMBER}x${NUMBER})$`,
);

/** What a limit begins with; the page has one control for each: "fold=", "fold=+", "angle=" … */
export const limitHead = (limit: string): string => /^[a-z]+=\+?/.exec(limit)?.[0] ?? "";

export const limitNumbers = (limit: string): readonly number[] =>
  limit.slice(limitHead(limit).length).split(/[:x]/).map(Number);

const isLimit = (value: unknown): value is string =>
  typeof value === "string" && value.length <= 100 && LIMIT.test(value);

/** A stranger's list, each control's limit at most once; null if it is none. */
export function readLimits(value: unknown): readonly string[] | null {
  if (!Array.isArray(value) || !value.every(isLimit)) return null;
  return new Set(value.map(limitHead)).size === value.length ? value : null;
}
