// SPDX-License-Identifier: MIT
// Supports of points that are listed by their numbers, which are those of one mesh.
import {
  formOf,
  isListed,
  isSpring,
  ofAnyMesh,
  springForm,
  whose,
  withoutAllOnSurface,
} from "./supports.ts";

/** The numbers of the points that it lists; none of "boundary" and "all". */
export const pointsOf = (support: string): number[] =>
  isListed(support) ? whose(support).split(",").map(Number) : [];

/** The form of a line of the mesh, whose points are listed in their order; the others' ascend. */
export const POLYLINE = "polyline";

/** What points are listed to stand on, by their numbers, in the order of the alphabet; springs hold
 * nothing. */
export function formsByPoint(supports: readonly string[]): ReadonlyMap<number, readonly string[]> {
  const forms = new Map<number, string[]>();
  for (const support of supports.filter((one) => !isSpring(one)))
    for (const vertex of new Set(pointsOf(support)))
      forms.set(vertex, [...(forms.get(vertex) ?? []), formOf(support)].sort());
  return forms;
}

const isListedSpring = (support: string): boolean => isListed(support) && isSpring(support);

const ascending = (points: Iterable<number>): number[] => [...points].sort((a, b) => a - b);

/** The pieces that are left of a line without the `chosen` points; one point is no line. */
function pieces(line: readonly number[], chosen: ReadonlySet<number>): number[][] {
  const cut = line.findIndex((vertex) => chosen.has(vertex));
  if (cut < 0) return [[...line]];
  const closed = line.length > 1 && line[0] === line.at(-1);
  const opened = closed ? [...line.slice(cut + 1), ...line.slice(1, cut + 1)] : line;
  const found: number[][] = [[]];
  for (const vertex of opened) chosen.has(vertex) ? found.push([]) : found.at(-1)?.push(vertex);
  return found.filter((piece) => piece.length > 1);
}

const isEnd = (line: readonly number[], vertex: number): boolean =>
  line[0] !== line.at(-1) && (line[0] === vertex || line.at(-1) === vertex);

/** Whether two lines share one point, and one of them ends there: it rests. */
function meetAtAnEnd(a: readonly number[], b: readonly number[]): boolean {
  const [shared, ...more] = new Set(a.filter((vertex) => b.includes(vertex)));
  if (shared === undefined || more.length > 0) return false;
  return isEnd(a, shared) || isEnd(b, shared);
}

/**
 * `vertices` stand on `forms` and on nothing else that lists points; of one form all are one text, but
 * every line of the mesh is one of its own, `vertices` in their order, and may end on another. Springs
 * stay.
 */
export function withPoints(
  supports: readonly string[],
  vertices: readonly number[],
  forms: readonly string[],
): readonly string[] {
  const chosen = new Set(vertices);
  const listed = new Map<string, number[]>();
  const lines: (readonly number[])[] = [];
  const springs = supports.filter(isListedSpring);
  for (const support of supports.filter((one) => isListed(one) && !isSpring(one))) {
    const form = formOf(support);
    if (form === POLYLINE) {
      const line = pointsOf(support);
      const meets = forms.includes(POLYLINE) && meetAtAnEnd(line, vertices);
      lines.push(...(meets ? [line] : pieces(line, chosen)));
    } else {
      const others = pointsOf(support).filter((vertex) => !chosen.has(vertex));
      listed.set(form, [...(listed.get(form) ?? []), ...others]);
    }
  }
  for (const form of forms) {
    if (form === POLYLINE) lines.push(vertices);
    else listed.set(form, [...(listed.get(form) ?? []), ...vertices]);
  }
  const texts = [...listed].flatMap(([form, points]) =>
    points.length > 0 ? [`${form}:${ascending(new Set(points)).join(",")}`] : [],
  );
  return [
    ...withoutAllOnSurface(ofAnyMesh(supports), forms),
    ...texts,
    ...lines.map((line) => `${POLYLINE}:${line.join(",")}`),
    ...springs,
  ];
}

/** The stiffness that springs give `vertices`: "" for none, null where they differ. */
export function springOf(supports: readonly string[], vertices: readonly number[]): string | null {
  const found = new Map<number, string>();
  for (const support of supports.filter(isSpring))
    for (const vertex of pointsOf(support)) found.set(vertex, springForm(support));
  const [first = "", ...others] = vertices.map((vertex) => found.get(vertex) ?? "");
  return others.every((other) => other === first) ? first : null;
}

/** `vertices` have that spring and no other. @param stiffness "" for none */
export function withSpring(
  supports: readonly string[],
  vertices: readonly number[],
  stiffness: string,
): readonly string[] {
  const chosen = new Set(vertices);
  const springs = new Map<string, number[]>();
  for (const support of supports.filter(isListedSpring)) {
    const others = pointsOf(support).filter((vertex) => !chosen.has(vertex));
    const form = springForm(support);
    springs.set(form, [...(springs.get(form) ?? []), ...others]);
  }
  if (stiffness) springs.set(stiffness, [...(springs.get(stiffness) ?? []), ...vertices]);
  return [
    ...supports.filter((support) => !isListedSpring(support)),
    ...[...springs].flatMap(([form, points]) =>
      points.length > 0 ? [`spring=${form}:${ascending(new Set(points)).join(",")}`] : [],
    ),
  ];
}
