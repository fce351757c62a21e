// SPDX-License-Identifier: MIT
// What travels beside a design comes back as it was; what is wrong with it costs the design nothing.
import { inflateRawSync } from "node:zlib";
import { effect } from "@preact/signals";
import { describe, expect, it } from "vitest";
import { readBeside, withBeside } from "../../web/src/design/beside-text.ts";
import {
  type Companions,
  readCompanions,
  writeCompanions,
} from "../../web/src/design/companions.ts";
import { recipeOf, stepsOf } from "../../web/src/design/recipe.ts";
import { variantJson } from "../../web/src/design/variant-text.ts";
import { companionsOf, EVERYTHING, NOTHING } from "../../web/src/export/companions.ts";
import { onChanges } from "../../web/src/state/connection.ts";
import { setTarget, shownPoint } from "../../web/src/state/editing.ts";
import { openFile } from "../../web/src/state/files.ts";
import { readMark } from "../../web/src/state/marking.ts";
import { note } from "../../web/src/state/note.ts";
import { openSample } from "../../web/src/state/opening.ts";
import type { Page } from "../../web/src/state/page.ts";
import { arrivedNote } from "../../web/src/state/receiving.ts";
import { replay } from "../../web/src/state/replaying.ts";
import { cancel } from "../../web/src/state/showing.ts";
import { takeSnapshot } from "../../web/src/state/snapshots.ts";
import { GOLDEN_LINKS } from "./support/golden-links.ts";
import { decodeLink, encodeLink, linkText, readText } from "./support/links.ts";
import { openedPage, pageHere } from "./support/page-here.ts";

const MIDDLE = 220;
const CAMERA = { position: [1, 2, 3], target: [0, 0, 0.5] } as const;
const VIEW = { name: "From the street", camera: CAMERA };

async function raise(page: Page, by: number): Promise<void> {
  const base = page.mesh.value?.positions.slice(3 * MIDDLE, 3 * MIDDLE + 3) ?? [];
  await setTarget(page, MIDDLE, [base[0] ?? 0, base[1] ?? 0, (base[2] ?? 0) + by]);
}

/** A mesh of a file, 17 × 17 points: every panel is flat. */
function translated(): File {
  const side = Array.from({ length: 17 }, (_, k) => k);
  const points = side.flatMap((y) =>
    side.map((x) => `v ${x} ${y} ${-0.03 * (x - 8) ** 2 - 0.02 * (y - 8) ** 2}`),
  );
  const faces = side.slice(1).flatMap((j) =>
    side.slice(1).map((i) => {
      const d = 17 * j + i + 1;
      return `f ${d - 18} ${d - 17} ${d} ${d - 1}`;
    }),
  );
  return new File([[...points, ...faces].join("\n")], "translated.obj");
}

async function withFile(): Promise<Page> {
  const page = pageHere();
  await openFile(page, translated());
  return page;
}

/** A roof, or another mesh, with a note, a view and three variants; the last is shown. */
async function author(open: () => Promise<Page> = openedPage): Promise<Page> {
  const page = await open();
  for (const [k, by] of [0.2, 0.4, 0.6].entries()) {
    await raise(page, by);
    await takeSnapshot(page, `Variant ${k + 1}`);
  }
  note(page).value = "Middle raised.\nPlease choose <b>one</b>.";
  page.views.value = [VIEW];
  return page;
}

async function linkOf(page: Page, taken = EVERYTHING): Promise<string> {
  const design = page.history.value?.present;
  const mark = design && (await readMark(page, design.shape));
  if (!design || !mark?.ok) throw new Error("no design");
  const companions = await companionsOf(page, taken);
  return encodeLink({ ...recipeOf(design, "m", CAMERA, mark.value), companions });
}

async function openedFrom(link: string): Promise<Page> {
  const read = await decodeLink(link);
  if (!read.ok) throw new Error(read.reason);
  const page = pageHere();
  expect(await replay(page, read.value)).toBe(true);
  return page;
}

describe("what travels beside a design", () => {
  it("is there where the link is opened: note, view, three variants to the bit", async () => {
    const page = await author();
    const other = await openedFrom(await linkOf(page));
    expect(other.problem.value).toBeNull();
    expect(other.notice.value).toMatch(/^Verified: .* With it came a note, 1 view, 3 snapshots\.$/);
    expect(note(other).value).toBe(note(page).value);
    expect(arrivedNote(other).value).toBe(note(page).value);
    expect(other.views.value).toEqual([VIEW]);
    const pairs = page.snapshots.value.map((one, k) => [one, other.snapshots.value[k]] as const);
    expect(pairs).toHaveLength(3);
    for (const [sent, came] of pairs) {
      expect(came?.name).toBe(sent.name);
      expect(came?.design.shape).toEqual(sent.design.shape);
      expect(came?.design.handles).toEqual(sent.design.handles);
    }
    expect(other.draft.value?.shape).toEqual(page.draft.value?.shape);
    // The solver has the design itself open, not the last variant.
    await raise(other, 0.7);
    await raise(page, 0.7);
    expect(shownPoint(other, MIDDLE)).toEqual(shownPoint(page, MIDDLE));
  });

  it("is nothing twice where the link is opened again, and nothing of one's own is lost", async () => {
    const page = await author();
    const read = await decodeLink(await linkOf(page));
    if (!read.ok) throw new Error(read.reason);
    const other = await openedPage();
    note(other).value = "Mine.";
    other.views.value = [{ name: VIEW.name, camera: { ...CAMERA, target: [9, 9, 9] } }];
    await takeSnapshot(other, "Variant 1");
    for (let time = 0; time < 2; ++time) expect(await replay(other, read.value)).toBe(true);
    expect(other.snapshots.value.map(({ name }) => name)).toEqual([
      "Variant 1",
      "Variant 1 2",
      "Variant 2",
      "Variant 3",
    ]);
    expect(other.views.value.map(({ name }) => name)).toEqual([VIEW.name, `${VIEW.name} 2`]);
    expect(note(other).value).toBe(`${note(page).value}\n\nMine.`);
  });

  it("is only what is wanted, and of this mesh", async () => {
    const page = await author();
    const all = await linkOf(page);
    const none = await linkOf(page, NOTHING);
    expect(none.length).toBeLessThan(all.length - 100);
    const bare = await decodeLink(none);
    expect(bare.ok && bare.value.companions).toBeUndefined();
    await openSample(page, "vault");
    expect((await companionsOf(page, EVERYTHING)).variants).toEqual([]);
  });
});

describe("of what travels beside a design", () => {
  it("whatever is damaged or hostile costs the design nothing", async () => {
    const page = await author();
    const whole = await companionsOf(page, EVERYTHING);
    const json = JSON.parse(JSON.stringify(writeCompanions(whole, [])));
    expect(readCompanions(json, whole.variants)).toEqual(whole);
    const long = "x".repeat(5000);
    const odd: unknown[] = [
      null,
      7,
      "note",
      [],
      {},
      { n: 7, v: 7, s: 7 },
      { v: [[1, 2], ["a", 1], null] },
      { v: [["a", 1, 2, 3, 4, 5, Number.NaN]] },
    ];
    for (const one of odd) expect(readCompanions(one, []), JSON.stringify(one)).toBeUndefined();
    expect(readCompanions({ n: long }, [])?.note).toHaveLength(2000);
    const many = Array.from({ length: 99 }, (_, k) => [`v${k}`, 1, 2, 3, 4, 5, 6]);
    expect(readCompanions({ v: many }, [])?.views).toHaveLength(50);
  });

  it("at most twenty variants are read, and none that is not whole", async () => {
    const page = await author();
    const { variants } = await companionsOf(page, EVERYTHING);
    const design = page.history.value?.present;
    const [first] = variants;
    if (!design || !first) throw new Error("no variant");
    const recipe = { ...recipeOf(design, "m", null, first.steps.mark), ...first.steps };
    const whole = variantJson("one", await linkText(recipe));
    const beside = (s: unknown) => readBeside(JSON.stringify({ page: { n: "a", s } }), readText);
    const read = await beside([whole]);
    expect(read.companions?.variants).toEqual([
      { name: "one", steps: expect.objectContaining({ ...variants[0]?.steps }) },
    ]);
    expect((await beside(Array(99).fill(whole))).companions?.variants).toHaveLength(20);
    const { n: _, ...nameless } = whole;
    const odd = [null, {}, { n: "a" }, { n: "a", w: [] }, nameless, { ...whole, handles: "none" }];
    const unmarked = { ...whole, result: undefined };
    expect((await beside([...odd, unmarked])).companions?.variants).toEqual([]);
  });

  it("what an earlier page saved opens, its variants packed", async () => {
    const golden = GOLDEN_LINKS.find(({ name }) => name === "what travels beside it");
    const bytes = inflateRawSync(Buffer.from(golden?.link.slice(4) ?? "", "base64url"));
    const { a } = JSON.parse(bytes.subarray(8, 8 + bytes.readUInt32LE(4)).toString());
    const read = await readBeside(JSON.stringify({ page: a }), readText);
    expect(read.companions).toEqual(golden?.recipe.companions);
    expect(read.companions?.variants).toHaveLength(2);
  });

  it('a saved design holds all under "page", beside numbers that stay as they were written', async () => {
    const page = await author();
    const design = page.history.value?.present;
    const mark = design && (await readMark(page, design.shape));
    if (!design || !mark?.ok) throw new Error("no design");
    const recipe = recipeOf(design, "m", null, mark.value);
    const variants = [variantJson("now", await linkText(recipe))];
    const companions: Companions = {
      note: "A } in a note",
      views: [VIEW],
      variants: [{ name: "now", steps: expect.objectContaining(stepsOf(design, mark.value)) }],
      section: { axis: 2, at: 1.25, flipped: true },
      groups: [{ name: "Ridge", of: "points", members: [4, 5, 90], colour: null }],
    };
    const text = '{"format": "planish-design",\n "x": 0.1000000000000000055511151231257827}\n';
    const saved = withBeside(text, { camera: CAMERA, companions }, variants);
    expect(saved).toContain('"x": 0.1000000000000000055511151231257827,\n "page": {');
    expect(await readBeside(saved, readText)).toEqual({ camera: CAMERA, companions });
    expect(withBeside(text, { camera: null, companions: undefined }, [])).toBe(text);
    for (const odd of ["", '"page"', '{"page": 1}', '{"page": {"c": "no"}', text])
      expect(await readBeside(odd, readText)).toEqual({ camera: null, companions: undefined });
  });
});

describe("snapshots that travel with a design", () => {
  it("come after the design, which is there to be looked at, and are never drawn", async () => {
    const page = await author();
    const read = await decodeLink(await linkOf(page));
    if (!read.ok) throw new Error(read.reason);
    const other = await openedPage();
    await openSample(other, "vault");
    const labels: string[] = [];
    const drawn: { label: string; within: boolean }[] = [];
    other.activity.subscribe((activity) => {
      if (!activity || labels.at(-1) === activity.label) return;
      labels.push(activity.label);
      if (!activity.label.startsWith("opening snapshot")) return;
      expect(other.draft.value?.shape).toEqual(page.draft.value?.shape);
      expect(other.mesh.value?.report.vertices).toBe(page.mesh.value?.report.vertices);
    });
    onChanges(other, (changes) => {
      const points = other.mesh.value?.report.vertices ?? 0;
      const within = changes.every((value, k) => k % 4 !== 0 || value < points);
      drawn.push({ label: other.activity.value?.label ?? "", within });
    });
    expect(await replay(other, read.value)).toBe(true);
    expect(labels.filter((label) => label.startsWith("opening snapshot"))).toEqual(
      [1, 2, 3].map((k) => `opening snapshot ${k} of 3`),
    );
    expect(drawn.every(({ within }) => within)).toBe(true);
    expect(drawn.filter(({ label }) => label.startsWith("opening snapshot"))).toEqual([]);
    expect(other.draft.value?.shape).toEqual(page.draft.value?.shape);
  });

  it("of a file's mesh never make the status count points of another mesh than that in view", async () => {
    const page = await author(withFile);
    const read = await decodeLink(await linkOf(page));
    if (!read.ok) throw new Error(read.reason);
    const other = await openedPage();
    const counts: (readonly [inView: number, counted: number, moved: number])[] = [];
    const stop = effect(() => {
      const inView = (other.displayMesh.value?.display.length ?? 0) / 3;
      const counted = other.mesh.value?.report.vertices ?? 0;
      counts.push([inView, counted, other.figures.value.movedVertices]);
    });
    let designThere = false;
    other.activity.subscribe((activity) => {
      if (!activity?.label.startsWith("opening snapshot")) return;
      designThere = true;
      expect(other.mesh.value?.report.vertices).toBe(17 * 17);
      expect(other.draft.value?.shape).toEqual(page.draft.value?.shape);
    });
    expect(await replay(other, read.value)).toBe(true);
    stop();
    expect(designThere).toBe(true);
    expect(other.snapshots.value.map(({ name }) => name)).toHaveLength(3);
    // Of the sample, then of the file, at no time of both.
    expect(new Set(counts.map(([inView]) => inView)).size).toBe(2);
    expect(counts.at(-1)?.[0]).toBe(17 * 17);
    for (const [inView, counted, moved] of counts) {
      expect(counted).toBe(inView);
      expect(moved).toBeLessThanOrEqual(inView);
    }
  });

  it("leave the design there where somebody cancels before all snapshots are there", async () => {
    const page = await author();
    const read = await decodeLink(await linkOf(page));
    if (!read.ok) throw new Error(read.reason);
    const other = await openedPage();
    const stop = other.activity.subscribe((activity) => {
      if (activity?.label === "opening snapshot 2 of 3") queueMicrotask(() => cancel(other));
    });
    await replay(other, read.value);
    stop();
    expect(other.problem.value).toBeNull();
    expect(other.draft.value?.shape).toEqual(page.draft.value?.shape);
    expect(other.snapshots.value.map(({ name }) => name)).toEqual(["Variant 1"]);
    expect(other.notice.value).toMatch(/2 snapshots could not be made again\.$/);
    await raise(other, 0.7);
    await raise(page, 0.7);
    expect(shownPoint(other, MIDDLE)).toEqual(shownPoint(page, MIDDLE));
  });
});
