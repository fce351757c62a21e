// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { formsByPoint, pointsOf, withPoints } from "../../web/src/design/listed-supports.ts";
import {
  areAllOnSurface,
  boundaryForm,
  ofAnyMesh,
  withAllOnSurface,
  withBoundary,
} from "../../web/src/design/supports.ts";

const GIVEN = ["outline:boundary", "level=z:3,4", "line=0,0,1,0,0,1:7"];

it("points stand on what is chosen for them and on nothing else", () => {
  expect(withPoints(GIVEN, [5, 3], ["level=x", "level=y"])).toEqual([
    "outline:boundary",
    "level=z:4",
    "line=0,0,1,0,0,1:7",
    "level=x:3,5",
    "level=y:3,5",
  ]);
  expect(withPoints(GIVEN, [5, 3], ["level=z"])[1]).toBe("level=z:3,4,5");
  expect(withPoints(GIVEN, [3, 4, 7], [])).toEqual(["outline:boundary"]);
});

it("says what a point stands on, and whose a support is", () => {
  const both = withPoints(GIVEN, [9], ["level=y", "level=x"]);
  const forms = formsByPoint(both);
  expect(forms.get(9)).toEqual(["level=x", "level=y"]);
  expect(forms.get(3)).toEqual(["level=z"]);
  expect(forms.get(1)).toBeUndefined();
  expect(both.map(pointsOf)).toEqual([[], [3, 4], [7], [9], [9]]);
});

it("the boundary stands on one thing, which goes with the settings to another mesh", () => {
  expect(boundaryForm(GIVEN)).toBe("outline");
  expect(withBoundary(GIVEN, "level=z")).toEqual(["level=z:boundary", ...GIVEN.slice(1)]);
  expect(withBoundary(GIVEN, "")).toEqual(GIVEN.slice(1));
  expect(ofAnyMesh(GIVEN)).toEqual(["outline:boundary"]);
});

it("lines of the mesh keep their order, and what is taken out of one leaves its pieces", () => {
  const lined = withPoints(GIVEN, [9, 2, 8, 1, 6], ["polyline"]);
  expect(lined).toEqual([...GIVEN, "polyline:9,2,8,1,6"]);
  expect(formsByPoint(lined).get(8)).toEqual(["polyline"]);
  expect(withPoints(lined, [8], ["level=z"])).toEqual([
    "outline:boundary",
    "level=z:3,4,8",
    "line=0,0,1,0,0,1:7",
    "polyline:9,2",
    "polyline:1,6",
  ]);
  expect(withPoints(lined, [2, 1], [])).toEqual(GIVEN);
  const closed = withPoints([], [5, 3, 9, 7, 5], ["polyline"]);
  expect(closed).toEqual(["polyline:5,3,9,7,5"]);
  expect(formsByPoint(closed).get(5)).toEqual(["polyline"]);
  expect(withPoints(closed, [9], [])).toEqual(["polyline:7,5,3"]);
  expect(withPoints(closed, [5], [])).toEqual(["polyline:3,9,7"]);
});

it("a line may end on another, which keeps all its points", () => {
  const one = withPoints([], [4, 5, 6], ["polyline"]);
  expect(withPoints(one, [2, 6, 10], ["polyline"])).toEqual(["polyline:4,5,6", "polyline:2,6,10"]);
  expect(withPoints(one, [5, 9, 13], ["polyline"])).toEqual(["polyline:4,5,6", "polyline:5,9,13"]);
  expect(withPoints(one, [1, 5, 9], ["polyline"])).toEqual(["polyline:1,5,9"]);
  expect(withPoints(one, [6, 5, 9], ["polyline"])).toEqual(["polyline:6,5,9"]);
  expect(withPoints(one, [6], ["level=x"])).toEqual(["level=x:6", "polyline:4,5"]);
});

it("all points on the surface follow nothing else", () => {
  const all = withAllOnSurface([...GIVEN, "polyline:1,2", "surface:5"], true);
  expect(all).toEqual(["surface:all", ...GIVEN.slice(1)]);
  expect(areAllOnSurface(all)).toBe(true);
  expect(withAllOnSurface(all, false)).toEqual(GIVEN.slice(1));
  expect(withBoundary(all, "outline")).toEqual(GIVEN);
  expect(withBoundary(all, "level=z")).toEqual(["level=z:boundary", ...all]);
  expect(withPoints(all, [1, 2], ["polyline"])).toEqual([...GIVEN.slice(1), "polyline:1,2"]);
  expect(areAllOnSurface(withPoints(all, [1, 2], ["level=x"]))).toBe(true);
});
