// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import {
  client,
  frame,
  held,
  onChanges,
  run,
  solverIsThere,
} from "../../web/src/state/connection.ts";
import {
  commitSettings,
  editQuestion,
  setTarget,
  shownPoint,
} from "../../web/src/state/editing.ts";
import { Page } from "../../web/src/state/page.ts";
import { cancel } from "../../web/src/state/showing.ts";
import { type Fate, openedPage, pageHere } from "./support/page-here.ts";

const MIDDLE = 220;
/** Of the same roof, on its boundary. */
const ON_RIM = 10;

async function lift(page: Page, by: number): Promise<void> {
  const [x, y, z] = shownPoint(page, MIDDLE);
  await setTarget(page, MIDDLE, [x, y, z + by]);
}

it("says when the solver cannot be had", async () => {
  const gone = () => Promise.reject(new Error("No network."));
  const page = new Page(gone);
  expect(await solverIsThere(page)).toBe(false);
  expect(page.stranded.value).toBe(true);
  expect(page.problem.value).toBe("No network.");
});

it("tells what runs while it runs, and nothing after", async () => {
  const page = await openedPage();
  const edit = lift(page, 0.2);
  await new Promise((resolve) => setTimeout(resolve, 5));
  expect(page.activity.value?.label).toBe("computing");
  expect(page.busy.value).toBe(true);
  await edit;
  await Promise.resolve();
  expect(page.activity.value).toBeNull();
  expect(page.busy.value).toBe(false);
});

it("hands on what moves, vertex and place each", async () => {
  const page = await openedPage();
  const moved = new Set<number>();
  const stop = onChanges(page, (changes) => {
    for (let k = 0; k < changes.length; k += 4) moved.add(changes[k] ?? -1);
  });
  await lift(page, 0.2);
  stop();
  expect([...moved].sort((a, b) => a - b)).toEqual([
    ...(page.history.value?.present.shape.moved ?? []),
  ]);
  const before = moved.size;
  await lift(page, 0.1);
  expect(moved.size).toBe(before);
});

it("points on a surface are the whole solver's, which takes the edit over", async () => {
  const page = await openedPage();
  await lift(page, 0.2);
  expect(await commitSettings(page, { supports: ["surface:boundary"] })).toMatchObject({
    ok: true,
  });
  const [x, y, z] = shownPoint(page, ON_RIM);
  await setTarget(page, ON_RIM, [x + 0.2, y, z]);
  const { report, shape } = page.history.value?.present ?? {};
  expect(report?.status).toBe("converged");
  expect(shape?.moved).toContain(ON_RIM);
  expect(shape?.moved).toContain(MIDDLE);
});

it("of frames that wait only the newest is asked", async () => {
  const asked: number[] = [];
  const page = await openedPage("roof", (request) => {
    if (request.kind === "edit") asked.push(request.targets.handles[3] ?? 0);
    return null;
  });
  const design = page.draft.value;
  const [x, y, z] = shownPoint(page, MIDDLE);
  if (!design) throw new Error("no design");
  const frames = [1, 2, 3, 4].map((k) => {
    const target = [x, y, z + 0.02 * k] as const;
    const next = { ...design, handles: [{ vertex: MIDDLE, target, pinned: false }] };
    return frame(page, editQuestion(next, "drag"));
  });
  const answers = await Promise.all(frames);
  expect(answers.at(-1)?.kind).toBe("shown");
  expect(asked.length).toBeLessThan(4);
  expect(asked.at(-1)).toBe(z + 0.08);
  expect(page.problem.value).toBeNull();
});

it("a solver that dies of an edit is replaced, and the last design is back", async () => {
  let dying = false;
  const fate: Fate = ({ kind, job }) =>
    dying && kind === "edit" ? { kind: "failed", job, message: "It stopped.", fatal: true } : null;
  const page = await openedPage("roof", fate);
  await lift(page, 0.2);
  const kept = page.history.value?.present;
  dying = true;
  await lift(page, 0.1);
  dying = false;
  await expect.poll(() => page.busy.value).toBe(false);
  expect(page.history.value?.present).toBe(kept);
  expect(page.draft.value).toBe(kept);
  expect(page.problem.value).toBe("It stopped.");
  await lift(page, 0.1);
  expect(page.problem.value).toBeNull();
  expect(page.history.value?.past.length).toBe(2);
});

it("one that dies whatever it is told is not started for ever", async () => {
  let dead = false;
  let starts = 0;
  const page = await openedPage("roof", ({ kind, job }) => {
    if (!dead) return null;
    if (kind === "open") starts += 1;
    return { kind: "failed", job, message: "It stopped.", fatal: true };
  });
  dead = true;
  await lift(page, 0.2);
  await expect.poll(() => page.problem.value).toMatch(/keeps stopping/);
  expect(starts).toBeLessThanOrEqual(4);
});

it("Cancel is back at once, and the new solver knows the design before it is asked anything", async () => {
  let endless = false;
  const page = await openedPage("roof", ({ kind, job }) =>
    endless && kind === "edit" ? { kind: "progress", job, step: 1, residual: 1 } : null,
  );
  await lift(page, 0.2);
  const kept = page.history.value?.present;
  endless = true;
  const edit = lift(page, 0.3);
  await new Promise((resolve) => setTimeout(resolve, 5));
  cancel(page);
  expect(page.draft.value).toBe(kept);
  endless = false;
  await edit;
  expect(page.busy.value).toBe(false);
  await lift(page, 0.1);
  expect(page.history.value?.past.length).toBe(2);
  expect(page.problem.value).toBeNull();
});

it("knows which mesh the solver has open", async () => {
  const page = pageHere();
  expect(held(page).base).toBeNull();
  const source = { kind: "sample", name: "vault", size: 21 } as const;
  await run(
    page,
    "opening",
    { kind: "open", source, planarise: null, symmetry: null, cuts: [] },
    "opened",
  );
  expect(held(page).base?.source).toEqual(source);
  await run(
    page,
    "opening",
    { kind: "open", source: { ...source, name: "x" }, planarise: null, symmetry: null, cuts: [] },
    "opened",
  );
  expect(held(page).base).toBeNull();
  client(page).cancel();
});
