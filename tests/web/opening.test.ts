// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { NO_SHAPE } from "../../web/src/design/design.ts";
import { commitSettings, setTarget, shownPoint, undo } from "../../web/src/state/editing.ts";
import { openFile } from "../../web/src/state/files.ts";
import { openFirst, openSample, planarise } from "../../web/src/state/opening.ts";
import {
  adoptSnapshot,
  deleteSnapshot,
  renameSnapshot,
  takeSnapshot,
} from "../../web/src/state/snapshots.ts";
import { openedPage, pageHere } from "./support/page-here.ts";

const bent = (): File => {
  const points: string[] = [];
  const faces: string[] = [];
  for (let j = 0; j < 6; ++j)
    for (let i = 0; i < 6; ++i)
      points.push(`v ${i} ${j} ${(0.05 * Math.sin(3 * i * j)).toFixed(6)}`);
  for (let j = 0; j < 5; ++j)
    for (let i = 0; i < 5; ++i) {
      const a = 6 * j + i + 1;
      faces.push(`f ${a} ${a + 1} ${a + 7} ${a + 6}`);
    }
  return new File([[...points, ...faces].join("\n")], "bent.obj");
};

it("the first visit has a mesh, and one point that asks to be dragged", async () => {
  const page = pageHere();
  await openFirst(page);
  expect(page.mesh.value?.report.faces).toBe(384);
  expect(page.hintVertex.value).not.toBeNull();
  expect(page.history.value?.present.shape).toBe(NO_SHAPE);
});

it("another mesh is one more step, which undo takes back with its edit", async () => {
  const page = await openedPage();
  const [x, y, z] = shownPoint(page, 220);
  await setTarget(page, 220, [x, y, z + 0.2]);
  const edited = page.history.value?.present;
  page.selection.value = [3];
  await openSample(page, "vault");
  expect(page.selection.value).toEqual([]);
  expect(page.handles.value).toEqual([]);
  await undo(page);
  expect(page.history.value?.present).toBe(edited);
  expect(page.mesh.value?.report.faces).toBe(384);
});

it("a limit on folds that the page found stays with its mesh; one that someone states goes along", async () => {
  const limits = () => page.settings.value?.limits;
  const page = await openedPage();
  const [x, y, z] = shownPoint(page, 220);
  await setTarget(page, 220, [x, y, z + 1.5]);
  expect(limits()).toEqual(["fold=+10"]);
  await openFile(page, bent());
  expect(limits()).toEqual([]);
  await undo(page);
  expect(limits()).toEqual(["fold=+10"]);
  await commitSettings(page, { limits: ["fold=+10", "angle=30:150"] });
  await openSample(page, "vault");
  expect(limits()).toEqual(["angle=30:150"]);
  await commitSettings(page, { limits: ["fold=+10"] });
  await openSample(page, "roof");
  expect(limits()).toEqual(["fold=+10"]);
});

it("a file that is not flat is not edited until it is, and planarising is one step", async () => {
  const page = pageHere();
  await openFile(page, bent());
  expect(page.problem.value).toBeNull();
  expect(page.baseFlat.value).toBe(false);
  expect(page.importReport.value).toBe(true);
  await planarise(page);
  expect(page.baseFlat.value).toBe(true);
  expect(page.history.value?.past.length).toBe(1);
  expect(page.history.value?.present.planarised).not.toBeNull();
  await undo(page);
  expect(page.baseFlat.value).toBe(false);
});

it("what is no mesh leaves what was there, and the sentence names the file", async () => {
  const page = await openedPage();
  const before = page.history.value?.present;
  await openFile(page, new File(["no mesh"], "broken.obj"));
  expect(page.problem.value).toMatch(/broken\.obj/);
  expect(page.history.value?.present).toBe(before);
  await openFile(page, new File(["?"], "what.xyz"));
  expect(page.problem.value).toMatch(/what\.xyz/);
});

it("a part of the page that cannot be had is said, and the design stays", async () => {
  // In node nobody serves the module that reads designs.
  const page = await openedPage();
  const before = page.history.value?.present;
  await openFile(page, new File(["{}"], "design.json"));
  expect(page.problem.value).toMatch(/could not be loaded/);
  expect(page.history.value?.present).toBe(before);
});

it("snapshots are named, adopted as one step, and go", async () => {
  const page = await openedPage();
  const first = await takeSnapshot(page);
  const [x, y, z] = shownPoint(page, 220);
  await setTarget(page, 220, [x, y, z + 0.2]);
  await takeSnapshot(page, "high");
  expect(page.snapshots.value.map(({ name }) => name)).toEqual(["Snapshot 1", "high"]);
  renameSnapshot(page, first, "  flat ");
  await adoptSnapshot(page, first);
  expect(page.figures.value.movedVertices).toBe(0);
  expect(page.history.value?.past.length).toBe(2);
  deleteSnapshot(page, first);
  expect(page.snapshots.value.map(({ name }) => name)).toEqual(["high"]);
});
