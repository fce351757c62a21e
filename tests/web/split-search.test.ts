// SPDX-License-Identifier: MIT
import { expect, it, vi } from "vitest";
import {
  endSearch,
  search,
  searchNow,
  stopSearch,
} from "../../web/src/features/stopping/split-search.ts";
import { setTarget, shownPoint } from "../../web/src/state/editing.ts";
import type { Page } from "../../web/src/state/page.ts";
import { openedPage } from "./support/page-here.ts";

const VERTEX = 220;

const standing = (lines: number, handleError: number) => ({
  lines,
  cuts: Array.from({ length: lines }, (_, k) => `split=${k}:0,2`),
  handleError,
  movedVertices: 4,
  remadePanels: 9,
  sharpestFold: 30,
});

const TOLD = [standing(0, 4), standing(1, 3), standing(1, 2), standing(2, 1)];

/** A lifted point, and a search that tells so much and goes on. */
async function searching(told: typeof TOLD): Promise<Page> {
  const page = await openedPage("roof", ({ kind, job }) =>
    kind === "splitEdit"
      ? told.map((one) => ({ kind: "standing" as const, job, standing: one }))
      : null,
  );
  const [x, y, z] = shownPoint(page, VERTEX);
  await setTarget(page, VERTEX, [x, y, z + 0.2]);
  void search(page);
  return page;
}

const errors = (page: Page): number[] => {
  const now = searchNow(page);
  return now && now.kind !== "refused"
    ? now.curve.standings.map(({ handleError }) => handleError)
    : [];
};

it("the best of each number of lines is there while more are looked for, and stays when that is stopped", async () => {
  const page = await searching(TOLD);
  await vi.waitFor(() => expect(errors(page)).toEqual([4, 2, 1]));
  expect(searchNow(page)?.kind).toBe("running");
  stopSearch(page);
  expect(searchNow(page)).toMatchObject({ kind: "found", end: "stopped" });
  expect(errors(page)).toEqual([4, 2, 1]);
  endSearch(page);
  expect(searchNow(page)).toBeNull();
});

it("a search that is stopped before it found any line leaves nothing", async () => {
  const page = await searching(TOLD.slice(0, 1));
  await vi.waitFor(() => expect(errors(page)).toEqual([4]));
  stopSearch(page);
  expect(searchNow(page)).toBeNull();
});

it("what the design has is there before anything is solved", async () => {
  const page = await searching([]);
  const design = page.history.value?.present;
  const now = searchNow(page);
  expect(now?.kind).toBe("running");
  const [first, ...more] = now && now.kind !== "refused" ? now.curve.standings : [];
  expect(more).toEqual([]);
  const moved = new Set(design?.shape.moved);
  const mesh = page.mesh.value;
  const panels = Array.from({ length: (mesh?.offsets.length ?? 1) - 1 }, (_, panel) =>
    mesh?.vertices.subarray(mesh.offsets[panel], mesh.offsets[panel + 1]),
  );
  const [x, y, z] = shownPoint(page, VERTEX);
  const target = design?.handles[0]?.target ?? [0, 0, 0];
  expect(first).toMatchObject({
    lines: 0,
    cuts: [],
    movedVertices: design?.report.movedVertices,
    remadePanels: panels.filter((corners) => corners?.some((v) => moved.has(v))).length,
    sharpestFold: design?.report.sharpestFold?.after,
  });
  expect(first?.handleError).toBeCloseTo(
    Math.hypot(target[0] - x, target[1] - y, target[2] - z),
    12,
  );
});
