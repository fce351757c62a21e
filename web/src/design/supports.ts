// SPDX-License-Identifier: MIT
// What points stand on and slide along, in the words of the command line: "level=z:3,4",
// "outline:boundary". Before the colon is what it is, behind it whose.

/** "level=z" of "level=z:3,4". */
export const formOf = (support: string): string => support.slice(0, support.indexOf(":"));

export const whose = (support: string): string => support.slice(support.indexOf(":") + 1);

const SPRING = "spring=";

/** Whether it holds nothing: its points only move less or more willingly. */
export const isSpring = (support: string): boolean => support.startsWith(SPRING);

/** "8" of "spring=8:3,4". */
export const springForm = (support: string): string => formOf(support).slice(SPRING.length);

const BOUNDARY = "boundary";

const isOfBoundary = (support: string): boolean =>
  whose(support) === BOUNDARY && !isSpring(support);

/** Whether it speaks of points by their numbers, which are those of one mesh. */
export const isListed = (support: string): boolean => /\d$/.test(support);

/** Those that say something of whatever mesh. */
export const ofAnyMesh = (supports: readonly string[]): readonly string[] =>
  supports.filter((support) => !isListed(support));

/** What the whole boundary stands on; "" where it moves freely. */
export const boundaryForm = (supports: readonly string[]): string =>
  supports.filter(isOfBoundary).map(formOf).join(" ");

/** @param form "" to let it move freely */
export const withBoundary = (supports: readonly string[], form: string): readonly string[] => [
  ...(form ? [`${form}:${BOUNDARY}`] : []),
  ...supports.filter((support) => !isOfBoundary(support)),
];
