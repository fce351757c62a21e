// SPDX-License-Identifier: MIT
// Supports of points that are listed by their numbers, which are those of one mesh.
import { formOf, isListed, ofAnyMesh, whose } from "./supports.ts";

/** The numbers of the points that it lists; none of "boundary" and "all". */
export const pointsOf = (support: string): number[] =>
  isListed(support) ? whose(support).split(",").map(Number) : [];

/** What points are listed to stand on, by their numbers, in the order of the alphabet. */
export function formsByPoint(supports: readonly string[]): ReadonlyMap<number, readonly string[]> {
  const forms = new Map<number, string[]>();
  for (const support of supports)
    for (const vertex of pointsOf(support))
      forms.set(vertex, [...(forms.get(vertex) ?? []), formOf(support)].sort());
  return forms;
}

/** What one point is listed to stand on. */
export const formsOf = (supports: readonly string[], vertex: number): readonly string[] =>
  formsByPoint(supports).get(vertex) ?? [];

const ascending = (points: Iterable<number>): number[] => [...points].sort((a, b) => a - b);

/** `vertices` stand on `forms` and on nothing else that lists points; of one form all are one text. */
export function withPoints(
  supports: readonly string[],
  vertices: readonly number[],
  forms: readonly string[],
): readonly string[] {
  const chosen = new Set(vertices);
  const listed = new Map<string, number[]>();
  for (const support of supports.filter(isListed)) {
    const others = pointsOf(support).filter((vertex) => !chosen.has(vertex));
    listed.set(formOf(support), [...(listed.get(formOf(support)) ?? []), ...others]);
  }
  for (const form of forms) listed.set(form, [...(listed.get(form) ?? []), ...vertices]);
  const texts = [...listed].flatMap(([form, points]) =>
    points.length > 0 ? [`${form}:${ascending(new Set(points)).join(",")}`] : [],
  );
  return [...ofAnyMesh(supports), ...texts];
}
