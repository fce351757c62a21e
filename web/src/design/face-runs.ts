// SPDX-License-Identifier: MIT
// Groups of panels as OBJ has them: runs of faces, each of which may be of several groups. A line is the
// first face of a run, a blank, and the names, which have no blanks.
import { type Group, MOST_GROUPS } from "./groups.ts";

/** The groups of a file, without colours, in the order in which they come. */
export function groupsOfRuns(runs: string, faces: number): Group[] {
  const members = new Map<string, number[]>();
  const lines = runs.split("\n").filter((line) => line !== "");
  const starts = lines.map((line) => Number.parseInt(line, 10));
  lines.forEach((line, k) => {
    const names = line.slice(line.indexOf(" ") + 1).split(/\s+/);
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

/** The runs of the groups of panels; points have none. A face of no group begins a run without a name. */
export function runsOfGroups(groups: readonly Group[], faces: number): string {
  const names = new Map<number, string>();
  for (const { name, of, members } of groups) {
    if (of !== "panels") continue;
    const word = name.trim().replace(/\s+/g, "_");
    for (const face of members)
      if (face < faces) names.set(face, names.has(face) ? `${names.get(face)} ${word}` : word);
  }
  const lines: string[] = [];
  let last = "";
  for (let face = 0; face < faces; ++face) {
    const now = names.get(face) ?? "";
    if (now !== last) lines.push(`${face} ${now}\n`);
    last = now;
  }
  return lines.join("");
}
