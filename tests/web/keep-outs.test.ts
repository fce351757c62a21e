// SPDX-License-Identifier: MIT
// A design with keep-outs is opened with the solver that knows them, and edits go on with them.
import { expect, it } from "vitest";
import { DEFAULT_SETTINGS } from "../../web/src/design/design.ts";
import { fromDesign } from "../../web/src/design/design-value.ts";
import { decodeLink, encodeLink } from "../../web/src/design/link.ts";
import type { Steps } from "../../web/src/design/recipe.ts";
import { commitSettings, setTarget, shownPoint } from "../../web/src/state/editing.ts";
import { openSample } from "../../web/src/state/opening.ts";
import type { Page } from "../../web/src/state/page.ts";
import { replay } from "../../web/src/state/replaying.ts";
import { loadGlb } from "../parity/support/planish.ts";
import { openedPage, pageHere } from "./support/page-here.ts";

/** The middle of the roof, of 21 by 21 points. */
const MIDDLE = 220;
const ROOF = { sample: "roof", size: 21 };

async function middle(): Promise<readonly [number, number, number]> {
  const page = await openedPage();
  const [x = 0, y = 0, z = 0] = page.mesh.value?.positions.slice(3 * MIDDLE, 3 * MIDDLE + 3) ?? [];
  return [x, y, z];
}

/** The middle of the roof is pulled through a ceiling: the design as it is read from a file. */
async function underACeiling(): Promise<{ recipe: Steps; ceiling: number }> {
  const [x, y, z] = await middle();
  const ceiling = z + 0.1;
  const design = {
    format: "planish-design",
    version: 1,
    source: ROOF,
    handles: [[MIDDLE, x, y, z + 0.4]],
    options: { shape: true, keep_out: [`above=${ceiling}`], clearance: 0.02 },
  };
  const read = fromDesign((await loadGlb()).readDesign(JSON.stringify(design)));
  if (!read.ok || !read.value.source) throw new Error("not read");
  return { recipe: { ...read.value, source: read.value.source, camera: null }, ceiling };
}

/** Of the middle, as it is shown. */
const height = (page: Page): number => shownPoint(page, MIDDLE)[2];

it("opens a design with keep-outs, and keeps to them", async () => {
  const page = await openedPage("vault");
  const { recipe, ceiling } = await underACeiling();
  expect(await replay(page, recipe)).toBe(true);
  expect(page.problem.value).toBeNull();
  const settings = page.draft.value?.settings;
  expect(settings?.keepOuts).toEqual([`above=${ceiling}`]);
  expect(settings?.clearance).toBe(0.02);
  expect(page.draft.value?.report.status).toBe("converged");
  expect(page.draft.value?.report.movedVertices).toBeGreaterThan(0);
  expect(height(page)).toBeLessThanOrEqual(ceiling - 0.02 + 1e-9);
});

it("edits go on with them, and another mesh begins without", async () => {
  const page = pageHere();
  const { recipe, ceiling } = await underACeiling();
  expect(await replay(page, recipe)).toBe(true);
  const [x, y, z] = await middle();
  await setTarget(page, MIDDLE, [x, y, z + 0.8]);
  expect(page.problem.value).toBeNull();
  expect(height(page)).toBeLessThanOrEqual(ceiling - 0.02 + 1e-9);
  await commitSettings(page, { keepOuts: [] });
  expect(height(page)).toBeGreaterThan(ceiling);
  await openSample(page, "vault");
  expect(page.draft.value?.settings.keepOuts).toEqual([]);
});

it("a link and a saved design hold them", async () => {
  const settings = {
    ...DEFAULT_SETTINGS,
    keepOuts: ["below=0", "plane=0,0.5,-1e-3,4", "box=-1,0,0.5,2,1,3.25"],
    clearance: 0.125,
    limits: ["fold=+5"],
    constraints: ["circular:1e-9"],
  };
  const recipe = {
    source: { kind: "sample", name: "vault", size: 21 },
    planarised: null,
    handles: [],
    settings,
    families: [],
    unit: "m",
    camera: null,
    mark: { hash: 1, moved: 0, probes: [] },
  } as const;
  const read = await decodeLink(await encodeLink(recipe));
  expect(read.ok && read.value.settings).toEqual(settings);
});
