// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { groupsOfRuns, runsOfGroups } from "../../web/src/design/face-runs.ts";
import { type Group, readGroups, writeGroup } from "../../web/src/design/groups.ts";
import {
  formsByPoint,
  springOf,
  withPoints,
  withSpring,
} from "../../web/src/design/listed-supports.ts";
import { boundaryForm, withBoundary } from "../../web/src/design/supports.ts";
import { prepareDisplay } from "../../web/src/mesh/display-mesh.ts";
import { cornersOf, panelsOf } from "../../web/src/mesh/group-members.ts";
import { addGroup, groups, isLocked, lockGroup } from "../../web/src/state/groups.ts";
import { openSample } from "../../web/src/state/opening.ts";
import { receive } from "../../web/src/state/receiving.ts";
import { openedPage } from "./support/page-here.ts";

const RIDGE: Group = { name: "Ridge", of: "points", members: [0, 4, 5, 90], colour: 2 };
const GLASS: Group = { name: "Glass 1", of: "panels", members: [2, 3, 7], colour: null };
const DOORS: Group = { name: "Doors", of: "panels", members: [3, 4], colour: 0 };

describe("groups in links and records", () => {
  it("come back as they were", () => {
    expect(readGroups(JSON.parse(JSON.stringify([RIDGE, GLASS].map(writeGroup))))).toEqual([
      RIDGE,
      GLASS,
    ]);
  });

  it("are left out where they are none", () => {
    const good = writeGroup(RIDGE);
    const odd = [null, 3, "g", [], ["a"], ["a", 0, 0], ["a", 2, 0, 1], ["a", 0, 0, -1]];
    const worse = [
      ["a", 0, 0, 1, 0],
      ["a", 0, 0, 1.5],
      ["", 0, 0, 1],
      ["a", 0, 0, 1e12],
    ];
    expect(readGroups([...odd, ...worse, good, good])).toEqual([RIDGE]);
    expect(readGroups("no")).toEqual([]);
    expect(readGroups([["a", 0, 99, 1]])[0]?.colour).toBeNull();
  });
});

describe("groups of panels in OBJ", () => {
  it("are runs of faces, each of which may be of several", () => {
    const runs = runsOfGroups([RIDGE, GLASS, DOORS], 9);
    expect(runs).toBe("2 Glass_1\n3 Glass_1 Doors\n4 Doors\n5 \n7 Glass_1\n8 \n");
    expect(groupsOfRuns(runs, 9)).toEqual([
      { ...GLASS, name: "Glass_1" },
      { ...DOORS, colour: null },
    ]);
  });

  it("keep blanks where a name stands alone, and before a number sign", () => {
    const names = (runs: string) => groupsOfRuns(runs, 4).map(({ name }) => name);
    expect(names("0 Panel #1\n1 Panel  #2\n2 #3 a\n")).toEqual([
      "Panel #1",
      "Panel  #2",
      "#3",
      "a",
    ]);
    expect(names("0 \tNorth roof\n2 South roof\n")).toEqual(["North roof", "South", "roof"]);
    const north = { ...DOORS, name: "North  roof", members: [0, 1] };
    expect(runsOfGroups([north], 4)).toBe("0 \tNorth roof\n2 \n");
    expect(names(runsOfGroups([north], 4))).toEqual(["North roof"]);
    expect(runsOfGroups([north, { ...GLASS, members: [1, 2] }], 3)).toBe(
      "0 North_roof\n1 North_roof Glass_1\n2 Glass_1\n",
    );
  });

  it("of a file end with the file", () => {
    expect(groupsOfRuns("0 a\n2 b\n", 4).map(({ members }) => members)).toEqual([
      [0, 1],
      [2, 3],
    ]);
    expect(groupsOfRuns("", 4)).toEqual([]);
    expect(runsOfGroups([], 4)).toBe("");
  });
});

describe("a spring", () => {
  const SUPPORTS = ["level=z:boundary", "spring=2:boundary", "level=x:3,4", "spring=4:4,5"];

  it("is given to some points and taken from them, and nothing else changes", () => {
    const stiffer = withSpring(SUPPORTS, [5, 9], "30");
    expect(stiffer).toEqual([...SUPPORTS.slice(0, 3), "spring=4:4", "spring=30:5,9"]);
    expect(springOf(stiffer, [5, 9])).toBe("30");
    expect(springOf(stiffer, [4, 5])).toBeNull();
    expect(springOf(stiffer, [7])).toBe("");
    expect(withSpring(stiffer, [4, 5, 9], "")).toEqual(SUPPORTS.slice(0, 3));
  });

  it("is nothing that a point stands on", () => {
    expect([...formsByPoint(SUPPORTS).keys()]).toEqual([3, 4]);
    expect(boundaryForm(SUPPORTS)).toBe("level=z");
    expect(withBoundary(SUPPORTS, "")).toEqual(SUPPORTS.slice(1));
    expect(withPoints(SUPPORTS, [4, 5], ["level=y"])).toContain("spring=4:4,5");
  });
});

it("panels of points are those that have no other corner; without one, those at them", () => {
  // Three quads in a row.
  const mesh = prepareDisplay({
    display: new Float32Array(24),
    offsets: Int32Array.of(0, 4, 8, 12),
    vertices: Int32Array.of(0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6),
  });
  expect(panelsOf(mesh, [0, 1, 4, 5, 2])).toEqual([0]);
  expect(panelsOf(mesh, [1])).toEqual([0, 1]);
  expect(cornersOf(mesh, [2, 1])).toEqual([1, 2, 3, 5, 6, 7]);
});

describe("groups of the mesh that is open", () => {
  it("are locked by pins, and no other mesh has them", async () => {
    const page = await openedPage();
    page.selection.value = [0];
    addGroup(page, "points");
    const [corner] = groups(page).value;
    if (!corner) throw new Error("no group");
    expect(isLocked(page, corner)).toBe(false);
    await lockGroup(page, corner);
    expect(isLocked(page, corner)).toBe(true);
    expect(page.draft.value?.handles.map(({ vertex, pinned }) => [vertex, pinned])).toEqual([
      [0, true],
    ]);
    await lockGroup(page, corner);
    expect(isLocked(page, corner)).toBe(false);
    await openSample(page, "vault");
    expect(groups(page).value).toEqual([]);
  });

  it("come with a design only as far as its mesh has their members", async () => {
    const page = await openedPage();
    const { vertices = 0, faces = 0 } = page.mesh.value?.report ?? {};
    const all: Group[] = [
      { ...RIDGE, members: [0, vertices - 1] },
      { ...GLASS, members: [1, faces] },
      { ...DOORS, members: [faces - 1] },
    ];
    const came = { note: "", views: [], variants: [], section: null, groups: all };
    expect(receive(page, came, [])).toBe("With it came 2 groups.");
    expect(groups(page).value.map(({ name }) => name)).toEqual(["Ridge", "Doors"]);
  });
});
