// SPDX-License-Identifier: MIT
// An edit of one point edits its images: in the page, in its links and in what it opens.
import { describe, expect, it } from "vitest";
import type { HandleRow, Point } from "../../web/src/design/design.ts";
import { fromDesign, toDesign } from "../../web/src/design/design-value.ts";
import { recipeOf } from "../../web/src/design/recipe.ts";
import { imagesOf, mirrorsIn, mirrorsText, withoutImages } from "../../web/src/design/symmetry.ts";
import { commitVariation, explore } from "../../web/src/features/exploring/exploring.ts";
import {
  findMirrors,
  mirrors,
  mostImages,
  noMirrors,
  setMirrors,
} from "../../web/src/features/symmetry/symmetry.ts";
import { setPinned, setTarget, shownPoint, undo } from "../../web/src/state/editing.ts";
import { markOf } from "../../web/src/state/marking.ts";
import { openSample, planarise } from "../../web/src/state/opening.ts";
import type { Page } from "../../web/src/state/page.ts";
import { replay } from "../../web/src/state/replaying.ts";
import { cancel } from "../../web/src/state/showing.ts";
import { loadDocuments } from "../parity/support/planish.ts";
import { decodeLink, encodeLink } from "./support/links.ts";
import { openedPage, pageHere } from "./support/page-here.ts";

const NONE = { across: [false, false, false], turns: [0, 0, 0] };

/** A vault of 21 by 21 points has one mirror plane; this one is beside it. */
const ASIDE = 21 * 7 + 5;
/** This one is on it. */
const ON_PLANE = 21 * 5 + 10;

async function symmetricPage(): Promise<Page> {
  const page = await openedPage("vault");
  const found = await findMirrors(page);
  expect(found).toMatchObject({ ok: true });
  return page;
}

async function lift(page: Page, vertex: number, by: Point): Promise<unknown> {
  const [x, y, z] = shownPoint(page, vertex);
  return setTarget(page, vertex, [x + by[0], y + by[1], z + by[2]]);
}

/** Largest distance of a point's height from that of its images. */
function unevenness(page: Page): number {
  const orbits = page.mesh.value?.symmetry?.orbits ?? new Int32Array();
  const heights = [...orbits].map((_, vertex) => shownPoint(page, vertex)[2]);
  return Math.max(...[...orbits].map((o, v) => Math.abs((heights[o] ?? 0) - (heights[v] ?? 0))));
}

it("all that a mesh has is found, and an edit of one point moves its images alike", async () => {
  const page = await symmetricPage();
  expect(mirrors(page).value).toEqual({ across: [true, false, false], turns: [0, 0, 0] });
  expect(mostImages(page).value).toBe(2);
  expect(await lift(page, ASIDE, [0, 0, 0.2])).toMatchObject({ ok: true });
  expect(page.images.value).toHaveLength(1);
  const { report, shape, handles } = page.history.value?.present ?? {};
  expect(report?.status).toBe("converged");
  expect(handles).toHaveLength(1);
  expect(shape?.moved.length).toBeGreaterThan(2);
  for (const image of page.images.value) expect(shape?.moved).toContain(image);
  expect(unevenness(page)).toBeLessThan(1e-13);
});

it("a mesh that is made flat anew has none, and the page says so", async () => {
  const page = await symmetricPage();
  expect(await planarise(page)).toMatchObject({ ok: true });
  expect(mostImages(page).value).toBe(1);
  expect(page.settings.value?.symmetry ?? []).toEqual([]);
  expect(page.notice.value).toMatch(/^Edits follow no symmetry any more/);
});

it("turns about an axis are followed as well", async () => {
  const page = await openedPage("roof");
  expect(await setMirrors(page, { ...NONE, turns: [0, 0, 2] })).toMatchObject({ ok: true });
  expect(mostImages(page).value).toBe(2);
  expect(await findMirrors(page)).toMatchObject({ ok: true });
  expect(mirrors(page).value).toEqual({ across: [true, true, false], turns: [0, 0, 2] });
  expect(mostImages(page).value).toBe(4);
  const point = page.mesh.value?.symmetry?.orbits.findIndex((orbit, v) => orbit === v && v > 60);
  expect(await lift(page, point ?? 0, [0, 0, 0.2])).toMatchObject({ ok: true });
  expect(page.images.value).toHaveLength(3);
  expect(page.history.value?.present.report.status).toBe("converged");
  expect(unevenness(page)).toBeLessThan(1e-12);
});

it("a point on a mirror plane stays on it", async () => {
  const page = await symmetricPage();
  const [x] = shownPoint(page, ON_PLANE);
  expect(await lift(page, ON_PLANE, [0.1, 0, 0.2])).toMatchObject({ ok: true });
  const row = page.history.value?.present.handles[0];
  expect(row?.target[0]).toBe(x);
  expect(shownPoint(page, ON_PLANE)[0]).toBe(x);
  expect(unevenness(page)).toBeLessThan(1e-13);
});

it("a point that is moved speaks for the image that was moved before", async () => {
  const page = await symmetricPage();
  await lift(page, ASIDE, [0, 0, 0.2]);
  const [image = 0] = page.images.value;
  expect(await lift(page, image, [0, 0, 0.1])).toMatchObject({ ok: true });
  const rows = page.history.value?.present.handles;
  expect(rows?.map(({ vertex }) => vertex)).toEqual([image]);
  expect(await setPinned(page, [ASIDE], true)).toMatchObject({ ok: true });
  expect(page.history.value?.present.handles).toMatchObject([{ vertex: ASIDE, pinned: true }]);
});

it("it is a step of the history, stays after Cancel, and another mesh begins without", async () => {
  const page = await symmetricPage();
  await lift(page, ASIDE, [0, 0, 0.2]);
  const present = page.history.value?.present;
  cancel(page);
  const [row] = present?.handles ?? [];
  if (row) await setTarget(page, row.vertex, row.target);
  expect(page.history.value?.present.shape).toEqual(present?.shape);
  expect(await noMirrors(page)).toMatchObject({ ok: true });
  expect(mostImages(page).value).toBe(1);
  expect(page.history.value?.present.shape.moved.length).toBeLessThan(
    present?.shape.moved.length ?? 0,
  );
  await undo(page);
  expect(mostImages(page).value).toBe(2);
  expect(page.history.value?.present.shape).toEqual(present?.shape);
  await openSample(page, "roof");
  expect(mirrors(page).value).toEqual(NONE);
});

it("what the mesh does not have is refused in words, and nothing has changed", async () => {
  const page = await openedPage("freeform");
  const before = page.history.value?.present;
  const wrong = await setMirrors(page, { ...NONE, turns: [0, 0, 7] });
  expect(wrong?.ok === false && wrong.reason).toMatch(/^The mesh does not have axis:z:7: /);
  expect(page.history.value?.present).toBe(before);
  expect(mostImages(page).value).toBe(1);
  expect(await setMirrors(page, { ...NONE, turns: [0, 0, 1.5] })).toMatchObject({ ok: false });
});

it("variations move both images", async () => {
  const page = await symmetricPage();
  await lift(page, ASIDE, [0, 0, 0.2]);
  const before = page.history.value?.present.shape;
  expect(await explore(page)).toMatchObject({ ok: true });
  await commitVariation(page, 0, 0.6);
  const after = page.history.value?.present.shape;
  expect(after).not.toEqual(before);
  expect(unevenness(page)).toBeLessThan(1e-9);
});

it("its link is the same design in another page, to the last bit", async () => {
  const page = await symmetricPage();
  await lift(page, ASIDE, [0.05, 0, 0.2]);
  const design = page.history.value?.present;
  if (!design) throw new Error("no design");
  const mark = await markOf(page, design.shape);
  if (!mark) throw new Error("no mark");
  const recipe = recipeOf(design, "m", null, mark);
  const link = await encodeLink(recipe);
  const read = await decodeLink(link);
  if (!read.ok) throw new Error(read.reason);
  const other = pageHere();
  expect(await replay(other, read.value)).toBe(true);
  expect(other.history.value?.present.shape).toEqual(design.shape);
  expect(other.notice.value).toMatch(/^Verified/);
  expect(mostImages(other).value).toBe(2);
  // As a file the core writes and reads it.
  const glb = await loadDocuments();
  const again = fromDesign(glb.readDesign(glb.writeDesign(toDesign(recipe))));
  expect(again.ok && again.value.settings.symmetry).toEqual(design.settings.symmetry);
});

describe("what controls show", () => {
  it("is read and written", () => {
    const all = ["x", "z", "axis:y:2", "axis:z:12"];
    const shown = { across: [true, false, true], turns: [0, 2, 12] };
    expect(mirrorsIn(all)).toEqual(shown);
    expect(mirrorsText(shown)).toEqual(all);
    expect(mirrorsText(NONE)).toEqual([]);
  });

  it("images follow those that were changed last", () => {
    const orbits = Int32Array.of(0, 1, 0, 1, 4);
    const row = (vertex: number): HandleRow => ({ vertex, target: [0, 0, 0], pinned: false });
    const before = [row(0), row(1), row(4)];
    const after = [...before, row(2)];
    expect(withoutImages(orbits, before, after).map(({ vertex }) => vertex)).toEqual([1, 4, 2]);
    expect(withoutImages(orbits, [], [row(1), row(3)]).map(({ vertex }) => vertex)).toEqual([3]);
    expect(imagesOf(orbits, [2, 4])).toEqual([0]);
  });
});
