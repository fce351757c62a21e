// SPDX-License-Identifier: MIT
// Designs with cuts: the page has none of its own yet, but opens them, edits what they leave, and keeps them
// through undo, links, snapshots, saved designs and making the mesh flat.
import { describe, expect, it } from "vitest";
import { DEFAULT_SETTINGS, settingsForNew } from "../../web/src/design/design.ts";
import { fromDesign, toDesign } from "../../web/src/design/design-value.ts";
import { recipeOf, type Steps } from "../../web/src/design/recipe.ts";
import { readSettings } from "../../web/src/design/v1/settings.ts";
import { findMirrors } from "../../web/src/features/symmetry/symmetry.ts";
import { redo, setTarget, shownPoint, undo } from "../../web/src/state/editing.ts";
import { readMark } from "../../web/src/state/marking.ts";
import { openSample, planarise } from "../../web/src/state/opening.ts";
import type { Page } from "../../web/src/state/page.ts";
import { replay } from "../../web/src/state/replaying.ts";
import { cancel } from "../../web/src/state/showing.ts";
import { loadDocuments } from "../parity/support/planish.ts";
import { decodeLink, encodeLink } from "./support/links.ts";
import { openedPage, pageHere } from "./support/page-here.ts";

const documents = await loadDocuments();

const CUTS = ["strip=135-136@0.25", "corner=100:106", "refine=20,21:collar"];
/** Added by the strip. */
const ADDED = 261;

function recipe(more: object = {}): Steps {
  const head = { format: "planish-design", version: 1, source: { sample: "vault", size: 16 } };
  const text = JSON.stringify({ ...head, cuts: CUTS, ...more });
  const read = fromDesign(documents.readDesign(text));
  if (!read.ok || !read.value.source) throw new Error(read.ok ? "no source" : read.reason);
  return { ...read.value, source: read.value.source, camera: null };
}

/** A line of the file's mesh, divided by the strip, and a handle on another of its points. */
const EDITED = {
  handles: [[ADDED, 7.25, 5.1, 3.4]],
  supports: ["polyline:135,136,137"],
  options: { shape: true, softness: 4, bounds: ["fold=+8"] },
};

async function cutPage(more: object = EDITED): Promise<Page> {
  const page = pageHere();
  expect(await replay(page, recipe(more))).toBe(true);
  return page;
}

async function linkOf(page: Page): Promise<string> {
  const design = page.history.value?.present;
  const mark = design && (await readMark(page, design.shape));
  if (!design || !mark?.ok) throw new Error("no design");
  return encodeLink(recipeOf(design, "m", null, mark.value));
}

const cutsIn = (page: Page) => page.settings.value?.cuts;

describe("a design with cuts", () => {
  it("opens as the mesh that they leave, and is edited there", async () => {
    const page = await cutPage();
    expect(page.problem.value).toBeNull();
    expect(page.mesh.value?.report.vertices).toBeGreaterThan(256 + 16);
    expect(page.history.value?.present.report.movedVertices).toBeGreaterThan(0);
    const [x, y, z] = shownPoint(page, ADDED);
    expect(await setTarget(page, ADDED, [x, y, z + 0.2])).toMatchObject({ ok: true });
    expect(cutsIn(page)).toEqual(CUTS);
  });

  it("is the same in a link, in another page, to the last bit", async () => {
    const page = await cutPage();
    const read = await decodeLink(await linkOf(page));
    if (!read.ok) throw new Error(read.reason);
    const other = pageHere();
    expect(await replay(other, read.value)).toBe(true);
    expect(other.notice.value).toMatch(/^Verified/);
    expect(cutsIn(other)).toEqual(CUTS);
    expect(other.history.value?.present.shape).toEqual(page.history.value?.present.shape);
  });

  it("is the same as text that the core writes and reads", async () => {
    const page = await cutPage();
    const design = page.history.value?.present;
    const mark = design && (await readMark(page, design.shape));
    if (!design || !mark?.ok) throw new Error("no design");
    const value = toDesign(recipeOf(design, "m", null, mark.value));
    const text = documents.writeDesign(value);
    expect(JSON.parse(text).cuts).toEqual(CUTS);
    const again = fromDesign(documents.readDesign(text));
    expect(again.ok && again.value.settings).toEqual(design.settings);
  });

  it("is one step that Undo takes back, and Redo brings its cuts again", async () => {
    const page = await openedPage("roof");
    const points = page.mesh.value?.report.vertices;
    expect(await replay(page, recipe(EDITED))).toBe(true);
    const cut = page.mesh.value?.report.vertices;
    const { shape } = page.history.value?.present ?? {};
    await undo(page);
    expect([cutsIn(page), page.mesh.value?.report.vertices]).toEqual([[], points]);
    await redo(page);
    expect([cutsIn(page), page.mesh.value?.report.vertices]).toEqual([CUTS, cut]);
    expect(page.history.value?.present.shape).toEqual(shape);
    await undo(page);
    await openSample(page, "vault");
    expect(cutsIn(page)).toEqual([]);
  });

  it("is still there after Cancel", async () => {
    const page = await cutPage();
    const before = await linkOf(page);
    cancel(page);
    expect(await linkOf(page)).toBe(before);
    const [x, y, z] = shownPoint(page, ADDED);
    expect(await setTarget(page, ADDED, [x, y, z + 0.1])).toMatchObject({ ok: true });
  });

  it("keeps them where its mesh is made flat again", async () => {
    const page = await cutPage({});
    expect(await planarise(page)).toMatchObject({ ok: true });
    expect(cutsIn(page)).toEqual(CUTS);
    const read = await decodeLink(await linkOf(page));
    const other = pageHere();
    expect(read.ok && (await replay(other, read.value))).toBe(true);
    expect(other.mesh.value?.positions).toEqual(page.mesh.value?.positions);
  });

  it("has no symmetry that its cuts have not, which is said", async () => {
    const page = await cutPage({});
    const answer = await findMirrors(page);
    expect(answer?.ok === false && answer.reason).toMatch(/cuts are not symmetric/);
    expect(cutsIn(page)).toEqual(CUTS);
  });

  it("that cannot be made is refused in one sentence, and nothing has changed", async () => {
    const page = await openedPage("roof");
    const before = page.history.value?.present;
    expect(
      await replay(page, {
        ...recipe(),
        settings: { ...recipe().settings, cuts: ["corner=999:1"] },
      }),
    ).toBe(false);
    expect(page.problem.value).toMatch(
      /^Cuts: corner=999:1: there is no panel 999: panels are 0 to 224\./,
    );
    expect(page.history.value?.present).toBe(before);
  });
});

describe("as settings", () => {
  it("no other text is one in a link of version 1", () => {
    const packed = [1000, 1, 1, "second", "newton"];
    expect(readSettings([...packed, ["cut=strip=1-2"]])?.cuts).toEqual(["strip=1-2"]);
    for (const text of ["cut=saw=1", "cut=strip=<b>", "cut=", "cut=strip="])
      expect(readSettings([...packed, [text]])).toBeNull();
  });

  it("another mesh has none of them", () => {
    expect(settingsForNew({ ...DEFAULT_SETTINGS, cuts: CUTS }).cuts).toEqual([]);
  });
});
