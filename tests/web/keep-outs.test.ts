// SPDX-License-Identifier: MIT
// A design with keep-outs is opened with the solver that knows them, and edits go on with them.
import { describe, expect, it } from "vitest";
import { DEFAULT_SETTINGS, type Point } from "../../web/src/design/design.ts";
import { fromDesign } from "../../web/src/design/design-value.ts";
import {
  firstKeepOut,
  keepOutMoved,
  keepOutText,
  type PlainKind,
  readKeepOut,
} from "../../web/src/design/keep-outs.ts";
import type { Steps } from "../../web/src/design/recipe.ts";
import {
  addContext,
  addKeepOut,
  addModel,
  changeKeepOut,
  heldByKeepOuts,
  keepClear,
  keepOuts,
  movedInView,
  moveKeepOut,
  removeKeepOut,
  removeKeepOuts,
} from "../../web/src/features/keep-outs/keep-outs.ts";
import { refuse } from "../../web/src/result/result.ts";
import { commitSettings, setTarget, shownPoint, undo } from "../../web/src/state/editing.ts";
import { openSample } from "../../web/src/state/opening.ts";
import type { Page } from "../../web/src/state/page.ts";
import { panelsAtLimit } from "../../web/src/state/refused-pull.ts";
import { replay } from "../../web/src/state/replaying.ts";
import { loadDocuments } from "../parity/support/planish.ts";
import { decodeLink, encodeLink } from "./support/links.ts";
import { openedPage, pageHere } from "./support/page-here.ts";
import { vault } from "./support/vault.ts";

/** The middle of the roof, of 21 by 21 points. */
const MIDDLE = 220;
const MODEL = "mesh=0,0,1;1,0,1;1,1,0.5;-0.001,1,1/0,1,2;0,2,3";
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
  const read = fromDesign((await loadDocuments()).readDesign(JSON.stringify(design)));
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
    keepOuts: ["below=0", "plane=0,0.5,-0.001,4", "box=-1,0,0.5,2,1,3.25", "self", MODEL],
    clearance: 0.125,
    limits: ["fold=+5"],
    constraints: ["circular:1e-9"],
  };
  const read = await decodeLink(await encodeLink(vault(21, settings)));
  expect(read.ok && read.value.settings).toEqual(settings);
});

describe("keep-outs as text", () => {
  it("are read back as they were written, and nothing else is read", () => {
    for (const text of [
      "below=0",
      "above=3.25",
      "plane=0,0.5,-0.001,4",
      "box=-1,0,0.5,2,1,3",
      "self",
      "mesh=0,0,1;1,0,1;1,1,0.5;0,1,1/0,1,2;0,2,3",
    ])
      expect(keepOutText(readKeepOut(text) ?? { kind: "self", numbers: [] })).toBe(text);
    for (const text of [
      "",
      "below",
      "below=",
      "below=1,2",
      "box=1,2,3",
      "self=1",
      "above=x",
      "under=1",
      "mesh",
      "mesh=0,0,0;1,0,0;1,1,0",
      "mesh=0,0,0;1,0,0;1,1,0/0,1",
      "mesh=0,0,0;1,0,0;1,1,0/0,1,3",
      "mesh=0,0;1,0;1,1/0,1,2",
      "mesh=0,0,0;1,0,0;1,1,0/0,1,2/",
    ])
      expect(readKeepOut(text), text).toBeNull();
  });

  it("move as a whole", () => {
    const moved = (text: string, ...by: readonly [number, number, number]): string => {
      const read = readKeepOut(text);
      return read ? keepOutText(keepOutMoved(read, by)) : "";
    };
    expect(moved("below=1", 5, 6, 0.5)).toBe("below=1.5");
    expect(moved("plane=0,2,0,8", 1, 3, 9)).toBe("plane=0,2,0,14");
    expect(moved("box=0,0,0,1,2,3", 1, -1, 0.5)).toBe("box=1,-1,0.5,2,1,3.5");
    expect(moved("self", 1, 1, 1)).toBe("self");
    expect(moved("mesh=0,0,1;1,0,1;1,1,1/0,1,2", 1, 0, -1)).toBe("mesh=1,0,0;2,0,0;2,1,0/0,1,2");
  });

  it("begin beside the structure, a plane through three chosen points", () => {
    const extent = { low: [0, 0, 0.12], high: [10, 8, 3.14] } as const;
    const first = (kind: PlainKind, chosen: readonly Point[] = []): string =>
      keepOutText(firstKeepOut(kind, { extent, chosen, step: 0.1 }));
    expect(first("below")).toBe("below=0.1");
    expect(first("above")).toBe("above=3.2");
    expect(first("plane")).toBe("plane=1,0,0,10");
    expect(
      first("plane", [
        [0, 0, 1],
        [0, 1, 1],
        [1, 0, 1],
      ]),
    ).toBe("plane=0,0,1,1");
    expect(
      first("plane", [
        [0, 0, 1],
        [1, 0, 1],
        [2, 0, 1],
      ]),
    ).toBe("plane=1,0,0,10");
    expect(first("box", [[1, 1, 1]])).toBe("box=0,0,2,2,2,4");
  });
});

/** A square slab over the middle of the roof, whose first point no panel has. */
async function slab(name = "beam.obj"): Promise<{ file: File; level: number }> {
  const [x, y, z] = await middle();
  const level = z + 0.15;
  const corners = [
    [x - 9, y - 9],
    [x + 9, y - 9],
    [x + 9, y + 9],
    [x - 9, y + 9],
  ];
  const points = corners.map((corner) => `v ${corner.join(" ")} ${level}`);
  const text = ["v 0 0 0", ...points, "f 2 3 4 5", ""].join("\n");
  return { file: new File([text], name), level };
}

describe("a model from a file", () => {
  it("is kept out of, and makes no other base", async () => {
    const page = await openedPage();
    const base = page.mesh.value;
    const { file, level } = await slab();
    expect(await addModel(page, file)).toMatchObject({ ok: true });
    expect(page.mesh.value).toBe(base);
    expect(keepOuts(page).value).toHaveLength(1);
    expect(keepOuts(page).value[0]?.panels).toEqual([[0, 1, 2, 3]]);
    const [x, y, z] = await middle();
    await setTarget(page, MIDDLE, [x, y, z + 0.6]);
    expect(height(page)).toBeLessThanOrEqual(level + 1e-9);
    expect(height(page)).toBeGreaterThan(z + 0.05);
    expect(heldByKeepOuts(page)).toContain(MIDDLE);
    await moveKeepOut(page, 0, [0, 0, 0.2]);
    expect(height(page)).toBeGreaterThan(level);
    expect(height(page)).toBeLessThanOrEqual(level + 0.2 + 1e-9);
  });

  it("that cannot be read is refused by its name, and nothing has changed", async () => {
    const page = await openedPage();
    const wrong = new File(["v 0 0 0\nf 1 2 3\n"], "broken.obj");
    const reason = async (file: File): Promise<string> => {
      const end = await addModel(page, file);
      return end && !end.ok ? end.reason : "";
    };
    expect(await reason(wrong)).toMatch(/^broken\.obj: /);
    expect(await reason(new File([""], "roof.dwg"))).toMatch(/^roof\.dwg cannot be read/);
    expect(keepOuts(page).value).toEqual([]);
    expect(page.mesh.value).not.toBeNull();
  });
});

describe("what lies beside the panels of a file", () => {
  /** A square of two triangles and one without area, seen from the middle of the roof. */
  function wallAt(z: number): Float64Array {
    const [a, b, c, d] = [
      [-50, -50, z],
      [50, -50, z],
      [50, 50, z],
      [-50, 50, z],
    ]; // prettier-ignore
    return Float64Array.from([a, b, c, a, c, d, a, a, b].flatMap((corner) => corner ?? []));
  }
  async function pageWithContext(triangles: Float64Array): Promise<Page> {
    const page = await openedPage();
    const source = page.draft.value?.source;
    if (!source) throw new Error("no design");
    const empty = new Float64Array();
    const context = { count: 1, lines: empty, triangles, points: empty };
    page.contexts.value = new Map([[source, context]]);
    return page;
  }

  it("becomes a keep-out, its corners joined, and holds an edit back", async () => {
    const [x, y, z] = await middle();
    const page = await pageWithContext(wallAt(z + 0.1));
    expect(await addContext(page)).toMatchObject({ ok: true });
    expect(keepOuts(page).value).toMatchObject([
      {
        kind: "mesh",
        panels: [
          [0, 1, 2],
          [0, 2, 3],
        ],
      },
    ]); // prettier-ignore
    expect(keepOuts(page).value[0]?.numbers).toHaveLength(12);
    await setTarget(page, MIDDLE, [x, y, z + 0.5]);
    expect(shownPoint(page, MIDDLE)[2]).toBeLessThanOrEqual(z + 0.1 + 1e-9);
    expect(page.figures.value.movedVertices).toBeGreaterThan(0);
  });

  it("without surfaces it is none, and that is said", async () => {
    const page = await pageWithContext(new Float64Array());
    expect(await addContext(page)).toMatchObject({ ok: false });
    expect(keepOuts(page).value).toEqual([]);
    expect(page.problem.value).toMatch(/^A model needs panels/);
  });
});

describe("keep-outs of a page", () => {
  it("are added beside the design, changed, moved, refused and removed, a step each", async () => {
    const page = await openedPage();
    const texts = (): readonly string[] => page.draft.value?.settings.keepOuts ?? [];
    await addKeepOut(page, "above");
    const roof = Math.max(...(page.mesh.value?.positions ?? []).filter((_, k) => k % 3 === 2));
    const ceiling = keepOuts(page).value[0]?.numbers[0] ?? 0;
    expect(ceiling).toBeGreaterThanOrEqual(roof);
    expect(ceiling).toBeLessThan(roof + 0.2);
    await keepClear(page, 0.02);
    await addKeepOut(page, "box");
    expect(texts()).toHaveLength(2);
    const wrong = await changeKeepOut(page, 1, { kind: "box", numbers: [1, 0, 0, 0, 1, 1] });
    expect(wrong).toEqual(
      refuse("The first corner must be lower than the second along X, Y and Z."),
    );
    expect((await keepClear(page, -1))?.ok).toBe(false);
    expect(page.draft.value?.settings.clearance).toBe(0.02);
    await moveKeepOut(page, 0, [1, 1, 0.5]);
    expect(keepOuts(page).value[0]?.numbers[0]).toBeCloseTo(ceiling + 0.5, 12);
    await undo(page);
    expect(keepOuts(page).value[0]?.numbers[0]).toBe(ceiling);
    movedInView(page).value = 1;
    await removeKeepOut(page, 1);
    expect(movedInView(page).value).toBeNull();
    expect(texts()).toEqual([`above=${ceiling}`]);
    await removeKeepOuts(page);
    expect(texts()).toEqual([]);
    expect(page.draft.value?.settings.clearance).toBe(0);
  });

  it("say which points they hold back, which are no panels at a limit", async () => {
    const page = await openedPage();
    const [x, y, z] = await middle();
    await commitSettings(page, { keepOuts: [`above=${z + 0.05}`, "self"], limits: ["fold=+20"] });
    await setTarget(page, MIDDLE, [x, y, z + 0.8]);
    expect(page.problem.value).toBeNull();
    expect(heldByKeepOuts(page)).toContain(MIDDLE);
    expect(panelsAtLimit(page).value).not.toContain(MIDDLE);
  });
});
