// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { NO_REPORT } from "../../web/src/design/design.ts";
import { settledWords } from "../../web/src/features/stopping/settled-words.ts";
import { onChanges } from "../../web/src/state/connection.ts";
import { beginDrag, heldWords, toggleLock, togglePins } from "../../web/src/state/dragging.ts";
import { setPinned } from "../../web/src/state/editing.ts";
import type { Page } from "../../web/src/state/page.ts";
import { selectThese } from "../../web/src/state/selection.ts";
import { lastSettling } from "../../web/src/state/settling.ts";
import { cancel } from "../../web/src/state/showing.ts";
import { moveInFrame, moveTogether } from "../../web/src/state/typed-moves.ts";
import { openedPage } from "./support/page-here.ts";

const MIDDLE = 220;
const frames = (): Promise<unknown> => new Promise((resolve) => setTimeout(resolve, 40));

it("a drag is one step of the history, whatever its frames", async () => {
  const page = await openedPage();
  const drag = beginDrag(page, [MIDDLE]);
  for (let k = 1; k <= 5; ++k) {
    drag?.by([0, 0, 0.04 * k]);
    await frames();
  }
  expect(page.history.value?.past.length).toBe(0);
  expect(page.figures.value.movedVertices).toBeGreaterThan(0);
  await drag?.end();
  expect(page.history.value?.past.length).toBe(1);
  const base = page.mesh.value?.positions ?? [];
  const [row] = page.handles.value;
  // Along x and y nothing was pulled: those coordinates keep their bits.
  expect(row?.target.slice(0, 2)).toEqual([base[3 * MIDDLE], base[3 * MIDDLE + 1]]);
  expect(page.history.value?.present.report.status).toBe("converged");
});

it("one that is given up leaves nothing", async () => {
  const page = await openedPage();
  const before = page.history.value;
  toggleLock(page, "z", false);
  const drag = beginDrag(page, [MIDDLE]);
  toggleLock(page, "x", false);
  drag?.by([0.1, 0, 0]);
  await frames();
  await drag?.abandon();
  expect(page.history.value).toBe(before);
  expect(page.figures.value.movedVertices).toBe(0);
  expect(page.lock.value).toEqual({ axis: "z", plane: false });
});

it("names the limits that panels are at, and no other, and to a finger no key", () => {
  expect(heldWords(["fold"], 10, false)).toBe(
    "Held back: further, panels would fold more than 10° sharper. Shift goes through.",
  );
  expect(heldWords(["fold", "area"], 10, true)).toBe(
    "Held back: further, panels would fold more than 10° sharper, or exceed a limit.",
  );
  expect(heldWords(["area"], 10, false)).toBe("Held back: further, panels would exceed a limit.");
  expect(heldWords(["fold"], Number.POSITIVE_INFINITY, false)).toBe(
    "Held back: further, panels would exceed a limit.",
  );
  const unknown = "Held back: no panel is at a limit, but it was not followed further.";
  expect(heldWords([], 10, false)).toBe(`${unknown} Shift goes through.`);
  expect(heldWords([], 10, true)).toBe(unknown);
  expect(heldWords([], Number.POSITIVE_INFINITY, false)).toBe(unknown);
});

it("is held back before folds sharpen, says so, and Shift goes through", async () => {
  const page = await openedPage();
  const drag = beginDrag(page, [MIDDLE]);
  for (let k = 1; k <= 10; ++k) {
    drag?.by([0, 0, 0.5 * k]);
    await frames();
  }
  await drag?.end();
  expect(page.notice.value).toMatch(/^Held back: /);
  const { sharpestFold } = page.history.value?.present.report ?? {};
  const growth = (sharpestFold?.after ?? 0) - (sharpestFold?.before ?? 0);
  expect(growth).toBeGreaterThan(0);
  expect(growth).toBeLessThanOrEqual(10);
  const through = beginDrag(page, [MIDDLE]);
  through?.by([0, 0, 3], true);
  await frames();
  await through?.end();
  const after = page.history.value?.present.report.sharpestFold;
  expect((after?.after ?? 0) - (after?.before ?? 0)).toBeGreaterThan(10);
});

it("frames go on while the pointer rests, until they settle, and none is of where it was before", async () => {
  const asked: number[] = [];
  const page = await openedPage("roof", (request) => {
    if (request.kind !== "edit" || request.mode !== "drag") return null;
    const [height = 0] = request.targets.handles.slice(3);
    asked.push(height);
    const times = asked.filter((one) => one === height).length;
    const settles = asked[0] !== height && times === 3;
    const report = { ...NO_REPORT, status: settles ? "converged" : "iteration_limit" };
    const changes = Float32Array.of(MIDDLE, 0, 0, asked.length);
    const shown = { kind: "shown", job: request.job, changes, report, shape: null } as const;
    return { ...shown, taken: null, found: [], reach: null, placed: null };
  });
  const drag = beginDrag(page, [MIDDLE]);
  drag?.by([0, 0, 0.1]);
  await expect.poll(() => asked.length).toBeGreaterThan(1);
  drag?.by([0, 0, 0.2]);
  await expect.poll(() => page.figures.value.status).toBe("converged");
  await frames();
  const [first = 0, last = 0] = [asked[0], asked.at(-1)];
  expect(last).toBeCloseTo(first + 0.1, 12);
  expect(asked.slice(asked.indexOf(last))).toEqual([last, last, last]);
});

describe("the end of a drag", () => {
  /** A page with a drag that has frames, and what it is as the release comes to the solver. */
  async function letGo(sample: string, up: number) {
    const last = new Map<number, readonly number[]>();
    const seen = { atRelease: null as null | object, last, frames: 0 };
    let page: Page | null = null;
    const now = (from: Page) => ({
      steps: from.history.value?.past.length,
      recorded: from.history.value?.present.shape.moved.length,
      says: from.activity.value?.label,
      frame: new Map(seen.last),
    });
    page = await openedPage(sample, (request) => {
      if (request.kind === "edit" && request.mode === "release" && page && !seen.atRelease)
        seen.atRelease = now(page);
      return null;
    });
    onChanges(page, (changes) => {
      seen.frames += 1;
      for (let k = 0; k < changes.length; k += 4)
        seen.last.set(changes[k] ?? -1, [...changes.subarray(k + 1, k + 4)]);
    });
    const drag = beginDrag(page, [MIDDLE]);
    for (let k = 1; k <= 4; ++k) {
      drag?.by([0, 0, (up * k) / 4]);
      // A pointer that rests has frames more.
      await expect.poll(() => seen.frames).toBeGreaterThanOrEqual(k);
    }
    return { page, drag, seen, frame: new Map(seen.last) };
  }

  it("keeps the last frame in view until the design is there, and records nothing before", async () => {
    const { page, drag, seen, frame } = await letGo("roof", 0.3);
    const ended = drag?.end();
    expect(seen.last).toEqual(frame);
    await ended;
    expect(seen.atRelease).toEqual({ steps: 0, recorded: 0, says: "computing", frame });
    expect(page.history.value?.past.length).toBe(1);
    expect(page.history.value?.present.report.status).toBe("converged");
  });

  it("can be cancelled: the design is the one before, and is shown again", async () => {
    const { page, drag } = await letGo("roof", 0.3);
    const before = page.history.value;
    void drag?.end();
    cancel(page);
    await expect.poll(() => page.activity.value).toBeNull();
    await expect.poll(() => page.figures.value.movedVertices).toBe(0);
    expect(page.history.value).toBe(before);
  });

  it("may be followed by another drag at once, which keeps to what it settled to", async () => {
    const { page, drag, seen } = await letGo("roof", 3);
    const first = drag?.end();
    await expect.poll(() => seen.atRelease).not.toBeNull();
    const other = beginDrag(page, [MIDDLE + 42]);
    other?.by([0, 0, 0.1]);
    await frames();
    await first;
    const settled = page.history.value?.present.handles[0];
    expect(page.notice.value).toMatch(/^Held back: /);
    await other?.end();
    expect(page.history.value?.past.length).toBe(2);
    expect(page.history.value?.present.handles[0]).toEqual(settled);
  });

  it("notes how far points went on from the last frame, which is little where nothing held it back", async () => {
    const { page, drag, seen, frame } = await letGo("roof", 0.3);
    await drag?.end();
    const { scale } = page.mesh.value?.report ?? { scale: Number.NaN };
    const apart = [...seen.last].map(([vertex, place]) => {
      const before = frame.get(vertex) ?? page.mesh.value?.display.subarray(3 * vertex) ?? [];
      return Math.hypot(...place.map((x, k) => x - (before[k] ?? 0))) / scale;
    });
    const last = lastSettling(page).value;
    expect(last?.design).toBe(page.history.value?.present);
    expect(last?.most).toBeCloseTo(Math.max(...apart), 5);
    expect(last?.pull).toBeCloseTo(0.3, 12);
    expect(last && settledWords(last, "m")).toBeNull();
    expect(last && settledWords({ ...last, most: 0.004 }, "m")).toBe(
      "As it settled, points moved by up to 4.0 mm.",
    );
  });
});

it("pinned points are not dragged, and a mesh that is not ready is not either", async () => {
  const page = await openedPage();
  await setPinned(page, [MIDDLE], true);
  expect(beginDrag(page, [MIDDLE])).toBeNull();
  expect(page.notice.value).toBe(`Point ${MIDDLE} is pinned.`);
  page.ready.value = false;
  expect(beginDrag(page, [MIDDLE + 1])).toBeNull();
});

it("typed amounts move points together, all but the pinned ones", async () => {
  const page = await openedPage();
  await setPinned(page, [MIDDLE + 1], true);
  await moveTogether(page, [MIDDLE, MIDDLE + 1], [0, 0, 0.1]);
  const moved = page.handles.value.filter(({ pinned }) => !pinned);
  expect(moved.map(({ vertex }) => vertex)).toEqual([MIDDLE]);
  selectThese(page, [MIDDLE, MIDDLE + 1]);
  togglePins(page);
  await new Promise((resolve) => setTimeout(resolve, 200));
  expect(page.handles.value.every(({ pinned }) => pinned)).toBe(true);
});

/** How far each handle was asked to go upwards, by vertex. */
const ways = (page: Page): ReadonlyMap<number, number> => {
  const base = page.mesh.value?.positions ?? [];
  return new Map(
    page.handles.value.map(({ vertex, target }) => [
      vertex,
      Number((target[2] - (base[3 * vertex + 2] ?? 0)).toFixed(9)),
    ]),
  );
};

const LINE = [-2, -1, 1, 2, 0].map((k) => MIDDLE + k);

it("with a fall-off a group moves as a bump: the dragged point all the way, the others less", async () => {
  const page = await openedPage();
  page.fallOff.value = 1;
  const drag = beginDrag(page, LINE);
  drag?.by([0, 0, 0.1]);
  await frames();
  await drag?.end();
  const [l2 = 0, l1 = 0, r1 = 0, r2 = 0, middle] = LINE.map((v) => ways(page).get(v));
  expect(middle).toBe(0.1);
  expect(l1).toBeLessThan(0.1);
  expect(l2).toBeLessThan(l1);
  expect(l2).toBeGreaterThan(0);
  expect(r1).toBeGreaterThan(r2);
  // No step of the history more, and nothing that a link does not know: they are plain targets.
  expect(page.history.value?.past.length).toBe(1);
});

it("typed amounts fall off from the middle of the group, and without a fall-off they do not", async () => {
  const page = await openedPage();
  await moveTogether(page, LINE, [0, 0, 0.1]);
  expect([...ways(page).values()]).toEqual(LINE.map(() => 0.1));
  page.fallOff.value = 0.65;
  await moveTogether(page, LINE, [0, 0, -0.1]);
  expect(ways(page).get(MIDDLE)).toBe(0);
  expect(ways(page).get(MIDDLE + 2)).toBeGreaterThan(0);
  await moveInFrame(page, LINE, [0, 0, 0.1]);
  const asked = page.handles.value.find(({ vertex }) => vertex === MIDDLE + 2);
  expect(asked).toBeDefined();
});
