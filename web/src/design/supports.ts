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

/** The supports that mean something on any mesh. */
export const ofAnyMesh = (supports: readonly string[]): readonly string[] =>
  supports.filter((support) => !isListed(support));

/** What the whole boundary stands on; "" where it moves freely. */
export const boundaryForm = (supports: readonly string[]): string =>
  supports.filter(isOfBoundary).map(formOf).join(" ");

/** Every point slides along the surface that the mesh stands for. */
const ALL_ON_SURFACE = "surface:all";

export const areAllOnSurface = (supports: readonly string[]): boolean =>
  supports.includes(ALL_ON_SURFACE);

/** Whether it takes a point along a line of the mesh or a surface: there is one such for a point. */
const isFollowed = (support: string): boolean => /^(?:outline|polyline|surface)\b/.test(support);

/** Puts all points on the surface, and on nothing else that they would follow; or no longer so. */
export const withAllOnSurface = (supports: readonly string[], on: boolean): readonly string[] =>
  on
    ? [ALL_ON_SURFACE, ...supports.filter((one) => !isFollowed(one))]
    : supports.filter((one) => one !== ALL_ON_SURFACE);

/** Makes way for forms that points follow. */
export const withoutAllOnSurface = (
  supports: readonly string[],
  forms: readonly string[],
): readonly string[] => (forms.some(isFollowed) ? withAllOnSurface(supports, false) : supports);

/** @param form "" to let it move freely */
export const withBoundary = (supports: readonly string[], form: string): readonly string[] => [
  ...(form ? [`${form}:${BOUNDARY}`] : []),
  ...withoutAllOnSurface(supports, [form]).filter((support) => !isOfBoundary(support)),
];
