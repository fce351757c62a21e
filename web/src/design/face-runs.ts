// SPDX-License-Identifier: MIT
// Groups of panels as OBJ has them: runs of faces, each of which may be of several groups. A line is the
// first face of a run, a blank, and the names, which have no blanks but before a "#", or, behind a tab,
// one name with blanks.
import { type Group, MOST_GROUPS } from "./groups.ts";

/** "Panel #1" is one name also where several stand in a line. */
const namesIn = (text: string): string[] =>
  text.startsWith("\t") ? [text.slice(1).trim()] : text.split(/\s+(?![\s#])/);

/** The groups of a file, without colours, in the order in which they come. */
export function groupsOfRuns(runs: string, faces: number): Group[] {
  const members = new Map<string, number[]>();
  const lines = runs.split("\n").filter((line) => line !== "");
  const starts = lines.map((line) => Number.parseInt(line, 10));
  lines.forEach((line, k) => {
    const names = namesIn(line.slice(line.indexOf(" ") + 1));
    const [begin = faces, end = faces] = starts.slice(k, k + 2);
    for (const name of new Set(names.filter((one) => one !== ""))) {
      const list = members.get(name) ?? [];
      for (let face = begin; face < end; ++face) list.push(face);
      members.set(name, list);
    }
  });
  return [...members]
    .slice(0, MOST_GROUPS)
    .map(([name, list]) => ({ name, of: "panels", members: list, colour: null }));
}

/** The names of each face's groups; names keep their blanks only where they stand alone. */
function namesOfFaces(groups: readonly Group[], faces: number): Map<number, string> {
  const panels = groups.filter(({ of }) => of === "panels");
  const counts = new Map<number, number>();
  for (const { members } of panels)
    for (const face of members) counts.set(face, (counts.get(face) ?? 0) + 1);
  const names = new Map<number, string>();
  for (const { name, members } of panels) {
    const alone = members.every((face) => counts.get(face) === 1);
    const words = name.trim().replace(/\s+/g, " ");
    const word = alone && words.includes(" ") ? `\t${words}` : words.replaceAll(" ", "_");
    for (const face of members)
      if (face < faces) names.set(face, names.has(face) ? `${names.get(face)} ${word}` : word);
  }
  return names;
}

/** The runs of the groups of panels; points have none. A face of no group begins a run without a name. */
export function runsOfGroups(groups: readonly Group[], faces: number): string {
  const names = namesOfFaces(groups, faces);
  const lines: string[] = [];
  let last = "";
  for (let face = 0; face < faces; ++face) {
    const now = names.get(face) ?? "";
    if (now !== last) lines.push(`${face} ${now}\n`);
    last = now;
  }
  return lines.join("");
}
