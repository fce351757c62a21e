// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { panelList } from "../../web/src/features/panels/panel-list.ts";

it("lists every panel in order, lengths in millimetres whatever the model's unit", () => {
  const figures = Float32Array.of(0.0125, 1.5, 1.5, 0, 0, 0, 0, 0, 0);
  const health = Float32Array.of(0, 2, 87.5, 1, 2, 0.25, 10, 0, 0, 1, 90, 2);
  const head =
    "panel,out_of_flat_mm,out_of_flat_mm_per_m,smallest_angle_deg,shortest_edge_mm,shape,sharpest_fold_deg,must_be_made_again";
  const [troubles, folds] = [Float32Array.of(0, 5, 1), Float32Array.of(12.5, 3, 0)];
  const panels = { figures, health, troubles, urgency: troubles, folds, defects: null };
  expect(panelList(panels, "m", null).split("\r\n")).toEqual([
    head,
    "0,12.5,1.5,87.5,2000,convex,12.5,yes",
    "1,0,0,10,250,crosses itself,3,no",
    "2,0,0,90,1000,sliver,0,bevel",
    "",
  ]);
  expect(panelList(panels, "mm", null).split("\r\n")[1]).toBe(
    "0,0.0125,1.5,87.5,2,convex,12.5,yes",
  );
  const missed = panelList({ ...panels, defects: Float32Array.of(0.5, -1, 0) }, "m", "circular");
  expect(missed.split("\r\n")).toEqual([
    `${head},circular_defect_deg`,
    "0,12.5,1.5,87.5,2000,convex,12.5,yes,0.5",
    "1,0,0,10,250,crosses itself,3,no,",
    "2,0,0,90,1000,sliver,0,bevel,0",
    "",
  ]);
});
